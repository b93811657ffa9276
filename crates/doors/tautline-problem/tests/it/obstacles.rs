//! Regions that no curve enters.

use tautline_problem::{Failure, Question};

const FILE: &str = "\
[metric]
phi = 1
[obstacles]
margin = 0.003
regions = [{ ball = { centre = [0, 0], radius = 1 } }]
[from]
point = [-3, 0.1]
[to]
point = [3, -0.1]
[certify]
bound = false
";

/// Returns the length of the curve, and its points.
fn solved(file: &str) -> (f64, Vec<Vec<f64>>) {
    let answer = Question::read(file).expect(file).solve(&mut |_| ()).expect(file);
    assert!(answer.search.converged && answer.resolved, "{file}");
    (answer.length.value, answer.curve)
}

/// The shortest way round a disc: two tangents and an arc.
fn round_the_disc([x, y]: [f64; 2]) -> f64 {
    // The ends are opposite each other, at the distance r from the centre.
    let r = x.hypot(y);
    2.0 * (r * r - 1.0).sqrt() + std::f64::consts::PI - 2.0 * (1.0 / r).acos()
}

#[test]
fn a_curve_goes_round_a_ball_and_its_length_falls_to_the_shortest_with_the_margin() {
    let shortest = round_the_disc([3.0, 0.1]);
    let mut last = f64::INFINITY;
    for margin in [0.1_f64, 0.03, 0.01, 0.003] {
        let file = FILE.replace("margin = 0.003", &format!("margin = {margin}"));
        let (length, curve) = solved(&file);
        assert!(curve.iter().all(|x| x[0].hypot(x[1]) > 1.0));
        assert!(length > shortest && length < last, "{length} of {shortest}, before {last}");
        // At the distance δ from the ball the way is longer by δ, and each unit of it costs (m/δ)²/2
        // more. Over an arc of an angle of 2.5 the sum is least, (3/2)(2.5 m²)^{1/3}, at δ³ = 2.5 m².
        let most = shortest + 4.0 * (2.5 * margin * margin).cbrt();
        assert!(length < most, "margin {margin}: {length} is more than {most}");
        last = length;
    }
}

#[test]
fn a_half_space_and_an_expression_are_obstacles_too() {
    // Below x₂ = −1/2 nothing is free, so that the way above the ball is taken.
    let file = FILE.replace(
        "radius = 1 } }",
        "radius = 1 } }, { half_space = { normal = [0, -2], at_least = 1 } }",
    );
    let (above, curve) = solved(&file);
    assert!(curve.iter().any(|x| x[1] > 1.0) && above < 6.5);
    let expression = "{ negative = \"sqrt(r2) - 1\" }";
    let file = FILE.replace("{ ball = { centre = [0, 0], radius = 1 } }", expression);
    let defined = format!("[let]\nr2 = \"x1^2 + x2^2\"\n{file}");
    let (length, ball) = (solved(&defined).0, solved(FILE).0);
    // They are the same metric, but for rounding.
    assert!((length - ball).abs() < 1e-9, "{length}, {ball}");
}

#[test]
fn what_is_wrong_with_obstacles_is_underlined() {
    for (from, to, underlined, says) in [
        ("[-3, 0.1]", "[0.5, 0.1]", "[0.5, 0.1]", "the point [0.5, 0.1] is in an obstacle"),
        ("[3, -0.1]", "[0.0, 1.0]", "[0.0, 1.0]", "the point [0.0, 1.0] is in an obstacle"),
        // A wall from side to side.
        (
            "{ ball = { centre = [0, 0], radius = 1 } }",
            "{ negative = \"x1^2 - 1\" }",
            "[{ negative",
            "every search runs into an obstacle",
        ),
        ("radius = 1", "radius = 0", "0", "an obstacle without inside"),
        ("radius = 1", "radius = -1", "-1", "an obstacle without inside"),
        ("margin = 0.003", "margin = 0", "0", "0 is out of range"),
        ("margin = 0.003\n", "", "[obstacles]", "margin is missing"),
        ("[0, 0]", "[0, 0, 0]", "[0, 0, 0]", "3 coordinates in dimension 2"),
        ("ball = { centre = [0, 0], radius = 1 }", "negative = \"y\"", "y", "unknown name y"),
        ("ball = {", "cube = {", "cube", "unknown key cube"),
        // The names of the distances in the factor are those of no other text.
        ("phi = 1", "phi = \"obstacle1\"", "obstacle1", "unknown name obstacle1"),
        ("phi = 1", "phi = \"u1\"", "u1", "unknown name u1"),
        ("regions = [", "regions = [{ negative = \"u2\" }, ", "u2", "unknown name u2"),
        ("} }]", "} }, { negative = \"u1\" }]", "u1", "unknown name u1"),
    ] {
        let file = FILE.replace(from, to);
        let solved =
            Question::read(&file).map_err(Failure::from).and_then(|q| q.solve(&mut |_| ()));
        let Err(Failure::BadInput(diagnostic)) = solved else { panic!("{file}: {solved:?}") };
        let said = diagnostic.to_string();
        assert!(file[diagnostic.at.clone()].starts_with(underlined), "{file}: {diagnostic:?}");
        assert!(said.contains(says), "{file}: {said}");
    }
}

