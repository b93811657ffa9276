//! `cargo xtask release`: what a release needs beyond `cargo xtask ci`. It publishes nothing.

use std::process::{Command, Stdio};

use crate::{
    run::{cargo, root},
    said::print,
};

/// The packages that are not published.
const PRIVATE: [&str; 4] = ["benches", "paper", "tests", "xtask"];

/// Makes the package of every published crate and compiles it from the package alone, in the order
/// of dependency, and compares the public items with those of the last release. What is not committed
/// is refused unless `rest` allows it.
pub(crate) fn release(rest: &[&str]) -> Result<(), String> {
    if !matches!(rest, [] | ["--allow-dirty"]) {
        return Err("release takes no arguments but --allow-dirty".to_owned());
    }
    cargo(&[&["package"], published().as_slice(), rest].concat(), &[])?;
    print("Every package compiles from its own files, without tests, examples and benchmarks.")?;
    let tag = output("git", &["describe", "--tags", "--abbrev=0", "--match", "v*"]);
    let tool = output(env!("CARGO"), &["semver-checks", "--version"]).is_some();
    match comparison(tag.as_deref(), tool) {
        Ok(arguments) => {
            cargo(&arguments, &[])?;
            let tag = arguments[arguments.len() - 1];
            print(format!("The public items are compatible with {tag}."))?;
        }
        Err(reason) => {
            print(format!("NOT done: a comparison of the public items. {reason}"))?;
        }
    }
    print("NOT done: publishing. `CONTRIBUTING.md` has the steps of a release.")
}

/// Returns the arguments that select the published crates.
fn published() -> Vec<&'static str> {
    let excluded = PRIVATE.iter().flat_map(|name| ["--exclude", *name]);
    ["--workspace"].into_iter().chain(excluded).collect()
}

/// Returns the arguments for a comparison with the release of this tag, or why there is none.
fn comparison(tag: Option<&str>, tool: bool) -> Result<Vec<&str>, &'static str> {
    match (tag, tool) {
        (None, _) => Err("There is no tag `v…`, and so no release to compare with."),
        (_, false) => Err("`cargo install cargo-semver-checks --locked` installs what it needs."),
        (Some(tag), true) => {
            Ok([&["semver-checks"], published().as_slice(), &["--baseline-rev", tag]].concat())
        }
    }
}

/// Returns what a command in the root of the workspace prints, if it succeeds.
fn output(program: &str, arguments: &[&str]) -> Option<String> {
    let mut command = Command::new(program);
    let command = command.args(arguments).current_dir(root()).stderr(Stdio::null());
    let output = command.output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::{comparison, published};

    #[test]
    fn a_comparison_needs_a_tag_and_a_tool() {
        assert!(comparison(None, true).expect_err("no tag").contains("no tag"));
        assert!(comparison(None, false).expect_err("no tag").contains("no tag"));
        assert!(comparison(Some("v1"), false).expect_err("no tool").contains("cargo install"));
        let line = comparison(Some("v1"), true).expect("arguments").join(" ");
        assert!(line.starts_with("semver-checks --workspace --exclude benches "), "{line}");
        assert!(line.ends_with(" --exclude xtask --baseline-rev v1"), "{line}");
        assert_eq!(published().len(), 9);
    }
}
