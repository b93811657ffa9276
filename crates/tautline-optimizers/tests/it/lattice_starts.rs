//! A search on the grid itself, from a shortest path along a lattice.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{PointSequence, Trapezoidal};
use tautline_formula::Prepared;
use tautline_lattice::{Lattice, graph_path};
use tautline_metrics::{Metric, Scalar};
use tautline_optimizers::{Options, Starts, minimise};
use tautline_sets::Ends;

/// The cost 1, and about 100 on a wall along `x₁ = 0` with a gap at `x₂ = 3`.
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
        let minimum = minimise(&Wall, &ends, Trapezoidal, 600, &options).expect("a minimum");
        assert!(minimum.is_local_minimum());
        (minimum.energy, crosses(&minimum.sequence))
    };
    let (automatic, _) = energy(Starts::Automatic);
    let (found, crossing) = energy(Starts::OnTheGrid(vec![path.clone()]));
    assert!((crossing - 3.0).abs() < 0.3 && found < 0.2 * automatic, "{found}, {automatic}");
    // √40 is the length of the way round the end of the gap, without the wall.
    assert!((6.0_f64.powi(2)..7.2_f64.powi(2)).contains(&found), "{found}");
}
