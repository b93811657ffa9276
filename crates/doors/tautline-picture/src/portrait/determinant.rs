//! The determinant of a small matrix.

/// Returns the determinant of an `n × n` matrix, by elimination with partial pivoting.
pub(crate) fn determinant(mut matrix: Vec<f64>, n: usize) -> f64 {
    let mut product = 1.0;
    for k in 0..n {
        let size = |row: &usize| matrix[row * n + k].abs();
        let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(k);
        if pivot != k {
            (0..n).for_each(|column| matrix.swap(k * n + column, pivot * n + column));
            product = -product;
        }
        let diagonal = matrix[k * n + k];
        product *= diagonal;
        if diagonal == 0.0 {
            return 0.0;
        }
        for row in k + 1..n {
            let factor = matrix[row * n + k] / diagonal;
            for column in k..n {
                matrix[row * n + column] -= factor * matrix[k * n + column];
            }
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::determinant;

    #[test]
    fn determinants_of_known_matrices() {
        assert_eq!(determinant(vec![3.0], 1), 3.0);
        assert_eq!(determinant(vec![0.0, 1.0, 1.0, 0.0], 2), -1.0);
        assert_eq!(determinant(vec![1.0, 2.0, 2.0, 4.0], 2), 0.0);
        // The Hilbert matrix of order 4 has the determinant 1/6048000.
        let hilbert = (0..16).map(|k| 1.0 / (1 + k / 4 + k % 4) as f64).collect();
        assert!((determinant(hilbert, 4) * 6_048_000.0 - 1.0).abs() <= 1e-9);
        let mut large = vec![0.0; 144];
        (0..12).for_each(|k| large[k * 12 + (k + 1) % 12] = 2.0);
        // A cycle of twelve is an odd permutation.
        assert_eq!(determinant(large, 12), -4096.0);
    }
}
