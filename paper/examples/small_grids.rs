//! Is a small grid cheaper than a fine one? Times with small `N`, divided by the time with
//! `N = 512`, for each problem of the corpus.
//!
//! `cargo run --release --package paper --example small_grids [problems] [runs]`: by default 2000
//! problems and the least of 3 runs. Other load on the machine makes runs longer, on either grid:
//! where a ratio is above 1, and so may be on the wrong side of 1.2, both are timed again with ten
//! times as many runs.

use std::error::Error;

use paper::corpus::corpus;

const SMALL: [usize; 5] = [4, 16, 32, 33, 64];
const FINE: usize = 512;

/// Above `LIMIT` a small grid is not cheaper; above `IN_DOUBT` this may be so.
const LIMIT: f64 = 1.2;
const IN_DOUBT: f64 = 1.0;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<usize>());
    let count = arguments.next().transpose()?.unwrap_or(2000);
    let runs = arguments.next().transpose()?.unwrap_or(3);
    let grids = [&SMALL[..], &[FINE]].concat();
    let mut ratios = vec![Vec::with_capacity(count); SMALL.len()];
    for (index, case) in corpus(count).into_iter().enumerate() {
        let seconds = case.seconds(&grids, runs)?;
        let fine = seconds[SMALL.len()];
        for ((ratios, time), n) in ratios.iter_mut().zip(seconds).zip(SMALL) {
            let mut ratio = time / fine;
            if ratio > IN_DOUBT {
                let again = case.seconds(&[n, FINE], 10 * runs)?;
                ratio = again[0] / again[1];
            }
            ratios.push((ratio, index));
        }
    }
    println!("N, problems, median of t(N)/t({FINE}), greatest, problem, number above {LIMIT}");
    for (n, mut ratios) in SMALL.into_iter().zip(ratios) {
        ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
        let Some(&(greatest, index)) = ratios.last() else { continue };
        let median = ratios[ratios.len() / 2].0;
        let above = ratios.iter().filter(|(ratio, _)| *ratio > LIMIT).count();
        println!("{n}, {}, {median:.2}, {greatest:.2}, {index}, {above}", ratios.len());
    }
    Ok(())
}
