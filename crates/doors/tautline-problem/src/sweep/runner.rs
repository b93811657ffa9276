//! `Runner`: solves the problems of a plan on some threads.

use std::ops::Range;

use rayon::{ThreadPool, ThreadPoolBuilder, prelude::*};

use super::{
    BlockWriter, Plan, PlanError,
    result_row::{Status, fields},
};
use crate::{Answer, Failure, Programs};

/// The stack of a thread: matrices in twelve dimensions lie on it.
const STACK: usize = 64 << 20;

/// How many problems are solved before their rows are handed on.
const CHUNK: u64 = 4096;

/// Solves the problems of a plan on some threads. The rows do not depend on their number.
#[derive(Debug)]
pub struct Runner<'p> {
    plan: &'p Plan,
    threads: ThreadPool,
}

/// The rows of a block of problems.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rows {
    /// A line for each problem, in the order of the ids.
    pub text: String,
    /// The number of problems whose curve is doubtful.
    pub doubtful: u64,
    /// The number of problems without a curve.
    pub failed: u64,
}

impl<'p> Runner<'p> {
    /// Returns a runner with this many threads; 0 stands for one for each processor.
    ///
    /// # Errors
    ///
    /// [`PlanError::Threads`] if the system does not start them.
    pub fn new(plan: &'p Plan, threads: usize) -> Result<Self, PlanError> {
        let threads = ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
        let threads = threads.map_err(|error| PlanError::Threads { reason: error.to_string() })?;
        Ok(Self { plan, threads })
    }

    /// Returns the number of threads.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.threads.current_num_threads()
    }

    /// Solves the problems with these ids. One that has no curve is a row with its reason.
    ///
    /// # Errors
    ///
    /// [`PlanError::Ids`].
    pub fn rows(&self, ids: Range<u64>) -> Result<Rows, PlanError> {
        self.plan.check(&ids)?;
        // The threads begin with the programs of the first problem, which may be those of all.
        let first = ids.clone().next().and_then(|id| {
            let question = self.plan.question.with_parameters(&self.plan.parameters(id)).ok()?;
            question.programs(None).ok()
        });
        let row = |last: &mut Option<Programs>, id| row(self.plan, id, last);
        let solve = || ids.into_par_iter().map_init(|| first.clone(), row).collect::<Vec<_>>();
        let rows = self.threads.install(solve);
        let count = |wanted| rows.iter().filter(|(_, status)| *status == wanted).count() as u64;
        let (doubtful, failed) = (count(Status::Doubtful), count(Status::Failed));
        Ok(Rows { text: rows.into_iter().map(|(line, _)| line).collect(), doubtful, failed })
    }

    /// Cuts a block into pieces whose rows fit into memory.
    pub fn pieces(ids: Range<u64>) -> impl Iterator<Item = Range<u64>> {
        let Range { start, end } = ids;
        (start..end).step_by(CHUNK as usize).map(move |id| id..end.min(id + CHUNK))
    }

    /// Returns the results of a block of problems as one text, which [`Block::read`](super::Block::read)
    /// reads.
    ///
    /// # Errors
    ///
    /// [`PlanError::Ids`].
    pub fn solved(&self, ids: Range<u64>) -> Result<String, PlanError> {
        let (mut writer, mut text) = BlockWriter::of_plan(self.plan, ids.clone())?;
        for ids in Self::pieces(ids) {
            text += &writer.rows(self.rows(ids)?.text);
        }
        Ok(text + &writer.end())
    }
}

/// Solves a problem, with the programs of the last one if its formula is the same.
fn row(plan: &Plan, id: u64, last: &mut Option<Programs>) -> (String, Status) {
    let parameters = plan.parameters(id);
    let (fields, status) = fields(&solve(plan, &parameters, last));
    let mut writer = csv::Writer::from_writer(Vec::new());
    let values = parameters.iter().map(|(_, value)| format!("{value:?}"));
    let record = [id.to_string()].into_iter().chain(values).chain(fields);
    // Writing to memory does not fail.
    let _ = writer.write_record(record);
    let line = writer.into_inner().unwrap_or_default();
    (String::from_utf8(line).unwrap_or_default(), status)
}

fn solve(
    plan: &Plan,
    parameters: &[(&str, f64)],
    last: &mut Option<Programs>,
) -> Result<Answer, Failure> {
    let question = plan.question.with_parameters(parameters)?;
    let programs = question.programs(last.as_ref())?;
    let programs = last.insert(programs);
    question.solve_with(programs)
}

#[cfg(test)]
mod tests {
    use super::{CHUNK, Runner};

    /// One after the other, each problem once, also in the last piece that is not full.
    #[test]
    fn pieces_are_consecutive_and_fit_into_memory() {
        for ids in [
            0..0,
            7..7,
            0..1,
            0..CHUNK,
            0..CHUNK + 1,
            5..5 + CHUNK,
            3..2 * CHUNK + 2,
            CHUNK - 1..3 * CHUNK,
        ] {
            let mut next = ids.start;
            for piece in Runner::pieces(ids.clone()) {
                assert_eq!(piece.start, next, "{ids:?}");
                let size = piece.end - piece.start;
                assert!((1..=CHUNK).contains(&size), "{ids:?}: {piece:?}");
                next = piece.end;
            }
            assert_eq!(next, ids.end, "{ids:?}");
        }
    }
}
