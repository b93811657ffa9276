//! Energies and lengths of polygons, compared with closed forms and with many-digit numbers.

use astro_float::{BigFloat, Consts, Radix, RoundingMode};
use nalgebra::{SMatrix, SVector, vector};
use tautline_certify::Polygon;
use tautline_discretizations::{PointSequence, Rule};
use tautline_metrics::{
    Metric,
    gallery::{
        Bump, Constant, EggCrate, GaussianFisher, Hyperbolic, RotatingAnisotropy, Shear, Sphere,
        TwoLinkArm, Valleys,
    },
};
use tautline_scalar::{Enclosure, Fast, Interval, Kernel};

use crate::parsed;

const P: usize = 192;
const RM: RoundingMode = RoundingMode::None;

fn big(x: f64) -> BigFloat {
    BigFloat::from_f64(x, P)
}

/// Returns whether the enclosure contains the number.
fn holds<K: Kernel>(x: Enclosure<K>, y: &BigFloat) -> bool {
    let below = |a: &BigFloat, b: &BigFloat| a.cmp(b).is_some_and(|order| order <= 0);
    below(&big(x.lo()), y) && below(y, &big(x.hi()))
}

/// Checks that the enclosure contains the decimal, with a relative width of at most `margin`.
#[track_caller]
fn check<K: Kernel>(x: Enclosure<K>, decimal: &str, margin: f64) {
    let mut consts = Consts::new().expect("memory for the constants");
    let y = BigFloat::parse(decimal, Radix::Dec, P, RM, &mut consts);
    assert!(holds(x, &y), "{x:?} misses {decimal}");
    assert!(x.width() <= margin * x.lo(), "{x:?} is wide: {:e}", x.width() / x.lo());
}

/// The tolerance of a chord, plus the rounding of a few chords.
const NARROW: f64 = 1.01e-12;

fn line(a: [f64; 2], b: [f64; 2]) -> PointSequence<2> {
    PointSequence::straight(a, b, 1).expect("finite")
}

/// `E = ½ (4/3 + ln 3)` and `L = ln 3` from the centre to ½ in the hyperbolic ball, and
/// `E = 2 + (1 − e⁻²)/2` along the diagonal for `diag(e^{−2t}, 2)`.
#[test]
fn closed_forms_are_enclosed() {
    let radius = line([0.0, 0.0], [0.5, 0.0]);
    let (energy, length) = Polygon::new(&radius).energy_and_length(&Hyperbolic);
    check(energy, "1.215972811000721512364289285128", NARROW);
    check(length, "1.098612288668109691395245236923", NARROW);
    let diagonal = line([0.0, 0.0], [1.0, 1.0]);
    check(
        Polygon::new(&diagonal).energy(&GaussianFisher),
        "2.432332358381693654053000252514",
        NARROW,
    );
    // The distance from the ball of radius ½ to the wall at 3 in the valleys is 5 − sin 3 + sin ½.
    let gap = line([0.5, 0.0], [3.0, 0.0]);
    check(Polygon::new(&gap).length(&Valleys), "5.33830553054433577817", NARROW);
}

/// The straight line of Section 5 has `E = 72 π²` and `L = 8π`. Its end `4π` is a box between two
/// doubles, and its only chord is bisected as often as needed.
#[test]
fn the_line_of_section_5_has_the_energy_72_pi_squared() {
    let four_pi = 12.566370614359172_f64;
    let straight = line([0.0, 0.0], [four_pi, 0.0]);
    let zero = Interval::point(0.0);
    let end = Interval::new(four_pi, four_pi.next_up()).expect("ordered");
    let polygon = Polygon::new(&straight).with_ends(vector![zero, zero], vector![end, zero]);
    let (energy, length) = polygon.energy_and_length(&Valleys);
    check(energy, "710.61151687843382055608335199108", NARROW);
    check(length, "25.1327412287183459077011471", NARROW);
    // The paper's discrete energy sees only a valley: it is 16 π². The box is one unit in the last
    // place wide, and its width is squared.
    let discrete = polygon.discrete_energy(Rule::TRAPEZOIDAL, &Valleys);
    check(discrete, "157.913670417429737901351855998", 16.0 * f64::EPSILON);
    let fast = polygon.with_kernel::<Fast>();
    check(fast.energy(&Valleys), "710.61151687843382055608335199108", NARROW);
}

