//! `Fan`: the distance from a set near a geodesic, from several rays.
//!
//! The rays start at one point behind an end point, or across a front that touches the boundary of a
//! set. Near each ray the distance is known up to the third order; between rays these values are averaged
//! with smooth weights. More rays make it accurate farther from the geodesic.
//!
//! A ray is named by its coordinates: by how much it starts beside the geodesic, along each of `D − 1`
//! tangents. A point has the coordinates of the ray through it, up to the second order in its distance
//! from the geodesic.

use std::collections::BTreeSet;

use nalgebra::{SMatrix, SVector};
use tautline_check::in_parallel;
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

/// How far from a ray, in steps of the lattice of rays, its values count.
const SUPPORT: f64 = 1.6;

/// How far apart points may be of which one foot is sought near the other: so many samples, or this part
/// of the ray.
const WALK: (f64, f64) = (24.0, 0.06);

/// Coordinates of a ray or a point, or steps of a lattice of rays. The last one is 0.
type Coordinates<const D: usize> = SVector<f64, D>;

/// Rays, the first of which is the geodesic.
#[derive(Clone, Debug)]
pub(crate) struct Fan<const D: usize> {
    rays: Vec<(Coordinates<D>, Calibration<D>)>,
    /// For each sample, what maps the way from the geodesic to a point to the point's coordinates, in steps
    /// of the lattice.
    charts: Vec<SMatrix<f64, D, D>>,
    spacing: Coordinates<D>,
}

/// Which rays a fan has.
#[derive(Clone, Debug)]
pub(crate) struct Rays<const D: usize> {
    /// The rays beside the geodesic, in steps of a lattice.
    pub(crate) lattice: Vec<Coordinates<D>>,
    /// How long these steps are.
    pub(crate) spacing: Coordinates<D>,
    /// Where the rays from a point meet: so far behind it, relative to the length of the geodesic.
    /// Fronts that leave a small ball or a corner are no more curved than this.
    pub(crate) focus: f64,
    /// How far the rays run from the set, in `m`, and in how many steps.
    pub(crate) reach: f64,
    pub(crate) steps: usize,
}

impl<const D: usize> Rays<D> {
    /// Returns the rays next to the geodesic.
    fn beside(focus: f64, reach: f64, steps: usize) -> Self {
        let lattice = neighbours().collect();
        Self { lattice, spacing: SVector::repeat(PROBE), focus, reach, steps }
    }
}

/// Returns the steps to the next rays along each tangent.
fn neighbours<const D: usize>() -> impl Iterator<Item = Coordinates<D>> {
    let step = |k: usize, by: f64| SVector::from_fn(|i, _| if i == k { by } else { 0.0 });
    (0..D - 1).flat_map(move |k| [step(k, 1.0), step(k, -1.0)])
}

