//! Jets over intervals contain the metrics of the gallery, their compositions and their
//! derivatives, computed to 192 bits with an error bound, at points of the box.

use std::collections::BTreeSet;

use crate::every_metric::{Trial, try_all};
use crate::precise::Tally;
use crate::reference::Random;

fn trial(seed: u64, comparisons: u64) -> Trial {
    let random = Random(tautline_chance::seed(seed));
    let mut trial = Trial { random, comparisons, records: Vec::new() };
    try_all(&mut trial);
    trial
}

#[test]
fn no_enclosure_misses_a_metric_or_its_derivatives() {
    const EACH: u32 = 6_000;
    let each = u64::from(tautline_chance::cases(EACH));
    let mut all = Tally::default();
    for record in trial(41, each).records {
        println!("{record:?}");
        assert!(record.tally.compared >= each, "{record:?}");
        assert!(record.tally.unknown * 100 <= record.tally.total(), "{record:?}");
        all.add(record.tally);
    }
    println!("{all:?}");
    // The hyperbolic metric is undefined outside the unit ball.
    assert!(all.undefined > 1_000, "{all:?}");
}

/// Compares the list of tried metrics with the table at the top of the gallery. Other tests compare
/// that table with the exports of the gallery.
#[test]
fn every_metric_of_the_gallery_is_tried() {
    let gallery = include_str!("../../../tautline-metrics/src/gallery/mod.rs");
    let rows = gallery.lines().filter_map(|line| line.strip_prefix("//! | [`"));
    let names: BTreeSet<&str> = rows.map(|row| row.split('`').next().expect("a name")).collect();
    let tried: BTreeSet<&str> = trial(42, 0).records.iter().map(|record| record.name).collect();
    assert!(names.len() >= 25, "{names:?}");
    let compositions = ["AffinePullback", "Product", "Scaled", "Sum"];
    assert_eq!(names.into_iter().chain(compositions).collect::<BTreeSet<_>>(), tried);
}
