//! The first level: cubes that short curves cannot leave.

use tautline_check::{Chain, CheckError, Cubes, Level, Place, Region};
use tautline_sets::Shape;

use crate::{
    DistanceError,
    marching::Nodes,
    search::{KEPT, Search, dilated},
};

/// About how many cubes the first level has along the curve.
const ALONG: f64 = 48.0;

/// How far the first level reaches beyond what is needed, in turn.
const MARGINS: [f64; 3] = [1.15, 1.4, 1.8];

impl<const D: usize> Search<'_, D> {
    /// Returns a region, the first level and the proof so far.
    pub(crate) fn first_level(&self) -> Result<(Region, Level<D>, Chain<'_, D>), DistanceError> {
        let mut reason = CheckError::Empty;
        for finer in 0..3 {
            for margin in MARGINS {
                match self.by_exit(finer, margin) {
                    Ok(found) => return Ok(found),
                    Err(DistanceError::Refused(error)) => reason = error,
                    Err(error) => return Err(error),
                }
            }
        }
        Err(DistanceError::Region { hi: self.hi, reason })
    }

    /// Tries cubes at most `margin` times as far from the sets as short curves go.
    fn by_exit(
        &self,
        finer: i32,
        margin: f64,
    ) -> Result<(Region, Level<D>, Chain<'_, D>), DistanceError> {
        let euclidean: f64 =
            self.curve.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
        let along = if D == 2 { ALONG } else { 0.5 * ALONG };
        let exponent = (euclidean / along).log2().floor() as i32 - finer;
        let both = self.sets.iter().all(|set| is_small(set, euclidean));
        let region = if both { Region::ExitTwo } else { Region::ExitOne };
        // Cubes around the curve, dilated until the short curves do not reach their boundary.
        let side = 2.0_f64.powi(exponent);
        let place = |x: &nalgebra::SVector<f64, D>| -> Place<D> {
            std::array::from_fn(|i| (x[i] / side).floor() as i32)
        };
        let near = Cubes::new(exponent, self.curve.iter().map(place).collect());
        let mut cubes = near.map_err(DistanceError::Refused)?;
        let required = region.required(self.sets.each_ref(), self.hi, exponent);
        let required = required.map_err(DistanceError::Refused)?;
        let reach = if both { 0.5 } else { 1.0 } * margin * self.hi;
        let mut wide = dilated(&cubes, along as i32 / 2)?;
        for _ in 0..4 {
            let nodes = Nodes::new(self.formula, &wide);
            let values = [0, 1].map(|side| self.marched(&nodes, side, 0.0));
            // A cube counts if one of its nodes does.
            let least = |all: &[f64], place: &Place<D>| {
                let corner = |at: usize| std::array::from_fn(|i| 2 * place[i] + 2 * (at >> i & 1) as i32);
                let values = (0..1 << D).filter_map(|at| nodes.value(all, &corner(at)));
                values.fold(f64::INFINITY, f64::min)
            };
            let counts = |place: &&Place<D>| {
                least(&values[0], place) <= reach || both && least(&values[1], place) <= reach
            };
            let mut places: Vec<Place<D>> = wide.places().iter().filter(counts).copied().collect();
            places.extend(required.places());
            cubes = Cubes::new(exponent, places).map_err(DistanceError::Refused)?;
            // Cubes at the boundary: more may lie beyond.
            let around = dilated(&cubes, 1)?;
            if around.places().iter().all(|place| wide.contains(place)) {
                let chosen = values.map(|all| {
                    let value = |place: &Place<D>| nodes.value(&all, place).unwrap_or(0.0) * 1.003;
                    cubes.nodes().iter().map(value).collect()
                });
                let level = Level::new(0, cubes, chosen).map_err(DistanceError::Refused)?;
                let mut chain = Chain::new(self.formula, self.sets, self.hi, region)
                    .map_err(DistanceError::Refused)?;
                chain.add(&level, self.hi * (1.0 + KEPT)).map_err(DistanceError::Refused)?;
                return Ok((region, level, chain));
            }
            wide = dilated(&cubes, along as i32 / 2)?;
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
