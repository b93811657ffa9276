//! `Cursor`: a text that is parsed from the left.

/// The rest of a text that has not been parsed yet.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a>(pub(super) &'a str);

impl<'a> Cursor<'a> {
    /// Skips blanks, and the expected character if it follows; returns whether it did.
    pub(super) fn eat(&mut self, expected: char) -> bool {
        let after = self.0.trim_start().strip_prefix(expected);
        self.0 = after.unwrap_or(self.0);
        after.is_some()
    }

    /// Skips blanks, and returns the text before the next of these characters.
    pub(super) fn word(&mut self, ends: &str) -> &'a str {
        let text = self.0.trim_start();
        let (word, after) = text.split_at(text.find(|c| ends.contains(c)).unwrap_or(text.len()));
        self.0 = after;
        word
    }

    /// Parses elements separated by commas up to `end`; returns `None` if one of them cannot be
    /// parsed.
    pub(super) fn list<T>(
        &mut self,
        end: char,
        read: impl Fn(&mut Self) -> Option<T>,
    ) -> Option<Vec<T>> {
        let mut elements = Vec::new();
        while !self.eat(end) {
            elements.push(read(self)?);
            self.eat(',');
        }
        Some(elements)
    }
}
