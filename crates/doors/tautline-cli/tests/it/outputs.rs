//! Outputs that are closed, full or cut, and files that are written whole or not at all.

#![cfg(unix)]

use std::{
    fs::{self, File},
    path::Path,
    process::{Command, Output, Stdio},
};

use crate::{folder, names, tautline, text};

const FILE: &str = "\
[metric]
phi = \"(2 - cos(x1))^2\"
[from]
point = [0, 0]
[to]
point = [3, 0]
";

/// Every verb that prints.
const PRINTING: [&[&str]; 9] = [
    &["solve", "v.toml"],
    &["solve", "v.toml", "--json"],
    &["constants", "v.toml"],
    &["certify", "v.toml", "--gap", "0.1"],
    &["plan", "sweep.toml"],
    &["schema"],
    &["examples"],
    &["completions", "bash"],
    &["--help"],
];

fn written(name: &str) -> std::path::PathBuf {
    let folder = folder(name);
    fs::write(folder.join("v.toml"), FILE).expect("written");
    let example = tautline_problem::Example::named("sweep").expect("an example").text;
    let (problem, _) = example.split_once("[sweep.vary]").expect("a section");
    let sweep = "[sweep]\ndraws = 120\nseed = 3\nvary = { y = { uniform = [-1, 1] } }\n";
    let file = format!("{}{sweep}", problem.replace("n = 64", "n = 16"));
    fs::write(folder.join("sweep.toml"), file).expect("written");
    folder
}

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tautline"));
    command.args(arguments).current_dir(folder);
    command
}

#[test]
fn a_full_output_is_an_error_and_a_full_stderr_no_panic() {
    let folder = written("full");
    let full = || Stdio::from(File::options().write(true).open("/dev/full").expect("a device"));
    for arguments in PRINTING {
        let output = command(&folder, arguments).stdout(full()).output().expect("started");
        assert_ne!(output.status.code(), Some(0), "{arguments:?}");
        assert!(output.status.code().is_some_and(|code| code <= 2), "{arguments:?}");
        let said = text(&output.stderr);
        let is_said = said.contains("standard output") || arguments == ["--help"];
        assert!(is_said && !said.contains("panicked"), "{arguments:?}: {said}");
        // With nobody to tell, the code still says it.
        let output = command(&folder, arguments).stdout(full()).stderr(full()).output();
        let code = output.expect("started").status.code();
        assert!(matches!(code, Some(1 | 2)), "{arguments:?}: {code:?}");
    }
    for arguments in [&["solve", "nothing.toml"][..], &["solve", "--wrong"], &["nothing"]] {
        let output = command(&folder, arguments).stderr(full()).output().expect("started");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    }
    // What is said beside the results does not count.
    let run = ["run", "sweep.toml", "--to", "r"];
    let output = command(&folder, &run).stderr(full()).output().expect("started");
    assert_eq!(output.status.code(), Some(0));
    assert!(folder.join("r/1-of-1.csv").exists());
}

#[test]
fn a_reader_that_has_gone_away_is_no_panic_and_no_success() {
    let folder = written("gone");
    for arguments in PRINTING {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let output = command(&folder, arguments).stdout(writer).output().expect("started");
        let said = text(&output.stderr);
        assert!(matches!(output.status.code(), Some(1 | 2)), "{arguments:?}: {:?}", output.status);
        assert!(said.is_empty(), "{arguments:?}: {said}");
    }
    // Of stderr: the error is not read, and the code is the same.
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let output = command(&folder, &["solve", "nothing.toml"]).stderr(writer).output();
    assert_eq!(output.expect("started").status.code(), Some(2));
    let closed = |arguments: &str| {
        let program = env!("CARGO_BIN_EXE_tautline");
        let shell = format!("'{program}' {arguments} 2>&-");
        let status = Command::new("sh").args(["-c", &shell]).current_dir(&folder).output();
        status.expect("started").status.code()
    };
    assert_eq!(closed("solve nothing.toml"), Some(2));
    assert_eq!(closed("solve v.toml"), Some(0));
    // The pictures of an answer that nobody reads are drawn.
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let plot = ["solve", "v.toml", "--plot", "v.svg"];
    assert!(!command(&folder, &plot).stdout(writer).status().expect("started").success());
    assert!(folder.join("v.svg").exists());
}

