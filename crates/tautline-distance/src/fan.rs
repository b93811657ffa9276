//! `Fan`: the distance from a set near a geodesic, from several rays.
//!
//! The rays start at one point behind an end point, or across the boundary of a set. Near each ray the
//! distance is known up to the third order; between rays these values are averaged with smooth
//! weights. More rays make it accurate farther from the geodesic.

use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    calibration::{Calibration, shoot},
    geodesic::Geodesic,
    hamiltonian::{Hamiltonian, eigenvalues},
    seed::distance,
};

/// How far the rays are continued behind the other end, relative to the length of the geodesic.
pub(crate) const OVERHANG: f64 = 0.1;

/// The support of the weight of a ray, in distances between rays.
const SUPPORT: f64 = 1.6;

/// How many samples apart points may be of which one foot is sought near the other.
const WALK: f64 = 24.0;

/// Rays, the first of which is the geodesic.
#[derive(Clone, Debug)]
pub(crate) struct Fan<const D: usize> {
    rays: Vec<Calibration<D>>,
    /// For each sample, the distance between neighbouring rays.
    gaps: Vec<f64>,
    /// The offset of the rays next to the geodesic.
    spacing: f64,
}

/// Which rays a fan has.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rays {
    /// The rings of rays around the geodesic, and how far apart they start.
    pub(crate) rings: i32,
    pub(crate) spacing: f64,
    /// Where the rays from a point meet: so far behind it, relative to the length of the geodesic.
    /// Fronts that leave a small ball or a corner are no more curved than this.
    pub(crate) focus: f64,
    /// How far the rays run from the set, in `m`, and in how many steps.
    pub(crate) reach: f64,
    pub(crate) steps: usize,
}

/// Where rays start.
struct Launch<const D: usize> {
    /// The end of the geodesic, and the momentum there.
    x: SVector<f64, D>,
    p: SVector<f64, D>,
    /// The centre of a ball; `None` for another boundary.
    centre: Option<SVector<f64, D>>,
    /// How curved the front is that leaves the boundary: the second derivatives of a function whose
    /// gradient has length 1.
    bend: SMatrix<f64, D, D>,
}

/// The kind of an end.
enum End<const D: usize> {
    Point,
    Flat,
    Box,
    Ball(SVector<f64, D>),
}

/// The least part of the momentum along an axis that counts as away from a side of a box.
const AWAY: f64 = 0.1;

impl<const D: usize> End<D> {
    /// Returns how curved a front may be that leaves the end at `x` with the momentum `p`: it touches
    /// the set from outside, and its radii are at least `radius`. A front that is less curved than the
    /// distance costs nothing at the set, and is smooth where the distance is not.
    ///
    /// From an edge or a corner of a box it may be curved across those sides that hold the end there.
    /// Nearby, the part of the momentum across a side outweighs the curvature.
    fn bend(&self, x: &SVector<f64, D>, p: &SVector<f64, D>, radius: f64) -> SMatrix<f64, D, D> {
        match self {
            End::Point | End::Flat => SMatrix::zeros(),
            End::Box => SMatrix::from_fn(|i, j| {
                if i == j && p[i].abs() > AWAY * p.norm() { 1.0 / radius } else { 0.0 }
            }),
            End::Ball(centre) => SMatrix::identity() / (x - centre).norm().max(radius),
        }
    }
}

fn kind<const D: usize>(set: &Shape<D>, x: &SVector<f64, D>) -> End<D> {
    match set {
        Shape::Point(_) => End::Point,
        Shape::Ball(ball) if ball.r() == 0.0 => End::Point,
        Shape::Ball(ball) => End::Ball(*ball.centre()),
        Shape::HalfSpace(_) => End::Flat,
        Shape::AxisBox(_) => End::Box,
        Shape::Union(_) => {
            let pieces = set.pieces().into_iter();
            let nearest = pieces.min_by(|a, b| distance(a, x).total_cmp(&distance(b, x)));
            nearest.map_or(End::Flat, |piece| kind(piece, x))
        }
    }
}

