//! Searches that also start from a shortest path along a lattice.

use tautline::{
    Ends, GraphPathError, Lattice, Metric, Options, Problem, SMatrix, SVector, Scalar, SolveError,
    Trapezoidal,
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

#[test]
fn the_shorter_of_both_lines_is_returned() {
    let problem = Problem::new(Wall, Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite"));
    let options = Options::default();
    let automatic = problem.solve(Trapezoidal, 512).expect("a line").length().value;
    let on = |lower: [f64; 2], upper, spacing| {
        let lattice = Lattice::new(lower, upper, spacing).expect("a lattice");
        problem.solve_on_lattice(Trapezoidal, 512, &lattice, &options)
    };
    // √40 is the way to the gap and back, without the wall.
    let found = on([-2.0, -1.0], [2.0, 4.0], 0.05).expect("a line");
    assert!((6.3..7.0).contains(&found.length().value) && automatic > 15.0);
    // A lattice that does not reach the gap finds nothing better.
    let low = on([-2.0, -1.0], [2.0, 1.0], 0.05).expect("a line").length().value;
    assert!(low <= automatic && low > 15.0, "{low} beside {automatic}");
    for n in [0, usize::MAX] {
        let lattice = Lattice::new([-2.0, -1.0], [2.0, 4.0], 0.5).expect("a lattice");
        let refused = problem.solve_on_lattice(Trapezoidal, n, &lattice, &options);
        assert_eq!(
            refused.expect_err("no grid"),
            problem.solve(Trapezoidal, n).expect_err("no grid")
        );
    }
    let far = on([4.0, 4.0], [5.0, 5.0], 0.1).expect_err("no path");
    assert_eq!(far, SolveError::GraphPath(GraphPathError::FarFromEnd { end: "first" }));
}