/// With 1 a check says that nothing is proved. A reader that has seen enough does not change what is, and
/// a full output leaves it unsaid.
#[test]
fn the_code_of_a_check_tells_what_is_proved() {
    let folder = written("check-code");
    let made = tautline(&folder, &["certify", "v.toml", "--gap", "0.1", "-o", "v.cert"]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let output = command(&folder, &["check", "v.cert"]).stdout(writer).output().expect("started");
    assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), String::new()));
    let full = Stdio::from(File::options().write(true).open("/dev/full").expect("a device"));
    let output = command(&folder, &["check", "v.cert"]).stdout(full).output().expect("started");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("standard output"), "{}", text(&output.stderr));
}

/// Runs the command in a shell where no file may have more than a few thousand bytes. With the signal
/// ignored, a write fails as on a full disk; otherwise the process is killed in the middle of it.
fn limited(folder: &Path, arguments: &[&str], is_killed: bool) -> Output {
    let trap = if is_killed { "" } else { "trap '' XFSZ; " };
    let program = env!("CARGO_BIN_EXE_tautline");
    // Units are of 512 or 1024 bytes.
    let shell = format!("{trap}ulimit -f 2; exec '{program}' {}", arguments.join(" "));
    Command::new("sh").args(["-c", &shell]).current_dir(folder).output().expect("started")
}

/// Every file that the command writes is the old one or none if the disk is full, and if the process is
/// killed in the middle.
#[test]
fn a_full_disk_or_a_kill_leaves_the_old_file_or_none() {
    let folder = written("disk");
    assert!(tautline(&folder, &["run", "sweep.toml", "--to", "good"]).status.success());
    let cases: [(&[&str], &str); 9] = [
        (&["certify", "v.toml", "--gap", "1e-2", "-o", "out/v.cert"], "out/v.cert"),
        (&["certify", "v.toml", "--gap", "0.1", "--plot", "out/c.pdf"], "out/c.pdf"),
        (&["solve", "v.toml", "--plot", "out/v.svg"], "out/v.svg"),
        (&["solve", "v.toml", "--plot", "out/v.png"], "out/v.png"),
        (&["plot", "v.toml", "out/p.pdf"], "out/p.pdf"),
        (&["plan", "sweep.toml", "-o", "out/plan.csv"], "out/plan.csv"),
        (&["run", "sweep.toml", "--to", "out"], "out/1-of-1.csv"),
        (&["merge", "good", "-o", "out/merged.csv"], "out/merged.csv"),
        (&["plan", "sweep.toml", "-o", "out/new.csv"], "out/new.csv"),
    ];
    for (arguments, path) in cases {
        for is_killed in [false, true] {
            let _ = fs::remove_dir_all(folder.join("out"));
            fs::create_dir(folder.join("out")).expect("a folder");
            let is_new = path.ends_with("new.csv");
            // An old file of a sweep is one that was cut.
            let old = if path.contains("1-of-1") {
                let good = fs::read_to_string(folder.join("good/1-of-1.csv")).expect("results");
                good[..good.len() - 5].to_owned()
            } else {
                "the old one".to_owned()
            };
            if !is_new {
                fs::write(folder.join(path), &old).expect("written");
            }
            let output = limited(&folder, arguments, is_killed);
            if is_killed {
                assert_eq!(output.status.code(), None, "{arguments:?}: {output:?}");
            } else {
                assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
                assert!(text(&output.stderr).contains("File too large"), "{output:?}");
                // The draft is gone.
                assert!(names(&folder.join("out")).len() <= 1, "{:?}", names(&folder.join("out")));
            }
            let found = fs::read_to_string(folder.join(path));
            assert_eq!(found.ok(), (!is_new).then_some(old), "{arguments:?}");
            // Without the limit, the file is there, and drafts of killed processes are not.
            assert!(tautline(&folder, arguments).status.success(), "{arguments:?}");
            let name = path.rsplit('/').next().expect("a name");
            assert_eq!(names(&folder.join("out")), [name], "{arguments:?}");
            assert!(fs::metadata(folder.join(path)).expect("a file").len() > 2048, "{path}");
        }
    }
}

