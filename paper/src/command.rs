//! The commands `figures`, `tables` and `second-checker`.

#[cfg(feature = "tables")]
use std::path::Path;
use std::{env::consts, fs, thread, time::Instant};

#[cfg(feature = "tables")]
use crate::certificates::second_checker;
use crate::{
    Failure,
    artefact::{Artefact, Times},
    figures::FIGURES,
    output::Output,
    parallel,
    said::{print, say},
    sweep::Sweep,
};

const USAGE: &str = "\
usage: paper figures [ID …] [--check | --quick | --list]
       paper tables  [ID …] [--check | --quick | --list]
       paper second-checker PYTHON

  --check   recompute, and compare with what is committed
  --quick   fewer subintervals, written to target/quick
  --list    name what there is, and what it shows";

/// What to do with an artefact.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    Write,
    /// Write all but the measured times, if everything else is as before.
    Keep,
    Check,
    Quick,
    List,
}

/// Runs one command, given the arguments that follow the name of the program.
///
/// # Errors
///
/// If the arguments are wrong, a computation fails, an inequality is violated or a file differs.
pub fn run(arguments: impl IntoIterator<Item = String>) -> Result<(), Failure> {
    let mut arguments = lexopt::Parser::from_args(arguments);
    let usage = |reason: String| Failure::Usage(format!("{reason}\n\n{USAGE}"));
    let (mut kind, mut ids, mut mode) = (None, Vec::new(), Mode::Write);
    while let Some(argument) = arguments.next().map_err(|error| usage(error.to_string()))? {
        match argument {
            lexopt::Arg::Long("help") | lexopt::Arg::Short('h') => {
                return print(USAGE);
            }
            lexopt::Arg::Long(flag @ ("check" | "quick" | "list")) => {
                let asked = match flag {
                    "check" => Mode::Check,
                    "quick" => Mode::Quick,
                    _ => Mode::List,
                };
                if mode != Mode::Write && mode != asked {
                    return Err(usage("only one of --check, --quick and --list".to_owned()));
                }
                mode = asked;
            }
            lexopt::Arg::Value(value) => {
                let value = value.to_string_lossy().into_owned();
                if kind.is_none() { kind = Some(value) } else { ids.push(value) }
            }
            other => return Err(usage(other.unexpected().to_string())),
        }
    }
    let artefacts: &[Artefact] = match kind.as_deref() {
        Some("figures") => FIGURES,
        #[cfg(feature = "tables")]
        Some("tables") => crate::tables::TABLES,
        #[cfg(not(feature = "tables"))]
        Some("tables" | "second-checker") => {
            return Err(usage("compiled without the feature `tables`".to_owned()));
        }
        #[cfg(feature = "tables")]
        Some("second-checker") => match &ids[..] {
            [python] if mode == Mode::Write => return second_checker::run(Path::new(python)),
            _ => return Err(usage("second-checker needs one program, Python".to_owned())),
        },
        Some(other) => return Err(usage(format!("there is no command {other}"))),
        None => return Err(usage("figures or tables?".to_owned())),
    };
    if let Some(id) = ids.iter().find(|id| artefacts.iter().all(|a| a.id != id.as_str())) {
        let known: Vec<&str> = artefacts.iter().map(|a| a.id).collect();
        let kind = kind.as_deref().unwrap_or_default();
        return Err(usage(format!("no {id} among the {kind}: {}", known.join(", "))));
    }
    let chosen =
        artefacts.iter().filter(|a| ids.is_empty() || ids.iter().any(|id| id.as_str() == a.id));
    if mode == Mode::List {
        let mut lines = chosen.map(|artefact| format!("{:24} {}", artefact.id, artefact.shows));
        return lines.try_for_each(print);
    }
    let (unchecked, chosen): (Vec<&Artefact>, Vec<&Artefact>) =
        chosen.partition(|artefact| mode == Mode::Check && artefact.times == Times::Unchecked);
    for artefact in unchecked {
        say(format!("not checked: paper/{}, which contains times", artefact.data_file()));
    }
    // Whoever makes everything wants the times of before as long as all other numbers are the same, and
    // the tree unchanged. Who names an artefact wants new times.
    let keeps = |artefact: &Artefact| {
        mode == Mode::Write && ids.is_empty() && artefact.times == Times::Free
    };
    // Artefacts with measured times come last, one at a time, so that nothing else runs on the
    // machine. A check ignores the times.
    let (timed, others): (Vec<_>, Vec<_>) = chosen
        .into_iter()
        .partition(|artefact| mode != Mode::Check && artefact.times != Times::None);
    let results = parallel::map(&others, |&artefact| make_and_tell(artefact, mode));
    results.into_iter().collect::<Result<(), Failure>>()?;
    timed.into_iter().try_for_each(|artefact| {
        // What is not as it was is made anew, and that says why it cannot be made.
        let kept = keeps(artefact) && make_and_tell(artefact, Mode::Keep).is_ok();
        if kept { Ok(()) } else { make_and_tell(artefact, mode) }
    })
}

