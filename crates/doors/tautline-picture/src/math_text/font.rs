//! The embedded figure font: its outlines, its advance widths and its `MATH` table.

use std::sync::OnceLock;

use ttf_parser::{Face, GlyphId, OutlineBuilder, math};

use crate::geometry::{Path, Segment};

/// The font of all labels, a subset of New Computer Modern Math (see `font/NOTICE.md`).
///
/// Lengths are in em, with `y` pointing upwards. Only [`outline`](FigureFont::outline) converts
/// them to the px and the downward `y` of a scene.
pub(crate) struct FigureFont {
    face: Face<'static>,
    math: math::Table<'static>,
    units_per_em: f64,
}

/// Positions of scripts and radicals from the `MATH` table, in em of the surrounding size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MathConstants {
    /// Height of a superscript's baseline above the baseline of its base.
    pub superscript_up: f64,
    /// Lowest position of the bottom of a superscript.
    pub superscript_bottom_min: f64,
    /// How far the baseline of a superscript may lie below the top of a tall base.
    pub superscript_drop_max: f64,
    /// Depth of a subscript's baseline below the baseline of its base.
    pub subscript_down: f64,
    /// Highest position of the top of a subscript.
    pub subscript_top_max: f64,
    /// Smallest gap between stacked scripts.
    pub script_gap_min: f64,
    /// White space after scripts.
    pub space_after_script: f64,
    /// Gap between a radicand and its bar.
    pub radical_gap: f64,
    /// Thickness of the bar of a radical.
    pub radical_rule: f64,
    /// Height of the letters for which accents are drawn.
    pub accent_base_height: f64,
    /// Sizes of scripts and of scripts of scripts, relative to the text.
    pub script_sizes: [f64; 2],
}

impl FigureFont {
    /// Returns the font, which is parsed only once.
    pub(crate) fn embedded() -> &'static FigureFont {
        static FONT: OnceLock<FigureFont> = OnceLock::new();
        FONT.get_or_init(|| {
            let data = include_bytes!("../../font/TautlineFigure.otf");
            let face = Face::parse(data, 0).expect("the committed font is a valid OpenType font");
            let math = face.tables().math.expect("the committed font has a MATH table");
            let units_per_em = f64::from(face.units_per_em());
            FigureFont { face, math, units_per_em }
        })
    }

    /// Returns the glyph of a character, or `None` if the font has none.
    pub(crate) fn glyph(&self, character: char) -> Option<GlyphId> {
        self.face.glyph_index(character)
    }

    /// Returns the advance width, in em.
    pub(crate) fn advance(&self, glyph: GlyphId) -> f64 {
        f64::from(self.face.glyph_hor_advance(glyph).unwrap_or(0)) / self.units_per_em
    }

    /// Returns the bottom and the top of the ink, in em above the baseline; both are zero for a
    /// blank.
    pub(crate) fn vertical_ink(&self, glyph: GlyphId) -> (f64, f64) {
        let ink = self.face.glyph_bounding_box(glyph);
        ink.map_or((0.0, 0.0), |ink| (self.em(ink.y_min), self.em(ink.y_max)))
    }

    /// Returns the left and the right of the ink, in em from the origin; both are zero for a blank.
    pub(crate) fn horizontal_ink(&self, glyph: GlyphId) -> (f64, f64) {
        let ink = self.face.glyph_bounding_box(glyph);
        ink.map_or((0.0, 0.0), |ink| (self.em(ink.x_min), self.em(ink.x_max)))
    }

    fn em(&self, units: i16) -> f64 {
        f64::from(units) / self.units_per_em
    }

    /// Returns how far the top of a slanted letter extends beyond its advance width, in em.
    pub(crate) fn italic_correction(&self, glyph: GlyphId) -> f64 {
        let corrections = self.math.glyph_info.and_then(|info| info.italic_corrections);
        let value = corrections.and_then(|table| table.get(glyph));
        value.map_or(0.0, |value| self.em(value.value))
    }

    /// Returns the position over which an accent is centred, in em from the origin of the glyph.
    pub(crate) fn accent_centre(&self, glyph: GlyphId) -> f64 {
        let centres = self.math.glyph_info.and_then(|info| info.top_accent_attachments);
        let value = centres.and_then(|table| table.get(glyph));
        value.map_or(self.advance(glyph) / 2.0, |value| self.em(value.value))
    }

    /// Returns the smallest radical sign that is at least `height` em tall, or else the tallest
    /// one.
    pub(crate) fn radical(&self, height: f64) -> Option<GlyphId> {
        let plain = self.glyph('√')?;
        let variants = self
            .math
            .variants
            .and_then(|variants| variants.vertical_constructions.get(plain))
            .map(|construction| construction.variants);
        let tall_enough = |glyph: &GlyphId| {
            let (bottom, top) = self.vertical_ink(*glyph);
            top - bottom >= height
        };
        let mut all = vec![plain];
        all.extend(variants.into_iter().flatten().map(|variant| variant.variant_glyph));
        all.iter().copied().find(tall_enough).or(all.last().copied())
    }

    /// Returns the positions of the `MATH` table.
    pub(crate) fn constants(&self) -> MathConstants {
        let table = self.math.constants.expect("the committed font has math constants");
        let em = |value: math::MathValue<'_>| self.em(value.value);
        MathConstants {
            superscript_up: em(table.superscript_shift_up()),
            superscript_bottom_min: em(table.superscript_bottom_min()),
            superscript_drop_max: em(table.superscript_baseline_drop_max()),
            subscript_down: em(table.subscript_shift_down()),
            subscript_top_max: em(table.subscript_top_max()),
            script_gap_min: em(table.sub_superscript_gap_min()),
            space_after_script: em(table.space_after_script()),
            radical_gap: em(table.radical_vertical_gap()),
            radical_rule: em(table.radical_rule_thickness()),
            accent_base_height: em(table.accent_base_height()),
            script_sizes: [
                f64::from(table.script_percent_scale_down()) / 100.0,
                f64::from(table.script_script_percent_scale_down()) / 100.0,
            ],
        }
    }

    /// Appends the outline of a glyph at `size` px per em, with its origin at `(x, y)`.
    pub(crate) fn outline(&self, glyph: GlyphId, size: f64, (x, y): (f64, f64), path: &mut Path) {
        let mut pen = Pen { path, scale: size / self.units_per_em, x, y, at: (0.0, 0.0) };
        // `None` means that the glyph has no ink, such as the space.
        let _ = self.face.outline_glyph(glyph, &mut pen);
    }
}