/// Where rays start.
struct Launch<const D: usize> {
    /// The end of the geodesic, and the momentum there.
    x: SVector<f64, D>,
    p: SVector<f64, D>,
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
        Shape::AxisBox(_) => End::Box,
        Shape::Union(_) => {
            let pieces = set.pieces().into_iter();
            let nearest = pieces.min_by(|a, b| distance(a, x).total_cmp(&distance(b, x)));
            nearest.map_or(End::Flat, |piece| kind(piece, x))
        }
        _ => End::Flat,
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
        &Rays { ref lattice, spacing, focus, reach, steps }: &Rays<D>,
    ) -> Option<Self> {
        let (x, _) = geodesic.behind(formula, end, 0.0)?;
        let kind = kind(set, &x);
        let behind = if matches!(kind, End::Point) { focus * geodesic.length() } else { 0.0 };
        let (x, p) = geodesic.behind(formula, end, behind)?;
        let p = -p;
        let velocity = Hamiltonian::at(formula, &x, &p)?.velocity;
        // The velocity belongs to this momentum, whose length in the dual norm need not be 1.
        let speed = velocity.norm() / p.dot(&velocity).sqrt();
        let bend = kind.bend(&x, &p, focus * geodesic.length() * speed);
        let launch = Launch { x, p, bend };
        let step = (behind + reach) / steps as f64;
        let tangents = match kind {
            End::Point => across(&velocity),
            _ => across(&p),
        };
        let ray = |at: &Coordinates<D>| {
            let offset = tangents
                .iter()
                .zip(at.component_mul(&spacing).iter())
                .fold(SVector::zeros(), |sum, (t, &by)| sum + t * by);
            match kind {
                End::Point => launch.ray_from_point(formula, &offset, (step, steps), behind),
                _ => launch.ray_from_boundary(formula, &offset, (step, steps)),
            }
        };
        // Without the geodesic there is no fan; without another ray there is a gap.
        let mut rays = vec![(SVector::zeros(), ray(&SVector::zeros())?)];
        let others = in_parallel(lattice.len(), &|k| ray(&lattice[k]));
        rays.extend(lattice.iter().zip(others).filter_map(|(at, ray)| Some((*at, ray?))));
        let charts = charts(&rays, steps)?;
        Some(Self { rays, charts, spacing })
    }

    /// Returns the ray that is the geodesic.
    fn axis(&self) -> &Calibration<D> {
        &self.rays[0].1
    }

    /// Returns about the distance of `x` from the set.
    pub(crate) fn value(&self, x: &SVector<f64, D>) -> f64 {
        self.value_at(x, self.axis().foot(x))
    }

    /// Returns the same, given the foot of `x` on the geodesic.
    fn value_at(&self, x: &SVector<f64, D>, foot: f64) -> f64 {
        let at = self.lattice(x, foot);
        let (mut sum, mut weights) = (0.0, 0.0);
        let (mut nearest, mut least) = (0, f64::INFINITY);
        for (n, (place, ray)) in self.rays.iter().enumerate() {
            let square = (place - at).norm_squared();
            if square < least {
                (nearest, least) = (n, square);
            }
            if square < SUPPORT * SUPPORT {
                let weight = (1.0 - square / (SUPPORT * SUPPORT)).powi(2);
                sum += weight * ray.value(x, ray.foot_near(x, foot));
                weights += weight;
            }
        }
        if weights > 0.0 {
            sum / weights
        } else {
            let ray = &self.rays[nearest].1;
            ray.value(x, ray.foot_near(x, foot))
        }
    }

    /// Returns the value from the geodesic alone, which is enough very near it.
    pub(crate) fn value_near(&self, x: &SVector<f64, D>) -> f64 {
        self.axis().value(x, self.axis().foot(x))
    }

    /// Returns the values of points of which each is near the one before, which is faster.
    pub(crate) fn walk(&self) -> impl FnMut(&SVector<f64, D>) -> f64 {
        let mut feet = self.feet();
        move |x| self.value_at(x, feet(x))
    }

    /// Returns the values from the geodesic alone of such points.
    pub(crate) fn walk_near(&self) -> impl FnMut(&SVector<f64, D>) -> f64 {
        let mut feet = self.feet();
        move |x| self.axis().value(x, feet(x))
    }

    /// Returns the feet on the geodesic of such points.
    fn feet(&self) -> impl FnMut(&SVector<f64, D>) -> f64 {
        let ray = self.axis();
        let stride = WALK.0.min(WALK.1 * self.charts.len() as f64);
        let stride = stride * (ray.place(1) - ray.place(0)).norm();
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
            foot
        }
    }

    /// Returns the coordinates of `x`.
    pub(crate) fn coordinates(&self, x: &SVector<f64, D>) -> Coordinates<D> {
        self.lattice(x, self.axis().foot(x)).component_mul(&self.spacing)
    }

    /// Returns the coordinates of `x` in steps of the lattice, given its foot on the geodesic.
    fn lattice(&self, x: &SVector<f64, D>, foot: f64) -> Coordinates<D> {
        let sample = (foot.round().max(0.0) as usize).min(self.charts.len() - 1);
        let mut at = self.charts[sample] * (x - self.axis().place(sample));
        // Along the geodesic.
        at[D - 1] = 0.0;
        at
    }

    /// Returns the second derivatives of the distance at this arc length from the set.
    fn curvature(&self, s: f64) -> SMatrix<f64, D, D> {
        self.axis().curvature(s)
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

/// By how much longer the steps along the rays of a wide fan are: between them the error of a value is
/// larger.
const WIDE: usize = 6;

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
            let rays = Rays::beside(focus, reach, steps);
            let fan = |end: usize| Fan::new(formula, &sets[end], geodesic, end, &rays);
            Some(Self { fans: [fan(0)?, fan(1)?], focus })
        };
        (0..7).filter_map(with).find(|pencil| pencil.is_convex(geodesic.length()))
    }

    /// Returns a fan at one end whose rays cover these points, with `rings` of them on each side of the
    /// geodesic along each tangent. They run as far as this pencil.
    pub(crate) fn wide(
        &self,
        (formula, set): (&Formula<D>, &Shape<D>),
        geodesic: &Geodesic<D>,
        end: usize,
        rings: i32,
        points: &[SVector<f64, D>],
    ) -> Option<Fan<D>> {
        let reach = (1.0 + OVERHANG) * geodesic.length();
        let steps = self.fans[end].charts.len() / WIDE;
        Fan::new(formula, set, geodesic, end, &self.covering(end, rings, points, (reach, steps)))
    }

    /// Returns the rays of a fan at one end that cover these points, with `rings` of them on each side of
    /// the geodesic along each tangent.
    pub(crate) fn covering(
        &self,
        end: usize,
        rings: i32,
        points: &[SVector<f64, D>],
        (reach, steps): (f64, usize),
    ) -> Rays<D> {
        let mut of_points = in_parallel(points.len(), &|k| self.fans[end].coordinates(&points[k]));
        of_points.retain(|at| at.iter().all(|c| c.is_finite()));
        let largest = of_points.iter().fold(SVector::repeat(0.0), |most: Coordinates<D>, at| {
            most.zip_map(at, |most, c| most.max(c.abs()))
        });
        let spacing = largest.map(|most| (most / f64::from(rings)).max(PROBE));
        let near: BTreeSet<[i32; D]> =
            of_points.iter().flat_map(|at| supporting(&at.component_div(&spacing))).collect();
        let lattice = near.into_iter().map(|at| SVector::from(at.map(f64::from)));
        let beside = |at: &Coordinates<D>| at.norm_squared() > 1.0;
        let lattice = neighbours().chain(lattice.filter(beside)).collect();
        Rays { lattice, spacing, focus: self.focus, reach, steps }
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

    /// Returns the ray that leaves the front `n·y + ½ yᵀB y = 0`, `y = x − x₀`, about in the direction
    /// `n + B offset`.
    fn ray_from_boundary(
        &self,
        formula: &Formula<D>,
        offset: &SVector<f64, D>,
        (step, steps): (f64, usize),
    ) -> Option<Calibration<D>> {
        let (n, b) = (self.p.normalize(), self.bend);
        // On a sphere, s offset + t n with s = 1/√(1 + |B offset|²) has this normal, so that rays leave
        // less than a quarter of the sphere on each side.
        let offset = offset / (1.0 + (b * offset).norm_squared()).sqrt();
        // The root t near 0 of ½ a t² + c t + e = 0, where s offset + t n is on the front.
        let a = n.dot(&(b * n));
        let c = 1.0 + n.dot(&(b * offset));
        let e = 0.5 * offset.dot(&(b * offset));
        let root = (c * c - 2.0 * a * e).sqrt();
        let away = offset - n * (2.0 * e / (c + root));
        let normal = n + b * away;
        let slope = normal.norm();
        if !(slope > 0.0) {
            return None;
        }
        // The front is a level of a function with the gradient n + B y and the second derivatives B; with
        // the gradient p it has these.
        let bend = |_: &SMatrix<f64, D, D>, p: &SVector<f64, D>| b * (p.norm() / slope);
        Calibration::integrate(formula, (self.x + away, normal), bend, 0.0, step, steps)
    }
}

