//! `cargo xtask bench`: measures the cost of a solve, part by part and on large problems.

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
    thread,
};

/// Each benchmark of the solver, and what its table shows.
const BENCHES: [(&str, &str); 3] = [
    (
        "speed",
        "the least time of each part of a solve on one thread, of many runs in turn, and its \
         ratio to the same written by hand: of assembly to assembly, of a solve of the formula as \
         text to one of the formula in Rust, of all else to one Newton step; no ratio where \
         nothing is written by hand, on P4 to P6",
    ),
    (
        "scale",
        "whole solves of long and wide problems from the straight line, and of many from the \
         automatic starts; how many ended in a local minimum; the least time of up to five runs \
         and the peak memory of the first, by the nodes of all problems; the mean of the Newton \
         steps of all searches on all grids, and the largest residual over its floor; efficiency \
         is the rate over that of one thread times their number",
    ),
    (
        "programs",
        "the steps of each recorded formula, and the cost before the first chord of a search: the \
         least time of up to five runs to record it, and to record it and derive the program of H \
         and its contracted derivatives, the peak memory for that, and the registers of each \
         thread; a formula of very many steps runs as compiled code",
    ),
];

/// The parts that can run separately: problems, numbers of chords, and rows of the second table.
const PARTS: [&str; 14] = [
    "P1", "P2", "P3", "P4", "P5", "P6", "64", "1000", "10000", "100000", "1000000", "batch",
    "by gram", "programs",
];

/// Runs the benchmarks. Complete tables are written to `paper/tables`, parts only to the terminal.
pub(crate) fn bench(root: &Path, rest: &[&str]) -> Result<(), String> {
    if let Some(other) = rest.iter().find(|word| !PARTS.contains(word)) {
        return Err(format!("{other}: parts are {}", PARTS.join(", ")));
    }
    for (name, what) in BENCHES {
        let rows = run(root, name, rest)?;
        if rest.is_empty() {
            let table = format!("paper/tables/{name}.csv");
            let text = format!("{}{rows}", header(name, what));
            fs::write(root.join(&table), text).map_err(|error| format!("{table}: {error}"))?;
            eprintln!("wrote {table}");
        }
    }
    Ok(())
}

/// Runs one benchmark, and returns its output.
fn run(root: &Path, name: &str, rest: &[&str]) -> Result<String, String> {
    let arguments = ["bench", "--package", "tautline", "--bench", name, "--"];
    eprintln!("$ cargo {} {}", arguments.join(" "), rest.join(" "));
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .args(rest)
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("the benchmark did not start: {error}"))?;
    let rows = String::from_utf8_lossy(&output.stdout).into_owned();
    print!("{rows}");
    if !output.status.success() {
        return Err(format!("the benchmark failed: {}", output.status));
    }
    Ok(rows)
}

/// Returns the comment above the rows.
fn header(name: &str, what: &str) -> String {
    let processor = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = processor
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or(std::env::consts::ARCH, |(_, name)| name);
    let cores = thread::available_parallelism().map_or(1, usize::from);
    format!(
        "# {name}\n\
         # {what}\n\
         # command: cargo xtask bench\n\
         # machine: {processor}, {cores} cores, {}; no flags for the processor\n",
        std::env::consts::OS
    )
}
