//! An audit that keeps its time limit.

use std::{
    sync::mpsc::{self, RecvTimeoutError},
    thread,
    time::{Duration, Instant},
};

use tautline_problem::{Diagnostic, Failure, LARGEST_FIXED_DIMENSION, Question, in_dimension};

use crate::{answer::Audit, effort::Effort, run::Run};

/// The stack of the thread that works: matrices in twelve dimensions lie on it.
const STACK: usize = 64 << 20;

/// The share of the time limit that is kept for the report.
const RESERVE: f64 = 0.02;

/// Why there is no audit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AuditError {
    /// The file is wrong.
    #[error(transparent)]
    BadInput(#[from] Diagnostic),
    /// The time limit is too short even to read the formula.
    #[error("nothing was tried within the time limit")]
    NoTime,
    /// The audit did not run.
    #[error("the audit did not run: {0}")]
    NotRun(String),
}

/// Audits the metric of a file. If the time runs out, the laws that are not done by then are listed
/// as not tried; the law that runs at this moment ends in the background.
///
/// # Errors
///
/// [`AuditError::BadInput`] with the place in the file, if its formula is wrong;
/// [`AuditError::NoTime`] and [`AuditError::NotRun`] if there is nothing to report.
pub fn audit(question: &Question, effort: Effort) -> Result<Audit, AuditError> {
    let start = Instant::now();
    let limit: Duration = effort.time_limit.mul_f64(1.0 - RESERVE);
    let dimension = question.dimension();
    if dimension > LARGEST_FIXED_DIMENSION {
        let what =
            format!("audits run in up to {LARGEST_FIXED_DIMENSION} dimensions, not {dimension}");
        return Err(AuditError::NotRun(what));
    }
    let (sender, reports) = mpsc::channel();
    let question = question.clone();
    let work = move || {
        // Nobody listens any more once time has run out.
        let report = |audit: &Audit| sender.send(Ok(audit.clone())).is_ok();
        let run = Run { question: &question, effort, report: &report };
        // The dimension was checked.
        if let Some(result) = in_dimension(question.dimension(), run) {
            let _ = sender.send(result);
        }
    };
    let thread = thread::Builder::new().stack_size(STACK).spawn(work);
    let thread = thread.map_err(|error| AuditError::NotRun(error.to_string()))?;
    let mut last = None;
    loop {
        match reports.recv_timeout(limit.saturating_sub(start.elapsed())) {
            Ok(report) => last = Some(report),
            Err(RecvTimeoutError::Timeout) => break,
            Err(RecvTimeoutError::Disconnected) => {
                if thread.join().is_err() {
                    return Err(AuditError::NotRun("a law panicked".to_owned()));
                }
                break;
            }
        }
    }
    match last {
        Some(Ok(audit)) => Ok(audit),
        Some(Err(Failure::BadInput(diagnostic))) => Err(AuditError::BadInput(diagnostic)),
        Some(Err(Failure::NotComputed(reason))) => Err(AuditError::NotRun(reason)),
        None => Err(AuditError::NoTime),
    }
}
