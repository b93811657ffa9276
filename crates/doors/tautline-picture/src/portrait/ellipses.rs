//! The metric as a grid of ellipses, all with the same length in the metric.

use std::f64::consts::TAU;

use super::{
    background::Background,
    span::{Span, number},
};
use crate::{Ramp, Region};

/// The number of ellipses across the picture.
const ACROSS: usize = 10;
/// The largest half-axis, as a share of the distance between centres: no two ellipses meet.
const REACH: f64 = 0.46;
/// The number of corners of the polygon that stands for an ellipse.
const CORNERS: usize = 72;

/// The half-axes of `{v : vᵀ H v = 1}`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Axes {
    /// The shorter and the longer one.
    half: [f64; 2],
    /// The direction of the shorter one, in radians.
    angle: f64,
}

impl Axes {
    /// Returns the half-axes for `H = [a b; b c]`, if it is positive definite.
    fn of([a, b, c]: [f64; 3]) -> Option<Axes> {
        let largest = f64::midpoint(a, c) + (a / 2.0 - c / 2.0).hypot(b);
        // The product of the eigenvalues is ac − b²; their difference would cancel.
        let smallest = a * (c / largest) - b * (b / largest);
        let half = [largest, smallest].map(|eigenvalue| 1.0 / eigenvalue.sqrt());
        let angle = f64::atan2(2.0 * b, a - c) / 2.0;
        (largest > 0.0 && half.iter().all(|half| half.is_finite() && *half > 0.0))
            .then_some(Axes { half, angle })
    }

    /// Returns the boundary of `{v : vᵀ H v = r²}` about a centre.
    fn ring(&self, r: f64, centre: [f64; 2]) -> Vec<[f64; 2]> {
        let (sin, cos) = self.angle.sin_cos();
        let corner = |k: usize| {
            let (s, c) = (TAU * k as f64 / CORNERS as f64).sin_cos();
            let (short, long) = (r * self.half[0] * c, r * self.half[1] * s);
            [centre[0] + short * cos - long * sin, centre[1] + short * sin + long * cos]
        };
        (0..CORNERS).map(corner).collect()
    }
}

/// Returns the ellipses of the block `[Hᵢᵢ, Hᵢⱼ, Hⱼⱼ]` at the points of a grid, and the remark that
/// says how long they are, with `which` vectors they contain.
pub(crate) fn ellipses(
    [x, y]: [Span; 2],
    which: &str,
    block: impl Fn([f64; 2]) -> Option<[f64; 3]>,
) -> Background {
    let spacing = x.length() / ACROSS as f64;
    let rows = ((y.length() / spacing) as usize).max(1);
    let place = |k: usize, count: usize, span: Span| {
        span.from + span.length() / 2.0 + (k as f64 - (count as f64 - 1.0) / 2.0) * spacing
    };
    let (mut found, mut missing, mut indefinite) = (Vec::new(), false, false);
    for j in 0..rows {
        for i in 0..ACROSS {
            let centre = [place(i, ACROSS, x), place(j, rows, y)];
            match block(centre) {
                None => missing = true,
                Some(entries) => match Axes::of(entries) {
                    None => indefinite = true,
                    Some(axes) => found.push((centre, axes)),
                },
            }
        }
    }
    let longest = found.iter().map(|(_, axes)| axes.half[1]).fold(0.0, f64::max);
    let mut remarks = Vec::new();
    let square = rounded_down((REACH * spacing / longest).powi(2));
    if square.is_some() {
        let square = number(square.unwrap_or_default());
        remarks.push(format!("Ellipses: $v^\"T\"Hv={square}${which}."));
    }
    if missing {
        remarks.push("Where there is none, $H$ is not defined.".to_owned());
    }
    if indefinite {
        remarks.push("Where there is none, $H$ is not positive definite.".to_owned());
    }
    let region = |(centre, axes): &([f64; 2], Axes)| {
        let ring = axes.ring(square.unwrap_or_default().sqrt(), *centre);
        let drawn = ring.iter().map(|p| (x.drawn(p[0]), y.drawn(p[1]))).collect();
        let ramp = Ramp::blue();
        Region::new(vec![drawn]).filled(ramp.at(0.3), 0.6).outlined(ramp.at(0.85), 0.9)
    };
    let found = if square.is_some() { &found[..] } else { &[] };
    let regions = found.iter().map(region).collect();
    Background { field: None, regions, remarks }
}

/// Rounds down to two digits, so that a short number is the exact one.
fn rounded_down(value: f64) -> Option<f64> {
    if !(value.is_finite() && value > 1e-290) {
        return None;
    }
    let exponent = value.log10().floor() as i32 - 1;
    let digits = (value / 10.0_f64.powi(exponent)).floor();
    // Parsing is correctly rounded, unlike a product with a power of ten.
    format!("{digits}e{exponent}").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{Axes, Span, ellipses, rounded_down};

    #[test]
    fn axes_of_a_known_matrix() {
        // Eigenvalues 9 along (1, 1) and 1 along (1, −1).
        let axes = Axes::of([5.0, 4.0, 5.0]).expect("definite");
        assert!((axes.half[0] - 1.0 / 3.0).abs() <= 1e-15 && (axes.half[1] - 1.0).abs() <= 1e-15);
        assert!((axes.angle - std::f64::consts::FRAC_PI_4).abs() <= 1e-15);
        for [x, y] in axes.ring(2.0, [0.0, 0.0]) {
            assert!((5.0 * (x * x + y * y) + 8.0 * x * y - 4.0).abs() <= 1e-13);
        }
    }

    #[test]
    fn matrices_without_an_ellipse_have_none() {
        for entries in [[1.0, 2.0, 1.0], [0.0, 0.0, 0.0], [-1.0, 0.0, -1.0], [1.0, 1.0, 1.0]] {
            assert_eq!(Axes::of(entries), None);
        }
        assert!(Axes::of([1e-200, 0.0, 1e200]).is_some());
    }

    #[test]
    fn no_two_ellipses_meet() {
        let span = |to| Span::new(0, [0.0, to]).expect("a range");
        let background =
            ellipses([span(2.0), span(1.0)], "", |[x, y]| Some([1.0 + x, 0.3 * y, 2.0 - y]));
        assert_eq!(background.regions.len(), 50);
        assert_eq!(background.remarks.len(), 1);
        let none = ellipses([span(2.0), span(1.0)], "", |_| None);
        assert!(none.regions.is_empty() && none.remarks.len() == 1);
    }

    #[test]
    fn the_constant_has_two_digits() {
        assert_eq!(rounded_down(0.012_99), Some(0.012));
        assert_eq!(rounded_down(1.0), Some(1.0));
        assert_eq!(rounded_down(f64::NAN), None);
    }
}
