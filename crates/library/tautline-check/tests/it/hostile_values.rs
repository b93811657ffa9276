//! Values that were made to prove too much: every bound stays below the distance, and every minimal
//! geodesic that is shorter than `hi` stays in the corridor.

use nalgebra::SVector;
use tautline_chance::{Random, cases, seed};
use tautline_check::{Certificate, Chain, Cubes, Level, Region};

use crate::{
    helpers::{flood, formula, keeps, lower, point, points},
    wave::Wave,
};

/// A problem with a known distance, and cubes that hold all curves shorter than `hi`.
struct Known<const D: usize> {
    certificate: Certificate<D>,
    d: f64,
    geodesic: Vec<SVector<f64, D>>,
    /// The distances from the ends at the nodes.
    distances: [Vec<f64>; 2],
}

fn wave(random: &mut Random, exponent: i32) -> Known<2> {
    let wave = Wave::random(random, 4.0);
    let ends: [SVector<f64, 2>; 2] =
        [0, 1].map(|_| SVector::from_fn(|_, _| random.between(-0.5, 0.5)));
    let d = wave.distance(&ends[0], &ends[1]);
    let hi = d * (1.0 + 10.0_f64.powf(random.between(-9.0, -0.5)));
    known(wave.formula(), ends, hi, wave.declared(), exponent, wave.geodesic(ends, 60), |x, y| {
        wave.distance(x, y)
    })
}

fn flat<const D: usize>(random: &mut Random, exponent: i32) -> Known<D> {
    let ends: [SVector<f64, D>; 2] =
        [0, 1].map(|_| SVector::from_fn(|_, _| random.between(-0.5, 0.5)));
    let hi = (ends[1] - ends[0]).norm() * (1.0 + 10.0_f64.powf(random.between(-9.0, -0.5)));
    let line = (0..=30).map(|n| ends[0].lerp(&ends[1], f64::from(n) / 30.0)).collect();
    let region = Region::Declared { c1: 1.0 };
    known(formula("1 I"), ends, hi, region, exponent, line, |x, y| (x - y).norm())
}

fn known<const D: usize>(
    formula: tautline_formula::Formula<D>,
    ends: [SVector<f64, D>; 2],
    hi: f64,
    region: Region,
    exponent: i32,
    geodesic: Vec<SVector<f64, D>>,
    distance: impl Fn(&SVector<f64, D>, &SVector<f64, D>) -> f64,
) -> Known<D> {
    let sets = ends.map(|x| point(x.into()));
    let cubes = region.required(sets.each_ref(), hi, exponent).expect("a region");
    let at = points(&cubes);
    let distances = ends.map(|end| at.iter().map(|x| distance(&end, x)).collect::<Vec<_>>());
    let level = Level::new(0, cubes, distances.clone()).expect("finite");
    let certificate = Certificate { formula, sets, hi, region, curve: None, levels: vec![level] };
    Known { certificate, d: distance(&ends[0], &ends[1]), geodesic, distances }
}

impl<const D: usize> Known<D> {
    /// Returns what the values prove, after asserting that it is true.
    fn try_values(&self, values: [Vec<f64>; 2]) -> f64 {
        let mut certificate = self.certificate.clone();
        let cubes = certificate.levels[0].cubes().clone();
        certificate.levels[0] = Level::new(0, cubes, values).expect("finite");
        let proved = certificate.check().expect("no cube is missing");
        // The distance was computed with an error of a few roundings.
        assert!(proved.lower <= self.d * (1.0 + 1e-14), "{} > {}", proved.lower, self.d);
        assert!(keeps(&proved, &self.geodesic), "hi/d − 1 = {:e}", certificate.hi / self.d - 1.0);
        proved.lower
    }

    /// Returns the distances, spoilt in some way.
    fn spoilt(&self, random: &mut Random) -> [Vec<f64>; 2] {
        let kind = (random.unit() * 8.0) as usize;
        let size = self.d * 10.0_f64.powf(random.between(-6.0, 1.0));
        let huge = 10.0_f64.powf(random.between(100.0, 308.0));
        let jump = random.unit() * self.d;
        let scale = [1.0, random.between(0.1, 3.0)][usize::from(random.unit() < 0.5)];
        self.distances.each_ref().map(|distances| {
            let count = distances.len() as f64;
            let mut values: Vec<f64> = distances.iter().map(|d| scale * d).collect();
            match kind {
                0 => {}
                1 => values.iter_mut().for_each(|v| *v += random.between(-size, size)),
                2 => values[(random.unit() * count) as usize] += random.sign() * size,
                3 => values.iter_mut().for_each(|v| *v += if *v > jump { size } else { 0.0 }),
                4 => values[(random.unit() * count) as usize] = random.sign() * huge,
                5 => values.iter_mut().for_each(|v| *v = random.between(-size, size)),
                6 => values.iter_mut().for_each(|v| *v = jump - (*v - jump).abs()),
                _ => values.iter_mut().for_each(|v| *v *= huge),
            }
            values
        })
    }
}

