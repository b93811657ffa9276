//! 300 malformed problem files, made by mutation of good ones.

use std::fs;

use tautline_chance::{Chance, Random};
use tautline_problem::EXAMPLES;

use crate::{folder, tautline, text};

/// The seed of the corpus.
const SEED: u64 = 20_261_125;

const FILES: usize = 300;

/// Returns a malformed file, the numbers of the lines at which the mistake may be reported, from 1,
/// and what was done. Returns `None` if this mistake cannot be made in this file.
fn malformed(file: &str, random: &mut Random) -> Option<(String, Vec<usize>, &'static str)> {
    let lines: Vec<&str> = file.lines().collect();
    let pick = |random: &mut Random, count: usize| (random.bits() % count as u64) as usize;
    // A list that goes on over several lines would break in another line.
    let is_entry =
        |line: &&str| line.contains(" = ") && !line.starts_with(['#', ' ']) && !line.ends_with('[');
    let entries: Vec<usize> = (0..lines.len()).filter(|&i| is_entry(&lines[i])).collect();
    let at = entries[pick(random, entries.len())];
    let (line, here) = (lines[at], vec![at + 1]);
    let (key, value) = line.split_once(" = ")?;
    let value = value.split('#').next().unwrap_or_default().trim_end();
    let with = |new: String| {
        let mut changed: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        changed[at] = new;
        changed.join("\n")
    };
    // In the section of parameters and definitions, every name is a good one.
    let section = lines[..at].iter().rev().find(|line| line.starts_with('[')).copied();
    let is_free = section.is_some_and(|it| it.starts_with("[parameters") || it.starts_with("[let"));
    let has_quotes = value.matches('"').count() >= 2;
    Some(match pick(random, 12) {
        0 if !is_free => (with(format!("{key}x = {value}")), here, "a letter too many in a key"),
        1 => (with(format!("{line}\n{key} = {value}")), vec![at + 1, at + 2], "a key twice"),
        2 if value.ends_with(['"', ']', '}']) => {
            let short = &value[..value.len() - 1];
            // What is open may close on a later line, or never.
            (with(format!("{key} = {short}")), (at + 1..=lines.len() + 1).collect(), "an open end")
        }
        3 if has_quotes => (with(line.replacen('"', "\"1 + ( ", 1)), here, "an open bracket"),
        4 if has_quotes => (with(line.replacen('"', "\"qqq + ", 1)), here, "an unknown name"),
        5 if has_quotes => {
            (with(line.replacen('"', "\"sine(x1) + ", 1)), here, "an unknown function")
        }
        6 if has_quotes => (with(line.replacen('"', "\"x77 * ", 1)), here, "an unknown coordinate"),
        7 if has_quotes => (with(line.replacen('"', "\"2 ^ 1.5 + ", 1)), here, "a broken power"),
        8 if has_quotes => (with(line.replacen('"', "\"1 $ 2 + ", 1)), here, "an unknown sign"),
        9 => (with(format!("{key} = nan")), here, "a number that is none"),
        10 => (with(format!("{key} = true")), here, "a truth value"),
        11 => (with(format!("{key} {value}")), here, "no equals sign"),
        _ => return None,
    })
}

#[test]
fn three_hundred_malformed_files_are_refused_with_the_place() {
    let folder = folder("malformed");
    let mut random = Random(Chance::asked().seed(SEED));
    let (mut made, mut kinds) = (0, std::collections::BTreeMap::<_, usize>::new());
    while made < FILES {
        let example = EXAMPLES[(random.bits() % EXAMPLES.len() as u64) as usize];
        let Some((file, places, what)) = malformed(example.text, &mut random) else { continue };
        made += 1;
        *kinds.entry(what).or_default() += 1;
        fs::write(folder.join("bad.toml"), &file).expect("written");
        let output = tautline(&folder, &["solve", "bad.toml", "-n", "2", "--no-bounds"]);
        let said = text(&output.stderr);
        let about = format!("{} with {what}:\n{file}\n{said}", example.name);
        assert_eq!(output.status.code(), Some(2), "{about}");
        assert!(output.stdout.is_empty() && !said.contains("panicked"), "{about}");
        let named = places.iter().any(|line| said.contains(&format!("bad.toml:{line}:")));
        assert!(named, "expected a place in {places:?}: {about}");
    }
    // Each mistake was made.
    assert!(kinds.len() == 12 && kinds.values().all(|&count| count >= 5), "{kinds:?}");
}
