//! Changed files: what the format does not name is refused.

use tautline_check::{AnyCertificate, CheckError};

use super::BASE;

fn lines() -> Vec<String> {
    BASE.certificate.to_string().lines().map(str::to_owned).collect()
}

/// Returns the first line that begins with this word.
fn first(lines: &[String], word: &str) -> usize {
    lines.iter().position(|line| line.split(' ').next() == Some(word)).expect(word)
}

fn read(lines: &[String]) -> Result<AnyCertificate, CheckError> {
    AnyCertificate::read(&(lines.join("\n") + "\n"))
}

/// Asserts that the file is refused at this line, counted from 0.
fn assert_refused_at(lines: &[String], at: usize) {
    match read(lines) {
        Err(CheckError::Line { line, .. }) => assert_eq!(line, at + 1, "{}", lines[at]),
        other => panic!("line {at}, {}: {:?}", lines[at], other.map(|_| "read")),
    }
}

#[test]
fn a_file_is_read_as_it_was_written() {
    let read = read(&lines()).expect("a certificate");
    assert_eq!(read, AnyCertificate::Plane(BASE.certificate.clone()));
}

/// Nothing that is proved can be supplied.
#[test]
fn lines_that_the_format_does_not_name_are_refused() {
    let bits = "3ff0000000000000";
    for name in ["hi", "curvature", "m", "epsilon", "q", "f", "table", "lower", "keep", "mu"] {
        let line = format!("{name} {bits}");
        let lines = lines();
        let (level, end) = (first(&lines, "level"), lines.len() - 1);
        for at in [1, 2, first(&lines, "region") + 1, level, level + 1, end] {
            // The first line of a set or of the region may say what is wrong one line later.
            let mut lines = lines.clone();
            lines.insert(at, line.clone());
            let refused = read(&lines).map(|_| ());
            assert!(matches!(refused, Err(CheckError::Line { .. })), "{at} {name}: {refused:?}");
        }
    }
    let mut lines = lines();
    lines.push(String::new());
    lines.push("lower 3ff0000000000000".to_owned());
    assert!(read(&lines).is_err());
}

#[test]
fn lines_end_with_a_line_feed_and_nothing_else() {
    let text = BASE.certificate.to_string();
    for changed in [text.replace('\n', "\r\n"), text.trim_end().to_owned(), text.clone() + "\n"] {
        let refused = AnyCertificate::read(&changed).map(|_| ());
        assert!(matches!(refused, Err(CheckError::Line { .. })), "{refused:?}");
    }
}

#[test]
fn bits_of_no_number_are_refused() {
    for bits in ["7ff8000000000000", "7ff0000000000000", "fff0000000000000"] {
        let mut lines = lines();
        let at = lines.len() - 2;
        lines[at].replace_range(..16, bits);
        let refused = read(&lines).map(|_| ());
        assert!(matches!(refused, Err(CheckError::NotFinite { level: 3, .. })), "{refused:?}");
        let mut lines = self::lines();
        let from = first(&lines, "from");
        lines[from].replace_range(11..27, bits);
        assert_refused_at(&lines, from);
        let hi = first(&lines, "hi");
        let mut lines = self::lines();
        lines[hi].replace_range(3.., bits);
        let Ok(AnyCertificate::Plane(certificate)) = read(&lines) else { panic!("a file") };
        let checked = certificate.check();
        assert!(matches!(checked, Err(CheckError::Bound { .. })), "{checked:?}");
    }
}

/// The count of nodes follows from the cubes.
#[test]
fn a_missing_line_of_values_is_refused() {
    let lines = lines();
    let mut missing = lines.clone();
    missing.remove(lines.len() - 2);
    let refused = read(&missing).map(|_| ());
    assert!(matches!(refused, Err(CheckError::Line { .. })), "{refused:?}");
    // With the count changed too, it contradicts the cubes.
    let last = lines.iter().rposition(|line| line.starts_with("level")).expect("a level");
    let nodes = BASE.certificate.levels[3].nodes().len();
    missing[last] = missing[last].replace(&nodes.to_string(), &(nodes - 1).to_string());
    let refused = read(&missing).map(|_| ());
    assert!(matches!(refused, Err(CheckError::Values { level: 3, .. })), "{refused:?}");
}

