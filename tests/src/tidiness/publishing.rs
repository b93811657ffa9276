//! What a crate needs to be published, and that all places name one version.

use std::path::{Component, Path, PathBuf};

use super::{crates, files, read, root};

/// Returns the lines of one table of a manifest, without its header.
fn table<'a>(manifest: &'a str, header: &str) -> impl Iterator<Item = &'a str> {
    let lines = manifest.lines().skip_while(move |line| *line != header).skip(1);
    lines.take_while(|line| !line.starts_with('['))
}

/// Returns what a table says of a key, which may be followed by `.workspace`.
fn value<'a>(manifest: &'a str, header: &str, key: &str) -> Option<&'a str> {
    table(manifest, header).find_map(|line| {
        let (name, value) = line.split_once('=')?;
        (name.trim().split('.').next() == Some(key)).then_some(value.trim())
    })
}

/// Returns the version that the workspace gives to its packages, in quotes.
fn version() -> String {
    let manifest = read(&root().join("Cargo.toml"));
    value(&manifest, "[workspace.package]", "version").expect("a version").to_owned()
}

/// There is no public address yet: `repository` joins this list, and `[workspace.package]`, once
/// there is one.
#[test]
fn every_crate_has_what_a_registry_asks_for() {
    let fields = [
        "name",
        "description",
        "version",
        "edition",
        "rust-version",
        "license",
        "categories",
        "keywords",
        "readme",
    ];
    for folder in crates() {
        let manifest = read(&folder.join("Cargo.toml"));
        let shown = folder.display();
        for field in fields {
            let value = value(&manifest, "[package]", field);
            assert!(value.is_some_and(|value| value.len() > 3), "{shown} has no {field}");
        }
        let readme = value(&manifest, "[package]", "readme").expect("seen above");
        let readme = match readme.trim_matches('"') {
            "true" => root().join("crates/README.md"),
            path => folder.join(path),
        };
        assert!(read(&readme).starts_with("# "), "{}", readme.display());
    }
}

/// The files of a package lie in the folder of its crate: there, the licences are symbolic links.
/// Where a system has none, they are texts with the path, and this test fails.
#[test]
fn every_package_has_the_licences() {
    for name in ["LICENSE-APACHE", "LICENSE-MIT"] {
        let licence = read(&root().join(name));
        for folder in crates() {
            assert!(read(&folder.join(name)) == licence, "{} has no {name}", folder.display());
        }
    }
}

/// A dependency by its path alone cannot be published.
#[test]
fn every_dependency_by_path_has_the_version() {
    let workspace = read(&root().join("Cargo.toml"));
    let with_version = format!("version = {}", version());
    let mut seen = 0;
    let lines = table(&workspace, "[workspace.dependencies]");
    for line in lines.filter(|line| line.contains("path = ")) {
        assert!(line.contains(&with_version), "{line:?} lacks {with_version}");
        seen += 1;
    }
    assert!(seen > 20, "only {seen} dependencies were seen");
    for folder in crates() {
        let manifest = read(&folder.join("Cargo.toml"));
        let dependencies = manifest.split("dependencies]").skip(1).collect::<String>();
        assert!(!dependencies.contains("{ path = "), "{}: by `workspace` only", folder.display());
    }
}

/// Returns the path in a line that reads a file when it is compiled.
fn compiled_in(line: &str) -> Option<&str> {
    let starts = ["include_str!(\"", "include_bytes!(\"", "#[path = \""];
    let rest = starts.iter().find_map(|start| Some(line.split_once(start)?.1))?;
    rest.split('"').next()
}

/// Returns the path without `..`.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path.components() {
        if part != Component::ParentDir || !normal.pop() {
            normal.push(part);
        }
    }
    normal
}

/// What does not compile from the package alone is not in it. The documentation tests of the README
/// and of the guide run only in the repository.
#[test]
fn no_package_has_a_source_that_reads_a_file_outside() {
    let mut seen = 0;
    for folder in crates() {
        let folder = normal(&folder);
        let manifest = read(&folder.join("Cargo.toml"));
        let excluded = value(&manifest, "[package]", "exclude").unwrap_or_default();
        for path in files(&folder, "rs") {
            let inside = path.strip_prefix(&folder).expect("a file of the folder");
            let first = inside.iter().next().and_then(|part| part.to_str()).expect("a name");
            let is_excluded = excluded.contains(&format!("\"/{first}\""));
            if is_excluded || path.ends_with("tautline/src/lib.rs") {
                continue;
            }
            let text = read(&path);
            for found in text.lines().filter_map(compiled_in) {
                let target = normal(&path.parent().expect("a folder").join(found));
                assert!(target.starts_with(&folder), "{}: {found:?}", path.display());
                seen += 1;
            }
        }
    }
    assert!(seen > 5, "only {seen} files were seen");
}

/// The bindings are a workspace of their own.
#[test]
fn python_and_the_citation_have_the_version_of_the_workspace() {
    let workspace = read(&root().join("Cargo.toml"));
    let python = read(&root().join("python/Cargo.toml"));
    for key in ["version", "rust-version", "edition", "license"] {
        let expected = value(&workspace, "[workspace.package]", key);
        assert!(expected.is_some(), "{key}");
        assert_eq!(value(&python, "[package]", key), expected, "{key} in python/Cargo.toml");
    }
    let citation = read(&root().join("CITATION.cff"));
    let line = format!("version: {}", version().trim_matches('"'));
    assert!(citation.lines().any(|found| found == line), "CITATION.cff lacks {line:?}");
}

#[test]
fn what_a_manifest_says_is_found() {
    let manifest = "[package]\nname = \"a\"\nreadme.workspace = true\n\n[b]\nname = \"c\"\n";
    assert_eq!(value(manifest, "[package]", "name"), Some("\"a\""));
    assert_eq!(value(manifest, "[package]", "readme"), Some("true"));
    assert_eq!(value(manifest, "[b]", "readme"), None);
    assert_eq!(compiled_in("let a = include_str!(\"../b.txt\");"), Some("../b.txt"));
    assert_eq!(normal(Path::new("/a/b/../c/./../d")), Path::new("/a/d"));
}

#[test]
fn every_feature_is_in_the_documentation() {
    let mut seen = 0;
    for folder in crates() {
        let manifest = read(&folder.join("Cargo.toml"));
        let features: Vec<&str> = table(&manifest, "[features]")
            .filter(|line| !line.starts_with(['#', ' ', ']']))
            .filter_map(|line| Some(line.split_once(" = ")?.0))
            .collect();
        if features.is_empty() {
            continue;
        }
        let page = read(&folder.join("src/lib.rs"));
        let (_, section) = page.split_once("//! # Features\n").expect("a section on features");
        for feature in features {
            assert!(section.contains(&format!("`{feature}`")), "{feature} of {}", folder.display());
            seen += 1;
        }
    }
    assert!(seen > 5, "only {seen} features were seen");
}
