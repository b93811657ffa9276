//! Values between the nodes of a grid, and the least value.

use paper::grid::{Grid, Lines};

const X: Lines = Lines { from: -1.0, to: 2.0, count: 7 };
const Y: Lines = Lines { from: 0.0, to: 1.0, count: 5 };

fn sampled(f: impl Fn(f64, f64) -> f64) -> Grid {
    let values = Y.all().flat_map(|y| X.all().map(move |x| (x, y))).map(|(x, y)| f(x, y));
    Grid::new(X, Y, values.collect()).expect("complete")
}

#[test]
fn cubics_come_back_exactly_also_beyond_the_edge() {
    let cubic = |x: f64, y: f64| x * x * x - 2.0 * x * y * y + y * y * y - 1.0;
    let grid = sampled(cubic);
    for (x, y) in [(0.5, 0.5), (-0.93, 0.07), (1.99, 0.6), (2.05, -0.02), (-1.0, 1.0)] {
        assert!((grid.at(x, y) - cubic(x, y)).abs() <= 1e-13, "({x}, {y})");
    }
}

#[test]
fn the_least_value_is_found_where_it_is() {
    let (place, value) = sampled(|x, y| (x - 0.5).abs() + (y - 0.75).abs()).least();
    assert_eq!((place, value), ((0.5, 0.75), 0.0));
}

#[test]
fn an_incomplete_grid_is_refused() {
    assert!(Grid::new(X, Y, vec![0.0; 34]).is_err());
    assert!(Grid::new(X, Y, vec![f64::NAN; 35]).is_err());
}