/// A node has one line with two numbers.
#[test]
fn a_third_number_of_a_node_is_refused() {
    let mut lines = lines();
    let at = lines.len() - 2;
    lines[at].push_str(" 3ff0000000000000");
    assert_refused_at(&lines, at);
    lines[at].truncate(16);
    assert_refused_at(&lines, at);
}

/// Exponents and places are integers, written in one way.
#[test]
fn exponents_and_places_that_are_no_integers_are_refused() {
    let lines = lines();
    let level = first(&lines, "level");
    for exponent in ["-4.0", "-4.0000001", "+4", "-04", "4e0", "", "99999999999"] {
        let mut lines = lines.clone();
        lines[level] = lines[level].replacen("-4", exponent, 1);
        assert_refused_at(&lines, level);
    }
    let run = level + 1;
    let words: Vec<&str> = lines[run].split(' ').collect();
    for place in ["0.5", "-0", "1e2", "2147483648", "x", ""] {
        let mut lines = lines.clone();
        lines[run] = [place, words[1], words[2]].join(" ");
        assert_refused_at(&lines, run);
    }
    // Runs that are empty, too long, or not in order.
    for length in ["0", "-1", "2147483647"] {
        let mut lines = lines.clone();
        lines[run] = [words[0], words[1], length].join(" ");
        assert_refused_at(&lines, run);
    }
    let mut swapped = lines.clone();
    swapped.swap(run, run + 1);
    assert_refused_at(&swapped, run + 1);
    let mut twice = lines.clone();
    twice[run + 1] = twice[run].clone();
    assert_refused_at(&twice, run + 1);
}

#[test]
fn decimal_numbers_are_refused() {
    let lines = lines();
    let (hi, region, row) = (first(&lines, "hi"), first(&lines, "region"), lines.len() - 2);
    for decimal in ["0.5", "1", "1.0000000000000", "3FF0000000000000", "+ff0000000000000"] {
        let with = |at: usize, line: String| {
            let mut lines = lines.clone();
            lines[at] = line;
            assert_refused_at(&lines, at);
        };
        with(hi, format!("hi {decimal}"));
        with(region, format!("region declared {decimal}"));
        with(row, format!("{decimal} {decimal}"));
    }
}

#[test]
fn another_dimension_is_refused() {
    for dimension in ["1", "3", "4"] {
        let mut lines = lines();
        lines[1] = format!("dimension {dimension}");
        let refused = read(&lines).map(|_| ());
        assert!(matches!(refused, Err(CheckError::Line { .. })), "{dimension}: {refused:?}");
    }
    for dimension in [0, 5, 12] {
        let mut lines = lines();
        lines[1] = format!("dimension {dimension}");
        assert_eq!(read(&lines).map(|_| ()), Err(CheckError::Dimension { dimension }));
    }
}

/// A file that ends early or lost a line is refused or proves something true; none panics.
#[test]
fn truncated_files_do_not_panic() {
    let lines = lines();
    for count in (0..lines.len()).step_by(97).chain(0..40) {
        assert!(read(&lines[..count]).is_err());
    }
    let mut random = tautline_chance::Random(tautline_chance::seed(7));
    for _ in 0..tautline_chance::cases(200) {
        let mut lines = lines.clone();
        // Half of the changes in the head of the file.
        let range = if random.unit() < 0.5 { 60.0 } else { lines.len() as f64 };
        let at = (random.unit() * range) as usize;
        let old = lines[at].clone();
        let cut = (random.unit() * (old.len() + 1) as f64) as usize;
        match (random.unit() * 4.0) as usize {
            0 => lines[at].truncate(cut),
            1 => drop(lines.remove(at)),
            2 => lines.insert(at, old),
            _ => {
                let letter = b"0123456789abcdef -.x\t"[(random.unit() * 21.0) as usize] as char;
                lines[at].insert(cut, letter);
            }
        }
        let _ = read(&lines);
    }
}