/// A formula that is undefined for another reason is not blamed on the obstacles.
#[test]
fn another_defect_of_the_metric_is_not_that_of_an_obstacle() {
    let file = FILE.replace("phi = 1", "phi = \"sqrt(x2 + 0.05)\"");
    let failure = Question::read(&file).expect("a file").solve(&mut |_| ()).expect_err("no metric");
    assert!(!failure.to_string().contains("obstacle"), "{failure}");
}

/// A definition may have any name, also one that the factor of the obstacles uses.
#[test]
fn definitions_do_not_meet_the_names_of_obstacles() {
    let expected = solved(FILE);
    for name in ["u1", "obstacle1"] {
        let file = format!("[let]\n{name} = \"1 + 0*x1\"\n{FILE}")
            .replace("phi = 1", &format!("phi = \"{name}\""));
        let (length, curve) = solved(&file);
        assert!((length - expected.0).abs() < 1e-12 && curve.len() == expected.1.len(), "{name}");
        let file = FILE.replace("phi = 1", &format!("formula = \"{name} = 1; {name} I\""));
        assert!((solved(&file).0 - expected.0).abs() < 1e-12, "{name}");
    }
}

/// A pillar and a wall that are thinner than a chord, and a set that a pillar overlaps. Every automatic search
/// runs into them.
#[test]
fn the_way_round_a_thin_obstacle_is_found() {
    let file = |regions: &str, from: &str, to: &str| {
        format!(
            "[metric]\nphi = 1\n[obstacles]\nmargin = 0.0001\nregions = [{{ {regions} }}]\n\
             [from]\n{from}\n[to]\n{to}\n[certify]\nbound = false\n"
        )
    };
    let pillar =
        file("ball = { centre = [0, 0], radius = 0.005 }", "point = [-3, 0]", "point = [3, 0]");
    let (length, curve) = solved(&pillar);
    // 2 √(9 + r²), to a millionth.
    assert!((6.0..6.0001).contains(&length), "{length}");
    let beside = curve.iter().map(|x| x[0].hypot(x[1])).fold(f64::INFINITY, f64::min);
    assert!(beside > 0.005, "{beside}");
    let wall = "negative = \"(x1/0.002)^2 + exp(20*(x2 - 2)) - 1\"";
    let wall = file(wall, "point = [-2, 0]", "point = [2, 0]");
    let (length, _) = solved(&wall);
    // Round the point (0, 2): 2 √8.
    let error = length / (2.0 * 8.0_f64.sqrt()) - 1.0;
    assert!((-1e-9..1e-4).contains(&error), "{length}");
    let pillar = "ball = { centre = [1, 0], radius = 0.7 }";
    let overlapped = file(pillar, "ball = { centre = [0, 0], radius = 1 }", "point = [4, 0]");
    let (length, curve) = solved(&overlapped);
    let start = curve.first().expect("points");
    assert!(start[0].hypot(start[1]) <= 1.0 + 1e-12 && (start[0] - 1.0).hypot(start[1]) > 0.7);
    // From where the circles meet along the pillar, and from there on along the tangent of length √(9 − 0.7²).
    let angle = (0.245_f64 / 0.7).asin() + std::f64::consts::FRAC_PI_2 - (0.7_f64 / 3.0).acos();
    let exact = 0.7 * angle + (9.0_f64 - 0.49).sqrt();
    assert!((0.0..1e-3).contains(&(length / exact - 1.0)), "{length} {exact} {start:?}");
    // In space too.
    let space = "ball = { centre = [0, 0, 0], radius = 0.01 }";
    let (length, _) = solved(&file(space, "point = [-3, 0.002, 0]", "point = [3, 0.002, 0.001]"));
    assert!((6.0..6.001).contains(&length), "{length}");
}

/// Round a square: two sides of √2 and one of 2. The edges are rounded by a part of the margin, within which
/// the repulsion costs more.
#[test]
fn a_box_is_an_obstacle() {
    let exact = 2.0 + 2.0 * 2.0_f64.sqrt();
    let mut last = f64::INFINITY;
    for margin in [0.01_f64, 0.001, 0.0001] {
        let file = format!(
            "[metric]\nphi = 1\n[obstacles]\nmargin = {margin}\n\
             regions = [{{ box = {{ lower = [-1, -1], upper = [1, 1] }} }}]\n\
             [from]\npoint = [-2, 0]\n[to]\npoint = [2, 0]\n[solve]\nn = 2048\n[certify]\nbound = false\n"
        );
        let (length, curve) = solved(&file);
        assert!(curve.iter().all(|x| x[0].abs() > 1.0 || x[1].abs() > 1.0), "{margin}");
        assert!(exact < length && length < last, "{margin}: {length}");
        // At the distance δ along a side of length 2 the way is longer by at most 2 δ, and by (m/δ)².
        assert!(length < exact + 6.0 * (margin * margin).cbrt(), "{margin}: {length}");
        last = length;
    }
}
