//! `cargo xtask bench`: measures the cost of a solve, part by part and on large problems, and of
//! certificates of distances.

use std::{
    fs::{self, File},
    io::Write,
    path::Path,
    process::{Command, Stdio},
    thread,
};

use crate::said::{print, say};

/// Each benchmark, its table, and what the table shows.
const BENCHES: [(&str, &str, &str); 4] = [
    (
        "speed",
        "speed",
        "the least time of each part of a solve on one thread, of many runs in turn, and its \
         ratio to the same written by hand: of assembly to assembly, of a solve of the formula as \
         text to one of the formula in Rust, of all else to one Newton step; no ratio where \
         nothing is written by hand, on P4 to P6",
    ),
    (
        "scale",
        "scale",
        "whole solves of long and wide problems from the straight line, and of many from the \
         automatic starts; how many ended in a local minimum; the least time of up to five runs \
         and the peak memory of the first, by the nodes of all problems; the mean of the Newton \
         steps of all searches on all grids, and the largest residual over its floor; efficiency \
         is the rate over that of one thread times their number",
    ),
    (
        "programs",
        "programs",
        "the steps of each recorded formula, and the cost before the first chord of a search: the \
         least time of up to five runs to record it, and to record it and derive the program of H \
         and its contracted derivatives, the peak memory for that, and the registers of each \
         thread; a formula of very many steps runs as compiled code",
    ),
    (
        "certificate",
        "certificates",
        "the search for a certificate of the distance, from the solve of the problem to the gap that \
         is wanted or the smallest that is reached, and its check, both on one thread: the least time \
         of five runs, or the time of one that takes a second; gap = (hi - lo)/hi, cubes are those of \
         all levels; a search of more than two minutes stops with its gap",
    ),
];

/// The parts of the first two benchmarks: problems, numbers of chords, and rows of the second table.
const PARTS: [&str; 13] = [
    "P1", "P2", "P3", "P4", "P5", "P6", "64", "1000", "10000", "100000", "1000000", "batch",
    "by gram",
];

/// The benchmarks that have parts.
const IN_PARTS: [&str; 2] = ["speed", "scale"];

/// Runs the benchmarks, or those that are named. Complete tables are written to `paper/tables`. Parts
/// are only printed.
pub(crate) fn bench(root: &Path, rest: &[&str]) -> Result<(), String> {
    let (named, parts): (Vec<&str>, Vec<&str>) =
        rest.iter().partition(|word| BENCHES.iter().any(|(name, ..)| name == *word));
    if let Some(other) = parts.iter().find(|word| !PARTS.contains(word)) {
        let names = BENCHES.map(|(name, ..)| name).join(", ");
        return Err(format!("{other}: tables are {names}; parts are {}", PARTS.join(", ")));
    }
    for (name, table, what) in
        BENCHES.iter().filter(|(name, ..)| parts.is_empty() && chosen(name, &named))
    {
        let rows = run(root, name, &[])?;
        let file = format!("paper/tables/{table}.csv");
        let text = format!("{}{rows}", header(name, table, what));
        write(&root.join(&file), &text)?;
        say(format!("wrote {file}"));
    }
    for name in IN_PARTS.iter().filter(|name| !parts.is_empty() && chosen(name, &named)) {
        run(root, name, &parts)?;
    }
    Ok(())
}

/// Returns whether a benchmark is named, or none is.
fn chosen(name: &str, named: &[&str]) -> bool {
    named.is_empty() || named.contains(&name)
}

/// Writes a table under another name, brings it to the disk, and renames it.
fn write(path: &Path, text: &str) -> Result<(), String> {
    let unfinished = path.with_extension("part");
    let written = File::create(&unfinished).and_then(|mut file| {
        file.write_all(text.as_bytes())?;
        file.sync_all()?;
        fs::rename(&unfinished, path)
    });
    written.map_err(|error| {
        let _ = fs::remove_file(&unfinished);
        format!("{}: {error}", path.display())
    })
}

/// Runs one benchmark, and returns its output.
fn run(root: &Path, name: &str, rest: &[&str]) -> Result<String, String> {
    let arguments = ["bench", "--package", "tautline", "--bench", name, "--"];
    say(format!("$ cargo {} {}", arguments.join(" "), rest.join(" ")));
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .args(rest)
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("the benchmark did not start: {error}"))?;
    let rows = String::from_utf8_lossy(&output.stdout).into_owned();
    print(rows.trim_end())?;
    if !output.status.success() {
        return Err(format!("the benchmark failed: {}", output.status));
    }
    Ok(rows)
}

/// Returns the comment above the rows.
fn header(name: &str, table: &str, what: &str) -> String {
    let processor = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = processor
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or(std::env::consts::ARCH, |(_, name)| name);
    let cores = thread::available_parallelism().map_or(1, usize::from);
    format!(
        "# {table}\n\
         # {what}\n\
         # command: cargo xtask bench {name}\n\
         # machine: {processor}, {cores} cores, {}; no flags for the processor\n",
        std::env::consts::OS
    )
}
