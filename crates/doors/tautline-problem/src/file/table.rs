//! `TableFile`: an array of numbers, in a file of its own or in the problem file.

use std::{borrow::Cow, fmt};

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{
    Deserialize, Deserializer,
    de::{self, SeqAccess, Visitor},
};

use super::placed::Placed;

/// An array on one to three axes as a smooth function, which formulas call with as many numbers:
/// `h(i, j)` is the number in row `i` and column `j`, counted from 0, unless these are smoothed, and goes on
/// with the values at the border.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TableFile {
    /// The numbers: a list, a list of rows, or a list of lists of rows.
    pub(crate) values: Option<Placed<Nested>>,
    /// A NPY file of numbers, or a PNG picture, found from the folder of the problem file. A picture is
    /// its rows from the top. Its pixels have numbers from 0 to 255, also where a number has fewer bits, or
    /// to 65535 with sixteen bits.
    pub(crate) file: Option<Placed<String>>,
    /// Which entry of the last axes, from 1: a channel of a picture with colours, such as `[1]`, or an
    /// entry of a matrix at each point, such as `[1, 2]`.
    pub(crate) component: Option<Placed<Vec<usize>>>,
    /// How the function goes between the numbers; `"monotone"` unless said otherwise.
    #[serde(default)]
    pub(crate) spline: SplineFile,
}

/// How a function goes between numbers.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum SplineFile {
    /// Through the numbers, and between them: it neither overshoots nor rings.
    #[default]
    Monotone,
    /// Through the numbers. It is more accurate where they are smooth, and overshoots where they jump.
    Cubic,
    /// Between neighbouring numbers, each of which it replaces by a mean of those around it.
    Smoothing,
}

/// A number, or a list of such.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Nested {
    Number(f64),
    List(Vec<Nested>),
}

impl JsonSchema for Nested {
    fn schema_name() -> Cow<'static, str> {
        "Numbers".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let number = json_schema!({ "type": "number" });
        let list_of = |item: &Schema| json_schema!({ "type": "array", "items": item });
        let [row, rows] = [list_of(&number), list_of(&list_of(&number))];
        json_schema!({
            "description": "A list of numbers, of rows, or of lists of rows.",
            "anyOf": [row, rows, list_of(&rows)],
        })
    }
}

impl<'de> Deserialize<'de> for Nested {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OfNumbers;
        impl<'de> Visitor<'de> for OfNumbers {
            type Value = Nested;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("numbers in brackets, such as [[0, 1], [1, 2]]")
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Nested, E> {
                Ok(Nested::Number(value as f64))
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Nested, E> {
                Ok(Nested::Number(value))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Nested, A::Error> {
                let mut list = Vec::new();
                while let Some(item) = items.next_element()? {
                    list.push(item);
                }
                Ok(Nested::List(list))
            }
        }
        deserializer.deserialize_any(OfNumbers)
    }
}
