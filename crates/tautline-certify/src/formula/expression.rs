//! `Expression`: formulas as such, to see which entries of a Gram matrix are the same.

use std::{
    cell::RefCell,
    collections::{HashMap, HashSet},
    ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign},
    sync::atomic::{AtomicU64, Ordering},
};

use nalgebra::SVector;
use num_traits::{One, Zero};
use tautline_metrics::Metric;
use tautline_scalar::Scalar;

use super::operators::operators_follow;

/// Returns whether `H(x) = φ(x) I` by its formula: zeros beside the diagonal, and the same
/// expression all along it.
///
/// True is proved; false says nothing, since equal functions may be written in different ways.
pub(crate) fn is_isotropic<const D: usize>(metric: &impl Metric<D>) -> bool {
    FORMULAS.with_borrow_mut(|formulas| *formulas = Formulas::default());
    let x = SVector::from_fn(|i, _| Expression::new(Node::Variable(i)));
    let gram = metric.gram(&x);
    let upper = (0..D).flat_map(|j| (0..=j).map(move |i| (i, j)));
    upper.into_iter().all(|(i, j)| {
        let entry = gram[(i, j)];
        if i == j { entry == gram[(0, 0)] } else { entry.is_zero() }
    })
}

/// Every expression of the evaluation that goes on, by its number and with it.
struct Formulas {
    /// No other table has this number: neither another thread's, nor that of another evaluation.
    table: u64,
    nodes: Vec<Node>,
    numbers: HashMap<Node, u32>,
}

impl Default for Formulas {
    fn default() -> Self {
        static TABLES: AtomicU64 = AtomicU64::new(0);
        let table = TABLES.fetch_add(1, Ordering::Relaxed);
        Self { table, nodes: Vec::new(), numbers: HashMap::new() }
    }
}

impl Formulas {
    /// The formula of an expression, if it is from this table.
    fn node(&self, expression: Expression) -> Option<Node> {
        if expression.table != self.table {
            return None;
        }
        self.nodes.get(expression.number as usize).copied()
    }
}

/// Returns whether `H(x) = φ(|x|²) I` by its formula: the coordinates occur in `x₁² + x₂² + … `,
/// summed in their order, and nowhere else.
///
/// True is proved; false says nothing.
pub(crate) fn is_radial<const D: usize>(metric: &impl Metric<D>) -> bool {
    if D == 0 || !is_isotropic(metric) {
        return false;
    }
    // The formulas of that evaluation are still there.
    let x = std::array::from_fn::<_, D, _>(|i| Expression::new(Node::Variable(i)));
    let square = x.iter().fold(Expression::zero(), |sum, x| sum + x.sqr());
    let gram = metric.gram(&SVector::from(x));
    FORMULAS.with_borrow(|formulas| {
        let mut reached = HashSet::new();
        let mut open = vec![gram[(0, 0)]];
        while let Some(expression) = open.pop() {
            if expression == square || !reached.insert(expression) {
                continue;
            }
            match formulas.node(expression) {
                None | Some(Node::Variable(_)) => return false,
                Some(Node::Constant(_)) => {}
                Some(Node::Sum(a, b) | Node::Product(a, b) | Node::Quotient(a, b)) => {
                    open.extend([a, b]);
                }
                Some(Node::Negative(a) | Node::Power(a, _) | Node::Of(_, a)) => open.push(a),
            }
        }
        true
    })
}

thread_local! {
    static FORMULAS: RefCell<Formulas> = RefCell::default();
}

/// An expression by its number in a table: two are the same formula if both numbers are equal.
/// Those that were made on another thread, or by an evaluation inside of this one, equal none of
/// this one's.
///
/// Sums and products do not depend on the order of two operands; `f · f` is `f²`; adding `0` and
/// multiplying by `1` changes nothing; of constants, `0 · c` is `0`. Nothing else is simplified, `0
/// · f` not either: `f` may not be defined.
#[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
struct Expression {
    table: u64,
    number: u32,
}

#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
enum Node {
    Variable(usize),
    /// By its bits.
    Constant(u64),
    Sum(Expression, Expression),
    Product(Expression, Expression),
    Quotient(Expression, Expression),
    Negative(Expression),
    Power(Expression, i32),
    Of(&'static str, Expression),
}

impl Expression {
    fn new(node: Node) -> Self {
        FORMULAS.with_borrow_mut(|Formulas { table, nodes, numbers }| {
            let number = *numbers.entry(node).or_insert_with(|| {
                nodes.push(node);
                u32::try_from(nodes.len() - 1).expect("fewer than 2³² expressions")
            });
            Self { table: *table, number }
        })
    }

    fn of(self, function: &'static str) -> Self {
        Self::new(Node::Of(function, self))
    }

