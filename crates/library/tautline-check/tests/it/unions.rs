//! Random unions of points, balls, boxes and half-spaces on a flat space, where the distance is known:
//! with values of any kind nothing false is proved, and in other units the same.

use nalgebra::SVector;
use tautline_chance::{Random, cases, seed};
use tautline_check::{Certificate, CheckError, Level, Region};
use tautline_formula::Formula;
use tautline_sets::{AxisBox, Ball, ClosedSet, HalfSpace, Point, Shape};

use crate::helpers::{keeps, on_cubes, point, points, proves_at_most};

fn piece<const D: usize>(random: &mut Random, unbounded: bool) -> Shape<D> {
    // Small and near, so that several of them meet one simplex.
    let mut vector = |size: f64| SVector::<f64, D>::from_fn(|_, _| random.between(-size, size));
    let (x, y) = (vector(1.2), vector(0.4));
    match (random.unit() * if unbounded { 4.0 } else { 3.0 }) as usize {
        0 => Shape::Point(Point::new(x).expect("finite")),
        1 => Shape::Ball(Ball::new(x, random.between(0.0, 0.4)).expect("a ball")),
        2 => Shape::AxisBox(AxisBox::from_corners(x - y.abs(), x + y.abs()).expect("a box")),
        // The origin is at the distance 1 to 2.
        _ => {
            let offset = -random.between(1.0, 2.0) * x.norm();
            Shape::HalfSpace(HalfSpace::new(x, offset).expect("a normal"))
        }
    }
}

fn union<const D: usize>(random: &mut Random, unbounded: bool) -> Shape<D> {
    let count = 1 + (random.unit() * 4.0) as usize;
    Shape::Union((0..count).map(|_| piece(random, unbounded)).collect())
}

/// Returns the point of a piece that is nearest to `x`, up to rounding.
fn project<const D: usize>(piece: &Shape<D>, x: &SVector<f64, D>) -> SVector<f64, D> {
    match piece {
        Shape::Point(set) => set.project(x),
        Shape::Ball(set) => set.project(x),
        Shape::AxisBox(set) => set.project(x),
        Shape::HalfSpace(set) => set.project(x),
        other => unreachable!("{} is no piece", other.name()),
    }
}

/// Returns the nearest points of two unions: by projections in turn, which converge for convex pieces.
fn nearest<const D: usize>(sets: [&Shape<D>; 2]) -> [SVector<f64, D>; 2] {
    let pairs = sets[0].pieces().into_iter().flat_map(|a| {
        sets[1].pieces().into_iter().map(move |b| {
            let mut ends = [SVector::zeros(); 2];
            for _ in 0..2000 {
                ends[0] = project(a, &ends[1]);
                ends[1] = project(b, &ends[0]);
            }
            ends
        })
    });
    let length = |ends: &[SVector<f64, D>; 2]| (ends[1] - ends[0]).norm();
    pairs.min_by(|a, b| length(a).total_cmp(&length(b))).expect("pieces")
}

/// A problem on a flat space with a random level.
struct Drawn<const D: usize> {
    certificate: Certificate<D>,
    d: f64,
    line: Vec<SVector<f64, D>>,
}

fn flat<const D: usize>(h: f64) -> Formula<D> {
    Formula::parse("h I", &[("h", h)]).expect("a formula")
}

fn drawn<const D: usize>(random: &mut Random) -> Option<Drawn<D>> {
    // One of the sets may be unbounded.
    let unbounded = (random.unit() * 3.0) as usize;
    let sets = [0, 1].map(|set| union::<D>(random, unbounded == set));
    let ends = nearest(sets.each_ref());
    let d = (ends[1] - ends[0]).norm();
    if d < 0.05 {
        return None;
    }
    let hi = d * (1.0 + 10.0_f64.powf(random.between(-6.0, -0.5)));
    let region = Region::Declared { c1: 1.0 };
    let exponent = -((random.unit() * 3.0) as i32);
    let cubes = region.required(sets.each_ref(), hi, exponent).expect("a bounded set");
    let at = points(&cubes);
    let mut direction = SVector::<f64, D>::from_fn(|_, _| random.between(-1.0, 1.0));
    if random.unit() < 0.5 {
        direction = ends[1] - ends[0];
    }
    direction /= direction.norm();
    let kind = (random.unit() * 4.0) as usize;
    let noise = [0.0, 1e-3, 0.3][(random.unit() * 3.0) as usize];
    let values = [0, 1].map(|set| {
        let away = |x: &SVector<f64, D>| {
            let to = |piece: &Shape<D>| (project(piece, x) - x).norm();
            sets[set].pieces().into_iter().map(to).fold(f64::INFINITY, f64::min)
        };
        let sign = [1.0, -1.0][set];
        let value = |x: &SVector<f64, D>| match kind {
            // Linear functions lose only roundings.
            0 | 1 => sign * direction.dot(x),
            2 => away(x),
            _ => random.between(-1.0, 1.0),
        };
        let values: Vec<f64> = at.iter().map(value).collect();
        values.into_iter().map(|v| v + noise * random.between(-d, d)).collect()
    });
    let levels = vec![Level::new(0, cubes, values).expect("finite")];
    let line = (0..=20).map(|n| ends[0].lerp(&ends[1], f64::from(n) / 20.0)).collect();
    let certificate = Certificate { formula: flat(1.0), sets, hi, region, curve: None, levels };
    Some(Drawn { certificate, d, line })
}

