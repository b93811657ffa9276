//! Random samples of a law, always the same ones, shrunk where it fails.

use std::fmt::Debug;

use proptest::{
    strategy::{Strategy, ValueTree},
    test_runner::{Config, RngAlgorithm, RngSeed, TestRunner},
};

use super::{
    Effort, Failure, Fault,
    met::{Met, merge},
    report::{LawResult, Tried},
};

/// How many smaller samples are tried after a failure, where a case is an evaluation of `H`.
pub(crate) const CHEAP: u32 = 4096;

/// The same, where a case is a number of solves: seconds for a metric on which the solver stalls.
pub(crate) const COSTLY: u32 = 5;

/// Checks a law, which returns what it meets, on `cases` random values.
///
/// A sample that breaks it is made smaller, unless that costs solves and the fault is one of the
/// metric, for which there are cheaper laws with smaller samples.
pub(crate) fn for_all<V, W>(
    effort: &Effort,
    cases: u32,
    shrinks: u32,
    values: V,
    law: impl Fn(&V::Value) -> Result<W, Fault>,
) -> LawResult
where
    V: Strategy,
    V::Value: Debug,
    W: Into<Met>,
{
    drawn(effort, cases, shrinks, &values, &|value| law(value).map(W::into))
}

/// Compiled once for each kind of samples, and not for each law.
fn drawn<V>(
    effort: &Effort,
    cases: u32,
    shrinks: u32,
    values: &V,
    law: &dyn Fn(&V::Value) -> Result<Met, Fault>,
) -> LawResult
where
    V: Strategy,
    V::Value: Debug,
{
    let (rng_algorithm, rng_seed) = (RngAlgorithm::ChaCha, RngSeed::Fixed(effort.seed));
    let config = Config { rng_algorithm, rng_seed, ..Config::default() };
    // Only the samples are proptest's. Its runner would catch the panics of a formula, say on
    // stderr when it stops shrinking, and remember seeds in the folder of somebody else.
    let mut runner = TestRunner::new(config);
    let mut tried = Tried::cases(cases.into());
    for _ in 0..cases {
        let mut tree = values.new_tree(&mut runner).map_err(|reason| {
            let fault = Fault::NoSample { why: reason.to_string() };
            Failure { fault, sample: None, seed: effort.seed }
        })?;
        let value = tree.current();
        match law(&value) {
            Ok(met) => {
                tried.idle += u64::from(met.is_idle());
                // NaN is less than nothing.
                tried.overestimation = tried.overestimation.min(met.overestimation);
                merge(&mut tried.assumed, &met.assumed);
            }
            Err(fault) => {
                let shrinks =
                    if shrinks <= COSTLY && fault.is_of_the_metric() { 0 } else { shrinks };
                let (fault, value) = shrink(&mut tree, shrinks, (fault, value), law);
                let sample = Some(format!("{value:?}"));
                return Err(Failure { fault, sample, seed: effort.seed });
            }
        }
    }
    Ok(tried)
}

/// The smallest of the next samples that break the law, and how.
fn shrink<T: ValueTree>(
    tree: &mut T,
    shrinks: u32,
    mut smallest: (Fault, T::Value),
    law: &dyn Fn(&T::Value) -> Result<Met, Fault>,
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

    use super::{CHEAP, COSTLY, for_all};
    use crate::{
        Effort, Failure, Fault,
        met::{IDLE, Met},
    };

    /// What a law says that fails from 700 on, and how many samples it was asked.
    fn from_700(shrinks: u32, fault: fn(f64) -> Fault) -> (Failure, u32) {
        let asked = Cell::new(0);
        let failed = for_all(&Effort::default(), 256, shrinks, 0..1000_u32, |&k| {
            asked.set(asked.get() + 1);
            if k < 700 { Ok(1000.0 / f64::from(k)) } else { Err(fault(f64::from(k))) }
        });
        (failed.expect_err("some are beyond"), asked.get())
    }

    fn broken(left: f64) -> Fault {
        Fault::unless_at_most("k ≤ 699", [left, 699.0], 0.0, &[]).expect_err("from 700")
    }

    fn not_finite(entry: f64) -> Fault {
        MetricError::NotFinite { point: Vec::new(), row: 0, column: 0, entry }.into()
    }

    #[test]
    fn the_smallest_sample_is_found_with_its_fault() {
        let (failure, _) = from_700(CHEAP, broken);
        assert_eq!((failure.fault, failure.sample.as_deref()), (broken(700.0), Some("700")));
        let (failure, _) = from_700(CHEAP, not_finite);
        assert_eq!(failure.sample.as_deref(), Some("700"));
    }

    #[test]
    fn what_costs_solves_is_shrunk_a_little_and_not_for_a_fault_of_the_metric() {
        let [(_, once), (_, of_metric), (_, of_law)] =
            [from_700(0, broken), from_700(COSTLY, not_finite), from_700(COSTLY, broken)];
        assert_eq!(of_metric, once);
        assert!(of_law > once && of_law <= once + COSTLY, "{of_law} of {once}");
    }

    #[test]
    fn the_least_overestimation_is_that_of_the_largest_sample() {
        let largest = Cell::new(0);
        let tried = for_all(&Effort::default(), 64, CHEAP, 1..1000_u32, |&k| {
            largest.set(largest.get().max(k));
            Ok(1000.0 / f64::from(k))
        });
        let tried = tried.expect("it holds");
        assert_eq!((tried.cases, tried.overestimation), (64, 1000.0 / f64::from(largest.get())));
    }

    #[test]
    fn values_that_could_not_have_broken_a_law_are_counted_apart() {
        let tried = for_all(&Effort::default(), 64, CHEAP, 0..1000_u32, |&k| {
            Ok(if k % 2 == 0 { IDLE } else { 3.0 })
        });
        let tried = tried.expect("it holds");
        assert!(tried.idle > 0 && tried.idle < 64, "{tried:?}");
        assert_eq!((tried.cases, tried.overestimation), (64, 3.0));
    }

    #[test]
    fn what_is_assumed_of_some_sample_is_said_of_the_law() {
        let tried = for_all(&Effort::default(), 64, CHEAP, 0..1000_u32, |&k| {
            let assumed = if k % 2 == 0 { vec!["even"] } else { vec!["odd", "small"] };
            Ok(Met { overestimation: if k < 500 { 2.0 } else { IDLE }, assumed })
        });
        let mut assumed = tried.expect("it holds").assumed;
        assumed.sort_unstable();
        assert_eq!(assumed, ["even", "odd", "small"]);
    }
}
