//! Is a small grid cheaper than a fine one? The time with `N = 64` over that with `N = 512`, for each
//! problem of the corpus.
//!
//! `cargo run --release --package paper --example small_grids [problems] [runs]`: 2000 problems and the
//! least of 3 runs unless said otherwise. What else the machine does makes a run longer, never shorter: where
//! a ratio is above 1.2, it is taken once more of ten times as many runs.

use std::error::Error;

use paper::corpus::corpus;

const N: [usize; 6] = [4, 16, 32, 33, 64, 512];

/// Above it a small grid is not cheaper.
const LIMIT: f64 = 1.2;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<usize>());
    let count = arguments.next().transpose()?.unwrap_or(2000);
    let runs = arguments.next().transpose()?.unwrap_or(3);
    let mut ratios = vec![Vec::with_capacity(count); N.len() - 1];
    for (index, case) in corpus(count).into_iter().enumerate() {
        let seconds = case.seconds(&N, runs)?;
        let fine = seconds[N.len() - 1];
        for ((ratios, time), n) in ratios.iter_mut().zip(seconds).zip(N) {
            let mut ratio = time / fine;
            if ratio > LIMIT {
                let again = case.seconds(&[n, 512], 10 * runs)?;
                ratio = again[0] / again[1];
            }
            ratios.push((ratio, index));
        }
    }
    println!("N, problems, median of t(N)/t(512), greatest, problem, number above {LIMIT}");
    for (n, mut ratios) in N.into_iter().zip(ratios) {
        ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
        let Some(&(greatest, index)) = ratios.last() else { continue };
        let median = ratios[ratios.len() / 2].0;
        let above = ratios.iter().filter(|(ratio, _)| *ratio > LIMIT).count();
        println!("{n}, {}, {median:.2}, {greatest:.2}, {index}, {above}", ratios.len());
    }
    Ok(())
}
