//! Claims about the kit, checked on the sources: the whole gallery goes through it, and a newcomer
//! writes twelve lines.

use std::path::PathBuf;

use crate::tidiness::{read, root};

fn here() -> PathBuf {
    root().join("tests/src/kit")
}

fn crates() -> PathBuf {
    root().join("crates")
}

/// The lines that are neither blank nor comments.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter(|line| !line.trim().is_empty() && !line.trim_start().starts_with("//"))
}

fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// The names in `pub use module::Name;` or `pub use module::{Name, Other};` for which the file of
/// the module has an `impl … Metric<…> for Name`.
fn metrics() -> Vec<String> {
    let gallery = crates().join("tautline-metrics/src/gallery");
    let exports = read(&gallery.join("mod.rs"));
    let exported = code(&exports).filter_map(|line| line.strip_prefix("pub use "));
    let mut found = Vec::new();
    for line in exported {
        let (module, names) = line.split_once("::").expect("a module and what is in it");
        let text = read(&gallery.join(module).with_extension("rs"));
        // `Metric<D> for Name` may be broken into two lines.
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
    let sources = ["gallery.rs", "without_constants.rs"].map(|name| read(&here().join(name)));
    let metrics = metrics();
    // The table at the top of the gallery has a row for each metric.
    let table = read(&crates().join("tautline-metrics/src/gallery/mod.rs"));
    let rows = table.lines().filter(|line| line.starts_with("//! | [`")).count();
    assert_eq!(metrics.len(), rows, "{metrics:?}");
    for metric in metrics {
        let seen = sources.iter().flat_map(|text| code(text)).flat_map(words);
        assert!(seen.into_iter().any(|word| word == metric), "{metric} is not in the kit's tests");
    }
}

/// The code of the newcomer.
fn newcomer() -> Vec<String> {
    let text = read(&here().join("newcomer.rs"));
    // The mistakes are not the newcomer's.
    code(&text).take_while(|line| *line != "mod mistakes;").map(str::to_owned).collect()
}

/// All lines of code count, imports and closing braces too, except the formula.
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
    let page = read(&crates().join("tautline-kit/src/lib.rs"));
    let page: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("//! ")).collect();
    let lines = newcomer();
    let from = page.iter().position(|line| *line == lines[0]).expect("the first line");
    let shown = page[from..].iter().filter(|line| !line.is_empty()).take(lines.len());
    assert_eq!(shown.collect::<Vec<_>>(), lines.iter().collect::<Vec<_>>());
}
