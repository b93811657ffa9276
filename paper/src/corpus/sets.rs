//! Two random sets, at least one of which is bounded.

use std::sync::Arc;

use tautline::{
    AffineSubspace, AxisBox, Ball, ClosedSet, Ends, FiniteSet, HalfSpace, Point, SVector, Segment,
    SetError, Sphere, Union,
};
use tautline_checks::adversary::SplitMix;

use super::metrics::vector;

/// The kind of a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is the set of its name")]
pub enum Kind {
    Point,
    FiniteSet,
    Ball,
    Sphere,
    AxisBox,
    Segment,
    Union,
    HalfSpace,
    AffineSubspace,
}

impl Kind {
    /// All kinds, the bounded ones first.
    const ALL: [Kind; 9] = [
        Kind::Point,
        Kind::FiniteSet,
        Kind::Ball,
        Kind::Sphere,
        Kind::AxisBox,
        Kind::Segment,
        Kind::Union,
        Kind::HalfSpace,
        Kind::AffineSubspace,
    ];
    const BOUNDED: usize = 7;
    /// How many of the kinds may be members of a union.
    const SIMPLE: usize = 6;
}

/// The two ends of a problem, and their kinds.
#[derive(Clone, Debug)]
pub struct Pair<const D: usize> {
    /// The ends.
    pub ends: Ends<D>,
    /// Their kinds.
    pub kinds: [Kind; 2],
}

impl<const D: usize> Pair<D> {
    /// Returns two sets about random places in the cube `[−reach, reach]^D`, with sizes up to a
    /// third of `reach`. In a quarter of the cases they are two points. Otherwise they are a
    /// bounded set and any set, in either order.
    ///
    /// A half-space lies beyond its place, as seen from the other set. The other sets may be
    /// disjoint or not.
    ///
    /// # Errors
    ///
    /// There are none: the parameters are admissible.
    pub fn new(random: &mut SplitMix, reach: f64) -> Result<Self, SetError> {
        let places: [SVector<f64, D>; 2] = [vector(random, reach), vector(random, reach)];
        if random.below(4) == 0 {
            let [first, second] = places;
            return Ok(Self { ends: Ends::points(first, second)?, kinds: [Kind::Point; 2] });
        }
        let bounded = random.below(2);
        let mut kinds = [Kind::Point; 2];
        kinds[bounded] = Kind::ALL[random.below(Kind::BOUNDED)];
        kinds[1 - bounded] = Kind::ALL[random.below(Kind::ALL.len())];
        let mut set = |end: usize| {
            Draw { random: &mut *random, reach }.set(kinds[end], places[end], places[1 - end])
        };
        Ok(Self { ends: Ends::new(set(0)?, set(1)?)?, kinds })
    }
}

/// Draws sets of one size.
struct Draw<'a> {
    random: &'a mut SplitMix,
    reach: f64,
}

impl Draw<'_> {
    /// Returns a set of this kind about `place`, where `other` is the place of the other set.
    fn set<const D: usize>(
        &mut self,
        kind: Kind,
        place: SVector<f64, D>,
        other: SVector<f64, D>,
    ) -> Result<Arc<dyn ClosedSet<D>>, SetError> {
        let size = self.reach / 3.0;
        Ok(match kind {
            Kind::Point => Arc::new(Point::new(place)?),
            Kind::FiniteSet => {
                let count = 1 + self.random.below(4);
                let points: Vec<SVector<f64, D>> =
                    (0..count).map(|_| place + vector::<D>(self.random, size)).collect();
                Arc::new(FiniteSet::new(points)?)
            }
            Kind::Ball => Arc::new(Ball::new(place, self.random.between(0.0, size))?),
            Kind::Sphere => Arc::new(Sphere::new(place, self.random.between(0.0, size))?),
            Kind::AxisBox => {
                let half = vector::<D>(self.random, size).map(f64::abs);
                Arc::new(AxisBox::new(place, half)?)
            }
            Kind::Segment => {
                let half = vector::<D>(self.random, size);
                Arc::new(Segment::new(place - half, place + half)?)
            }
            Kind::Union => {
                let mut member = || {
                    let kind = Kind::ALL[self.random.below(Kind::SIMPLE)];
                    let aside = vector::<D>(self.random, size);
                    self.set(kind, place + aside, other)
                };
                Arc::new(Union::new(vec![member()?, member()?])?)
            }
            Kind::HalfSpace => {
                let normal = vector::<D>(self.random, 1.0);
                let away = if normal.dot(&(place - other)) < 0.0 { -normal } else { normal };
                Arc::new(HalfSpace::at_least(away, away.dot(&place))?)
            }
            Kind::AffineSubspace => {
                let count = self.random.below(D);
                let directions: Vec<SVector<f64, D>> =
                    (0..count).map(|_| vector(self.random, 1.0)).collect();
                Arc::new(AffineSubspace::new(place, directions)?)
            }
        })
    }
}
