//! `cargo xtask python`: makes the wheel, and tests it in an environment of its own.

use std::{env, fs, path::Path, process::Command};

use crate::{peers::install, run::run};

/// Makes the wheel of the Python module, installs it into `target/python-environment`, and runs its
/// tests, those of its documentation, and `stubtest`.
pub(crate) fn python(root: &Path, rest: &[&str]) -> Result<(), String> {
    if !rest.is_empty() {
        return Err("python takes no arguments".to_owned());
    }
    let target = root.join(env::var_os("CARGO_TARGET_DIR").unwrap_or("target".into()));
    let environment = target.join("python-environment");
    install(&environment, &root.join("python/requirements.txt"))?;
    let python = environment.join("bin/python");
    let wheels = target.join("wheels");
    // An old wheel would be installed in place of the new one.
    let _ = fs::remove_dir_all(&wheels);
    let call = |arguments: &[&str]| {
        let line = format!("{} {}", python.display(), arguments.join(" "));
        run(Command::new(&python).args(arguments), &line)
    };
    let (wheels, python_target) = (shown(&wheels), shown(&target.join("python")));
    let manifest = "python/Cargo.toml";
    call(&[
        "-m",
        "maturin",
        "build",
        "--release",
        "--manifest-path",
        manifest,
        "--target-dir",
        &python_target,
        "--out",
        &wheels,
    ])?;
    call(&[
        "-m",
        "pip",
        "install",
        "--quiet",
        "--force-reinstall",
        "--no-deps",
        "--no-index",
        "--find-links",
        &wheels,
        "tautline",
    ])?;
    call(&["-m", "unittest", "discover", "--start-directory", "python/tests"])?;
    call(&["-m", "mypy.stubtest", "tautline"])
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
