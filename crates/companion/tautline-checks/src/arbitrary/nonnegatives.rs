//! `Nonnegatives`: random numbers for Proposition 7.8.

use quickcheck::{Arbitrary, Gen};

/// Nonnegative numbers that are multiples of 1/16 up to 4096; many are small, and some are 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Nonnegatives(Vec<u16>);

impl Nonnegatives {
    /// Returns the numbers, given in sixteenths.
    #[must_use]
    pub fn of(sixteenths: Vec<u16>) -> Self {
        Self(sixteenths)
    }

    /// Returns the numbers.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        self.0.iter().map(|&sixteenths| f64::from(sixteenths) / 16.0).collect()
    }
}

impl Arbitrary for Nonnegatives {
    fn arbitrary(g: &mut Gen) -> Self {
        // Shifts by 0 to 15 bits spread the numbers over several decades.
        let entries = Vec::<(u16, u8)>::arbitrary(g);
        Self(entries.into_iter().map(|(number, shift)| number >> (shift % 16)).collect())
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(self.0.shrink().map(Self))
    }
}

#[cfg(test)]
mod tests {
    use quickcheck::Arbitrary;

    use super::{super::holds, Nonnegatives};

    #[test]
    fn numbers_and_what_they_shrink_to_are_nonnegative() {
        fn law(numbers: Nonnegatives) -> bool {
            let mut all = numbers.shrink().chain([numbers.clone()]);
            all.all(|numbers| numbers.numbers().iter().all(|x| (0.0..=4096.0).contains(x)))
        }
        holds(781, 200, law as fn(Nonnegatives) -> bool);
    }
}
