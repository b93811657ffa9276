//! Limits the size of folders.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use super::sources::all_sources;

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
fn no_folder_has_more_than_20_files() {
    let sources = all_sources();
    let crowded = crowded(&sources);
    assert!(crowded.is_empty(), "folders with more than 20 files of Rust: {crowded:#?}");
}

#[test]
fn crowded_folders_are_found() {
    let of = |folder: &str, count: usize| -> Vec<PathBuf> {
        (0..count).map(|k| Path::new(folder).join(format!("{k}.rs"))).collect()
    };
    let files = [of("a/large", 21), of("a", 20), of("b", 20), of("b/gallery", 21)].concat();
    assert_eq!(crowded(&files), BTreeMap::from([(Path::new("a/large"), 21)]));
}
