//! The program `tautline-check`: what it prints, and its exit codes.

use std::{
    fs,
    io::pipe,
    path::PathBuf,
    process::{Command, Output, Stdio},
};

use crate::{budget::long_tubes, tampering::BASE};

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_tautline-check"))
}

/// Writes a file that is removed with the value.
struct Written(PathBuf);

impl Written {
    fn new(name: &str, text: &str) -> Self {
        let path = std::env::temp_dir().join(format!("tautline-{}-{name}", std::process::id()));
        fs::write(&path, text).expect("a temporary file");
        Self(path)
    }
}

impl Drop for Written {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

fn said(output: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn a_proof_and_a_refusal_have_exit_codes() {
    let good = Written::new("good", &BASE.certificate.to_string());
    let output = program().arg(&good.0).output().expect("the program");
    let (code, out, _) = said(&output);
    assert!(code == Some(0) && out.contains("lower bound") && out.contains("upper bound"), "{out}");
    let mut certificate = BASE.certificate.clone();
    certificate.hi *= 0.9;
    let bad = Written::new("bad", &certificate.to_string());
    let (code, out, error) = said(&program().arg(&bad.0).output().expect("the program"));
    assert!(code == Some(1) && out.is_empty() && error.contains("refused"), "{error}");
    let (code, _, error) = said(&program().output().expect("the program"));
    assert!(code == Some(2) && error.starts_with("usage"), "{error}");
}

/// A name of a file is bytes.
#[cfg(target_os = "linux")]
#[test]
fn a_file_may_have_a_name_that_is_not_unicode() {
    use std::os::unix::ffi::OsStringExt;
    let name = std::ffi::OsString::from_vec(b"missing-\xff.cert".to_vec());
    let (code, out, error) = said(&program().arg(&name).output().expect("the program"));
    assert!(code == Some(2) && out.is_empty() && error.starts_with("missing-"), "{code:?} {error}");
    let path = std::env::temp_dir().join(&name);
    fs::write(&path, BASE.certificate.to_string()).expect("a temporary file");
    let output = program().arg(&path).output();
    let _ = fs::remove_file(&path);
    let (code, out, _) = said(&output.expect("the program"));
    assert!(code == Some(0) && out.contains("lower bound"), "{code:?} {out}");
}

/// What was not checked is not proved, and not refused either.
#[test]
fn a_limit_of_time_ends_the_check_and_says_what_was_not_checked() {
    let file = Written::new("limit", &BASE.certificate.to_string());
    let with = |limit: &str| program().args(["--time-limit", limit]).arg(&file.0).output();
    let (code, out, error) = said(&with("0").expect("the program"));
    assert!(code == Some(2) && out.is_empty(), "{code:?} {out}");
    assert!(error.contains("not checked in the time: stopped after 0 of 4 levels"), "{error}");
    let (code, out, _) = said(&with("1e6").expect("the program"));
    assert!(code == Some(0) && out.contains("lower bound"), "{out}");
    for limit in ["-1", "soon", "", "NaN", "inf"] {
        let (code, _, error) = said(&with(limit).expect("the program"));
        assert!(code == Some(2) && error.contains("no number of seconds"), "{limit}: {error}");
    }
    let long = Written::new("long", &long_tubes(20_000));
    let begun = std::time::Instant::now();
    let output = program().args(["--time-limit", "0.5"]).arg(&long.0).output();
    let (code, _, error) = said(&output.expect("the program"));
    assert!(code == Some(2) && error.contains("0 of 1 levels"), "{error}");
    // Reading takes a part of it.
    assert!(begun.elapsed().as_secs() < 20);
}

/// A reader that is gone is no reason to panic, whether it read errors or bounds.
#[test]
fn nobody_has_to_listen() {
    let good = Written::new("heard", &BASE.certificate.to_string());
    for (arguments, code) in [(vec![good.0.as_os_str()], 0), (vec!["nowhere".as_ref()], 2)] {
        let closed = || {
            let (reader, writer) = pipe().expect("a pipe");
            drop(reader);
            Stdio::from(writer)
        };
        let mut child = program().args(arguments).stdout(closed()).stderr(closed()).spawn();
        let status = child.as_mut().expect("the program").wait().expect("an end");
        assert_eq!(status.code(), Some(code));
    }
}