fn spoilt_values_prove_nothing_false<const D: usize>(
    fixed: u64,
    [count, tries]: [u32; 2],
    known: impl Fn(&mut Random) -> Known<D>,
) {
    let mut random = Random(seed(fixed));
    for _ in 0..cases(count) {
        let known = known(&mut random);
        for _ in 0..tries {
            known.try_values(known.spoilt(&mut random));
        }
    }
}

#[test]
fn spoilt_values_prove_nothing_false_on_waves() {
    spoilt_values_prove_nothing_false(11, [1000, 2], |random| {
        let exponent = -2 - (random.unit() * 3.0) as i32;
        wave(random, exponent)
    });
}

#[test]
fn spoilt_values_prove_nothing_false_in_one_dimension() {
    spoilt_values_prove_nothing_false::<1>(12, [100, 6], |random| flat(random, -4));
}

#[test]
fn spoilt_values_prove_nothing_false_in_space() {
    spoilt_values_prove_nothing_false::<3>(13, [30, 6], |random| flat(random, -2));
}

#[test]
fn spoilt_values_prove_nothing_false_in_four_dimensions() {
    spoilt_values_prove_nothing_false::<4>(14, [8, 6], |random| flat(random, -1));
}

/// Values that are changed at random wherever that raises the bound.
#[test]
fn values_that_climb_do_not_climb_beyond_the_distance() {
    let mut random = Random(seed(15));
    for _ in 0..cases(12) {
        let known = wave(&mut random, -2);
        let mut values = known.spoilt(&mut random);
        let mut best = known.try_values(values.clone());
        let mut size = 0.3 * known.d;
        for _ in 0..100 {
            let mut next = values.clone();
            let function = usize::from(random.unit() < 0.5);
            // One node, or all.
            let one = (random.unit() * next[0].len() as f64) as usize;
            let all = random.unit() < 0.2;
            for (n, value) in next[function].iter_mut().enumerate() {
                if all || n == one {
                    *value += random.between(-size, size);
                }
            }
            let found = known.try_values(next.clone());
            if found >= best {
                (best, values) = (found, next);
            } else {
                size *= 0.97;
            }
        }
    }
}

/// Cubes that were left out make a hole, or cut the corridor in two. A further level on the cubes
/// that are kept has other values in each part.
#[test]
fn holes_and_parts_prove_nothing_false() {
    let mut random = Random(seed(16));
    for _ in 0..cases(30) {
        let known = wave(&mut random, -3);
        let Certificate { formula, sets, hi, region, .. } = &known.certificate;
        let mut chain = Chain::new(formula, sets, *hi, *region).expect("a region");
        chain.add(&known.certificate.levels[0], *hi).expect("no cube is missing");
        for number in 1..3 {
            let mut places = chain.required(-3 - number).expect("cubes").places().to_vec();
            // Further cubes, some of them on their own.
            for _ in 0..20 {
                places.push([0, 0].map(|_: i32| random.between(-60.0, 60.0) as i32));
            }
            let cubes = Cubes::new(-3 - number, places).expect("in range");
            let end = &known.geodesic;
            let values = [end[0], end[end.len() - 1]].map(|end| {
                let distance = |x: &SVector<f64, 2>| (x - end).norm();
                points(&cubes).iter().map(|x| distance(x) * random.between(0.5, 2.0)).collect()
            });
            let level = Level::new(number as usize, cubes, values).expect("finite");
            chain.add(&level, *hi).expect("no cube is missing");
        }
        let proved = chain.proved(None).expect("levels");
        assert!(proved.lower <= known.d * (1.0 + 1e-14), "{} > {}", proved.lower, known.d);
        assert!(keeps(&proved, &known.geodesic));
    }
}

/// Boxes of any size, with any values: if the exit test accepts them, the bound is true.
#[test]
fn random_boxes_prove_nothing_false_by_the_exit_test() {
    let mut random = Random(seed(17));
    let mut accepted = 0;
    for _ in 0..cases(150) {
        let known = wave(&mut random, -2);
        let middle = known.geodesic[30];
        let reach = random.between(0.3, 3.0) * known.d;
        let cubes = flood(-3, &known.geodesic[0], |x| (x - middle).amax() < reach);
        let ends = [known.geodesic[0], known.geodesic[60]];
        let scale = random.between(0.5, 1.5);
        let metric = random.between(0.5, 3.0);
        let noise = 0.01 * random.unit() * known.d;
        let values = ends.map(|end| {
            let at = points(&cubes);
            let value = |x: &SVector<f64, 2>| {
                scale * (x - end).norm() * metric + random.between(-noise, noise)
            };
            at.iter().map(value).collect()
        });
        let mut certificate = known.certificate.clone();
        certificate.levels = vec![Level::new(0, cubes, values).expect("finite")];
        for region in [Region::ExitOne, Region::ExitTwo] {
            certificate.region = region;
            let checked = certificate.check();
            accepted += usize::from(checked.is_ok());
            assert!(lower(&checked) <= known.d * (1.0 + 1e-14), "{region:?}");
            if let Ok(proved) = checked {
                assert!(keeps(&proved, &known.geodesic), "{region:?}");
            }
        }
    }
    assert!(accepted > 20, "only {accepted} boxes were accepted");
}
