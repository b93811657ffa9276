//! What a source file may contain.

use std::path::PathBuf;

use super::{crates, files, read, root};

pub(super) fn all_sources() -> Vec<PathBuf> {
    let folders = ["benches", "crates", "guide", "paper", "peers", "tests", "xtask"];
    folders.iter().flat_map(|folder| files(&root().join(folder), "rs")).collect()
}

/// Returns the sources of the libraries, without their integration tests and examples.
fn library_sources() -> Vec<PathBuf> {
    crates().iter().flat_map(|folder| files(&folder.join("src"), "rs")).collect()
}

/// Returns the lines that are not comments, numbered from 1.
fn code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    (1..).zip(text.lines()).filter(|(_, line)| !line.trim_start().starts_with("//"))
}

/// Returns whether `line` contains `word` without a letter, digit or `_` next to it.
fn has_word(line: &str, word: &str) -> bool {
    let part_of_a_name = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(word).any(|(at, _)| {
        !line[..at].ends_with(part_of_a_name)
            && !line[at + word.len()..].starts_with(part_of_a_name)
    })
}

/// Fails and lists the forbidden lines of code, if there are any.
#[track_caller]
fn assert_absent(sources: &[PathBuf], why: &str, forbidden: impl Fn(&str) -> bool) {
    let mut found = Vec::new();
    for path in sources {
        for (number, line) in code(&read(path)).filter(|(_, line)| forbidden(line)) {
            found.push(format!("{}:{number}: {}", path.display(), line.trim()));
        }
    }
    assert!(found.is_empty(), "{why}:\n{}", found.join("\n"));
}

#[test]
fn no_test_is_ignored() {
    // The string is in two parts, since this file is searched too.
    let attribute = concat!("#[", "ignore");
    assert_absent(&all_sources(), "every test runs", |line| line.contains(attribute));
}

/// A seed written in the code would not change with `TAUTLINE_SEED`.
#[test]
fn seeds_come_from_the_environment() {
    let chance = root().join("crates/companion/tautline-chance");
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
        // The string is in two parts, since this file is searched too.
        fixed || line.contains(concat!("TestRunner::", "deterministic"))
    });
}

#[test]
fn libraries_do_no_input_or_output() {
    let modules = ["fs", "net", "io", "env", "process", "time"].map(|name| format!("std::{name}"));
    let macros = ["println!", "eprintln!", "print!", "eprint!", "dbg!"].map(str::to_owned);
    let forbidden = modules.into_iter().chain(macros).collect::<Vec<_>>();
    // `tautline-chance` reads seeds from the environment, and only tests depend on it.
    let chance = root().join("crates/companion/tautline-chance/src/lib.rs");
    let (apart, sources): (Vec<_>, Vec<_>) =
        library_sources().into_iter().partition(|path| *path == chance);
    assert_eq!(apart, [chance]);
    let programs =
        ["doors/tautline-cli", "doors/tautline-audit", "library/tautline-check/src/main.rs"]
            .map(|program| root().join("crates").join(program));
    let (apart, sources): (Vec<_>, Vec<_>) =
        sources.into_iter().partition(|path| programs.iter().any(|it| path.starts_with(it)));
    assert!(programs.iter().all(|program| apart.iter().any(|path| path.starts_with(program))));
    assert_absent(&sources, "libraries read and write nothing", |line| {
        // A cursor reads bytes that are in memory.
        let line = line.replace("std::io::Cursor", "Cursor");
        forbidden.iter().any(|pattern| has_word(&line, pattern))
    });
}

#[test]
fn the_bounds_never_see_a_metric() {
    let sources = files(&root().join("crates/library/tautline-bounds/src"), "rs");
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
