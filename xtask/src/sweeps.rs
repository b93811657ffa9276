//! `cargo xtask sweeps`: shows that a sweep has the same bytes however it was run.

use std::{env, path::Path, process::Command};

use crate::{
    peers::install,
    python::wheel,
    run::{cargo, run},
};

/// Runs 2,000 problems in one process, on Dask with a worker that is killed, and in 40 shards that are
/// killed at random moments; with `ray` also on Ray. It installs the wheel and the engines into
/// `target/sweeps-environment`.
pub(crate) fn sweeps(root: &Path, rest: &[&str]) -> Result<(), String> {
    let (ray, rest) = match rest {
        ["ray", rest @ ..] => (true, rest),
        _ => (false, rest),
    };
    let seed = match rest {
        [] => Vec::new(),
        ["--seed", seed] => vec!["--seed", *seed],
        _ => return Err("usage: cargo xtask sweeps [ray] [--seed SEED]".to_owned()),
    };
    let target = root.join(env::var_os("CARGO_TARGET_DIR").unwrap_or("target".into()));
    let environment = target.join("sweeps-environment");
    let checks = root.join("python/checks");
    wheel(root, &target, &environment)?;
    install(&environment, &checks.join("requirements.txt"))?;
    if ray {
        install(&environment, &checks.join("requirements-ray.txt"))?;
    }
    cargo(&["build", "--release", "--package", "tautline-cli"], &[])?;
    let python = environment.join("bin/python");
    let mut check = Command::new(&python);
    check.arg(checks.join("sweeps.py"));
    check.arg("--tautline").arg(target.join("release/tautline"));
    check.arg("--folder").arg(target.join("sweeps")).args(seed);
    if ray {
        check.arg("--ray");
    }
    let line = format!("{check:?}");
    run(&mut check, &line)
}
