//! Values that are proposed for a level.

use std::collections::HashMap;

use nalgebra::SVector;
use tautline_check::{Cubes, Place, in_parallel};
use tautline_sets::Shape;

use crate::{
    DistanceError,
    fan::{Fan, Pencil},
    geodesic::Geodesic,
    marching::{Nodes, gram, point},
    search::Search,
    seed::seed,
};

/// How far from a point its rays are used as the start of a march, relative to the length of the curve.
const REACH: f64 = 0.25;

/// How many nodes beyond a point the march begins.
const BAND: f64 = 4.0;

/// How many nodes are treated one after the other.
const CHUNK: usize = 512;

/// The steps along rays that are as short as the band is wide.
const SHORT: usize = 200;

/// How many rays of a fan are on each side of a geodesic, along each tangent.
fn rings(dimension: usize) -> i32 {
    match dimension {
        0..=2 => 6,
        3 => 5,
        _ => 3,
    }
}

/// By how many cubes the cubes are dilated before a march: along their boundary the nodes lack
/// neighbours, and the values are too large.
fn dilation(dimension: usize) -> i32 {
    if dimension < 3 { 4 } else { 3 }
}

/// Where values come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// The rays next to a geodesic: very accurate near it, and wrong far away.
    Rays,
    /// Several rays on each side of a geodesic: less accurate near it, and more where the cubes are wide
    /// compared with how curved the fronts are.
    Fans,
    /// Fast marching from the rays behind the ends that are points. There the rays meet behind the
    /// point. A distance from the point itself is not smooth, which costs an order.
    MarchFromRays,
    /// Fast marching from the sets.
    March,
}

/// Returns the values times a factor.
pub(crate) fn scaled(values: Vec<f64>, factor: f64) -> Vec<f64> {
    values.into_iter().map(|value| value * factor).collect()
}

/// Values at points of which each is near the one before.
type Walk<'f, const D: usize> = Box<dyn FnMut(&SVector<f64, D>) -> f64 + 'f>;

/// Two functions at nodes.
pub(crate) type Values = [Vec<f64>; 2];

