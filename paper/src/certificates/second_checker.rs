//! Compares the two checkers of certificates, on the certificates of the gallery, on the same with one
//! number changed, and on certificates by chance.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
    time::Instant,
};

use tautline::check::AnyCertificate;

use crate::{
    Failure,
    data::{Data, Tolerance},
    output::Output,
    said::say,
};

use super::{CHANGES, Pair, Search, pairs};

const FILE: &str = "tables/second_checker.csv";

const COMMENT: &str = "second_checker\n\
    what the checker in Rust and the second one in Python say of the certificates of \
    certified_distances, and of the same with one number changed; the two lower bounds, the cubes that \
    the last level keeps, and the seconds of the second checker, with the start of Python\n\
    command: cargo xtask second-checker";

/// The relative difference of two lower bounds. Each is rounded in its own way.
const AGREEMENT: f64 = 1e-12;

/// The seed and the number of the certificates by chance, of which every second one is changed: through
/// pockets where the metric is indefinite, over poles and knots, from unions to points of a boundary, in
/// one to four dimensions. They take about a minute.
const CHANCE: [&str; 2] = ["1", "120"];

/// What a checker says: the lower bound and the cubes kept by the last level, or nothing if it refuses.
type Verdict = Option<(f64, usize)>;

/// Runs `python` on all certificates, and writes the table.
///
/// # Errors
///
/// If Python does not start, or if the checkers disagree: one refuses what the other accepts, their
/// bounds differ by more than rounding, they keep different cubes, an unchanged certificate is refused,
/// or a changed one proves more than the length of the curve. The same for certificates by chance, if
/// anything false is accepted of them.
pub(crate) fn run(python: &Path) -> Result<(), Failure> {
    let folder = std::env::temp_dir().join(format!("tautline-second-{}", std::process::id()));
    let unwritten = |source| Failure::File { path: folder.clone(), source };
    fs::create_dir_all(&folder).map_err(unwritten)?;
    let table =
        campaign(python, &folder).and_then(|()| compare(python, &folder.join("certificate")));
    fs::remove_dir_all(&folder).map_err(unwritten)?;
    Output::committed().write(FILE, &table?.to_csv(COMMENT)?)?;
    say(format!("wrote paper/{FILE}"));
    Ok(())
}

/// Lets the second checker make certificates by chance, and compares what the two say of them.
fn campaign(python: &Path, folder: &Path) -> Result<(), Failure> {
    let unread = |source| Failure::File { path: folder.to_owned(), source };
    let output = Command::new(python)
        .arg(second_folder().join("campaign.py"))
        .arg(folder)
        .args(CHANCE)
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()
        .map_err(|source| Failure::File { path: python.to_owned(), source })?;
    let said = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() {
        return Err(Failure::Violated(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    let mut differences = Vec::new();
    for line in said.lines() {
        // `7 accepted 0.438 11 1-D declared …` or `8 refused …`.
        let words: Vec<&str> = line.split(' ').collect();
        let second: Verdict = match words[..] {
            [_, "refused", ..] => None,
            [_, "accepted", lower, kept, ..] => lower.parse().ok().zip(kept.parse().ok()),
            _ => return Err(Failure::Data(format!("the campaign says {line:?}"))),
        };
        let text = fs::read_to_string(folder.join(format!("{}.cert", words[0]))).map_err(unread)?;
        let first = first(&text);
        if !agree(first, second) {
            differences.push(format!("{first:?}, second checker: {line}"));
        }
    }
    let (count, differ) = (said.lines().count(), differences.len());
    say(format!("{count} certificates by chance, {differ} differences"));
    if differences.is_empty() { Ok(()) } else { Err(Failure::Violated(differences.join("\n"))) }
}

/// Returns the folder of the second checker.
fn second_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../crates/library/tautline-check/second")
}

fn compare(python: &Path, file: &Path) -> Result<Data, Failure> {
    let mut data = Data::new(&[(
        "metric d changed verdict lower kept second_verdict second_lower second_kept second_seconds",
        Tolerance::Free,
    )]);
    let mut differences = Vec::new();
    for pair in pairs()? {
        let Pair { metric, d, known, .. } = &pair;
        let found = match pair.search()? {
            Ok(found) => found,
            Err(error) => {
                say(format!("{metric}, D = {d}: no certificate: {error}"));
                continue;
            }
        };
        let Search { text, changed, verdict, .. } = &found;
        let most = known.or(verdict.upper).unwrap_or(f64::INFINITY);
        let texts = [("nothing", text)].into_iter().chain(CHANGES.into_iter().zip(changed));
        for (change, text) in texts {
            let first = first(text);
            fs::write(file, text)
                .map_err(|source| Failure::File { path: file.to_owned(), source })?;
            let begun = Instant::now();
            let second = second(python, file)?;
            let seconds = begun.elapsed().as_secs_f64();
            let name = format!("{metric}, D = {d}, {change} changed");
            say(format!("{name}: {first:?} {second:?} in {seconds:.1} s"));
            let is_wrong = |verdict: Verdict| match verdict {
                None => change == "nothing",
                Some((lower, _)) => !(lower <= most * (1.0 + AGREEMENT)),
            };
            if !agree(first, second) || is_wrong(first) || is_wrong(second) {
                differences.push(format!("{name}: {first:?}, second checker {second:?}"));
            }
            let mut row = vec![(*metric).to_owned(), d.to_string(), change.to_owned()];
            row.extend([first, second].into_iter().flat_map(cells));
            row.push(format!("{seconds:.1}"));
            data.push(row);
        }
    }
    if differences.is_empty() { Ok(data) } else { Err(Failure::Violated(differences.join("\n"))) }
}

fn agree(first: Verdict, second: Verdict) -> bool {
    match (first, second) {
        (Some((a, kept)), Some((b, as_many))) => {
            kept == as_many && (a - b).abs() <= AGREEMENT * a.max(b)
        }
        _ => first.is_none() && second.is_none(),
    }
}

fn cells(verdict: Verdict) -> [String; 3] {
    verdict.map_or(["refused".to_owned(), String::new(), String::new()], |(lower, kept)| {
        ["accepted".to_owned(), lower.to_string(), kept.to_string()]
    })
}

/// Returns the verdict of the checker in Rust.
fn first(text: &str) -> Verdict {
    let verdict = AnyCertificate::read(text).and_then(|certificate| certificate.check());
    verdict.ok().map(|verdict| (verdict.lower, verdict.corridor.0))
}

/// Returns the verdict of the checker in Python.
fn second(python: &Path, file: &Path) -> Result<Verdict, Failure> {
    let output = Command::new(python)
        .arg(second_folder().join("check.py"))
        .arg(file)
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()
        .map_err(|source| Failure::File { path: python.to_owned(), source })?;
    let (said, error) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if output.status.code() == Some(1) && error.starts_with("refused: ") {
        return Ok(None);
    }
    let read = || {
        // `level 3 of 5: 96 cubes, 40 kept, lower bound …` for each level, and `lower …`.
        let lower = said.lines().find_map(|line| line.strip_prefix("lower "))?.parse().ok()?;
        let level = said.lines().rfind(|line| line.starts_with("level "))?;
        let kept = level.split(", ").find_map(|part| part.strip_suffix(" kept"))?.parse().ok()?;
        Some((lower, kept))
    };
    match read() {
        Some(verdict) if output.status.success() => Ok(Some(verdict)),
        _ => Err(Failure::Data(format!("the second checker does not answer: {error}"))),
    }
}
