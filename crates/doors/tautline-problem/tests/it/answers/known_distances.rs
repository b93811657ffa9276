//! Problems with known distances that a search by the energy of a rule alone, or bounds by constants alone,
//! get wrong or leave open.

use tautline_problem::{Answer, Failure, Question};

fn answer(metric: &str, from: &str, to: &str, rest: &str) -> Answer {
    let file = format!("{metric}\n[from]\npoint = {from}\n[to]\npoint = {to}\n{rest}");
    Question::read(&file).expect("a problem").solve(&mut |_| ()).expect("solved")
}

const NO_BOUNDS: &str = "[certify]\nbound = false\n";

/// `∫₀ʳ (1 − e^{−s²}) ds`, by its series `Σ (−1)ᵏ⁺¹ r^{2k+1}/(k! (2k + 1))`, of which 60 terms are enough for
/// `r ≤ 2`.
fn to_the_centre(r: f64) -> f64 {
    let (mut power, mut sum) = (r, 0.0);
    for k in 1..60 {
        power *= -r * r / f64::from(k);
        sum -= power / f64::from(2 * k + 1);
    }
    sum
}

/// The cost vanishes at the origin, so that a long chord over it has no energy by the rule: a curve that is
/// three times as long has less energy, on every grid.
#[test]
fn the_answer_is_the_shortest_curve_by_its_length() {
    let metric = "[metric]\ncost = \"1 - exp(-x1^2 - x2^2)\"";
    let found = answer(metric, "[-1.5, 0.1]", "[1.5, 0.05]", NO_BOUNDS);
    // Straight to the origin, and straight on.
    let exact = to_the_centre(1.5_f64.hypot(0.1)) + to_the_centre(1.5_f64.hypot(0.05));
    let error = found.length.value / exact - 1.0;
    assert!((0.0..1e-4).contains(&error), "{} {exact}", found.length.value);
    assert!(found.other_minima.iter().all(|other| !other.is_shorter_than(&found)));
    assert_eq!((found.rule, found.doubts.as_slice()), ("simpson", &[][..]));
    let left = answer(
        metric,
        "[-1.5, 0.1]",
        "[1.5, 0.05]",
        &format!("[solve]\nscope = \"local\"\n{NO_BOUNDS}"),
    );
    assert!(left.rule == "trapezoidal" && left.length.value > 3.0, "{}", left.length.value);
    assert!(left.doubts.iter().any(|doubt| doubt.kind == "not_resolved"), "{:?}", left.doubts);
}

/// Simpson's rule has no theorem, and claims are about theorems: they take the minimum of the rule that was
/// asked for, and the curve is a bound from above. With many chords there is no search on finer grids.
#[test]
fn claims_give_bounds_also_where_another_rule_finds_the_curve() {
    let metric = "[metric]\ncost = \"1.001 - exp(-x1^2 - x2^2)\"";
    let claims = "[certify.constants]\nc1 = 1e-6\nc2 = 1.1\nl_h = 2\n";
    let found = answer(metric, "[-1.5, 0.1]", "[1.5, 0.05]", claims);
    let bounds = found.bounds.expect("by claims");
    let most = to_the_centre(1.5_f64.hypot(0.1)) + to_the_centre(1.5_f64.hypot(0.05)) + 0.004;
    assert!(bounds.rests_on_claims() && bounds.lower.value > 0.0, "{bounds:?}");
    assert!(bounds.lower.value <= most && bounds.upper.value <= most, "{bounds:?} {most}");
    // This claim holds at all points of the trapezoidal rule, 1.49 from the origin or farther. By Euclid the
    // distance is then at least 3 √0.75, and the curves that Simpson's rule finds refute it.
    let wrong = "[certify.constants]\nc1 = 0.75\nc2 = 1.1\nl_h = 2\n";
    let refused = answer(metric, "[-1.5, 0.1]", "[1.5, 0.05]", wrong);
    let reason = refused.no_bounds.expect("a contradiction");
    assert!(reason.starts_with("the claimed constants are wrong"), "{reason}");
    let vanishing = "[metric]\ncost = \"1 - exp(-x1^2 - x2^2)\"";
    let fine = format!("[solve]\nn = 5000\n{NO_BOUNDS}");
    let found = answer(vanishing, "[-1.5, 0.1]", "[1.5, 0.05]", &fine);
    assert_eq!((found.rule, found.n, found.search.converged), ("simpson", 5000, true));
    // With a tolerance, too.
    let close = format!("[solve]\ntolerance = 1e-3\n{NO_BOUNDS}");
    let found = answer(vanishing, "[-1.5, 0.1]", "[1.5, 0.05]", &close);
    assert!(found.length.value < 1.293, "{}", found.length.value);
}

