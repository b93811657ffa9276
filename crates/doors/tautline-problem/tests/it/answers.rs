//! The numbers of an answer are those of the line and of the proof in Rust, each under its own name.

mod known_distances;
mod other_minima;

use tautline::{Ends, Formula, Integral, Problem, Rule, TautLine, certify::Accuracy};
use tautline_problem::{Estimated, GlobalMinimum, Question};

/// A hill has two ways round it, and so another minimum.
#[test]
fn each_number_of_an_answer_is_that_of_the_line() {
    let file = "[metric]\ncost = \"1 + 4*exp(-2*(x1^2 + x2^2))\"\n[from]\npoint = [-1.5, 0.05]\n\
                [to]\npoint = [1.5, -0.1]\n[solve]\nn = 64\n[certify]\nbound = false\n";
    let answer = Question::read(file).expect("a file").solve(&mut |_| ()).expect("solved");
    let metric = Formula::<2>::parse("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", &[]).expect("a formula");
    let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let minimum = line.minimum();
    let estimated = |it: Integral| Estimated { value: it.value, error: it.error };
    assert_eq!((answer.dimension, answer.rule, answer.n), (2, "trapezoidal", 64));
    assert_eq!(answer.length, estimated(line.length()));
    assert_eq!(answer.energy, Some(estimated(line.energy())));
    assert_eq!(answer.discrete_energy, line.discrete_energy());
    assert!(
        answer.energy.as_ref().expect("finite").value > answer.length.value
            && answer.discrete_energy > 0.0
    );
    // An error of the square is 2 d times an error of d.
    let square = line.distance_squared_estimate().expect("several grids");
    let extrapolated = answer.extrapolated.expect("several grids");
    let error = square.error / (2.0 * square.value.sqrt());
    assert_eq!(extrapolated.value, square.value.sqrt());
    assert!((extrapolated.error - error).abs() <= 1e-14 * error, "{extrapolated:?} {error}");
    let search = &answer.search;
    assert_eq!((search.converged, search.stop), (true, "converged"));
    assert_eq!(search.hessian, "positive definite");
    assert_eq!(search.residual, minimum.residual);
    assert_eq!(search.residual_floor, minimum.residual_floor);
    assert_eq!(search.newton_steps, minimum.iterations);
    assert_eq!((answer.resolved, answer.within_tolerance), (line.is_resolved(), None));
    assert_eq!((answer.bounds, answer.no_bounds), (None, None));
    let points = |line: &TautLine<Formula<2>, 2>| -> Vec<Vec<f64>> {
        line.sequence().points().iter().map(|x| x.as_slice().to_vec()).collect()
    };
    assert_eq!(answer.curve, points(&line));
    let others = line.other_minima();
    assert_eq!((answer.other_minima.len(), others.is_empty()), (others.len(), false));
    for (other, line) in answer.other_minima.iter().zip(&others) {
        assert_eq!(other.length, estimated(line.length()));
        assert_eq!(other.curve, points(line));
    }
}

/// Three points of a detour, and no step of the search. The bounds hold for all curves; but a straight
/// sequence has less energy, so that nothing is proved of this one.
#[test]
fn a_sequence_that_did_not_converge_is_no_global_minimum() {
    let file = |steps: &str| {
        format!(
            "[metric]\nformula = \"2 + 0.1*sin(x1) I\"\n[from]\npoint = [0, 0]\n\
             [to]\npoint = [1, 0]\n[solve]\nn = 4\n{steps}\
             starts = [[[0, 0], [0.25, 0.0354], [0.5, 0.05], [0.75, 0.0354], [1, 0]]]\n\
             only_these_starts = true\n"
        )
    };
    let solved = |steps: &str| {
        let answer = Question::read(&file(steps)).expect("a file").solve(&mut |_| ());
        let answer = answer.expect("solved");
        (answer.search.converged, answer.bounds.expect("proved").global_minimum)
    };
    assert_eq!(solved("steps = 0\n"), (false, GlobalMinimum::NotNeeded));
    assert_eq!(solved(""), (true, GlobalMinimum::Proved));
}

