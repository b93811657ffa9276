//! `Met`: what a law meets in one sample.

/// How near a sample came to breaking a law, and what was assumed of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Met {
    /// The overestimation; NaN if the sample could not have broken the law.
    pub(crate) overestimation: f64,
    /// The hypotheses that nobody looked at, each once.
    pub(crate) assumed: Vec<&'static str>,
}

/// The overestimation of a sample that could not have broken a law.
pub(crate) const IDLE: f64 = f64::NAN;

impl Met {
    /// One of which nothing is tried yet.
    pub(crate) fn nothing() -> Self {
        IDLE.into()
    }

    /// Whether the sample could not have broken the law.
    pub(crate) fn is_idle(&self) -> bool {
        self.overestimation.is_nan()
    }

    /// What two of one sample are together: the lesser overestimation, and the hypotheses of both.
    pub(crate) fn and(mut self, other: Self) -> Self {
        merge(&mut self.assumed, &other.assumed);
        // A number before NaN: one that could fail is enough.
        Self { overestimation: self.overestimation.min(other.overestimation), ..self }
    }
}

impl From<f64> for Met {
    /// An overestimation of which nothing is assumed.
    fn from(overestimation: f64) -> Self {
        Self { overestimation, assumed: Vec::new() }
    }
}

/// Adds what is not yet there, in the order in which it came.
pub(crate) fn merge(all: &mut Vec<&'static str>, more: &[&'static str]) {
    for claim in more {
        if !all.contains(claim) {
            all.push(claim);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{IDLE, Met};

    #[test]
    fn two_of_one_sample_have_the_lesser_overestimation_and_all_that_is_assumed() {
        let met = |overestimation, assumed: &[&'static str]| Met {
            overestimation,
            assumed: assumed.to_vec(),
        };
        let both = met(3.0, &["a", "b"]).and(met(2.0, &["b", "c"]));
        assert_eq!(both, met(2.0, &["a", "b", "c"]));
        for (one, other) in [(IDLE, 2.0), (2.0, IDLE)] {
            assert_eq!(Met::from(one).and(other.into()), 2.0.into());
        }
        assert!(Met::nothing().and(IDLE.into()).is_idle());
    }
}
