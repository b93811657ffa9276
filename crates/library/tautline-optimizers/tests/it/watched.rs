//! A watcher sees the iterates of a solve, changes nothing, and can end it.

use std::ops::ControlFlow;

use tautline_discretizations::Rule;
use tautline_formula::Prepared;
use tautline_optimizers::{
    Minimum, Options, SolveError, Trace, Watcher, Workspace, minimise_by_batches, minimise_watched,
};
use tautline_sets::Ends;

use crate::setup::{ball, between, bump, from_to, half_space, only, straight};

fn watched(
    ends: &Ends<2>,
    n: usize,
    options: &Options<2>,
    watcher: &mut Watcher<'_, 2>,
) -> Result<Minimum<2>, SolveError> {
    let metric = Prepared::new(bump());
    // The watcher is called through a closure, whose lifetime is that of this call.
    let mut watch = |iterate: &tautline_optimizers::Iterate<'_, 2>| watcher(iterate);
    let memory = &mut Workspace::default();
    minimise_watched(memory, &metric, ends, Rule::TRAPEZOIDAL, n, options, &mut watch)
}

/// A small grid, a grid that takes undamped steps, and one whose finest grid takes none.
#[test]
fn a_watcher_sees_every_grid_and_changes_nothing() {
    let ends = between(ball([-2.0, 0.3], 0.5), half_space([1.0, 0.0], 2.0));
    for n in [5, 32, 500, 20_000] {
        let options = Options::default();
        let metric = Prepared::new(bump());
        let memory = &mut Workspace::default();
        let alone = minimise_by_batches(memory, &metric, &ends, Rule::TRAPEZOIDAL, n, &options);
        let alone = alone.expect("a metric");
        let mut time = 0.0;
        let mut clock = || {
            time += 1.0;
            time
        };
        let mut trace = Trace::new(&mut clock);
        let found = watched(&ends, n, &options, &mut |iterate| trace.record(iterate));
        assert_eq!(found, Ok(alone.clone()), "N = {n}");
        for level in &alone.levels {
            let on_grid = || trace.entries().iter().filter(|entry| entry.n == level.n);
            let lowest = on_grid().map(|entry| entry.energy).fold(f64::INFINITY, f64::min);
            // The last iterate may be one Newton step before the result, which it promises to
            // lower by at most 1e-10 of the energy. A search may also pass below the minimiser on
            // the way to it, since another start leads elsewhere: only this end is compared.
            assert!(
                on_grid()
                    .any(|entry| { (entry.energy - level.energy).abs() <= 1e-10 * level.energy }),
                "N = {n}, grid {}: {lowest:e} {:e}",
                level.n,
                level.energy
            );
            assert_eq!(on_grid().next().map(|entry| entry.iteration), Some(0));
        }
        let (energy, best) = trace.best().expect("an iterate");
        assert_eq!(best.n().get(), n);
        assert!(energy <= alone.energy * (1.0 + 1e-10));
        let residual = trace.entries().last().map_or(f64::INFINITY, |entry| entry.residual);
        assert!(residual <= 1e-4, "N = {n}: {residual:e}");
    }
}

/// Along one search the energy falls, and so does, in the end, the residual.
#[test]
fn the_iterates_of_a_search_go_down() {
    let ends = from_to([-1.5, 0.05], [1.5, -0.1]);
    let start = straight([-1.5, 0.05], [1.5, -0.1], 40);
    let mut seen = Vec::new();
    let found = watched(&ends, 40, &only(start.clone()), &mut |iterate| {
        assert_eq!(iterate.iteration, seen.len());
        if seen.is_empty() {
            assert_eq!(*iterate.sequence, start);
        }
        seen.push((iterate.energy, iterate.residual));
        ControlFlow::Continue(())
    });
    let found = found.expect("a metric");
    assert!(seen.len() >= 4, "{seen:?}");
    // The last steps are not checked: they change the energy by rounding, about 40 terms.
    assert!(seen.windows(2).all(|pair| pair[1].0 <= pair[0].0 * (1.0 + 1e-13)), "{seen:?}");
    let (first, last) = (seen[0], seen[seen.len() - 1]);
    assert!(last.1 <= 1e-6 * first.1, "{seen:?}");
    assert!((last.0 - found.energy).abs() <= 1e-10 * found.energy);
}

/// Whenever the watcher ends the solve, it is not asked for more, and the caller gets no result that
/// looks like one.
#[test]
fn a_watcher_ends_the_solve_at_any_iterate() {
    let ends = between(ball([-2.0, 0.3], 0.5), half_space([1.0, 0.0], 2.0));
    let mut count = 0;
    watched(&ends, 500, &Options::default(), &mut |_| {
        count += 1;
        ControlFlow::Continue(())
    })
    .expect("a metric");
    assert!(count > 20);
    for end in [1, 2, count / 2, count - 1, count] {
        let mut seen = 0;
        let ended = watched(&ends, 500, &Options::default(), &mut |_| {
            seen += 1;
            if seen == end { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert!(matches!(ended, Err(SolveError::Interrupted { .. })), "{end}: {ended:?}");
        assert_eq!(seen, end);
    }
}
