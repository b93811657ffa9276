//! `cargo xtask <task>`: the commands of the repository that go beyond building and testing one
//! crate.

mod bench;
mod guide;
mod nightly;
mod peers;
mod python;
mod release;
mod run;
mod said;
mod second_checker;
mod sweeps;

use std::{
    env,
    process::{Command, ExitCode},
};

use run::{cargo, root, run};

const USAGE: &str = "\
usage: cargo xtask <task>

  figures [ID …] [--check | --quick | --list]   recompute and redraw paper/figures and paper/data
  tables  [ID …] [--check | --quick | --list]   recompute paper/tables
  test    [ARG …]                               every test of the workspace
  nightly [-p PACKAGE] [NAME] [-- ARG …]        everything random with a fresh seed, printed first,
                                                and 100 times the cases, unless TAUTLINE_SEED and
                                                TAUTLINE_CASES are set
  bench   [TABLE] … [P1 | … | N | batch | …] …  times the parts of a solve (speed), large problems
                                                (scale), the start-up of formulas (programs), and
                                                certificates (certificate), to paper/tables; with
                                                parts, only prints those of speed and scale
  second-checker [PYTHON]                       tests the checker in Python, and compares it with the
                                                one in Rust on certificates by chance and on those
                                                of the gallery: paper/tables/second_checker.csv;
                                                needs Python 3 and, the first time, the network
  peers   [--problem ID | --n N | --distance] … other programs on the same problems, timed; needs
                                                Python 3 and downloads what docs/comparison.md lists
  python  [speed | audit]                       makes the wheel of the Python module, and tests it in
                                                an environment of its own, or measures what calls
                                                from Python cost, and paths through images beside
                                                scikit-image, or makes and tests the wheel of the
                                                audit, which takes many minutes; needs Python 3.10
                                                and, the first time, the network
  sweeps  [ray] [--seed SEED]                   2,000 problems in one process, on Dask with a worker
                                                that is killed, in 40 shards that are killed, and on
                                                Ray if asked: the same bytes; needs Python 3.10 and,
                                                the first time, the network
  guide   [--check]                             the guide, to target/guide; --check opens every page
                                                in Chromium and lists what is wrong
  release [--allow-dirty]                       makes the packages of all published crates, compiles
                                                each from its package, and compares the public items
                                                with the last tag; publishes nothing
  ci                                            what continuous integration runs

  --check   recompute, and compare with what is committed
  --quick   fewer subintervals, written to target/quick
  --list    name what there is";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match arguments.as_slice() {
        ["figures", rest @ ..] => paper(&["--no-default-features", "--", "figures"], rest),
        ["tables", rest @ ..] => paper(&["--", "tables"], rest),
        ["test", rest @ ..] => test(rest),
        ["nightly", rest @ ..] => nightly::nightly(&root(), rest),
        ["bench", rest @ ..] => bench::bench(&root(), rest),
        ["peers", rest @ ..] => peers::peers(&root(), rest),
        ["second-checker", rest @ ..] => second_checker::second_checker(&root(), rest),
        ["python", rest @ ..] => python::python(&root(), rest),
        ["sweeps", rest @ ..] => sweeps::sweeps(&root(), rest),
        ["guide", rest @ ..] => guide::guide(&root(), rest),
        ["release", rest @ ..] => release::release(rest),
        ["ci"] => ci(),
        ["help" | "--help" | "-h"] => said::print(USAGE),
        _ => Err(USAGE.to_owned()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            said::say(message);
            ExitCode::FAILURE
        }
    }
}

/// Runs the package that computes and draws. It uses the profile of the tests, so that little is
/// compiled twice. The figures do not use the feature `tables`, whose dependencies take longer to
/// compile than everything that the figures need.
fn paper(what: &[&str], rest: &[&str]) -> Result<(), String> {
    cargo(&[&["run", "--package", "paper"], what, rest].concat(), &[])
}

/// Runs unit and integration tests, then documentation tests. `--tests` includes the libraries and
/// programs with unit tests, whereas `--lib` would also compile those without any. The lints check
/// that the examples compile, without generating machine code.
fn test(rest: &[&str]) -> Result<(), String> {
    cargo(&[&["test", "--workspace", "--tests"], rest].concat(), &[])?;
    cargo(&[&["test", "--workspace", "--doc"], rest].concat(), &[])
}

/// Checks the formatting, lints, documentation and tests, and whether the committed figures and
/// tables are what the code computes. The cheapest check comes first.
fn ci() -> Result<(), String> {
    cargo(&["fmt", "--all", "--check"], &[])?;
    let lints = ["clippy", "--workspace", "--all-targets", "--", "--deny", "warnings"];
    cargo(&lints, &[])?;
    cargo(&["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "--deny warnings")])?;
    test(&[])?;
    check("figures")?;
    check("tables")
}

/// Compares the committed files with recomputed ones, using the program that the tests have built.
/// `cargo run` would compile the program and its libraries again, since test dependencies enable
/// more features of shared crates.
fn check(what: &str) -> Result<(), String> {
    let program =
        env::current_exe().map_err(|error| format!("the path of this program: {error}"))?;
    let program = program.with_file_name(format!("paper{}", env::consts::EXE_SUFFIX));
    let line = format!("{} {what} --check", program.display());
    run(Command::new(&program).args([what, "--check"]), &line)
}
