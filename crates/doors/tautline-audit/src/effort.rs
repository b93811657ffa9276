//! `Effort`: how much an audit may do.

use std::time::Duration;

/// How much an audit may do. What is `None` is taken from the file, or else from the kit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// The number of random samples for each law, at least 1.
    pub cases: Option<u32>,
    /// The seed of the samples.
    pub seed: Option<u64>,
    /// The time after which no result is waited for. Laws that are not done by then are listed as
    /// not tried.
    pub time_limit: Duration,
}

impl Default for Effort {
    /// Returns 20 seconds.
    fn default() -> Self {
        Self { cases: None, seed: None, time_limit: Duration::from_secs(20) }
    }
}
