//! Sets as they are read and written with the feature `serde`: by the names of their parts. What is read
//! goes through the constructors, which check it.

use std::fmt;

use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{DeserializeSeed, Error, MapAccess, Visitor},
    ser::SerializeMap,
};

use super::{Form, Kind, Part, Value};

/// Implements `Serialize` and `Deserialize` for a set by its parts.
macro_rules! by_parts {
    ($set:ident) => {
        impl<const D: usize> serde::Serialize for $set<D> {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                data::write(Self::KIND, &self.values(), serializer)
            }
        }

        impl<'de, const D: usize> serde::Deserialize<'de> for $set<D> {
            fn deserialize<R: serde::Deserializer<'de>>(reader: R) -> Result<Self, R::Error> {
                let other = SetError::Parts { what: Self::KIND.name };
                let set = Self::of(&data::read(Self::KIND, reader)?).ok_or(other);
                set.and_then(|set| set).map_err(serde::de::Error::custom)
            }
        }
    };
}
pub(crate) use by_parts;

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::Vector(x) => x.serialize(serializer),
            Value::Vectors(rows) => rows.serialize(serializer),
            Value::Number(x) | Value::AtMost(x) | Value::AtLeast(x) => x.serialize(serializer),
        }
    }
}

/// Writes the values of the parts under their names, or the only one without its name.
pub(crate) fn write<S: Serializer>(
    kind: Kind,
    values: &[Value],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    if let [only] = values {
        return only.serialize(serializer);
    }
    let mut map = serializer.serialize_map(Some(values.len()))?;
    for (part, value) in kind.parts.iter().zip(values) {
        map.serialize_entry(part.name_of(value), value)?;
    }
    map.end()
}

/// Reads the values of the parts.
pub(crate) fn read<'de, R: Deserializer<'de>>(
    kind: Kind,
    reader: R,
) -> Result<Vec<Value>, R::Error> {
    match kind.parts {
        [only] => Ok(vec![Named { part: only, name: only.name }.deserialize(reader)?]),
        _ => reader.deserialize_map(Parts(kind)),
    }
}

/// A part under one of its names, whose value is read.
struct Named {
    part: &'static Part,
    name: &'static str,
}

impl<'de> DeserializeSeed<'de> for Named {
    type Value = Value;

    fn deserialize<R: Deserializer<'de>>(self, reader: R) -> Result<Value, R::Error> {
        Ok(match self.part.form {
            Form::Vector => Value::Vector(Vec::deserialize(reader)?),
            Form::Vectors => Value::Vectors(Vec::deserialize(reader)?),
            Form::Number => Value::Number(f64::deserialize(reader)?),
            Form::Side if self.name == "at_least" => Value::AtLeast(f64::deserialize(reader)?),
            Form::Side => Value::AtMost(f64::deserialize(reader)?),
        })
    }
}

/// The parts of a set by their names.
struct Parts(Kind);

impl<'de> Visitor<'de> for Parts {
    type Value = Vec<Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.name)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Vec<Value>, A::Error> {
        let Self(kind) = self;
        let mut values = vec![None; kind.parts.len()];
        while let Some(key) = map.next_key::<String>()? {
            let Some((k, part, name)) = kind.part_named(&key) else {
                let names: Vec<_> = kind.names().map(|name| format!("`{name}`")).collect();
                let expected = names.join(", ");
                return Err(A::Error::custom(format!(
                    "unknown field `{key}`, expected {expected}"
                )));
            };
            if values[k].is_some() {
                return Err(A::Error::duplicate_field(name));
            }
            values[k] = Some(map.next_value_seed(Named { part, name })?);
        }
        let parts = values.into_iter().zip(kind.parts);
        parts.map(|(value, part)| value.ok_or(A::Error::missing_field(part.names()[0]))).collect()
    }
}
