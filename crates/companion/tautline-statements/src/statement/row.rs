//! `Row`: the static facts of a statement, and the macro that makes the enum of all rows.

use super::needs::Needs;
use crate::{Evidence, Verdict, VerifyError};

/// The static facts of a statement.
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

/// A counterexample to a statement as printed; see [`Erratum`](crate::Erratum).
pub(crate) struct Refutation {
    pub(crate) witness: &'static str,
    pub(crate) relied_on_by: &'static str,
    /// Evaluates the printed form on the counterexample.
    pub(crate) evidence: fn() -> Result<Evidence, VerifyError>,
}

/// Makes the enum [`Statement`](crate::Statement), its list and its rows from the table.
///
/// A row begins with the name, the number and the label. Three fields are optional: `needs` lists
/// the hypotheses; `is_a_bound` marks a statement that bounds an error, a speed or a derivative by
/// constants of the metric; and `refuted_by` has the counterexample to a statement that is false as
/// printed. `code` is a function of this crate; an unknown name does not compile.
macro_rules! statements {
    ($($name:ident $number:literal $label:literal {
        claim: $claim:literal,
        $(needs: $needs:expr,)?
        verdict: $verdict:expr,
        code: $code:ident,
        $(is_a_bound: $bound:literal,)?
        $(refuted_by: $refutation:expr,)?
    })*) => {
        /// The numbered statements of the paper, the claims of its Section 5 and its displayed
        /// constants, in the order of the paper; then our own, in the order of `paper/SHARPER.md`.
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
                        needs: const { &or!([] $(, $needs)?) },
                        verdict: $verdict,
                        function: stringify!($code),
                        is_a_bound: or!(false $(, $bound)?),
                        refuted_by: or!(None $(, Some($refutation))?),
                    },)*
                }
            }
        }

        const _: () = {
            #[allow(unused_imports, reason = "checks that the names exist")]
            use crate::statements::{$($code as _),*};
        };
    };
}
pub(super) use statements;

/// Expands to the given value or else to the default.
macro_rules! or {
    ($default:expr) => {
        $default
    };
    ($default:expr, $given:expr) => {
        $given
    };
}
pub(super) use or;
