//! The syntax of labels: text with mathematics between dollar signs.

use crate::error::DrawingError;

/// A piece of a label.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Piece {
    /// Upright text.
    Text(String),
    /// A formula.
    Math(Vec<Atom>),
}

/// The innermost part of an atom, to which scripts are attached.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Nucleus {
    /// One character, already in its mathematical alphabet.
    Glyph(char),
    /// An upright word, as in the index of `E_"tra"`.
    Word(String),
    /// A formula in braces.
    Group(Vec<Atom>),
    /// A formula under a root.
    Radical(Vec<Atom>),
    /// An explicit thin space.
    ThinSpace,
}

/// The role of an atom in its formula, which determines the white space around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    Ordinary,
    Operator,
    Binary,
    Relation,
    Opening,
    Closing,
    Punctuation,
}

/// A nucleus with an accent and scripts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Atom {
    pub(crate) nucleus: Nucleus,
    pub(crate) class: Class,
    pub(crate) accent: Option<char>,
    pub(crate) superscript: Vec<Atom>,
    pub(crate) subscript: Vec<Atom>,
}

/// Splits one line of a label into text and formulas.
pub(crate) fn parse(label: &str) -> Result<Vec<Piece>, DrawingError> {
    let malformed = |problem| DrawingError::MalformedLabel { label: label.to_owned(), problem };
    let parts: Vec<&str> = label.split('$').collect();
    if parts.len().is_multiple_of(2) {
        return Err(malformed("an odd number of dollar signs"));
    }
    let mut pieces = Vec::new();
    for (k, part) in parts.into_iter().enumerate().filter(|(_, part)| !part.is_empty()) {
        if k.is_multiple_of(2) {
            pieces.push(Piece::Text(part.to_owned()));
            continue;
        }
        let mut reader = Reader { rest: part.chars().collect(), at: 0 };
        let atoms = reader.row().map_err(malformed)?;
        if reader.at < reader.rest.len() {
            return Err(malformed("a closing brace without its opening one"));
        }
        pieces.push(Piece::Math(atoms));
    }
    Ok(pieces)
}

struct Reader {
    rest: Vec<char>,
    at: usize,
}

impl Reader {
    fn next(&mut self) -> Option<char> {
        let c = self.rest.get(self.at).copied();
        self.at += usize::from(c.is_some());
        c
    }

    /// Reads up to the end or to a closing brace, which it leaves to the caller.
    fn row(&mut self) -> Result<Vec<Atom>, &'static str> {
        let mut atoms: Vec<Atom> = Vec::new();
        // Opening and closing bars have the same sign, so their class alternates.
        let mut bar_is_open = false;
        while let Some(&c) = self.rest.get(self.at) {
            match c {
                '}' => break,
                ' ' => self.at += 1,
                '^' | '_' => {
                    self.at += 1;
                    let script = self.argument()?;
                    let base = atoms.last_mut().ok_or("a script without a base")?;
                    let slot = if c == '^' { &mut base.superscript } else { &mut base.subscript };
                    if !slot.is_empty() {
                        return Err("two scripts at one place; use braces");
                    }
                    *slot = script;
                }
                '\u{302}'..='\u{308}' => {
                    self.at += 1;
                    atoms.last_mut().ok_or("an accent without a letter")?.accent = Some(c);
                }
                '|' | '‖' => {
                    self.at += 1;
                    let class = if bar_is_open { Class::Closing } else { Class::Opening };
                    bar_is_open = !bar_is_open;
                    atoms.push(Atom::new(Nucleus::Glyph(c), class));
                }
                _ => atoms.push(self.atom()?),
            }
        }
        settle_signs(&mut atoms);
        Ok(atoms)
    }

    /// Reads the argument of a script or a root: a group in braces or one atom.
    fn argument(&mut self) -> Result<Vec<Atom>, &'static str> {
        while self.rest.get(self.at) == Some(&' ') {
            self.at += 1;
        }
        let atom = self.atom()?;
        let inner = match atom.nucleus {
            Nucleus::Group(inner) => inner,
            _ => vec![atom],
        };
        if inner.is_empty() { Err("an empty argument") } else { Ok(inner) }
    }

    fn atom(&mut self) -> Result<Atom, &'static str> {
        match self.next().ok_or("a script, root or accent without its argument")? {
            '{' => {
                let inner = self.row()?;
                match self.next() {
                    Some('}') => Ok(Atom::new(Nucleus::Group(inner), Class::Ordinary)),
                    _ => Err("an opening brace without its closing one"),
                }
            }
            '"' => {
                let word: String =
                    std::iter::from_fn(|| self.next().filter(|c| *c != '"')).collect();
                if self.rest.get(self.at - 1) != Some(&'"') || word.is_empty() {
                    return Err("a quoted word that is empty or does not end");
                }
                Ok(Atom::new(Nucleus::Word(word), Class::Operator))
            }
            '√' => Ok(Atom::new(Nucleus::Radical(self.argument()?), Class::Ordinary)),
            '\u{2009}' => Ok(Atom::new(Nucleus::ThinSpace, Class::Ordinary)),
            c if "^_}".contains(c) => Err("a script, root or accent without its argument"),
            c => Ok(Atom::new(Nucleus::Glyph(mathematical(c)), class_of(c))),
        }
    }
}

