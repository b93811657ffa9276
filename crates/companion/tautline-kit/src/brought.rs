//! `Brought`: the case of a suite, which is made once for all its tests.

use std::{
    any::Any,
    fmt::Display,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::OnceLock,
};

use tautline::{Bounded, CertifyError};

use super::MetricCase;

/// The input that a suite accepts: a metric with constants, or a `Result` that contains one.
///
/// The inferred `Kind` distinguishes the two: it is [`Itself`] or [`Attempt`].
pub trait Bring<Kind, const D: usize> {
    /// The type of the metric.
    type Metric: Bounded<D>;

    /// Returns the metric.
    ///
    /// # Errors
    ///
    /// The reason why there is no metric, and what to do about it.
    fn bring(self) -> Result<Self::Metric, String>;
}

/// The kind of an input that is a metric.
#[derive(Debug)]
pub enum Itself {}

/// The kind of an input that is a `Result` with a metric, as returned by
/// [`Certified::new`](tautline::Certified).
#[derive(Debug)]
pub enum Attempt {}

impl<M: Bounded<D>, const D: usize> Bring<Itself, D> for M {
    type Metric = M;

    fn bring(self) -> Result<M, String> {
        Ok(self)
    }
}

impl<M: Bounded<D>, E: Display + 'static, const D: usize> Bring<Attempt, D> for Result<M, E> {
    type Metric = M;

    fn bring(self) -> Result<M, String> {
        self.map_err(|error| {
            let advice = (&error as &dyn Any).downcast_ref().and_then(advice);
            advice.map_or_else(|| error.to_string(), |advice| format!("{error}.\n{advice}"))
        })
    }
}

/// Returns advice on what to do if no constants are proved.
fn advice(error: &CertifyError) -> Option<&'static str> {
    match error {
        CertifyError::NotPositiveDefinite { .. } | CertifyError::Undefined { .. } => Some(
            "Mend the formula at this point; or test the metric in a ball that avoids it: \
             LocallyCertified::new(metric, accuracy), …, within radius, of centre",
        ),
        CertifyError::NotAllOfSpace | CertifyError::NotSettled { .. } => Some(
            "State the constants (Bounded); or declare that the metric settles far away: \
             Certified::settled(metric, accuracy); or test it in a ball: \
             LocallyCertified::new(metric, accuracy), …, within radius, of centre",
        ),
        CertifyError::NotRecorded(_) => Some("State the constants (Bounded)"),
        CertifyError::BudgetSpent { .. } => Some(
            "Ask for less, Accuracy { tolerance: 1e-2, ..Accuracy::default() }, or for more boxes; \
             or state the constants (Bounded)",
        ),
        _ => None,
    }
}

/// Holds the case of a suite, which the first test to run makes.
///
/// A metric that takes long to make, for example one with proved constants, is made only once. A
/// metric that cannot be made fails once, in the test `the_metric_has_constants`, and no law is
/// tested.
#[derive(Debug, Default)]
pub struct Brought(OnceLock<Result<Box<dyn Any + Send + Sync>, String>>);

impl Brought {
    /// Returns a holder without a case.
    #[must_use]
    pub const fn new() -> Self {
        Self(OnceLock::new())
    }

    /// Returns the case, which the first call makes.
    ///
    /// # Errors
    ///
    /// The error of `make`, or the message of its panic. Every later call returns the same error.
    ///
    /// # Panics
    ///
    /// If two calls make cases for different types of metrics.
    pub fn case<M, const D: usize>(
        &self,
        make: impl FnOnce() -> Result<MetricCase<M, D>, String>,
    ) -> Result<&MetricCase<M, D>, &str>
    where
        M: Bounded<D> + Send + 'static,
    {
        let made = self.0.get_or_init(|| match catch_unwind(AssertUnwindSafe(make)) {
            Ok(made) => made.map(|case| Box::new(case) as _),
            Err(panic) => Err(message(&*panic)),
        });
        match made {
            Ok(case) => Ok(case.downcast_ref().expect("one metric for all tests of a suite")),
            Err(reason) => Err(reason),
        }
    }
}

