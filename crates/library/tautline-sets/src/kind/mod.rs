//! Kinds of sets: the names under which vectors and numbers describe a set.
//!
//! What reads or writes sets by name takes the names from here: problem files with their schema, Python,
//! and serde.
//!
//! ```
//! use tautline_sets::{SetError, kind::{Kind, Value}};
//!
//! let kind = Kind::keyed("half_space").expect("a kind of set");
//! assert_eq!(kind.parts.iter().map(|part| part.name).collect::<Vec<_>>(), ["normal", "side"]);
//! let wall = kind.shape(&[Value::Vector(vec![1.0, 0.0]), Value::AtLeast(3.0)])?;
//! assert!(wall.contains(&[3.0, 7.0]) && !wall.contains(&[2.9, 7.0]));
//!
//! let [piece] = &wall.described()[..] else { panic!("one piece") };
//! assert_eq!(piece.1, [Value::Vector(vec![-1.0, 0.0]), Value::AtMost(-3.0)]);
//! # Ok::<(), SetError>(())
//! ```

#[cfg(feature = "serde")]
pub(crate) mod data;

use std::cmp::Ordering;

use crate::{AnySet, numerics::proof};

/// A kind of set, and what describes a set of this kind.
///
/// [`Kind::ALL`] has all kinds, and [`Kind::shape`] makes a set of its parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// The key of such a set in problem files.
    pub key: &'static str,
    /// The name with its article, such as "a half-space".
    pub name: &'static str,
    /// What a set of this kind is, in a sentence.
    pub about: &'static str,
    /// The parts, in the order of the values. A single part is written without its name.
    pub parts: &'static [Part],
}

/// A part of what describes a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// The name. Files and Python name a [`Form::Side`] `at_least` or `at_most`.
    pub name: &'static str,
    /// What the part consists of.
    pub form: Form,
    /// What the part is, in a sentence.
    pub about: &'static str,
    /// Whether vectors are places, which a translation moves, and not directions.
    pub are_places: bool,
}

/// What a part consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The coordinates of a point or a vector.
    Vector,
    /// Several points or vectors.
    Vectors,
    /// A number.
    Number,
    /// The largest value of a linear form, under the name `at_most`, or its least value, under the name
    /// `at_least`.
    Side,
}

/// The value of a part.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Coordinates, in `ℓ`.
    Vector(Vec<f64>),
    /// Several points or vectors.
    Vectors(Vec<Vec<f64>>),
    /// A number.
    Number(f64),
    /// The largest value of a linear form.
    AtMost(f64),
    /// The least value of a linear form.
    AtLeast(f64),
}

impl Kind {
    /// Returns the kind with this key.
    #[must_use]
    pub fn keyed(key: &str) -> Option<Kind> {
        Kind::ALL.iter().find(|kind| kind.key == key).copied()
    }

    /// Returns the names under which the parts are written.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.parts.iter().flat_map(|part| part.names().iter().copied())
    }

    /// Returns the index of the part that is written under a name, the part and the name.
    #[must_use]
    pub fn part_named(&self, name: &str) -> Option<(usize, &'static Part, &'static str)> {
        self.parts.iter().enumerate().find_map(|(k, part)| {
            Some((k, part, *part.names().iter().find(|&&known| known == name)?))
        })
    }
}

impl Part {
    /// The names of a [`Form::Side`].
    const SIDES: [&'static str; 2] = ["at_least", "at_most"];

    pub(crate) const fn vector(name: &'static str, about: &'static str) -> Self {
        Self { name, form: Form::Vector, about, are_places: true }
    }

    pub(crate) const fn vectors(name: &'static str, about: &'static str) -> Self {
        Self { name, form: Form::Vectors, about, are_places: true }
    }

    pub(crate) const fn directions(self) -> Self {
        Self { are_places: false, ..self }
    }

    pub(crate) const fn number(name: &'static str, about: &'static str) -> Self {
        Self { name, form: Form::Number, about, are_places: false }
    }

    pub(crate) const fn side(about: &'static str) -> Self {
        Self { name: "side", form: Form::Side, about, are_places: false }
    }

    /// Returns the names of which one is written: the name, or those of the two sides.
    #[must_use]
    pub fn names(&'static self) -> &'static [&'static str] {
        match self.form {
            Form::Side => &Part::SIDES,
            _ => std::slice::from_ref(&self.name),
        }
    }

    /// Returns the name under which a value of this part is written.
    #[must_use]
    pub fn name_of(&self, value: &Value) -> &'static str {
        match value {
            Value::AtLeast(_) => Part::SIDES[0],
            Value::AtMost(_) => Part::SIDES[1],
            _ => self.name,
        }
    }
}

/// A set that finitely many vectors and numbers describe.
pub(crate) trait Piece: AnySet {
    fn kind(&self) -> Kind;

