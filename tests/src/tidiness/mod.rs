//! The shape of the workspace, as tests: which file may hold what, and who may depend on whom.

mod ledger;
mod manifest;
mod sources;
mod workspace;

use std::path::{Path, PathBuf};

use manifest::Manifest;

/// The root of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All files below `folder` with this extension, sorted; build output left out.
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

/// The folders of the packages below `crates/`.
fn crates() -> Vec<PathBuf> {
    let manifests = files(&root().join("crates"), "toml");
    let folder = |path: &PathBuf| path.parent().expect("a file is in a folder").to_owned();
    manifests.iter().filter(|path| path.ends_with("Cargo.toml")).map(folder).collect()
}

/// The manifests of all packages, those at the top included.
fn manifests() -> Vec<Manifest> {
    let top = ["benches", "paper", "tests", "xtask"].map(|name| root().join(name));
    crates().iter().chain(&top).map(|folder| Manifest::read(&folder.join("Cargo.toml"))).collect()
}
