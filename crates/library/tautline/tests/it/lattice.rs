//! Searches that also start from a shortest path along a lattice.

use tautline::{
    Ends, GraphPathError, Lattice, Metric, Nodes, Options, PointSequence, Prepared, Problem,
    Request, RequestError, Rule, SMatrix, SVector, Scalar, SolveError, Starts, TautLine,
    gallery::{Obstacle, SoftObstacles},
    graph_path, minimise,
};

/// The cost 1, and about 100 on a wall along `x₁ = 0` with a gap at `x₂ = 3`.
#[derive(Debug)]
struct Wall;

impl Metric<2> for Wall {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let wall = (-(x[0] / 0.1).sqr()).exp();
        let gap = (-((x[1] - 3.0) / 0.3).sqr()).exp();
        SMatrix::from_diagonal_element((wall * (-gap + 1.0) * 100.0 + 1.0).sqr())
    }
}

/// The straight line costs about 20. The automatic starts bend by less than the wall is long.
#[test]
fn a_path_leads_through_the_gap_and_a_search_on_the_grid_stays_there() {
    let ends = Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite");
    let lattice = Lattice::new([-2.0, -1.0], [2.0, 4.0], 0.05).expect("a lattice");
    let path = graph_path(&Prepared::new(&Wall), &ends, &lattice, 600).expect("a path");
    let crosses = |path: &PointSequence<2>| {
        let crossing = path.points().windows(2).find(|pair| pair[0][0] <= 0.0 && pair[1][0] > 0.0);
        crossing.expect("a crossing")[0][1]
    };
    assert!((crosses(&path) - 3.0).abs() < 0.3, "{}", crosses(&path));
    let energy = |starts| {
        let options = Options { starts, ..Options::default() };
        let minimum = minimise(&Wall, &ends, Rule::TRAPEZOIDAL, 600, &options).expect("a minimum");
        assert!(minimum.is_local_minimum());
        (minimum.energy, crosses(&minimum.sequence))
    };
    let (automatic, _) = energy(Starts::Automatic);
    let (found, crossing) = energy(Starts::OnTheGrid(vec![path.clone()]));
    assert!((crossing - 3.0).abs() < 0.3 && found < 0.2 * automatic, "{found}, {automatic}");
    // √40 is the length of the way round the end of the gap, without the wall.
    assert!((6.0_f64.powi(2)..7.2_f64.powi(2)).contains(&found), "{found}");
}

/// Returns the energy on a finer grid, from the same line.
fn on_a_grid_of(n: usize, problem: &Problem<Wall, 2>, line: &TautLine<Wall, 2>) -> f64 {
    let starts = Starts::OnTheGrid(vec![line.sequence().clone()]);
    let options = Options { starts, ..Options::default() };
    problem.solve_with(Rule::TRAPEZOIDAL, n, &options).expect("a line").discrete_energy()
}

/// Asks for a search with `n` chords that also starts from paths along a lattice.
fn along(nodes: Nodes, n: usize) -> Request {
    Request { lattice: Some(nodes), ..Request::chords(n) }
}

#[test]
fn the_shorter_of_both_lines_is_returned() {
    let problem = Problem::new(Wall, Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite"));
    let automatic = problem.solve(Rule::TRAPEZOIDAL, 512).expect("a line").length().value;
    let on = |lower: [f64; 2], upper: [f64; 2], spacing| {
        problem.answer(&along(Nodes::new(lower, upper, spacing), 512))
    };
    // √40 is the way to the gap and back, without the wall.
    let found = on([-2.0, -1.0], [2.0, 4.0], 0.05).expect("a line");
    assert!((6.3..7.0).contains(&found.length().value) && automatic > 15.0);
    // The line through the wall is another minimum.
    let others = found.other_minima();
    let through = others.iter().map(|other| other.length().value);
    assert!(through.clone().any(|length| (length - automatic).abs() < 1e-9 * automatic));
    // The limit of 128, 256 and 512 chords; that of 2048 chords is off by 1/15 of what is between it and
    // 512, as errors fall with the square.
    let levels: Vec<usize> = found.minimum().levels.iter().map(|level| level.n).collect();
    assert_eq!(levels, [128, 256, 512]);
    let estimate = found.distance_squared_estimate().expect("three grids");
    let fine = on_a_grid_of(2048, &problem, &found);
    let off = (found.discrete_energy() - fine).abs() / 15.0;
    assert!((estimate.value - fine).abs() <= estimate.error + off, "{estimate:?} beside {fine}");
    assert!(estimate.error < off, "{estimate:?} beside {off:e}");
    // Both searches took steps, and the grids for the extrapolation.
    let first = problem.solve(Rule::TRAPEZOIDAL, 512).expect("a line");
    assert!(
        found.minimum().iterations > first.minimum().iterations + found.minimum().own_iterations
    );
    assert_eq!(found.minimum().local_minima, first.minimum().local_minima);
    // A lattice that does not reach the gap finds nothing better.
    let low = on([-2.0, -1.0], [2.0, 1.0], 0.05).expect("a line").length().value;
    assert!(low <= automatic && low > 15.0, "{low} beside {automatic}");
    for n in [0, usize::MAX] {
        let refused = problem.answer(&along(Nodes::new([-2.0, -1.0], [2.0, 4.0], 0.5), n));
        assert_eq!(
            refused.expect_err("no grid"),
            problem.solve(Rule::TRAPEZOIDAL, n).expect_err("no grid").into()
        );
    }
    let far = on([4.0, 4.0], [5.0, 5.0], 0.1).expect_err("no path");
    assert_eq!(far, RequestError::Lattice(GraphPathError::FarFromEnd { end: "first" }));
}

/// No metric in the disc: a factor that repels, and a logarithm that is undefined inside.
#[derive(Debug)]
struct Disc;

impl Metric<2> for Disc {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let from_it = (x[0].sqr() + x[1].sqr()).sqrt() - 1.0;
        let repelled = (from_it.recip() * 0.1).sqr() + from_it.ln() * 0.0 + 1.0;
        SMatrix::from_diagonal_element(repelled)
    }
}