impl<const D: usize> Fan<D> {
    /// Returns the rays from one end of a geodesic. Returns `None` if the geodesic cannot be continued
    /// or focuses on the way.
    pub(crate) fn new(
        formula: &Formula<D>,
        set: &Shape<D>,
        geodesic: &Geodesic<D>,
        end: usize,
        Rays { rings, spacing, focus, reach, steps }: Rays,
    ) -> Option<Self> {
        let (x, _) = geodesic.behind(formula, end, 0.0)?;
        let kind = kind(set, &x);
        let behind = if matches!(kind, End::Point) { focus * geodesic.length() } else { 0.0 };
        let (x, p) = geodesic.behind(formula, end, behind)?;
        let p = -p;
        let centre = match kind {
            End::Ball(centre) => Some(centre),
            _ => None,
        };
        let velocity = Hamiltonian::at(formula, &x, &p)?.velocity;
        // The velocity belongs to this momentum, whose length in the dual norm need not be 1.
        let speed = velocity.norm() / p.dot(&velocity).sqrt();
        let bend = kind.bend(&x, &p, focus * geodesic.length() * speed);
        let launch = Launch { x, p, centre, bend };
        let step = (behind + reach) / steps as f64;
        let tangents = match kind {
            End::Point => across(&velocity),
            _ => across(&p),
        };
        let offsets = offsets(D - 1, rings);
        let rays: Vec<Option<Calibration<D>>> = offsets
            .par_iter()
            .map(|offset| {
                let offset = tangents
                    .iter()
                    .zip(offset)
                    .fold(SVector::zeros(), |sum, (t, &by)| sum + t * (by * spacing));
                match kind {
                    End::Point => launch.ray_from_point(formula, &offset, (step, steps), behind),
                    _ => launch.ray_from_boundary(formula, &offset, (step, steps)),
                }
            })
            .collect();
        let mut rays = rays.into_iter();
        // Without the geodesic there is no fan; without another ray there is a gap.
        let mut kept = vec![rays.next()??];
        kept.extend(rays.flatten());
        let gaps: Vec<f64> = (0..=steps)
            .map(|sample| {
                let to = |ray: &Calibration<D>| (ray.place(sample) - kept[0].place(sample)).norm();
                kept[1..].iter().take(2 * (D - 1)).map(to).fold(0.0, f64::max)
            })
            .collect();
        Some(Self { rays: kept, gaps, spacing })
    }

    /// Returns about the distance of `x` from the set.
    pub(crate) fn value(&self, x: &SVector<f64, D>) -> f64 {
        let foot = self.rays[0].foot(x);
        let sample = self.sample(foot);
        let support = (SUPPORT * self.gaps[sample]).powi(2);
        let (mut sum, mut weights) = (0.0, 0.0);
        let (mut nearest, mut least) = (0, f64::INFINITY);
        for (n, ray) in self.rays.iter().enumerate() {
            let square = (ray.place(sample) - x).norm_squared();
            if square < least {
                (nearest, least) = (n, square);
            }
            if square < support {
                let weight = (1.0 - square / support).powi(2);
                sum += weight * ray.value(x, ray.foot_near(x, foot));
                weights += weight;
            }
        }
        if weights > 0.0 {
            sum / weights
        } else {
            let ray = &self.rays[nearest];
            ray.value(x, ray.foot_near(x, foot))
        }
    }

    /// Returns the same from the geodesic alone, which is enough very near it.
    pub(crate) fn value_near(&self, x: &SVector<f64, D>) -> f64 {
        self.rays[0].value(x, self.rays[0].foot(x))
    }

    /// Returns the same for points of which each is near the one before, which is faster.
    pub(crate) fn walk(&self) -> impl FnMut(&SVector<f64, D>) -> f64 {
        let ray = &self.rays[0];
        let stride = WALK * (ray.place(1) - ray.place(0)).norm();
        let mut last: Option<(SVector<f64, D>, f64, f64)> = None;
        move |x| {
            let away = |foot: f64| (ray.point(foot) - x).norm();
            let near = last.and_then(|(before, foot, distance)| {
                let moved = (x - before).norm();
                let foot = (moved <= stride).then(|| ray.foot_near(x, foot))?;
                // Another part of the geodesic may be nearer.
                (away(foot) <= distance + moved).then_some(foot)
            });
            let foot = near.unwrap_or_else(|| ray.foot(x));
            last = Some((*x, foot, away(foot)));
            ray.value(x, foot)
        }
    }

    /// Returns how far `x` is from the geodesic, in offsets of rays where they start.
    pub(crate) fn offset(&self, x: &SVector<f64, D>) -> f64 {
        let sample = self.sample(self.rays[0].foot(x));
        (self.rays[0].place(sample) - x).norm() / self.gaps[sample] * self.spacing
    }

    /// Returns the sample nearest to this foot.
    fn sample(&self, foot: f64) -> usize {
        (foot.round().max(0.0) as usize).min(self.gaps.len() - 1)
    }

    /// Returns the second derivatives of the distance at this arc length from the set.
    fn curvature(&self, s: f64) -> SMatrix<f64, D, D> {
        self.rays[0].curvature(s)
    }
}

/// Two fans along one geodesic, from its two ends.
#[derive(Clone, Debug)]
pub(crate) struct Pencil<const D: usize> {
    pub(crate) fans: [Fan<D>; 2],
    focus: f64,
}

/// How far behind a point the rays meet at first.
const FOCUS: f64 = 0.25;

/// The offsets of the rays of a fan that is made to measure offsets.
const PROBE: f64 = 1e-3;

