//! The sequential colour ramp of heat-maps.

use super::colour::Colour;

/// A colour ramp from near-white to deep blue, whose equal steps look equal.
///
/// It is built in OKLab: the lightness falls linearly, the chroma rises and falls in one arc, and
/// the hue drifts from cyan to blue. Lightness alone orders the colours, so the order survives grey
/// printing and every colour vision. The light end leaves room for dark contour lines and for
/// curves over them.
#[derive(Clone, Debug)]
#[must_use]
pub struct Ramp {
    /// Points of the curve in OKLab, and the fraction of its length before each point.
    knots: Vec<([f64; 3], f64)>,
}

/// The number of knots of the table. The steps between them are below one 8-bit step of a channel.
const KNOTS: usize = 512;

impl Ramp {
    /// Returns the ramp of all heat-maps.
    pub fn blue() -> Ramp {
        let mut knots: Vec<([f64; 3], f64)> = Vec::with_capacity(KNOTS + 1);
        for k in 0..=KNOTS {
            let t = k as f64 / KNOTS as f64;
            let lightness = 0.985 - 0.60 * t;
            let chroma = 0.008 + 0.118 * (std::f64::consts::PI * (0.08 + 0.66 * t)).sin();
            let chroma = chroma * t.sqrt().min(1.0);
            let hue = (218.0 + 40.0 * t).to_radians();
            let lab = [lightness, chroma * hue.cos(), chroma * hue.sin()];
            let length = knots.last().map_or(0.0, |(last, before)| before + distance(*last, lab));
            knots.push((lab, length));
        }
        let total = knots[KNOTS].1;
        for knot in &mut knots {
            knot.1 /= total;
        }
        Ramp { knots }
    }

    /// Returns the colour at the fraction `share` of the ramp's length, from 0 (light) to 1 (dark).
    pub fn at(&self, share: f64) -> Colour {
        let share = share.clamp(0.0, 1.0);
        let next = self.knots.partition_point(|(_, length)| *length < share).clamp(1, KNOTS);
        let ((from, start), (to, end)) = (self.knots[next - 1], self.knots[next]);
        let part = ((share - start) / (end - start)).clamp(0.0, 1.0);
        Colour::from_oklab(std::array::from_fn(|i| from[i] + part * (to[i] - from[i])))
    }
}

fn distance(from: [f64; 3], to: [f64; 3]) -> f64 {
    from.iter().zip(to).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::{Colour, Ramp, distance};

    #[test]
    fn equal_steps_look_equal() {
        let ramp = Ramp::blue();
        let colours: Vec<_> = (0..=12).map(|k| ramp.at(f64::from(k) / 12.0).oklab()).collect();
        let steps: Vec<f64> = colours.windows(2).map(|w| distance(w[0], w[1])).collect();
        let mean = steps.iter().sum::<f64>() / steps.len() as f64;
        for step in &steps {
            // The tolerance is five per cent: rounding to bytes moves a colour by up to 0.003, and
            // a step is 0.06.
            assert!((step / mean - 1.0).abs() <= 0.05, "{steps:?}");
        }
    }

    #[test]
    fn lightness_falls_all_the_way() {
        let ramp = Ramp::blue();
        let lightness: Vec<f64> =
            (0..=64).map(|k| ramp.at(f64::from(k) / 64.0).oklab()[0]).collect();
        assert!(lightness.windows(2).all(|w| w[1] < w[0]), "{lightness:?}");
    }

    #[test]
    fn the_light_end_is_nearly_white_and_the_dark_end_carries_white_text() {
        let ramp = Ramp::blue();
        assert!(ramp.at(0.0).contrast(Colour::WHITE) <= 1.1);
        assert!(ramp.at(1.0).contrast(Colour::WHITE) >= 4.5);
    }

    /// Clipping would distort the ramp, so every colour must survive the conversion to sRGB.
    #[test]
    fn the_ramp_stays_inside_srgb() {
        for (lab, _) in &Ramp::blue().knots {
            let back = Colour::from_oklab(*lab).oklab();
            assert!(distance(*lab, back) <= 0.004, "{lab:?} became {back:?}");
        }
    }
}
