//! Limits the size of crates and folders.

use std::collections::BTreeMap;

use super::{files, packages, read, sources::all_sources};

#[test]
fn no_crate_has_more_than_10_000_lines() {
    for package in packages() {
        let lines: usize =
            files(&package, "rs").iter().map(|path| read(path).lines().count()).sum();
        assert!(lines <= 10_000, "{} has {lines} lines of Rust", package.display());
    }
}

/// Galleries are excepted, since each new metric is a new file.
#[test]
fn no_folder_has_more_than_20_files() {
    let mut sizes: BTreeMap<_, usize> = BTreeMap::new();
    for path in all_sources() {
        let folder = path.parent().expect("a file is in a folder").to_owned();
        *sizes.entry(folder).or_default() += 1;
    }
    sizes.retain(|folder, size| *size > 20 && !folder.ends_with("gallery"));
    assert!(sizes.is_empty(), "folders with more than 20 files of Rust: {sizes:#?}");
}
