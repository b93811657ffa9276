//! Sets one line of a label: its glyphs, scripts and roots, and the white space between them.

use super::{
    font::{FigureFont, MathConstants},
    formula::{Atom, Class, Nucleus, Piece, parse},
};
use crate::{
    error::DrawingError,
    geometry::{Extent, Path},
};

/// Outlines whose origin is at the left end of the baseline. All lengths are in px.
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    pub(super) path: Path,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) depth: f64,
    /// How far the last letter extends beyond `width`. A superscript moves to the right by this
    /// amount.
    lean: f64,
}

impl Row {
    /// Appends another row at the right end.
    fn join(&mut self, next: &Row) {
        self.place(next, self.width, 0.0);
        self.width += next.width;
        self.lean = next.lean;
    }

    /// Draws another row at `x`, raised by `up`, without adding to the width.
    fn place(&mut self, other: &Row, x: f64, up: f64) {
        self.path.append(&other.path.moved(x, -up));
        self.height = self.height.max(other.height + up);
        self.depth = self.depth.max(other.depth - up);
    }
}

/// Sets the lines of one label.
pub(super) struct Setter<'a> {
    font: &'static FigureFont,
    constants: MathConstants,
    /// The size, in px per em.
    size: f64,
    /// The label, which error messages quote.
    label: &'a str,
}

impl Setter<'_> {
    pub(super) fn new(size: f64, label: &str) -> Setter<'_> {
        let font = FigureFont::embedded();
        Setter { font, constants: font.constants(), size, label }
    }

    pub(super) fn line(&self, line: &str) -> Result<Row, DrawingError> {
        let mut row = Row::default();
        for piece in parse(line)? {
            let next = match piece {
                Piece::Text(text) => self.word(&text, self.size)?,
                Piece::Math(atoms) => self.formula(&atoms, 0)?,
            };
            row.join(&next);
        }
        Ok(row)
    }

    /// Returns px per em at nesting `level`: text, script, script of a script (and no smaller).
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
            row.join(&self.atom(atom, level)?);
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
            // TeX's rule: without a subscript, the overhang becomes part of the width.
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

    /// Returns how far the superscript moves up and the subscript moves down, in px.
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
        // The sign may be too tall. Half of the surplus goes below the radicand.
        let surplus = ((top - bottom) * em - wanted).max(0.0);
        let bar = radicand.height + gap + rule + surplus / 2.0;
        let mut row = Row { width: self.font.advance(sign) * em, ..Row::default() };
        let raise = bar - top * em;
        self.font.outline(sign, em, (0.0, -raise), &mut row.path);
        row.height = bar;
        row.depth = (-(bottom * em + raise)).max(0.0);
        // The sign and its bar overlap by a tenth of a px, so that no hairline shows between them.
        let left = self.font.horizontal_ink(sign).1 * em - 0.1;
        let right = row.width + radicand.width;
        let over = Extent { left, top: -bar, right, bottom: rule - bar };
        row.path.append(&Path::rectangle(over));
        row.join(&radicand);
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
        // The f of Computer Modern collides with a following i or l unless they form a single
        // glyph.
        let word = word.replace("ffi", "ﬃ").replace("ffl", "ﬄ").replace("ff", "ﬀ");
        let word = word.replace("fi", "ﬁ").replace("fl", "ﬂ").replace('\'', "’");
        let mut row = Row::default();
        for c in word.chars() {
            row.join(&self.glyph(c, None, em)?);
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
        // Scripts have no such space.
        _ if level > 0 => 0.0,
        (Punctuation, _) => thin,
        (_, Punctuation) | (Opening, _) | (_, Closing) => 0.0,
        (Binary, _) | (_, Binary) => medium,
        (Relation, Relation) => 0.0,
        (Relation, _) | (_, Relation) => thick,
        _ => 0.0,
    }
}
