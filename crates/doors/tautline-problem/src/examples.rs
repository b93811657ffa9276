//! Commented problem files, each for a question that a user may have.

/// A commented problem file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Example {
    /// The name of the file, without `.toml`.
    pub name: &'static str,
    /// The file.
    pub text: &'static str,
}

impl Example {
    /// Returns the question, which is the first line of the file.
    #[must_use]
    pub fn question(&self) -> &'static str {
        self.text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
    }

    /// Returns the example with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Example> {
        EXAMPLES.iter().find(|example| example.name == name)
    }
}

macro_rules! examples {
    ($($name:literal)*) => {
        &[$(Example { name: $name, text: include_str!(concat!("../problems/", $name, ".toml")) }),*]
    };
}

/// All examples.
pub const EXAMPLES: &[Example] = examples! {
    "valleys"
    "robot_arm"
    "refraction"
    "normal_distributions"
    "decoder"
    "obstacles"
    "measured"
    "sets"
    "two_channels"
    "tie"
    "wrong_start"
    "wrong_constants"
    "counterexample"
    "twelve_coordinates"
    "sweep"
};
