//! The verbs `certify` and `check`.

use std::{
    fs,
    time::{Duration, Instant},
};

use crate::{folder, tautline, text};

const VALLEYS: &str =
    "[metric]\ncost = \"2 - cos(x1)\"\n[from]\npoint = [0, 0]\n[to]\npoint = [3, 0]\n";

#[test]
fn a_certificate_is_written_and_checked() {
    let folder = folder("certify");
    fs::write(folder.join("v.toml"), VALLEYS).expect("written");
    let made = tautline(&folder, &["certify", "v.toml", "--gap", "1e-4", "-o", "v.cert", "--json"]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    let answer: serde_json::Value = serde_json::from_slice(&made.stdout).expect("JSON");
    let number = |name: &str| answer[name]["value"].as_f64().expect("a number");
    // ∫ (2 − cos x) dx from 0 to 3.
    let d = 6.0 - 3.0_f64.sin();
    assert!(number("lower") <= d && d <= number("upper") && number("gap") <= 1e-4);
    let checked = tautline(&folder, &["check", "v.cert"]);
    assert!(checked.status.success(), "{}", text(&checked.stderr));
    let verdict = text(&checked.stdout);
    assert!(verdict.contains("\nto point 3.0 0.0\n"), "{verdict}");
    // The decimal is rounded down.
    let lower = format!("lower bound  {:.17e}", number("lower").next_down());
    assert!(verdict.contains(&lower), "{lower} {verdict}");
}

#[test]
fn a_certificate_is_drawn_with_its_corridor() {
    let folder = folder("corridor");
    fs::write(folder.join("v.toml"), VALLEYS).expect("written");
    let made = tautline(&folder, &["certify", "v.toml", "--plot", "v.svg", "--plot", "v.png"]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    let picture = fs::read_to_string(folder.join("v.svg")).expect("drawn");
    assert!(picture.contains("in the corridor of all minimal geodesics"), "{picture}");
    assert!(fs::read(folder.join("v.png")).expect("drawn").starts_with(b"\x89PNG"));
    // Nothing is computed for a name that is no picture.
    let refused = tautline(&folder, &["certify", "v.toml", "-o", "v.cert", "--plot", "v.gif"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(!folder.join("v.cert").exists());
}

/// A value is a proposal; a changed one proves less, or nothing, but the file is read.
#[test]
fn a_certificate_that_is_no_proof_is_refused() {
    let folder = folder("refused");
    fs::write(folder.join("v.toml"), VALLEYS).expect("written");
    tautline(&folder, &["certify", "v.toml", "--gap", "1e-2", "-o", "v.cert"]);
    let certificate = fs::read_to_string(folder.join("v.cert")).expect("written");
    let cases = [
        ("a number", certificate.replacen("\nhi ", "\nhi x", 1), "hi BITS"),
        ("the end", certificate.replace("\nend\n", "\n"), "\"level\" or \"end\""),
        ("the levels", cut(&certificate, "level ") + "end\n", "no levels"),
        ("a problem file", VALLEYS.to_owned(), "line 1"),
    ];
    for (what, changed, reason) in cases {
        fs::write(folder.join("changed.cert"), changed).expect("written");
        let checked = tautline(&folder, &["check", "changed.cert"]);
        assert_eq!(checked.status.code(), Some(1), "{what}");
        assert!(text(&checked.stderr).contains(reason), "{what}: {}", text(&checked.stderr));
    }
    let missing = tautline(&folder, &["check", "missing.cert"]);
    assert_eq!(missing.status.code(), Some(2));
}

/// Returns the part before the first line that begins with this word.
fn cut(text: &str, word: &str) -> String {
    text.lines()
        .take_while(|line| !line.starts_with(word))
        .map(|line| format!("{line}\n"))
        .collect()
}

#[test]
fn what_cannot_be_certified_is_said() {
    let folder = folder("uncertified");
    fs::write(folder.join("v.toml"), VALLEYS).expect("written");
    let sphere =
        VALLEYS.replace("[to]\npoint = [3, 0]", "[to]\nsphere = { centre = [3, 0], radius = 1 }");
    fs::write(folder.join("sphere.toml"), sphere).expect("written");
    let five = VALLEYS.replace("[0, 0]", "[0, 0, 0, 0, 0]").replace("[3, 0]", "[3, 0, 0, 0, 0]");
    fs::write(folder.join("five.toml"), five).expect("written");
    let touching = VALLEYS.replace("[3, 0]", "[0, 0]");
    fs::write(folder.join("touching.toml"), touching).expect("written");
    let cases: [(&[&str], i32, &str); 5] = [
        (&["v.toml", "--gap", "0"], 2, "not between 0 and 1"),
        (&["sphere.toml"], 2, "the second set is no point"),
        (&["five.toml"], 1, "up to 4 dimensions, not 5"),
        (&["touching.toml", "-o", "t.cert"], 1, "t.cert: a distance of 0 has no certificate"),
        (&["v.toml", "-o", "-"], 2, "needs a file of its own"),
    ];
    for (arguments, code, reason) in cases {
        let output = tautline(&folder, &[&["certify"], arguments].concat());
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        assert!(text(&output.stderr).contains(reason), "{}", text(&output.stderr));
    }
}

#[test]
fn sets_that_touch_have_distance_0() {
    let folder = folder("touching");
    let ends = "[from]\npoint = [0, 0]\n[to]\npoint = [3, 0]\n";
    let cases = [
        ("point = [0.1, 0]", "point = [0.1, 0]"),
        ("point = [0, 0]", "ball = { centre = [0.1, 0], radius = 1 }"),
        ("ball = { centre = [0, 0], radius = 1 }", "ball = { centre = [0.5, 0], radius = 1 }"),
        ("ball = { centre = [0, 0], radius = 1 }", "ball = { centre = [2, 0], radius = 1 }"),
        ("point = [0, 0]", "half_space = { normal = [1, 1], at_least = -1 }"),
    ];
    for (from, to) in cases {
        let changed = VALLEYS.replace(ends, &format!("[from]\n{from}\n[to]\n{to}\n"));
        assert_ne!(changed, VALLEYS);
        fs::write(folder.join("t.toml"), changed).expect("written");
        let output = tautline(&folder, &["certify", "t.toml", "--plot", "t.svg"]);
        assert_eq!(text(&output.stdout), "distance    0: the sets have a common point\n");
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        // Nothing is proved, and there is no corridor.
        let picture = fs::read_to_string(folder.join("t.svg")).expect("drawn");
        assert!(!picture.contains("corridor") && picture.contains("<svg"), "{picture}");
    }
}

/// At a cost of 10¹⁵ a rounding of the ends is worth 0.444. Without a common point that is proved, the
/// distance is not said to be 0.
#[test]
fn sets_that_touch_up_to_rounding_have_a_bound() {
    let folder = folder("nearly-touching");
    let file = |cost: &str, centre: &str| {
        format!(
            "[metric]\ncost = \"{cost}\"\n[from]\nball = {{ centre = [0, 0], radius = 1 }}\n[to]\n\
             ball = {{ centre = [{centre}, 0], radius = 1 }}\n"
        )
    };
    let d = 0.5_f64.powi(51);
    for (cost, scale) in [("1e15 + 0*x1", 1e15), ("1", 1.0), ("2 - cos(x1)", 2.0 - 1_f64.cos())] {
        fs::write(folder.join("t.toml"), file(cost, "\"2 + 2^-51\"")).expect("written");
        let output = tautline(&folder, &["certify", "t.toml", "-o", "t.cert"]);
        assert_eq!(output.status.code(), Some(1), "{cost}");
        assert!(text(&output.stderr).contains("no certificate: the sets touch up to rounding"));
        assert!(!folder.join("t.cert").exists());
        let output = tautline(&folder, &["certify", "t.toml", "--json"]);
        assert_eq!(output.status.code(), Some(1), "{cost}");
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let upper = json["upper"]["value"].as_f64().expect("a number");
        assert_eq!((json["lower"]["value"].as_f64(), &json["reached"]), (Some(0.0), &false.into()));
        let d = d * scale * (1.0 - 1e-12);
        assert!(d <= upper && upper < 20.0 * d, "{cost}: {upper} for {d}");
        let output = tautline(&folder, &["solve", "t.toml"]);
        let answer = text(&output.stdout);
        assert!(answer.contains("the sets touch, up to rounding\n"), "{answer}");
        assert!(answer.contains("length       0 ± ") && !answer.contains("global"), "{answer}");
        assert!(answer.contains("one shorter by 100.00 % may exist"), "{answer}");
        let bounds = answer.lines().next().expect("a line");
        let upper: f64 = bounds.rsplit(' ').next().expect("a number").parse().expect(bounds);
        assert!(d <= upper && upper < 40.0 * d, "{cost}: {answer}");
        // Sets that do touch are said to.
        fs::write(folder.join("t.toml"), file(cost, "2")).expect("written");
        let output = tautline(&folder, &["certify", "t.toml"]);
        assert_eq!(output.status.code(), Some(0), "{cost}");
        assert_eq!(text(&output.stdout), "distance    0: the sets have a common point\n");
        let answer = text(&tautline(&folder, &["solve", "t.toml"]).stdout);
        assert!(answer.contains("the sets touch\n"), "{answer}");
        assert!(answer.starts_with("distance     between 0 and 0\n"), "{answer}");
    }
}

#[cfg(unix)]
#[test]
fn a_certificate_is_written_through_a_symbolic_link() {
    let folder = folder("link");
    fs::write(folder.join("v.toml"), VALLEYS).expect("written");
    fs::write(folder.join("real.cert"), "before").expect("written");
    std::os::unix::fs::symlink("real.cert", folder.join("link.cert")).expect("linked");
    let output = tautline(&folder, &["certify", "v.toml", "--gap", "0.1", "-o", "link.cert"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let written = fs::read_to_string(folder.join("real.cert")).expect("read");
    assert!(written.starts_with("tautline-distance 1\n"));
    assert!(fs::symlink_metadata(folder.join("link.cert")).expect("there").is_symlink());
}

/// What is proved by then is printed.
#[test]
fn certify_keeps_a_time_limit() {
    let folder = folder("time");
    let hill = VALLEYS.replace("2 - cos(x1)", "1 + 4*exp(-2*((x1 - 1.5)^2 + x2^2))");
    fs::write(folder.join("hill.toml"), hill).expect("written");
    let start = Instant::now();
    let arguments = ["certify", "hill.toml", "--gap", "1e-9", "--time-limit", "6"];
    let output = tautline(&folder, &arguments);
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
    assert_eq!(output.status.code(), Some(1));
    let answer = text(&output.stdout);
    assert!(answer.starts_with("distance    between "), "{answer} {}", text(&output.stderr));
}

/// What was not checked in the time is neither proved nor refused.
#[test]
fn check_keeps_a_time_limit() {
    let folder = folder("check-time");
    fs::write(folder.join("v.toml"), VALLEYS).expect("written");
    tautline(&folder, &["certify", "v.toml", "--gap", "1e-2", "-o", "v.cert"]);
    let checked = |limit: &str| {
        let output = tautline(&folder, &["check", "v.cert", "--time-limit", limit]);
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    };
    let (code, proved, said) = checked("1e-9");
    assert_eq!((code, proved.as_str()), (Some(2), ""));
    assert!(said.contains("not checked in the time: stopped after 0 of "), "{said}");
    let (code, proved, said) = checked("600");
    assert_eq!((code, said.as_str()), (Some(0), ""));
    assert!(proved.contains("\nlower bound "), "{proved}");
    assert_eq!(checked("-1").0, Some(2));
}
