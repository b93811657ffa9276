//! What each way to write a metric means: its matrix at a point, entry by entry.

use tautline::{Metric, SMatrix, SVector};
use tautline_problem::Question;

/// Returns `H(x)` of a file that begins with these lines.
fn gram<const D: usize>(lines: &str, x: [f64; D]) -> SMatrix<f64, D, D> {
    let file = format!("dimension = {D}\n{lines}\n");
    let question = Question::read(&file).unwrap_or_else(|error| panic!("{file}: {error}"));
    let formula = question.formula::<D>().unwrap_or_else(|error| panic!("{file}: {error}"));
    formula.gram(&SVector::from(x))
}

/// The half on and above the diagonal is the matrix.
fn assert_is<const D: usize>(lines: &str, x: [f64; D], expected: [[f64; D]; D]) {
    let found = gram(lines, x);
    for i in 0..D {
        for j in i..D {
            let (entry, expected) = (found[(i, j)], expected[i][j]);
            assert!((entry - expected).abs() < 1e-14, "{lines} at {i} {j}: {entry}, {expected}");
        }
    }
}

/// Small whole numbers and halves, so that each entry is known.
#[test]
fn each_form_of_a_metric_in_the_plane_is_its_matrix() {
    for (metric, expected) in [
        ("matrix = [[\"1 + x1^2\", \"x1*x2\"], [\"x1*x2\", 4]]", [[1.25, 1.0], [1.0, 4.0]]),
        ("upper = [[\"1 + x1^2\", \"x1*x2\"], [4]]", [[1.25, 1.0], [1.0, 4.0]]),
        ("diag = [\"x2\", 3]", [[2.0, 0.0], [0.0, 3.0]]),
        // The rows of the derivative are (2, 1/2), (1, 0) and (0, 4).
        ("pullback = [\"x1*x2\", \"x1\", \"x2^2\"]", [[5.0, 1.0], [1.0, 16.25]]),
        ("phi = \"x2\"", [[2.0, 0.0], [0.0, 2.0]]),
        ("cost = \"x2\"", [[4.0, 0.0], [0.0, 4.0]]),
        ("speed = \"x2\"", [[0.25, 0.0], [0.0, 0.25]]),
        // The gradient is (2, 1/2).
        ("graph = \"x1*x2\"", [[5.0, 1.0], [1.0, 1.25]]),
        ("sum = [{ phi = \"x1\" }, { diag = [1, \"x2\"] }]", [[1.5, 0.0], [0.0, 2.5]]),
        ("scaled = { by = \"x2\", metric = { diag = [1, 3] } }", [[2.0, 0.0], [0.0, 6.0]]),
        ("formula = \"f = x1 + x2; [f, 1; 1, 2*f]\"", [[2.5, 1.0], [1.0, 5.0]]),
    ] {
        assert_is(&format!("metric = {{ {metric} }}"), [0.5, 2.0], expected);
    }
}

/// A block has its own rows, columns and derivatives, in the order of its coordinates, and uses all
/// coordinates.
#[test]
fn each_block_of_a_product_stands_at_its_coordinates() {
    let x = [0.5, 2.0, -1.0];
    let upper = "metric = { upper = [[1, \"x1\", \"x2\"], [5, \"x3\"], [9]] }";
    assert_is(upper, x, [[1.0, 0.5, 2.0], [0.5, 5.0, -1.0], [2.0, -1.0, 9.0]]);
    let blocks = "metric = { product = [\
                  { coordinates = [3, 1], metric = { matrix = [[2, \"x2\"], [\"x2\", 8]] } }, \
                  { coordinates = [2], metric = { phi = \"1 + x1\" } }] }";
    assert_is(blocks, x, [[8.0, 0.0, 2.0], [0.0, 1.5, 0.0], [2.0, 0.0, 2.0]]);
    // The derivative of x₁x₂² by x₂ is 2, and those of x₁x₂x₃ by x₁ and x₃ are −2 and 1.
    let derived = "metric = { product = [\
                   { coordinates = [2], metric = { pullback = [\"x1*x2^2\"] } }, \
                   { coordinates = [1, 3], metric = { graph = \"x1*x2*x3\" } }] }";
    assert_is(derived, x, [[5.0, 0.0, -2.0], [0.0, 4.0, 0.0], [-2.0, 0.0, 2.0]]);
}

/// Parameters and definitions use those that stand before them, whatever their names.
#[test]
fn names_are_defined_in_the_order_of_the_file() {
    let lines = "metric = { phi = \"b + a\" }\n[parameters]\nz = 3\nb = \"z^2\"\n\
                 [let]\ny = \"x1 + 1\"\na = \"2*y\"";
    assert_is(lines, [0.5], [[12.0]]);
}
