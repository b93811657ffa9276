//! Searches that look beyond what their starts led to.

use tautline::{
    Ends, Formula, KnownDistance, Options, Problem, Request, Rule, SVector, Scope, Starts,
    TautLine, are_apart,
    gallery::{Obstacle, SoftObstacles, Sphere, Valleys},
};
use tautline_chance::{Random, seed};

/// Seven hills: every start leads above the two on the left, where the shortest way leads below them.
fn hills() -> Problem<SoftObstacles<2>, 2> {
    let hill = |[x, y, height, width]: [f64; 4]| Obstacle { centre: [x, y].into(), height, width };
    let hills = [
        [-1.05, -0.27, 29.1, 0.152],
        [-0.96, -0.28, 7.43, 0.114],
        [0.04, 0.10, 5.02, 0.173],
        [-0.34, 0.52, 23.8, 0.235],
        [0.81, -1.12, 9.52, 0.321],
        [-0.99, -0.77, 8.63, 0.160],
        [-1.16, 0.93, 22.7, 0.133],
    ];
    let ends = Ends::points([-1.8, -0.712], [1.8, 0.731]).expect("finite");
    Problem::new(SoftObstacles::new(hills.map(hill).to_vec()).expect("hills"), ends)
}

fn local() -> Options<2> {
    Options { scope: Scope::Local, ..Options::default() }
}

/// The local search misses a curve that is shorter by 7 %: the energies differ by a sixth. What it found is
/// among the other minima, and the line has coarser grids of its own for the extrapolation.
#[test]
fn a_path_through_the_hills_leads_to_a_shorter_line() {
    let problem = hills();
    for rule in [Rule::TRAPEZOIDAL, Rule::LEFT_ENDPOINT] {
        for n in [64, 256, 1000] {
            let near = problem.solve_with(rule, n, &local()).expect("a line");
            let line = problem.solve(rule, n).expect("a line");
            let [long, short] = [&near, &line].map(|line| line.length().value);
            println!("{rule:?} {n}: {long} {short}");
            assert!(short < 0.95 * long, "{rule:?}, N = {n}: {short} {long}");
            assert!(line.minimum().is_local_minimum() && line.is_resolved());
            assert_eq!(line.sequence().n().get(), n);
            let is_near = |other: &TautLine<_, 2>| !are_apart(other.sequence(), near.sequence());
            assert!(line.other_minima().iter().any(is_near), "{rule:?}, N = {n}");
            let estimate = line.distance_squared_estimate().expect("several grids");
            assert!((estimate.value.sqrt() / short - 1.0).abs() < 1e-2);
        }
    }
}

/// Two walls with gaps on opposite sides: the shortest way winds through both.
fn walls<const D: usize>() -> Formula<D> {
    let wall = |x: f64, gap: f64| {
        format!("30*exp(-((x1 - ({x}))/0.3)^2)*(1 - exp(-((x2 - ({gap}))/0.5)^2))")
    };
    let text = format!("cost(1 + {} + {})", wall(-1.0, 1.5), wall(1.0, -1.5));
    Formula::parse(&text, &[]).expect("a formula")
}

/// In space, the third coordinate plays no part: the way is that in the plane.
#[test]
fn a_path_in_space_leads_to_a_shorter_line_too() {
    fn lengths<const D: usize>(n: usize) -> [f64; 2] {
        let point = |x: f64| std::array::from_fn::<_, D, _>(|i| if i == 0 { x } else { 0.0 });
        let ends = Ends::points(point(-2.5), point(2.5)).expect("finite");
        let problem = Problem::new(walls::<D>(), ends);
        [Scope::Local, Scope::Automatic].map(|scope| {
            let options = Options { scope, ..Options::default() };
            let line = problem.solve_with(Rule::TRAPEZOIDAL, n, &options).expect("a line");
            line.length().value
        })
    }
    for n in [32, 128] {
        let (plane, space) = (lengths::<2>(n), lengths::<3>(n));
        println!("{plane:?} {space:?}");
        assert!(plane[1] < 0.5 * plane[0] && space[1] < 0.5 * space[0], "{plane:?} {space:?}");
        // Both are minima of the same energy, found to rounding.
        assert!((space[1] / plane[1] - 1.0).abs() < 1e-9, "{plane:?} {space:?}");
    }
}

