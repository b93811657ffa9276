//! Who depends on whom, and what the files at the top promise.

use super::{Manifest, manifests, read, root};

/// For each library, the libraries below it.
const BELOW: [(&str, &[&str]); 15] = [
    ("tautline-drawing", &[]),
    ("tautline-chance", &[]),
    ("tautline-scalar", &["tautline-chance"]),
    ("tautline-metrics", &["tautline-chance", "tautline-scalar"]),
    ("tautline-formula", &["tautline-chance", "tautline-metrics", "tautline-scalar"]),
    ("tautline-sets", &["tautline-chance", "tautline-scalar"]),
    ("tautline-bounds", &["tautline-chance", "tautline-metrics"]),
    (
        "tautline-discretizations",
        &["tautline-chance", "tautline-formula", "tautline-metrics", "tautline-scalar"],
    ),
    (
        "tautline-certify",
        &[
            "tautline-chance",
            "tautline-discretizations",
            "tautline-formula",
            "tautline-metrics",
            "tautline-scalar",
            "tautline-sets",
        ],
    ),
    (
        "tautline-optimizers",
        &[
            "tautline-chance",
            "tautline-discretizations",
            "tautline-formula",
            "tautline-metrics",
            "tautline-sets",
        ],
    ),
    (
        "tautline",
        &[
            "tautline-bounds",
            "tautline-certify",
            "tautline-discretizations",
            "tautline-formula",
            "tautline-metrics",
            "tautline-optimizers",
            "tautline-scalar",
            "tautline-sets",
        ],
    ),
    ("tautline-statements", &["tautline"]),
    ("tautline-kit", &["tautline", "tautline-chance", "tautline-statements"]),
    ("tautline-suite", &["tautline", "tautline-chance", "tautline-statements"]),
    ("tautline-adversary", &["tautline", "tautline-statements"]),
];

fn libraries() -> Vec<Manifest> {
    let top = ["benches", "paper", "tests", "xtask"];
    manifests().into_iter().filter(|manifest| !top.contains(&manifest.name.as_str())).collect()
}

#[test]
fn arrows_between_crates_point_downward() {
    let libraries = libraries();
    assert_eq!(libraries.len(), BELOW.len(), "a new crate gets a row in the table of this test");
    for library in &libraries {
        let below = BELOW.iter().find(|row| row.0 == library.name);
        let (_, below) = below.unwrap_or_else(|| panic!("{} has no row", library.name));
        for dependency in library.dependencies.iter().chain(&library.dev_dependencies) {
            assert!(
                !dependency.starts_with("tautline") || below.contains(&dependency.as_str()),
                "{} is not below {}",
                dependency,
                library.name
            );
        }
    }
    // The table itself has no cycle: each row names rows above it only.
    for (index, (name, below)) in BELOW.iter().enumerate() {
        for dependency in *below {
            let above = BELOW[..index].iter().any(|row| row.0 == *dependency);
            assert!(above, "{dependency} comes after {name}");
        }
    }
}

#[test]
fn plotters_is_for_the_drawing_alone() {
    for manifest in manifests() {
        for dependency in manifest.dependencies.iter().chain(&manifest.dev_dependencies) {
            let drawing = manifest.name == "tautline-drawing";
            let allowed = drawing || !dependency.starts_with("plotters");
            assert!(allowed, "{} depends on {dependency}", manifest.name);
        }
    }
    assert!(manifests().iter().any(|m| m.name == "tautline-drawing" && m.mentions("plotters")));
}

#[test]
fn random_testing_is_for_verification_alone() {
    // The first one is for tests only.
    let verifies =
        |name: &str| ["tautline-chance", "tautline-kit", "tautline-suite"].contains(&name);
    for library in libraries().into_iter().filter(|library| !verifies(&library.name)) {
        for name in ["proptest", "quickcheck"] {
            let depends = library.dependencies.iter().any(|found| found == name);
            assert!(!depends, "{} depends on {name} outside of its tests", library.name);
        }
    }
}

/// It reads the environment, which no library does.
#[test]
fn chance_is_for_tests_alone() {
    let draws = |name: &str| ["tautline-kit", "tautline-suite"].contains(&name);
    for manifest in manifests().into_iter().filter(|manifest| !draws(&manifest.name)) {
        let depends = manifest.dependencies.iter().any(|found| found == "tautline-chance");
        assert!(!depends, "{} depends on tautline-chance outside of its tests", manifest.name);
    }
}

#[test]
fn xtask_depends_on_nothing() {
    let xtask = manifests().into_iter().find(|manifest| manifest.name == "xtask");
    let xtask = xtask.expect("there is an xtask");
    assert_eq!((xtask.dependencies.len(), xtask.dev_dependencies.len()), (0, 0), "{xtask:?}");
}

#[test]
fn every_dependency_says_what_it_is_for() {
    let text = read(&root().join("Cargo.toml"));
    let table = text.split("[workspace.dependencies]").nth(1).expect("there is such a table");
    let mut before = "";
    let mut seen = 0;
    for line in table.lines().take_while(|line| !line.starts_with('[')) {
        // Our own crates speak for themselves.
        if line.contains('=') && !line.starts_with('#') && !line.contains("path = \"crates/") {
            assert!(before.starts_with("# "), "no comment above {line:?}");
            seen += 1;
        }
        before = line;
    }
    assert!(seen >= 5, "only {seen} dependencies were seen");
}

#[test]
fn the_readme_names_both_commands() {
    let readme = read(&root().join("README.md"));
    for command in ["cargo xtask figures", "cargo xtask test"] {
        assert!(readme.contains(command), "README.md does not name `{command}`");
    }
}

#[test]
fn the_changelog_names_the_version() {
    let manifest = read(&root().join("Cargo.toml"));
    let package = manifest.split("[workspace.package]").nth(1).expect("there is such a table");
    let line = package.lines().find(|line| line.starts_with("version")).expect("a version");
    let version = line.split('"').nth(1).expect("a version is quoted");
    let changelog = read(&root().join("CHANGELOG.md"));
    assert!(changelog.contains(version), "CHANGELOG.md does not name {version}");
}
