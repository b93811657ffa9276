//! The commands `figures` and `tables`.

use std::time::Instant;

use crate::{
    Failure, artefact::Artefact, figures::FIGURES, output::Output, parallel, sweep::Sweep,
};

const USAGE: &str = "\
usage: paper figures [ID …] [--check | --quick | --list]
       paper tables  [ID …] [--check | --quick | --list]

  --check   recompute, and compare with what is committed
  --quick   fewer subintervals, written to target/quick
  --list    name what there is, and what it shows";

/// What to do with an artefact.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    Write,
    Check,
    Quick,
    List,
}

/// Runs one command with the arguments after the name of the program.
///
/// # Errors
///
/// Bad arguments, a failed computation, a violated inequality or a difference.
pub fn run(arguments: impl IntoIterator<Item = String>) -> Result<(), Failure> {
    let mut arguments = lexopt::Parser::from_args(arguments);
    let usage = |reason: String| Failure::Usage(format!("{reason}\n\n{USAGE}"));
    let (mut kind, mut ids, mut mode) = (None, Vec::new(), Mode::Write);
    while let Some(argument) = arguments.next().map_err(|error| usage(error.to_string()))? {
        match argument {
            lexopt::Arg::Long("help") | lexopt::Arg::Short('h') => {
                println!("{USAGE}");
                return Ok(());
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
    let artefacts: Vec<&dyn Artefact> = match kind.as_deref() {
        Some("figures") => FIGURES.iter().map(|figure| figure as &dyn Artefact).collect(),
        #[cfg(feature = "tables")]
        Some("tables") => {
            crate::tables::TABLES.iter().map(|table| table as &dyn Artefact).collect()
        }
        #[cfg(not(feature = "tables"))]
        Some("tables") => return Err(usage("compiled without the feature `tables`".to_owned())),
        Some(other) => return Err(usage(format!("there is no command {other}"))),
        None => return Err(usage("figures or tables?".to_owned())),
    };
    if let Some(id) = ids.iter().find(|id| artefacts.iter().all(|a| a.id() != id.as_str())) {
        let known: Vec<&str> = artefacts.iter().map(|a| a.id()).collect();
        let kind = kind.as_deref().unwrap_or_default();
        return Err(usage(format!("none of the {kind} is called {id}: {}", known.join(", "))));
    }
    let chosen = artefacts.into_iter();
    let chosen = chosen.filter(|a| ids.is_empty() || ids.iter().any(|id| id == a.id()));
    if mode == Mode::List {
        chosen.for_each(|artefact| println!("{:24} {}", artefact.id(), artefact.shows()));
        return Ok(());
    }
    // Those with times in them by themselves, when all others are done.
    let (others, timed): (Vec<_>, Vec<_>) = chosen.partition(|artefact| artefact.repeatable());
    let results = parallel::map(&others, |&artefact| make_and_tell(artefact, mode));
    results.into_iter().collect::<Result<(), Failure>>()?;
    timed.into_iter().try_for_each(|artefact| {
        if mode == Mode::Check {
            eprintln!("not checked: paper/{}, which has times in it", artefact.data_file().0);
            return Ok(());
        }
        make_and_tell(artefact, mode)
    })
}

fn make_and_tell(artefact: &dyn Artefact, mode: Mode) -> Result<(), Failure> {
    let begun = Instant::now();
    // Said at once: others go on meanwhile, and may fail as well.
    make(artefact, mode).inspect_err(|failure| eprintln!("{}: {failure}", artefact.id()))?;
    let (file, _) = artefact.data_file();
    let done = match mode {
        Mode::Check => format!("checked paper/{file}"),
        Mode::Quick => format!("wrote target/quick/{file}"),
        _ => format!("wrote paper/{file}"),
    };
    eprintln!("{done} in {:.1} s", begun.elapsed().as_secs_f64());
    Ok(())
}

fn make(artefact: &dyn Artefact, mode: Mode) -> Result<(), Failure> {
    let quick = mode == Mode::Quick;
    let data = artefact.compute(Sweep { quick })?;
    let (data_file, command) = artefact.data_file();
    let id = artefact.id();
    let seed = artefact.seed();
    let version = env!("CARGO_PKG_VERSION");
    let comment = format!(
        "{id}\n{}\ncommand: cargo xtask {command} {id}\nversion: {version}\nseed: {seed}",
        artefact.shows()
    );
    let bytes = data.to_csv(&comment)?;
    let output = if quick { Output::quick() } else { Output::committed() };
    if mode == Mode::Check {
        let old = output.read(&data_file)?;
        let header: String = comment.lines().map(|line| format!("# {line}\n")).collect();
        if !old.starts_with(header.as_bytes()) {
            return Err(Failure::Differs(format!("{data_file}: its comment is another")));
        }
        let committed = data.read(&old)?;
        let within = |error| Failure::Differs(format!("{data_file}: {error}"));
        data.compare(&committed).map_err(within)?;
        for (file, bytes) in artefact.files(&committed)? {
            output.compare(&file, &bytes)?;
        }
        return Ok(());
    }
    // Everything is made before anything is written.
    let files = artefact.files(&data.read(&bytes)?)?;
    output.write(&data_file, &bytes)?;
    files.iter().try_for_each(|(file, bytes)| output.write(file, bytes))
}
