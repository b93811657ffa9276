//! The colours of the figures, after Okabe and Ito (2008). They are distinct for every colour
//! vision.

use super::colour::Colour;

/// Axes and text.
pub const INK: Colour = Colour::new(0x1A, 0x1A, 0x1A);
/// Reference lines, slope triangles and other remarks.
pub const GREY: Colour = Colour::new(0x6B, 0x6B, 0x6B);
/// The horizontal grid, which must not compete with the curves.
pub const GRID: Colour = Colour::new(0xE4, 0xE4, 0xE4);
/// Okabe–Ito blue.
pub const BLUE: Colour = Colour::new(0x00, 0x72, 0xB2);
/// Okabe–Ito vermillion.
pub const VERMILLION: Colour = Colour::new(0xD5, 0x5E, 0x00);
/// Okabe–Ito bluish green.
pub const GREEN: Colour = Colour::new(0x00, 0x9E, 0x73);
/// Okabe–Ito reddish purple.
pub const PURPLE: Colour = Colour::new(0xCC, 0x79, 0xA7);
/// Okabe–Ito orange.
pub const ORANGE: Colour = Colour::new(0xE6, 0x9F, 0x00);
/// Okabe–Ito sky blue. It is for lines only, and must not appear next to [`BLUE`] without another
/// mark.
pub const SKY: Colour = Colour::new(0x56, 0xB4, 0xE9);

/// The colours of curves, in the order in which a figure should take them.
///
/// Okabe–Ito yellow is omitted: with a contrast of 1.3:1, a thin yellow line is invisible on white.
pub const CURVES: [Colour; 6] = [VERMILLION, BLUE, GREEN, PURPLE, ORANGE, SKY];

#[cfg(test)]
mod tests {
    use super::{CURVES, Colour, GREY, INK};

    #[test]
    fn text_in_every_colour_is_legible_on_white() {
        for colour in CURVES.into_iter().chain([INK, GREY]) {
            let contrast = colour.for_text().contrast(Colour::WHITE);
            assert!(contrast >= 4.5, "{} has only {contrast:.2}", colour.hex());
        }
    }

    #[test]
    fn text_keeps_the_hue_of_its_curve() {
        for colour in CURVES {
            let hue = |c: Colour| c.oklab()[2].atan2(c.oklab()[1]);
            let turn = (hue(colour) - hue(colour.for_text())).abs();
            // The tolerance is a tenth of a radian: clipping to sRGB and bytes shifts the hue of
            // dark shades a little.
            assert!(turn <= 0.1, "{} turned by {turn:.3}", colour.hex());
        }
    }

    /// Under deuteranopia, only lightness and the yellow–blue axis distinguish curves.
    #[test]
    fn curves_differ_without_red_and_green() {
        for (i, first) in CURVES.into_iter().enumerate() {
            for second in &CURVES[..i] {
                let ([l1, _, b1], [l2, _, b2]) = (first.oklab(), second.oklab());
                let apart = (l1 - l2).hypot(b1 - b2);
                assert!(apart >= 0.06, "{} and {}: {apart:.3}", first.hex(), second.hex());
            }
        }
    }
}
