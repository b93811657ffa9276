//! Random samples for a law. They are the same in every run, and a sample that fails is shrunk.

use std::fmt::Debug;

use proptest::{
    strategy::{Strategy, ValueTree},
    test_runner::{Config, RngAlgorithm, RngSeed, TestRunner},
};

use super::{
    Effort, Failure, Fault,
    margin::{Margin, merge},
    report::{LawResult, Tried},
};

/// The number of smaller samples to try after a failure if a case only evaluates `H`.
const CHEAP: u32 = 4096;

/// The same number if a case solves problems, which takes seconds when the solver stalls.
const COSTLY: u32 = 5;

impl Effort {
    /// Checks a law on [`cases`](Effort::cases) random values, and shrinks a value that violates
    /// it.
    pub(crate) fn for_all<V: Strategy<Value: Debug>, M: Into<Margin>>(
        &self,
        values: V,
        law: impl Fn(&V::Value) -> Result<M, Fault>,
    ) -> LawResult {
        draw(self.seed, self.cases, CHEAP, &values, &|value| law(value).map(M::into))
    }

    /// Checks a law that solves [`problems`](Effort::problems) random problems.
    ///
    /// A problem that violates the law is shrunk, unless the fault is in the metric; cheaper laws
    /// find smaller samples for such a fault.
    pub(crate) fn for_all_problems<V: Strategy<Value: Debug>, M: Into<Margin>>(
        &self,
        problems: V,
        law: impl Fn(&V::Value) -> Result<M, Fault>,
    ) -> LawResult {
        draw(self.seed, self.problems, COSTLY, &problems, &|value| law(value).map(M::into))
    }
}

/// Takes the law as `dyn`, so that this function is compiled once per kind of sample.
fn draw<V: Strategy<Value: Debug>>(
    seed: u64,
    cases: u32,
    shrinks: u32,
    values: &V,
    law: &dyn Fn(&V::Value) -> Result<Margin, Fault>,
) -> LawResult {
    let (rng_algorithm, rng_seed) = (RngAlgorithm::ChaCha, RngSeed::Fixed(seed));
    let config = Config { rng_algorithm, rng_seed, ..Config::default() };
    // We use proptest only to draw the samples. Its own runner would catch the panics of a formula,
    // report on stderr when it stops shrinking, and store seeds in the user's folder.
    let mut runner = TestRunner::new(config);
    let mut tried = Tried::cases(cases.into());
    for _ in 0..cases {
        let mut tree = values.new_tree(&mut runner).map_err(|reason| {
            let fault = Fault::NoSample { why: reason.to_string() };
            Failure { fault, sample: None, seed }
        })?;
        let value = tree.current();
        match law(&value) {
            Ok(margin) => {
                tried.idle += u64::from(margin.is_idle());
                // `min` ignores the NaN of an idle sample.
                tried.overestimation = tried.overestimation.min(margin.overestimation);
                merge(&mut tried.assumed, &margin.assumed);
            }
            Err(fault) => {
                let skip = shrinks <= COSTLY && fault.is_of_the_metric();
                let shrinks = if skip { 0 } else { shrinks };
                let (fault, value) = shrink(&mut tree, shrinks, (fault, value), law);
                return Err(Failure { fault, sample: Some(format!("{value:?}")), seed });
            }
        }
    }
    Ok(tried)
}

/// Returns the smallest sample found that violates the law, and its fault.
fn shrink<T: ValueTree>(
    tree: &mut T,
    shrinks: u32,
    mut smallest: (Fault, T::Value),
    law: &dyn Fn(&T::Value) -> Result<Margin, Fault>,
) -> (Fault, T::Value) {
    let mut left = shrinks;
    let mut changed = left > 0 && tree.simplify();
    while changed && left > 0 {
        left -= 1;
        let value = tree.current();
        changed = match law(&value) {
            Ok(_) => tree.complicate(),
            Err(fault) => {
                smallest = (fault, value);
                tree.simplify()
            }
        };
    }
    smallest
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use tautline::MetricError;

    use super::{CHEAP, COSTLY, draw};
    use crate::{
        Effort, Failure, Fault,
        margin::{IDLE, Margin},
    };

    /// Returns the failure of a law that is violated from 700 on, and the number of samples it was
    /// given.
    fn from_700(shrinks: u32, fault: fn(f64) -> Fault) -> (Failure, u32) {
        let given = Cell::new(0);
        let failed = draw(Effort::default().seed, 256, shrinks, &(0..1000_u32), &|&k| {
            given.set(given.get() + 1);
            if k < 700 { Ok((1000.0 / f64::from(k)).into()) } else { Err(fault(f64::from(k))) }
        });
        (failed.expect_err("some are beyond"), given.get())
    }

    fn broken(left: f64) -> Fault {
        Fault::unless_at_most("k ≤ 699", [left, 699.0], 0.0, &[]).expect_err("from 700")
    }

    fn not_finite(entry: f64) -> Fault {
        MetricError::NotFinite { point: Vec::new(), row: 0, column: 0, entry }.into()
    }

    fn few() -> Effort {
        Effort { cases: 64, ..Effort::default() }
    }

    #[test]
    fn the_smallest_sample_is_found_with_its_fault() {
        let (failure, _) = from_700(CHEAP, broken);
        assert_eq!((failure.fault, failure.sample.as_deref()), (broken(700.0), Some("700")));
        let (failure, _) = from_700(CHEAP, not_finite);
        assert_eq!(failure.sample.as_deref(), Some("700"));
    }

    #[test]
    fn problems_are_shrunk_a_little_and_not_for_a_fault_of_the_metric() {
        let [(_, once), (_, of_metric), (_, of_law)] =
            [from_700(0, broken), from_700(COSTLY, not_finite), from_700(COSTLY, broken)];
        assert_eq!(of_metric, once);
        assert!(of_law > once && of_law <= once + COSTLY, "{of_law} of {once}");
    }

    #[test]
    fn the_smallest_overestimation_is_kept() {
        let largest = Cell::new(0);
        let tried = few().for_all(1..1000_u32, |&k| {
            largest.set(largest.get().max(k));
            Ok(1000.0 / f64::from(k))
        });
        let tried = tried.expect("it holds");
        assert_eq!((tried.cases, tried.overestimation), (64, 1000.0 / f64::from(largest.get())));
    }

    #[test]
    fn idle_samples_are_counted_apart() {
        let tried = few().for_all(0..1000_u32, |&k| Ok(if k % 2 == 0 { IDLE } else { 3.0 }));
        let tried = tried.expect("it holds");
        assert!(tried.idle > 0 && tried.idle < 64, "{tried:?}");
        assert_eq!((tried.cases, tried.overestimation), (64, 3.0));
    }

    #[test]
    fn the_assumptions_of_all_samples_are_collected() {
        let tried = few().for_all(0..1000_u32, |&k| {
            let assumed = if k % 2 == 0 { vec!["even"] } else { vec!["odd", "small"] };
            Ok(Margin { overestimation: if k < 500 { 2.0 } else { IDLE }, assumed })
        });
        let mut assumed = tried.expect("it holds").assumed;
        assumed.sort_unstable();
        assert_eq!(assumed, ["even", "odd", "small"]);
    }
}
