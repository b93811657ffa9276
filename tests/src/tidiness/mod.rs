//! The invariants of the architecture, as tests: what a source file may contain, how large a crate
//! and a folder may become, which crate may depend on which, and what a crate needs to be published.

mod ledger;
mod manifest;
mod publishing;
mod sizes;
mod sources;
mod workspace;

use std::path::{Path, PathBuf};

use manifest::Manifest;

/// The folders of the packages outside `crates/`.
const TOP: [&str; 4] = ["benches", "paper", "tests", "xtask"];

/// Returns the root of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

pub(crate) fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Returns all files below `folder` with this extension, sorted; files of the build output are
/// omitted.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut pending = vec![folder.to_owned()];
    while let Some(folder) = pending.pop() {
        let entries = std::fs::read_dir(&folder)
            .unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
        for entry in entries {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() && path.file_name().is_some_and(|name| name != "target") {
                pending.push(path);
            } else if path.extension().is_some_and(|found| found == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    assert!(!found.is_empty(), "no .{extension} below {}", folder.display());
    found
}

/// Returns the folders of the packages below `crates/`.
fn crates() -> Vec<PathBuf> {
    let manifests = files(&root().join("crates"), "toml");
    let folder = |path: &PathBuf| path.parent().expect("a file is in a folder").to_owned();
    manifests.iter().filter(|path| path.ends_with("Cargo.toml")).map(folder).collect()
}

/// Returns the folders of all packages.
fn packages() -> Vec<PathBuf> {
    crates().into_iter().chain(TOP.map(|name| root().join(name))).collect()
}

/// Reads the manifests of all packages.
fn manifests() -> Vec<Manifest> {
    packages().iter().map(|folder| Manifest::read(&folder.join("Cargo.toml"))).collect()
}
