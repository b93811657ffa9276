//! Shortest lattice paths of several homotopy classes.

use std::{
    cmp::Reverse,
    collections::{BinaryHeap, HashMap},
};

use nalgebra::SVector;
use tautline_sets::{ClosedSet, Ends};

use crate::{
    GraphPathError, LatticeGraph, LatticePath, Punctures, Word, lattice_graph::ROUNDING,
    word::Words,
};

/// The most states, and the most words, that a search stores: about 100 bytes each.
const MOST_STATES: usize = 1 << 22;

/// A shortest lattice path among those with one word.
#[derive(Clone, Debug, PartialEq)]
pub struct ClassPath<const D: usize> {
    word: Word,
    path: LatticePath<D>,
}

impl<const D: usize> ClassPath<D> {
    /// Returns the word.
    #[must_use]
    pub fn word(&self) -> &Word {
        &self.word
    }

    /// Returns the path. Its number of opened nodes is that of the whole search.
    #[must_use]
    pub fn path(&self) -> &LatticePath<D> {
        &self.path
    }
}

/// A node with the word of a path to it.
struct State {
    node: u32,
    word: u32,
    length: f64,
    /// The state before, or [`NONE`].
    before: u32,
    is_settled: bool,
}

const NONE: u32 = u32::MAX;

