//! An sRGB colour, its contrast, and its coordinates in a perceptual space.

/// An opaque sRGB colour with 8 bits per channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use]
pub struct Colour {
    /// Red, green and blue.
    pub rgb: [u8; 3],
}

impl Colour {
    /// White, the background of every figure.
    pub const WHITE: Colour = Colour::new(0xFF, 0xFF, 0xFF);

    /// Returns the colour with these channels.
    pub const fn new(red: u8, green: u8, blue: u8) -> Colour {
        Colour { rgb: [red, green, blue] }
    }

    /// Returns the colour as `#rrggbb`.
    #[must_use]
    pub fn hex(self) -> String {
        let [r, g, b] = self.rgb;
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// Returns the contrast ratio of WCAG 2 with another colour, from 1 (none) to 21.
    #[must_use]
    pub fn contrast(self, other: Colour) -> f64 {
        let (a, b) = (self.luminance(), other.luminance());
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    /// Returns the lightest shade of this hue that is legible as text on white.
    ///
    /// WCAG requires a contrast of 4.5:1 for text. The shade has a little more, to allow for
    /// rounding.
    pub fn for_text(self) -> Colour {
        let [lightness, a, b] = self.oklab();
        // The contrast increases as the lightness decreases, so a downward search suffices. The
        // chroma decreases too, which keeps dark shades inside sRGB.
        (0..=100)
            .map(|step| {
                let keep = 1.0 - f64::from(step) / 100.0;
                Colour::from_oklab([lightness * keep, a * keep.sqrt(), b * keep.sqrt()])
            })
            .find(|shade| shade.contrast(Colour::WHITE) >= 4.6)
            .unwrap_or(Colour::new(0, 0, 0))
    }

    /// Returns the lightness and the two opponent coordinates in OKLab (Ottosson 2020).
    ///
    /// The Euclidean distance in OKLab approximates the difference that the eye perceives.
    #[must_use]
    pub fn oklab(self) -> [f64; 3] {
        let [r, g, b] = self.rgb.map(linear);
        let l = (0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b).cbrt();
        let m = (0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b).cbrt();
        let s = (0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b).cbrt();
        [
            0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
            1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
            0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
        ]
    }

    /// Returns the colour at these OKLab coordinates, clipped to sRGB.
    pub fn from_oklab([lightness, a, b]: [f64; 3]) -> Colour {
        let l = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
        let m = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
        let s = (lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b).powi(3);
        let red = 4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s;
        let green = -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s;
        let blue = -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s;
        Colour { rgb: [red, green, blue].map(encoded) }
    }

    /// Returns the relative luminance of WCAG 2, from 0 (black) to 1 (white).
    fn luminance(self) -> f64 {
        let [r, g, b] = self.rgb.map(linear);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }
}

/// Undoes the sRGB transfer curve (IEC 61966-2-1).
fn linear(channel: u8) -> f64 {
    let c = f64::from(channel) / 255.0;
    if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

/// Applies the sRGB transfer curve and clips to a byte.
fn encoded(c: f64) -> u8 {
    let c = c.clamp(0.0, 1.0);
    let c = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
    // The value is in [0, 255] after the clamp, so the cast only rounds.
    (c * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::Colour;

    #[test]
    fn contrast_of_black_and_white_is_the_largest() {
        let contrast = Colour::new(0, 0, 0).contrast(Colour::WHITE);
        assert!((contrast - 21.0).abs() < 1e-9, "{contrast}");
    }

    #[test]
    fn oklab_and_back_is_the_identity() {
        for rgb in [[0, 0, 0], [255, 255, 255], [213, 94, 0], [0, 114, 178], [86, 180, 233]] {
            let colour = Colour { rgb };
            assert_eq!(Colour::from_oklab(colour.oklab()), colour);
        }
    }

    /// Ottosson published these values for pure red, to three decimals.
    #[test]
    fn oklab_of_red_is_the_published_one() {
        let lab = Colour::new(255, 0, 0).oklab();
        for (got, want) in lab.into_iter().zip([0.628, 0.225, 0.126]) {
            assert!((got - want).abs() < 6e-4, "{lab:?}");
        }
    }
}
