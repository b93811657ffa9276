//! Runs every block of code in the guide as a test, named by its page and line, and compares every
//! picture with the one that its page makes.
//!
//! `cargo test -p tautline-cli --test guide -- --list` lists the tests. With `TAUTLINE_BLESS=1`
//! answers that differ are written into the pages, and pictures are copied into the guide.

#[path = "guide/bless.rs"]
mod bless;
#[path = "guide/block.rs"]
mod block;
#[path = "guide/command.rs"]
mod command;
#[path = "guide/page.rs"]
mod page;
#[path = "guide/picture.rs"]
mod picture;
#[path = "guide/self_tests.rs"]
mod self_tests;

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
    sync::{Arc, OnceLock},
};

use libtest_mimic::{Arguments, Failed, Trial};
use page::{Outcomes, Page};

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let pages = root().join("guide/pages");
    let tests = match trials(&pages, command::tautline) {
        Ok(tests) => tests,
        Err(error) => vec![Trial::test("the_guide_can_be_read", move || Err(error.into()))],
    };
    let tests = tests.into_iter().chain(self_tests::all()).collect();
    libtest_mimic::run(&arguments, tests).exit_code()
}

/// Selects the outcome of one test.
type Select = dyn Fn(&Outcomes) -> &Result<(), String> + Send;

/// Returns the root of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// Returns a test for each block and each picture of each page below `folder`. The command
/// `tautline` is the program that `tautline` names.
fn trials(folder: &Path, tautline: fn() -> Result<PathBuf, String>) -> Result<Vec<Trial>, String> {
    let bless = std::env::var_os("TAUTLINE_BLESS").is_some();
    let mut trials = Vec::new();
    let pages = Page::all(folder)?;
    trials.push(Trial::test("every_page_is_in_the_table_of_contents", {
        let orphans = page::orphans(&pages);
        move || if orphans.is_empty() { Ok(()) } else { Err(orphans.join(", ").into()) }
    }));
    for page in pages {
        let page = Arc::new(page);
        // The first test of a page runs all its blocks, in order: they share a folder.
        let outcomes: Arc<OnceLock<Outcomes>> = Arc::default();
        let mut test = |name: String, select: Box<Select>| {
            let (page, outcomes) = (Arc::clone(&page), Arc::clone(&outcomes));
            trials.push(Trial::test(name, move || {
                let outcomes = outcomes.get_or_init(|| page.run(tautline, bless));
                select(outcomes).clone().map_err(Failed::from)
            }));
        };
        for (index, block) in page.blocks.iter().enumerate() {
            let name = format!("{}:{}", page.name, block.line);
            test(name, Box::new(move |outcomes| &outcomes.blocks[index]));
        }
        for (index, picture) in page.pictures.iter().enumerate() {
            let name = format!("{}:{}", page.name, picture.name);
            test(name, Box::new(move |outcomes| &outcomes.pictures[index]));
        }
    }
    Ok(trials)
}
