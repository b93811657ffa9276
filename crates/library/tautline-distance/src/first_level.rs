//! The first level: cubes that short curves cannot leave.

use nalgebra::SVector;
use tautline_check::{Chain, CheckError, Cubes, Level, Place, Region};
use tautline_sets::Shape;

use crate::{
    DistanceError,
    marching::Nodes,
    neighbourhood::Neighbourhood,
    proposal::{Source, dilated, scaled},
    search::{KEPT, Search},
    seed::distance,
    tubes::tubes,
};

/// About how many cubes there are along the curve where the region is found, by dimension.
const ALONG: [f64; 4] = [16.0, 8.0, 5.0, 4.0];

/// How far the first level reaches at first, in distances that are needed.
const MARGIN: f64 = 1.2;

/// How far it reaches at most, and how large the share of one set is at most.
const LARGEST_MARGIN: f64 = 2.0;
const LARGEST_SHARE: f64 = 0.75;

/// How much more than is needed the second attempt should prove.
const ENOUGH: f64 = 1.02;

/// By which factor the part that is not proved falls on cubes half as large.
const FALL: f64 = 1.8;

/// By how many cubes the cubes are dilated for a march: along their boundary the nodes lack
/// neighbours, and the values are too large.
const DILATION: i32 = 1;

/// In how many ways the distance may be shared between the two sets.
const SHARES: i32 = 40;

/// The factor of the values: slopes above 1 cost less than slopes below 1.
const SCALE: f64 = 1.003;

/// How many cubes the first level should have, and may have, by dimension.
const COUNTS: [(usize, usize); 4] = [(64, 4096), (1500, 150_000), (4000, 120_000), (8000, 60_000)];

/// How many cubes are looked at in the search for a region.
const MOST: [usize; 4] = [4096, 20_000, 30_000, 40_000];

/// The proof so far, with its region and its first level.
pub(crate) type First<'s, const D: usize> = (Region, Level<D>, Chain<'s, D>);