/// From a given start there is one line, and with few chords none would be resolved.
#[test]
fn given_starts_and_few_chords_keep_the_search_near() {
    let problem = hills();
    let near = problem.solve_with(Rule::TRAPEZOIDAL, 64, &local()).expect("a line");
    let start = vec![near.sequence().clone()];
    for starts in [Starts::Only(start.clone()), Starts::OnTheGrid(start.clone())] {
        let options = Options { starts, ..Options::default() };
        let line = problem.solve_with(Rule::TRAPEZOIDAL, 64, &options).expect("a line");
        assert!(!are_apart(line.sequence(), near.sequence()));
    }
    let options = Options { starts: Starts::Also(start), ..Options::default() };
    let line = problem.solve_with(Rule::TRAPEZOIDAL, 64, &options).expect("a line");
    assert!(are_apart(line.sequence(), near.sequence()));
    for n in [8, 15] {
        let [near, line] = [local(), Options::default()]
            .map(|options| problem.solve_with(Rule::TRAPEZOIDAL, n, &options).expect("a line"));
        assert_eq!(line.minimum(), near.minimum(), "N = {n}");
    }
}

/// Where the path runs along the line, or leads to nothing shorter, the result has the same bits.
#[test]
fn a_look_that_finds_nothing_leaves_the_line_as_it_is() {
    let problem = Problem::new(Valleys, Ends::points([0.0, 0.0], [12.0, 0.5]).expect("finite"));
    for n in [16, 64, 300] {
        let [near, line] = [local(), Options::default()]
            .map(|options| problem.solve_with(Rule::TRAPEZOIDAL, n, &options).expect("a line"));
        assert_eq!(line.minimum(), near.minimum(), "N = {n}");
    }
}

/// Lines of a few roundings would have a lattice of millions of nodes, far from the origin: they have none.
#[test]
fn a_line_of_a_few_roundings_is_not_looked_around() {
    for far in [1.0, 50.0, 1e6] {
        let ends = Ends::points([1.0, far], [1.0_f64.next_up(), far]).expect("finite");
        let problem = Problem::new(Valleys, ends);
        let [near, line] = [local(), Options::default()]
            .map(|options| problem.solve_with(Rule::TRAPEZOIDAL, 64, &options).expect("a line"));
        assert_eq!(line.minimum(), near.minimum(), "{far}");
    }
}

/// Far points of the stereographic plane are near to each other, so that a curve that runs away to 10⁵⁴ and back
/// has little energy by the rule, and by the first nodes of a quadrature a length below the distance. 400 pairs
/// are as far apart as on the sphere.
#[test]
fn no_pair_on_the_sphere_is_closer_than_its_angle() {
    let mut random = Random(seed(400));
    for case in 0..400 {
        let mut point =
            || -> SVector<f64, 2> { [random.between(-2.0, 2.0), random.between(-2.0, 2.0)].into() };
        // The pair that was seen to run away is the first.
        let [a, b]: [SVector<f64, 2>; 2] = match case {
            0 => [[-0.947_295_75, -1.439_118_09].into(), [1.876_028_89, 1.492_029_39].into()],
            _ => [point(), point()],
        };
        let exact = Sphere.distance(&a, &b).expect("known");
        let problem = Problem::new(Sphere, Ends::points(a, b).expect("finite"));
        let line = problem.answer(&Request::chords(256)).expect("solved");
        let length = line.length();
        let error = length.value / exact - 1.0;
        assert!((-1e-13..1e-3).contains(&error), "{a} {b}: {length:?} of {exact}");
    }
    // Few chords leave some of the curves far out. Their errors say so.
    for n in [2, 8, 12, 16, 17, 33, 64] {
        for _ in 0..40 {
            let a: SVector<f64, 2> = [random.between(-2.0, 2.0), random.between(-2.0, 2.0)].into();
            // Nearly opposite each other.
            let b = -a / a.norm_squared() * random.between(0.9, 1.1);
            let exact = Sphere.distance(&a, &b).expect("known");
            let problem = Problem::new(Sphere, Ends::points(a, b).expect("finite"));
            let Ok(line) = problem.answer(&Request::chords(n)) else { continue };
            let length = line.length();
            let most = (length.value + length.error) * (1.0 + 1e-13);
            assert!(most >= exact, "{n} {a} {b}: {length:?} of {exact}");
        }
    }
}
