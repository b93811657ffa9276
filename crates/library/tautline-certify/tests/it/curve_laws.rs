//! Laws of the enclosures, for polygons under many metrics.

use std::sync::Arc;

use nalgebra::{SVector, vector};
use tautline_certify::Polygon;
use tautline_discretizations::{Interpolation, PointSequence, Rule};
use tautline_formula::{Formula, spline::Spline};
use tautline_metrics::{
    Metric,
    gallery::{
        Bump, CoupledCosines, EggCrate, GaussianFisher, Hill, Hyperbolic, RotatingAnisotropy,
        Shear, Sphere, TwoLinkArm, Valleys,
    },
};
use tautline_scalar::{Fast, Interval, Scalar, Table};

use crate::{parsed, reference::Random};

fn polygon<const D: usize>(random: &mut Random, n: usize, size: f64) -> PointSequence<D> {
    let point = |_| SVector::from_fn(|_, _| size * random.between(-1.0, 1.0));
    PointSequence::new((0..=n).map(point).collect()).expect("finite")
}

/// A check that runs for each metric, with a size for which the polygons lie in its domain.
trait Check {
    fn run<const D: usize>(&mut self, name: &str, metric: &impl Metric<D>, size: f64);
}

fn gallery(check: &mut impl Check) {
    check.run::<1>("valleys in one dimension", &Valleys, 3.0);
    check.run::<2>("valleys", &Valleys, 3.0);
    check.run::<2>("bump", &Bump::new(1.0, 0.5).expect("positive"), 2.0);
    check.run::<2>("egg crate", &EggCrate::new(0.5, 2.0).expect("positive"), 2.0);
    let rotating = RotatingAnisotropy::new([1.0, 4.0], [1.0, 2.0]).expect("positive");
    check.run::<2>("rotating", &rotating, 2.0);
    check.run::<2>("shear", &Shear::new(0.5, 1.0).expect("positive"), 3.0);
    check.run::<2>("arm", &TwoLinkArm::new(3.0, 1.0, 1.0).expect("definite"), 3.0);
    check.run::<2>("Fisher", &GaussianFisher, 1.5);
    check.run::<2>("hyperbolic", &Hyperbolic, 0.6);
    check.run::<3>("hill", &Hill::new(1.0, 0.5).expect("positive"), 1.5);
    check.run::<3>("sphere", &Sphere, 2.0);
    check.run::<3>("coupled cosines", &CoupledCosines, 3.0);
}

/// `L² ≤ E`; the enclosures agree with floating-point quadrature and with the rules to within the
/// errors of the latter; both kernels enclose the same numbers.
#[test]
fn energies_and_lengths_agree_with_floats_and_with_each_other() {
    struct Agree(Random);
    impl Check for Agree {
        fn run<const D: usize>(&mut self, name: &str, metric: &impl Metric<D>, size: f64) {
            for n in [1, 2, 8] {
                let sequence = polygon::<D>(&mut self.0, n, size);
                let polygon = Polygon::new(&sequence);
                let (energy, length) = polygon.energy_and_length(metric);
                assert_eq!((energy, length), (polygon.energy(metric), polygon.length(metric)));
                assert!(length.lo() > 0.0 && length.sqr().lo() <= energy.hi(), "{name}");
                let curve = Interpolation::new(&sequence);
                for (x, float) in [(energy, curve.energy(metric)), (length, curve.length(metric))] {
                    // The error estimate excludes the rounding of the integrand, which is about
                    // thirty roundings of numbers up to four times the result.
                    let error = float.error + 64.0 * f64::EPSILON * float.value;
                    let reach = x + Interval::new(-error, error).expect("ordered");
                    assert!(reach.contains(float.value), "{name}, {n}: {float:?} in {x:?}");
                    assert!(x.width() <= 1.01e-12 * x.lo(), "{name}, {n}: {x:?}");
                }
                let fast = polygon.with_kernel::<Fast>();
                let (e, l) = fast.energy_and_length(metric);
                assert!(energy.intersection(e.with_kernel()).is_some(), "{name}");
                assert!(length.intersection(l.with_kernel()).is_some(), "{name}");
                rule(name, Rule::TRAPEZOIDAL, metric, &sequence);
                rule(name, Rule::LEFT_ENDPOINT, metric, &sequence);
                rule(name, Rule::TRUE_TRAPEZOID, metric, &sequence);
            }
        }
    }
    fn rule<const D: usize>(
        name: &str,
        rule: Rule,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) {
        let energy = Polygon::new(sequence).discrete_energy(rule, metric);
        let float = rule.energy(metric, sequence);
        let error = 64.0 * f64::EPSILON * float;
        let reach = energy + Interval::new(-error, error).expect("ordered");
        assert!(reach.contains(float), "{name}, {rule}: {float} in {energy:?}");
        assert!(energy.width() <= 64.0 * f64::EPSILON * float, "{name}, {rule}: {energy:?}");
    }
    gallery(&mut Agree(Random(tautline_chance::seed(1))));
}

