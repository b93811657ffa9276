//! Searches in a dimension that is a value: the one place that chooses the code for a dimension.

use std::{any::Any, ops::ControlFlow};

use nalgebra::SVector;
use tautline_check::{AnyCertificate, CheckError, Cubes, Proved, Verdict};
use tautline_formula::Formula;
use tautline_scalar::ANY;
use tautline_sets::Shape;

use crate::{
    DistanceError, Ended, Found, Progress, Wanted, contact::chord_between_members,
    search::search_in,
};

/// A certificate, and what it proves, in one to four dimensions.
#[derive(Clone, Debug)]
pub enum AnyFound {
    /// On the line.
    Line(Found<1>),
    /// In the plane.
    Plane(Found<2>),
    /// In space.
    Space(Found<3>),
    /// In four dimensions.
    Four(Found<4>),
}

/// Evaluates an expression of the certificate, whatever its dimension.
macro_rules! of {
    ($any:expr, $found:ident => $of:expr) => {
        match $any {
            AnyFound::Line($found) => $of,
            AnyFound::Plane($found) => $of,
            AnyFound::Space($found) => $of,
            AnyFound::Four($found) => $of,
        }
    };
}

/// Cubes in a dimension that is a value.
#[derive(Clone, Debug, PartialEq)]
pub struct AnyCubes {
    /// Their side, in `ℓ`.
    pub side: f64,
    /// Their places, one after the other: a cube at `k` is `k a + [0, a]^D` for the side `a`.
    pub places: Vec<i32>,
}

impl<const D: usize> From<&Cubes<D>> for AnyCubes {
    fn from(cubes: &Cubes<D>) -> Self {
        Self { side: cubes.side(), places: cubes.places().iter().flatten().copied().collect() }
    }
}

impl AnyFound {
    /// Returns the dimension.
    #[must_use]
    pub fn dimension(&self) -> usize {
        match self {
            Self::Line(_) => 1,
            Self::Plane(_) => 2,
            Self::Space(_) => 3,
            Self::Four(_) => 4,
        }
    }

    /// Returns the certificate, as the text that a checker reads.
    #[must_use]
    pub fn certificate(&self) -> String {
        of!(self, found => found.certificate.to_string())
    }

    /// Proves the certificate again, as anybody would: from its text.
    ///
    /// # Errors
    ///
    /// [`CheckError`] if it proves nothing.
    pub fn check(&self) -> Result<Verdict, CheckError> {
        AnyCertificate::read(&self.certificate())?.check()
    }

    /// Returns the proved lower bound on the distance, in `m`.
    #[must_use]
    pub fn lower(&self) -> f64 {
        of!(self, found => found.proved.lower)
    }

    /// Returns the proved upper bound on the distance, in `m`.
    #[must_use]
    pub fn upper(&self) -> Option<f64> {
        of!(self, found => found.proved.upper)
    }

    /// Returns `(upper − lower)/upper`, as [`Proved::gap`].
    #[must_use]
    pub fn gap(&self) -> Option<f64> {
        of!(self, found => found.proved.gap())
    }

    /// Returns what the levels prove, from coarse to fine: the number of cubes, and the lower bound so far,
    /// in `m`.
    #[must_use]
    pub fn levels(&self) -> &[(usize, f64)] {
        of!(self, found => &found.proved.levels)
    }

    /// Returns the cubes of each level, from coarse to fine.
    #[must_use]
    pub fn cubes(&self) -> Vec<AnyCubes> {
        of!(self, found => found.certificate.levels.iter().map(|it| it.cubes().into()).collect())
    }

    /// Returns the cubes that hold every minimal geodesic.
    #[must_use]
    pub fn corridor(&self) -> AnyCubes {
        fn corridor<const D: usize>(proved: &Proved<D>) -> AnyCubes {
            (&proved.corridor).into()
        }
        of!(self, found => corridor(&found.proved))
    }

