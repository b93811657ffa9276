//! Layout of labels: from `"excess $E(γ^\"pl\") - d^2$"` to outlines with a measured extent.

use super::{
    error::DrawingError,
    extent::Extent,
    font::{FigureFont, MathConstants},
    formula::{Atom, Class, Nucleus, Piece, parse},
    path::Path,
};

/// Where the origin of a label lies between its left and its right end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// At the left end.
    Left,
    /// In the middle.
    Centre,
    /// At the right end.
    Right,
}

/// A label as outlines, in px; the origin is on the baseline of its first line.
#[derive(Clone, Debug)]
pub struct TextBlock {
    /// All glyphs.
    pub path: Path,
    /// The box of advance width and ink height; its corners are relative to the origin.
    pub extent: Extent,
    /// The label in plain words, for those who cannot see the outlines.
    pub spoken: String,
}

/// Distance of the baselines of a label with several lines, in em.
const LEADING: f64 = 1.28;

/// Returns the label set at `size` px an em.
///
/// Text is upright. Between dollar signs letters are slanted, `"quoted words"` upright, `^` and
/// `_` set scripts of the next letter, word or `{group}`, `√` roots the next one; a combining
/// accent sits on the letter before it; `-` is a minus; spaces do nothing, U+2009 is a thin
/// space. A line feed starts a new line.
///
/// # Errors
///
/// If the label is malformed, or the font lacks one of its characters.
pub fn typeset(label: &str, size: f64, align: Align) -> Result<TextBlock, DrawingError> {
    let font = FigureFont::embedded();
    let setter = Setter { font, constants: font.constants(), size, label };
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
        let start = extent.unwrap_or(Extent {
            left,
            top: baseline - row.height,
            right: left + row.width,
            bottom: baseline + row.depth,
        });
        extent = Some(
            start.with(left, baseline - row.height).with(left + row.width, baseline + row.depth),
        );
    }
    let extent = extent.expect("`split` yields at least one line");
    let spoken = label.replace(['$', '"', '{', '}'], "").replace(['\n', '\u{2009}'], " ");
    Ok(TextBlock { path, extent, spoken })
}

/// Returns half the height of a digit, in px: what centres a number on a tick.
#[must_use]
pub fn half_digit(size: f64) -> f64 {
    let font = FigureFont::embedded();
    let digit = font.glyph('0').expect("the committed font has digits");
    font.vertical_ink(digit).1 / 2.0 * size
}

impl TextBlock {
    /// Returns the label turned to read upwards, about its origin.
    #[must_use]
    pub fn upwards(&self) -> TextBlock {
        let Extent { left, top, right, bottom } = self.extent;
        TextBlock {
            path: self.path.mapped(|x, y| (y, -x)),
            extent: Extent { left: top, top: -right, right: bottom, bottom: -left },
            spoken: self.spoken.clone(),
        }
    }
}

/// Outlines with their origin at the left end of the baseline; all lengths in px.
#[derive(Clone, Debug, Default)]
struct Row {
    path: Path,
    width: f64,
    height: f64,
    depth: f64,
    /// How far the last letter leans out of `width`; a superscript moves right by it.
    lean: f64,
}

impl Row {
    /// Appends another row at the right end, raised by `up`.
    fn join(&mut self, next: &Row, up: f64) {
        self.place(next, self.width, up);
        self.width += next.width;
        self.lean = next.lean;
    }

    /// Draws another row at `x` without taking its width.
    fn place(&mut self, other: &Row, x: f64, up: f64) {
        self.path.append(&other.path.moved(x, -up));
        self.height = self.height.max(other.height + up);
        self.depth = self.depth.max(other.depth - up);
    }
}

struct Setter<'a> {
    font: &'static FigureFont,
    constants: MathConstants,
    size: f64,
    label: &'a str,
}