    /// Returns the values of the parts, of which the kind makes the same set again.
    fn values(&self) -> Vec<Value>;

    /// Returns the corners of a box around the set, or around each of its points; nothing if the set is
    /// unbounded.
    fn boxes(&self) -> Vec<[Vec<f64>; 2]>;

    /// Returns whether `x` is proved to be a member. By default a set knows only those members that
    /// [`AnySet::member_near`] proves.
    fn has(&self, x: &[f64]) -> bool {
        let is_finite = x.iter().all(|x| x.is_finite());
        is_finite && self.member_near(x).is_some_and(|member| member == proof::point(x))
    }
}

/// Returns a box around a ball; its corners are rounded.
pub(crate) fn box_around(centre: &[f64], r: f64) -> Vec<[Vec<f64>; 2]> {
    vec![[-r, r].map(|by| centre.iter().map(|x| x + by).collect())]
}

/// Returns whether the distance from a centre is proved to compare so with a radius.
pub(crate) fn is_at(x: &[f64], centre: &[f64], r: f64, is_so: fn(Ordering) -> bool) -> bool {
    proof::compare_distance(x, centre, r).is_some_and(is_so)
}

#[cfg(test)]
mod tests {
    use super::{Form, Kind, Part, Value};
    use crate::{HalfSpace, SetError, Shape};

    fn sample(k: usize, part: &Part) -> Value {
        let x = k as f64;
        match part.form {
            Form::Vector => Value::Vector(vec![x, 0.1 + x, 3.0]),
            Form::Vectors => Value::Vectors(vec![vec![1.0, 0.3, 0.0], vec![0.0, -0.7, 2.0]]),
            Form::Number => Value::Number(0.7),
            Form::Side => Value::AtMost(0.7),
        }
    }

    #[test]
    fn each_kind_of_set_is_made_of_its_parts_and_returns_them() {
        for kind in Kind::ALL {
            assert_eq!(Kind::keyed(kind.key), Some(*kind));
            let values: Vec<Value> =
                kind.parts.iter().enumerate().map(|(k, part)| sample(k, part)).collect();
            let shape = kind.shape(&values).expect(kind.name);
            assert_eq!(shape.name(), kind.name);
            assert_eq!(shape.described(), [(*kind, values.clone())]);
            let other = Err(SetError::Parts { what: kind.name });
            assert_eq!(kind.shape(&values[1..]), other, "{kind:?}");
            for k in 0..values.len() {
                let mut wrong = values.clone();
                wrong[k] = match wrong[k] {
                    Value::Vector(_) => Value::Vectors(vec![vec![1.0, 2.0, 3.0]]),
                    _ => Value::Vector(vec![1.0, 2.0, 3.0]),
                };
                assert_eq!(kind.shape(&wrong), other, "{wrong:?}");
            }
        }
        assert_eq!(Kind::keyed("cone"), None);
    }

    #[test]
    fn each_key_and_each_name_of_a_part_occurs_once() {
        for (k, kind) in Kind::ALL.iter().enumerate() {
            assert!(Kind::ALL[..k].iter().all(|other| other.key != kind.key), "{kind:?}");
            let names: Vec<_> = kind.names().collect();
            for (i, name) in names.iter().enumerate() {
                assert!(!names[..i].contains(name), "{kind:?}");
                let (at, part, found) = kind.part_named(name).expect("a part");
                assert!(kind.parts[at] == *part && found == *name && part.names().contains(name));
            }
            assert_eq!(kind.part_named("side").is_some(), names.contains(&"side"));
        }
    }

    /// `n·x ≥ b` is `−n·x ≤ −b`.
    #[test]
    fn a_half_space_has_either_side() {
        let kind = Kind::keyed("half_space").expect("a kind");
        let made = |side| kind.shape(&[Value::Vector(vec![3.0, 0.1]), side]);
        let at_most = HalfSpace::from_slice(&[3.0, 0.1], 0.7).map(Shape::HalfSpace);
        assert_eq!(made(Value::AtMost(0.7)), at_most);
        let at_least = HalfSpace::from_slice(&[-3.0, -0.1], -0.7).map(Shape::HalfSpace);
        assert_eq!(made(Value::AtLeast(0.7)), at_least);
    }
}
