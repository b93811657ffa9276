//! `Margin`: how near one sample comes to breaking a law.

/// How near a sample comes to breaking a law, and what was assumed of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Margin {
    /// The overestimation; NaN if the sample could not have broken the law.
    pub(crate) overestimation: f64,
    /// The hypotheses that nothing checked, each once.
    pub(crate) assumed: Vec<&'static str>,
}

/// The overestimation of a sample that could not have broken a law.
pub(crate) const IDLE: f64 = f64::NAN;

impl Margin {
    /// The margin of a sample that could not have broken the law.
    pub(crate) fn idle() -> Self {
        IDLE.into()
    }

    /// Whether the sample could not have broken the law.
    pub(crate) fn is_idle(&self) -> bool {
        self.overestimation.is_nan()
    }

    /// Combines two margins of one sample: the smaller overestimation, the hypotheses of both.
    pub(crate) fn and(mut self, other: Self) -> Self {
        merge(&mut self.assumed, &other.assumed);
        // `min` prefers a number to NaN: a sample can break the law if one of its parts can.
        Self { overestimation: self.overestimation.min(other.overestimation), ..self }
    }
}

impl From<f64> for Margin {
    /// An overestimation that rests on no assumption.
    fn from(overestimation: f64) -> Self {
        Self { overestimation, assumed: Vec::new() }
    }
}

/// Appends what is missing, in order.
pub(crate) fn merge(all: &mut Vec<&'static str>, more: &[&'static str]) {
    for claim in more {
        if !all.contains(claim) {
            all.push(claim);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{IDLE, Margin};

    #[test]
    fn combined_margins_keep_the_smaller_overestimation_and_all_assumptions() {
        let margin = |overestimation, assumed: &[&'static str]| Margin {
            overestimation,
            assumed: assumed.to_vec(),
        };
        let both = margin(3.0, &["a", "b"]).and(margin(2.0, &["b", "c"]));
        assert_eq!(both, margin(2.0, &["a", "b", "c"]));
        for (one, other) in [(IDLE, 2.0), (2.0, IDLE)] {
            assert_eq!(Margin::from(one).and(other.into()), 2.0.into());
        }
        assert!(Margin::idle().and(IDLE.into()).is_idle());
    }
}