/// Under the cost `|∇V|` a shortest curve between two minima runs along the gradient, and its length is the sum
/// of the climbs and falls of `V`. The cost vanishes at both ends, and at three points between them.
#[test]
fn the_cost_of_a_gradient_is_the_climb_of_its_potential() {
    // Müller and Brown's potential.
    let term = |a: f64, p: [f64; 5]| {
        let [b, c, d, x, y] = p;
        let at = format!(
            "{a}*exp(({b})*(x1 - ({x}))^2 + ({c})*(x1 - ({x}))*(x2 - ({y})) + ({d})*(x2 - ({y}))^2)"
        );
        [
            format!("(2*({b})*(x1 - ({x})) + ({c})*(x2 - ({y})))*{at}"),
            format!("(({c})*(x1 - ({x})) + 2*({d})*(x2 - ({y})))*{at}"),
        ]
    };
    let terms = [
        term(-200.0, [-1.0, 0.0, -10.0, 1.0, 0.0]),
        term(-100.0, [-1.0, 0.0, -10.0, 0.0, 0.5]),
        term(-170.0, [-6.5, 11.0, -6.5, -0.5, 1.5]),
        term(15.0, [0.7, 0.6, 0.7, -1.0, 1.0]),
    ];
    let sum = |i: usize| terms.each_ref().map(|term| term[i].as_str()).join(" + ");
    let metric =
        format!("[let]\ng1 = \"{}\"\ng2 = \"{}\"\n[metric]\nphi = \"g1^2 + g2^2\"", sum(0), sum(1));
    let found = answer(&metric, "[-0.558224, 1.441726]", "[0.623499, 0.028038]", NO_BOUNDS);
    // Its values at three minima and the two saddles between them, below 0.
    let [first, saddle, middle, second, last] = [146.6995, 40.6648, 80.7678, 72.2489, 108.1667];
    let exact = (first - saddle) + (middle - saddle) + (middle - second) + (last - second);
    let error = found.length.value / exact - 1.0;
    assert!((-1e-6..1e-4).contains(&error), "{} {exact}", found.length.value);
    assert!(found.doubts.is_empty(), "{:?}", found.doubts);
}

/// Under `|x|⁻²` the inversion `x/|x|²` is an isometry to the plane without the origin. With 256 chords
/// the search leaps over the pole and its quadrature sees a length of 4.5.
#[test]
fn chords_are_doubled_until_the_rule_sees_the_metric() {
    let metric = "[metric]\ncost = \"1/(x1^2 + x2^2)\"";
    let inverted = |x: f64, y: f64| (x / (x * x + y * y), y / (x * x + y * y));
    let (a, b) = (inverted(-1.5, 0.1), inverted(1.5, 0.05));
    let exact = (a.0 - b.0).hypot(a.1 - b.1);
    let found = answer(metric, "[-1.5, 0.1]", "[1.5, 0.05]", NO_BOUNDS);
    assert!(found.n > 256 && found.doubts.is_empty(), "{} {:?}", found.n, found.doubts);
    assert!((found.length.value / exact - 1.0).abs() < 1e-4, "{} {exact}", found.length.value);
    let local = answer(
        metric,
        "[-1.5, 0.1]",
        "[1.5, 0.05]",
        "[solve]\nscope = \"local\"\n[certify]\nbound = false\n",
    );
    assert!(local.n == 256 && !local.resolved, "a local search keeps to its chords");
}

/// Two minima that differ by a ten-thousandth: by the energies of 256 chords the longer one is lower.
#[test]
fn the_shorter_of_two_minima_is_followed_to_the_grid_that_tells_them_apart() {
    let peaks = "[metric]\ngraph = \"3*(1 - x1)^2*exp(-x1^2 - (x2 + 1)^2) \
                 - 10*(x1/5 - x1^3 - x2^5)*exp(-x1^2 - x2^2) - exp(-(x1 + 1)^2 - x2^2)/3\"";
    let found = answer(peaks, "[0.5, -3]", "[-0.5, 3]", NO_BOUNDS);
    // By collocation of the geodesic equation, to nine digits.
    let exact = 8.454_167_268;
    assert!((found.length.value / exact - 1.0).abs() < 1e-4, "{}", found.length.value);
    let extrapolated = found.extrapolated.expect("several grids");
    assert!((extrapolated.value / exact - 1.0).abs() < 1e-6, "{extrapolated:?}");
}

