//! Limits the size of crates and folders.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use super::{files, packages, read, sources::all_sources};

fn is_long(lines: usize) -> bool {
    lines > 10_000
}

/// The folders of more than 20 of these files. Except galleries: a new metric is a new file.
fn crowded(files: &[PathBuf]) -> BTreeMap<&Path, usize> {
    let mut sizes = BTreeMap::new();
    for path in files {
        *sizes.entry(path.parent().expect("a file is in a folder")).or_default() += 1;
    }
    sizes.retain(|folder, size| *size > 20 && !folder.ends_with("gallery"));
    sizes
}

#[test]
fn no_crate_has_more_than_10_000_lines() {
    for package in packages() {
        let lines = files(&package, "rs").iter().map(|path| read(path).lines().count()).sum();
        assert!(!is_long(lines), "{} has {lines} lines of Rust", package.display());
    }
}

#[test]
fn no_folder_has_more_than_20_files() {
    let sources = all_sources();
    let crowded = crowded(&sources);
    assert!(crowded.is_empty(), "folders with more than 20 files of Rust: {crowded:#?}");
}

#[test]
fn what_is_too_large_is_found() {
    assert!(is_long(10_001) && !is_long(10_000));
    let of = |folder: &str, count: usize| -> Vec<PathBuf> {
        (0..count).map(|k| Path::new(folder).join(format!("{k}.rs"))).collect()
    };
    let files = [of("a/large", 21), of("a", 20), of("b", 20), of("b/gallery", 21)].concat();
    assert_eq!(crowded(&files), BTreeMap::from([(Path::new("a/large"), 21)]));
}
