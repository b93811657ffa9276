//! The verbs of the command, and their options.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use tautline_problem::sweep::Shard;

/// Shortest curves between two sets, under a metric that you type, with bounds on the distance.
///
/// Exit codes: 0 done; 1 a warning, such as no strict minimum or a tolerance that is not reached, or
/// something that is not proved; 2 bad input.
#[derive(Debug, Parser)]
#[command(
    name = "tautline",
    version,
    after_help = "Begin with: tautline examples valleys --to . && tautline solve valleys.toml"
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) verb: Verb,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    Solve(Solve),
    Constants(Constants),
    Certify(Certify),
    Check(Check),
    Audit(Audit),
    Plot(Plot),
    Plan(Plan),
    Run(Run),
    Merge(Merge),
    Schema(Schema),
    Examples(Examples),
    Completions(Completions),
}

/// Finds a shortest curve, and bounds the distance from both sides.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline examples valleys --to .
  $ tautline solve valleys.toml --plot valleys.svg
prints the bounds, the length, how the search ended and the constants it used, and draws the curve.")]
pub(crate) struct Solve {
    /// The problem file; - reads standard input.
    pub(crate) file: PathBuf,
    /// Print one JSON document; `tautline schema answer` describes it.
    #[arg(long)]
    pub(crate) json: bool,
    /// Draw the problem and its curve: a file that ends in .svg, .png or .pdf. May be repeated.
    #[arg(long, value_name = "PICTURE")]
    pub(crate) plot: Vec<PathBuf>,
    /// The number of chords, in place of that of the file.
    #[arg(short, long = "chords", value_name = "N", conflicts_with = "tolerance")]
    pub(crate) n: Option<usize>,
    /// The wanted relative error of the length, instead of n. A file with a lattice needs n.
    #[arg(long, value_name = "ERROR", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// Stop after this many seconds, with what is known by then.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
    /// Prove no bounds.
    #[arg(long)]
    pub(crate) no_bounds: bool,
}

/// Proves the constants c1, c2, L_H and M_H of the metric from its formula, or says why not.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline examples valleys --to .
  $ tautline constants valleys.toml
A metric that is neither periodic nor constant far away has constants in a region only: name it in
the file with [certify] and within = { ball = { centre = [0, 0], radius = 1 } }.")]
pub(crate) struct Constants {
    /// The problem file, of which only the metric counts; - reads standard input.
    pub(crate) file: PathBuf,
    /// Print one JSON document; `tautline schema constants` describes it.
    #[arg(long)]
    pub(crate) json: bool,
    /// Stop after this many seconds.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
}

/// Proves the distance: two numbers with a certificate that anybody can check.
///
/// No curve between the sets is shorter than the lower number; the upper one is the length of a curve.
/// Exit code 1 if the gap between them is larger than wanted.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline examples two_channels --to .
  $ tautline certify two_channels.toml --gap 1e-4 -o two_channels.cert
  $ tautline check two_channels.cert")]
pub(crate) struct Certify {
    /// The problem file; - reads standard input.
    pub(crate) file: PathBuf,
    /// The largest (upper - lower)/upper that will do.
    #[arg(long, value_name = "GAP", default_value_t = 1e-3, allow_negative_numbers = true)]
    pub(crate) gap: f64,
    /// Write the certificate to this file.
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Print one JSON document; `tautline schema certified` describes it.
    #[arg(long)]
    pub(crate) json: bool,
    /// Draw the problem, its curve and the cubes that hold every shortest curve: a file that ends in
    /// .svg, .png or .pdf. May be repeated.
    #[arg(long, value_name = "PICTURE")]
    pub(crate) plot: Vec<PathBuf>,
    /// Stop after this many seconds, with what is proved by then.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
    /// The most cubes of the certificate, unless its first level has more. A million take 140 megabytes in the plane, 440 in space.
    #[arg(long, value_name = "COUNT", default_value_t = 2_000_000)]
    pub(crate) cubes: usize,
}

/// Checks a certificate: proves its two numbers again, and trusts none in the file.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline check two_channels.cert
prints the metric, the sets and what is proved. Exit code 1 if the certificate proves nothing, 2 if it
was not read or not checked in time.")]
pub(crate) struct Check {
    /// The certificate; - reads standard input.
    pub(crate) file: PathBuf,
    /// Stop after this time in seconds; what was not checked is neither proved nor refused.
    #[arg(long, value_name = "SECONDS")]
    pub(crate) time_limit: Option<f64>,
}

