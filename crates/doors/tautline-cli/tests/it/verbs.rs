//! The verbs, their formats and their exit codes.

use std::{
    fs,
    io::Write,
    process::{Command, Stdio},
    time::{Duration, Instant},
};

use tautline_problem::EXAMPLES;

use crate::{folder, tautline, text};

#[test]
fn an_answer_is_printed_for_a_person() {
    let folder = folder("person");
    let written = tautline(&folder, &["examples", "valleys", "--to", "."]);
    assert_eq!(text(&written.stdout), "wrote ./valleys.toml\n");
    let output = tautline(&folder, &["solve", "valleys.toml"]);
    assert!(output.status.success() && output.stderr.is_empty());
    let answer = text(&output.stdout);
    let expected = "\
distance     between 5.338147761 and 5.338305531
             the lower bound is that of a certificate, which is about all curves
length       5.338305531 of a curve of 256 chords, trapezoidal rule
             from [0.5, 0] to [3, 0]
extrapolated 5.338305531 ± 3e-8, an estimate
search       converged, Hessian positive definite
";
    assert!(answer.starts_with(expected), "{answer}");
    assert!(answer.ends_with("proved on all of space\n"), "{answer}");
    // The length is 5 − sin 3 + sin ½, as for the straight line.
    assert!((5.0 - 3.0_f64.sin() + 0.5_f64.sin() - 5.338_305_531).abs() < 1e-9);
}

#[test]
fn a_tolerance_that_is_missed_is_said() {
    let folder = folder("tolerance");
    let file = "[metric]\nphi = \"2 - cos(x1)\"\n[from]\npoint = [0, 0]\n[to]\npoint = [3, 1]\n";
    fs::write(folder.join("steps.toml"), format!("{file}[solve]\nsteps = 0\n")).expect("written");
    fs::write(folder.join("good.toml"), file).expect("written");
    let missed = tautline(&folder, &["solve", "steps.toml", "--tolerance", "1e-6"]);
    assert_eq!(missed.status.code(), Some(1));
    let warning = "warning      the tolerance is not reached with 4096 chords\n";
    assert!(text(&missed.stdout).contains(warning), "{}", text(&missed.stdout));
    let kept = tautline(&folder, &["solve", "good.toml", "--tolerance", "1e-6"]);
    assert!(kept.status.success() && !text(&kept.stdout).contains("warning"));
}

#[test]
fn an_answer_is_one_json_document() {
    let folder = folder("json");
    for example in ["valleys", "two_channels", "counterexample"] {
        tautline(&folder, &["examples", example, "--to", "."]);
        let output =
            tautline(&folder, &["solve", &format!("{example}.toml"), "--json", "-n", "64"]);
        assert!(output.status.success());
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(answer["n"], 64);
        assert_eq!(answer["curve"].as_array().map(Vec::len), Some(65));
        let number = |bound: &str| answer["bounds"][bound]["value"].as_f64().expect("a bound");
        let length = answer["length"]["value"].as_f64().expect("a length");
        assert!(number("lower") < length && length <= number("upper"));
        let hex = answer["bounds"]["lower"]["hex"].as_str().expect("digits");
        assert!(hex.starts_with("0x1.") && hex.contains('p'), "{hex}");
    }
}

