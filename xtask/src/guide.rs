//! `cargo xtask guide`: builds the guide into `target/guide`.

use std::{env, path::Path};

use crate::run::cargo;

/// Builds the guide. With `--check` it then opens every page in a browser, after the tests of the
/// program that does so. The program is a separate workspace, with its own lock file and its own
/// folder.
pub(crate) fn guide(root: &Path, rest: &[&str]) -> Result<(), String> {
    let target = root.join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()));
    let output = target.join("guide").display().to_string();
    let manifest = root.join("guide/Cargo.toml").display().to_string();
    let folder = target.join("guide-build").display().to_string();
    let own = ["--quiet", "--manifest-path", &manifest, "--target-dir", &folder];
    match rest {
        [] => cargo(&[&["run"], &own[..], &["--", &output]].concat(), &[]),
        ["--check"] => {
            let browser = ["--features", "browser"];
            cargo(&[&["test"], &own[..], &browser].concat(), &[])?;
            cargo(&[&["run"], &own[..], &browser, &["--", &output, "--check"]].concat(), &[])
        }
        _ => Err("usage: cargo xtask guide [--check]".to_owned()),
    }
}
