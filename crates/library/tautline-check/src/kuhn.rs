//! Kuhn's simplices: the `D!` simplices of a cube, one for each order of the axes.

/// The largest dimension in which certificates are checked.
pub const LARGEST_DIMENSION: usize = 4;

const VERTICES: usize = LARGEST_DIMENSION + 1;

/// The simplex `0 ≤ y_{π(D)} ≤ … ≤ y_{π(1)} ≤ 1` of the unit cube. Its vertices are `w₀ = 0` and
/// `wₘ = wₘ₋₁ + e_{π(m)}`.
///
/// Simplices of neighbouring cubes meet face to face.
#[derive(Clone, Debug)]
pub(crate) struct Simplex {
    /// `π(1), …, π(D)`, axes counted from 0.
    pub(crate) axes: Vec<usize>,
    /// The vertices, as numbers with bit `i` for the coordinate `i`.
    pub(crate) corners: Vec<usize>,
    /// The midpoint of the vertices `i` and `j` among the `3^D` nodes of the cube.
    pub(crate) nodes: [[usize; VERTICES]; VERTICES],
}

/// Returns the simplices, by the lexicographic order of `π`.
pub(crate) fn simplices(dimension: usize) -> Vec<Simplex> {
    let mut orders: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..dimension {
        let longer = |order: &Vec<usize>| {
            let next = (0..dimension).filter(|axis| !order.contains(axis));
            next.map(|axis| [&order[..], &[axis]].concat()).collect::<Vec<_>>()
        };
        orders = orders.iter().flat_map(longer).collect();
    }
    orders.into_iter().map(|axes| simplex(dimension, axes)).collect()
}

fn simplex(dimension: usize, axes: Vec<usize>) -> Simplex {
    let mut corners = vec![0];
    for &axis in &axes {
        corners.push(corners[corners.len() - 1] | 1 << axis);
    }
    let mut nodes = [[0; VERTICES]; VERTICES];
    for (i, a) in corners.iter().enumerate() {
        for (j, b) in corners.iter().enumerate() {
            // Nodes are ordered lexicographically, by the number of half sides along each axis.
            nodes[i][j] =
                (0..dimension).fold(0, |node, axis| 3 * node + (a >> axis & 1) + (b >> axis & 1));
        }
    }
    Simplex { axes, corners, nodes }
}
