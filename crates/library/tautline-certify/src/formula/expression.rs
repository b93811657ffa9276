//! `Expressions`: formulas up to trivial identities, which show which entries of `H` are equal.

use std::collections::{HashMap, HashSet};

use tautline_formula::{Arithmetic, Formula, Function, Operation, Tabulation};
use tautline_scalar::ANY;

/// Returns whether the formula shows that `H(x) = φ(x) I`, with zeros off the diagonal and the same
/// expression in every diagonal entry. False proves nothing, since equal functions may be written
/// in different ways.
pub fn is_isotropic<const D: usize>(formula: &Formula<D>) -> bool {
    Expressions::default().multiple_of_identity(formula).is_some()
}

/// Returns whether the formula shows that `H(x) = φ(|x|²) I`. In this case the coordinates occur
/// only in `x₁² + x₂² + …`, summed in this order. False proves nothing.
pub(crate) fn is_radial(formula: &Formula<ANY>) -> bool {
    let mut expressions = Expressions::default();
    let Some(Some(factor)) = expressions.multiple_of_identity(formula) else { return false };
    let zero = expressions.constant(0.0);
    let square = (0..formula.dimension()).fold(zero, |sum, i| {
        let x = expressions.number(Node::Variable(i as u32));
        let square = expressions.power(x, 2);
        expressions.sum(sum, square)
    });
    let mut reached = HashSet::new();
    let mut open = vec![factor];
    while let Some(expression) = open.pop() {
        if expression == square || !reached.insert(expression) {
            continue;
        }
        match expressions.nodes[expression as usize] {
            Node::Variable(_) => return false,
            Node::Constant(_) => {}
            Node::Sum(a, b) | Node::Product(a, b) | Node::Quotient(a, b) => open.extend([a, b]),
            Node::Negative(a) | Node::Power(a, _) | Node::Of(_, a) => open.push(a),
            Node::Table(call) => open.extend(call.arguments()),
        }
    }
    true
}

/// The number of an expression. Expressions with the same number are equal.
type Expression = u32;

/// Maps expressions to their numbers and back.
///
/// The order of the two operands of a sum or product does not matter; `f · f` is `f²`; adding `0`
/// or multiplying by `1` changes nothing; for constants, `0 · c` is `0`. Nothing else is
/// simplified, not even `0 · f`, since `f` may be undefined.
#[derive(Default)]
struct Expressions {
    nodes: Vec<Node>,
    numbers: HashMap<Node, Expression>,
}

#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
enum Node {
    Variable(u32),
    /// A constant, given by its bits.
    Constant(u64),
    Sum(Expression, Expression),
    Product(Expression, Expression),
    Quotient(Expression, Expression),
    Negative(Expression),
    Power(Expression, i32),
    Of(Function, Expression),
    /// A table of the formula, with expressions as its arguments.
    Table(Tabulation),
}

impl Expressions {
    /// Returns `φ` if `H = φ I`, and `Some(None)` if `D = 0`.
    fn multiple_of_identity<const D: usize>(
        &mut self,
        formula: &Formula<D>,
    ) -> Option<Option<Expression>> {
        let (steps, d) = (self.steps(formula), formula.dimension());
        let zero = self.constant(0.0);
        let entry = |i: usize, j: usize| steps[formula.entry(i, j) as usize];
        let is_multiple =
            (0..d).all(|j| entry(j, j) == entry(0, 0) && (0..j).all(|i| entry(i, j) == zero));
        is_multiple.then(|| (d > 0).then(|| entry(0, 0)))
    }

    /// Returns the expression of each step.
    fn steps<const D: usize>(&mut self, formula: &Formula<D>) -> Vec<Expression> {
        let mut steps = Vec::with_capacity(formula.operations().len());
        for (place, &operation) in formula.operations().iter().enumerate() {
            let at = |step: u32| steps[step as usize];
            let step = match operation {
                Operation::Coordinate(i) => self.number(Node::Variable(i)),
                Operation::Constant(c) => self.constant(c.value()),
                Operation::Binary(how, a, b) => self.combined(how, at(a), at(b)),
                Operation::WithNumber(how, a, c) => {
                    let c = self.constant(c.value());
                    self.combined(how, at(a), c)
                }
                Operation::Powi(a, n) => self.power(at(a), n),
                Operation::Of(Function::Neg, a) => self.negative(at(a)),
                Operation::Of(Function::Sqr, a) => self.power(at(a), 2),
                Operation::Table(call) => {
                    let arguments = call.arguments.map(at);
                    self.number(Node::Table(Tabulation { arguments, ..call }))
                }
                Operation::Of(..) | Operation::First(..) | Operation::Second => {
                    let (function, a) =
                        formula.function(place).expect("a second follows its first");
                    self.number(Node::Of(function, at(a)))
                }
            };
            steps.push(step);
        }
        steps
    }

