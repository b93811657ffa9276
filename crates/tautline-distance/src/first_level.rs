//! The first level: cubes that short curves cannot leave.

use nalgebra::SVector;
use tautline_check::{Chain, CheckError, Cubes, Level, Place, Region};
use tautline_sets::Shape;

use crate::{
    DistanceError,
    marching::Nodes,
    search::{KEPT, Search, Source, dilated, scaled},
};

/// About how many cubes there are along the curve where the region is found.
const ALONG: f64 = 8.0;

/// How far the first level reaches beyond what is needed, in turn.
const MARGINS: [f64; 3] = [1.15, 1.4, 1.8];

/// How many cubes the first level should have, and may have, by dimension.
const COUNTS: [(usize, usize); 4] = [(64, 4096), (1500, 50_000), (4000, 120_000), (8000, 60_000)];

/// The proof so far, with its region and its first level.
pub(crate) type First<'s, const D: usize> = (Region, Level<D>, Chain<'s, D>);

impl<const D: usize> Search<'_, D> {
    /// Returns a region, the first level and the proof so far.
    pub(crate) fn first_level(&self) -> Result<First<'_, D>, DistanceError> {
        let mut reason = CheckError::Empty;
        for margin in MARGINS {
            match self.by_exit(margin) {
                Ok(found) => return Ok(found),
                Err(DistanceError::Refused(error)) => reason = error,
                Err(error) => return Err(error),
            }
        }
        Err(DistanceError::Region { hi: self.hi, reason })
    }

    /// Tries cubes that reach `margin` times as far from the sets as short curves go.
    fn by_exit(&self, margin: f64) -> Result<First<'_, D>, DistanceError> {
        let euclidean = self.euclidean();
        let both = self.sets.iter().all(|set| is_small(set, euclidean));
        let region = if both { Region::ExitTwo } else { Region::ExitOne };
        let reach = if both { 0.5 } else { 1.0 } * margin * self.hi;
        let exponent = (euclidean / ALONG).log2().floor() as i32;
        let mut cubes = self.within(exponent, region, reach)?;
        let (few, many) = COUNTS[D - 1];
        let mut refused = CheckError::Empty;
        loop {
            if cubes.places().len() >= few {
                let mut chain = Chain::new(self.formula, self.sets, self.hi, region)
                    .map_err(DistanceError::Refused)?;
                let nodes = Nodes::new(self.formula, &cubes);
                let values =
                    [0, 1].map(|side| nodes.march(self.seeds(&nodes, side, Source::Set)));
                let level = Level::new(0, cubes.clone(), values.map(|values| scaled(values, 1.003)))
                    .map_err(DistanceError::Refused)?;
                match chain.add(&level, self.hi * (1.0 + KEPT)) {
                    Ok(()) => return Ok((region, level, chain)),
                    Err(error) => refused = error,
                }
            }
            if cubes.places().len() << D > many {
                return Err(DistanceError::Refused(refused));
            }
            cubes = cubes.halved().map_err(DistanceError::Refused)?;
        }
    }

    /// Returns the cubes of side `2^exponent` that have a corner within `reach` of a set (of the
    /// first one, if the region has one exit), and those that the region requires.
    fn within(
        &self,
        exponent: i32,
        region: Region,
        reach: f64,
    ) -> Result<Cubes<D>, DistanceError> {
        let required = region.required(self.sets.each_ref(), self.hi, exponent);
        let required = required.map_err(DistanceError::Refused)?;
        let side = required.side();
        let place = |x: &SVector<f64, D>| -> Place<D> {
            std::array::from_fn(|i| (x[i] / side).floor() as i32)
        };
        let mut places: Vec<Place<D>> = self.curve.iter().map(place).collect();
        places.extend(required.places());
        let near = Cubes::new(exponent, places.clone()).map_err(DistanceError::Refused)?;
        let mut wide = dilated(&near, ALONG as i32 / 2)?;
        for _ in 0..6 {
            let nodes = Nodes::new(self.formula, &wide);
            let values = [0, 1].map(|side| nodes.march(self.seeds(&nodes, side, Source::Set)));
            let least = |all: &[f64], place: &Place<D>| {
                let corners = crate::marching::corners(place);
                let values = corners.filter_map(|corner| nodes.value(all, &corner));
                values.fold(f64::INFINITY, f64::min)
            };
            let counts = |place: &&Place<D>| {
                least(&values[0], place) <= reach
                    || region == Region::ExitTwo && least(&values[1], place) <= reach
            };
            let counted = wide.places().iter().filter(counts).chain(&places).copied();
            let cubes = Cubes::new(exponent, counted.collect()).map_err(DistanceError::Refused)?;
            let around = dilated(&cubes, 1)?;
            // If a cube at the boundary counts, more may lie beyond.
            if around.places().iter().all(|place| wide.contains(place)) {
                return Ok(cubes);
            }
            wide = dilated(&cubes, ALONG as i32 / 2)?;
        }
        Err(DistanceError::Refused(CheckError::Empty))
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
