//! Homogeneity: the same case in two systems of units.

use std::{any::Any, fmt::Debug};

use proptest::prelude::Strategy;
use tautline_statements::{Evidence, Subject, Units, VerifyError};

use super::{Outcome, Trial};

impl Trial<'_> {
    /// Evaluates statements on `cases` random values in two systems of units. Every number has to
    /// scale by its unit.
    ///
    /// The units differ by powers of two, which cause no rounding. Bounds agree to a relative
    /// `10⁻¹²`, which allows for a few hundred roundings in another order; observations agree to
    /// within the granted error.
    ///
    /// # Errors
    ///
    /// The first number that does not scale by its unit.
    pub fn homogeneous<V, E>(
        &self,
        seed: u64,
        cases: u32,
        values: V,
        evidence: impl Fn(&Subject, V::Value, Units) -> Result<E, VerifyError>,
    ) -> Outcome
    where
        V: Strategy + 'static,
        V::Value: Any + Debug + Clone,
        E: IntoIterator<Item = Evidence>,
    {
        let units = (-3..4_i32, -3..4_i32)
            .prop_map(|(ell, m)| Units { ell: 2_f64.powi(ell), m: 2_f64.powi(m) });
        self.for_all(seed, cases, (values, units), |subject, (value, units)| {
            let here: Vec<_> = evidence(subject, value.clone(), Units::ONE)?.into_iter().collect();
            let there: Vec<_> = evidence(subject, value, units)?.into_iter().collect();
            all_scale(&here, &there, units)?;
            Ok(here)
        })
    }
}

fn all_scale(here: &[Evidence], there: &[Evidence], units: Units) -> Result<(), VerifyError> {
    assert_eq!(here.len(), there.len(), "as much evidence in other units");
    here.iter().zip(there).try_for_each(|(here, there)| scales(here, there, units))
}

fn scales(here: &Evidence, there: &Evidence, units: Units) -> Result<(), VerifyError> {
    let pairs = |evidence: &Evidence| {
        evidence.hypotheses.iter().chain(&evidence.conclusions).copied().collect::<Vec<_>>()
    };
    let (here, there) = (pairs(here), pairs(there));
    assert_eq!(here.len(), there.len(), "as many clauses in other units");
    for (here, there) in here.into_iter().zip(there) {
        let factor = here.unit.factor(units.ell, units.m);
        let (observed, bound) = (here.observed * factor, here.bound * factor);
        let (grant, granted) = (here.granted * factor, there.granted + here.granted * factor);
        // The granted error must scale too; otherwise it could hide that the numbers do not. The
        // errors of adaptive quadratures are estimates, which differ by less than a factor of 2.
        let same_grant = there.granted <= 2.0 * grant && grant <= 2.0 * there.granted;
        // Two infinite bounds are equal, but their difference is NaN.
        let same_bound =
            bound == there.bound || (bound - there.bound).abs() <= 1e-12 * bound.abs() + granted;
        let same = observed == there.observed || (observed - there.observed).abs() <= granted;
        if !(same && same_bound && same_grant) {
            let claim = here.claim;
            return Err(VerifyError::NotHomogeneous {
                claim,
                expected: [observed, bound],
                found: [there.observed, there.bound],
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use tautline_statements::{Evidence, Statement, Unit, Units};

    use super::{super::sample, scales};

    /// In units of 1/2, lengths are twice as large and energies four times as large.
    #[test]
    fn every_number_has_to_scale_by_its_unit() {
        let units = Units { ell: 1.0, m: 2.0 };
        let of = |observed: f64, bound: f64, granted: f64| {
            let begun = Evidence::of(Statement::Theorem1_1);
            begun.stated("a bound", Unit::ENERGY, [observed, bound], granted)
        };
        let here = of(1.0, 3.0, 1e-9);
        assert!(scales(&here, &of(4.0, 12.0, 4e-9), units).is_ok());
        for there in [of(2.0, 12.0, 4e-9), of(4.0, 6.0, 4e-9), of(4.0, 12.0, 1e-9)] {
            assert!(scales(&here, &there, units).is_err(), "{there:?}");
        }
    }

    #[test]
    #[should_panic(expected = "as many clauses")]
    fn a_clause_that_is_missing_in_other_units_is_missed() {
        let less = Evidence::of(Statement::Theorem1_1);
        let _ = scales(&sample([0.5, 0.0], 0.5, 0.5), &less, Units::ONE);
    }
}
