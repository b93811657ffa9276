//! The command `tautline`, run as a user runs it.

mod audit;
mod certificates;
#[path = "../../../../library/tautline-scalar/src/exact_decimal.rs"]
mod exact_decimal;
mod malformed;
mod outputs;
mod printed;
mod sweeps;
mod tables;
mod verbs;

use std::{
    path::Path,
    process::{Command, Output},
};

/// Runs the command in a folder.
fn tautline(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tautline"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the command starts")
}

/// Returns a new folder of this test.
fn folder(name: &str) -> std::path::PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Returns the names of the files in a folder, in order.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let name = |entry: std::io::Result<std::fs::DirEntry>| {
        entry.expect("an entry").file_name().to_string_lossy().into_owned()
    };
    let mut names: Vec<String> = entries.map(name).collect();
    names.sort();
    names
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}