fn nothing_false_is_proved<const D: usize>(fixed: u64, count: u32, at_least: f64) {
    let mut random = Random(seed(fixed));
    let (mut drawn, mut best) = (0.0, 0.0);
    for _ in 0..cases(count) {
        let Some(Drawn { certificate, d, line }) = self::drawn::<D>(&mut random) else { continue };
        let proved = certificate.check().expect("all cubes are there");
        // The nearest points are found up to the convergence of projections.
        assert!(proved.lower <= d * (1.0 + 1e-9), "{} > {d}: {certificate}", proved.lower);
        assert!(keeps(&proved, &line), "{certificate}");
        drawn += 1.0;
        best += f64::from(proved.lower > 0.9 * d);
    }
    // Values that prove nothing would show nothing.
    assert!(best >= at_least * drawn, "{best} of {drawn}");
}

#[test]
fn random_unions_prove_nothing_false_on_the_line() {
    nothing_false_is_proved::<1>(71, 600, 0.08);
}

#[test]
fn random_unions_prove_nothing_false_in_the_plane() {
    nothing_false_is_proved::<2>(72, 300, 0.02);
}

#[test]
fn random_unions_prove_nothing_false_in_space() {
    nothing_false_is_proved::<3>(73, 30, 0.0);
}

/// Returns the same problem with `H`, lengths, values and normals in other units.
fn scaled<const D: usize>(
    certificate: &Certificate<D>,
    factor: f64,
    normals: f64,
) -> Certificate<D> {
    let mut scaled = certificate.clone();
    scaled.formula = flat(factor * factor);
    scaled.hi *= factor;
    scaled.region = Region::Declared { c1: factor * factor };
    for level in &mut scaled.levels {
        let values = level.values().clone().map(|v| v.iter().map(|v| v * factor).collect());
        *level = Level::new(0, level.cubes().clone(), values).expect("finite");
    }
    for set in &mut scaled.sets {
        let piece = |piece: &Shape<D>| match piece {
            Shape::HalfSpace(wall) => {
                let (normal, offset) = wall.given();
                let wall = HalfSpace::new(normal * normals, offset * normals);
                Shape::HalfSpace(wall.expect("a normal"))
            }
            piece => piece.clone(),
        };
        *set = Shape::Union(set.pieces().into_iter().map(piece).collect());
    }
    scaled
}

/// Powers of two round nothing, also as normals. A hundred rounds the normal and the values.
#[test]
fn in_other_units_the_same_is_proved() {
    let mut random = Random(seed(74));
    let mut compared = 0;
    for _ in 0..cases(60) {
        let Some(drawn) = drawn::<2>(&mut random) else { continue };
        let mut certificate = drawn.certificate;
        let mut ends = [drawn.line[0], drawn.line[20]];
        // Ends may miss their sets by a rounding.
        for (set, end) in certificate.sets.iter_mut().zip(&mut ends) {
            let spot = Shape::Point(Point::new(*end).expect("finite"));
            *set = Shape::Union(vec![set.clone(), spot]);
        }
        certificate.curve = Some(ends.to_vec());
        let base = certificate.check().expect("all cubes are there");
        for (factor, normals) in [(8.0, 1.0), (1.0, 4.0), (0.25, 0.125)] {
            let proved = scaled(&certificate, factor, normals).check().expect("the same cubes");
            assert_eq!(proved.lower, factor * base.lower);
            assert_eq!(proved.upper, base.upper.map(|upper| factor * upper));
            assert_eq!(proved.corridor, base.corridor);
            assert_eq!(proved.gap(), base.gap());
        }
        let proved = scaled(&certificate, 100.0, 100.0).check().expect("the same cubes");
        // Values and walls are rounded, and with them which bin a value is in.
        let ratio = |a: f64, b: f64| (a - 100.0 * b).abs() <= 1e-9 * 100.0 * drawn.d;
        assert!(ratio(proved.lower, base.lower), "{} {}", proved.lower, base.lower);
        assert!(ratio(proved.upper.expect("a curve"), base.upper.expect("a curve")));
        compared += 1;
    }
    assert!(compared > 20, "{compared}");
}

/// A ball with a half-space is unbounded, whichever stands first.
#[test]
fn a_union_is_bounded_if_all_its_pieces_are() {
    let wall = || Shape::HalfSpace(HalfSpace::at_least([1.0, 0.0], 2.0).expect("a normal"));
    let ball = || Shape::Ball(Ball::new([-9.0, 0.0], 0.5).expect("a ball"));
    let to = point([0.0, 0.0]);
    let formula = flat::<2>(1.5625);
    for pieces in [vec![ball(), wall()], vec![wall(), ball()]] {
        let union = Shape::Union(pieces);
        let hi = 3.0;
        // One tube, about the point, has to be as wide as the curves are long.
        let tubes = |radius| Region::Tubes { radius, c1: 1.0 }.prove(&formula, [&union, &to], hi);
        assert_eq!(tubes(hi), Ok(()));
        assert!(matches!(tubes(0.6 * hi), Err(CheckError::Tubes { .. })), "{:?}", tubes(0.6 * hi));
        for sets in [[&union, &to], [&to, &union]] {
            let cubes = Region::Declared { c1: 1.5625 }.required(sets, hi, -1).expect("a point");
            assert!((-1..4).all(|k| cubes.contains(&[k, 0])), "{:?}", cubes.places());
        }
        let both = [&union, &union];
        let cubes = Region::Declared { c1: 1.0 }.required(both, hi, -1);
        assert_eq!(cubes, Err(CheckError::Unbounded));
        for region in [Region::ExitOne, Region::ExitTwo] {
            assert_eq!(region.required([&union, &to], hi, -1), Err(CheckError::Unbounded));
        }
        let zero = [&|_: &SVector<f64, 2>| 0.0; 2];
        let sets = [union, to.clone()];
        let found = on_cubes("1 I", sets, hi, Region::ExitOne, 0, &[[-9, 0]], zero.map(|f| f as _));
        proves_at_most(&found, 2.0);
    }
}
