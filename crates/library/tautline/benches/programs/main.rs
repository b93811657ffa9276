//! Measures what the programs of a formula cost before the first chord: their length, the time to
//! record and derive them, and the memory of a thread that runs them.
//!
//! `cargo bench --package tautline --bench programs` prints `paper/tables/programs.csv`, which
//! `cargo xtask bench` writes.

#[path = "../scale/cost.rs"]
mod cost;
mod metrics;

use cost::cost;
use metrics::{Visitor, every_metric};
use tautline::{Metric, Prepared};
use tautline_formula::{Batch, Formula, Kind};

/// More chords than fit into one block.
const CHORDS: usize = 1 << 20;

struct Printer;

impl Visitor for Printer {
    fn visit<const D: usize>(&mut self, name: &str, metric: &impl Metric<D>) {
        let record = cost(|| Formula::record(metric));
        let Ok(formula) = record.result else {
            println!("{name},{D},,as compiled,,,{:.0},,,", 1e6 * record.seconds);
            return;
        };
        // This is what a search on a fine grid requests first.
        let derive = cost(|| {
            let prepared = Prepared::<_, D>::new(metric);
            let batch = Batch::new(&prepared, Kind::Contraction, 2, CHORDS);
            (prepared.size(Kind::Contraction), batch.lanes())
        });
        let (size, lanes) = derive.result;
        let way = if size.is_some() { "program" } else { "as compiled" };
        let [instructions, registers] =
            size.map_or([const { String::new() }; 2], |size| size.map(|count| count.to_string()));
        // A program needs two more rows for its results.
        let thread = size.map_or(String::new(), |[_, registers]| {
            format!("{:.0}", (8 * lanes * (registers + 2)) as f64 / 1024.0)
        });
        println!(
            "{name},{D},{},{way},{instructions},{registers},{:.0},{:.0},{:.0},{thread}",
            formula.operations().len(),
            1e6 * record.seconds,
            1e6 * derive.seconds,
            derive.bytes as f64 / 1024.0,
        );
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "metric,d,steps,way,instructions,registers,microseconds_to_record,\
         microseconds_to_be_ready,kilobytes_to_be_ready,kilobytes_of_a_thread"
    );
    every_metric(&mut Printer)
}