/// Converts font units to px.
struct Pen<'a> {
    path: &'a mut Path,
    scale: f64,
    x: f64,
    y: f64,
    at: (f64, f64),
}

impl Pen<'_> {
    fn point(&self, x: f32, y: f32) -> (f64, f64) {
        (self.x + self.scale * f64::from(x), self.y - self.scale * f64::from(y))
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.at = self.point(x, y);
        self.path.push(Segment::Move(self.at.0, self.at.1));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.at = self.point(x, y);
        self.path.push(Segment::Line(self.at.0, self.at.1));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        // The cubic with the same shape has control points two thirds of the way to the
        // quadratic's.
        let ((ax, ay), (bx, by), (cx, cy)) = (self.at, self.point(x1, y1), self.point(x, y));
        let third = |from: f64, to: f64| from + 2.0 / 3.0 * (to - from);
        let first = (third(ax, bx), third(ay, by));
        let second = (third(cx, bx), third(cy, by));
        self.at = (cx, cy);
        self.path.push(Segment::Cubic([first.0, first.1, second.0, second.1, cx, cy]));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((a, b), (c, d)) = (self.point(x1, y1), self.point(x2, y2));
        self.at = self.point(x, y);
        self.path.push(Segment::Cubic([a, b, c, d, self.at.0, self.at.1]));
    }

    fn close(&mut self) {
        self.path.push(Segment::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::{FigureFont, Path};

    #[test]
    fn slanted_letters_lean_and_upright_ones_do_not() {
        let font = FigureFont::embedded();
        let lean = |c: char| font.italic_correction(font.glyph(c).expect("in the subset"));
        assert!(lean('𝐶') > 0.05 && lean('𝐾') > 0.05 && lean('𝛾') > 0.03);
        assert_eq!(lean('C'), 0.0);
    }

    #[test]
    fn a_tall_radicand_gets_a_taller_radical() {
        let font = FigureFont::embedded();
        let height = |wanted: f64| {
            let (bottom, top) = font.vertical_ink(font.radical(wanted).expect("in the subset"));
            top - bottom
        };
        assert!(height(0.5) >= 0.5);
        assert!(height(1.5) >= 1.5 && height(1.5) > height(0.5));
    }

    #[test]
    fn a_digit_stands_on_its_baseline() {
        let font = FigureFont::embedded();
        let one = font.glyph('1').expect("in the subset");
        let mut path = Path::default();
        font.outline(one, 100.0, (10.0, 50.0), &mut path);
        let extent = path.extent().expect("a digit has ink");
        assert!((extent.bottom - 50.0).abs() <= 0.5 && extent.top < 0.0, "{extent:?}");
    }

    #[test]
    fn every_character_the_house_needs_is_there() {
        let font = FigureFont::embedded();
        for c in "ABCxyz0189+−−·×±≤≥<>=≈∼∞√∑∫∂∇∈→‖|()[]{}⟨⟩′♯♭ℓ∗∘/,.;:–—’ﬁ𝛾𝛼𝛽𝜋𝜀𝐸𝐿𝐾ℎΓΔΦ".chars()
        {
            assert!(font.glyph(c).is_some(), "{c:?} is missing");
        }
    }
}