/// A link to a file that is not there yet, or is in another folder, remains a link; the file is written.
/// Where there is no such folder, or links lead in a circle, nothing is.
#[test]
fn a_link_is_followed_to_a_file_that_is_not_there() {
    use std::os::unix::fs::symlink;

    let folder = written("links");
    fs::create_dir(folder.join("other")).expect("made");
    for (link, target) in [
        ("one.csv", "new.csv"),
        ("two.csv", "other/next.csv"),
        ("other/next.csv", "last.csv"),
        ("lost.csv", "nowhere/file.csv"),
        ("round.csv", "back.csv"),
        ("back.csv", "round.csv"),
    ] {
        symlink(target, folder.join(link)).expect("linked");
    }
    let before = [names(&folder), names(&folder.join("other"))];
    let plan = |to: &str| tautline(&folder, &["plan", "sweep.toml", "-o", to]);
    for link in ["lost.csv", "round.csv"] {
        let output = plan(link);
        assert_eq!(output.status.code(), Some(2), "{link}: {output:?}");
        assert_eq!([names(&folder), names(&folder.join("other"))], before);
    }
    // The second time the files are there.
    for (link, file) in [("one.csv", "new.csv"), ("two.csv", "other/last.csv")].repeat(2) {
        let output = plan(link);
        assert_eq!(output.status.code(), Some(0), "{link}: {output:?}");
        assert!(fs::read_to_string(folder.join(file)).expect("read").starts_with("# tautline"));
        let is_file =
            |name: &str| fs::symlink_metadata(folder.join(name)).expect("there").is_file();
        assert!(is_file(file) && !is_file(link), "{link}");
    }
    assert!(fs::symlink_metadata(folder.join("other/next.csv")).expect("there").is_symlink());
    assert_eq!(names(&folder).len(), before[0].len() + 1);
    assert_eq!(names(&folder.join("other")).len(), before[1].len() + 1);
}

/// A device is written to, and what it refuses is an error.
#[test]
fn a_device_is_no_file() {
    let folder = written("device");
    let plan = |to: &str| tautline(&folder, &["plan", "sweep.toml", "-o", to]);
    assert_eq!(plan("/dev/full").status.code(), Some(2));
    assert_eq!(plan("/dev/null").status.code(), Some(0));
    assert!(fs::metadata("/dev/null").is_ok_and(|device| !device.is_file()));
    assert_eq!(names(&folder), ["sweep.toml", "v.toml"]);
    std::os::unix::fs::symlink("real.csv", folder.join("link.csv")).expect("linked");
    fs::write(folder.join("real.csv"), "before").expect("written");
    assert_eq!(plan("link.csv").status.code(), Some(0));
    assert!(fs::symlink_metadata(folder.join("link.csv")).expect("there").is_symlink());
    assert!(fs::read_to_string(folder.join("real.csv")).expect("read").starts_with("# tautline"));
}

/// Writes a problem that reads a table from `h.png`, a sweep of it, and results of that sweep in `good`.
fn with_tables(name: &str) -> std::path::PathBuf {
    let folder = folder(name);
    // What a table is shows in its bytes, not in its name.
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 2), }\n";
    let length = (header.len() as u16).to_le_bytes();
    let npy = [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), &[1, 2, 3, 4]].concat();
    fs::write(folder.join("h.png"), npy).expect("written");
    let file = "[parameters]\na = 1\n[tables]\nh = { file = \"h.png\" }\n[metric]\n\
                cost = \"1 + a*h(x1, x2)\"\n[from]\npoint = [0, 0]\n[to]\npoint = [1, 1]\n\
                [solve]\nn = 16\n";
    fs::write(folder.join("v.toml"), file).expect("written");
    let sweep = format!("{file}[sweep.vary]\na = [1, 2]\n");
    fs::write(folder.join("s.toml"), sweep).expect("written");
    assert!(tautline(&folder, &["plan", "s.toml", "-o", "p.csv"]).status.success());
    assert!(tautline(&folder, &["run", "s.toml", "--to", "good"]).status.success());
    for (name, target) in [("v.svg", "v.toml"), ("v.cert", "v.toml"), ("s.csv", "s.toml")] {
        std::os::unix::fs::symlink(target, folder.join(name)).expect("linked");
    }
    fs::hard_link(folder.join("h.png"), folder.join("hard.png")).expect("linked");
    fs::create_dir(folder.join("in")).expect("made");
    folder
}