    fn is_finite_constant(self) -> bool {
        FORMULAS.with_borrow(|formulas| match formulas.node(self) {
            Some(Node::Constant(bits)) => f64::from_bits(bits).is_finite(),
            _ => false,
        })
    }
}

impl Neg for Expression {
    type Output = Self;
    fn neg(self) -> Self {
        if self.is_zero() { self } else { Self::new(Node::Negative(self)) }
    }
}

impl Add for Expression {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            other
        } else if other.is_zero() {
            self
        } else {
            Self::new(Node::Sum(self.min(other), self.max(other)))
        }
    }
}

impl Mul for Expression {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let zero = Self::zero();
        if self.is_one() || (other == zero && self.is_finite_constant()) {
            other
        } else if other.is_one() || (self == zero && other.is_finite_constant()) {
            self
        } else if self == other {
            self.powi(2)
        } else {
            Self::new(Node::Product(self.min(other), self.max(other)))
        }
    }
}

impl Div for Expression {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.is_one() { self } else { Self::new(Node::Quotient(self, other)) }
    }
}

operators_follow!([] Expression);

impl Zero for Expression {
    fn zero() -> Self {
        Self::constant(0.0)
    }
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl Scalar for Expression {
    fn constant(value: f64) -> Self {
        // The two zeros are one number.
        Self::new(Node::Constant((value + 0.0).to_bits()))
    }
    fn sqr(self) -> Self {
        self.powi(2)
    }
    fn powi(self, n: i32) -> Self {
        if n == 1 { self } else { Self::new(Node::Power(self, n)) }
    }
    fn recip(self) -> Self {
        self.of("recip")
    }
    fn sqrt(self) -> Self {
        self.of("sqrt")
    }
    fn exp(self) -> Self {
        self.of("exp")
    }
    fn ln(self) -> Self {
        self.of("ln")
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.of("sin"), self.of("cos"))
    }
    fn tan(self) -> Self {
        self.of("tan")
    }
    fn atan(self) -> Self {
        self.of("atan")
    }
    fn sinh_cosh(self) -> (Self, Self) {
        (self.of("sinh"), self.of("cosh"))
    }
    fn tanh(self) -> Self {
        self.of("tanh")
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, matrix};
    use tautline_metrics::{
        Metric,
        composition::{Scaled, Sum},
        gallery::{Checkerboard, Hill, Hyperbolic, Lens, Shear, Valleys},
    };
    use tautline_scalar::Scalar;

    use super::{is_isotropic, is_radial};

    #[test]
    fn functions_of_the_norm_are_seen() {
        let lens = Lens::new(1.0, 0.5).expect("a width");
        assert!(is_radial::<1>(&lens) && is_radial::<3>(&lens) && is_radial::<2>(&Hyperbolic));
        assert!(!is_radial::<2>(&Valleys) && !is_radial::<2>(&Sum::new(Valleys, lens)));
        assert!(!is_radial::<2>(&Hill::new(1.0, 1.0).expect("a width")));
        /// A product for a square, and a coordinate beside, or a weight.
        struct Near(usize);
        impl Metric<2> for Near {
            fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                let square = match self.0 {
                    0 => x[0] * x[0] + x[1].powi(2),
                    1 => x[0].sqr() + x[1].sqr() + x[0],
                    2 => x[0].sqr() + x[1].sqr() * 2.0,
                    _ => x[0].sqr() + x[0].sqr(),
                };
                SMatrix::from_diagonal_element(square.exp() + 1.0)
            }
        }
        assert!(is_radial(&Near(0)));
        assert!(!is_radial(&Near(1)) && !is_radial(&Near(2)) && !is_radial(&Near(3)));
    }

    #[test]
    fn multiples_of_the_identity_are_seen() {
        let lens = Lens::new(1.0, 0.5).expect("a width");
        assert!(is_isotropic::<1>(&Valleys) && is_isotropic::<2>(&Valleys));
        assert!(is_isotropic::<3>(&lens) && is_isotropic::<2>(&Hyperbolic));
        assert!(is_isotropic(&Checkerboard::new(1.0, 2.0).expect("an edge")));
        assert!(is_isotropic::<2>(&Scaled::new(lens, 3.0).expect("a factor")));
        assert!(is_isotropic::<2>(&Sum::new(Valleys, lens)));
    }

    /// Each diagonal entry is made on a thread of its own, where it is the first formula.
    #[test]
    fn formulas_of_other_threads_equal_none() {
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
        assert!(!is_isotropic(&Threads) && !is_radial(&Threads));
    }

    #[test]
    fn nothing_else_is_taken_for_one() {
        assert!(!is_isotropic(&Shear::new(0.5, 1.0).expect("a wave number")));
        assert!(!is_isotropic::<2>(&Hill::new(1.0, 1.0).expect("a width")));
        /// Equal on the diagonal but for the coordinate, or with something beside it.
        struct Diagonal(bool);
        impl Metric<2> for Diagonal {
            fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                let (a, b) = (x[0].sqr() + 2.0, x[1].sqr() + 2.0);
                if self.0 { matrix![a, S::zero(); S::zero(), b] } else { matrix![a, x[0]; x[0], a] }
            }
        }
        assert!(!is_isotropic(&Diagonal(true)) && !is_isotropic(&Diagonal(false)));
    }
}
