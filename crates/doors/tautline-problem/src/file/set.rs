//! `SetFile`: a closed set in a file.

use std::{borrow::Cow, fmt};

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{
    Deserialize, Deserializer,
    de::{DeserializeSeed, EnumAccess, Error, MapAccess, VariantAccess, Visitor},
};
use tautline::sets::kind::{Form, Kind, Part};

use super::{expression::Text, one_of, placed::Placed};

/// The coordinates of a point or a vector.
pub(crate) type Vector = Placed<Vec<Text>>;

/// A closed set: one of the keys of [`Kind::ALL`], or `union`.
#[derive(Clone, Debug)]
pub(crate) enum SetFile {
    /// A set under the key of its kind.
    Piece(PieceFile),
    /// The union of sets: `union = [{ point = [0, 0] }, { ball = … }]`.
    Union(Placed<Vec<SetFile>>),
}

/// What a file says about a set of one kind.
#[derive(Clone, Debug)]
pub(crate) struct PieceFile {
    pub(crate) kind: Kind,
    /// The values of the parts of the kind, in their order; both sides if a file gives both.
    pub(crate) values: Vec<ValueFile>,
}

/// What a file says about a part.
#[derive(Clone, Debug)]
pub(crate) enum ValueFile {
    Vector(Vector),
    Vectors(Placed<Vec<Vector>>),
    Number(Text),
    /// At least, and at most.
    Sides([Option<Text>; 2]),
}

/// A box.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Corners {
    /// The corner with the least coordinates.
    pub(crate) lower: Vector,
    /// The corner with the largest coordinates.
    pub(crate) upper: Vector,
}

/// The key of a union.
const UNION: &str = "union";

impl SetFile {
    /// Returns all points and vectors, in the order of their fields.
    pub(crate) fn vectors(&self) -> Vec<&Vector> {
        match self {
            SetFile::Piece(piece) => piece.values.iter().flat_map(ValueFile::vectors).collect(),
            SetFile::Union(sets) => sets.get_ref().iter().flat_map(SetFile::vectors).collect(),
        }
    }
}

impl ValueFile {
    fn vectors(&self) -> &[Vector] {
        match self {
            ValueFile::Vector(x) => std::slice::from_ref(x),
            ValueFile::Vectors(vectors) => vectors.get_ref(),
            ValueFile::Number(_) | ValueFile::Sides(_) => &[],
        }
    }
}

impl<'de> Deserialize<'de> for SetFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Keyed;
        impl<'de> Visitor<'de> for Keyed {
            type Value = SetFile;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a set")
            }

            fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<SetFile, A::Error> {
                let (kind, value) = data.variant_seed(Key)?;
                match kind {
                    Some(kind) => value.newtype_variant_seed(Values(kind)).map(SetFile::Piece),
                    None => value.newtype_variant().map(SetFile::Union),
                }
            }
        }
        deserializer.deserialize_enum("SetFile", &[], Keyed)
    }
}

/// The key of a set, which has a kind or is a union.
struct Key;

impl<'de> DeserializeSeed<'de> for Key {
    type Value = Option<Kind>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        let key = String::deserialize(deserializer)?;
        let kind = Kind::keyed(&key);
        if kind.is_none() && key != UNION {
            let keys = Kind::ALL.iter().map(|kind| kind.key).chain([UNION]);
            return Err(D::Error::custom(one_of("variant", &key, keys)));
        }
        Ok(kind)
    }
}

/// The values of a set of a kind.
pub(crate) struct Values(pub(crate) Kind);

impl<'de> DeserializeSeed<'de> for Values {
    type Value = PieceFile;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<PieceFile, D::Error> {
        let Self(kind) = self;
        let values = match kind.parts {
            [only] => {
                let mut value = None;
                read(only, only.name, &mut value, deserializer)?;
                value.into_iter().collect()
            }
            _ => deserializer.deserialize_map(self)?,
        };
        Ok(PieceFile { kind, values })
    }
}

