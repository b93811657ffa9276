//! The answer that the guide shows.

use crate::program::run;

/// The guide's own tests do not build this program, which takes minutes.
#[test]
fn the_guide_shows_the_beginning_of_the_report() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../..");
    let page = std::fs::read_to_string(format!("{root}/guide/pages/worked/lying-metric.md"))
        .expect("a page");
    let command = "$ tautline audit wrong_constants.toml | head -2\n";
    let (_, after) = page.split_once(command).expect("the command");
    let (shown, _) = after.split_once("```").expect("the end of the block");
    let ran =
        run(&[&format!("{root}/crates/doors/tautline-problem/problems/wrong_constants.toml")]);
    let first: String = ran.out.split_inclusive('\n').take(2).collect();
    assert_eq!(shown, first);
}