/// Tests the metric and its constants against every law and every statement of the paper.
///
/// The audit is a program of its own, tautline-audit, since it takes some minutes to build.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ cargo build --package tautline-audit
  $ tautline audit valleys.toml --markdown")]
pub(crate) struct Audit {
    /// Arguments of tautline-audit; see `tautline-audit --help`.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    pub(crate) arguments: Vec<std::ffi::OsString>,
}

/// Draws the metric and the sets, and the curve if the file has two sets.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline examples valleys --to .
  $ tautline plot valleys.toml valleys.pdf
[output] in the file chooses the coordinates, the window, and contours of det H or ellipses.")]
pub(crate) struct Plot {
    /// The problem file; - reads standard input.
    pub(crate) file: PathBuf,
    /// The pictures: files that end in .svg, .png or .pdf.
    #[arg(required = true)]
    pub(crate) pictures: Vec<PathBuf>,
    /// Draw the metric and the sets alone.
    #[arg(long)]
    pub(crate) no_curve: bool,
}

/// Writes the table of problems of a sweep: of a problem file that says which parameters vary.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline examples sweep --to .
  $ tautline plan sweep.toml -o plan.csv
  $ tautline run plan.csv --shard 1/2 --to results
  $ tautline run plan.csv --shard 2/2 --to results
  $ tautline merge results -o results.csv
The head of the table is the sweep file with a hash, so that a shard needs one file.")]
pub(crate) struct Plan {
    /// The sweep file.
    pub(crate) file: PathBuf,
    /// Write the table to this file.
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Print the problem file of one problem, for `tautline solve` or `tautline certify`, in place of the
    /// table.
    #[arg(long, value_name = "ID", conflicts_with = "output")]
    pub(crate) problem: Option<u64>,
}

/// Solves a block of the problems of a plan. What is finished is not done again.
///
/// A problem without a curve is a row with its reason. The rows do not depend on the number of threads or
/// shards; the time is printed, and is not among them.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline run plan.csv --shard 3/40 --to results
writes results/3-of-40.csv, at once when it is complete. Run the same line again after a crash.")]
pub(crate) struct Run {
    /// The plan, or the sweep file itself, from which the same problems follow.
    pub(crate) plan: PathBuf,
    /// Which of how many blocks of problems, from 1.
    #[arg(long, value_name = "K/N", default_value = "1/1")]
    pub(crate) shard: Shard,
    /// The folder of the results; it is made if there is none.
    #[arg(long, value_name = "FOLDER")]
    pub(crate) to: PathBuf,
    /// The number of threads; 0 stands for one for each processor.
    #[arg(long, value_name = "COUNT", default_value_t = 0)]
    pub(crate) threads: usize,
    /// Write the time and the memory that the shard took to this file.
    #[arg(long, value_name = "FILE")]
    pub(crate) times: Option<PathBuf>,
}

/// Joins the results of all shards. Every problem must be there once, of the same plan.
///
/// Exit code 1 if results are incomplete, missing or doubled; the message names them.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline merge results -o results.csv")]
pub(crate) struct Merge {
    /// Files of results, and folders of which all files that end in .csv are taken.
    #[arg(required = true)]
    pub(crate) results: Vec<PathBuf>,
    /// Write the table to this file.
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

/// Prints the JSON schema of problem files or of answers.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline schema problem > problem.schema.json
Editors with TOML support complete and check a file that begins with
  #:schema ./problem.schema.json")]
pub(crate) struct Schema {
    /// What is described.
    #[arg(default_value = "problem")]
    pub(crate) of: Described,
}

/// What a schema describes.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Described {
    /// A problem file.
    Problem,
    /// What `solve --json` prints.
    Answer,
    /// What `constants --json` prints.
    Constants,
    /// What `certify --json` prints.
    Certified,
}

/// Writes a commented problem file for a question that you may have.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline examples
  $ tautline examples two_channels --to .
  $ tautline solve two_channels.toml
Without names it lists all examples; without --to it prints the file.")]
pub(crate) struct Examples {
    /// The names of examples.
    pub(crate) names: Vec<String>,
    /// Write all examples.
    #[arg(long, conflicts_with = "names", requires = "to")]
    pub(crate) all: bool,
    /// The folder in which NAME.toml is written. An existing file is not replaced.
    #[arg(long, value_name = "FOLDER")]
    pub(crate) to: Option<PathBuf>,
}

/// Prints a script that completes the verbs and options in a shell.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  $ tautline completions bash > ~/.local/share/bash-completion/completions/tautline")]
pub(crate) struct Completions {
    /// The shell.
    pub(crate) shell: Shell,
}