    /// Returns why the search ended.
    #[must_use]
    pub fn ended(&self) -> Ended {
        of!(self, found => found.ended)
    }

    /// Returns the same in `R^D`; `None` if it lies in another dimension.
    #[must_use]
    pub fn into_dimension<const D: usize>(self) -> Option<Found<D>> {
        let found: Box<dyn Any> = of!(self, found => Box::new(found));
        found.downcast::<Found<D>>().ok().map(|found| *found)
    }
}

/// Searches like [`search`](crate::search), in a dimension that is a value. A curve is given by the
/// coordinates of its points, one after the other.
///
/// # Errors
///
/// Those of [`search`](crate::search).
///
/// # Panics
///
/// If the sets do not lie in the dimension of the formula.
pub fn search_any(
    formula: &Formula<ANY>,
    sets: &[Shape<ANY>; 2],
    curves: &[Vec<f64>],
    wanted: Wanted,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<AnyFound, DistanceError> {
    Ok(match formula.dimension() {
        1 => AnyFound::Line(typed(formula, sets, curves, wanted, observe)?),
        2 => AnyFound::Plane(typed(formula, sets, curves, wanted, observe)?),
        3 => AnyFound::Space(typed(formula, sets, curves, wanted, observe)?),
        4 => AnyFound::Four(typed(formula, sets, curves, wanted, observe)?),
        dimension => return Err(refused(dimension)),
    })
}

fn typed<const D: usize>(
    formula: &Formula<ANY>,
    sets: &[Shape<ANY>; 2],
    curves: &[Vec<f64>],
    wanted: Wanted,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Found<D>, DistanceError> {
    let (formula, sets) = in_dimension::<D>(formula, sets);
    let points = |curve: &Vec<f64>| curve.chunks_exact(D).map(SVector::from_column_slice).collect();
    let curves: Vec<Vec<SVector<f64, D>>> = curves.iter().map(points).collect();
    search_in(&formula, &sets, &curves, wanted, observe)
}

/// Returns a chord from a member of the first set to one of the second next to these two points, which are
/// ends of a curve between sets that touch up to rounding. It comes with its proved length, in `m`; a chord of
/// length 0 is a common point.
///
/// # Errors
///
/// [`DistanceError::Curve`] if no chord is proved to run from set to set where the metric is one, and
/// [`DistanceError::Refused`] in more than four dimensions.
///
/// # Panics
///
/// If the sets do not lie in the dimension of the formula.
pub fn shortest_chord(
    formula: &Formula<ANY>,
    sets: &[Shape<ANY>; 2],
    ends: [&[f64]; 2],
) -> Result<(Vec<f64>, f64), DistanceError> {
    fn typed<const D: usize>(
        formula: &Formula<ANY>,
        sets: &[Shape<ANY>; 2],
        ends: [&[f64]; 2],
    ) -> Result<(Vec<f64>, f64), DistanceError> {
        let (formula, sets) = in_dimension::<D>(formula, sets);
        let ends = ends.map(SVector::from_column_slice);
        let (chord, length) = chord_between_members(&formula, &sets, ends)?;
        Ok((chord.iter().flatten().copied().collect(), length))
    }
    match formula.dimension() {
        1 => typed::<1>(formula, sets, ends),
        2 => typed::<2>(formula, sets, ends),
        3 => typed::<3>(formula, sets, ends),
        4 => typed::<4>(formula, sets, ends),
        dimension => Err(refused(dimension)),
    }
}

fn in_dimension<const D: usize>(
    formula: &Formula<ANY>,
    sets: &[Shape<ANY>; 2],
) -> (Formula<D>, [Shape<D>; 2]) {
    let formula = formula.clone().into_dimension().expect("the dimension of the formula");
    let set = |set: &Shape<ANY>| set.clone().into_dimension().expect("sets in the same space");
    (formula, sets.each_ref().map(set))
}

fn refused(dimension: usize) -> DistanceError {
    DistanceError::Refused(CheckError::Dimension { dimension })
}
