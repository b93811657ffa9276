//! `Text`: an expression in a file, written as a string or as a number.

use std::{borrow::Cow, fmt, ops::Range};

use super::placed::Placed;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, de};

/// An expression, and the bytes of the file where it stands.
pub(crate) type Text = Placed<Expression>;

/// An expression such as `"2 - cos(x1)"`, or a number such as `0.5`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Expression(pub(crate) String);

impl JsonSchema for Expression {
    fn schema_name() -> Cow<'static, str> {
        "Expression".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A number, or an expression such as \"2 - cos(x1)\".",
            "type": ["string", "number"],
        })
    }
}

impl<'de> Deserialize<'de> for Expression {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl de::Visitor<'_> for Visitor {
            type Value = Expression;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or an expression in quotes")
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                Ok(Expression(value.to_string()))
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                if !value.is_finite() {
                    return Err(E::custom(format_args!("{value} is not a finite number")));
                }
                // The shortest text that parses to this number.
                Ok(Expression(format!("{value:?}")))
            }

            fn visit_str<E: de::Error>(self, value: &str) -> Result<Self::Value, E> {
                Ok(Expression(value.to_owned()))
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

/// Returns the bytes of the file at which the bytes `at` of an expression stand. `span` is that of
/// the whole value, with its quotes. Escapes make a string longer in the file than it is.
pub(crate) fn place(file: &str, span: Range<usize>, at: &Range<usize>) -> Range<usize> {
    let Some(written) = file.get(span.clone()) else { return span };
    let quotes = ["\"\"\"", "'''", "\"", "'"].into_iter().find(|quote| written.starts_with(quote));
    let Some(quote) = quotes else { return span };
    let mut begin = quote.len();
    if quote.len() == 3 {
        // A line break right after the quotes does not count.
        let rest = &written[3..];
        begin += if rest.starts_with("\r\n") { 2 } else { usize::from(rest.starts_with('\n')) };
    }
    let escapes = quote.starts_with('"');
    let (mut places, mut decoded) = (Vec::new(), 0);
    let mut rest =
        written[begin..written.len().saturating_sub(quote.len()).max(begin)].char_indices();
    while let Some((offset, c)) = rest.next() {
        let mut bytes = c.len_utf8();
        if escapes && c == '\\' {
            match rest.next() {
                Some((_, kind @ ('u' | 'U' | 'x'))) => {
                    let digits = match kind {
                        'x' => 2,
                        'u' => 4,
                        _ => 8,
                    };
                    let code: String = rest.by_ref().take(digits).map(|(_, c)| c).collect();
                    let code = u32::from_str_radix(&code, 16).ok().and_then(char::from_u32);
                    bytes = code.map_or(1, char::len_utf8);
                }
                // A line break after a backslash, and the blanks after it, do not count.
                Some((_, next)) if next.is_whitespace() => {
                    while rest.clone().next().is_some_and(|(_, c)| c.is_whitespace()) {
                        rest.next();
                    }
                    bytes = 0;
                }
                _ => bytes = 1,
            }
        }
        places.extend((decoded..decoded + bytes).map(|_| begin + offset));
        decoded += bytes;
    }
    let end = written.len().saturating_sub(quote.len());
    let of = |byte: usize| span.start + places.get(byte).copied().unwrap_or(end);
    let last =
        if at.end > at.start { of(at.end - 1) + width(file, of(at.end - 1)) } else { of(at.start) };
    of(at.start)..last.min(span.start + end).max(of(at.start))
}

/// Returns the number of bytes of the character at this byte, or 1 for an escape.
fn width(file: &str, byte: usize) -> usize {
    file.get(byte..).and_then(|rest| rest.chars().next()).map_or(1, char::len_utf8)
}

#[cfg(test)]
mod tests {
    use super::{Expression, Placed, place};

    #[track_caller]
    fn underlined<'f>(file: &'f str, part: &str) -> &'f str {
        #[derive(serde::Deserialize)]
        struct File {
            f: Placed<Expression>,
        }
        let File { f } = toml::from_str(file).expect("a file");
        let Expression(text) = f.get_ref();
        let begin = text.find(part).unwrap_or_else(|| panic!("{part} in {text}"));
        &file[place(file, f.span(), &(begin..begin + part.len()))]
    }

    #[test]
    fn a_part_of_an_expression_is_found_in_the_file() {
        for file in [
            "f = \"1 + cos(y)\"",
            "f = '1 + cos(y)'",
            "f = '''\n1 +\ncos(y)'''",
            "\n f = \"\"\"1 \\\n  + cos(y)\"\"\" # y",
        ] {
            assert_eq!(underlined(file, "y"), "y", "{file}");
            assert_eq!(underlined(file, "cos"), "cos", "{file}");
            assert_eq!(underlined(file, "y)"), "y)", "{file}");
        }
        assert_eq!(underlined("f = \"1\\t+ \\u0041y\"", "y"), "y");
        assert_eq!(underlined("f = \"1 + äöy\"", "y"), "y");
        assert_eq!(underlined("f = \"1 + äöy\"", "ö"), "ö");
    }

    #[test]
    fn the_end_of_an_expression_is_before_its_quote() {
        let file = "f = '1 +'";
        let at = place(file, 4..9, &(3..3));
        assert_eq!(at, 8..8);
        // A number has no quotes, and is underlined as a whole.
        assert_eq!(place("f = 1.5", 4..7, &(0..1)), 4..7);
    }
}