impl<const D: usize> Search<'_, D> {
    /// Returns values at the nodes of the cubes, all of them finite. Returns `None` if there are no
    /// rays for them, no node near a set has a metric, a ray gives a value that is not finite, or a march
    /// lacks places around the cubes. `marched` keeps the nodes of a march for the next one.
    pub(crate) fn propose(
        &self,
        cubes: &Cubes<D>,
        source: Source,
        marched: &mut Option<Nodes<D>>,
    ) -> Option<Values> {
        if source != Source::March && self.pencils.is_empty() {
            return None;
        }
        if matches!(source, Source::Rays | Source::Fans) {
            let values = self.along_rays(cubes, source)?;
            let is_finite = values.iter().flatten().all(|value| value.is_finite());
            return is_finite.then_some(values);
        }
        let nodes = match marched.take() {
            Some(nodes) => nodes,
            None => {
                // Next to the farthest places there is no room around the cubes.
                let around = dilated(cubes, dilation(D)).ok()?;
                Nodes::new(self.formula, &around)
            }
        };
        let values = self.marched(&nodes, &cubes.nodes(), source);
        *marched = Some(nodes);
        values
    }

    /// Returns the values of a march at some of its nodes; `None` if there is a set near which no node has
    /// a metric.
    pub(crate) fn marched(
        &self,
        nodes: &Nodes<D>,
        places: &[Place<D>],
        source: Source,
    ) -> Option<Values> {
        let of_side = |side: usize| -> Option<Vec<f64>> {
            let all = nodes.march(self.formula, self.seeds(nodes, side, source))?;
            places.iter().map(|place| nodes.value(&all, place)).collect()
        };
        Some([of_side(0)?, of_side(1)?])
    }

    /// Returns the values from the rays; `None` if some cannot be followed. If there are several geodesics
    /// and the cubes have several components, each component uses the geodesic that runs through it.
    fn along_rays(&self, cubes: &Cubes<D>, source: Source) -> Option<Values> {
        let spacing = 0.5 * cubes.side();
        let nodes = cubes.nodes();
        let pencil_of = self.pencils_of(cubes, &nodes);
        let points: Vec<SVector<f64, D>> = nodes.iter().map(|at| point(at, spacing)).collect();
        let of_side = |side: usize| {
            let wide: Vec<Fan<D>> = match source {
                Source::Fans => self.wide_fans(side, &points, &pencil_of)?,
                _ => Vec::new(),
            };
            let of_some = |chunk: usize| -> Vec<f64> {
                let rest = &points[chunk * CHUNK..];
                let points = &rest[..CHUNK.min(rest.len())];
                let narrow = self.pencils.iter().map(|(_, pencil)| &pencil.fans[side]);
                let mut values: Vec<Walk<'_, D>> = match source {
                    Source::Fans => wide.iter().map(|fan| Box::new(fan.walk()) as _).collect(),
                    _ => narrow.map(|fan| Box::new(fan.walk_near()) as _).collect(),
                };
                let value = |(n, x): (usize, &SVector<f64, D>)| {
                    match pencil_of.get(chunk * CHUNK + n) {
                        Some(&pencil) => values[pencil](x),
                        // Without a choice, the least value counts.
                        None => least(values.iter_mut().map(|value| value(x))),
                    }
                };
                points.iter().enumerate().map(value).collect()
            };
            Some(in_parallel(points.len().div_ceil(CHUNK), &of_some).concat())
        };
        Some([of_side(0)?, of_side(1)?])
    }

    /// Returns a fan for each geodesic that covers the points of which it is the pencil, or all points if
    /// there is no choice.
    fn wide_fans(
        &self,
        side: usize,
        points: &[SVector<f64, D>],
        pencil_of: &[usize],
    ) -> Option<Vec<Fan<D>>> {
        let fan = |(n, (geodesic, pencil)): (usize, &(Geodesic<D>, Pencil<D>))| {
            let is_own = |at: usize| pencil_of.get(at).is_none_or(|&pencil| pencil == n);
            let own = points.iter().enumerate().filter(|&(at, _)| is_own(at));
            let own: Vec<SVector<f64, D>> = own.map(|(_, x)| *x).collect();
            pencil.wide((self.formula, &self.sets[side]), geodesic, side, rings(D), &own)
        };
        self.pencils.iter().enumerate().map(fan).collect()
    }

    /// Returns whether two geodesics run through one component of the cubes. Then no function is smooth
    /// and has the gradients of both.
    pub(crate) fn is_shared(&self, cubes: &Cubes<D>) -> bool {
        self.pencils.len() > 1 && self.pencil_of(cubes, &components(cubes)).is_none()
    }

    /// Returns the pencil for each node, by its component; nothing if there is no choice, or if two
    /// geodesics run through one component.
    fn pencils_of(&self, cubes: &Cubes<D>, nodes: &[Place<D>]) -> Vec<usize> {
        if self.pencils.len() < 2 {
            return Vec::new();
        }
        let component = components(cubes);
        let Some(pencil_of) = self.pencil_of(cubes, &component) else { return Vec::new() };
        let mut of_node: HashMap<Place<D>, usize> = HashMap::new();
        for (cube, place) in cubes.places().iter().enumerate() {
            let pencil = pencil_of.get(&component[cube]).copied().unwrap_or(0);
            for at in 0..3_usize.pow(D as u32) {
                let node =
                    std::array::from_fn(|i| 2 * place[i] + (at / 3_usize.pow(i as u32) % 3) as i32);
                of_node.insert(node, pencil);
            }
        }
        nodes.iter().map(|node| of_node.get(node).copied().unwrap_or(0)).collect()
    }

    /// Returns the pencil of each component through which a geodesic runs; `None` if two run through one.
    fn pencil_of(&self, cubes: &Cubes<D>, component: &[usize]) -> Option<HashMap<usize, usize>> {
        let mut pencil_of = HashMap::new();
        for (n, (geodesic, _)) in self.pencils.iter().enumerate() {
            let x = geodesic.middle();
            let place = std::array::from_fn(|i| (x[i] / cubes.side()).floor() as i32);
            if let Ok(cube) = cubes.places().binary_search(&place)
                && pencil_of.insert(component[cube], n).is_some()
            {
                return None;
            }
        }
        Some(pencil_of)
    }

    /// Returns the values from which the distance from a set spreads over the nodes, and infinity at
    /// all other nodes.
    pub(crate) fn seeds(&self, nodes: &Nodes<D>, side: usize, source: Source) -> Vec<f64> {
        let points = nodes.points();
        let band = BAND * nodes.spacing();
        let set = &self.sets[side];
        let is_point = matches!(set, Shape::Point(_));
        if source == Source::March || !is_point {
            let value = |k: usize| seed(self.formula, set, band, &points[k]);
            return in_parallel(points.len(), &|k| value(k).unwrap_or(f64::INFINITY));
        }
        // Everything behind a front a little beyond the point.
        let end = if side == 0 { self.curve[0] } else { self.curve[self.curve.len() - 1] };
        let reach = REACH * self.euclidean();
        let front = band * gram(self.formula, &end).trace().sqrt();
        let mut seeds = vec![f64::INFINITY; points.len()];
        for (geodesic, pencil) in &self.pencils {
            let is_behind = |x: &SVector<f64, D>| {
                (x - end).norm() <= reach && pencil.fans[side].value_near(x) <= front
            };
            let are_behind = in_parallel(points.len(), &|k| is_behind(&points[k]));
            let behind = points.iter().zip(&are_behind).filter(|&(_, &is_behind)| is_behind);
            let behind: Vec<SVector<f64, D>> = behind.map(|(x, _)| *x).collect();
            let rays = pencil.covering(side, rings(D), &behind, (2.0 * front, SHORT));
            let wide = Fan::new(self.formula, &self.sets[side], geodesic, side, &rays);
            let fan = wide.as_ref().unwrap_or(&pencil.fans[side]);
            let value = |k: usize| {
                if are_behind[k] { fan.value(&points[k]) } else { f64::INFINITY }
            };
            let values = in_parallel(points.len(), &value);
            for (seed, value) in seeds.iter_mut().zip(values) {
                // Without a value a node is no seed.
                if value < *seed {
                    *seed = value;
                }
            }
        }
        seeds
    }

    /// Returns the Euclidean length of the curve.
    pub(crate) fn euclidean(&self) -> f64 {
        self.curve.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
    }
}