/// Returns for each sample what maps the way from the geodesic to a point to the point's coordinates, in
/// steps of the lattice; `None` if a ray next to the geodesic is missing or meets it.
fn charts<const D: usize>(
    rays: &[(Coordinates<D>, Calibration<D>)],
    steps: usize,
) -> Option<Vec<SMatrix<f64, D, D>>> {
    let beside = neighbours::<D>().map(|at| Some(&rays.iter().find(|(place, _)| *place == at)?.1));
    let beside: Vec<&Calibration<D>> = beside.collect::<Option<_>>()?;
    let of_sample = |sample: usize| {
        let velocity = rays[0].1.velocity(sample);
        let columns: [SVector<f64, D>; D] = std::array::from_fn(|k| match beside.get(2 * k + 1) {
            Some(other) => (beside[2 * k].place(sample) - other.place(sample)) * 0.5,
            None => *velocity,
        });
        SMatrix::from_columns(&columns).try_inverse()
    };
    (0..=steps).map(of_sample).collect()
}

/// Returns the places of the lattice whose rays count at these coordinates.
fn supporting<const D: usize>(at: &Coordinates<D>) -> Vec<[i32; D]> {
    let mut found = vec![[0; D]];
    for k in 0..D - 1 {
        let (low, high) = ((at[k] - SUPPORT).ceil() as i32, (at[k] + SUPPORT).floor() as i32);
        let along = |place: [i32; D]| {
            (low..=high).map(move |c| std::array::from_fn(|i| if i == k { c } else { place[i] }))
        };
        found = found.into_iter().flat_map(along).collect();
    }
    let square = |place: &[i32; D]| (SVector::from(place.map(f64::from)) - at).norm_squared();
    found.retain(|place| square(place) < SUPPORT * SUPPORT);
    found
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

#[cfg(test)]
mod tests;