/// Every verb that writes, with each of its inputs and outputs. Nothing is done: no file is new, and none
/// has other bytes.
#[test]
fn an_output_is_no_input_and_no_other_output() {
    let folder = with_tables("same-files");
    let state = || {
        let bytes = |folder: &Path| -> Vec<(String, Vec<u8>)> {
            let files = names(folder).into_iter().filter(|name| !folder.join(name).is_dir());
            files.map(|name| (name.clone(), fs::read(folder.join(name)).expect("read"))).collect()
        };
        ([bytes(&folder), bytes(&folder.join("good")), bytes(&folder.join("in"))], names(&folder))
    };
    let before = state();
    let read = "; write to another file";
    let twice = "are the same file; write to two";
    let cases: [(&[&str], &str); 23] = [
        (&["solve", "v.toml", "--plot", "h.png"], read),
        (&["solve", "v.toml", "--plot", "hard.png"], read),
        (&["solve", "v.toml", "--plot", "./h.png"], read),
        (&["solve", "v.toml", "--plot", "v.svg"], read),
        (&["solve", "v.toml", "--plot", "a.svg", "--plot", "in/../a.svg"], twice),
        (&["plot", "v.toml", "in/../h.png"], read),
        (&["plot", "v.toml", "v.svg", "--no-curve"], read),
        (&["plot", "v.toml", "a.pdf", "a.svg", "./a.pdf"], twice),
        (&["certify", "v.toml", "--gap", "0.5", "-o", "v.toml"], read),
        (&["certify", "v.toml", "--gap", "0.5", "-o", "v.cert"], read),
        (&["certify", "v.toml", "--gap", "0.5", "-o", "hard.png"], read),
        (&["certify", "v.toml", "--gap", "0.5", "--plot", "h.png"], read),
        (&["certify", "v.toml", "--gap", "0.5", "-o", "a.svg", "--plot", "./a.svg"], twice),
        (&["plan", "s.toml", "-o", "s.toml"], read),
        (&["plan", "s.toml", "-o", "./s.csv"], read),
        (&["plan", "s.toml", "-o", "h.png"], read),
        (&["plan", "p.csv", "-o", "p.csv"], read),
        (&["run", "s.toml", "--to", "new", "--times", "s.toml"], read),
        (&["run", "p.csv", "--to", "new", "--times", "p.csv"], read),
        (&["run", "p.csv", "--to", "new", "--times", "hard.png"], read),
        (&["run", "s.toml", "--to", "new", "--times", "new/1-of-1.csv"], twice),
        (&["merge", "good", "-o", "good/1-of-1.csv"], read),
        (&["merge", "good/1-of-1.csv", "-o", "in/../good/1-of-1.csv"], read),
    ];
    for (arguments, says) in cases {
        let output = tautline(&folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}: {output:?}");
        assert!(text(&output.stderr).contains(says), "{arguments:?}: {output:?}");
        assert!(state() == before, "{arguments:?}");
    }
    // Two examples of one name are one file, and one that is there is left before any is written.
    let twice = tautline(&folder, &["examples", "tie", "tie", "--to", "in"]);
    assert!(twice.status.code() == Some(2) && state() == before);
    assert!(tautline(&folder, &["examples", "tie", "--to", "in"]).status.success());
    let before = state();
    let there = tautline(&folder, &["examples", "valleys", "tie", "--to", "in"]);
    assert!(text(&there.stderr).contains("tie.toml exists already"));
    assert!(there.status.code() == Some(2) && state() == before);
}

/// Before the work, not after it.
#[test]
fn an_output_in_no_folder_is_refused_at_once() {
    let folder = with_tables("no-folder");
    let before = names(&folder);
    for arguments in [
        &["certify", "v.toml", "--gap", "0.5", "-o", "none/v.cert"][..],
        &["solve", "v.toml", "--plot", "none/v.svg"],
        &["plan", "s.toml", "-o", "none/p.csv"],
        &["merge", "good", "-o", "none/all.csv"],
        &["run", "p.csv", "--to", "good", "--shard", "1/2", "--times", "none/times.csv"],
    ] {
        let output = tautline(&folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}: {output:?}");
        assert_eq!(
            (names(&folder), names(&folder.join("good"))),
            (before.clone(), vec!["1-of-1.csv".to_owned()])
        );
    }
    // The folder of the results is made, and may hold the times too.
    let times = ["run", "p.csv", "--to", "new", "--times", "new/times.txt"];
    assert!(tautline(&folder, &times).status.success());
    assert_eq!(names(&folder.join("new")), ["1-of-1.csv", "times.txt"]);
}
