//! A metric that is undefined where functions are not positive.

use tautline_scalar::Scalar;

use crate::{Formula, RecordError, recording::record};

impl<const D: usize> Formula<D> {
    /// Returns the metric, undefined where one of some functions is not positive. A function `f` is given
    /// as the metric `f I`, such as the cost of the metric `f² I`, whose square does not show where `f` is
    /// negative. So a search refuses a step that leads there.
    ///
    /// `H` is multiplied by `1 + 0 ln f`: where `f` is positive and finite, its bits stay.
    ///
    /// ```
    /// use tautline_formula::Formula;
    /// use tautline_metrics::Metric;
    ///
    /// let [cost, squared] = ["(1/x1) I", "(1/x1)^2 I"].map(|text| Formula::<1>::parse(text, &[]).unwrap());
    /// let positive = squared.where_positive(&[cost])?;
    /// let h = |x: f64| positive.gram(&[x].into())[(0, 0)];
    /// assert!(h(0.5) == 4.0 && h(-0.5).is_nan());
    /// # Ok::<(), tautline_formula::RecordError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`RecordError::TooLong`].
    ///
    /// # Panics
    ///
    /// If a function has another dimension.
    pub fn where_positive(&self, functions: &[Self]) -> Result<Self, RecordError> {
        let d = self.dimension();
        let (entries, recording) = record(d, |x| {
            let entries = |formula: &Self| {
                assert_eq!(formula.dimension(), d, "functions of the same coordinates");
                let tape = formula.tape();
                let values = tape.values(x);
                tape.entries.iter().map(|&entry| values[entry as usize]).collect::<Vec<_>>()
            };
            let by = functions.iter().map(|f| entries(f)[0].ln() * 0.0 + 1.0).reduce(|a, b| a * b);
            let h = entries(self).into_iter();
            h.map(|h| by.map_or(h, |by| by * h)).collect::<Vec<_>>()
        });
        Self::of(d, &entries, &recording)
    }
}

#[cfg(test)]
mod tests {
    use crate::{AnyBatches, Batch, Formula, Kind, Prepared, PreparedFormula};

    /// Point by point and by the programs of every kind that a search runs, first and second derivatives too.
    #[test]
    fn a_metric_is_undefined_where_a_function_is_not_positive_and_the_same_elsewhere() {
        let [f, g, h] = ["x1 I", "(2 - x2) I", "[2 + x1^2, x2; x2, 3 + sin(x1)]"]
            .map(|text| Formula::<2>::parse(text, &[]).expect("a formula"));
        let positive = h.where_positive(&[f, g]).expect("short");
        let (before, after) = (Prepared::<_, 2>::new(h.clone()), Prepared::new(positive.clone()));
        let any = PreparedFormula::new(positive.into_any());
        for [x, y] in [[0.5, 0.3], [1.0, -4.0], [-0.5, 0.3], [0.0, 0.3], [0.5, 2.0], [0.5, 3.0]] {
            let is_there = x > 0.0 && y < 2.0;
            let rows = |metric: &dyn AnyBatches, kind: Kind| {
                let mut batch = Batch::new(metric, kind, 1, 1);
                for (i, [at, along]) in [[x, 0.7], [y, -0.4]].into_iter().enumerate() {
                    let [point, chord] = batch.input(i);
                    (point[0], chord[0]) = (at, along);
                }
                batch.evaluate(1);
                let layout = batch.layout();
                let all = [&layout.square, &layout.gram, &layout.slope, &layout.turn, &layout.bend];
                let registers = all.into_iter().flatten();
                registers.map(|register| batch.row(*register)[0]).collect::<Vec<f64>>()
            };
            for kind in [Kind::Square, Kind::Momentum, Kind::Contraction] {
                for metric in [&after as &dyn AnyBatches, &any] {
                    let (expected, found) = (rows(&before, kind), rows(metric, kind));
                    if is_there {
                        let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-14 * a.abs();
                        assert!(expected.iter().zip(&found).all(is_near), "{found:?} {expected:?}");
                    } else {
                        assert!(found[0].is_nan(), "{kind:?} at {x}, {y}: {found:?}");
                    }
                }
            }
            let mut gram = [0.0; 4];
            any.gram_into(&[x, y], &mut gram);
            let mut as_typed = [0.0; 4];
            before.gram_into(&[x, y], &mut as_typed);
            let is_same = gram.map(f64::to_bits) == as_typed.map(f64::to_bits);
            assert!(if is_there { is_same } else { gram.iter().all(|h| h.is_nan()) }, "{gram:?}");
        }
    }

    #[test]
    fn without_functions_it_is_the_metric() {
        let h = Formula::<1>::parse("(2 + cos(x1)) I", &[]).expect("a formula");
        assert_eq!(h.where_positive(&[]), Ok(h));
    }
}
