//! `Token`: the words of a text.

use std::ops::Range;

use super::{Problem, TextError};

/// A word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Token<'a> {
    Number(f64),
    /// A number without a point and an exponent.
    Integer(&'a str),
    Name(&'a str),
    /// One of `+ - * / ^ ( ) [ ] , ; =`.
    Sign(char),
    End,
}

/// The tokenizer.
#[derive(Clone, Debug)]
pub(super) struct Tokens<'a> {
    text: &'a str,
    place: usize,
}

impl<'a> Tokens<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        Self { text, place: 0 }
    }

    /// Returns the next word and its bytes.
    pub(super) fn word(&mut self) -> Result<(Token<'a>, Range<usize>), TextError> {
        let rest = self.text[self.place..].trim_start();
        let start = self.text.len() - rest.len();
        let Some(first) = rest.chars().next() else {
            self.place = start;
            return Ok((Token::End, start..start));
        };
        let length = match first {
            '0'..='9' | '.' => number(rest),
            'a'..='z' | 'A'..='Z' | '_' => {
                rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len())
            }
            _ => first.len_utf8(),
        };
        let at = start..start + length;
        let word = &rest[..length];
        self.place = at.end;
        let token = match first {
            '0'..='9' | '.' => {
                // Only a lone point does not parse.
                let unexpected =
                    || Problem::Unexpected { found: word.to_owned(), expected: "a number" };
                let value: f64 = word
                    .parse()
                    .map_err(|_| TextError { at: at.clone(), problem: unexpected() })?;
                let mantissa = word.split(['e', 'E']).next().unwrap_or_default();
                let is_lost =
                    value == 0.0 && mantissa.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
                if !value.is_finite() || is_lost {
                    return Err(TextError { at, problem: Problem::TooLarge });
                }
                let is_integer = word.bytes().all(|byte| byte.is_ascii_digit());
                if is_integer { Token::Integer(word) } else { Token::Number(value) }
            }
            'a'..='z' | 'A'..='Z' | '_' => Token::Name(word),
            '*' if rest.starts_with("**") => {
                self.place += 1;
                return Ok((Token::Sign('^'), at.start..at.end + 1));
            }
            '+' | '-' | '*' | '/' | '^' | '(' | ')' | '[' | ']' | ',' | ';' | '=' => {
                Token::Sign(first)
            }
            _ => {
                let expected = "a number, a name or a sign";
                let problem = Problem::Unexpected { found: word.to_owned(), expected };
                return Err(TextError { at, problem });
            }
        };
        Ok((token, at))
    }
}

/// Returns the length of the number at the beginning of a text: digits, a point, digits, and an
/// exponent if it has digits.
fn number(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits =
        |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut length = digits(0);
    if bytes.get(length) == Some(&b'.') {
        length += 1;
        length += digits(length);
    }
    if matches!(bytes.get(length), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
        let exponent = bytes.get(length + 1 + sign..).map_or(0, |_| digits(length + 1 + sign));
        if exponent > 0 {
            length += 1 + sign + exponent;
        }
    }
    length
}
