//! The tests of this package, in one program: the library is compiled once for all of them.

mod command;
mod data;
mod figures;
mod grid;
mod layout;
mod output;
mod parallel;
mod section_5;
