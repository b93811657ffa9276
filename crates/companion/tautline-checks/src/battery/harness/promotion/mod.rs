//! Writes a random case that failed as a test that can be kept.

mod cursor;
mod drawn;
mod rust_type;
mod source;

use std::{any::Any, cell::RefCell, fmt::Debug};

use drawn::Drawn;
use rust_type::RustType;

/// A case that replaces the random ones; a [promoted](Case::as_test) test passes it to a check.
pub struct Given {
    family: u64,
    value: RefCell<Option<Box<dyn Any>>>,
}

impl Given {
    /// Returns a case for the family with this seed.
    #[must_use]
    pub fn new(family: u64, case: impl Any) -> Self {
        Self { family, value: RefCell::new(Some(Box::new(case))) }
    }

    /// Gives the case to its family, once.
    pub(super) fn take<V: Any>(&self, family: u64) -> Option<V> {
        let mut value = self.value.borrow_mut();
        let fits = self.family == family && value.as_ref().is_some_and(|value| value.is::<V>());
        if !fits {
            return None;
        }
        value.take()?.downcast().ok().map(|value| *value)
    }

    /// Returns whether a family has taken the case.
    #[must_use]
    pub fn was_taken(&self) -> bool {
        self.value.borrow().is_none()
    }
}

impl Debug for Given {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Given").field("family", &self.family).finish_non_exhaustive()
    }
}

/// The smallest failing case that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The seed of its family, as written in the check.
    pub family: u64,
    /// Its type, and an expression of that type for its value.
    pub code: [String; 2],
}

impl Case {
    pub(super) fn new<V: Debug>(family: u64, value: &V) -> Self {
        Self::of_type::<V>(family, value)
    }

    /// Keeps a type-erased value of type `V`.
    pub(super) fn of_type<V>(family: u64, value: &dyn Debug) -> Self {
        let kind = RustType::of::<V>();
        // Output that cannot be parsed is kept as it is: the test then does not compile, and shows
        // the output.
        let text = format!("{value:?}");
        let code = Drawn::read(&text).map_or(text, |drawn| source::expression(&drawn, &kind));
        Self { family, code: [kind.to_string(), code] }
    }

    /// Returns a test of this case for `promoted_cases.rs`, which runs the check with this name.
    #[must_use]
    pub fn as_test(&self, check: &str) -> String {
        let Self { family, code: [kind, value] } = self;
        let names = source::names(&[kind, value]);
        let uses: String = names.iter().map(|path| format!("    use {path};\n")).collect();
        format!(
            "#[test]\nfn a_case_of_{family}_of_{check}() {{\n{uses}    let case: {kind} = {value};\n    \
             holds(\"{check}\", {family}, case);\n}}\n"
        )
    }
}

#[cfg(test)]
mod tests {
    use tautline_statements::curves::Pace;

    use super::{Case, Given};

    #[test]
    fn a_given_case_is_taken_once_by_its_family_and_type() {
        let given = Given::new(7, (1.5, 2_usize));
        assert_eq!(given.take::<(f64, usize)>(8), None);
        assert_eq!(given.take::<(f64, f64)>(7), None);
        assert!(!given.was_taken());
        assert_eq!(given.take(7), Some((1.5, 2_usize)));
        assert!(given.was_taken() && given.take::<(f64, usize)>(7).is_none());
    }

    #[test]
    fn a_case_is_a_test() {
        let test = Case::new(7, &(0.1 + 0.2, 2_usize)).as_test("sums_hold");
        let expected = "#[test]\nfn a_case_of_7_of_sums_hold() {\n    \
             let case: (f64, usize) = (0.30000000000000004, 2);\n    \
             holds(\"sums_hold\", 7, case);\n}\n";
        assert_eq!(test, expected);
        let test = Case::new(8, &[Pace::Even]).as_test("all");
        let uses = "#[test]\nfn a_case_of_8_of_all() {\n    use tautline_statements::curves::Pace;\n    \
                    let case: [Pace; 1] = [Pace::Even];\n";
        assert!(test.starts_with(uses), "{test}");
    }
}
