//! The first level: cubes that short curves cannot leave.

use nalgebra::SVector;
use tautline_check::{Chain, CheckError, Cubes, Level, Place, Region};
use tautline_sets::Shape;

use crate::{
    DistanceError,
    marching::Nodes,
    proposal::{Source, dilated, scaled},
    search::{KEPT, Search},
    tubes::tubes,
};

/// About how many cubes there are along the curve where the region is found, by dimension.
const ALONG: [f64; 4] = [16.0, 8.0, 5.0, 4.0];

/// How far the first level reaches beyond what is needed, in turn.
const MARGINS: [f64; 3] = [1.15, 1.4, 1.8];

/// By how many cubes a region is dilated at a time that short curves may leave.
const DILATION: i32 = 3;

/// The factor of the values: slopes above 1 cost less than slopes below 1.
const SCALE: f64 = 1.003;

/// How many cubes the first level should have, and may have, by dimension.
const COUNTS: [(usize, usize); 4] = [(64, 4096), (1500, 50_000), (4000, 120_000), (8000, 60_000)];

/// The proof so far, with its region and its first level.
pub(crate) type First<'s, const D: usize> = (Region, Level<D>, Chain<'s, D>);

impl<const D: usize> Search<'_, D> {
    /// Returns a region, the first level and the proof so far.
    pub(crate) fn first_level(&self) -> Result<First<'_, D>, DistanceError> {
        if let Some(region) = tubes(self.formula, self.sets, &self.curve, self.hi) {
            let (few, many) = COUNTS[D - 1];
            let mut exponent = (self.euclidean() / ALONG[D - 1]).log2().floor() as i32;
            let cubes = loop {
                let cubes = region
                    .required(self.sets.each_ref(), self.hi, exponent)
                    .map_err(DistanceError::Refused)?;
                if cubes.places().len() >= few {
                    break cubes;
                }
                exponent -= 1;
            };
            if cubes.places().len() <= many {
                return self.on(region, &cubes);
            }
        }
        self.by_exit()
    }

    /// Returns a first level whose own values show that short curves do not leave it.
    fn by_exit(&self) -> Result<First<'_, D>, DistanceError> {
        let mut reason = CheckError::Empty;
        let both = self.sets.iter().all(|set| is_small(set, self.euclidean()));
        let region = if both { Region::ExitTwo } else { Region::ExitOne };
        let (few, many) = COUNTS[D - 1];
        // A coarse region that is too large costs less than a fine one. Where the metric hardly
        // confines curves, larger regions may have no end.
        let mut tried: Vec<Cubes<D>> = Vec::new();
        let mut halvings = 0;
        loop {
            let mut smallest = usize::MAX;
            for (n, margin) in MARGINS.into_iter().enumerate() {
                if tried.len() == n {
                    let Ok(mut cubes) = self.within(region, margin) else { break };
                    while cubes.places().len() << (D * halvings) < few {
                        cubes = cubes.halved().map_err(DistanceError::Refused)?;
                    }
                    for _ in 0..halvings {
                        cubes = cubes.halved().map_err(DistanceError::Refused)?;
                    }
                    tried.push(cubes);
                }
                let cubes = &mut tried[n];
                smallest = smallest.min(cubes.places().len());
                if cubes.places().len() > many {
                    continue;
                }
                match self.on(region, cubes) {
                    Ok(found) => return Ok(found),
                    Err(DistanceError::Refused(error)) => reason = error,
                    Err(error) => return Err(error),
                }
                *cubes = cubes.halved().map_err(DistanceError::Refused)?;
            }
            halvings += 1;
            if smallest > many {
                return Err(DistanceError::Region { hi: self.hi, reason });
            }
        }
    }

    /// Tries these cubes.
    fn on(&self, region: Region, cubes: &Cubes<D>) -> Result<First<'_, D>, DistanceError> {
        let nodes = Nodes::new(self.formula, cubes);
        let values =
            [0, 1].map(|side| scaled(nodes.march(self.seeds(&nodes, side, Source::March)), SCALE));
        let refused = DistanceError::Refused;
        let level = Level::new(0, cubes.clone(), values).map_err(refused)?;
        let mut chain = Chain::new(self.formula, self.sets, self.hi, region).map_err(refused)?;
        chain.add(&level, self.hi * (1.0 + KEPT)).map_err(refused)?;
        Ok((region, level, chain))
    }

    /// Returns cubes that reach `margin` times as far as short curves go from the first set, or from
    /// both, and those that the region requires.
    fn within(&self, region: Region, margin: f64) -> Result<Cubes<D>, DistanceError> {
        let along = ALONG[D - 1];
        let exponent = (self.euclidean() / along).log2().floor() as i32;
        let reach = if region == Region::ExitTwo { 0.5 } else { 1.0 } * margin * self.hi;
        let required = region.required(self.sets.each_ref(), self.hi, exponent);
        let required = required.map_err(DistanceError::Refused)?;
        let side = required.side();
        let place = |x: &SVector<f64, D>| -> Place<D> {
            std::array::from_fn(|i| (x[i] / side).floor() as i32)
        };
        let mut places: Vec<Place<D>> = self.curve.iter().map(place).collect();
        places.extend(required.places());
        let near = Cubes::new(exponent, places.clone()).map_err(DistanceError::Refused)?;
        let mut wide = dilated(&near, DILATION)?;
        for _ in 0..12 {
            let nodes = Nodes::new(self.formula, &wide);
            let values = [0, 1].map(|side| nodes.march(self.seeds(&nodes, side, Source::March)));
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
            wide = dilated(&cubes, DILATION)?;
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
