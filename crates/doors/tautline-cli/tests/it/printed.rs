//! Printed bounds, as exact decimals, against the doubles that are printed as JSON.

use std::{cmp::Ordering, fs};

use serde_json::Value;
use tautline_problem::EXAMPLES;

use crate::{
    exact_decimal::{compare, exact},
    folder, tautline, text,
};

/// Reads a number such as `0x1.8p+1`, which the value in decimals may miss.
fn double(number: &Value) -> f64 {
    let hex = number["hex"].as_str().expect("a number");
    let (sign, digits) = hex.strip_prefix('-').map_or((1.0, hex), |rest| (-1.0, rest));
    let (digits, power) = digits.strip_prefix("0x").expect(hex).split_once('p').expect(hex);
    let (whole, rest) = digits.split_once('.').unwrap_or((digits, ""));
    let mantissa = u64::from_str_radix(&format!("{whole}{rest}"), 16).expect(hex) as f64;
    let power: i32 = power.parse().expect(hex);
    sign * mantissa * 2.0_f64.powi(power - 4 * rest.len() as i32)
}

/// Fails unless the decimal is at most the double.
#[track_caller]
fn is_below(printed: &str, bound: f64) {
    assert_ne!(compare(printed, &exact(bound)), Ordering::Greater, "{printed} for {bound:e}");
}

/// Fails unless the decimal is at least the double.
#[track_caller]
fn is_above(printed: &str, bound: f64) {
    assert_ne!(compare(printed, &exact(bound)), Ordering::Less, "{printed} for {bound:e}");
}

/// Returns the word after another one.
fn after<'t>(line: &'t str, word: &str) -> &'t str {
    let rest = line.split_once(word).unwrap_or_else(|| panic!("no {word} in {line}")).1;
    rest.trim_start().split([' ', ',', ';', '\n']).next().unwrap_or_default()
}

fn json(folder: &std::path::Path, arguments: &[&str]) -> Value {
    let output = tautline(folder, &[arguments, &["--json"]].concat());
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// Metrics whose constants and distances are decimals that are no doubles.
const FILES: [&str; 5] = [
    "[metric]\nphi = 0.1\n[from]\npoint = [0]\n[to]\npoint = [1]\n",
    "[metric]\nphi = 0.3\n[from]\npoint = [0.1]\n[to]\npoint = [0.7]\n",
    "[metric]\ncost = \"1.1 + 0.3*sin(x1)\"\n[from]\npoint = [0, 0.1]\n[to]\npoint = [0.3, 0.2]\n",
    "[metric]\nupper = [[1.3765694235720005, -1.228736383105909], [5.009335343392577]]\n[from]\n\
     point = [0.21120429684220876, -0.27521418310059076]\n[to]\n\
     point = [-0.7122678663241142, -0.423956465987569]\n[solve]\nn = 1\n",
    "[metric]\nphi = \"4/(1 + x1^2 + x2^2)^2\"\n[from]\npoint = [0.31, 0.1]\n[to]\n\
     point = [0.45, 0.2]\n[certify]\nwithin = { ball = { centre = [0.1, 0], radius = 1.1 } }\n",
];

#[test]
fn every_printed_bound_is_on_the_right_side_of_the_number() {
    let folder = folder("printed");
    let examples = EXAMPLES.iter().filter(|example| {
        ["valleys", "two_channels", "sets", "counterexample"].contains(&example.name)
    });
    for file in FILES.into_iter().chain(examples.map(|example| example.text)) {
        fs::write(folder.join("p.toml"), file).expect("written");
        let answer = json(&folder, &["solve", "p.toml"]);
        let printed = text(&tautline(&folder, &["solve", "p.toml"]).stdout);
        let bounds = &answer["bounds"];
        let first = printed.lines().next().expect("a line");
        is_below(after(first, "between"), double(&bounds["lower"]));
        is_above(after(first, "and"), double(&bounds["upper"]));
        let constants = printed.lines().find(|line| line.starts_with("constants")).expect("a line");
        let number = |name: &str| bounds["constants"][name].as_f64().expect(name);
        is_below(after(constants, "c1"), number("c1"));
        is_above(after(constants, "c2"), number("c2"));
        is_above(after(constants, "L_H"), number("l_h"));
        if let Some(m_h) = bounds["constants"]["m_h"].as_f64() {
            is_above(after(constants, "M_H"), m_h);
        }
        if let Some(radius) = bounds["constants"]["within"]["radius"].as_f64() {
            // The printed ball lies in the one that was proved.
            let within = after(constants, "within");
            is_below(within, radius);
            let centre = constants.split_once(['[', ']']).expect("a centre").1;
            let centre =
                centre.trim_end_matches(']').split(", ").map(|x| x.parse::<f64>().expect(x));
            let proved = bounds["constants"]["within"]["centre"].as_array().expect("a centre");
            let moved: f64 = centre
                .zip(proved)
                .map(|(a, b)| (a - b.as_f64().expect("a number")).powi(2))
                .sum::<f64>()
                .sqrt();
            let printed: f64 = within.parse().expect("a number");
            assert!(printed + moved <= radius * (1.0 + 1e-15), "{constants}");
        }
        let answer = json(&folder, &["constants", "p.toml"]);
        let printed = text(&tautline(&folder, &["constants", "p.toml"]).stdout);
        for constant in answer["constants"].as_array().expect("constants") {
            let name = constant["name"].as_str().expect("a name");
            let line = printed.lines().find(|line| line.starts_with(name)).expect(name);
            if line.contains("between") {
                is_below(after(line, "between"), double(&constant["lower"]));
                is_above(after(line, " and"), double(&constant["upper"]));
            }
        }
        let certify = ["certify", "p.toml", "--gap", "0.05"];
        let printed = text(&tautline(&folder, &certify).stdout);
        // A segment cannot be written into a certificate.
        if printed.is_empty() {
            assert!(file.contains("segment"), "{file}");
            continue;
        }
        let answer = json(&folder, &certify);
        let first = printed.lines().next().expect("a line");
        is_below(after(first, "between"), double(&answer["lower"]));
        is_above(after(first, "and"), double(&answer["upper"]));
        is_above(after(&printed, "gap"), double(&answer["gap"]));
    }
}

/// The double 0.1 is above the decimal, so that no decimal of ten digits is equal to a bound by it.
#[test]
fn a_constant_of_a_tenth_is_printed_rounded_outward() {
    let folder = folder("tenth");
    fs::write(folder.join("p.toml"), FILES[0]).expect("written");
    let printed = text(&tautline(&folder, &["constants", "p.toml"]).stdout);
    assert!(printed.contains("c1   between 0.1000000000 and 0.1000000001 "), "{printed}");
    assert!(printed.contains("c2   between 0.1000000000 and 0.1000000001 "), "{printed}");
    let printed = text(&tautline(&folder, &["solve", "p.toml"]).stdout);
    assert!(printed.contains("c1 0.1, c2 0.10001, L_H 0, M_H 0; proved"), "{printed}");
}