impl<const D: usize> Pencil<D> {
    /// Returns the fans along a geodesic from set to set, with `steps` steps along each ray. Returns
    /// `None` if there are none, for example because an end is conjugate to the other.
    pub(crate) fn along(
        formula: &Formula<D>,
        sets: &[Shape<D>; 2],
        geodesic: &Geodesic<D>,
        steps: usize,
    ) -> Option<Self> {
        let reach = (1.0 + OVERHANG) * geodesic.length();
        let with = |halvings: i32| {
            let focus = FOCUS * 0.5_f64.powi(halvings);
            let rays = Rays { rings: 1, spacing: PROBE, focus, reach, steps };
            let fan = |end: usize| Fan::new(formula, &sets[end], geodesic, end, rays);
            Some(Self { fans: [fan(0)?, fan(1)?], focus })
        };
        (0..7).filter_map(with).find(|pencil| pencil.is_convex(geodesic.length()))
    }

    /// Returns the rays of the fan at one end with `rings` rings that cover these points.
    pub(crate) fn covering(
        &self,
        end: usize,
        rings: i32,
        points: &[SVector<f64, D>],
        (reach, steps): (f64, usize),
    ) -> Rays {
        let offsets = points.par_iter().map(|x| self.fans[end].offset(x)).filter(|c| c.is_finite());
        let spacing = offsets.reduce(|| 0.0, f64::max) / f64::from(rings);
        Rays { rings, spacing, focus: self.focus, reach, steps }
    }

    /// Returns whether the sum of both distances has a strict minimum across the geodesic.
    fn is_convex(&self, length: f64) -> bool {
        (0..=20).all(|k| {
            let s = length * f64::from(k) / 20.0;
            let sum = self.fans[0].curvature(s) + self.fans[1].curvature(length - s);
            let mut eigenvalues = eigenvalues(&sum);
            // Along the geodesic the sum does not change.
            eigenvalues.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
            eigenvalues.iter().skip(1).all(|&eigenvalue| eigenvalue > 0.0)
        })
    }
}

impl<const D: usize> Launch<D> {
    /// Returns the ray from the point with another direction. Its first sample is a little way off,
    /// where `S` is about `1/s` across the ray.
    fn ray_from_point(
        &self,
        formula: &Formula<D>,
        offset: &SVector<f64, D>,
        (step, steps): (f64, usize),
        behind: f64,
    ) -> Option<Calibration<D>> {
        let near = 0.05 * behind;
        let p = self.p + offset;
        let (x, p) = shoot(formula, (self.x, p), near / 20.0, 20)?;
        Calibration::integrate(formula, (x, p), |h, _| h / near, near - behind, step, steps)
    }

    /// Returns the ray that leaves the boundary at another place.
    fn ray_from_boundary(
        &self,
        formula: &Formula<D>,
        offset: &SVector<f64, D>,
        (step, steps): (f64, usize),
    ) -> Option<Calibration<D>> {
        let x = self.x + offset;
        let (x, p) = match self.centre {
            None => (x, self.p),
            Some(centre) => {
                let r = (self.x - centre).norm();
                let normal = (x - centre).normalize();
                (centre + normal * r, normal)
            }
        };
        let bend = |_: &SMatrix<f64, D, D>, p: &SVector<f64, D>| self.bend * p.norm();
        Calibration::integrate(formula, (x, p), bend, 0.0, step, steps)
    }
}

/// Returns orthonormal vectors that are orthogonal to this one.
fn across<const D: usize>(vector: &SVector<f64, D>) -> Vec<SVector<f64, D>> {
    let mut found: Vec<SVector<f64, D>> = vec![vector.normalize()];
    for axis in 0..D {
        let mut unit = SVector::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 });
        for other in &found {
            unit -= other * other.dot(&unit);
        }
        if found.len() < D && unit.norm() > 0.3 {
            found.push(unit.normalize());
        }
    }
    found.split_off(1)
}

/// Returns points of a square lattice within `rings` of the origin, the origin first and then its
/// neighbours.
fn offsets(dimension: usize, rings: i32) -> Vec<Vec<f64>> {
    let width = (2 * rings + 1) as usize;
    let mut offsets: Vec<Vec<f64>> = (0..width.pow(dimension as u32))
        .map(|mut at| {
            (0..dimension)
                .map(|_| {
                    let step = (at % width) as f64 - f64::from(rings);
                    at /= width;
                    step
                })
                .collect()
        })
        .collect();
    let square = |offset: &Vec<f64>| offset.iter().map(|c| c * c).sum::<f64>();
    offsets.retain(|offset| square(offset) <= f64::from(rings * rings) + 0.5);
    offsets.sort_by(|a, b| square(a).total_cmp(&square(b)));
    offsets
}

#[cfg(test)]
mod tests;
