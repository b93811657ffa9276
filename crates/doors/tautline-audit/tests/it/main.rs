//! The program `tautline-audit`, run on files that are right and on files that lie.

mod bad_input;
mod formats;
mod guide;
mod program;
mod regions;
mod right_files;
mod time_limit;
mod wrong_files;