impl<const D: usize> Search<'_, D> {
    /// Returns a region, the first level with at most `most` cubes, and the proof so far.
    pub(crate) fn first_level(&self, most: usize) -> Result<First<'_, D>, DistanceError> {
        let (few, many) = COUNTS[D - 1];
        let many = many.min(most);
        if let Some(region) = tubes(self.formula, self.sets, &self.curve, self.hi) {
            let mut exponent = (self.euclidean() / ALONG[D - 1]).log2().floor() as i32;
            let mut largest: Option<Cubes<D>> = None;
            // Smaller ones until there are enough, but not more than there may be.
            while largest.as_ref().is_none_or(|cubes| cubes.places().len() < few) {
                let hi = self.hi * (1.0 + KEPT);
                let cubes = match region.required(self.sets.each_ref(), hi, exponent) {
                    Ok(cubes) => cubes,
                    // Larger cubes will do.
                    Err(_) if largest.is_some() => break,
                    Err(CheckError::TooLarge { .. }) => break,
                    Err(error) => return Err(DistanceError::Refused(error)),
                };
                if cubes.places().len() > many {
                    break;
                }
                largest = Some(cubes);
                exponent -= 1;
            }
            // Fewer are not worth it, unless no more are wanted.
            if let Some(cubes) = largest.filter(|cubes| cubes.places().len() >= few.min(most / 8)) {
                return self.on(region, &cubes);
            }
        }
        self.by_exit(many)
    }

    /// Returns a first level whose own values show that short curves do not leave it.
    fn by_exit(&self, many: usize) -> Result<First<'_, D>, DistanceError> {
        let both = self.sets.iter().all(|set| is_small(set, self.euclidean()));
        let region = if both { Region::ExitTwo } else { Region::ExitOne };
        let mut margin = MARGIN;
        let mut halvings = 0;
        let mut reason = CheckError::TooLarge { most: many };
        let near = self.near(region)?;
        let mut next = self.within(&near, margin, halvings);
        while let Some(cubes) = next.take().filter(|cubes| cubes.places().len() <= many) {
            let least = match self.on(region, &cubes) {
                Ok(found) => return Ok(found),
                Err(DistanceError::Refused(CheckError::Exit { least, hi })) => {
                    reason = CheckError::Exit { least, hi };
                    least
                }
                Err(error) => return Err(error),
            };
            // The part of the way to the boundary that is proved. A larger region and smaller cubes are
            // both possible.
            let proved = (least / (margin * self.hi)).clamp(0.05, 1.0);
            // What is not proved is partly lost at the sets, and partly on the way.
            let wide = 0.5 * ENOUGH * (1.0 / proved + 1.0 + margin * (1.0 - proved));
            let fine = ENOUGH / (1.0 - (1.0 - proved) / FALL);
            let tries = [(wide, halvings), (fine, halvings + 1), (margin, halvings + 1)];
            let mut found = tries.into_iter().filter_map(|(margin, halvings)| {
                Some((self.within(&near, margin, halvings)?, margin, halvings))
            });
            let first = found.next();
            let best = match (first, found.next()) {
                (Some(one), Some(two)) if two.0.places().len() < one.0.places().len() => Some(two),
                (first, second) => first.or(second),
            };
            if let Some((cubes, with, times)) = best {
                (margin, halvings) = (with, times);
                next = Some(cubes);
            }
        }
        Err(DistanceError::Region { hi: self.hi, reason })
    }

    /// Tries these cubes.
    fn on(&self, region: Region, cubes: &Cubes<D>) -> Result<First<'_, D>, DistanceError> {
        let nodes = Nodes::new(self.formula, &dilated(cubes, DILATION)?);
        let values = self.marched(&nodes, &cubes.nodes(), Source::March);
        let values = values.ok_or(DistanceError::NoValues)?;
        let values = values.map(|values| scaled(values, SCALE));
        let refused = DistanceError::Refused;
        let level = Level::new(0, cubes.clone(), values).map_err(refused)?;
        let mut chain = Chain::new(self.formula, self.sets, self.hi, region).map_err(refused)?;
        chain.add(&level, self.hi * (1.0 + KEPT)).map_err(refused)?;
        Ok((region, level, chain))
    }

    /// Returns the cubes near the first set, and near the second one if curves may leave the cubes of
    /// either.
    fn near(&self, region: Region) -> Result<Vec<Neighbourhood<D>>, DistanceError> {
        let exponent = (self.euclidean() / ALONG[D - 1]).log2().floor() as i32;
        let [first, second] = self.sets.each_ref();
        let seeds = |sets| {
            Region::ExitOne.required(sets, self.hi, exponent).map_err(DistanceError::Refused)
        };
        let near = |set, seeds: &Cubes<D>, reach: f64, end: &dyn Fn(&SVector<f64, D>) -> bool| {
            Neighbourhood::new(self.formula, (set, seeds), reach * self.hi, MOST[D - 1], end)
        };
        let own = seeds([first, second])?;
        if region == Region::ExitTwo {
            let other = seeds([second, first])?;
            let reach = LARGEST_SHARE * LARGEST_MARGIN;
            return Ok(vec![
                near(first, &own, reach, &|_| false),
                near(second, &other, reach, &|_| false),
            ]);
        }
        // Curves end where they meet the second set.
        let inside = 0.5 * own.side() * (D as f64).sqrt();
        let pieces = second.pieces();
        let is_inside =
            |x: &SVector<f64, D>| pieces.iter().any(|piece| distance(piece, x) <= -inside);
        Ok(vec![near(first, &own, LARGEST_MARGIN, &is_inside)])
    }

    /// Returns cubes that reach `margin` times as far as short curves go, halved this many times; `None`
    /// if there are too many.
    fn within(&self, near: &[Neighbourhood<D>], margin: f64, halvings: usize) -> Option<Cubes<D>> {
        let exponent = (self.euclidean() / ALONG[D - 1]).log2().floor() as i32;
        let reach = margin * self.hi;
        let mut places = match near {
            [one] => one.within(reach)?.to_vec(),
            [one, two] => {
                // The way to infinity may be longer from one set than from the other.
                let shares = (0..=SHARES).filter_map(|share| {
                    let share = f64::from(share) / f64::from(SHARES);
                    Some([one.within(share * reach)?, two.within((1.0 - share) * reach)?])
                });
                shares.min_by_key(|[one, two]| one.len() + two.len())?.concat()
            }
            _ => return None,
        };
        places.extend(near.iter().flat_map(Neighbourhood::seeds));
        let side = 2.0_f64.powi(exponent);
        places.extend(
            self.curve
                .iter()
                .map(|x| -> Place<D> { std::array::from_fn(|i| (x[i] / side).floor() as i32) }),
        );
        let mut cubes = Cubes::new(exponent, places).ok()?;
        for _ in 0..halvings {
            cubes = cubes.halved().ok()?;
        }
        Some(cubes)
    }
}

/// Returns whether a set is a point or small compared with this length.
fn is_small<const D: usize>(set: &Shape<D>, length: f64) -> bool {
    set.pieces().iter().all(|piece| match piece {
        Shape::Point(_) => true,
        Shape::Ball(ball) => ball.r() <= length,
        Shape::AxisBox(side) => (side.upper() - side.lower()).norm() <= length,
        _ => false,
    })
}
