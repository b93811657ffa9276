//! `AnyValue`: a type-erased random value, so that the code that runs random cases compiles only
//! once.

use std::{any::Any, fmt::Debug};

/// A value of any type that can be printed.
pub(super) trait AnyValue: Any + Debug {}

impl<V: Any + Debug> AnyValue for V {}

/// Returns the value as a `V`.
///
/// # Panics
///
/// Panics if the value has another type.
pub(super) fn downcast<V: Any>(value: Box<dyn AnyValue>) -> V {
    let value: Box<dyn Any> = value;
    *value.downcast().expect("the type that the strategy draws")
}
