//! A problem in a file and the same problem in Rust have the same result, bit by bit.

use tautline::{
    AxisBox, Ball, Ends, FiniteSet, HalfSpace, Metric, Options, PointSequence, Problem, Rule,
    SMatrix, SVector, Scalar, Segment, Starts, Union, gallery,
};
use tautline_problem::{Answer, Example, Question};

/// Solves an example from its file.
fn answer(name: &str, change: impl Fn(String) -> String) -> Answer {
    let example = Example::named(name).unwrap_or_else(|| panic!("no example {name}"));
    let file = change(example.text.to_owned());
    let question = Question::read(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut first = None;
    let answer = question.solve(&mut |answer| first = Some(answer.clone()));
    let answer = answer.unwrap_or_else(|error| panic!("{name}: {error}"));
    // What is told before the bounds is the same curve.
    assert_eq!(first.map(|first| first.curve).as_ref(), Some(&answer.curve), "{name}");
    answer
}

#[track_caller]
fn assert_twins<M: Metric<D>, const D: usize>(
    name: &str,
    metric: M,
    ends: Ends<D>,
    rule: Rule,
    n: usize,
    options: &Options<D>,
) {
    let answer = answer(name, |file| file);
    let line = Problem::new(metric, ends).solve_with(rule, n, options).expect("solved");
    let points: Vec<Vec<f64>> =
        line.sequence().points().iter().map(|x| x.as_slice().to_vec()).collect();
    assert_eq!(answer.curve, points, "{name}");
    let numbers = [
        answer.discrete_energy,
        answer.length.value,
        answer.energy.as_ref().expect("finite").value,
    ];
    let in_rust = [line.discrete_energy(), line.length().value, line.energy().value];
    assert_eq!(numbers.map(f64::to_bits), in_rust.map(f64::to_bits), "{name}");
    if let Some(found) = &answer.extrapolated {
        // An error e of the distance d is an error 2de of its square.
        let square = line.distance_squared_estimate().expect("an estimate");
        let (value, error) = (found.value.powi(2), 2.0 * found.value * found.error);
        // It is no larger than a proved bound, to which rounding may bring it down.
        let upper = answer.bounds.as_ref().map_or(f64::INFINITY, |bounds| bounds.upper.value);
        assert!(found.value <= upper, "{name}: {found:?} {upper}");
        let rounding = if found.value == upper { 1e-9 } else { 1e-15 };
        assert!((value / square.value - 1.0).abs() < rounding, "{name}: {found:?} {square:?}");
        assert!(
            (error - square.error).abs() <= 1e-15 * square.error || found.value == upper,
            "{name}: {found:?} {square:?}"
        );
    }
    assert_eq!(answer.search.residual.to_bits(), line.residual().to_bits(), "{name}");
    assert_eq!(answer.search.newton_steps, line.minimum().iterations, "{name}");
    let others: Vec<_> =
        line.other_minima().iter().map(|other| other.length().value.to_bits()).collect();
    let in_file: Vec<_> =
        answer.other_minima.iter().map(|other| other.length.value.to_bits()).collect();
    assert_eq!(in_file, others, "{name}");
}

macro_rules! formula {
    ($name:ident, $d:literal, |$x:ident| $h:expr) => {
        struct $name;
        impl Metric<$d> for $name {
            fn gram<S: Scalar>(&self, $x: &SVector<S, $d>) -> SMatrix<S, $d, $d> {
                $h
            }
        }
    };
}

formula!(Cost, 2, |x| SMatrix::from_diagonal_element((2.0 - x[0].cos()).sqr()));
formula!(Arm, 2, |x| {
    let off = 1.0 + 0.8 * x[1].cos();
    SMatrix::from_row_slice(&[4.0 + 2.0 * 0.8 * x[1].cos(), off, off, S::constant(1.0)])
});
formula!(Layer, 2, |x| {
    SMatrix::from_diagonal_element(1.0 / (0.8 + 0.2 * (x[1] / 0.05).tanh()).sqr())
});
formula!(Distributions, 2, |x| {
    SMatrix::from_diagonal(&[(-2.0 * x[1]).exp(), S::constant(2.0)].into())
});
formula!(Leaning, 2, |x| {
    let off = -1.0 + 0.3 * x[1].sin();
    SMatrix::from_row_slice(&[S::constant(2.0), off, off, S::constant(2.0)])
});
formula!(Channels, 2, |x| {
    let up = (-((x[1] - 1.0) / 0.5).powi(2) / 2.0).exp();
    let down = (-((x[1] + 0.8) / 0.5).powi(2) / 2.0).exp();
    SMatrix::from_diagonal_element(1.0 + 2.0 * (1.0 - up) * (1.0 - down))
});
formula!(Hill, 2, |x| {
    SMatrix::from_diagonal_element(1.0 + 4.0 * (-(x[0].powi(2) + x[1].powi(2)) / 0.5).exp())
});
formula!(Wide, 12, |x| {
    let square =
        x[0].powi(2) + x[1].powi(2) + x[2].powi(2) + x[3].powi(2) + x[4].powi(2) + x[5].powi(2);
    SMatrix::from_diagonal_element(1.0 + (-square / 2.0).exp())
});

fn points<const D: usize>(a: [f64; D], b: [f64; D]) -> Ends<D> {
    Ends::points(a, b).expect("finite")
}

#[test]
fn a_file_gives_the_bits_of_the_problem_in_rust() {
    let plane = Options::default();
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a ball");
    let wall = HalfSpace::at_least([1.0, 0.0], 3.0).expect("a wall");
    let ends = Ends::new(ball, wall).expect("bounded");
    assert_twins("valleys", Cost, ends, Rule::TRAPEZOIDAL, 256, &plane);
    let half_pi = std::f64::consts::PI / 2.0;
    assert_twins(
        "robot_arm",
        Arm,
        points([0.0, 0.2], [half_pi, 2.4]),
        Rule::TRAPEZOIDAL,
        256,
        &plane,
    );
    assert_twins(
        "refraction",
        Layer,
        points([-1.0, 1.0], [1.0, -1.0]),
        Rule::TRAPEZOIDAL,
        1024,
        &plane,
    );
    let ends = points([0.0, 0.0], [0.25, 0.125]);
    assert_twins("normal_distributions", Distributions, ends, Rule::TRAPEZOIDAL, 512, &plane);
    let obstacle = |x: [f64; 2]| gallery::Obstacle { centre: x.into(), height: 12.0, width: 0.5 };
    let obstacles = [[1.0, 0.2], [2.6, 1.3], [2.9, -0.9], [4.3, 0.3]].map(obstacle);
    let obstacles = gallery::SoftObstacles::<2>::new(obstacles.into()).expect("obstacles");
    assert_twins(
        "obstacles",
        obstacles,
        points([-0.5, 0.0], [5.5, 0.4]),
        Rule::TRAPEZOIDAL,
        256,
        &plane,
    );
    let far: Vec<std::sync::Arc<dyn tautline::ClosedSet<2>>> = vec![
        std::sync::Arc::new(Ball::new([3.0, 2.0], 0.7).expect("a ball")),
        std::sync::Arc::new(Segment::new([-2.0, 2.5], [0.5, 3.0]).expect("a segment")),
        std::sync::Arc::new(FiniteSet::new([[2.5, -1.5], [3.5, -0.5]]).expect("points")),
    ];
    let near = AxisBox::from_corners([-1.0, -1.0], [0.0, 0.0]).expect("a box");
    let ends = Ends::new(near, Union::new(far).expect("sets")).expect("bounded");
    assert_twins("sets", Leaning, ends, Rule::TRAPEZOIDAL, 256, &plane);
    assert_twins(
        "two_channels",
        Channels,
        points([-3.0, 0.0], [3.0, 0.0]),
        Rule::TRAPEZOIDAL,
        256,
        &plane,
    );
    assert_twins("tie", Hill, points([-2.0, 0.0], [2.0, 0.0]), Rule::TRAPEZOIDAL, 256, &plane);
    let start = [[-3.0, 0.0], [0.0, 1.0], [3.0, 0.0]].map(SVector::from);
    let start = PointSequence::new(start.into()).expect("finite");
    let only = Options { starts: Starts::Only(vec![start]), ..Options::default() };
    assert_twins(
        "wrong_start",
        Channels,
        points([-3.0, 0.0], [3.0, 0.0]),
        Rule::TRAPEZOIDAL,
        256,
        &only,
    );
    assert_twins(
        "wrong_constants",
        Cost,
        points([0.0, 0.0], [1.0, 1.0]),
        Rule::TRAPEZOIDAL,
        256,
        &plane,
    );
    let four_pi = 4.0 * std::f64::consts::PI;
    let ends = points([0.0], [four_pi]);
    assert_twins(
        "counterexample",
        gallery::Valleys,
        ends,
        Rule::TRAPEZOIDAL,
        256,
        &Options::default(),
    );
    let mut from = [0.0; 12];
    (from[0], from[1]) = (-2.0, 0.1);
    let mut to = [0.0; 12];
    (to[0], to[6]) = (2.0, 1.0);
    let ball = Ball::new(to, 0.25).expect("a ball");
    let ends = Ends::new(tautline::Point::new(from).expect("finite"), ball).expect("bounded");
    assert_twins("twelve_coordinates", Wide, ends, Rule::TRAPEZOIDAL, 64, &Options::default());
}

/// In Rust, a pullback is written with its derivatives; the values agree up to rounding.
#[test]
fn a_pullback_measures_the_image_of_the_map() {
    let answer = answer("decoder", |file| file);
    let image = |x: &[f64]| {
        let h1 = (1.2 * x[0] - 0.5 * x[1] + 0.3).tanh();
        let h2 = (0.4 * x[0] + 1.1 * x[1]).tanh();
        let h3 = (x[0] - x[1] - 0.5).tanh();
        SVector::from([x[0] + h1, x[1] + h2, h1 - 2.0 * h3, h2 * h3])
    };
    // The image of the curve as a polygon is shorter, by O(N⁻²).
    let length: f64 =
        answer.curve.windows(2).map(|pair| (image(&pair[1]) - image(&pair[0])).norm()).sum();
    let relative = answer.length.value / length - 1.0;
    assert!((0.0..1e-3).contains(&relative), "{relative}");
}

#[test]
fn a_file_chooses_rule_and_tolerance() {
    let solve_example = |name, section: &'static str| {
        answer(name, move |file| format!("{file}\n[solve]\n{section}\n"))
    };
    let solve = |section| solve_example("counterexample", section);
    let left = solve("rule = \"left_endpoint\"\nn = 100");
    let ends = points([0.0], [4.0 * std::f64::consts::PI]);
    let line =
        Problem::new(gallery::Valleys, ends).solve(Rule::LEFT_ENDPOINT, 100).expect("solved");
    assert_eq!(left.discrete_energy.to_bits(), line.discrete_energy().to_bits());
    // On this curve the error is 3·10⁻⁶ for 256 chords, and falls like N⁻².
    let fine = solve_example("two_channels", "tolerance = 1e-7");
    let d = fine.extrapolated.expect("several grids").value;
    let error = fine.length.value / d - 1.0;
    assert!((1e-8..1e-7).contains(&error) && fine.n > 256, "{} chords: {error}", fine.n);
    // By c1 = 2 two points that are √2 apart have a distance of 2, but the curve is shorter.
    let wrong = answer("wrong_constants", |file| file.replace("c1 = 1", "c1 = 2"));
    let reason = wrong.no_bounds.expect("a contradiction");
    assert!(wrong.bounds.is_none() && reason.contains("the claim c1 = 2 is wrong"), "{reason}");
    // All rules have a curve. The theorems are about those of the paper.
    for rule in Rule::ALL {
        let answer = answer("counterexample", |file| {
            format!("{file}\n[solve]\nrule = \"{rule}\"\nn = 100\n")
        });
        assert_eq!((answer.rule, answer.n), (rule.name(), 100));
        // A certificate takes the place of a theorem.
        let bounds = answer.bounds.expect("bounds");
        assert_eq!(bounds.constants.is_some(), rule.paper_rule().is_ok(), "{rule}");
        assert!(rule.paper_rule().is_ok() || bounds.lower_by == "a certificate", "{rule}");
    }
}
