//! `Tally`: counts comparisons of enclosures with values.

use tautline_scalar::{Enclosure, Kernel};

use super::{Precise, Value};

/// How many comparisons there were, by outcome.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    /// There is a value, and the enclosure has at least one finite end.
    pub(crate) compared: u64,
    /// The value is zero, and the enclosure is `[0, 0]`. These are mostly derivatives of constants.
    pub(crate) zeros: u64,
    /// There is no value, and the enclosure is undefined.
    pub(crate) undefined: u64,
    /// There is a value, but the enclosure is undefined or the whole line: valid but useless.
    pub(crate) useless: u64,
    /// The value is unknown.
    pub(crate) unknown: u64,
}

impl Tally {
    /// Compares an enclosure over a box with the value at a point of the box.
    ///
    /// # Errors
    ///
    /// If the enclosure misses the value, or is defined where the formula is not.
    pub(crate) fn compare<K: Kernel>(
        &mut self,
        x: Enclosure<K>,
        at: Precise,
    ) -> Result<(), String> {
        match at.value() {
            Value::Unknown => self.unknown += 1,
            Value::Undefined if x.is_undefined() => self.undefined += 1,
            Value::Undefined => return Err(format!("{x:?} where nothing is defined")),
            Value::Within(_) if x.is_undefined() => self.useless += 1,
            Value::Within(_) if x.lo() == f64::NEG_INFINITY && x.hi() == f64::INFINITY => {
                self.useless += 1;
            }
            Value::Within(y) if y.is_zero() && x.magnitude() == 0.0 => self.zeros += 1,
            Value::Within(y) => {
                let below = x.lo() != f64::NEG_INFINITY && y.is_below(x.lo());
                let above = x.hi() != f64::INFINITY && y.is_above(x.hi());
                if below || above {
                    return Err(format!("{x:?} misses {at:?}"));
                }
                self.compared += 1;
            }
        }
        Ok(())
    }

    /// The number of comparisons.
    pub(crate) fn total(&self) -> u64 {
        self.compared + self.zeros + self.undefined + self.useless + self.unknown
    }

    pub(crate) fn add(&mut self, other: Self) {
        self.compared += other.compared;
        self.zeros += other.zeros;
        self.undefined += other.undefined;
        self.useless += other.useless;
        self.unknown += other.unknown;
    }
}
