//! The coordinates that are not drawn, near a curve.

/// From the plane to `R^D`: each coordinate that is not drawn is a mean over the points of a curve.
///
/// The weights are `1/(distance² + ε²)²` in the plane. On the curve, the mean is the coordinate of
/// the curve but for a small part. Elsewhere it is smooth, while the coordinate of the nearest
/// point would jump.
pub(crate) struct Lift<'a> {
    points: Vec<&'a [f64]>,
    plane: [usize; 2],
    blur: f64,
}

/// A curve with more points than this is thinned: a chord is then a few px long.
const MOST: usize = 150;

impl<'a> Lift<'a> {
    /// Returns the lift along a curve that has a point, with the length `ε > 0`.
    pub(crate) fn new(curve: &'a [Vec<f64>], plane: [usize; 2], blur: f64) -> Lift<'a> {
        let stride = curve.len().div_ceil(MOST).max(1);
        let mut points: Vec<&[f64]> = curve.iter().step_by(stride).map(Vec::as_slice).collect();
        if !(curve.len().saturating_sub(1)).is_multiple_of(stride) {
            points.extend(curve.last().map(Vec::as_slice));
        }
        Lift { points, plane, blur }
    }

    /// Returns the point of `R^D` with these drawn coordinates.
    pub(crate) fn at(&self, drawn: [f64; 2]) -> Vec<f64> {
        let [i, j] = self.plane;
        let weight = |point: &[f64]| {
            // In units of ε, whose square may underflow.
            let (a, b) = ((point[i] - drawn[0]) / self.blur, (point[j] - drawn[1]) / self.blur);
            (a * a + b * b + 1.0).powi(-2)
        };
        let mut total = 0.0;
        let mut mean = vec![0.0; self.points[0].len()];
        for point in &self.points {
            let weight = weight(point);
            total += weight;
            mean.iter_mut().zip(*point).for_each(|(mean, x)| *mean += weight * x);
        }
        mean.iter_mut().for_each(|mean| *mean /= total);
        (mean[i], mean[j]) = (drawn[0], drawn[1]);
        mean
    }
}

#[cfg(test)]
mod tests {
    use super::Lift;

    fn helix() -> Vec<Vec<f64>> {
        (0..=300).map(|k| f64::from(k) / 100.0).map(|t| vec![t.cos(), t, t.sin()]).collect()
    }

    #[test]
    fn on_the_curve_it_is_the_curve() {
        let helix = helix();
        let lift = Lift::new(&helix, [0, 2], 1e-3);
        for point in &helix[30..270] {
            let lifted = lift.at([point[0], point[2]]);
            // Distant points of the curve, at chords of 0.02, pull by a few of these chords.
            assert!((lifted[1] - point[1]).abs() <= 0.02, "{lifted:?} and {point:?}");
            assert_eq!([lifted[0], lifted[2]], [point[0], point[2]]);
        }
    }

    #[test]
    fn it_stays_within_the_curve_and_does_not_jump() {
        let helix = helix();
        let lift = Lift::new(&helix, [0, 2], 1e-3);
        let along: Vec<f64> =
            (0..=400).map(|k| lift.at([f64::from(k) / 100.0 - 2.0, -1.0])[1]).collect();
        assert!(along.iter().all(|height| (0.0..=3.0).contains(height)));
        // The nearest point jumps by nearly 3 where it passes from one end to the other.
        let jump = along.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        assert!(jump <= 0.05, "{jump}");
    }

    #[test]
    fn a_point_lifts_everything_to_its_level() {
        let point = [vec![1.0, 2.0, 3.0]];
        assert_eq!(Lift::new(&point, [0, 1], 1e-9).at([8.0, 9.0]), [8.0, 9.0, 3.0]);
    }
}
