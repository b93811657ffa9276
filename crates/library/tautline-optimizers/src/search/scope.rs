//! `Scope`: how far a search looks.

/// How far a search looks for a curve.
///
/// It is for problems that are posed whole: [`minimise`](crate::minimise) and its kind search from their
/// [starts](crate::Starts) alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Scope {
    /// In two and three dimensions, also along a shortest path through a coarse lattice around what the
    /// starts led to. If the path runs elsewhere, a search starts from it, and the shorter line is the result.
    /// There is no such look with fewer than 16 chords, for a metric that is known by its values only, and
    /// from [starts](crate::Starts) that replace the automatic ones.
    #[default]
    Automatic,
    /// From the starts alone.
    Local,
}

impl Scope {
    /// The names of the scopes, in files and in Python.
    pub const NAMES: [&str; 2] = ["automatic", "local"];

    /// Returns the scope of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "automatic" => Some(Self::Automatic),
            "local" => Some(Self::Local),
            _ => None,
        }
    }
}
