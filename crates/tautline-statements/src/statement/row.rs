//! `Row`: what is written of a statement, and the macro that makes the enum of all rows.

use crate::{Evidence, Verdict, VerifyError};

/// What is known of a statement without evaluating it.
pub(crate) struct Row {
    pub(crate) number: &'static str,
    pub(crate) label: &'static str,
    pub(crate) claim: &'static str,
    pub(crate) needs: &'static [Needs],
    pub(crate) verdict: Verdict,
    pub(crate) function: &'static str,
    pub(crate) is_a_bound: bool,
    pub(crate) refuted_by: Option<Refutation>,
}

/// Hypotheses that belong together.
pub(crate) struct Needs {
    /// Those that are evaluated with every case.
    pub(crate) checked: &'static [&'static str],
    /// Those that no finite number of evaluations shows.
    pub(crate) assumed: &'static [&'static str],
}

pub(super) const fn checked(checked: &'static [&'static str]) -> Needs {
    Needs { checked, assumed: &[] }
}

pub(super) const fn assumed(assumed: &'static [&'static str]) -> Needs {
    Needs { checked: &[], assumed }
}

/// Why a statement is false as printed.
pub(crate) struct Refutation {
    /// The smallest counterexample that we know, in words.
    pub(crate) witness: &'static str,
    /// Who relies on the statement, and whether it matters there.
    pub(crate) relied_on_by: &'static str,
    /// Evaluates the printed form on the counterexample.
    pub(crate) evidence: fn() -> Result<Evidence, VerifyError>,
}

/// Makes the enum [`Statement`](crate::Statement), its list and its rows from the table.
///
/// The last two fields of a row may be left out: `is_a_bound` for a statement that bounds an error, a
/// speed or a derivative by constants of the metric, and `refuted_by` for one that is false as printed.
/// `code` is a function of this crate; a name that does not exist does not compile.
macro_rules! statements {
    ($($name:ident {
        number: $number:literal,
        label: $label:literal,
        claim: $claim:literal,
        needs: $needs:expr,
        verdict: $verdict:expr,
        code: $code:ident,
        $(is_a_bound: $bound:literal,)?
        $(refuted_by: $refutation:expr,)?
    })*) => {
        /// A numbered statement of the paper, a claim of its Section 5, or a displayed constant, in
        /// the order of the paper; after them our own, in the order of `paper/SHARPER.md`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Statement {
            $(#[doc = $number] #[doc = concat!("(`", $label, "`): ", $claim, ".")] $name,)*
        }

        impl Statement {
            /// All statements: the paper's in its order (30 numbered ones, both claims of Section 5
            /// and eight displayed constants), then the sharper ones.
            pub const ALL: [Self; [$($number),*].len()] = [$(Self::$name),*];

            pub(crate) fn row(self) -> &'static Row {
                match self {
                    $(Self::$name => &Row {
                        number: $number,
                        label: $label,
                        claim: $claim,
                        needs: const { &$needs },
                        verdict: $verdict,
                        function: stringify!($code),
                        is_a_bound: or!(false $(, $bound)?),
                        refuted_by: or!(None $(, Some($refutation))?),
                    },)*
                }
            }
        }

        const _: () = {
            #[allow(unused_imports, reason = "that the names exist is what is asked")]
            use crate::statements::{$($code as _),*};
        };
    };
}
pub(super) use statements;

/// The value that is given, or else the default.
macro_rules! or {
    ($default:expr) => {
        $default
    };
    ($default:expr, $given:expr) => {
        $given
    };
}
pub(super) use or;