/// A smooth curve of 1000 chords. The measured relative widths range from `3 · 10⁻¹⁵` for the
/// coupled cosines, which vary slowest, to `3 · 10⁻¹³`. Chords are bisected until the width is
/// below `10⁻¹²`.
#[test]
fn a_thousand_chords_have_twelve_digits() {
    struct Narrow;
    impl Check for Narrow {
        fn run<const D: usize>(&mut self, name: &str, metric: &impl Metric<D>, size: f64) {
            let at = |k: usize| {
                let t = f64::from(k as u32) / 1000.0;
                SVector::from_fn(|i, _| size * (0.3 + t * (3.0 + i as f64)).sin())
            };
            let sequence = PointSequence::new((0..=1000).map(at).collect()).expect("finite");
            let (energy, length) = Polygon::new(&sequence).energy_and_length(metric);
            for x in [energy, length] {
                assert!(x.width() <= 1e-12 * x.lo(), "{name}: {:e}", x.width() / x.lo());
            }
            // The rules have no truncation error, only a few roundings per chord.
            let discrete = Polygon::new(&sequence).discrete_energy(Rule::TRAPEZOIDAL, metric);
            assert!(discrete.width() <= 1e-14 * discrete.lo(), "{name}");
        }
    }
    gallery(&mut Narrow);
}

/// If the ends are boxes, all polygons with ends in these boxes are enclosed.
#[test]
fn boxes_at_the_ends_represent_all_their_points() {
    let metric = EggCrate::new(0.5, 2.0).expect("positive");
    let mut random = Random(tautline_chance::seed(2));
    for _ in 0..20 {
        let sequence = polygon::<2>(&mut random, 3, 2.0);
        let near =
            |x: &SVector<f64, 2>| x.map(|c| Interval::new(c - 1e-3, c + 1e-3).expect("ordered"));
        let (first, last) = (near(sequence.first()), near(sequence.last()));
        let all = Polygon::new(&sequence).with_ends(first, last);
        assert_eq!((all.first(), all.last()), (first.as_slice(), last.as_slice()));
        let (energy, length) = all.energy_and_length(&metric);
        let discrete = all.discrete_energy(Rule::LEFT_ENDPOINT, &metric);
        for _ in 0..5 {
            let mut points = sequence.points().to_vec();
            for end in [0, 3] {
                points[end] += SVector::from_fn(|_, _| random.between(-1e-3, 1e-3));
            }
            let one = PointSequence::new(points).expect("finite");
            let one = Polygon::new(&one);
            assert!(energy.contains_interval(one.energy(&metric)));
            assert!(length.contains_interval(one.length(&metric)));
            assert!(discrete.contains_interval(one.discrete_energy(Rule::LEFT_ENDPOINT, &metric)));
        }
    }
}

/// In boxes that contain opposite chords, the terms of `uᵀ H u` cancel, but squares stay
/// nonnegative.
#[test]
fn no_energy_is_negative() {
    let metric = RotatingAnisotropy::new([1.0, 4.0], [1.0, 2.0]).expect("positive");
    let sequence = PointSequence::straight([0.0, 0.0], [1.0, 0.0], 1).expect("finite");
    let wide = Interval::new(-1.0, 1.0).expect("ordered");
    let polygon = Polygon::new(&sequence).with_ends(vector![wide, wide], vector![wide, wide]);
    let (energy, length) = polygon.energy_and_length(&metric);
    assert!(energy.lo() == 0.0 && length.lo() == 0.0, "{energy:?} {length:?}");
    assert_eq!(polygon.discrete_energy(Rule::TRAPEZOIDAL, &metric).lo(), 0.0);
}

#[test]
fn equal_points_have_energy_and_length_zero() {
    let zero = Interval::point(0.0);
    let constant = PointSequence::new(vec![vector![0.1, 0.2]; 4]).expect("finite");
    assert_eq!(Polygon::new(&constant).energy_and_length(&Valleys), (zero, zero));
    assert_eq!(Polygon::new(&constant).discrete_energy(Rule::TRAPEZOIDAL, &Valleys), zero);
    // A repeated point only changes N.
    let (a, b) = (vector![0.0, 0.0], vector![1.0, 0.5]);
    let twice = PointSequence::new(vec![a, a, b]).expect("finite");
    let once = PointSequence::new(vec![a, b]).expect("finite");
    let (energy, length) = Polygon::new(&twice).energy_and_length(&Valleys);
    let (e, l) = Polygon::new(&once).energy_and_length(&Valleys);
    assert_eq!((energy, length), (e * 2.0, l));
    // The squares of these steps underflow.
    let small = PointSequence::straight([0.0, 0.0], [1e-200, 0.0], 3).expect("finite");
    let (energy, length) = Polygon::new(&small).energy_and_length(&Valleys);
    assert!(energy.lo() >= 0.0 && energy.hi() < 1e-300);
    assert!(length.lo() >= 0.0 && length.contains(1e-200));
}

