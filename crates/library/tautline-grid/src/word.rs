//! `Word`: on which sides a curve passes some points of the plane.

use std::{collections::HashMap, fmt};

/// The homotopy class of a curve in the plane without some points, the punctures, for fixed ends.
///
/// From each puncture a ray goes out, and the rays are parallel. The word lists the rays that the curve
/// crosses, in its order: the ray of puncture `k`, counted from 1, as `k` or as `−k` by the direction of
/// the crossing. A letter and its inverse that follow each other cancel. What is left after that is the
/// same for two curves exactly if one can be moved into the other without passing over a puncture.
///
/// Curves between sets are prolonged for it, by chords to one member of each set. Then it is also the same
/// for curves between convex sets without punctures in them that can be moved into each other while their
/// ends move in the sets. In any other set the chords may pass over punctures: two curves with different
/// words may be such, and two with the same word may not.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Word(Vec<i32>);

impl Word {
    /// Returns the letters.
    #[must_use]
    pub fn letters(&self) -> &[i32] {
        &self.0
    }

    /// Appends a letter, or cancels the last one.
    pub(crate) fn push(&mut self, letter: i32) {
        if self.0.last() == Some(&-letter) {
            self.0.pop();
        } else {
            self.0.push(letter);
        }
    }
}

impl fmt::Display for Word {
    /// Writes the letters with their signs, and `0` for the empty word.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            return f.write_str("0");
        }
        for (place, letter) in self.0.iter().enumerate() {
            let space = if place == 0 { "" } else { " " };
            write!(f, "{space}{letter:+}")?;
        }
        Ok(())
    }
}

/// The words that a search has met, each as the place of the word without its last letter, and that
/// letter. Place 0 is the empty word.
pub(crate) struct Words {
    known: Vec<(u32, i32)>,
    longer: HashMap<(u32, i32), u32>,
}

impl Words {
    pub(crate) fn new() -> Self {
        Self { known: vec![(0, 0)], longer: HashMap::new() }
    }

    /// Returns how many words there are.
    pub(crate) fn count(&self) -> usize {
        self.known.len()
    }

    /// Returns the place of a word with another letter.
    pub(crate) fn with(&mut self, word: u32, letter: i32) -> u32 {
        let (shorter, last) = self.known[word as usize];
        if last == -letter {
            return shorter;
        }
        let next = self.known.len() as u32;
        let place = *self.longer.entry((word, letter)).or_insert(next);
        if place == next {
            self.known.push((word, letter));
        }
        place
    }

    /// Returns the word at a place.
    pub(crate) fn word(&self, mut at: u32) -> Word {
        let mut letters = Vec::new();
        while at != 0 {
            let (shorter, last) = self.known[at as usize];
            letters.push(last);
            at = shorter;
        }
        letters.reverse();
        Word(letters)
    }
}

#[cfg(test)]
mod tests {
    use super::{Word, Words};

    #[test]
    fn a_letter_and_its_inverse_cancel() {
        let mut word = Word::default();
        for letter in [1, 2, -2, -1, 3] {
            word.push(letter);
        }
        assert_eq!(word.letters(), [3]);
        assert_eq!(word.to_string(), "+3");
        assert_eq!(Word::default().to_string(), "0");
    }

    #[test]
    fn words_are_found_again() {
        let mut words = Words::new();
        let one = words.with(0, 1);
        let both = words.with(one, -2);
        assert_eq!(words.with(0, 1), one);
        assert_eq!(words.with(both, 2), one);
        assert_eq!(words.with(one, -1), 0);
        assert_eq!(words.count(), 3);
        assert_eq!(words.word(both).letters(), [1, -2]);
    }
}
