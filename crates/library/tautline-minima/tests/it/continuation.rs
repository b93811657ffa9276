//! Minima of a bump that rises.

use tautline::{
    Ends, Metric, Problem, Rule, SMatrix, SVector, Scalar, are_apart,
    gallery::{Bump, TwoChannels},
};
use tautline_minima::{Flattened, GlobalSearch, Minima, follow};

/// The bump `φ² I` with `φ = 1 + a e^{−r²/2s²}` lies on the line from `(−L, 0)` to `(L, 0)`. The second
/// variation of the length for the displacement `η` across is `∫ φ η′² − (a/s²) e^{−x²/2s²} η²`: it is
/// positive on the grid of `n` intervals exactly if the pivots of its tridiagonal matrix are.
fn is_stable(a: f64, s: f64, half: f64, n: usize) -> bool {
    let h = 2.0 * half / n as f64;
    let gaussian = |x: f64| (-x * x / (2.0 * s * s)).exp();
    let stiffness = |k: f64| (1.0 + a * gaussian(-half + k * h)) / h;
    let mut pivot = f64::INFINITY;
    (1..n).all(|k| {
        let (left, right) = (stiffness(k as f64 - 0.5), stiffness(k as f64 + 0.5));
        let well = h * a / (s * s) * gaussian(-half + k as f64 * h);
        pivot = left + right - well - if k > 1 { left * left / pivot } else { 0.0 };
        pivot > 0.0
    })
}

/// The line over the bump is a minimum up to the height at which its second variation loses its sign.
/// There it splits into two mirror images.
#[test]
fn a_rising_bump_splits_the_line_where_the_second_variation_vanishes() {
    let (s, half, n) = (0.5, 1.5, 64);
    let (mut low, mut high) = (0.0, 4.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        *(if is_stable(middle, s, half, 4096) { &mut low } else { &mut high }) = middle;
    }
    let critical = low;
    assert!((0.1..3.0).contains(&critical), "{critical}");
    let ends = Ends::points([-half, 0.0], [half, 0.0]).expect("finite");
    let family = |a: f64| Bump::new(a, s).expect("a bump");
    // The error of 64 chords moves the critical height by their square, some 10⁻³ of it.
    for (last, expected) in [(0.98 * critical, 1), (1.1 * critical, 2)] {
        let heights: Vec<f64> = (0..=10).map(|k| last * f64::from(k) / 10.0).collect();
        let branches = follow(family, &heights, &ends, Rule::TRAPEZOIDAL, n, 8).expect("followed");
        assert_eq!(branches.len(), expected, "up to {last} of {critical}");
        let line = branches[0].line.sequence();
        let bend = line.points().iter().map(|x| x[1].abs()).fold(0.0, f64::max);
        if let [_, other] = &branches[..] {
            assert!(bend > 0.1 && are_apart(line, other.line.sequence()));
            let [a, b] = [&branches[0], other].map(|branch| branch.line.discrete_energy());
            // Mirror images, each to the floor of rounding.
            assert!((a / b - 1.0).abs() < 1e-11, "{a} {b}");
            // The heights are rounded.
            assert!((other.since / last - 1.0).abs() < 1e-15, "{}", other.since);
        } else {
            assert!(bend < 1e-6, "{bend}");
        }
    }
}

/// The other side is as old as the split, however long it is followed afterwards: up to twice the height, in
/// steps to either side of the critical one. Parameters may fall as well as rise.
#[test]
fn a_branch_keeps_its_age() {
    let ends = Ends::points([-1.5, 0.0], [1.5, 0.0]).expect("finite");
    let parameters: Vec<f64> = (0..=6).map(|k| -f64::from(k)).collect();
    let family = |a: f64| Bump::new(-a, 0.5).expect("a bump");
    let up_to = |last: usize, most| {
        let parameters = &parameters[..=last];
        follow(family, parameters, &ends, Rule::TRAPEZOIDAL, 64, most).expect("followed")
    };
    let split = (1..=6).find(|&k| up_to(k, 8).len() == 2).expect("a split");
    assert!(split < 4, "{split}");
    let [first, other] = &up_to(6, 8)[..] else { panic!("two sides") };
    assert_eq!([first.since, other.since], [0.0, parameters[split]]);
    assert_eq!(up_to(6, 1).len(), 1);
}

