//! What lives on the nodes of a lattice: shortest paths, fast marching, distance fields.
//!
//! A lattice sees the whole of a box, so that its paths are more than local minima: they are starts of
//! searches, and methods to compare with.
//!
//! | | what it returns | its error |
//! | --- | --- | --- |
//! | [`graph_path`], [`graph()`], [`LatticeGraph`] | a shortest path along edges | some per cent, at any spacing: it runs in a few directions |
//! | [`class_paths`] | one for each way around the peaks and holes of a metric, its [`Punctures`] | the same |
//! | [`path_elsewhere`] | a shortest path, unless it runs along a known line | the same |
//! | [`path_round`] | a shortest path round thin regions without a metric | the same |
//! | [`eikonal()`], [`Eikonal`] | the distances from a set at the nodes, by fast marching, and paths that descend them | of the first or second order in the spacing |
//! | [`pass_paths`] | curves through the passes between two distance fields | the same |
//! | [`Front`] | the march itself, over nodes of any arrangement | |

mod class_paths;
mod eikonal;
mod elsewhere;
mod front;
mod graph;
mod graph_path;
mod lattice;
mod lattice_graph;
mod lattice_path;
mod nodes;
mod ordered;
mod passes;
mod path_round;
mod peaks;
mod punctures;
mod reduction;
mod word;

pub use class_paths::{ClassPath, class_paths};
pub use eikonal::{Distances, Eikonal, EikonalError, EikonalPath, eikonal};
pub use elsewhere::path_elsewhere;
pub use front::{Front, Order};
pub use graph::{angular_factor, graph};
pub use graph_path::{GraphPathError, equal_chords, graph_path};
pub use lattice::Lattice;
pub use lattice_graph::LatticeGraph;
pub use lattice_path::LatticePath;
pub use nodes::Nodes;
pub use ordered::Ordered;
pub use passes::{PassPath, pass_paths};
pub use path_round::path_round;
pub use punctures::Punctures;
pub use word::Word;