fn make_and_tell(artefact: &Artefact, mode: Mode) -> Result<(), Failure> {
    let begun = Instant::now();
    // It is printed at once, since others are still running and may fail as well.
    let files = make(artefact, mode).inspect_err(|failure| {
        if mode != Mode::Keep {
            say(format!("{}: {failure}", artefact.id));
        }
    })?;
    let (done, folder) = match mode {
        Mode::Check => ("checked", "paper"),
        Mode::Quick => ("wrote", "target/quick"),
        _ => ("wrote", "paper"),
    };
    let files: Vec<String> = files.iter().map(|file| format!("{folder}/{file}")).collect();
    let times = match mode {
        Mode::Keep => format!(", with the times of before; name {} to measure them", artefact.id),
        _ => String::new(),
    };
    say(format!("{done} {} in {:.1} s{times}", files.join(", "), begun.elapsed().as_secs_f64()));
    Ok(())
}

/// Returns the processor, the number of its cores that can be used, and the system.
fn machine() -> String {
    let processor = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = processor
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or(consts::ARCH, |(_, name)| name);
    let cores = thread::available_parallelism().map_or(1, usize::from);
    format!("{processor}, {cores} cores, {}; no flags for the processor", consts::OS)
}

/// Writes or checks the files of an artefact, and returns their names.
fn make(artefact: &Artefact, mode: Mode) -> Result<Vec<String>, Failure> {
    let quick = mode == Mode::Quick;
    let data = (artefact.data)(Sweep { quick, repeats: mode == Mode::Write })?;
    let (data_file, comment) = (artefact.data_file(), artefact.comment());
    let output = if quick { Output::quick() } else { Output::committed() };
    let check = mode == Mode::Check;
    let (printed, bytes) = if check || mode == Mode::Keep {
        let old = output.read(&data_file)?;
        let header: String = comment.lines().map(|line| format!("# {line}\n")).collect();
        if !old.starts_with(header.as_bytes()) {
            return Err(Failure::Differs(format!("{data_file}: the comment differs")));
        }
        let committed = data.read(&old)?;
        let within = |error| Failure::Differs(format!("{data_file}: {error}"));
        data.compare(&committed).map_err(within)?;
        (committed, old)
    } else {
        let machine = format!("{comment}\nmachine: {}", machine());
        let comment = if artefact.times == Times::Free { machine } else { comment };
        let bytes = data.to_csv(&comment)?;
        (data.read(&bytes)?, bytes)
    };
    // All files are made before any is written.
    let mut files = vec![(data_file, bytes)];
    files.extend(artefact.files(&printed)?);
    for (file, bytes) in &files {
        if check { output.compare(file, bytes) } else { output.write(file, bytes) }?;
    }
    Ok(files.into_iter().map(|(file, _)| file).collect())
}
