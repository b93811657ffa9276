//! Random samples of a law, always the same ones, shrunk where it fails.

use std::{cell::Cell, fmt::Debug};

use proptest::{
    strategy::Strategy,
    test_runner::{Config, RngSeed, TestCaseError, TestError, TestRunner},
};

use super::{
    Effort, Failure, Fault,
    report::{LawResult, Tried},
};

/// How many smaller samples are tried after a failure, where a case is an evaluation of `H`.
pub(crate) const CHEAP: u32 = 4096;

/// The same, where a case is a number of solves.
pub(crate) const COSTLY: u32 = 40;

/// Checks a law, which returns its slack, on `cases` random values.
pub(crate) fn for_all<V>(
    effort: &Effort,
    cases: u32,
    shrinks: u32,
    values: V,
    law: impl Fn(&V::Value) -> Result<f64, Fault>,
) -> LawResult
where
    V: Strategy,
    V::Value: Debug,
{
    let config = Config {
        cases,
        max_shrink_iters: shrinks,
        rng_seed: RngSeed::Fixed(effort.seed),
        // Every run draws the same samples, so that there is nothing to remember, and no file
        // to leave in the folder of somebody else.
        failure_persistence: None,
        ..Config::default()
    };
    let slack = Cell::new(f64::INFINITY);
    let outcome = TestRunner::new(config).run(&values, |value| match law(&value) {
        Ok(found) => {
            slack.set(slack.get().min(found));
            Ok(())
        }
        Err(fault) => Err(TestCaseError::fail(fault.to_string())),
    });
    let (fault, sample) = match outcome {
        Ok(()) => {
            return Ok(Tried { cases: cases.into(), slack: slack.get(), note: None });
        }
        Err(TestError::Fail(reason, value)) => {
            // A law is a function of its sample, so that it fails again; were it not one, its
            // message would be all that is left.
            let why = || Fault::NoSample { why: format!("once only: {reason}") };
            (law(&value).err().unwrap_or_else(why), Some(format!("{value:?}")))
        }
        Err(TestError::Abort(reason)) => (Fault::NoSample { why: reason.to_string() }, None),
    };
    Err(Failure { fault, sample, seed: effort.seed })
}
