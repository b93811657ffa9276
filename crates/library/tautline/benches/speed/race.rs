//! `Race`: times several computations in turn.

use std::time::{Duration, Instant};

/// Computations that are timed in rounds, so that other load on the machine affects all of them
/// alike. The shortest time of each counts.
#[derive(Default)]
pub(crate) struct Race<'a> {
    runners: Vec<(&'static str, Runner<'a>)>,
}

type Runner<'a> = Box<dyn FnMut() + 'a>;

/// At least so many rounds are run, and more if they take less than this time.
const ROUNDS: usize = 5;
const TIME: Duration = Duration::from_millis(1500);

impl<'a> Race<'a> {
    pub(crate) fn add<T>(&mut self, name: &'static str, mut run: impl FnMut() -> T + 'a) {
        let run = move || drop(std::hint::black_box(run()));
        self.runners.push((name, Box::new(run)));
    }

    /// Returns the shortest time of each computation, in the order in which they were added.
    pub(crate) fn run(mut self) -> Vec<(&'static str, Duration)> {
        let mut least = vec![Duration::MAX; self.runners.len()];
        let begun = Instant::now();
        let mut rounds = 0;
        while rounds < ROUNDS || (begun.elapsed() < TIME && rounds < 1000) {
            for ((_, run), least) in self.runners.iter_mut().zip(&mut least) {
                let begun = Instant::now();
                run();
                *least = begun.elapsed().min(*least);
            }
            rounds += 1;
        }
        self.runners.into_iter().map(|(name, _)| name).zip(least).collect()
    }
}