impl Setter<'_> {
    fn line(&self, line: &str) -> Result<Row, DrawingError> {
        let mut row = Row::default();
        for piece in parse(line)? {
            let next = match piece {
                Piece::Text(text) => self.word(&text, self.size)?,
                Piece::Math(atoms) => self.formula(&atoms, 0)?,
            };
            row.join(&next, 0.0);
        }
        Ok(row)
    }

    /// Px an em at nesting `level`: text, script, script of a script (and no smaller).
    fn em(&self, level: usize) -> f64 {
        let shrink = match level {
            0 => 1.0,
            1 => self.constants.script_sizes[0],
            _ => self.constants.script_sizes[1],
        };
        self.size * shrink
    }

    fn formula(&self, atoms: &[Atom], level: usize) -> Result<Row, DrawingError> {
        let mut row = Row::default();
        for (k, atom) in atoms.iter().enumerate() {
            if let Some(before) = k.checked_sub(1) {
                row.width += space(atoms[before].class, atom.class, level) * self.em(level);
            }
            row.join(&self.atom(atom, level)?, 0.0);
        }
        Ok(row)
    }

    fn atom(&self, atom: &Atom, level: usize) -> Result<Row, DrawingError> {
        let em = self.em(level);
        let mut row = match &atom.nucleus {
            Nucleus::Glyph(c) => self.glyph(*c, atom.accent, em)?,
            Nucleus::Word(word) => self.word(word, em)?,
            Nucleus::Group(inner) => self.formula(inner, level)?,
            Nucleus::Radical(inner) => self.radical(inner, level)?,
            Nucleus::ThinSpace => Row { width: em / 6.0, ..Row::default() },
        };
        if atom.superscript.is_empty() && atom.subscript.is_empty() {
            // TeX's rule: without a subscript the lean becomes part of the width.
            row.width += row.lean;
            row.lean = 0.0;
            return Ok(row);
        }
        let above = self.formula(&atom.superscript, level + 1)?;
        let below = self.formula(&atom.subscript, level + 1)?;
        let (up, down) = self.script_shifts(&row, &above, &below, em);
        let (base, lean) = (row.width, row.lean);
        row.place(&above, base + lean, up);
        row.place(&below, base, -down);
        row.width = (base + lean + above.width).max(base + below.width);
        row.width += self.constants.space_after_script * em;
        row.lean = 0.0;
        Ok(row)
    }

    /// Returns how far superscript and subscript move up and down, in px.
    fn script_shifts(&self, base: &Row, above: &Row, below: &Row, em: f64) -> (f64, f64) {
        let c = &self.constants;
        let mut up = (c.superscript_up * em)
            .max(above.depth + c.superscript_bottom_min * em)
            .max(base.height - c.superscript_drop_max * em);
        let mut down = (c.subscript_down * em).max(below.height - c.subscript_top_max * em);
        let gap = (up - above.depth) - (below.height - down);
        let missing = c.script_gap_min * em - gap;
        let both = above.height + above.depth > 0.0 && below.height + below.depth > 0.0;
        if both && missing > 0.0 {
            up += missing / 2.0;
            down += missing / 2.0;
        }
        (up, down)
    }

    fn radical(&self, inner: &[Atom], level: usize) -> Result<Row, DrawingError> {
        let em = self.em(level);
        let radicand = self.formula(inner, level)?;
        let rule = self.constants.radical_rule * em;
        let gap = self.constants.radical_gap * em;
        let wanted = radicand.height + radicand.depth + gap + rule;
        let sign = self.font.radical(wanted / em).ok_or_else(|| self.unknown('√'))?;
        let (bottom, top) = self.font.vertical_ink(sign);
        // The sign may be taller than wanted; half of the surplus goes below the radicand.
        let surplus = ((top - bottom) * em - wanted).max(0.0);
        let bar = radicand.height + gap + rule + surplus / 2.0;
        let mut row = Row { width: self.font.advance(sign) * em, ..Row::default() };
        let raise = bar - top * em;
        self.font.outline(sign, em, (0.0, -raise), &mut row.path);
        row.height = bar;
        row.depth = (-(bottom * em + raise)).max(0.0);
        // One tenth of a px of overlap: no hairline shows between the sign and its bar.
        let left = self.font.horizontal_ink(sign).1 * em - 0.1;
        let right = row.width + radicand.width;
        let over = Extent { left, top: -bar, right, bottom: rule - bar };
        row.path.append(&Path::rectangle(over));
        row.join(&radicand, 0.0);
        row.lean = 0.0;
        row.width += em / 18.0;
        Ok(row)
    }

    fn glyph(&self, c: char, accent: Option<char>, em: f64) -> Result<Row, DrawingError> {
        let glyph = self.font.glyph(c).ok_or_else(|| self.unknown(c))?;
        let (bottom, top) = self.font.vertical_ink(glyph);
        let mut row = Row {
            width: self.font.advance(glyph) * em,
            height: top.max(0.0) * em,
            depth: (-bottom).max(0.0) * em,
            lean: self.font.italic_correction(glyph) * em,
            ..Row::default()
        };
        self.font.outline(glyph, em, (0.0, 0.0), &mut row.path);
        if let Some(accent) = accent {
            let mark = self.font.glyph(accent).ok_or_else(|| self.unknown(accent))?;
            let (left, right) = self.font.horizontal_ink(mark);
            let x = (self.font.accent_centre(glyph) - (left + right) / 2.0) * em;
            let up = (top - self.constants.accent_base_height).max(0.0) * em;
            self.font.outline(mark, em, (x, -up), &mut row.path);
            row.height = row.height.max(self.font.vertical_ink(mark).1 * em + up);
        }
        Ok(row)
    }

    fn word(&self, word: &str, em: f64) -> Result<Row, DrawingError> {
        // Computer Modern's f runs into a following i or l unless they are one glyph.
        let word = word.replace("ffi", "ﬃ").replace("ffl", "ﬄ").replace("ff", "ﬀ");
        let word = word.replace("fi", "ﬁ").replace("fl", "ﬂ").replace('\'', "’");
        let mut row = Row::default();
        for c in word.chars() {
            row.join(&self.glyph(c, None, em)?, 0.0);
        }
        Ok(row)
    }

    fn unknown(&self, character: char) -> DrawingError {
        DrawingError::UnknownGlyph { character, label: self.label.to_owned() }
    }
}

