//! A search for jumps of a metric that is known by its values only.

use tautline_formula::{AnyBatches, Prepare};
use tautline_optimizers::bent_lines;

use crate::TautLine;

/// The number of pieces of the curve, and of each bent line, between which the metric is compared.
const PIECES: usize = 64;
const PIECES_OF_A_BEND: usize = 16;

/// The relative change of `H` over a piece from which on the piece is looked at.
const CHANGE: f64 = 0.1;

/// How often a piece is halved: to a millionth of its length.
const HALVINGS: usize = 20;

/// The part of the change that a jump keeps on the way. A metric with a bounded slope keeps a millionth
/// times the ratio of its largest to its mean slope.
const KEPT: f64 = 0.5;

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Returns a point, in `ℓ`, at which the metric jumps along the curve, or along the lines from which
    /// automatic searches start. A search by derivatives does not see a jump.
    ///
    /// A formula has none: the result is `None` without a look.
    #[must_use]
    pub fn jump(&self) -> Option<Vec<f64>> {
        if self.recorded().is_ok() {
            return None;
        }
        let at = |t: usize| self.curve().coordinates_at(t as f64 / PIECES as f64).collect();
        let curve: Vec<Vec<f64>> = (0..=PIECES).map(at).collect();
        let bends = bent_lines(&curve[0], &curve[PIECES], PIECES_OF_A_BEND);
        let bends = bends
            .into_iter()
            .skip(1)
            .map(|bend| bend.chunks_exact(curve[0].len()).map(<[f64]>::to_vec).collect::<Vec<_>>());
        let lines = [curve.clone()].into_iter().chain(bends.collect::<Vec<_>>());
        lines.into_iter().find_map(|line| self.jump_along(&line))
    }

    /// Returns a point at which the metric jumps on a polygon.
    fn jump_along(&self, points: &[Vec<f64>]) -> Option<Vec<f64>> {
        let mut at_points = points.iter().map(|x| (x, self.gram(x)));
        let mut before = at_points.next()?;
        at_points.find_map(|next| {
            let jump = self.jump_between(&before, &next);
            before = next;
            jump
        })
    }

    fn jump_between(
        &self,
        (a, at_a): &(&Vec<f64>, Vec<f64>),
        (b, at_b): &(&Vec<f64>, Vec<f64>),
    ) -> Option<Vec<f64>> {
        let first = change(at_a, at_b);
        let size = change(at_a, &vec![0.0; at_a.len()]).max(change(at_b, &vec![0.0; at_b.len()]));
        // Written so that NaN is no change.
        if !(first > CHANGE * size && first.is_finite()) {
            return None;
        }
        let (mut a, mut b) = (((*a).clone(), at_a.clone()), ((*b).clone(), at_b.clone()));
        for _ in 0..HALVINGS {
            let middle: Vec<f64> = a.0.iter().zip(&b.0).map(|(a, b)| 0.5 * (a + b)).collect();
            let at_middle = self.gram(&middle);
            if change(&a.1, &at_middle) > change(&at_middle, &b.1) {
                b = (middle, at_middle);
            } else {
                a = (middle, at_middle);
            }
        }
        (change(&a.1, &b.1) >= KEPT * first).then_some(b.0)
    }

    fn gram(&self, x: &[f64]) -> Vec<f64> {
        let mut gram = vec![0.0; x.len() * x.len()];
        self.prepared().gram_into(x, &mut gram);
        gram
    }
}

/// Returns the Frobenius norm of the difference of two matrices.
fn change(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use tautline_discretizations::Rule;
    use tautline_formula::{BlackBox, Formula, Values};
    use tautline_sets::Ends;

    use crate::Problem;

    /// A cost that depends on the height, known by its values.
    struct Cost<F>(F);

    impl<F: Fn(f64) -> f64 + Send + Sync> Values for Cost<F> {
        fn gram(&self, x: &[f64]) -> Vec<f64> {
            let squares = x.chunks_exact(2).map(|x| (self.0)(x[1]).powi(2));
            squares.flat_map(|square| [square, 0.0, 0.0, square]).collect()
        }
    }

    fn problem(
        cost: impl Fn(f64) -> f64 + Send + Sync + 'static,
        ends: [[f64; 2]; 2],
    ) -> Problem<BlackBox<2>, 2> {
        let metric = BlackBox::<2>::new(Arc::new(Cost(cost)), 1e-5).expect("a step");
        Problem::new(metric, Ends::points(ends[0], ends[1]).expect("finite"))
    }

    /// Across a layer, and along it: the search runs beside the layer, where the way would be shorter.
    #[test]
    fn a_jump_on_the_curve_or_on_a_bent_line_is_found() {
        let layers = |height: f64| if height < -0.3 { 0.6 } else { 1.0 };
        for ends in [[[-1.0, 1.0], [1.0, -1.0]], [[-1.0, 0.0], [1.0, 0.0]]] {
            let problem = problem(layers, ends);
            let line = problem.solve(Rule::TRAPEZOIDAL, 64).expect("solved");
            let at = line.jump().expect("a jump");
            assert!((at[1] + 0.3).abs() < 1e-5, "{at:?}");
            assert!(line.doubts().iter().any(|doubt| doubt.key() == "jump"), "{:?}", line.doubts());
        }
    }

    /// A wall that is 1/100 of the curve wide is steep, and so is a kink no jump.
    #[test]
    fn a_steep_wall_is_no_jump() {
        for cost in [
            (|height: f64| 1.0 + 0.5 * (height / 0.02).tanh()) as fn(f64) -> f64,
            |height| 1.0 + height.abs(),
            |_| 2.0,
        ] {
            let line = problem(cost, [[-1.0, 1.0], [1.0, -1.0]]).solve(Rule::TRAPEZOIDAL, 64);
            assert_eq!(line.expect("solved").jump(), None);
        }
    }

    /// Where the metric is undefined there is nothing to compare.
    #[test]
    fn what_is_not_a_number_is_no_jump() {
        let cost = |height: f64| if height < -0.3 { f64::NAN } else { 1.0 };
        let line = problem(cost, [[-1.0, 0.0], [1.0, 0.0]]).solve(Rule::TRAPEZOIDAL, 64);
        assert_eq!(line.expect("solved").jump(), None);
    }

    #[test]
    fn a_formula_is_not_looked_at() {
        let steep = Formula::<2>::parse("cost(1 + 0.5*tanh(1e12*x2))", &[]).expect("a formula");
        let ends = Ends::points([-1.0, 1.0], [1.0, -1.0]).expect("finite");
        let line = Problem::new(steep, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
        assert_eq!(line.jump(), None);
    }
}
