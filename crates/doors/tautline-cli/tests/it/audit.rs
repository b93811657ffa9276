//! The verb that runs another program.

#![cfg(unix)]

use std::{fs, os::unix::fs::symlink, process::Command};

use crate::folder;

/// The shell takes the place of the program of the audit. One that is killed has no exit code, and has
/// found out nothing.
#[test]
fn an_audit_ends_as_its_program_does() {
    let folder = folder("audit");
    // A link keeps its own name, where the program looks beside itself.
    let own = folder.join("tautline");
    fs::hard_link(env!("CARGO_BIN_EXE_tautline"), &own).expect("a link");
    symlink("/bin/sh", folder.join("tautline-audit")).expect("a link");
    for (script, code) in [("exit 0", 0), ("exit 3", 3), ("kill -9 $$", 1), ("kill -15 $$", 1)] {
        let status = Command::new(&own).args(["audit", "-c", script]).status().expect("started");
        assert_eq!(status.code(), Some(code), "{script}");
    }
}
