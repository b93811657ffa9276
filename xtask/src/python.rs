//! `cargo xtask python`: makes the wheel, and tests it in an environment of its own.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    peers::install,
    run::{cargo, run},
    said::print,
};

/// Makes the wheel of the Python module, installs it into `target/python-environment`, and runs its
/// tests, its notebooks, `stubtest`, and its examples beside those in Rust. With `speed` it measures
/// instead what calls from Python cost, and paths through images beside scikit-image. With `audit` it
/// also makes the wheel of the audit, which takes minutes, and runs the tests of the audit alone.
pub(crate) fn python(root: &Path, rest: &[&str]) -> Result<(), String> {
    let target = root.join(env::var_os("CARGO_TARGET_DIR").unwrap_or("target".into()));
    let environment = target.join("python-environment");
    if !matches!(rest, [] | ["speed" | "audit"]) {
        return Err("the only arguments of python are speed and audit, one at a time".to_owned());
    }
    wheel(root, &target, &environment)?;
    match rest {
        ["speed"] => return speed(root, &target, &environment),
        ["audit"] => return audit(&target, &environment),
        _ => {}
    }
    let python = environment.join("bin/python");
    let call = |arguments: &[&str]| {
        let line = format!("{} {}", python.display(), arguments.join(" "));
        run(Command::new(&python).args(arguments), &line)
    };
    call(&["-m", "unittest", "discover", "--start-directory", "python/tests"])?;
    call(&["-m", "mypy.stubtest", "tautline_geodesics"])?;
    twins(root, &python, &shown(&target.join("python")))
}

/// Measures what calls from Python cost, beside the same calls in Rust.
fn speed(root: &Path, target: &Path, environment: &Path) -> Result<(), String> {
    install(environment, &root.join("python/checks/requirements-speed.txt"))?;
    let example = ["build", "--release", "--package", "tautline", "--example", "beside_python"];
    cargo(&example, &[])?;
    let script = shown(&root.join("python/checks/speed.py"));
    let mut command = Command::new(environment.join("bin/python"));
    run(command.arg(&script).arg(target.join("release/examples/beside_python")), &script)
}

/// Makes the wheel of the audit, installs its program beside the interpreter, and tests it.
fn audit(target: &Path, environment: &Path) -> Result<(), String> {
    let python = environment.join("bin/python");
    let wheels = target.join("wheels-audit");
    // As above.
    let _ = fs::remove_dir_all(&wheels);
    let programs = environment.join("bin");
    // The wheel is made by the maturin of the environment.
    let path = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths(std::iter::once(programs).chain(env::split_paths(&path)));
    let path = path.map_err(|error| format!("PATH: {error}"))?;
    let make = ["-m", "pip", "wheel", "--no-deps", "--no-index", "--no-build-isolation"];
    let mut command = Command::new(&python);
    let command = command.args(make).arg("--wheel-dir").arg(&wheels).arg("python/audit");
    run(command.env("PATH", path).env("CARGO_TARGET_DIR", target), "pip wheel python/audit")?;
    install_from(environment, &wheels, "tautline-audit")?;
    let tests = ["-m", "unittest", "discover", "--start-directory", "python/tests"];
    let tests = [&tests[..], &["--pattern", "test_audit.py"]].concat();
    run(Command::new(&python).args(&tests), &format!("{} {}", shown(&python), tests.join(" ")))
}

/// Makes the wheel, and installs it into an environment with what makes and tests it.
pub(crate) fn wheel(root: &Path, target: &Path, environment: &Path) -> Result<(), String> {
    let wheels = made(root, target, environment)?;
    installed(environment, &wheels)
}

/// Makes the wheel in an environment with what makes it, and returns its folder.
pub(crate) fn made(root: &Path, target: &Path, environment: &Path) -> Result<PathBuf, String> {
    install(environment, &root.join("python/requirements.txt"))?;
    let python = environment.join("bin/python");
    let wheels = target.join("wheels");
    // An old wheel would be installed in place of the new one.
    let _ = fs::remove_dir_all(&wheels);
    let call = |arguments: &[&str]| {
        let line = format!("{} {}", python.display(), arguments.join(" "));
        run(Command::new(&python).args(arguments), &line)
    };
    let (out, python_target) = (shown(&wheels), shown(&target.join("python")));
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
        &out,
    ])?;
    Ok(wheels)
}

/// Installs the wheel in this folder into an environment, in place of an older one.
pub(crate) fn installed(environment: &Path, wheels: &Path) -> Result<(), String> {
    install_from(environment, wheels, "tautline-geodesics")
}

fn install_from(environment: &Path, wheels: &Path, package: &str) -> Result<(), String> {
    let pip = ["-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps", "--no-index"];
    let mut command = Command::new(environment.join("bin/python"));
    let command = command.args(pip).arg("--find-links").arg(wheels).arg(package);
    run(command, &format!("pip install {package}"))
}

/// Runs the examples in Python and those in Rust of the same name. Every line that the former print is
/// one that the latter print.
fn twins(root: &Path, python: &Path, target: &str) -> Result<(), String> {
    let folder = root.join("python/examples");
    let files = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut names: Vec<String> = files
        .filter_map(|file| Some(file.ok()?.path().file_stem()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    for name in &names {
        let file = folder.join(format!("{name}.py"));
        let found = printed(Command::new(python).arg(&file), &shown(&file))?;
        let arguments = ["run", "--quiet", "--release", "--target-dir", target, "--package"];
        let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
        let mut twin = Command::new(cargo);
        twin.current_dir(root).args(arguments).args(["tautline", "--example", name]);
        let expected = printed(&mut twin, &format!("the example {name} of tautline"))?;
        let lines: Vec<&str> = expected.lines().collect();
        if let Some(line) = found.lines().find(|line| !lines.contains(line)) {
            return Err(format!("{name}.py prints {line:?}, and its twin in Rust\n{expected}"));
        }
        if found.trim().is_empty() {
            return Err(format!("{name}.py prints nothing"));
        }
        let count = found.lines().count();
        print(format!("{name}: {count} lines, equal in Python and in Rust"))?;
    }
    Ok(())
}

/// Returns what a command prints.
fn printed(command: &mut Command, line: &str) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{line}: {error}"))?;
    if !output.status.success() {
        return Err(format!("{line} fails:\n{}", String::from_utf8_lossy(&output.stderr)));
    }
    String::from_utf8(output.stdout).map_err(|error| format!("{line}: {error}"))
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