/// Returns the shortest paths between two sets along the edges of a lattice, one for each [word](Word),
/// shortest first: at most `most`, and none that is more than `slack` times as long as the shortest. Paths
/// that wind, by a whole turn or more around a puncture between their beginning, prolonged as for the word,
/// and one of their nodes, are left out.
///
/// The search is A* on pairs of a node and a word, with the length of the rest of the way in any class as
/// its bound (S. Bhattacharya, M. Likhachev and V. Kumar, *Topological constraints in search-based robot
/// path planning*, Auton. Robots 33, 2012). It ends early, with the paths that it has, after four million
/// pairs or words.
///
/// # Errors
///
/// [`GraphPathError::Slack`] unless `slack` is at least 1, [`GraphPathError::FarFromEnd`] and
/// [`GraphPathError::NotConnected`].
pub fn class_paths<const D: usize>(
    graph: &LatticeGraph<'_, D>,
    ends: &Ends<D>,
    punctures: &Punctures,
    most: usize,
    slack: f64,
) -> Result<Vec<ClassPath<D>>, GraphPathError> {
    if !(slack >= 1.0) {
        return Err(GraphPathError::Slack { slack });
    }
    let near = |set: &dyn ClosedSet<D>, end| {
        let gates = graph.gates(set);
        if gates.is_empty() { Err(GraphPathError::FarFromEnd { end }) } else { Ok(gates) }
    };
    let [first, second] = [near(&**ends.first(), "first")?, near(&**ends.second(), "second")?];
    let rests = rests(graph, second.iter().map(|gate| (gate.0, gate.2)));
    let whole = first.iter().map(|gate| gate.2 + rests[gate.0]).fold(f64::INFINITY, f64::min);
    if !whole.is_finite() {
        return Err(GraphPathError::NotConnected);
    }
    let longest = slack * whole * (1.0 + ROUNDING);
    let exits: HashMap<usize, _> = second.iter().map(|gate| (gate.0, (gate.1, gate.2))).collect();
    // The node after the last is the second set.
    let beyond = graph.lattice().nodes();
    let (mut words, mut states) = (Words::new(), Vec::<State>::new());
    let (mut known, mut heap) = (HashMap::<(u32, u32), u32>::new(), BinaryHeap::new());
    // Lengths are not negative, so that their bits have the same order.
    let mut reach = |states: &mut Vec<State>, node: usize, word: u32, length: f64, before: u32| {
        let estimate = length + rests.get(node).copied().unwrap_or(0.0);
        // NaN and ∞ are refused as well.
        if !(estimate <= longest) || states.len() >= MOST_STATES {
            return None;
        }
        let place = *known.entry((node as u32, word)).or_insert(states.len() as u32);
        match states.get_mut(place as usize) {
            Some(state) if state.is_settled || state.length <= length => return None,
            Some(state) => (state.length, state.before) = (length, before),
            None => {
                let node = node as u32;
                states.push(State { node, word, length, before, is_settled: false });
            }
        }
        Some(Reverse((estimate.to_bits(), place)))
    };
    let along = |words: &mut Words, word: u32, from: &SVector<f64, D>, to: &SVector<f64, D>| {
        punctures.letters(from, to).fold(word, |word, letter| words.with(word, letter))
    };
    let [begin, end] = punctures.anchors(ends);
    let point = |node: usize| if node == beyond { end } else { graph.lattice().point(node) };
    for (node, nearest, length) in &first {
        let word = along(&mut words, 0, &begin, nearest);
        let word = along(&mut words, word, nearest, &point(*node));
        heap.extend(reach(&mut states, *node, word, *length, NONE));
    }
    let (mut found, mut opened) = (Vec::new(), 0);
    while found.len() < most
        && states.len().max(words.count()) < MOST_STATES
        && let Some(Reverse((_, place))) = heap.pop()
    {
        let state = &mut states[place as usize];
        if std::mem::replace(&mut state.is_settled, true) {
            continue;
        }
        let (node, word, length) = (state.node as usize, state.word, state.length);
        let here = point(node);
        if !punctures.is_less_than_a_turn(&words.word(word), &begin, &here) {
            continue;
        }
        if node == beyond {
            found.push(place);
            continue;
        }
        opened += 1;
        if let Some((nearest, tail)) = exits.get(&node) {
            let word = along(&mut words, word, &here, nearest);
            let word = along(&mut words, word, nearest, &end);
            heap.extend(reach(&mut states, beyond, word, length + tail, place));
        }
        for (there, edge) in graph.edges(node) {
            let word = along(&mut words, word, &here, &point(there));
            heap.extend(reach(&mut states, there, word, length + edge, place));
        }
    }
    let path = |place: u32| {
        let (mut corners, mut at) = (Vec::new(), place);
        while at != NONE {
            let State { node, length, before, .. } = states[at as usize];
            let point = if node as usize == beyond {
                // The state before is the node at which the path leaves.
                exits[&(states[before as usize].node as usize)].0
            } else {
                point(node as usize)
            };
            corners.push((length, point));
            if before == NONE {
                let begin = first.iter().find(|gate| gate.0 == node as usize);
                corners.extend(begin.map(|gate| (0.0, gate.1)));
            }
            at = before;
        }
        corners.reverse();
        let path = LatticePath { corners, opened };
        ClassPath { word: words.word(states[place as usize].word), path }
    };
    let mut paths: Vec<_> = found.into_iter().map(path).collect();
    // Estimates are rounded: paths of nearly the same length may be found in another order.
    paths.sort_by(|a: &ClassPath<D>, b| a.path.length().total_cmp(&b.path.length()));
    Ok(paths)
}

/// Returns the length of the shortest way from each node to some gates, given with the lengths behind them,
/// in `m`; `∞` where there is none.
fn rests<const D: usize>(
    graph: &LatticeGraph<'_, D>,
    gates: impl Iterator<Item = (usize, f64)>,
) -> Vec<f64> {
    let mut lengths = vec![f64::INFINITY; graph.lattice().nodes()];
    let mut heap = BinaryHeap::new();
    for (node, length) in gates {
        lengths[node] = length;
        heap.push(Reverse((length.to_bits(), node)));
    }
    while let Some(Reverse((bits, node))) = heap.pop() {
        let length = f64::from_bits(bits);
        if length > lengths[node] {
            continue;
        }
        for (there, edge) in graph.edges(node) {
            let longer = length + edge;
            if longer < lengths[there] {
                lengths[there] = longer;
                heap.push(Reverse((longer.to_bits(), there)));
            }
        }
    }
    lengths
}
