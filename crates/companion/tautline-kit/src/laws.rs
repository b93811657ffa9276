//! The macro that turns a table of laws into functions.

/// Makes one function for each law, the list of their names, and `verify`, which runs them all.
///
/// `$see` turns the user's case into the case that the laws take. It also fixes the types of the
/// closures.
macro_rules! functions {
    ({ $generics:tt $case:ty, $see:expr } $($id:ident, $law:literal, $run:expr;)*) => {
        $($crate::laws::function! { $generics $case, $see, $id, $law, $run })*

        /// The names of all laws, in the order of a report.
        pub const LAWS: &[&str] = &[$(stringify!($id)),*];

        $crate::laws::verify! { $generics $case, [$($id),*] }
    };
}

macro_rules! function {
    ([$($generics:tt)*] $case:ty, $see:expr, $id:ident, $law:literal, $run:expr) => {
        #[doc = concat!("Checks the law `", stringify!($id), "`: `", $law, "`.")]
        pub fn $id<$($generics)*>(case: &$case) -> $crate::Outcome {
            $crate::Outcome::of(stringify!($id), $law, &$see(case), $run)
        }
    };
}

macro_rules! verify {
    ([$($generics:tt)*] $case:ty, [$($id:ident),*]) => {
        /// Checks all laws of a case.
        pub fn verify<$($generics)*>(case: &$case) -> $crate::Report {
            $crate::Report { outcomes: vec![$($id(case)),*] }
        }
    };
}

pub(crate) use {function, functions, verify};
