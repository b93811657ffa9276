//! Certificates of random metrics.

use tautline::{Ends, Formula, Problem, Rule, SVector};
use tautline_chance::{Random, cases, seed};

/// A metric as text, and its distance between two points, if it is known.
struct Case<const D: usize> {
    text: String,
    ends: [SVector<f64, D>; 2],
    distance: Option<f64>,
}

fn ends<const D: usize>(random: &mut Random) -> [SVector<f64, D>; 2] {
    let low = SVector::from_fn(|_, _| random.between(-1.0, 0.0));
    [low, low + SVector::from_fn(|_, _| random.between(0.2, 1.0))]
}

/// `(a + b cos k(x₁ + c))²` on the line, whose distance is the difference of a primitive.
fn on_the_line(random: &mut Random) -> Case<1> {
    let ends = ends::<1>(random);
    let (a, k, c) = (random.between(0.5, 3.0), random.between(0.5, 6.0), random.between(-1.0, 1.0));
    let b = a * random.between(-0.9, 0.9);
    let primitive = |x: f64| a * x + b / k * (k * (x + c)).sin();
    let distance = Some(primitive(ends[1][0]) - primitive(ends[0][0]));
    Case { text: format!("sqr({a} + {b}*cos({k}*(x1 + {c}))) I"), ends, distance }
}

/// The Euclidean metric in other coordinates, `F(x) = L(x₁ + b sin k x₂, x₂, …)`.
fn bent<const D: usize>(random: &mut Random) -> Case<D> {
    let ends = ends::<D>(random);
    let (b, k) = (random.between(-0.5, 0.5), random.between(0.5, 3.0));
    // A triangular matrix with a positive diagonal.
    let l: Vec<Vec<f64>> = (0..D)
        .map(|i| {
            let entry = |j: usize| if i == j { (0.5, 2.0) } else { (-0.5, 0.5) };
            (0..=i).map(|j| random.between(entry(j).0, entry(j).1)).collect()
        })
        .collect();
    let map = |x: &SVector<f64, D>| {
        let y = SVector::<f64, D>::from_fn(
            |i, _| {
                if i == 0 { x[0] + b * (k * x[1]).sin() } else { x[i] }
            },
        );
        SVector::<f64, D>::from_fn(|i, _| (0..=i).map(|j| l[i][j] * y[j]).sum())
    };
    let row = |i: usize| {
        let terms = (0..=i).map(|j| {
            let y = if j == 0 { format!("(x1 + {b}*sin({k}*x2))") } else { format!("x{}", j + 1) };
            format!("{}*{y}", l[i][j])
        });
        terms.collect::<Vec<_>>().join(" + ")
    };
    let rows: Vec<String> = (0..D).map(row).collect();
    let distance = Some((map(&ends[1]) - map(&ends[0])).norm());
    Case { text: format!("pullback({})", rows.join(", ")), ends, distance }
}

/// Waves in all entries, whose distance nobody knows.
fn waves(random: &mut Random) -> Case<2> {
    let ends = ends::<2>(random);
    let mut wave = || {
        let [size, k, l, c] = [0.9, 3.0, 3.0, 3.0].map(|most| random.between(-most, most));
        format!("{size}*sin({k}*x1 + {l}*x2 + {c})")
    };
    // By Gershgorin, the eigenvalues are at least 2 − 1.8.
    let beside = wave();
    let text = format!("[2 + {}, {beside}; {beside}, 2 + {}]", wave(), wave());
    Case { text, ends, distance: None }
}

/// Checks that the distance lies between the bounds. Returns the gap.
fn check<const D: usize>(case: &Case<D>, gap: f64) -> f64 {
    let Case { text, ends: [a, b], distance } = case;
    let formula = Formula::<D>::parse(text, &[]).unwrap_or_else(|error| panic!("{text}: {error}"));
    let ends = Ends::points(*a, *b).expect("finite");
    let line = Problem::new(formula.clone(), ends).solve(Rule::TRAPEZOIDAL, 32).expect("solved");
    let found = line.certificate(gap).unwrap_or_else(|error| panic!("{text}: {error}"));
    let proved = found.certificate.check().unwrap_or_else(|error| panic!("{text}: {error}"));
    let (lower, upper) = (proved.lower, proved.upper.expect("a curve"));
    assert!(0.0 < lower && lower <= upper, "{text}: {lower} {upper}");
    if let Some(d) = distance {
        // The known distance is rounded.
        let rounding = 1e-14 * d;
        assert!(lower <= d + rounding && *d <= upper + rounding, "{text}: {lower} {d} {upper}");
    }
    proved.gap().expect("a curve")
}

fn check_all<const D: usize>(
    fixed: u64,
    count: u32,
    gap: f64,
    case: impl Fn(&mut Random) -> Case<D>,
) {
    let mut random = Random(seed(fixed));
    let gaps: Vec<f64> = (0..cases(count)).map(|_| check(&case(&mut random), gap)).collect();
    // Almost all are as close as was wanted.
    let reached = gaps.iter().filter(|&&found| found <= gap).count();
    assert!(reached * 20 >= 19 * gaps.len(), "{reached} of {}", gaps.len());
}

#[test]
fn the_distances_of_600_metrics_on_the_line_lie_between_the_bounds() {
    check_all::<1>(51, 600, 1e-3, on_the_line);
}

#[test]
fn the_distances_of_240_bent_planes_lie_between_the_bounds() {
    check_all::<2>(52, 240, 0.1, bent);
}

#[test]
fn the_distances_of_10_bent_spaces_lie_between_the_bounds() {
    check_all::<3>(53, 10, 0.3, bent);
}

#[test]
fn the_bounds_of_150_waves_in_the_plane_are_in_order() {
    check_all::<2>(54, 150, 0.1, waves);
}