/// With another end, the energy is a different number.
#[test]
fn without_the_box_the_end_is_another_point() {
    let straight = line([0.0, 0.0], [12.0, 0.0]);
    let polygon = Polygon::new(&straight);
    let moved = polygon.with_ends(polygon.first(), vector![13.0, 0.0].map(Interval::point));
    assert!(polygon.energy(&Valleys).hi() < moved.energy(&Valleys).lo());
    assert!(polygon.length(&Valleys).hi() < moved.length(&Valleys).lo());
}

/// Three chords, compared with independent quadrature to 40 digits.
#[test]
fn polygons_under_seven_metrics_are_enclosed() {
    fn reference(metric: &impl Metric<2>, energy: &str, length: &str) {
        let points =
            vec![vector![-1.0, 0.25], vector![0.125, 0.5], vector![1.0, -0.75], vector![2.5, 0.5]];
        let sequence = PointSequence::new(points).expect("finite");
        let polygon = Polygon::new(&sequence);
        let (e, l) = polygon.energy_and_length(metric);
        check(e, energy, NARROW);
        check(l, length, NARROW);
        let (e, l) = polygon.with_kernel::<Fast>().energy_and_length(metric);
        check(e, energy, NARROW);
        check(l, length, NARROW);
    }
    let bump = Bump::new(1.0, 0.5).expect("positive");
    let egg = EggCrate::new(0.5, 2.0).expect("positive");
    let rotating = RotatingAnisotropy::new([1.0, 4.0], [1.0, 2.0]).expect("positive");
    let arm = TwoLinkArm::new(3.0, 1.0, 1.0).expect("definite");
    let shear = Shear::new(0.5, 1.0).expect("positive");
    reference(&bump, "35.36908591833803836736965", "5.864341535834249608205426");
    reference(&egg, "27.10108592342320716977472", "5.137576898421293718357888");
    reference(&rotating, "57.60478298481092038987403", "7.186524588467538482284238");
    reference(&arm, "84.24294797584373749255681", "8.171830674547448108248316");
    reference(&shear, "27.44061706962195256177904", "4.97814666587224638335436");
    reference(&Sphere, "25.74417942983695645757937", "4.755194247840014670830747");
    reference(&GaussianFisher, "35.82410628634388510639273", "5.507440069068043424268044");
}

/// `2 − cos` and its square along `x₁`, computed from their primitives in 192 bits. This is sharp
/// enough to detect a missing remainder of any chord.
#[test]
fn random_polygons_in_the_valleys_contain_a_value_of_192_bits() {
    let mut consts = Consts::new().expect("memory for the constants");
    for n in [1, 2, 7, 40] {
        // The points are irrational rotations, so that no two of them coincide.
        let at = |k: usize, step: f64| (k as f64 * step).fract() * 6.0 - 3.0;
        let points: Vec<SVector<f64, 2>> =
            (0..=n).map(|k| vector![at(k + n, 0.618_034), at(k + n, 0.414_214)]).collect();
        let (mut energy, mut length) = (big(0.0), big(0.0));
        for pair in points.windows(2) {
            let [a, b] = [pair[0][0], pair[1][0]];
            let minus = |a: &BigFloat, b: &BigFloat| a.sub(b, P, RM);
            let times = |a: &BigFloat, b: &BigFloat| a.mul(b, P, RM);
            let mut sine = |x: f64, k: f64| times(&big(x), &big(k)).sin(P, RM, &mut consts);
            let first = minus(&sine(b, 1.0), &sine(a, 1.0));
            let second = minus(&sine(b, 2.0), &sine(a, 2.0));
            let d = [0, 1].map(|i| minus(&big(pair[1][i]), &big(pair[0][i])));
            let square = times(&d[0], &d[0]).add(&times(&d[1], &d[1]), P, RM);
            // ∫ f² = 9/2 − (4 [sin x] − ¼ [sin 2x]) / (b − a) and ∫ f = 2 − [sin x] / (b − a).
            let part = minus(&times(&big(4.0), &first), &times(&big(0.25), &second));
            let f2 = minus(&big(4.5), &part.div(&d[0], P, RM));
            let f1 = minus(&big(2.0), &first.div(&d[0], P, RM));
            energy = energy.add(&times(&square, &f2), P, RM);
            length = length.add(&times(&square.sqrt(P, RM), &f1), P, RM);
        }
        let energy = energy.mul(&big(n as f64), P, RM);
        let sequence = PointSequence::new(points).expect("finite");
        let (e, l) = Polygon::new(&sequence).energy_and_length(&Valleys);
        assert!(holds(e, &energy) && holds(l, &length), "N = {n}: {e:?} {l:?}");
        assert!(e.width() <= NARROW * e.lo() && l.width() <= NARROW * l.lo(), "N = {n}");
    }
}