/// A ridge between the nodes: the energies of the grids tend to more than the length of the curve, which is
/// an upper bound.
#[test]
fn an_estimate_is_not_above_an_upper_bound() {
    let metric = "[metric]\ncost = \"1 + 30*exp(-200*x1^2)\"";
    for n in [64, 256, 512, 1024, 2048] {
        let found = answer(metric, "[-1.5, 0.1]", "[1.5, 0.05]", &format!("[solve]\nn = {n}\n"));
        let bounds = found.bounds.expect("proved");
        // Across the ridge straight on: 3 + 30 √(π/200) to three digits.
        assert!(bounds.lower.value < 6.76 && bounds.upper.value < 6.762, "{bounds:?}");
        if let Some(estimate) = found.extrapolated {
            assert!(estimate.value <= bounds.upper.value, "N = {n}: {estimate:?} {bounds:?}");
            assert!(estimate.value >= 6.759 - estimate.error, "N = {n}: {estimate:?}");
        }
    }
}

/// No constants are proved: curves may come near the edge of the half-plane, near a pole, or far away. A
/// certificate needs none.
#[test]
fn a_certificate_bounds_the_distance_where_no_constants_are_proved() {
    let half_plane = (1.0_f64 + 4.0 / 2.0).acosh();
    let degrees = |x: f64| x.to_radians();
    let ([a, b], [c, d]) = ([13.4, 52.5].map(degrees), [139.7, 35.7].map(degrees));
    let cosine = b.sin() * d.sin() + b.cos() * d.cos() * (c - a).cos();
    let globe = "[parameters]\nr = \"6371*pi/180\"\n\
                 [metric]\ndiag = [\"(r*cos(x2*pi/180))^2\", \"r^2\"]";
    for (metric, from, to, exact) in [
        ("[metric]\nphi = \"1/x2^2\"", "[-1, 1]", "[1, 1]", half_plane),
        (globe, "[13.4, 52.5]", "[139.7, 35.7]", 6371.0 * cosine.acos()),
    ] {
        let found = answer(metric, from, to, "");
        let bounds = found.bounds.expect("a certificate");
        assert_eq!((bounds.lower_by.as_str(), &bounds.constants), ("a certificate", &None));
        let (lower, upper) = (bounds.lower.value, bounds.upper.value);
        assert!(lower <= exact && exact <= upper, "{lower} {exact} {upper}");
        assert!(upper - lower <= 1e-3 * upper, "{lower} {upper}");
    }
}

/// A frequency in hertz beside an angle: the ends differ by half a radian, which is less than the rounding of
/// the frequency.
#[test]
fn different_points_do_not_touch() {
    let metric = "[metric]\ndiag = [\"1e-30\", 1]";
    let found = answer(metric, "[5e14, 0]", "[5e14, 0.5]", "");
    let bounds = found.bounds.expect("proved");
    assert!((found.length.value - 0.5).abs() < 1e-12, "{}", found.length.value);
    assert!(bounds.lower.value > 0.499_999 && bounds.lower.value <= 0.5, "{bounds:?}");
}

/// On the torus with radii 3 and 2 the inner circle has radius 1, and the points are 2π − 6 apart along it.
/// On the plane without a period, straight, they are 6 apart.
#[test]
fn an_angle_goes_round() {
    let torus = "[metric]\ndiag = [4, \"(3 + 2*cos(x1))^2\"]";
    let solve = |metric: &str| answer(metric, "[\"pi\", -3]", "[\"pi\", 3]", "");
    let round = solve(&format!("period = [0, \"2*pi\"]\n{torus}"));
    let exact = std::f64::consts::TAU - 6.0;
    // Along a straight line of constant cost, with the roundings of 3 and 2π.
    assert!((round.length.value - exact).abs() < 1e-14, "{}", round.length.value);
    let bounds = round.bounds.expect("a certificate");
    assert!(bounds.lower.value <= exact && bounds.lower.value > 0.999 * exact, "{bounds:?}");
    assert!((solve(torus).length.value - 6.0).abs() < 1e-14);
    // Round the outer circle, whose translates are farther, and with the period of the other angle.
    let both = solve(&format!("period = [\"2*pi\", \"2*pi\"]\n{torus}"));
    assert!((both.length.value - exact).abs() < 1e-14, "{}", both.length.value);
}

