//! `AnyTwoForms`: random data for Proposition 7.5.

use nalgebra::{SMatrix, SVector};
use quickcheck::{Arbitrary, Gen};
use tautline_statements::{TwoForms, operator_norm};

/// Two points, vectors and matrices that satisfy the hypotheses of Proposition 7.5, made from
/// `4D + 2D² + 2` integers.
///
/// `H(x₂) = MᵀM`, and `H(x₁)` differs from it by a symmetric matrix of any sign. `H(x₁)` need not
/// be positive, since the proposition does not assume that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnyTwoForms<const D: usize>(Vec<i8>);

impl<const D: usize> AnyTwoForms<D> {
    const LENGTH: usize = 4 * D + 2 * D * D + 2;

    /// Returns the data made from `4D + 2D² + 2` integers, in eighths. Further integers are
    /// ignored, and missing ones are 0.
    #[must_use]
    pub fn of(mut eighths: Vec<i8>) -> Self {
        eighths.resize(Self::LENGTH, 0);
        Self(eighths)
    }

    /// Returns the data. The constants are the smallest that the matrices allow, or up to twice as
    /// large.
    #[must_use]
    pub fn forms(&self) -> TwoForms<D> {
        let mut numbers = self.0.iter().map(|&eighths| f64::from(eighths) / 8.0);
        let mut next = || numbers.next().expect("one of LENGTH");
        let [x1, x2, u1, u2] = [(); 4].map(|()| SVector::<f64, D>::from_fn(|_, _| next()));
        let m: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| next());
        let change: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| next());
        let [spare_c2, spare_l] = [(); 2].map(|()| 1.0 + next().abs() / 16.0);
        let second: SMatrix<f64, D, D> = m.tr_mul(&m);
        let step = (x1 - x2).norm();
        // If the two points are equal, both matrices are equal too.
        let change =
            if step == 0.0 { SMatrix::zeros() } else { (change + change.transpose()) * 0.5 };
        let l_h = if step == 0.0 { spare_l } else { spare_l * operator_norm(&change) / step };
        let c2 = spare_c2 * operator_norm(&second);
        TwoForms {
            points: [x1, x2],
            vectors: [u1, u2],
            matrices: [second + change, second],
            c2,
            l_h,
        }
    }
}

impl<const D: usize> Arbitrary for AnyTwoForms<D> {
    fn arbitrary(g: &mut Gen) -> Self {
        // One entry in four is 0, which gives equal points, equal vectors and singular matrices.
        let entry = |g: &mut Gen| if u8::arbitrary(g) < 64 { 0 } else { i8::arbitrary(g) };
        Self((0..Self::LENGTH).map(|_| entry(g)).collect())
    }

    /// Each step makes one entry smaller.
    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let entries = self.0.clone();
        Box::new((0..entries.len()).flat_map(move |k| {
            let before = entries.clone();
            entries[k].shrink().map(move |smaller| {
                let mut entries = before.clone();
                entries[k] = smaller;
                Self(entries)
            })
        }))
    }
}

#[cfg(test)]
mod tests {
    use quickcheck::Arbitrary;
    use tautline_statements::{Finding, prop_7_5};

    use super::{super::holds, AnyTwoForms};

    #[test]
    fn cases_and_what_they_shrink_to_meet_the_hypotheses() {
        fn law(forms: AnyTwoForms<2>) -> bool {
            let mut all = forms.shrink().take(20).chain([forms.clone()]);
            all.all(|case| matches!(prop_7_5(&case.forms()).finding(), Finding::Holds))
        }
        holds(751, 200, law as fn(AnyTwoForms<2>) -> bool);
    }
}
