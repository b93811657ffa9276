//! `cargo xtask bench`: what each part of a solve costs, beside what is written by hand.

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
    thread,
};

/// Runs the benchmark of the solver; all of it is written to `paper/tables/speed.csv`, a part only
/// to the terminal.
pub(crate) fn bench(root: &Path, rest: &[&str]) -> Result<(), String> {
    let arguments = ["bench", "--package", "tautline", "--bench", "speed", "--"];
    eprintln!("$ cargo {} {}", arguments.join(" "), rest.join(" "));
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .args(rest)
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("the benchmark did not start: {error}"))?;
    let rows = String::from_utf8_lossy(&output.stdout);
    print!("{rows}");
    if !output.status.success() {
        return Err(format!("the benchmark failed: {}", output.status));
    }
    if rest.is_empty() {
        let path = root.join("paper/tables/speed.csv");
        let text = format!("{}{rows}", header());
        fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
        eprintln!("wrote paper/tables/speed.csv");
    }
    Ok(())
}

/// What stands above the rows.
fn header() -> String {
    let processor = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = processor
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or(std::env::consts::ARCH, |(_, name)| name);
    let cores = thread::available_parallelism().map_or(1, usize::from);
    format!(
        "# speed\n\
         # the least time of each part of a solve, of many runs in turn, and its ratio to the same \
         written by hand: of assembly to assembly, of all else to one Newton step\n\
         # command: cargo xtask bench\n\
         # machine: {processor}, {cores} cores, {}; one thread, no flags for the processor\n",
        std::env::consts::OS
    )
}