    fn number(&mut self, node: Node) -> Expression {
        let Self { nodes, numbers } = self;
        *numbers.entry(node).or_insert_with(|| {
            nodes.push(node);
            // The conversion is lossless, since a formula has fewer steps than `u32` has values.
            (nodes.len() - 1) as Expression
        })
    }

    fn constant(&mut self, value: f64) -> Expression {
        // Both zeros count as the same number.
        self.number(Node::Constant((value + 0.0).to_bits()))
    }

    fn is_finite_constant(&self, a: Expression) -> bool {
        matches!(self.nodes[a as usize], Node::Constant(bits) if f64::from_bits(bits).is_finite())
    }

    fn combined(&mut self, how: Arithmetic, a: Expression, b: Expression) -> Expression {
        match how {
            Arithmetic::Add => self.sum(a, b),
            Arithmetic::Sub => {
                let minus = self.negative(b);
                self.sum(a, minus)
            }
            Arithmetic::Mul => self.product(a, b),
            Arithmetic::Div if b == self.constant(1.0) => a,
            Arithmetic::Div => self.number(Node::Quotient(a, b)),
        }
    }

    fn negative(&mut self, a: Expression) -> Expression {
        if a == self.constant(0.0) { a } else { self.number(Node::Negative(a)) }
    }

    fn sum(&mut self, a: Expression, b: Expression) -> Expression {
        let zero = self.constant(0.0);
        if a == zero {
            b
        } else if b == zero {
            a
        } else {
            self.number(Node::Sum(a.min(b), a.max(b)))
        }
    }

    fn product(&mut self, a: Expression, b: Expression) -> Expression {
        let [zero, one] = [0.0, 1.0].map(|c| self.constant(c));
        if a == one || (b == zero && self.is_finite_constant(a)) {
            b
        } else if b == one || (a == zero && self.is_finite_constant(b)) {
            a
        } else if a == b {
            self.power(a, 2)
        } else {
            self.number(Node::Product(a.min(b), a.max(b)))
        }
    }

    fn power(&mut self, a: Expression, n: i32) -> Expression {
        if n == 1 { a } else { self.number(Node::Power(a, n)) }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{SMatrix, SVector, matrix};
    use tautline_formula::{Formula, RecordError, spline::Spline};
    use tautline_metrics::{
        Metric,
        composition::{Scaled, Sum},
        gallery::{Checkerboard, Hill, Hyperbolic, Lens, Shear, Valleys},
    };
    use tautline_scalar::{Scalar, Table};

    use crate::testing::{parsed, tables};

    fn is_isotropic<const D: usize>(metric: &impl Metric<D>) -> bool {
        super::is_isotropic(&Formula::record(metric).expect("no comparison"))
    }

    fn is_radial<const D: usize>(metric: &impl Metric<D>) -> bool {
        super::is_radial(&Formula::record(metric).expect("no comparison").into_any())
    }

    #[test]
    fn functions_of_the_norm_are_recognized() {
        let lens = Lens::new(1.0, 0.5).expect("a width");
        assert!(is_radial::<1>(&lens) && is_radial::<3>(&lens) && is_radial::<2>(&Hyperbolic));
        assert!(!is_radial::<2>(&Valleys) && !is_radial::<2>(&Sum::new(Valleys, lens)));
        assert!(!is_radial::<2>(&Hill::new(1.0, 1.0).expect("a width")));
        // Instead of |x|²: a product in place of a square, an additional coordinate, a weight, or a
        // missing coordinate.
        let radial = |square: &str| is_radial(&parsed::<2>(&format!("exp({square}) + 1 I")));
        assert!(radial("x1*x1 + x2^2"));
        for square in ["sqr(x1) + sqr(x2) + x1", "sqr(x1) + sqr(x2)*2", "sqr(x1) + sqr(x1)"] {
            assert!(!radial(square), "{square}");
        }
    }

    #[test]
    fn multiples_of_the_identity_are_recognized() {
        let lens = Lens::new(1.0, 0.5).expect("a width");
        assert!(is_isotropic::<1>(&Valleys) && is_isotropic::<2>(&Valleys));
        assert!(is_isotropic::<3>(&lens) && is_isotropic::<2>(&Hyperbolic));
        assert!(is_isotropic(&Checkerboard::new(1.0, 2.0).expect("an edge")));
        assert!(is_isotropic::<2>(&Scaled::new(lens, 3.0).expect("a factor")));
        assert!(is_isotropic::<2>(&Sum::new(Valleys, lens)));
    }

    /// Whatever a table does with its arguments, it is a function of the norm only if all of them are.
    /// Entries are the same if they call the same derivative of the same table at the same arguments.
    #[test]
    fn the_arguments_of_tables_are_followed() {
        let [t, h, _] = tables();
        let other: Arc<dyn Table> = Arc::new(Spline::new(&[1], vec![1.0]).expect("a shape"));
        let tables = [t, h, ("s", other)];
        for (text, radial, isotropic) in [
            ("cost(t(sqr(x1) + sqr(x2)))", true, true),
            ("r = x1^2 + x2^2; cost(h(r, exp(-r)))", true, true),
            ("cost(t(x1))", false, true),
            ("cost(t(x2))", false, true),
            // Where numbers occur, steps and expressions are numbered differently.
            ("cost(t(2*x1))", false, true),
            ("cost(t(x2/3 - 1))", false, true),
            ("r = 2*(x1^2 + x2^2) - 1; cost(h(r, t(r)))", true, true),
            ("diag(t(x1 + x2), t(x2 + x1))", false, true),
            ("cost(h(x1, x2))", false, true),
            ("r = x1^2 + x2^2; cost(h(r, x2))", false, true),
            ("r = x1^2 + x2^2; cost(h(x1, r))", false, true),
            ("diag(t(x1), t(x2))", false, false),
            ("diag(t(x1), s(x1))", false, false),
            ("diag(t(x1), t_1(x1))", false, false),
            ("diag(h(x1, x2), h(x2, x1))", false, false),
        ] {
            let formula = Formula::<2>::parse_with(text, &[], &tables).expect(text);
            assert_eq!(is_radial(&formula), radial, "{text}");
            assert_eq!(super::is_isotropic(&formula), isotropic, "{text}");
        }
    }

    /// Each diagonal entry is made on its own thread.
    #[test]
    fn formulas_of_other_threads_are_refused() {
        struct Threads;
        impl Metric<2> for Threads {
            fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                let [a, b] = [x[0], x[1]].map(|x| {
                    let entry = std::thread::scope(|scope| scope.spawn(|| x.sqr() + 2.0).join());
                    entry.expect("no panic")
                });
                matrix![a, S::zero(); S::zero(), b]
            }
        }
        assert_eq!(Formula::record(&Threads), Err(RecordError::Foreign));
    }

