//! `Cursor`: a text that is read from the left.

/// What is left of a text.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a>(pub(super) &'a str);

impl<'a> Cursor<'a> {
    /// Skips blanks, and the expected character if it follows; returns whether it does.
    pub(super) fn eat(&mut self, expected: char) -> bool {
        let after = self.0.trim_start().strip_prefix(expected);
        self.0 = after.unwrap_or(self.0);
        after.is_some()
    }

    /// Skips blanks, and returns what stands before the next of these characters.
    pub(super) fn word(&mut self, ends: &str) -> &'a str {
        let text = self.0.trim_start();
        let (word, after) = text.split_at(text.find(|c| ends.contains(c)).unwrap_or(text.len()));
        self.0 = after;
        word
    }

    /// Reads elements between commas up to `end`; `None` if one cannot be read.
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