#[test]
fn a_metric_that_is_undefined_somewhere_has_no_finite_energy() {
    // A quadrature might not notice the pole at 0.
    let pole = parsed("x1^-2 I");
    let negative = parsed("-1 I");
    fn undefined<const D: usize>(metric: &impl Metric<D>, points: &[[f64; D]]) {
        let points = points.iter().map(|&x| SVector::from(x)).collect();
        let sequence = PointSequence::new(points).expect("finite");
        let (energy, length) = Polygon::new(&sequence).energy_and_length(metric);
        assert!(energy.is_undefined() && length.is_undefined(), "{energy:?} {length:?}");
    }
    undefined(&Hyperbolic, &[[0.0, 0.0], [0.75, 0.0], [0.75, 0.75]]);
    undefined(&Hyperbolic, &[[0.0, 0.0], [1.0, 0.0]]);
    undefined(&Hyperbolic, &[[2.0, 0.0], [2.0, 0.0]]);
    undefined(&pole, &[[-1.0], [2.0]]);
    undefined(&negative, &[[0.0], [1.0]]);
    let unit = PointSequence::straight([0.0], [1.0], 1).expect("finite");
    assert!(Polygon::new(&unit).discrete_energy(Rule::LEFT_ENDPOINT, &negative).is_undefined());
    let sequence = PointSequence::straight([0.0, 0.0], [1.0, 0.0], 1).expect("finite");
    let polygon = Polygon::new(&sequence);
    let interior = polygon.discrete_energy(Rule::TRAPEZOIDAL, &Hyperbolic);
    assert!(interior.is_finite() && interior.contains(64.0 / 9.0));
    assert!(polygon.discrete_energy(Rule::TRUE_TRAPEZOID, &Hyperbolic).is_undefined());
    // Some boxes are undefined.
    let nowhere = vector![Interval::UNDEFINED, Interval::point(0.0)];
    assert!(polygon.with_ends(nowhere, polygon.last()).energy(&Valleys).is_undefined());
    assert!(polygon.with_ends(polygon.first(), nowhere).length(&Valleys).is_undefined());
    // Close to the boundary, only parts of the chord are shown to be defined. The length is 4
    // artanh 0.99.
    let sequence = PointSequence::straight([-0.99, 0.0], [0.99, 0.0], 1).expect("finite");
    let length = Polygon::new(&sequence).length(&Hyperbolic);
    let exact = 4.0 * 0.99_f64.atanh();
    assert!((length.midpoint() / exact - 1.0).abs() < 1e-13, "{length:?}, {exact}");
    assert!(length.width() <= 1e-12 * exact, "{length:?}");
}

/// `1 + |x|` has no derivative at 0. The panels of width `2⁻⁴⁰` there are bounded by their range.
#[test]
fn a_kink_only_costs_time() {
    let tent = parsed("sqrt(sqr(x1)) + 1 I");
    let sequence = PointSequence::straight([-1.0], [2.0], 1).expect("finite");
    let energy = Polygon::new(&sequence).energy(&tent);
    // The integral of 3 (1 + |x|) from −1 to 2 is 33/2.
    assert!(energy.contains(16.5), "{energy:?}");
    assert!(energy.width() <= 1e-12 * 16.5, "{:e}", energy.width());
}

/// A chord across the knots of a table is only bisected: where the fourth derivative is none, the lower
/// ones and the value stay. Chords from knot to knot have the same energy.
#[test]
fn the_knots_of_a_table_only_cost_time() {
    let line = Spline::new(&[4], vec![1.0, 5.0, 2.0, 3.0]).expect("a shape");
    let plane =
        Spline::new(&[2, 4], vec![1.0, 5.0, 2.0, 3.0, 4.0, 1.0, 6.0, 2.0]).expect("a shape");
    let tables: [(&str, Arc<dyn Table>); 2] = [("t", Arc::new(line)), ("h", Arc::new(plane))];
    for text in
        ["[t(x1)]", "[20 + t_1(x1)]", "[40 + t_2(x1)]", "[h(0.5, x1)]", "[30 + h_01(x1, x1)]"]
    {
        let metric = Formula::<1>::parse_with(text, &[], &tables).expect(text);
        let energy = |chords: usize| {
            let sequence = PointSequence::straight([0.0], [3.0], chords).expect("finite");
            Polygon::new(&sequence).energy(&metric)
        };
        let (across, from_knot_to_knot) = (energy(1), energy(3));
        for energy in [across, from_knot_to_knot] {
            assert!(energy.width() <= 1e-11 * energy.lo(), "{text}: {energy:?}");
        }
        assert!(across.intersection(from_knot_to_knot).is_some(), "{text}: {across:?}");
    }
}

#[test]
fn an_overflow_gives_infinity() {
    let sequence = PointSequence::straight([0.0, 0.0], [1e200, 0.0], 1).expect("finite");
    let energy = Polygon::new(&sequence).energy(&Valleys);
    assert!(energy.hi() == f64::INFINITY && energy.lo() > 1e300, "{energy:?}");
}