/// The straight line is not in the domain of the metric.
#[test]
fn a_path_along_the_lattice_is_enough() {
    let problem = Problem::new(Disc, Ends::points([-3.0, 0.1], [3.0, -0.1]).expect("finite"));
    let straight = PointSequence::straight([-3.0, 0.1], [3.0, -0.1], 64).expect("finite");
    let options = Options { starts: Starts::Only(vec![straight.clone()]), ..Options::default() };
    let alone = problem.solve_with(Rule::TRAPEZOIDAL, 512, &options);
    assert!(matches!(alone, Err(SolveError::Metric(_))), "{alone:?}");
    let request = Request {
        starts: vec![straight.points().iter().map(|x| x.as_slice().to_vec()).collect()],
        only_these_starts: true,
        ..along(Nodes::new([-3.5, -2.0], [3.5, 2.0], 0.1), 512)
    };
    let line = problem.answer(&request).expect("a line");
    // Two tangents and an arc are 6.34 long.
    assert!((6.34..7.5).contains(&line.length().value), "{}", line.length().value);
    assert!(line.distance_squared_estimate().is_some() && line.minimum().levels.len() == 3);
}

/// If the line from the path is the longer one, it is another minimum, with all of its turns.
#[test]
fn the_longer_line_is_another_minimum() {
    let problem = Problem::new(Wall, Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite"));
    let through_the_gap = [[-1.0, 0.0], [0.0, 3.0], [1.0, 0.0]].map(|x| x.to_vec()).to_vec();
    // The lattice ends below the gap.
    let request = Request {
        starts: vec![through_the_gap],
        only_these_starts: true,
        ..along(Nodes::new([-2.0, -1.0], [2.0, 1.0], 0.05), 512)
    };
    let line = problem.answer(&request).expect("a line");
    assert!((6.3..7.0).contains(&line.length().value));
    let others = line.other_minima();
    let [other] = &others[..] else { panic!("{} others", others.len()) };
    assert!(other.length().value > 15.0 && other.minimum().is_local_minimum());
}

/// Three hills in a row have four ways past them. Whichever of them the first search is led to, the shortest is
/// the line, and the three others are its other minima, lowest first.
#[test]
fn the_other_minima_of_both_searches_are_in_their_order() {
    let hill = |y: f64| Obstacle { centre: [0.0, y].into(), height: 20.0, width: 0.2 };
    let hills = SoftObstacles::new([-1.0, 0.1, 1.3].map(hill).to_vec()).expect("hills");
    let (a, b) = ([-2.0, 0.0], [2.0, 0.1]);
    let problem = Problem::new(hills, Ends::points(a, b).expect("finite"));
    let nodes = Nodes { classes: 4, ..Nodes::new([-2.2, -2.0], [2.2, 2.2], 0.1) };
    let mut known: Option<Vec<f64>> = None;
    for through in [-1.6, -0.45, 0.7, 1.9] {
        let request = Request {
            starts: vec![[a, [0.0, through], b].map(|x| x.to_vec()).to_vec()],
            only_these_starts: true,
            ..along(nodes.clone(), 64)
        };
        let line = problem.answer(&request).expect("a line");
        let others = line.minimum().others.iter().map(|other| other.energy);
        let energies: Vec<f64> = std::iter::once(line.discrete_energy()).chain(others).collect();
        assert_eq!(energies.len(), 4, "{through}");
        assert!(energies.is_sorted(), "{through}: {energies:?}");
        let known = known.get_or_insert(energies.clone());
        for (energy, known) in energies.iter().zip(known) {
            // The same minimum from another start, to the floor of rounding.
            assert!((energy / *known - 1.0).abs() < 1e-11, "{through}: {energy} {known}");
        }
    }
}
