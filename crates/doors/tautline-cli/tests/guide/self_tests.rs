//! Tests of the runner itself, with a small program in place of `tautline`.

use std::{fs, path::PathBuf, sync::OnceLock};

use libtest_mimic::{Failed, Trial};

use crate::{
    block::{Kind, blocks},
    page::{Page, orphans},
};

/// Answers `solve FILE` with the file, `fail` with an error and code 2, and `many` with lines.
const STAND_IN: &str = "#!/bin/sh
case $1 in
  solve) echo 'length 5.5  '; cat \"$2\" ;;
  fail) echo 'error: no file' >&2; exit 2 ;;
  many) echo one; echo two; echo three ;;
esac
";

/// Returns the tests.
pub(crate) fn all() -> Vec<Trial> {
    vec![
        Trial::test("answers_are_compared_line_by_line", answers_are_compared),
        Trial::test("a_failure_must_be_announced", a_failure_must_be_announced),
        Trial::test("a_block_that_nothing_checks_fails", unchecked_blocks_fail),
        Trial::test("a_page_with_rust_must_be_a_documentation_test", rust_is_documented),
        Trial::test("blessing_writes_answers_and_leaves_the_rest", blessing),
        Trial::test("a_page_that_nothing_links_to_is_found", orphans_are_found),
        Trial::test("a_picture_is_what_the_page_makes", pictures_are_made),
        Trial::test("blessing_copies_a_picture", blessing_copies_a_picture),
        Trial::test("blocks_have_lines_and_kinds", blocks_have_lines_and_kinds),
    ]
}

/// Returns the path of the program, which is written the first time.
fn stand_in() -> Result<PathBuf, String> {
    static WRITTEN: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    let write = || {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?.keep();
        let path = folder.join("tautline");
        fs::write(&path, STAND_IN).map_err(|error| error.to_string())?;
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            let executable = fs::Permissions::from_mode(0o755);
            fs::set_permissions(&path, executable).map_err(|error| error.to_string())?;
        }
        Ok(path)
    };
    WRITTEN.get_or_init(write).clone()
}

/// Runs one page. Returns the outcomes of its blocks, and the page afterwards.
fn run(text: &str, bless: bool) -> Result<(Vec<Result<(), String>>, String), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let path = folder.path().join("page.md");
    fs::write(&path, text).map_err(|error| error.to_string())?;
    let pages = Page::all(folder.path())?;
    let outcomes = pages.first().ok_or("no page")?.run(stand_in, bless).blocks;
    let after = fs::read_to_string(&path).map_err(|error| error.to_string())?;
    Ok((outcomes, after))
}

/// Runs one console block after a file, and returns its outcome.
fn console(commands: &str) -> Result<Result<(), String>, String> {
    let text = format!("```toml,file=a.toml\nx = 1\n```\n\n```console\n{commands}```\n");
    let (mut outcomes, _) = run(&text, false)?;
    outcomes.pop().ok_or_else(|| "no outcome".to_owned())
}

fn answers_are_compared() -> Result<(), Failed> {
    let good = [
        "$ tautline solve a.toml\nlength 5.5\nx = 1\n",
        "$ tautline many\none\n…\nthree\n",
        "$ tautline many\n…\n",
        "$ tautline many\n…\none\ntwo\nthree\n…\n",
        "$ tautline many > b.txt\n$ cat b.txt\none\ntwo\nthree\n",
    ];
    for commands in good {
        console(commands)??;
    }
    let bad = [
        "$ tautline solve a.toml\nlength 5.50\nx = 1\n",
        "$ tautline solve a.toml\nlength 5.5\n",
        "$ tautline many\none\n…\ntwo\n",
        "$ tautline many\none two three\n",
        "$ tautline many\n",
    ];
    for commands in bad {
        if console(commands)?.is_ok() {
            return Err(format!("{commands:?} passed").into());
        }
    }
    Ok(())
}

fn a_failure_must_be_announced() -> Result<(), Failed> {
    console("$ tautline fail\nerror: no file\n$ echo $?\n2\n")??;
    for commands in [
        "$ tautline fail\nerror: no file\n",
        "$ tautline fail\nerror: no file\n$ tautline many\none\ntwo\nthree\n",
        "$ tautline fail\nerror: no file\n$ echo $?\n1\n",
    ] {
        if console(commands)?.is_ok() {
            return Err(format!("{commands:?} passed").into());
        }
    }
    Ok(())
}