/// The valley moves under the ends, where its bottom has no derivative: no search converges there, and what it
/// leaves is no minimum.
#[test]
fn what_does_not_converge_is_no_branch() {
    #[derive(Debug)]
    struct Valley(f64);
    impl Metric<2> for Valley {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            SMatrix::from_diagonal_element((x[1] - self.0).sqr().sqrt() + 1.0)
        }
    }
    let ends = Ends::points([-1.5, 0.0], [1.5, 0.0]).expect("finite");
    let up_to = |parameters: &[f64]| {
        follow(Valley, parameters, &ends, Rule::TRAPEZOIDAL, 16, 8).expect("followed")
    };
    let [far, there] = [&[9.0][..], &[9.0, 0.0]].map(|parameters| up_to(parameters).len());
    assert_eq!([far, there], [1, 0]);
}

/// Already under the first metric there are two minima, of which one is asked for.
#[test]
fn the_first_metric_has_no_more_branches_either() {
    let ends = Ends::points([-3.0, 0.0], [3.0, 0.0]).expect("finite");
    let family = |width: f64| TwoChannels::new(2.0, 1.0, width).expect("channels");
    let of =
        |most| follow(family, &[0.5], &ends, Rule::TRAPEZOIDAL, 64, most).expect("solved").len();
    assert_eq!([of(8), of(1)], [2, 1]);
}

/// A flattened metric is Euclidean at first and the metric at last.
#[test]
fn a_flattened_metric_goes_from_flat_to_whole() {
    let metric = &Bump::new(3.0, 0.5).expect("a bump");
    let x = SVector::from([0.2, -0.1]);
    let at =
        |share: f64| -> SMatrix<f64, 2, 2> { Flattened { metric, level: 0.7, share }.gram(&x) };
    let (whole, one): (SMatrix<f64, 2, 2>, _) = (metric.gram(&x), SMatrix::<f64, 2, 2>::identity());
    assert_eq!(at(0.0), one * 0.7);
    assert_eq!(at(1.0), whole);
    // Exact up to two roundings.
    assert!((at(0.25) - (whole * 0.25 + one * 0.525)).amax() < 1e-14);
}

/// Without a lattice both sides of a bump are found, the far one of which splits off while it rises.
#[test]
fn continuation_alone_finds_both_sides() {
    let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
    let problem = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends.clone());
    let metric = problem.metric();
    let shares: Vec<f64> = (0..=8).map(|k| f64::from(k) / 8.0).collect();
    let family = |share| Flattened { metric, level: 1.0, share };
    let branches = follow(family, &shares, &ends, Rule::TRAPEZOIDAL, 64, 8).expect("followed");
    let search = GlobalSearch::default();
    let found = search.search(&problem, Rule::TRAPEZOIDAL, 64).expect("found");
    assert_eq!((branches.len(), found.minima().len()), (2, 2));
    assert!(branches[1].since > 0.0);
}

/// The last step of continuation leads to the whole metric: even in a single step, from the Euclidean one, it
/// sees that the line over the bump splits, and starts from both sides of it.
#[test]
fn the_last_step_is_that_to_the_whole_metric() {
    let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
    let problem = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends);
    let of = |steps| {
        let mut search = GlobalSearch::default();
        search.steps = steps;
        search.search(&problem, Rule::TRAPEZOIDAL, 64).expect("found")
    };
    let without = of(0);
    let hits = |found: &Minima<Bump, 2>| -> Vec<usize> {
        found.minima().iter().map(|minimum| minimum.hits).collect()
    };
    assert_eq!(without.minima().len(), 2);
    for steps in [1, 2] {
        let found = of(steps);
        assert_eq!(found.starts(), without.starts() + 2, "{steps}");
        let more: Vec<usize> = hits(&without).iter().map(|hits| hits + 1).collect();
        assert_eq!(hits(&found), more, "{steps}");
    }
}
