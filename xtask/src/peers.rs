//! `cargo xtask peers`: compares Tautline with its alternatives.
//!
//! It installs the Python packages into `target/peers` and compiles the peers in Rust. Everything
//! else is done by `peers/compare.py`. A peer that cannot be installed gets a row that says so.

use std::{env, fs, path::Path, process::Command};

use crate::{
    python,
    run::{self, cargo},
    said::say,
};

/// The virtual environments: their folders below `target/peers`, and their requirements.
const ENVIRONMENTS: [(&str, &str); 2] =
    [("main", "requirements.txt"), ("geomstats", "requirements-geomstats.txt")];

/// Installs, compiles and compares. The arguments are passed to the comparison.
pub(crate) fn peers(root: &Path, rest: &[&str]) -> Result<(), String> {
    let scripts = root.join("peers");
    // All build output is written below the folder that cargo uses.
    let target = root.join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()));
    let folder = target.join("peers");
    let [python, geomstats] = ENVIRONMENTS.map(|(name, requirements)| {
        let environment = folder.join(name);
        if let Err(message) = install(&environment, &scripts.join(requirements)) {
            say(format!("{message}; peers that need it get a row that says so"));
        }
        environment.join("bin/python")
    });

    // The wheel is made elsewhere, since what makes it needs other versions of what the peers need.
    let wheel = python::made(root, &target, &target.join("python-environment"))
        .and_then(|wheels| python::installed(&folder.join("main"), &wheels));
    if let Err(message) = wheel {
        say(format!("{message}; Tautline from Python gets a row that says so"));
    }

    let example = ["build", "--release", "--package", "tautline", "--example", "peers"];
    cargo(&example, &[])?;
    // The peer is a separate workspace, with its own lock file and its own folder.
    let manifest = scripts.join("argmin/Cargo.toml").display().to_string();
    let argmin = folder.join("argmin").display().to_string();
    let build = ["build", "--release", "--manifest-path", &manifest, "--target-dir", &argmin];
    if let Err(message) = cargo(&build, &[]) {
        say(format!("{message}; argmin gets a row that says so"));
    }

    // A part of the table does not replace the whole table.
    let place =
        if rest.is_empty() { root.join("paper/tables") } else { target.join("quick/tables") };
    let paths = [
        ("--python", python.clone()),
        ("--geomstats", geomstats),
        ("--tautline", target.join("release/examples/peers")),
        ("--argmin", folder.join("argmin/release/argmin-peer")),
        ("--output", place.join("peers.csv")),
    ];
    let mut compare = Command::new(&python);
    compare.arg(scripts.join("compare.py"));
    for (name, path) in paths {
        compare.arg(name).arg(path);
    }
    run(compare.args(rest).env("PYTHONDONTWRITEBYTECODE", "1"))
}

/// Makes a virtual environment unless it exists, and installs the requirements.
pub(crate) fn install(environment: &Path, requirements: &Path) -> Result<(), String> {
    let python = environment.join("bin/python");
    if !python.exists() {
        run(Command::new("python3").args(["-m", "venv"]).arg(environment))?;
    }
    let pip = || {
        let mut command = Command::new(&python);
        command.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        command
    };
    run(pip().arg("--requirement").arg(requirements)).or_else(|_| {
        // If one package fails, pip installs none of them, so they are installed one at a time.
        let text = fs::read_to_string(requirements).map_err(|error| error.to_string())?;
        let missing = text
            .lines()
            .filter(|line| !line.is_empty() && !line.starts_with('#'))
            .filter(|line| run(pip().arg(line)).is_err());
        let missing: Vec<&str> = missing.collect();
        match missing.as_slice() {
            [] => Ok(()),
            names => Err(format!("{} could not be installed", names.join(", "))),
        }
    })
}

/// Runs a command, and prints it with its quotes.
fn run(command: &mut Command) -> Result<(), String> {
    let line = format!("{command:?}");
    run::run(command, &line)
}