fn unchecked_blocks_fail() -> Result<(), Failed> {
    let text = "```console\n$ rm x\n```\n\n```console\none\n```\n\n```toml\nx = 1\n```\n\n\
                ```python\nx\n```\n\n```python,ignore=\nx\n```\n\n```\nx\n```\n\n    x\n\n\
                ```toml,file=../x.toml\n```\n";
    let (outcomes, _) = run(text, false)?;
    match outcomes.iter().position(Result::is_ok) {
        Some(index) => Err(format!("block {index} passed").into()),
        None if outcomes.len() == 8 => Ok(()),
        None => Err(format!("{outcomes:?}").into()),
    }
}

fn rust_is_documented() -> Result<(), Failed> {
    let (outcomes, _) = run("```rust\nassert!(true);\n```\n", false)?;
    match outcomes.as_slice() {
        [Err(why)] if why.contains("guide/pages/page.md") => Ok(()),
        other => Err(format!("{other:?}").into()),
    }
}

fn blessing() -> Result<(), Failed> {
    let page = |answer: &str| {
        format!(
            "# A\n\n```console\n$ tautline many\none\n…\n```\n\nText.\n\n```console\n$ tautline \
             many\n{answer}$ echo done\ndone\n```\n\nMore.\n"
        )
    };
    let (outcomes, after) = run(&page("four\n"), true)?;
    for outcome in outcomes {
        outcome?;
    }
    if after == page("one\ntwo\nthree\n") { Ok(()) } else { Err(after.into()) }
}

fn orphans_are_found() -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    for (name, text) in [("SUMMARY.md", "- [A](a.md)\n"), ("a.md", ""), ("b.md", "")] {
        fs::write(folder.path().join(name), text)?;
    }
    let found = orphans(&Page::all(folder.path())?);
    if found == ["b.md"] { Ok(()) } else { Err(format!("{found:?}").into()) }
}

/// Runs one page beside a picture `a.svg`. Returns the outcome of its only picture, and the picture
/// afterwards.
fn picture(text: &str, old: &str, bless: bool) -> Result<(Result<(), String>, String), Failed> {
    let folder = tempfile::tempdir()?;
    let shown = folder.path().join("pictures/a.svg");
    fs::create_dir(folder.path().join("pictures"))?;
    fs::write(folder.path().join("page.md"), text)?;
    fs::write(&shown, old)?;
    let pages = Page::all(folder.path())?;
    let outcomes = pages.first().ok_or("no page")?.run(stand_in, bless);
    match outcomes.pictures.as_slice() {
        [outcome] => Ok((outcome.clone(), fs::read_to_string(&shown)?)),
        other => Err(format!("{other:?}").into()),
    }
}

/// A page whose command writes `one`, `two` and `three` into `a.svg`, and shows it.
const PICTURED: &str = "```console\n$ tautline many > a.svg\n```\n\n![Lines](pictures/a.svg)\n";

fn pictures_are_made() -> Result<(), Failed> {
    picture(PICTURED, "one\ntwo\nthree\n", false)?.0?;
    let bad = [
        (PICTURED.to_owned(), "one\ntwo\n", "not the file"),
        (PICTURED.replace("a.svg)", "b.svg)"), "one\n", "no command"),
        (PICTURED.replace("> a.svg", "> b.svg"), "one\ntwo\nthree\n", "no command"),
        (PICTURED.replace("Lines", ""), "one\ntwo\nthree\n", "no text"),
        ("```svg,file=a.svg\nx\n```\n\n![Lines](pictures/a.svg)\n".to_owned(), "x\n", "a block"),
    ];
    for (text, old, why) in bad {
        match picture(&text, old, false)?.0 {
            Err(told) if told.contains(why) => {}
            other => return Err(format!("{text:?}: {other:?}").into()),
        }
    }
    Ok(())
}

fn blessing_copies_a_picture() -> Result<(), Failed> {
    let (outcome, after) = picture(PICTURED, "old", true)?;
    outcome?;
    if after == "one\ntwo\nthree\n" { Ok(()) } else { Err(after.into()) }
}

fn blocks_have_lines_and_kinds() -> Result<(), Failed> {
    let text = "# A\n\n```rust\nx\n```\n\n- b\n\n  ```csv,file=b.csv\n  1\n  2\n  ```\n\n\
                ```julia,ignore=needs Julia\nx\n```\n";
    let found = blocks(text);
    let seen: Vec<_> = found.iter().map(|it| (it.line, &it.kind, it.text.as_str())).collect();
    let file = Kind::File("b.csv".to_owned());
    let expected =
        [(3, &Ok(Kind::Rust), "x\n"), (9, &Ok(file), "1\n2\n"), (14, &Ok(Kind::Ignored), "x\n")];
    if seen == expected { Ok(()) } else { Err(format!("{seen:?}").into()) }
}
