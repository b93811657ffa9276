//! `Shard`: one of several blocks of about the same size.

use std::{ops::Range, str::FromStr};

/// The `k`-th of `n` blocks, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    k: u64,
    n: u64,
}

/// A text or two numbers that are no shard.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{given} is no shard: expected k/n with k from 1 to n, such as 3/40")]
pub struct ShardError {
    /// What was given.
    pub given: String,
}

impl Shard {
    /// All problems in one block.
    pub const WHOLE: Self = Self { k: 1, n: 1 };

    /// Returns the `k`-th of `n` blocks.
    ///
    /// # Errors
    ///
    /// [`ShardError`] unless `1 ≤ k ≤ n`.
    pub fn new(k: u64, n: u64) -> Result<Self, ShardError> {
        if (1..=n).contains(&k) {
            Ok(Self { k, n })
        } else {
            Err(ShardError { given: format!("{k}/{n}") })
        }
    }

    /// Returns the ids of the block: from `⌊(k−1) count/n⌋` to below `⌊k count/n⌋`. If there are more
    /// blocks than problems, some are empty.
    #[must_use]
    pub fn ids(self, count: u64) -> Range<u64> {
        let bound = |k: u64| (u128::from(k) * u128::from(count) / u128::from(self.n)) as u64;
        bound(self.k - 1)..bound(self.k)
    }

    /// Returns the name of the file of a block in a folder: `3-of-40.csv`.
    #[must_use]
    pub fn file_name(self) -> String {
        format!("{}-of-{}.csv", self.k, self.n)
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let wrong = || ShardError { given: text.to_owned() };
        let (k, n) = text.split_once('/').ok_or_else(wrong)?;
        let number = |text: &str| text.trim().parse::<u64>().map_err(|_| wrong());
        Self::new(number(k)?, number(n)?).map_err(|_| wrong())
    }
}

#[cfg(test)]
mod tests {
    use super::Shard;

    #[test]
    fn shards_are_consecutive_and_of_about_the_same_size() {
        for (count, n) in [(10, 3), (7, 7), (3, 5), (0, 2), (2000, 40), (1_000_003, 64)] {
            let mut next = 0;
            for k in 1..=n {
                let ids = Shard::new(k, n).expect("a shard").ids(count);
                assert_eq!(ids.start, next, "{k}/{n} of {count}");
                let size = ids.end - ids.start;
                assert!((count / n..=count.div_ceil(n)).contains(&size), "{k}/{n} of {count}");
                next = ids.end;
            }
            assert_eq!(next, count);
        }
        // Beyond 2⁶⁴ in between.
        let last = Shard::new(1 << 40, 1 << 40).expect("a shard").ids(1 << 53);
        assert_eq!(last, (1 << 53) - (1 << 13)..1 << 53);
    }

    #[test]
    fn what_is_no_shard_is_refused() {
        assert_eq!("3/40".parse(), Shard::new(3, 40));
        for text in ["0/4", "5/4", "3", "a/4", "1/0", "-1/4", "1/2/3", ""] {
            let error = text.parse::<Shard>().expect_err(text).to_string();
            assert!(error.starts_with(&format!("{text} is no shard")), "{error}");
        }
    }
}
