//! `SweepFile`: the section `[sweep]` of a file, which says what varies.

use std::{borrow::Cow, collections::BTreeMap, fmt};

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{
    Deserialize, Deserializer,
    de::{self, IntoDeserializer},
};

use super::{
    expression::{Expression, Text},
    placed::Placed,
};

/// What varies in a sweep: every combination of values is a problem.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SweepFile {
    /// The number of random draws for each combination of the other values; 1 unless said otherwise.
    pub(crate) draws: Option<Placed<u64>>,
    /// The seed of the random draws.
    #[serde(default)]
    pub(crate) seed: u64,
    /// Values of parameters by their names. Those of `"a, b"` vary together.
    #[serde(default)]
    pub(crate) vary: BTreeMap<Placed<String>, Placed<ValuesFile>>,
}

/// The values of a parameter.
#[derive(Clone, Debug)]
pub(crate) enum ValuesFile {
    /// `[1, 2, 4]`, or `[[1, 2], [4, 3]]` for parameters that vary together.
    List(Vec<Placed<EntryFile>>),
    /// `{ from = 0, to = 1, count = 11 }`, or `{ uniform = [0, 1] }`.
    Table(RangeFile),
}

/// Equally spaced values, or random ones: either `from`, `to` and `count`, or `uniform`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RangeFile {
    /// The first value.
    pub(crate) from: Option<Text>,
    /// The last value.
    pub(crate) to: Option<Text>,
    /// The number of values.
    pub(crate) count: Option<Placed<u64>>,
    /// The ends of the interval in which values are drawn.
    pub(crate) uniform: Option<Placed<[Text; 2]>>,
}

/// An entry of a list.
#[derive(Clone, Debug)]
pub(crate) enum EntryFile {
    /// A value.
    One(Expression),
    /// A value for each of the parameters that vary together.
    Several(Vec<Text>),
}

impl<'de> Deserialize<'de> for ValuesFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = ValuesFile;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list, or a table of from, to and count or of uniform")
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, entries: A) -> Result<Self::Value, A::Error> {
                let entries = de::value::SeqAccessDeserializer::new(entries);
                Deserialize::deserialize(entries).map(ValuesFile::List)
            }

            fn visit_map<A: de::MapAccess<'de>>(self, table: A) -> Result<Self::Value, A::Error> {
                let table = de::value::MapAccessDeserializer::new(table);
                Deserialize::deserialize(table).map(ValuesFile::Table)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

impl<'de> Deserialize<'de> for EntryFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = EntryFile;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, an expression in quotes, or a list of them")
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                Deserialize::deserialize(value.into_deserializer()).map(EntryFile::One)
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                Deserialize::deserialize(value.into_deserializer()).map(EntryFile::One)
            }

            fn visit_str<E: de::Error>(self, value: &str) -> Result<Self::Value, E> {
                Deserialize::deserialize(value.into_deserializer()).map(EntryFile::One)
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, texts: A) -> Result<Self::Value, A::Error> {
                let texts = de::value::SeqAccessDeserializer::new(texts);
                Deserialize::deserialize(texts).map(EntryFile::Several)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

impl JsonSchema for ValuesFile {
    fn schema_name() -> Cow<'static, str> {
        "Values".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (text, range) = (generator.subschema_for::<Text>(), RangeFile::json_schema(generator));
        json_schema!({
            "description": "The values of a parameter.",
            "anyOf": [
                { "type": "array", "items": { "anyOf": [text, { "type": "array", "items": text }] } },
                range,
            ],
        })
    }
}
