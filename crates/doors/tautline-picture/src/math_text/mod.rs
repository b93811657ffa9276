//! Layout of labels: from `"excess $E(γ^\"pl\") - d^2$"` to outlines with measured extents.

mod font;
mod formula;
mod setter;

use font::FigureFont;
use setter::Setter;

use crate::{
    error::DrawingError,
    geometry::{Extent, Path},
};

/// Where the origin of a label lies between its left and right ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// At the left end.
    Left,
    /// In the middle.
    Centre,
    /// At the right end.
    Right,
}

/// A label as outlines, in px. Its origin is on the baseline of its first line.
#[derive(Clone, Debug)]
#[must_use]
pub struct TextBlock {
    /// All glyphs.
    pub path: Path,
    /// The box of the advance width and the ink height; its corners are relative to the origin.
    pub extent: Extent,
    /// The label in plain words, for screen readers.
    pub spoken: String,
}

/// The distance between the baselines of a label with several lines, in em.
const LEADING: f64 = 1.28;

/// Returns the label, set at `size` px per em.
///
/// Text is upright. Between dollar signs, letters are slanted and `"quoted words"` are upright. The
/// signs `^` and `_` turn the next letter, word or `{group}` into a script, and `√` puts it under a
/// root. A combining accent applies to the letter before it, and `-` is a minus sign. Spaces have
/// no effect, but U+2009 is a thin space. A line feed starts a new line.
///
/// # Errors
///
/// If the label is malformed, or the font lacks one of its characters.
pub fn typeset(label: &str, size: f64, align: Align) -> Result<TextBlock, DrawingError> {
    let setter = Setter::new(size, label);
    let mut path = Path::default();
    let mut extent: Option<Extent> = None;
    for (k, line) in label.split('\n').enumerate() {
        let row = setter.line(line)?;
        let left = match align {
            Align::Left => 0.0,
            Align::Centre => -row.width / 2.0,
            Align::Right => -row.width,
        };
        let baseline = k as f64 * LEADING * size;
        path.append(&row.path.moved(left, baseline));
        let of_line = Extent {
            left,
            top: baseline - row.height,
            right: left + row.width,
            bottom: baseline + row.depth,
        };
        extent = Some(extent.map_or(of_line, |above| above.union(of_line)));
    }
    let extent = extent.expect("`split` yields at least one line");
    let spoken = label.replace(['$', '"', '{', '}'], "").replace(['\n', '\u{2009}'], " ");
    Ok(TextBlock { path, extent, spoken })
}

/// Returns half the height of a digit, in px. A number is lowered by this to centre it on a tick.
#[must_use]
pub fn half_digit(size: f64) -> f64 {
    let font = FigureFont::embedded();
    let digit = font.glyph('0').expect("the committed font has digits");
    font.vertical_ink(digit).1 / 2.0 * size
}

