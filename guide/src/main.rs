//! `cargo xtask guide`: builds the guide, and tests it in a browser.

mod book;
#[cfg(feature = "browser")]
mod browser;
mod captions;
mod formulas;
mod interactive;
mod page;

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::ExitCode,
};

use mdbook_preprocessor::errors::{Error, Result};

const USAGE: &str = "\
usage: guide OUTPUT [--check]

  OUTPUT    the folder to write, replaced as a whole
  --check   open every page in headless Chromium, and list what is wrong; writes pictures of the
            pages to OUTPUT-pictures";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments.as_slice() {
        [output] if !output.starts_with('-') => build(Path::new(output)),
        [output, "--check"] => build(Path::new(output)).and_then(|()| check(Path::new(output))),
        _ => Err(Error::msg(USAGE)),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Builds the guide beside `output`, and then puts it in its place, so that a failure leaves the
/// last guide as it was.
fn build(output: &Path) -> Result<()> {
    let fresh = beside(output, "new");
    if fresh.exists() {
        fs::remove_dir_all(&fresh)?;
    }
    book::build(Path::new(env!("CARGO_MANIFEST_DIR")), &fresh)?;
    let built = interactive::build(&fresh)?;
    if built == interactive::Built::NoTarget {
        // Links to the page lead to the reason why it is missing.
        fs::write(fresh.join(interactive::FILE), without_page(&built))?;
        println!("{built}");
    }
    if output.exists() {
        if !output.join("index.html").is_file() {
            let why = "is no guide, and is not replaced";
            return Err(Error::msg(format!("{} {why}", output.display())));
        }
        fs::remove_dir_all(output)?;
    }
    fs::rename(&fresh, output)?;
    println!("{}", output.join("index.html").display());
    Ok(())
}

/// Returns what stands in place of the page that computes, in a guide without it.
fn without_page(built: &interactive::Built) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Tautline</title>\n\
         <p>This guide was built without the page that computes: {built}.</p>\n\
         <p><a href=\"index.html\">The guide</a></p>\n</html>\n"
    )
}

#[cfg(feature = "browser")]
fn check(output: &Path) -> Result<()> {
    browser::check(output, &beside(output, "pictures"))
}

#[cfg(not(feature = "browser"))]
fn check(_: &Path) -> Result<()> {
    Err(Error::msg("built without the feature `browser`: run `cargo xtask guide --check`"))
}

/// Returns the path of a folder beside `output` whose name ends with `-suffix`.
fn beside(output: &Path, suffix: &str) -> PathBuf {
    let mut name = output.file_name().unwrap_or_default().to_owned();
    name.push("-");
    name.push(suffix);
    output.with_file_name(name)
}