/// Returns the least of some values; NaN if one of them is.
fn least(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(
        f64::INFINITY,
        |least, value| {
            if least.is_nan() || value >= least { least } else { value }
        },
    )
}

/// Returns the number of the component of each cube. Cubes that share a corner are in one.
fn components<const D: usize>(cubes: &Cubes<D>) -> Vec<usize> {
    let places = cubes.places();
    let mut component = vec![usize::MAX; places.len()];
    for start in 0..places.len() {
        if component[start] != usize::MAX {
            continue;
        }
        component[start] = start;
        let mut left = vec![start];
        while let Some(cube) = left.pop() {
            for at in 0..3_usize.pow(D as u32) {
                let beside: Place<D> = std::array::from_fn(|i| {
                    places[cube][i] + (at / 3_usize.pow(i as u32) % 3) as i32 - 1
                });
                if let Ok(other) = places.binary_search(&beside)
                    && component[other] == usize::MAX
                {
                    component[other] = start;
                    left.push(other);
                }
            }
        }
    }
    component
}

/// Returns the cubes within `by` cubes of these, along the axes.
pub(crate) fn dilated<const D: usize>(
    cubes: &Cubes<D>,
    by: i32,
) -> Result<Cubes<D>, DistanceError> {
    let mut cubes = cubes.clone();
    for axis in 0..D {
        let moved = cubes.places().iter().flat_map(|place| {
            (-by..=by).map(move |step| {
                let mut place = *place;
                place[axis] += step;
                place
            })
        });
        cubes = Cubes::new(cubes.exponent(), moved.collect()).map_err(DistanceError::Refused)?;
    }
    Ok(cubes)
}