    #[test]
    fn other_metrics_are_not_recognized() {
        assert!(!is_isotropic(&Shear::new(0.5, 1.0).expect("a wave number")));
        assert!(!is_isotropic::<2>(&Hill::new(1.0, 1.0).expect("a width")));
        // The diagonal entries depend on different coordinates, or an entry off the diagonal is not
        // zero.
        for text in ["diag(sqr(x1) + 2, sqr(x2) + 2)", "a = sqr(x1) + 2; [a, x1; x1, a]"] {
            assert!(!super::is_isotropic::<2>(&parsed(text)), "{text}");
        }
    }

    /// Entries that are nearly the same expression, and zeros that may be undefined.
    #[test]
    fn entries_that_differ_in_one_place_are_not_equal() {
        for text in [
            "[2, 0*ln(x1); 0*ln(x1), 2]",
            "[2, ln(x1)*0; ln(x1)*0, 2]",
            "[2, 0; 0, 2 + 0*ln(x1)]",
            "diag(x1/x2, x2/x1)",
            "diag(x1 - x2, x2 - x1)",
            "diag(x1*x2, x1/x2)",
            "diag(x1 + x2, x1*x2)",
            "diag(x1 + 2, x1*2)",
            "diag(x1^3, x1^4)",
            "diag(x1^3, x1^-3)",
            "diag(sin(x1), cos(x1))",
            "diag(x1, -x1)",
            "diag(2, 3)",
            "diag(1/x1, x1/1)",
            "a, b = sin_cos(x1); diag(a, b)",
            "a, b = sinh_cosh(x1); diag(a, b)",
        ] {
            assert!(!super::is_isotropic::<2>(&parsed(text)), "{text}");
        }
        for text in [
            "diag(x1 + x2, x2 + x1)",
            "diag(x1*x2, x2*x1)",
            "diag(x1/1, 1*x1 + 0)",
            "diag(x1^2, x1*x1)",
            "[x1, 0*3; 0*3, x1]",
            "a, b = sin_cos(x1); diag(b, cos(x1))",
        ] {
            assert!(super::is_isotropic::<2>(&parsed(text)), "{text}");
        }
    }

    /// A quotient, a table or a function of the coordinates themselves is no function of the norm.
    #[test]
    fn both_sides_of_each_operation_are_followed() {
        for factor in ["r/(x1 + 3)", "(x1 + 3)/r", "r - x2", "x2*r", "r + x1^2", "-x1", "exp(-x2)"]
        {
            let text = format!("r = sqr(x1) + sqr(x2); {factor} I");
            assert!(!is_radial(&parsed::<2>(&text)), "{text}");
        }
        for factor in ["r/(r + 3)", "3/r", "r - 2", "-r", "exp(-r)*r^3"] {
            let text = format!("r = sqr(x1) + sqr(x2); {factor} I");
            assert!(is_radial(&parsed::<2>(&text)), "{text}");
        }
    }
}