/// Under `(x₁ + x₂/2)² + x₂²` the translate by five periods is the nearest, at distance 10, though it is the
/// farthest by its coordinates: the bound about the translates that were tried says so. That of the torus does
/// not, since its constants prove that the others are farther.
#[test]
fn a_bound_says_that_farther_translates_were_not_tried() {
    let open = "; farther translates by the period were not tried";
    let slanted = "period = [1, 0]\n[metric]\nformula = \"[1, 0.5; 0.5, 1.25]\"";
    let found = answer(slanted, "[0, 0]", "[0, 10]", "").bounds.expect("bounds");
    assert!(found.lower.value > 10.0 && found.lower_by.ends_with(open), "{found:?}");
    let torus = "period = [0, \"2*pi\"]\n[metric]\ndiag = [4, \"(3 + 2*cos(x1))^2\"]";
    let found = answer(torus, "[\"pi\", -3]", "[\"pi\", 3]", "").bounds.expect("bounds");
    assert!(!found.lower_by.contains("translates"), "{found:?}");
}

/// A period is one of the metric, of the right length and sign.
#[test]
fn what_is_no_period_is_underlined() {
    let file = |period: &str| {
        format!(
            "period = {period}\n[metric]\ncost = \"2 + cos(x1)\"\n[from]\npoint = [0, 0]\n\
             [to]\npoint = [3, 0]\n{NO_BOUNDS}"
        )
    };
    let solved = |file: &str| Question::read(file).map(|question| question.solve(&mut |_| ()));
    assert!(solved(&file("[\"2*pi\", 0]")).expect("a file").is_ok());
    for (period, says, at) in [
        ("[6, 0]", "does not have the period 6 in x1", "[6, 0]"),
        ("[6]", "1 coordinate in dimension 2", "[6]"),
        ("[\"2*pi\", -1]", "the period -1", "-1"),
    ] {
        let file = file(period);
        let refused = match solved(&file) {
            Err(diagnostic) | Ok(Err(Failure::BadInput(diagnostic))) => diagnostic,
            Ok(other) => panic!("{period}: {:?}", other.map(|answer| answer.length)),
        };
        assert!(refused.message.contains(says), "{}", refused.message);
        assert_eq!(&file[refused.at.clone()], at, "{refused:?}");
    }
}

/// A ball falls from rest along a cycloid `(r (φ − sin φ), r (1 − cos φ))`, and takes the time `φ √(r/g)`. Its
/// speed is 0 where it starts, so that the cost is infinite there.
#[test]
fn a_start_from_rest_is_a_brachistochrone() {
    for (metric, to, [x, y]) in [
        ("speed = \"sqrt(2*9.81*x2)\"", "[10, 5]", [10.0_f64, 5.0]),
        ("phi = \"1/(2*9.81*x2)\"", "[2, 2]", [2.0, 2.0]),
    ] {
        // The quotient of the coordinates increases with φ; after 60 halvings φ is exact.
        let quotient = |phi: f64| (phi - phi.sin()) / (1.0 - phi.cos());
        let (mut low, mut high) = (1e-3, 6.2);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if quotient(middle) < x / y { low = middle } else { high = middle }
        }
        let exact = low * (y / (1.0 - low.cos()) / 9.81).sqrt();
        for from in ["[0, 0]", "[0, 1e-9]"] {
            let found = answer(&format!("[metric]\n{metric}"), from, to, NO_BOUNDS);
            let error = found.length.value / exact - 1.0;
            assert!(
                error.abs() < 3e-5 && found.doubts.is_empty(),
                "{from} {} {exact}",
                found.length.value
            );
        }
    }
}

/// `∫ dx/√(x − 5) = 2 √3` converges from 5 on, although 1/√ is infinite there and numbers next to 5 are rounded
/// to it. `∫ dx/x` does not.
#[test]
fn a_length_from_a_pole_is_finite_if_its_integral_is() {
    for metric in ["cost = \"1/sqrt(x1 - 5)\"", "speed = \"sqrt(x1 - 5)\""] {
        for [from, to] in [["[5]", "[8]"], ["[8]", "[5]"]] {
            let found = answer(&format!("[metric]\n{metric}"), from, to, NO_BOUNDS);
            let error = found.length.value - 2.0 * 3.0_f64.sqrt();
            // Within 1024 roundings of 5 numbers are not told apart from it: 2 √(1024 · 2.2e-16 · 5) is 2e-6.
            assert!(
                error.abs() <= found.length.error && found.length.error < 4e-6,
                "{:?}",
                found.length
            );
        }
    }
    for [from, to] in [["[0, 0]", "[1, 1]"], ["[1, 1]", "[0, 0]"]] {
        let file =
            format!("[metric]\ncost = \"1/x2\"\n[from]\npoint = {from}\n[to]\npoint = {to}\n");
        let refused = Question::read(&file).expect("a file").solve(&mut |_| ());
        let refused = refused.expect_err("an infinite length").to_string();
        assert!(refused.contains("H([0.0, 0.0]) has the entry inf"), "{refused}");
        // Another rule has nodes at the ends.
        let other = format!("{}[solve]\nrule = \"simpson\"\n", file.replace("1/x2", "1/sqrt(x2)"));
        let refused = Question::read(&other).expect("a file").solve(&mut |_| ());
        let Err(Failure::BadInput(refused)) = refused else { panic!("a node at an end") };
        assert_eq!(
            refused.help.as_deref(),
            Some("the trapezoidal rule has no node at an end, from where the length may be finite")
        );
        let advised = Question::read(&other.replace("simpson", "trapezoidal")).expect("a file");
        assert!(advised.solve(&mut |_| ()).is_ok());
    }
}