/// Returns the white space between two classes in em, after Chapter 18 of The TeXbook.
fn space(left: Class, right: Class, level: usize) -> f64 {
    use Class::{Binary, Closing, Opening, Operator, Ordinary, Punctuation, Relation};
    let (thin, medium, thick) = (3.0 / 18.0, 4.0 / 18.0, 5.0 / 18.0);
    match (left, right) {
        (Operator, Ordinary | Operator) | (Ordinary | Closing, Operator) => thin,
        // Scripts are set tight.
        _ if level > 0 => 0.0,
        (Punctuation, _) => thin,
        (_, Punctuation) | (Opening, _) | (_, Closing) => 0.0,
        (Binary, _) | (_, Binary) => medium,
        (Relation, Relation) => 0.0,
        (Relation, _) | (_, Relation) => thick,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::{Align, DrawingError, Extent, Path, TextBlock, typeset};

    fn set(label: &str) -> TextBlock {
        typeset(label, 100.0, Align::Left).expect("well formed")
    }

    /// The ink of `label` from the segment on at which that of its beginning would end.
    fn ink_after(beginning: &str, label: &str) -> Extent {
        ink_between(beginning, label, label)
    }

    /// The ink of `label` between the ends of two of its beginnings.
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
        // The italic corrections of the font, at 100 px an em; an upright letter has none.
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
            // A letter may lean over its advance by a few hundredths of an em.
            assert!(block.extent.inset(-8.0, -0.01).contains(&ink), "{label}: {ink:?}");
            let turned = block.upwards();
            assert!((turned.extent.height() - block.extent.width()).abs() <= 1e-9);
        }
    }
}