impl<'de> Visitor<'de> for Values {
    type Value = Vec<ValueFile>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("keys and values in braces")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let Self(kind) = self;
        let mut values = vec![None; kind.parts.len()];
        while let Some((k, part, name)) = map.next_key_seed(Name(kind))? {
            map.next_value_seed(Named { part, name, value: &mut values[k] })?;
        }
        let filled = |(value, part): (Option<ValueFile>, &Part)| match part.form {
            Form::Side => Ok(value.unwrap_or(ValueFile::Sides([None, None]))),
            _ => value.ok_or(A::Error::missing_field(part.name)),
        };
        values.into_iter().zip(kind.parts).map(filled).collect()
    }
}

/// The name of a part of a kind.
struct Name(Kind);

impl<'de> DeserializeSeed<'de> for Name {
    type Value = (usize, &'static Part, &'static str);

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        let name = String::deserialize(deserializer)?;
        let unknown = || D::Error::custom(one_of("field", &name, self.0.names()));
        self.0.part_named(&name).ok_or_else(unknown)
    }
}

/// The value of a part that is written under a name.
struct Named<'v> {
    part: &'static Part,
    name: &'static str,
    value: &'v mut Option<ValueFile>,
}

impl<'de> DeserializeSeed<'de> for Named<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        read(self.part, self.name, self.value, deserializer)
    }
}

/// Reads the value of a part; of two sides the one with this name.
fn read<'de, D: Deserializer<'de>>(
    part: &'static Part,
    name: &str,
    value: &mut Option<ValueFile>,
    deserializer: D,
) -> Result<(), D::Error> {
    let read = match part.form {
        Form::Vector => ValueFile::Vector(Vector::deserialize(deserializer)?),
        Form::Vectors => ValueFile::Vectors(Placed::deserialize(deserializer)?),
        Form::Number => ValueFile::Number(Text::deserialize(deserializer)?),
        Form::Side => {
            let mut sides = match value.take() {
                Some(ValueFile::Sides(sides)) => sides,
                _ => [None, None],
            };
            let side = usize::from(name == "at_most");
            sides[side] = Some(Text::deserialize(deserializer)?);
            ValueFile::Sides(sides)
        }
    };
    *value = Some(read);
    Ok(())
}

impl JsonSchema for SetFile {
    fn schema_name() -> Cow<'static, str> {
        "SetFile".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let sets = generator.subschema_for::<Vec<SetFile>>();
        let mut keys: Vec<Schema> = Kind::ALL
            .iter()
            .map(|kind| keyed(kind.key, kind.about, described(*kind, generator)))
            .collect();
        let union = "The union of sets: `union = [{ point = [0, 0] }, { ball = … }]`.";
        keys.push(keyed(UNION, union, sets));
        let names: Vec<String> = Kind::ALL.iter().map(|kind| format!("`{}`", kind.key)).collect();
        let about = format!("A closed set: one of the keys {} and `{UNION}`.", names.join(", "));
        json_schema!({ "description": about, "oneOf": keys })
    }
}

/// Returns the schema of a table with one key.
fn keyed(key: &str, about: &str, value: Schema) -> Schema {
    json_schema!({
        "description": about,
        "type": "object",
        "properties": { key: value },
        "required": [key],
        "additionalProperties": false,
    })
}

/// Returns the schema of what describes a set of a kind.
pub(crate) fn described(kind: Kind, generator: &mut SchemaGenerator) -> Schema {
    let mut of_form = |form: Form| match form {
        Form::Vector => generator.subschema_for::<Vector>(),
        Form::Vectors => generator.subschema_for::<Vec<Vector>>(),
        Form::Number | Form::Side => generator.subschema_for::<Text>(),
    };
    if let [only] = kind.parts {
        return of_form(only.form);
    }
    let mut properties = serde_json::Map::new();
    let mut required = Vec::new();
    for part in kind.parts {
        for &name in part.names() {
            let mut schema = of_form(part.form);
            schema.insert("description".to_owned(), part.about.into());
            properties.insert(name.to_owned(), schema.to_value());
        }
        if part.form != Form::Side {
            required.push(part.name);
        }
    }
    json_schema!({
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    })
}
