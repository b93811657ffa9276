//! The commands `figures` and `tables`.

use std::time::Instant;

use crate::{
    Failure,
    data::Data,
    drawing::{pdf, png, svg},
    figures::{FIGURES, Figure},
    output::Output,
    parallel,
    sweep::Sweep,
    tables::{Seed, TABLES, Table},
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
    let artefacts: Vec<Artefact> = match kind.as_deref() {
        Some("figures") => FIGURES.into_iter().map(Artefact::Figure).collect(),
        Some("tables") => TABLES.into_iter().map(Artefact::Table).collect(),
        Some(other) => return Err(usage(format!("there is no command {other}"))),
        None => return Err(usage("figures or tables?".to_owned())),
    };
    if let Some(id) = ids.iter().find(|id| artefacts.iter().all(|a| a.id() != id.as_str())) {
        let known: Vec<&str> = artefacts.iter().map(Artefact::id).collect();
        let kind = kind.as_deref().unwrap_or_default();
        return Err(usage(format!("none of the {kind} is called {id}: {}", known.join(", "))));
    }
    let chosen = artefacts.iter().filter(|a| ids.is_empty() || ids.iter().any(|id| id == a.id()));
    if mode == Mode::List {
        chosen.for_each(|artefact| println!("{:24} {}", artefact.id(), artefact.shows()));
        return Ok(());
    }
    // Those with times in them by themselves, when all others are done.
    let (others, timed): (Vec<_>, Vec<_>) = chosen.partition(|artefact| artefact.repeatable());
    let results = parallel::map(&others, |artefact| artefact.make_and_tell(mode));
    results.into_iter().collect::<Result<(), Failure>>()?;
    timed.into_iter().try_for_each(|artefact| {
        if mode == Mode::Check {
            eprintln!("not checked: paper/{}, which has times in it", artefact.data_file().0);
            return Ok(());
        }
        artefact.make_and_tell(mode)
    })
}

/// A figure or a table.
enum Artefact {
    Figure(Figure),
    Table(Table),
}

impl Artefact {
    fn id(&self) -> &'static str {
        match self {
            Artefact::Figure(figure) => figure.id,
            Artefact::Table(table) => table.id,
        }
    }

    fn shows(&self) -> &'static str {
        match self {
            Artefact::Figure(figure) => figure.shows,
            Artefact::Table(table) => table.shows,
        }
    }

    /// The data file, and the command that makes it.
    fn data_file(&self) -> (String, &'static str) {
        match self {
            Artefact::Figure(figure) => (format!("data/{}.csv", figure.id), "figures"),
            Artefact::Table(table) => (format!("tables/{}.csv", table.id), "tables"),
        }
    }

    /// Whether it comes out the same a second time.
    fn repeatable(&self) -> bool {
        match self {
            Artefact::Figure(_) => true,
            Artefact::Table(table) => table.repeatable,
        }
    }

    /// Where its random numbers come from.
    fn seed(&self) -> Seed {
        match self {
            Artefact::Figure(_) => Seed::None,
            Artefact::Table(table) => table.seed,
        }
    }

    fn compute(&self, sweep: Sweep) -> Result<Data, Failure> {
        match self {
            Artefact::Figure(figure) => (figure.data)(sweep),
            Artefact::Table(table) => (table.data)(sweep),
        }
    }

    /// The other files, made from the data as they are printed.
    fn files(&self, data: &Data) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        match self {
            Artefact::Figure(figure) => {
                let scene = (figure.draw)(data)?;
                let file = |ending: &str| format!("figures/{}.{ending}", figure.id);
                Ok(vec![
                    (file("svg"), svg(&scene)),
                    (file("png"), png(&scene)?),
                    (file("pdf"), pdf(&scene)),
                ])
            }
            Artefact::Table(table) => {
                let layout = (table.layout)(data)?;
                let file = |ending: &str| format!("tables/{}.{ending}", table.id);
                let mut files = vec![
                    (file("md"), layout.markdown().into_bytes()),
                    (file("tex"), layout.latex().into_bytes()),
                ];
                let pages = (table.pages)(data).into_iter();
                files.extend(pages.map(|(name, text)| (name.to_owned(), text.into_bytes())));
                Ok(files)
            }
        }
    }

    fn make_and_tell(&self, mode: Mode) -> Result<(), Failure> {
        let begun = Instant::now();
        // Said at once: others go on meanwhile, and may fail as well.
        self.make(mode).inspect_err(|failure| eprintln!("{}: {failure}", self.id()))?;
        let (file, _) = self.data_file();
        let done = match mode {
            Mode::Check => format!("checked paper/{file}"),
            Mode::Quick => format!("wrote target/quick/{file}"),
            _ => format!("wrote paper/{file}"),
        };
        eprintln!("{done} in {:.1} s", begun.elapsed().as_secs_f64());
        Ok(())
    }

    fn make(&self, mode: Mode) -> Result<(), Failure> {
        let quick = mode == Mode::Quick;
        let data = self.compute(Sweep { quick })?;
        let (data_file, command) = self.data_file();
        let id = self.id();
        let seed = self.seed();
        let version = env!("CARGO_PKG_VERSION");
        let comment = format!(
            "{id}\n{}\ncommand: cargo xtask {command} {id}\nversion: {version}\nseed: {seed}",
            self.shows()
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
            for (file, bytes) in self.files(&committed)? {
                output.compare(&file, &bytes)?;
            }
            return Ok(());
        }
        // Everything is made before anything is written.
        let files = self.files(&data.read(&bytes)?)?;
        output.write(&data_file, &bytes)?;
        files.iter().try_for_each(|(file, bytes)| output.write(file, bytes))
    }
}