/// `1 − 10⁻²⁰` rounds to 1, so a chord computed in doubles would be too long.
#[test]
fn the_difference_of_points_is_not_rounded() {
    let euclidean = Constant::new(SMatrix::<f64, 1, 1>::identity()).expect("definite");
    let tiny = 1e-20_f64;
    let sequence = PointSequence::straight([tiny], [1.0], 1).expect("finite");
    let exact = big(1.0).sub(&big(tiny), P, RM);
    let square = exact.mul(&exact, P, RM);
    let polygon = Polygon::new(&sequence);
    let (energy, length) = polygon.energy_and_length(&euclidean);
    assert!(holds(energy, &square) && holds(length, &exact), "{energy:?} {length:?}");
    assert!(holds(polygon.discrete_energy(Rule::TRAPEZOIDAL, &euclidean), &square));
    assert!(energy.width() <= 1e-15 && length.width() <= 1e-15);
}

/// The least exponent has no negative in `i32`. The power is 1 for `y = ±1`, and undefined for
/// `y = 0`.
#[test]
fn the_least_power_is_a_power_too() {
    let power = parsed::<2>(&format!("x2^{} I", i32::MIN));
    for (y, value) in [(1.0, 1.0), (-1.0, 1.0), (2.0, 0.0)] {
        let sequence = line([0.0, y], [3.0, y]);
        let (energy, length) = Polygon::new(&sequence).energy_and_length(&power);
        assert!(energy.contains(9.0 * value) && length.contains(3.0 * value), "{energy:?}");
        assert!(energy.width() < 1e-10 && length.width() < 1e-10, "{energy:?} {length:?}");
    }
    let sequence = line([0.0, 0.0], [3.0, 0.0]);
    assert!(Polygon::new(&sequence).energy(&power).is_undefined());
}

/// `H = x⁴` has a constant remainder: only the coefficient 1/80 makes `∫₀¹ x⁴ = 1/5`. This also
/// tests the weights and nodes of three rules.
#[test]
fn fourth_powers_are_integrated_exactly() {
    let quartic = parsed("x1^4 I");
    let sequence = PointSequence::straight([1.0], [2.0], 1).expect("finite");
    let polygon = Polygon::new(&sequence);
    let (energy, length) = polygon.energy_and_length(&quartic);
    // The values are 31/5, not a double, and 7/3 for √H = x², where the recurrence of the root is
    // not exact.
    check(energy, "6.2", 4.0 * f64::EPSILON);
    check(length, "2.333333333333333333333333333333", NARROW);
    let point = |x: f64| Interval::point(x);
    assert_eq!(polygon.discrete_energy(Rule::LEFT_ENDPOINT, &quartic), point(1.0));
    assert_eq!(polygon.discrete_energy(Rule::TRAPEZOIDAL, &quartic), point(5.0625));
    assert_eq!(polygon.discrete_energy(Rule::TRUE_TRAPEZOID, &quartic), point(8.5));
    // Two halves, with the factor N = 2.
    let sequence = PointSequence::straight([1.0], [2.0], 2).expect("finite");
    let halves = Polygon::new(&sequence).discrete_energy(Rule::LEFT_ENDPOINT, &quartic);
    assert_eq!(halves, point(2.0 * 0.25 * (1.0 + 5.0625)));
}