impl Atom {
    fn new(nucleus: Nucleus, class: Class) -> Atom {
        Atom { nucleus, class, accent: None, superscript: Vec::new(), subscript: Vec::new() }
    }
}

/// Turns a sign into an ordinary atom if an operand is missing on its left or right: `−1`, `(−x)`,
/// `C^{+}`.
fn settle_signs(atoms: &mut [Atom]) {
    use Class::{Binary, Closing, Opening, Ordinary, Punctuation, Relation};
    for k in 0..atoms.len() {
        if atoms[k].class != Binary {
            continue;
        }
        let left = k.checked_sub(1).map(|before| atoms[before].class);
        let right = atoms.get(k + 1).map(|after| after.class);
        // A word counts as an operand: in figures "cost − 2" is likelier than "cos −x".
        let lonely_left = matches!(left, None | Some(Binary | Relation | Opening | Punctuation));
        let lonely_right = matches!(right, None | Some(Relation | Closing | Punctuation));
        if lonely_left || lonely_right {
            atoms[k].class = Ordinary;
        }
    }
}

fn class_of(c: char) -> Class {
    match c {
        '+' | '-' | '−' | '±' | '∓' | '·' | '⋅' | '×' | '÷' | '∘' | '∗' | '*' | '⊕' | '⊗' | '∪'
        | '∩' | '∧' | '∨' | '∖' => Class::Binary,
        '=' | '<' | '>' | '≤' | '≥' | '≪' | '≫' | '≈' | '∼' | '≃' | '≅' | '≡' | '≠' | '∈' | '∉'
        | '⊂' | '⊃' | '⊆' | '⊇' | '→' | '←' | '↔' | '↦' | '∝' | '≲' | '≳' | ':' => {
            Class::Relation
        }
        '(' | '[' | '⟨' | '⌊' | '⌈' => Class::Opening,
        ')' | ']' | '⟩' | '⌋' | '⌉' => Class::Closing,
        ',' | ';' => Class::Punctuation,
        _ => Class::Ordinary,
    }
}

/// Returns the character in its mathematical alphabet. As in TeX, Latin and small Greek letters are
/// slanted, and capital Greek letters and digits are upright.
fn mathematical(c: char) -> char {
    let shifted = |first: u32, base: char| char::from_u32(first + u32::from(c) - u32::from(base));
    let slanted = match c {
        // Unicode has no slanted h in this alphabet, because the Planck constant already existed.
        'h' => Some('ℎ'),
        'A'..='Z' => shifted(0x1D434, 'A'),
        'a'..='z' => shifted(0x1D44E, 'a'),
        'α'..='ω' => shifted(0x1D6FC, 'α'),
        'ϕ' => Some('𝜙'),
        'ϵ' => Some('𝜖'),
        '-' => Some('−'),
        '*' => Some('∗'),
        _ => None,
    };
    slanted.unwrap_or(c)
}

#[cfg(test)]
mod tests {
    use super::{Class, Nucleus, Piece, parse};

    fn classes(formula: &str) -> Vec<Class> {
        let pieces = parse(&format!("${formula}$")).expect("well formed");
        let [Piece::Math(atoms)] = &pieces[..] else { panic!("one formula, got {pieces:?}") };
        atoms.iter().map(|atom| atom.class).collect()
    }

    #[test]
    fn a_minus_is_binary_only_between_two_operands() {
        use Class::{Binary, Closing, Opening, Ordinary, Relation};
        assert_eq!(classes("a-b"), [Ordinary, Binary, Ordinary]);
        assert_eq!(classes("-b"), [Ordinary, Ordinary]);
        assert_eq!(classes("a=-b"), [Ordinary, Relation, Ordinary, Ordinary]);
        assert_eq!(classes("(-b)"), [Opening, Ordinary, Ordinary, Closing]);
        assert_eq!(classes("|a|-b"), [Opening, Ordinary, Closing, Binary, Ordinary]);
    }

    #[test]
    fn letters_are_slanted_and_quoted_words_are_not() {
        let pieces = parse("value $γ^\"pl\"$").expect("well formed");
        let [Piece::Text(text), Piece::Math(atoms)] = &pieces[..] else { panic!("{pieces:?}") };
        assert_eq!(text, "value ");
        assert_eq!(atoms[0].nucleus, Nucleus::Glyph('𝛾'));
        assert_eq!(atoms[0].superscript[0].nucleus, Nucleus::Word("pl".to_owned()));
    }

    #[test]
    fn malformed_labels_are_refused() {
        for bad in ["$x", "$x^$", "$^2$", "$x^1^2$", "$x_{1$", "$x}$", "$\"pl$", "$x_{}$", "$√$"]
        {
            assert!(parse(bad).is_err(), "{bad} was accepted");
        }
    }
}
