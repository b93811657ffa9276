//! Checks two claims about the kit by reading the sources: that the whole gallery goes through it,
//! and how much code a newcomer has to write.

use std::path::{Path, PathBuf};

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn here() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/kit")
}

fn crates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates")
}

/// Returns the lines of a text that are neither blank nor comments.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter(|line| !line.trim().is_empty() && !line.trim_start().starts_with("//"))
}

fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// Returns the names in `pub use module::Name;` or `pub use module::{Name, Other};` for which the
/// file of the module contains an `impl … Metric<…> for Name`.
fn metrics() -> Vec<String> {
    let gallery = crates().join("library/tautline-metrics/src/gallery");
    let exports = read(&gallery.join("mod.rs"));
    let exported = code(&exports).filter_map(|line| line.strip_prefix("pub use "));
    let exported = exported.filter(|line| !line.starts_with("crate::"));
    let mut found = Vec::new();
    for line in exported {
        let (module, names) = line.split_once("::").expect("a module and what is in it");
        let text = read(&gallery.join(module).with_extension("rs"));
        // `Metric<D> for Name` may be split over two lines.
        let heads: Vec<&str> = code(&text).flat_map(words).collect();
        let is_metric = |name: &str| {
            heads.windows(4).any(|head| matches!(head, ["Metric", _, "for", of] if *of == name))
        };
        found.extend(words(names).filter(|name| is_metric(name)).map(str::to_owned));
    }
    found
}

#[test]
fn every_metric_of_the_gallery_goes_through_the_kit() {
    let metrics = metrics();
    let gallery = read(&crates().join("library/tautline-metrics/src/gallery/mod.rs"));
    // The table at the top of the gallery has a row for each metric.
    let rows = gallery.lines().filter(|line| line.starts_with("//! | [`")).count();
    assert_eq!(metrics.len(), rows, "{metrics:?}");
    let (_, samples) = gallery.split_once("macro_rules! for_each_sample").expect("the samples");
    let sources = [samples.to_owned(), read(&here().join("without_constants.rs"))];
    for metric in metrics {
        let seen = sources.iter().flat_map(|text| code(text)).flat_map(words);
        assert!(seen.into_iter().any(|word| word == metric), "{metric} is not in the kit's tests");
    }
}

/// Every set has a file that contains its `impl ClosedSet`, and is named in `sets.rs`.
#[test]
fn every_set_goes_through_the_kit() {
    let sets = crates().join("library/tautline-sets/src");
    let tested = read(&here().join("sets.rs"));
    let exports = read(&sets.join("lib.rs"));
    let mut count = 0;
    for line in code(&exports).filter_map(|line| line.strip_prefix("pub use ")) {
        let (module, name) = line.split_once("::").expect("a module and what is in it");
        let name = name.trim_end_matches(';');
        let text = read(&sets.join(module).with_extension("rs"));
        if code(&text).any(|line| line.contains(&format!("ClosedSet<D> for {name}<D>"))) {
            count += 1;
            assert!(code(&tested).flat_map(words).any(|word| word == name), "{name} is not tested");
        }
    }
    // The table at the top of the crate has exactly one row per set.
    let rows = exports.lines().filter(|line| line.starts_with("//! | [`")).count();
    assert_eq!(count, rows);
}

/// Returns the lines that a newcomer writes, without comments and blank lines.
fn newcomer() -> Vec<String> {
    let text = read(&here().join("newcomer.rs"));
    // The newcomer does not write the mistakes; we do.
    code(&text).take_while(|line| *line != "mod mistakes;").map(str::to_owned).collect()
}

/// The count includes everything that the newcomer writes, imports and closing braces too, except
/// the formula.
#[test]
fn a_newcomer_writes_twelve_lines_besides_the_formula() {
    let lines = newcomer();
    let begin = lines.iter().position(|line| line.contains("fn gram")).expect("a formula") + 1;
    let end = begin + lines[begin..].iter().position(|line| line == "    }").expect("its end");
    assert!(begin < end && lines.last().is_some_and(|line| line.starts_with("metric_suite!")));
    assert_eq!(lines.len() - (end - begin), 12, "{lines:#?}");
}

#[test]
fn the_page_of_the_kit_shows_the_lines_of_the_newcomer() {
    let page = read(&crates().join("companion/tautline-kit/src/lib.rs"));
    let page: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("//! ")).collect();
    let lines = newcomer();
    let shown = |from: usize| {
        code_of(&page[from..]).zip(&lines).all(|(shown, line)| shown == line.as_str())
    };
    let from = page.iter().position(|line| *line == lines[0]).expect("the first line");
    assert!(shown(from), "{:#?}", code_of(&page[from..]).take(lines.len()).collect::<Vec<_>>());
}

fn code_of<'a>(lines: &'a [&'a str]) -> impl Iterator<Item = &'a str> {
    lines.iter().copied().filter(|line| !line.is_empty())
}
