//! `AnyStrategy`: a type-erased strategy, so that the runner of random cases compiles once.

use std::{any::Any, fmt::Debug};

use proptest::{
    strategy::{NewTree, Strategy, ValueTree},
    test_runner::{Reason, TestRunner},
};

/// A value of any type that can be printed.
pub(super) trait AnyValue: Any + Debug {}

impl<V: Any + Debug> AnyValue for V {}

/// Returns the value as a `V`.
///
/// # Panics
///
/// If it has another type.
pub(super) fn downcast<V: Any>(value: Box<dyn AnyValue>) -> V {
    let value: Box<dyn Any> = value;
    *value.downcast().expect("the type that the strategy draws")
}

/// A strategy behind a pointer.
#[derive(Debug)]
pub(super) struct AnyStrategy<'s>(&'s dyn Draw);

impl<'s> AnyStrategy<'s> {
    pub(super) fn new<V>(values: &'s V) -> Self
    where
        V: Strategy,
        V::Value: Any + Debug,
    {
        Self(values)
    }
}

/// A value with its smaller versions.
type Tree<'s> = Box<dyn ValueTree<Value = Box<dyn AnyValue>> + 's>;

impl<'s> Strategy for AnyStrategy<'s> {
    type Tree = Tree<'s>;
    type Value = Box<dyn AnyValue>;

    fn new_tree(&self, runner: &mut TestRunner) -> NewTree<Self> {
        self.0.draw(runner)
    }
}

trait Draw: Debug {
    fn draw(&self, runner: &mut TestRunner) -> Result<Tree<'_>, Reason>;
}

impl<V> Draw for V
where
    V: Strategy,
    V::Value: Any + Debug,
{
    fn draw(&self, runner: &mut TestRunner) -> Result<Tree<'_>, Reason> {
        Ok(Box::new(Grown(self.new_tree(runner)?)))
    }
}

/// Erases the type of the values of a tree.
struct Grown<T>(T);

impl<T: ValueTree> ValueTree for Grown<T>
where
    T::Value: Any + Debug,
{
    type Value = Box<dyn AnyValue>;

    fn current(&self) -> Box<dyn AnyValue> {
        Box::new(self.0.current())
    }

    fn simplify(&mut self) -> bool {
        self.0.simplify()
    }

    fn complicate(&mut self) -> bool {
        self.0.complicate()
    }
}