impl TextBlock {
    /// Returns the label rotated about its origin, so that it is read upwards.
    pub fn upwards(&self) -> TextBlock {
        let Extent { left, top, right, bottom } = self.extent;
        TextBlock {
            path: self.path.mapped(|x, y| (y, -x)),
            extent: Extent { left: top, top: -right, right: bottom, bottom: -left },
            spoken: self.spoken.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Align, DrawingError, Extent, Path, TextBlock, typeset};

    fn set(label: &str) -> TextBlock {
        typeset(label, 100.0, Align::Left).expect("well formed")
    }

    /// Returns the ink of `label` without that of its `beginning`.
    fn ink_after(beginning: &str, label: &str) -> Extent {
        ink_between(beginning, label, label)
    }

    /// Returns the ink of `label` between the ends of its beginnings `first` and `second`.
    fn ink_between(first: &str, second: &str, label: &str) -> Extent {
        let count = |part: &str| set(part).path.segments().len();
        let mut part = Path::default();
        set(label).path.segments()[count(first)..count(second)]
            .iter()
            .for_each(|segment| part.push(*segment));
        part.extent().expect("more ink")
    }

    #[test]
    fn scripts_are_raised_lowered_and_smaller() {
        let (base, sup, sub) =
            (ink_after("", "$2$"), ink_after("$x$", "$x^2$"), ink_after("$x$", "$x_2$"));
        assert!(sup.bottom < -20.0 && sub.bottom > 10.0, "{sup:?} {sub:?}");
        assert!(sup.height() < 0.8 * base.height() && sup.height() > 0.5 * base.height());
        let nested = ink_after("$N^{-k}$", "$N^{-k_2}$");
        assert!(nested.height() < sup.height() && nested.height() > 0.4 * base.height());
    }

    #[test]
    fn superscripts_move_out_of_the_lean_of_their_letter() {
        let shift = |letter: &str| {
            let script =
                |sign: char| ink_after(&format!("${letter}$"), &format!("${letter}{sign}2$"));
            script('^').left - script('_').left
        };
        // These are the italic corrections of the font, at 100 px per em. An upright letter has
        // none.
        assert!((shift("C") - 7.3).abs() <= 0.1, "{}", shift("C"));
        assert!((shift("N") - 10.6).abs() <= 0.1, "{}", shift("N"));
        assert!(shift("\"C\"").abs() <= 0.1);
        let (letter, sharp) = (ink_after("", "$C$"), ink_after("$C$", "$C^♯$"));
        assert!(sharp.left >= letter.right + 3.0, "{sharp:?} beside {letter:?}");
    }

    #[test]
    fn stacked_scripts_keep_the_gap_of_the_font() {
        let label = "$C^♯_\"tra\"$";
        let sharp = ink_between("$C$", "$C^♯$", label);
        let index = ink_after("$C^♯$", label);
        assert!(index.top - sharp.bottom >= 15.9, "{index:?} under {sharp:?}");
        // The order in which the scripts are written does not matter.
        assert_eq!(set("$C_\"tra\"^♯$").path, set(label).path);
    }

    #[test]
    fn binary_signs_have_space_and_unary_ones_do_not() {
        let width = |label: &str| set(label).extent.width();
        let glyphs = width("$a$") + width("$b$") + width("$−$");
        assert!((width("$a-b$") - glyphs - 800.0 / 18.0).abs() <= 1e-6);
        assert!((width("$-b$") - width("$−$") - width("$b$")).abs() <= 1e-6);
    }

    #[test]
    fn hyphens_in_formulas_become_minus_signs() {
        assert_eq!(set("$a-b$").path, set("$a−b$").path);
        assert_ne!(set("a-b").path, set("a−b").path);
    }

    #[test]
    fn a_root_covers_its_radicand() {
        let root = set("$√{E_\"tra\"}$");
        let radicand = set("$E_\"tra\"$");
        assert!(root.extent.top < radicand.extent.top - 3.0);
        assert!(root.extent.width() > radicand.extent.width() + 40.0);
        let ink = root.path.extent().expect("ink");
        assert!(ink.bottom >= radicand.extent.bottom - 10.0, "{ink:?}");
    }

    #[test]
    fn an_accent_stands_over_its_letter() {
        let bar = ink_after("$K$", "$K\u{304}$");
        let letter = set("$K$").path.extent().expect("ink");
        assert!(bar.bottom <= letter.top, "{bar:?} over {letter:?}");
        assert!(bar.left >= letter.left && bar.right <= letter.right);
    }

    #[test]
    fn an_unknown_glyph_is_an_error() {
        let error = typeset("漢", 15.0, Align::Left).expect_err("not in the subset");
        let expected = DrawingError::UnknownGlyph { character: '漢', label: "漢".to_owned() };
        assert_eq!(error, expected);
    }

    #[test]
    fn the_measured_box_holds_the_ink() {
        for label in ["$E(γ^\"pl\")-d^2$", "first $K_{1,g}N^{-1}$\nsecond", "$√{N}$", "10"] {
            let block = set(label);
            let ink = block.path.extent().expect("ink");
            // A letter may extend beyond its advance width by a few hundredths of an em.
            assert!(block.extent.inset(-8.0, -0.01).contains(&ink), "{label}: {ink:?}");
            let turned = block.upwards();
            assert!((turned.extent.height() - block.extent.width()).abs() <= 1e-9);
        }
    }
}