/// Tests that the case of a suite could be made.
///
/// # Panics
///
/// If the case could not be made, with the reason. No other test fails in this situation.
#[track_caller]
pub fn assert_made<C>(case: Result<C, &str>) {
    if let Err(reason) = case {
        panic!("no law of this suite is tried: {reason}");
    }
}

/// Returns the message of a panic.
fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("a panic without a message").to_owned()
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use nalgebra::{SMatrix, SVector};
    use tautline::{
        Bounded, Certified, CertifyError, Metric, Scalar,
        certify::Accuracy,
        gallery::{Shear, Valleys},
    };

    use super::{Bring, Brought};
    use crate::{Effort, MetricCase, Region};

    fn case_of<M: Bounded<2>>(metric: M) -> MetricCase<M, 2> {
        MetricCase::new(metric, Region::cell([0.0; 2], [6.3; 2]), Effort::default())
    }

    #[test]
    fn a_case_is_made_once() {
        let (place, made) = (Brought::new(), Cell::new(0));
        let case = || {
            let make = || {
                made.set(made.get() + 1);
                Ok(case_of(Valleys))
            };
            place.case(make).expect("a metric")
        };
        assert!(std::ptr::eq(case(), case()));
        assert_eq!(made.get(), 1);
    }

    #[test]
    fn a_panic_is_caught_once_and_reported_to_every_test() {
        let (place, made) = (Brought::new(), Cell::new(0));
        for _ in 0..3 {
            let case = place.case::<Shear, 2>(|| {
                made.set(made.get() + 1);
                Ok(case_of(Shear::new(0.5, f64::NAN).expect("a wave number")))
            });
            let reason = case.map(|_| ()).expect_err("there is no such metric");
            assert!(reason.starts_with("a wave number: "), "{reason}");
        }
        assert_eq!(made.get(), 1);
    }

    /// The matrix `[[1, 1.1 sin x₁], [·, 1]]` is indefinite around `x₁ = π/2`.
    #[derive(Debug)]
    struct Leaning;
    impl Metric<2> for Leaning {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let off = x[0].sin() * 1.1;
            SMatrix::<S, 2, 2>::new(S::one(), off, off, S::one())
        }
    }

    #[test]
    fn a_failed_attempt_shows_the_place_and_gives_advice() {
        let reason = |attempt: Result<Certified<Leaning, 2>, _>| {
            attempt.bring().map(|_| ()).expect_err("indefinite")
        };
        let error = Certified::new(Leaning, Accuracy::default()).expect_err("indefinite");
        let CertifyError::NotPositiveDefinite { point, .. } = &error else { panic!("{error}") };
        let (place, said) = (format!("{point:?}"), reason(Err(error)));
        assert!(said.contains(&place) && said.contains("Mend the formula"), "{said}");
        let said = reason(Err(CertifyError::NotAllOfSpace));
        assert!(said.contains("Certified::settled") && said.contains("within radius"), "{said}");
        assert_eq!(reason(Err(CertifyError::NoDimension)), "D = 0: there is no dimension");
        let few = Accuracy { budget: 1, tolerance: 1e-9 };
        let error = Certified::<_, 2>::new(Valleys, few).map(|_| ()).expect_err("one box");
        assert!(matches!(error, CertifyError::BudgetSpent { .. }), "{error}");
        let said = reason(Err(error));
        assert!(said.contains("after 1 boxes") && said.contains("Ask for less"), "{said}");
    }

    #[test]
    #[should_panic(expected = "no law of this suite is tried: indefinite at 0")]
    fn a_case_that_could_not_be_made_fails_its_test() {
        super::assert_made(Err::<(), _>("indefinite at 0"));
    }

    #[test]
    fn a_metric_and_a_successful_attempt_bring_the_same() {
        let attempt: Result<Valleys, CertifyError> = Ok(Valleys);
        let brought = [Bring::<_, 2>::bring(attempt), Bring::<_, 2>::bring(Valleys)];
        let [one, other] = brought.map(|metric| Bounded::<2>::constants(&metric.expect("brought")));
        assert_eq!(one, other);
    }
}
