//! Which crate may depend on which, and what the files at the top promise.

use super::{Manifest, TOP, manifests, read, root};

/// For each library, the libraries that it may use. All of them are in rows above it, and the names
/// lack the prefix `tautline-`.
const BELOW: &[(&str, &str)] = &[
    ("chance", ""),
    ("scalar", "chance"),
    ("metrics", "chance scalar"),
    ("formula", "chance metrics scalar"),
    ("sets", "chance scalar"),
    ("bounds", "chance metrics scalar"),
    ("discretizations", "bounds chance formula metrics scalar"),
    ("certify", "chance discretizations formula metrics scalar sets"),
    ("grid", "chance discretizations formula metrics scalar sets"),
    ("check", "chance formula metrics scalar sets"),
    ("distance", "chance check formula grid metrics scalar sets"),
    ("optimizers", "chance discretizations formula metrics sets"),
    (
        "tautline",
        "bounds certify chance check discretizations distance formula grid metrics optimizers scalar sets",
    ),
    ("baselines", "chance tautline"),
    ("minima", "chance tautline"),
    ("picture", "chance scalar sets tautline"),
    ("page", "picture tautline"),
    ("any", "chance picture tautline"),
    ("problem", "any chance picture tautline"),
    ("cli", "chance problem"),
    ("statements", "tautline"),
    ("kit", "tautline chance statements"),
    ("checks", "tautline chance statements"),
    ("audit", "tautline problem statements kit"),
];

fn libraries() -> Vec<Manifest> {
    manifests().into_iter().filter(|manifest| !TOP.contains(&manifest.name.as_str())).collect()
}

#[test]
fn arrows_between_crates_point_downward() {
    let libraries = libraries();
    assert_eq!(libraries.len(), BELOW.len(), "a new crate needs a row in the table of this test");
    for library in &libraries {
        let name = short_name(&library.name);
        let below = BELOW.iter().find(|row| row.0 == name);
        let (_, below) = below.unwrap_or_else(|| panic!("{name} has no row"));
        for dependency in library.all().filter(|name| name.starts_with("tautline")) {
            let dependency = short_name(dependency);
            let known = below.split_whitespace().any(|below| below == dependency);
            assert!(known, "{dependency} is not below {name}");
        }
    }
    // Each row names only rows above it, so that there is no cycle.
    for (index, (name, below)) in BELOW.iter().enumerate() {
        for dependency in below.split_whitespace() {
            let above = BELOW[..index].iter().any(|row| row.0 == dependency);
            assert!(above, "{dependency} comes after {name}");
        }
    }
}

/// The library needs neither a door nor the companion of the paper; only its tests draw numbers.
#[test]
fn a_folder_says_who_needs_its_crates() {
    let folder = |name: &str| {
        let is_there = |folder: &&str| root().join("crates").join(folder).join(name).is_dir();
        let folders = ["library", "doors", "companion"];
        folders.into_iter().find(is_there).unwrap_or_else(|| panic!("{name} is in no folder"))
    };
    for library in libraries() {
        let own = folder(&library.name);
        for used in library.dependencies.iter().filter(|name| name.starts_with("tautline")) {
            let is_allowed = match (own, folder(used)) {
                (_, "library") => true,
                // The audit runs the kit.
                ("doors", "companion") => library.name == "tautline-audit",
                (own, used) => own == used,
            };
            assert!(is_allowed, "{} in {own} needs {used}", library.name);
        }
    }
}

fn short_name(name: &str) -> &str {
    name.strip_prefix("tautline-").unwrap_or(name)
}

#[test]
fn plotters_is_for_the_picture_alone() {
    for manifest in manifests() {
        let depends = manifest.all().any(|name| name.starts_with("plotters"));
        assert_eq!(depends, manifest.name == "tautline-picture", "{}", manifest.name);
    }
}

#[test]
fn random_testing_is_for_verification_alone() {
    let verifies = ["tautline-chance", "tautline-kit", "tautline-checks"];
    for library in libraries().iter().filter(|library| !verifies.contains(&&*library.name)) {
        for name in ["proptest", "quickcheck"] {
            let depends = library.dependencies.iter().any(|found| found == name);
            assert!(!depends, "{} depends on {name} outside of its tests", library.name);
        }
    }
}

/// This crate reads the environment, which no library does.
#[test]
fn chance_is_for_tests_alone() {
    let draws = ["tautline-kit", "tautline-checks"];
    for manifest in manifests().iter().filter(|manifest| !draws.contains(&&*manifest.name)) {
        let depends = manifest.dependencies.iter().any(|found| found == "tautline-chance");
        assert!(!depends, "{} depends on tautline-chance outside of its tests", manifest.name);
    }
}

#[test]
fn xtask_depends_on_nothing() {
    let xtask = manifests().into_iter().find(|manifest| manifest.name == "xtask");
    let xtask = xtask.expect("there is an xtask");
    assert_eq!(xtask.all().count(), 0, "{xtask:?}");
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

#[test]
fn every_dependency_says_what_it_is_for() {
    let text = read(&root().join("Cargo.toml"));
    let table = text.split("[workspace.dependencies]").nth(1).expect("there is such a table");
    let mut before = "";
    let mut seen = 0;
    for line in table.lines().take_while(|line| !line.starts_with('[')) {
        // Our own crates need no comment.
        if line.contains('=') && !line.starts_with('#') && !line.contains("path = \"crates/") {
            assert!(before.starts_with("# "), "no comment above {line:?}");
            seen += 1;
        }
        before = line;
    }
    assert!(seen >= 5, "only {seen} dependencies were seen");
}
