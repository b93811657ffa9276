//! `Damping`: the state that a local search carries from one iterate to the next.

/// After this many unchecked steps in a row that each predict as large a decrease as the one
/// before, the predicted decrease is rounding, for example from a projection along a soft
/// direction.
const STAGNANT: usize = 3;

/// The first shift, and the factor between shifts. Beyond the last shift, steps are so short that
/// an energy that has not fallen never will.
const FIRST_SHIFT: f64 = 1e-2;
pub(crate) const SHIFT_FACTOR: f64 = 8.0;
pub(crate) const LAST_SHIFT: f64 = 1e12;

/// The damping of a search, and what its last steps were like.
#[derive(Default)]
pub(crate) struct Damping {
    /// The factor `μ` of the regulariser.
    pub(crate) shift: f64,
    /// The number of steps in a row with an indefinite Hessian.
    pub(crate) indefinite: usize,
    /// The number of saddles that the search has left.
    pub(crate) escapes: usize,
    /// The decrement of the last unchecked step, and for how many steps in a row it did not fall.
    promised: f64,
    stagnant: usize,
}

impl Damping {
    pub(crate) fn raise(&mut self) {
        self.shift = (self.shift * SHIFT_FACTOR).max(FIRST_SHIFT);
    }

    pub(crate) fn lower(&mut self) {
        self.shift = if self.shift <= FIRST_SHIFT { 0.0 } else { self.shift / SHIFT_FACTOR };
    }

    /// Records the decrement of an unchecked step, and returns whether the decrements have stopped
    /// falling.
    pub(crate) fn stagnates(&mut self, decrement: f64) -> bool {
        let falls = self.promised == 0.0 || decrement <= 0.25 * self.promised;
        self.stagnant = if falls { 0 } else { self.stagnant + 1 };
        self.promised = decrement;
        self.stagnant >= STAGNANT
    }
}

#[cfg(test)]
mod tests {
    use super::{Damping, FIRST_SHIFT};

    #[test]
    fn the_shift_goes_up_from_zero_and_back() {
        let mut damping = Damping::default();
        damping.raise();
        assert_eq!(damping.shift, FIRST_SHIFT);
        damping.raise();
        damping.lower();
        assert_eq!(damping.shift, FIRST_SHIFT);
        damping.lower();
        assert_eq!(damping.shift, 0.0);
    }

    #[test]
    fn three_decrements_that_do_not_fall_are_stagnation() {
        let mut damping = Damping::default();
        let decrements = [1e-11, 1e-12, 9e-13, 2e-13, 1.5e-13, 1.4e-13, 1.4e-13];
        let stagnates = decrements.map(|decrement| damping.stagnates(decrement));
        assert_eq!(stagnates, [false, false, false, false, false, false, true]);
    }
}
