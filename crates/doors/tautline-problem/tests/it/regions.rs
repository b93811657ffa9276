//! Where the constants of a metric hold.

use tautline_problem::Question;

/// Returns the region of the constants of a file, and the bounds on c2.
fn constants(metric: &str, certify: &str) -> (String, [f64; 2]) {
    let file = format!("dimension = 2\nmetric = {{ phi = \"{metric}\" }}\n[certify]\n{certify}\n");
    let found = Question::read(&file).expect("a file").constants().expect("sought");
    let c2 = found.constants.iter().find(|constant| constant.name == "c2").expect("c2");
    let bound = |bound: &Option<tautline_problem::Float>| bound.as_ref().expect("finite").value;
    assert!(c2.proved, "{metric}: {c2:?}");
    (found.region, [bound(&c2.lower), bound(&c2.upper)])
}

/// Of a metric with rational parts nothing is known far out. That it settles is assumed, and said; of the
/// others it is not.
#[test]
fn the_region_of_constants_is_where_they_are_proved() {
    let settles = "all of space, if the metric settles within a distance of 2^100";
    let ball = "within = { ball = { centre = [1, 0], radius = 0.5 } }";
    let corners = "within = { box = { lower = [-1, 0], upper = [0.5, 1] } }";
    let of_ball = "the ball of radius 0.5 about [1.0, 0.0]";
    let of_box = "the box from [-1.0, 0.0] to [0.5, 1.0]";
    let rational = "1 + 1/(1 + x1^2 + x2^2)";
    for (metric, certify, region, c2) in [
        ("2 - cos(x1)", "", "all of space", 3.0),
        ("1 + exp(-x1^2 - x2^2)", "", "all of space", 2.0),
        (rational, "", settles, 2.0),
        (rational, ball, of_ball, 1.8),
        (rational, corners, of_box, 2.0),
        ("2 - cos(x1)", ball, of_ball, 2.0 - 1.5_f64.cos()),
        ("1 + x1^2 + x2^2", ball, of_ball, 3.25),
        ("1 + x1^2 + x2^2", corners, of_box, 3.0),
    ] {
        let (found, [lower, upper]) = constants(metric, certify);
        assert_eq!(found, region, "{metric}, {certify}");
        // The accuracy is a thousandth; a decimal of c2 is off by far less than 10⁻¹².
        let (least, most) = (c2 * (1.0 - 1e-12), c2 * (1.0 + 1e-12));
        assert!(lower <= most && least <= upper, "{metric}, {certify}: {lower} {c2} {upper}");
        assert!(upper - lower <= 2e-3 * c2, "{metric}, {certify}: {lower} {upper}");
    }
}

/// The claims hold around the straight way, of length 6. By a valley beyond them the way is shorter: 2, and
/// 6 at a cost of a third. Bounds by the claims as if they held there exclude it.
#[test]
fn claims_in_a_region_bound_no_curve_that_leaves_it() {
    let solved = |certify: &str| {
        let file = format!(
            "metric = {{ phi = \"1 - 0.9*exp(-((x2 - 1)/0.2)^2)\" }}\nfrom = {{ point = [-3, 0] }}\n\
             to = {{ point = [3, 0] }}\n[solve]\nonly_these_starts = true\n\
             starts = [[[-3, 0], [3, 0]]]\n[certify]\n{certify}\n"
        );
        Question::read(&file).expect("a file").solve(&mut |_| ()).expect("a curve")
    };
    let claims = "constants = { c1 = 0.999, c2 = 1, l_h = 1e-3, m_h = 1 }";
    for within in [
        "within = { box = { lower = [-4, -0.1], upper = [4, 0.1] } }",
        "within = { ball = { centre = [0, 0], radius = 0.5 } }",
    ] {
        let answer = solved(&format!("{claims}\n{within}"));
        assert_eq!(answer.bounds, None);
        let reason = answer.no_bounds.expect("a reason");
        assert!(reason.contains("claimed in the region of `within`"), "{reason}");
    }
    // As claims on all of space they are used, and are wrong; the region alone changes nothing.
    let bounds = solved(claims).bounds.expect("claimed");
    assert!(bounds.lower.value > 5.9, "{bounds:?}");
    let proved = solved("within = { ball = { centre = [0, 0], radius = 0.5 } }").bounds;
    assert!(proved.is_some_and(|bounds| !bounds.rests_on_claims() && bounds.lower.value < 3.9));
}