/// The claims are true. Quadrature misses a spike of width 10⁻⁶ and height 10⁶, and says that its error is
/// small. The length is 1 + √π.
#[test]
fn bounds_by_claims_are_those_of_an_enclosed_curve() {
    let file = "[metric]\nphi = \"sqr(1 + 1e6*exp(-((x1 - 0.50123)*1e6)^2))\"\n[from]\npoint = [0]\n\
                [to]\npoint = [1]\n[certify]\n\
                constants = { c1 = 1, c2 = 1000002000001, l_h = 2e18, m_h = 1e25 }\n";
    let answer = Question::read(file).expect("a file").solve(&mut |_| ()).expect("solved");
    let bounds = answer.bounds.expect("bounds");
    let length = 1.0 + std::f64::consts::PI.sqrt();
    assert!(bounds.rests_on_claims() && bounds.lower.value <= length, "{bounds:?}");
    assert!(bounds.upper.value >= length && answer.length.value < 1.1, "{bounds:?}");
}

/// `H = 2 + x₁`, which doubles round to 2, below the claim.
#[test]
fn claims_that_only_rounding_breaks_are_not_refused() {
    let file = "[metric]\nphi = \"2 + (x1 + 1e16) - 1e16\"\n[from]\npoint = [0.2, 0]\n\
                [to]\npoint = [0.8, 0]\n[certify]\n\
                constants = { c1 = 2.1, c2 = 3, l_h = 1, m_h = 0 }\n";
    let answer = Question::read(file).expect("a file").solve(&mut |_| ()).expect("solved");
    let why = answer.no_bounds.unwrap_or_default();
    assert!(!why.contains("claim c1") && !why.contains("claim c2"), "{why}");
}

/// On the sphere the constants hold in a ball only, which is told with them.
#[test]
fn the_bounds_of_an_answer_are_those_of_the_proof() {
    let file = "[metric]\nphi = \"4/(1 + x1^2 + x2^2)^2\"\n[from]\npoint = [0.3, 0.1]\n\
                [to]\npoint = [0.45, 0.2]\n[solve]\nn = 256\n";
    let answer = Question::read(file).expect("a file").solve(&mut |_| ()).expect("solved");
    let metric = Formula::<2>::parse("phi(4/(1 + x1^2 + x2^2)^2)", &[]).expect("a formula");
    let ends = Ends::points([0.3, 0.1], [0.45, 0.2]).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 256).expect("solved");
    let accuracy = Accuracy { tolerance: 1e-3, budget: 100_000 };
    let proof = line.prove(accuracy).expect("proved");
    let bounds = answer.bounds.expect("proved");
    let constants = bounds.constants.expect("proved");
    let found = proof.constants;
    assert_eq!((constants.c1, constants.c2), (found.c1(), found.c2()));
    assert_eq!((constants.l_h, constants.m_h), (found.l_h(), found.m_h()));
    assert!(constants.proved && constants.c1 < constants.c2 && constants.m_h.is_some());
    let within = proof.within.expect("a ball");
    let ball = constants.within.as_ref().expect("a ball");
    assert_eq!((&ball.centre[..], ball.radius), (within.centre().as_slice(), within.r()));
    let (lower, upper) = (bounds.lower.value, bounds.upper.value);
    assert!(lower * lower <= proof.enclosure.lower && upper * upper >= proof.enclosure.upper);
    assert!(upper - lower <= 1e-14 + proof.enclosure.upper.sqrt() - proof.enclosure.lower.sqrt());
    // The arc between the points is 2 arcsin of half of their chord.
    let scale = (1.1_f64 * (1.0 + 0.2025 + 0.04)).sqrt();
    let d = 2.0 * (0.0325_f64.sqrt() / scale).asin();
    assert!(lower <= d && d <= upper, "{lower} {d} {upper}");
    assert_eq!((bounds.global_minimum, bounds.certificate), (GlobalMinimum::Proved, None));
    assert_eq!(bounds.upper_by, "the length of the curve");
}
