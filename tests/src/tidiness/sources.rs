//! What may stand in a source file.

use std::path::{Path, PathBuf};

use super::{crates, files, read, root};

/// A file is one sitting.
const LONGEST: usize = 400;

fn all_sources() -> Vec<PathBuf> {
    let folders = ["benches", "crates", "paper", "peers", "tests", "xtask"];
    folders.iter().flat_map(|folder| files(&root().join(folder), "rs")).collect()
}

/// The sources of the libraries, without their tests and examples.
fn library_sources() -> Vec<PathBuf> {
    crates().iter().flat_map(|folder| files(&folder.join("src"), "rs")).collect()
}

/// The lines that the compiler reads, numbered from 1; comments and doc comments left out.
fn code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines()
        .enumerate()
        .filter(|(_, line)| !line.trim_start().starts_with("//"))
        .map(|(index, line)| (index + 1, line))
}

/// Returns whether `word` stands in `line` with no letter, digit or `_` beside it.
fn has_word(line: &str, word: &str) -> bool {
    let part_of_a_name = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(word).any(|(at, _)| {
        !line[..at].ends_with(part_of_a_name)
            && !line[at + word.len()..].starts_with(part_of_a_name)
    })
}

/// Fails with the places where one of the patterns stands in code.
#[track_caller]
fn assert_absent(sources: &[PathBuf], why: &str, forbidden: impl Fn(&str) -> bool) {
    let place = |path: &Path, (line, text): (usize, &str)| {
        forbidden(text).then(|| format!("{}:{line}: {}", path.display(), text.trim()))
    };
    let found: Vec<String> = sources
        .iter()
        .flat_map(|path| {
            let text = read(path);
            code(&text).filter_map(|line| place(path, line)).collect::<Vec<_>>()
        })
        .collect();
    assert!(found.is_empty(), "{why}:\n{}", found.join("\n"));
}

#[test]
fn every_file_begins_with_what_it_is() {
    for path in all_sources() {
        let text = read(&path);
        assert!(text.starts_with("//! "), "{} does not begin with a //! line", path.display());
    }
}

#[test]
fn no_file_is_longer_than_one_sitting() {
    for path in all_sources() {
        let lines = read(&path).lines().count();
        assert!(lines <= LONGEST, "{} has {lines} lines, more than {LONGEST}", path.display());
    }
}

#[test]
fn scripts_say_what_they_are_and_are_one_sitting() {
    for path in files(&root().join("peers"), "py") {
        let text = read(&path);
        assert!(text.starts_with("\"\"\""), "{} does not begin with its doc", path.display());
        let lines = text.lines().count();
        assert!(lines <= LONGEST, "{} has {lines} lines, more than {LONGEST}", path.display());
    }
}

#[test]
fn no_test_is_ignored() {
    // In two parts, since this file is looked at too.
    let attribute = concat!("#[", "ignore");
    assert_absent(&all_sources(), "every test is run", |line| line.contains(attribute));
}

/// Or else `TAUTLINE_SEED` would not change what a test draws.
#[test]
fn seeds_are_asked_of_the_environment() {
    let chance = root().join("crates/tautline-chance");
    let is_drawn = |path: &PathBuf| {
        !path.starts_with(&chance)
            && path.iter().all(|part| part != "examples" && part != "benches")
    };
    let sources: Vec<PathBuf> = all_sources().into_iter().filter(is_drawn).collect();
    let constructors = ["RngSeed::Fixed(", "Random(", "from_size_and_seed(24, ", "Random::new("];
    assert_absent(&sources, "seeds come from tautline_chance", |line| {
        let fixed = constructors.iter().any(|constructor| {
            let mut ends = line.match_indices(constructor).map(|(at, _)| at + constructor.len());
            ends.any(|end| line[end..].starts_with(|c: char| c.is_ascii_digit()))
        });
        // In two parts, since this file is looked at too.
        fixed || line.contains(concat!("TestRunner::", "deterministic"))
    });
}

#[test]
fn libraries_do_no_input_or_output() {
    let forbidden = [
        "std::fs",
        "std::net",
        "std::io",
        "std::env",
        "std::process",
        "std::time",
        "println!",
        "eprintln!",
        "print!",
        "eprint!",
        "dbg!",
    ];
    // What asks the environment for seeds is no library but a part of tests, and one file.
    let chance = root().join("crates/tautline-chance/src/lib.rs");
    let (apart, sources): (Vec<_>, Vec<_>) =
        library_sources().into_iter().partition(|path| *path == chance);
    assert_eq!(apart, [chance]);
    assert_absent(&sources, "libraries read and write nothing", |line| {
        forbidden.iter().any(|pattern| has_word(line, pattern))
    });
}

#[test]
fn the_bounds_never_see_a_metric() {
    let sources = files(&root().join("crates/tautline-bounds/src"), "rs");
    assert_absent(&sources, "bounds take constants", |line| has_word(line, "Metric"));
}

#[test]
fn words_end_where_a_name_ends() {
    assert!(has_word("use m::{Metric, X}", "Metric"));
    assert!(has_word("println!(\"\")", "println!"));
    assert!(!has_word("use m::MetricError", "Metric"));
    assert!(!has_word("eprintln!()", "println!"));
    assert_eq!(code("a\n  // b\n/// c\nd // e").map(|(k, _)| k).collect::<Vec<_>>(), [1, 4]);
}