/// A shell of radius 6371 from the pole, whose longitude is no number: a quarter of a great circle. On the first
/// chord the longitude changes, as the rule sees it.
#[test]
fn a_curve_may_begin_at_a_pole_of_its_coordinates() {
    let shell = "[metric]\ndiag = [\"6371^2\", \"(6371*sin(x1))^2\"]";
    let found = answer(shell, "[0, 0]", "[\"pi/2\", 1]", NO_BOUNDS);
    let exact = 6371.0 * std::f64::consts::FRAC_PI_2;
    let error = found.length.value / exact - 1.0;
    assert!((0.0..1e-3).contains(&error), "{} {exact}", found.length.value);
}

/// The cost |∇V| of rare events vanishes at both ends and at the saddle between them, so that a search may end
/// there in one point. The advice is an end beside the one that was given.
#[test]
fn an_end_at_which_the_cost_vanishes_may_be_left_out() {
    let metric = "[let]\nb1 = \"x1 - x1^3 - x1*x2^2\"\nb2 = \"-(1 + x1^2)*x2\"\n\
                  [metric]\nphi = \"b1^2 + b2^2\"";
    let file =
        |from: &str| format!("{metric}\n[from]\npoint = {from}\n[to]\npoint = [1, 0]\n{NO_BOUNDS}");
    let solve = |from: &str| Question::read(&file(from)).expect("a file").solve(&mut |_| ());
    let Err(Failure::BadInput(refused)) = solve("[-1, 0]") else { panic!("refused") };
    let advice = refused.help.expect("advice");
    let beside = advice.strip_prefix("leave out the end, such as by [from] at ").expect(&advice);
    let found = solve(beside).expect("the advice works");
    // V falls by 1/4 twice, apart from what is left out.
    assert!((found.length.value - 0.5).abs() < 1e-4, "{beside} {}", found.length.value);
}

/// At an end `H` may be infinite or singular. It is neither indefinite there nor no number.
#[test]
fn an_end_where_the_matrix_is_indefinite_is_refused() {
    for (metric, says) in [
        ("diag = [\"1\", \"x2 - 1e-5\"]", "not positive definite"),
        ("diag = [\"1\", \"1 + 0/x2\"]", "NaN"),
    ] {
        let file = format!("[metric]\n{metric}\n[from]\npoint = [0, 0]\n[to]\npoint = [1, 1]\n");
        let refused = Question::read(&file).expect("a file").solve(&mut |_| ());
        let refused = refused.expect_err("no metric at an end").to_string();
        assert!(refused.contains("H([0.0, 0.0])") && refused.contains(says), "{refused}");
    }
}

/// The offset of projected coordinates changes neither the digits nor the work.
#[test]
fn an_offset_of_the_origin_costs_nothing() {
    let file = |[x, y]: [f64; 2]| {
        format!(
            "[tables]\ng = {{ values = [[1,1.2,1.6,1.5,1.1],[1.1,2,3.5,2.6,1.3],[1.2,2.8,5,3.9,1.4],\
             [1,2.1,4.2,2.2,1.2],[0.9,1.3,1.9,1.4,1]] }}\n\
             [metric]\ncost = \"g((x1 - {x})/25, (x2 - {y})/25)\"\n[from]\npoint = [{x}, {}]\n\
             [to]\npoint = [{}, {}]\n{NO_BOUNDS}",
            y + 50.0,
            x + 100.0,
            y + 50.0
        )
    };
    let solve = |offset| {
        let question = Question::read(&file(offset)).expect("a file");
        question.solve(&mut |_| ()).expect("solved")
    };
    let (near, far) = (solve([0.0, 0.0]), solve([600_000.0, 4_200_000.0]));
    // 4 200 000 has roundings of 5e-10, and the cost is at most 5.
    assert!(
        (near.length.value - far.length.value).abs() < 1e-6,
        "{:?} {:?}",
        near.length,
        far.length
    );
    assert!(far.search.newton_steps <= 2 * near.search.newton_steps && far.n == near.n);
}