#[test]
fn a_problem_may_come_from_standard_input() {
    let folder = folder("input");
    let mut command = Command::new(env!("CARGO_BIN_EXE_tautline"))
        .args(["solve", "-", "--no-bounds"])
        .current_dir(&folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("started");
    command.stdin.take().expect("a pipe").write_all(EXAMPLES[0].text.as_bytes()).expect("written");
    let output = command.wait_with_output().expect("ended");
    assert!(output.status.success() && text(&output.stdout).starts_with("length       5.338"));
}

#[test]
fn pictures_are_written_in_three_formats() {
    let folder = folder("pictures");
    tautline(&folder, &["examples", "two_channels", "--to", "."]);
    let names = ["a.svg", "b.png", "c.pdf"];
    let plotted = tautline(&folder, &["plot", "two_channels.toml", names[0], names[1], names[2]]);
    assert!(plotted.status.success() && plotted.stderr.is_empty());
    let begins: [&[u8]; 3] = [b"<svg", b"\x89PNG", b"%PDF"];
    for (name, begin) in names.into_iter().zip(begins) {
        assert!(fs::read(folder.join(name)).expect(name).starts_with(begin), "{name}");
    }
    let solved = tautline(&folder, &["solve", "two_channels.toml", "--plot", "again.svg"]);
    assert!(solved.status.success());
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect(name);
    assert_eq!(read("a.svg"), read("again.svg"));
    // The other way is drawn, and named in the key.
    assert!(read("a.svg").contains("other local minimum"));
    let metric = tautline(&folder, &["plot", "two_channels.toml", "metric.svg", "--no-curve"]);
    assert!(metric.status.success() && !read("metric.svg").contains("other local minimum"));
    // Nothing else was left behind.
    let left = fs::read_dir(&folder).expect("a folder").count();
    assert_eq!(left, 6);
    let refused = tautline(&folder, &["plot", "two_channels.toml", "a.bmp"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("a.bmp: a picture ends in .svg, .png or .pdf"));
}

#[test]
fn a_picture_that_cannot_be_written_leaves_nothing() {
    let folder = folder("unwritten");
    tautline(&folder, &["examples", "valleys", "--to", "."]);
    let refused = tautline(&folder, &["plot", "valleys.toml", "none/a.svg"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("none/a.svg"));
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1);
}

#[test]
fn every_example_is_written_and_solved() {
    let folder = folder("examples");
    let list = text(&tautline(&folder, &["examples"]).stdout);
    assert!(tautline(&folder, &["examples", "--all", "--to", "."]).status.success());
    for example in EXAMPLES {
        let line = format!("{:<22}{}", example.name, example.question());
        assert!(list.lines().any(|listed| listed == line) && line.ends_with('?'), "{line}");
        let name = format!("{}.toml", example.name);
        assert_eq!(fs::read_to_string(folder.join(&name)).expect("written"), example.text);
        let output = tautline(&folder, &["solve", &name, "--no-bounds"]);
        assert!(output.status.success(), "{name}: {}", text(&output.stderr));
    }
    // An existing file is left as it is.
    let again = tautline(&folder, &["examples", "valleys", "--to", "."]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("exists already"));
    let unknown = tautline(&folder, &["examples", "vallys"]);
    assert_eq!(unknown.status.code(), Some(2));
}

#[test]
fn a_tie_and_a_longer_way_are_told() {
    let folder = folder("ties");
    for (example, says) in
        [("tie", "tie          another curve is as short"), ("two_channels", "other minima 7.529")]
    {
        tautline(&folder, &["examples", example, "--to", "."]);
        let output = tautline(&folder, &["solve", &format!("{example}.toml")]);
        assert!(text(&output.stdout).contains(says), "{}", text(&output.stdout));
    }
}

#[test]
fn constants_are_proved_or_it_is_said_why_not() {
    let folder = folder("constants");
    let file = |metric: &str, certify: &str| {
        let text = format!("dimension = 2\n[metric]\n{metric}\n{certify}");
        fs::write(folder.join("metric.toml"), text).expect("written");
        tautline(&folder, &["constants", "metric.toml", "--json"])
    };
    let proved = file("cost = \"2 - cos(x1)\"", "");
    assert_eq!(proved.status.code(), Some(0));
    let constants: serde_json::Value = serde_json::from_slice(&proved.stdout).expect("JSON");
    // The best constants of (2 − cos x₁)² I are 1, 9, 4.4037 and 6.
    for (i, best) in [1.0, 9.0, 4.403_669_6, 6.0].into_iter().enumerate() {
        let bound =
            |side: &str| constants["constants"][i][side]["value"].as_f64().expect("a bound");
        let (lower, upper) = (bound("lower"), bound("upper"));
        assert!(
            lower <= best && best <= upper && upper - lower <= 1.1e-3 * best,
            "{lower} {upper}"
        );
    }
    let unbounded = file("phi = \"1 + x1^2\"", "");
    assert_eq!(unbounded.status.code(), Some(1));
    assert!(text(&unbounded.stderr).contains("[certify]"));
    let within = "[certify]\nwithin = { box = { lower = [-1, -1], upper = [2, 1] } }";
    assert_eq!(file("phi = \"1 + x1^2\"", within).status.code(), Some(0));
    let indefinite = file("phi = \"0.5 + cos(x1)\"", "");
    assert_eq!(indefinite.status.code(), Some(1));
    assert!(text(&indefinite.stdout).contains("not positive definite at"));
    let many = "dimension = 13\n[metric]\nphi = 1";
    fs::write(folder.join("many.toml"), many).expect("written");
    let many = tautline(&folder, &["constants", "many.toml"]);
    assert!(many.status.code() == Some(1) && text(&many.stderr).contains("up to 12 dimensions"));
}

#[test]
fn a_time_limit_is_kept() {
    let folder = folder("limit");
    let file = EXAMPLES.iter().find(|example| example.name == "decoder").expect("an example").text;
    // The constants of this metric on a ball of this size take minutes.
    let slow = file.replace("[-2, -1]", "[-6, -3]").replace("[2, 1]", "[6, 3]");
    let slow = slow.replace("boxes = ", "boxes = 1000000000 #");
    fs::write(folder.join("slow.toml"), slow).expect("written");
    let start = Instant::now();
    let output = tautline(&folder, &["solve", "slow.toml", "--time-limit", "2", "--json"]);
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    // The curve is known, and the bounds are not.
    assert_eq!(output.status.code(), Some(1));
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(answer["length"]["value"].as_f64().is_some() && answer["bounds"].is_null());
    // The proof ended itself, with what it had.
    let reason = answer["no_bounds"].as_str().expect("a reason");
    assert!(reason.contains("c1 is known only to lie between"), "{reason}");
    let start = Instant::now();
    let output = tautline(&folder, &["constants", "slow.toml", "--time-limit", "1", "--json"]);
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    assert_eq!(output.status.code(), Some(1));
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let constants = answer["constants"].as_array().expect("constants");
    assert!(constants.iter().any(|constant| constant["upper"]["value"].as_f64().is_some()));
    let none =
        tautline(&folder, &["solve", "slow.toml", "-n", "10000000", "--time-limit", "0.001"]);
    assert_eq!(none.status.code(), Some(1));
    assert!(text(&none.stderr).contains("within the time limit"));
    let wrong = tautline(&folder, &["solve", "slow.toml", "--time-limit", "-1"]);
    assert_eq!(wrong.status.code(), Some(2));
}

/// `--time-limit` overrides the `time_limit` of the file, whether it is longer or shorter.
#[test]
fn the_option_takes_the_place_of_the_time_limit_of_a_file() {
    let folder = folder("limits");
    let file = |limit: f64| {
        let file =
            "[metric]\nphi = \"2 - cos(x1)\"\n[from]\npoint = [0, 0]\n[to]\npoint = [3, 1]\n";
        let file = format!("{file}[solve]\ntime_limit = {limit}\n");
        fs::write(folder.join("p.toml"), file).expect("written");
    };
    // With no time for a second level the gap is not reached.
    let certified = |more: &[&str]| {
        let arguments = [&["certify", "p.toml", "--gap", "1e-3"], more].concat();
        tautline(&folder, &arguments).status.code()
    };
    file(1e-6);
    assert_eq!(certified(&[]), Some(1));
    assert_eq!(certified(&["--time-limit", "100"]), Some(0));
    file(100.0);
    assert_eq!(certified(&[]), Some(0));
    assert_eq!(certified(&["--time-limit", "0.000001"]), Some(1));
    let solve = ["solve", "p.toml", "-n", "10000000", "--no-bounds", "--time-limit", "0.001"];
    let output = tautline(&folder, &solve);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("within the time limit"));
}

#[test]
fn bad_arguments_have_the_exit_code_2() {
    let folder = folder("arguments");
    tautline(&folder, &["examples", "valleys", "--to", "."]);
    for arguments in [
        &["solve"][..],
        &["solve", "nothing.toml"],
        &["solve", "valleys.toml", "-n", "0"],
        &["solve", "valleys.toml", "-n", "3", "--tolerance", "0.1"],
        &["solve", "valleys.toml", "--tolerance", "2"],
        &["solve", "valleys.toml", "--plot", "picture"],
        &["walk", "valleys.toml"],
    ] {
        let output = tautline(&folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", text(&output.stderr));
        assert!(!output.stderr.is_empty() && output.stdout.is_empty(), "{arguments:?}");
    }
}

#[test]
fn every_verb_has_an_example_in_its_help() {
    let folder = folder("help");
    let help = text(&tautline(&folder, &["--help"]).stdout);
    for verb in [
        "solve",
        "constants",
        "certify",
        "check",
        "audit",
        "plot",
        "plan",
        "run",
        "merge",
        "schema",
        "examples",
        "completions",
    ] {
        assert!(help.contains(&format!("\n  {verb}")), "{verb}");
        let own = text(&tautline(&folder, &[verb, "--help"]).stdout);
        assert!(own.contains(&format!("$ tautline {verb}")), "{own}");
    }
    for shell in ["bash", "fish", "zsh"] {
        let script = tautline(&folder, &["completions", shell]);
        assert!(script.status.success() && text(&script.stdout).contains("constants"), "{shell}");
    }
    for of in ["problem", "answer", "constants", "certified"] {
        let schema = tautline(&folder, &["schema", of]);
        let schema: serde_json::Value = serde_json::from_slice(&schema.stdout).expect("JSON");
        assert!(schema["$schema"].is_string(), "{of}");
    }
}

/// The problem, the commands, the answer and the picture of the first page are those of today.
/// `TAUTLINE_BLESS=1` copies the picture there.
#[test]
fn the_readme_shows_the_file_its_answer_and_its_picture() {
    let folder = folder("readme");
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let readme = fs::read_to_string(root.join("README.md")).expect("README.md");
    let block = |language: &str| {
        let rest = readme.split_once(&format!("```{language}\n")).expect(language).1;
        rest.split_once("```").expect("an end").0
    };
    assert!(EXAMPLES[0].text.ends_with(block("toml")), "{}", block("toml"));
    let mut lines = block("console").lines();
    for verb in ["examples valleys --to .", "solve valleys.toml --plot valleys.svg"] {
        assert_eq!(lines.next(), Some(format!("$ cargo tautline {verb}").as_str()));
        let output = tautline(&folder, &verb.split(' ').collect::<Vec<_>>());
        assert!(output.status.success());
        if verb.starts_with("solve") {
            assert_eq!(
                text(&output.stdout),
                lines.clone().map(|line| format!("{line}\n")).collect::<String>()
            );
        }
    }
    let (shown, drawn) = (root.join("docs/valleys.svg"), folder.join("valleys.svg"));
    assert!(readme.contains("](docs/valleys.svg)"));
    if std::env::var_os("TAUTLINE_BLESS").is_some() {
        fs::copy(&drawn, &shown).expect("copied");
    }
    assert_eq!(
        fs::read_to_string(shown).expect("a picture"),
        fs::read_to_string(drawn).expect("drawn")
    );
}

/// A ball so large that no box is small enough: the reason has few digits, and says what may help.
#[test]
fn missing_bounds_are_explained_in_few_digits() {
    let folder = folder("missing");
    // In five dimensions there is no certificate either.
    let file = "[metric]\ncost = \"exp(-(x1^2 + x2^2 + x3^2 + x4^2 + x5^2))\"\n[from]\n\
                point = [-1.5, 0, 0, 0, 0]\n[to]\npoint = [1.5, 0, 0, 0, 1]\n";
    std::fs::write(folder.join("decay.toml"), file).expect("written");
    let output = tautline(&folder, &["solve", "decay.toml"]);
    assert_eq!(output.status.code(), Some(1));
    let answer = text(&output.stdout);
    let first = answer.lines().next().expect("a line");
    assert!(first.contains("c1 is known only to lie between"), "{first}");
    assert!(first.ends_with(", or more `boxes` in [certify] may help"), "{first}");
    // Before the power of ten.
    let digits = |word: &str| {
        word.split('e').next().unwrap_or_default().chars().filter(char::is_ascii_digit).count()
    };
    assert!(first.split(' ').all(|word| digits(word) <= 5), "{first}");
}

/// A narrow wall of cost between the points of the rule: the answer says so, and is none.
#[test]
fn a_metric_that_the_chords_do_not_resolve_is_a_warning() {
    let folder = folder("unresolved");
    let file = "[metric]\ncost = \"1 + 1000*exp(-(1000*(x1 - 0.0031))^2)\"\n\
                [from]\npoint = [-2, 0]\n[to]\npoint = [2, 0]\n";
    std::fs::write(folder.join("wall.toml"), file).expect("written");
    let output = tautline(&folder, &["solve", "wall.toml", "--no-bounds"]);
    let answer = text(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{answer}");
    assert!(answer.contains("warning      the metric changes between"), "{answer}");
    assert!(!answer.contains("extrapolated"), "{answer}");
}

#[test]
fn a_picture_in_no_folder_is_refused_before_anything_is_computed() {
    let folder = folder("no-folder");
    tautline(&folder, &["examples", "valleys", "--to", "."]);
    let output = tautline(&folder, &["solve", "valleys.toml", "--plot", "nowhere/x.svg"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    assert_eq!(text(&output.stderr), "error: nowhere/x.svg: there is no folder nowhere\n");
}

/// As where both stand in a file: a search along a lattice has one grid.
#[test]
fn a_tolerance_besides_a_lattice_is_refused() {
    let folder = folder("lattice");
    let file = "[metric]\nphi = \"2 - cos(x1)\"\n[from]\npoint = [0, 0]\n[to]\npoint = [3, 1]\n\
                [solve]\nn = 64\nlattice = { lower = [-1, -1], upper = [4, 2], spacing = 0.5 }\n";
    fs::write(folder.join("lattice.toml"), file).expect("written");
    let refused = tautline(&folder, &["solve", "lattice.toml", "--tolerance", "1e-6"]);
    assert_eq!(refused.status.code(), Some(2));
    let said = text(&refused.stderr);
    assert!(said.contains("error: a lattice besides a tolerance"), "{said}");
    assert!(said.contains("lattice.toml:9:11") && said.contains("choose n"), "{said}");
    let solved = tautline(&folder, &["solve", "lattice.toml", "-n", "128"]);
    assert!(text(&solved.stdout).contains("of a curve of 128 chords"), "{solved:?}");
}
