//! NPY, the file format of one NumPy array, versions 1 to 3.
//!
//! A file is a magic string, the version, the length of the header, the header and the numbers. The
//! header is a dictionary in the syntax of Python, such as
//! `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }`. Libraries for this format parse all of
//! Python's literals, with dependencies that need a C compiler; three keys need neither.

use super::{Array, ArrayError, count};

/// The first bytes of a file.
pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";

pub(crate) fn read(file: &[u8]) -> Result<Array, ArrayError> {
    if let Some(version @ (0 | 4..)) = file.get(MAGIC.len()) {
        return Err(wrong(format!("its version is {version}; expected 1 to 3")));
    }
    let (header, data) = parts(file).ok_or_else(|| wrong("it ends too early"))?;
    let header = std::str::from_utf8(header).map_err(|_| wrong("it is no text"))?;
    let Header { descr, is_by_column, shape } = Header::read(header)?;
    let (decode, width) = decoder(&descr).ok_or(ArrayError::Type { descr })?;
    let expected = count(&shape).and_then(|count| count.checked_mul(width));
    let expected = expected.ok_or_else(|| wrong("its shape is larger than any memory"))?;
    if data.len() != expected {
        return Err(ArrayError::Length { shape, expected, found: data.len() });
    }
    let values: Vec<f64> = data.chunks_exact(width).map(decode).collect();
    let values = if is_by_column { by_row(&shape, &values) } else { values };
    Array::new(shape, values)
}

fn wrong(what: impl Into<String>) -> ArrayError {
    ArrayError::Header { what: what.into() }
}

/// Returns the header and the numbers, as bytes.
fn parts(file: &[u8]) -> Option<(&[u8], &[u8])> {
    let rest = file.strip_prefix(MAGIC)?;
    let (&[major, _minor], rest) = rest.split_first_chunk()?;
    let (length, rest) = if major == 1 {
        let (bytes, rest) = rest.split_first_chunk()?;
        (usize::from(u16::from_le_bytes(*bytes)), rest)
    } else {
        let (bytes, rest) = rest.split_first_chunk()?;
        (usize::try_from(u32::from_le_bytes(*bytes)).ok()?, rest)
    };
    rest.split_at_checked(length)
}

/// What a header says.
struct Header {
    descr: String,
    is_by_column: bool,
    shape: Vec<usize>,
}

impl Header {
    fn read(header: &str) -> Result<Self, ArrayError> {
        let expected = |what: &str, at: &str| {
            let found: String = at.chars().take(20).collect();
            wrong(format!("expected {what}, found {found:?}"))
        };
        let (mut descr, mut order, mut shape) = (None, None, None);
        let inside = header.trim().strip_prefix('{').and_then(|rest| rest.strip_suffix('}'));
        let mut rest =
            inside.ok_or_else(|| expected("a dictionary in braces", header))?.trim_start();
        while !rest.is_empty() {
            let (key, after) = quoted(rest).ok_or_else(|| expected("a key in quotes", rest))?;
            let value = after.trim_start().strip_prefix(':');
            let value = value.ok_or_else(|| expected(":", after))?.trim_start();
            let after = match key {
                "descr" => {
                    // A list describes records.
                    let records = || ArrayError::Type { descr: value.chars().take(20).collect() };
                    let (text, after) = quoted(value).ok_or_else(records)?;
                    descr = Some(text.to_owned());
                    after
                }
                "fortran_order" => {
                    let (is_by_column, after) =
                        flag(value).ok_or_else(|| expected("True or False", value))?;
                    order = Some(is_by_column);
                    after
                }
                "shape" => {
                    let (lengths, after) =
                        tuple(value).ok_or_else(|| expected("a tuple of lengths", value))?;
                    shape = Some(lengths);
                    after
                }
                _ => return Err(wrong(format!("its key {key:?} is unknown"))),
            };
            let after = after.trim_start();
            rest = after.strip_prefix(',').unwrap_or(after).trim_start();
        }
        let missing = |key: &str| wrong(format!("it has no {key}"));
        Ok(Self {
            descr: descr.ok_or_else(|| missing("descr"))?,
            is_by_column: order.ok_or_else(|| missing("fortran_order"))?,
            shape: shape.ok_or_else(|| missing("shape"))?,
        })
    }
}

/// Returns what stands in quotes, and the text after it.
fn quoted(text: &str) -> Option<(&str, &str)> {
    let quote = text.chars().next().filter(|&c| c == '\'' || c == '"')?;
    text[1..].split_once(quote)
}

fn flag(text: &str) -> Option<(bool, &str)> {
    let yes = text.strip_prefix("True").map(|rest| (true, rest));
    yes.or_else(|| text.strip_prefix("False").map(|rest| (false, rest)))
}

fn tuple(text: &str) -> Option<(Vec<usize>, &str)> {
    let (inside, rest) = text.strip_prefix('(')?.split_once(')')?;
    let lengths = inside.split(',').map(str::trim).filter(|length| !length.is_empty());
    // Python 2 wrote long integers with an L.
    let lengths = lengths.map(|length| length.trim_end_matches('L').parse().ok());
    Some((lengths.collect::<Option<_>>()?, rest))
}

/// The number of an entry of a file.
type Decode = fn(&[u8]) -> f64;

/// Returns how an entry is read, and of how many bytes it is.
fn decoder(descr: &str) -> Option<(Decode, usize)> {
    macro_rules! decoders {
        ($($code:literal: $type:ty),* $(,)?) => {
            match descr {
                $(
                    concat!("<", $code) => (|b| <$type>::from_le_bytes(sized(b)) as f64, size_of::<$type>()),
                    concat!(">", $code) => (|b| <$type>::from_be_bytes(sized(b)) as f64, size_of::<$type>()),
                )*
                // One byte has no order.
                "|i1" => (|b| f64::from(i8::from_le_bytes(sized(b))), 1),
                "|u1" => (|b| f64::from(sized::<1>(b)[0]), 1),
                "|b1" => (|b| f64::from(u8::from(sized::<1>(b) != [0])), 1),
                _ => return None,
            }
        };
    }
    let decoder: (Decode, usize) = decoders! {
        "f4": f32, "f8": f64,
        "i2": i16, "i4": i32, "i8": i64,
        "u2": u16, "u4": u32, "u8": u64,
    };
    Some(decoder)
}

/// Returns the bytes of an entry; `chunks_exact` made them of this length.
fn sized<const N: usize>(bytes: &[u8]) -> [u8; N] {
    bytes.try_into().unwrap_or([0; N])
}

/// Returns the numbers row by row, given those of an array column by column: the first axis varies
/// fastest there.
fn by_row(shape: &[usize], values: &[f64]) -> Vec<f64> {
    let mut index = vec![0; shape.len()];
    let mut sorted = Vec::with_capacity(values.len());
    for _ in 0..values.len() {
        let at = index.iter().zip(shape).rev().fold(0, |at, (index, length)| at * length + index);
        sorted.push(values[at]);
        for (index, length) in index.iter_mut().zip(shape).rev() {
            *index += 1;
            if *index < *length {
                break;
            }
            *index = 0;
        }
    }
    sorted
}
