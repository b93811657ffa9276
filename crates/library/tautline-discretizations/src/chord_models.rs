//! `ChordModels`: the contributions of some chords to a discrete energy, to second order, in any
//! dimension.

use tautline_formula::{Layout, Register};

use crate::ChordBatch;

/// The [models](crate::ChordModel) of some chords in a dimension that is known when the program runs.
/// Vectors and matrices of a chord are contiguous, matrices column by column.
#[derive(Clone, Debug, Default)]
pub struct ChordModels {
    dimension: usize,
    chords: usize,
    /// The energies and the traces of all chords; their gradients with respect to both ends; their
    /// second derivatives with respect to both ends, and the mixed ones; `H d`, coordinate by coordinate,
    /// with a lane for each node. All in one list, which is allocated at once.
    numbers: Vec<f64>,
}

/// Matrices of neighbouring chords are this much farther apart than they are long, so that in powers of
/// two the same entries of many chords do not compete for the same lines of a cache.
const GAP: usize = 8;

impl ChordModels {
    /// Returns the energy of chord `k`, in `m²`.
    #[must_use]
    #[inline]
    pub fn energy(&self, k: usize) -> f64 {
        self.numbers[k]
    }

    /// Returns `N tr H` of chord `k`, averaged over the nodes, in `m²/ℓ²`.
    #[must_use]
    #[inline]
    pub fn trace(&self, k: usize) -> f64 {
        self.numbers[self.chords + k]
    }

    /// Returns the gradient with respect to the near end (0) or the far end (1) of chord `k`, in `m²/ℓ`.
    #[must_use]
    #[inline]
    pub fn gradient(&self, end: usize, k: usize) -> &[f64] {
        let begin = 2 * self.chords + (end * self.chords + k) * self.dimension;
        &self.numbers[begin..][..self.dimension]
    }

    /// Returns the lower triangle `i ≥ j` of the second derivatives with respect to an end of chord
    /// `k`, in `m²/ℓ²`. Entries above the diagonal are arbitrary.
    #[must_use]
    #[inline]
    pub fn hessian(&self, end: usize, k: usize) -> &[f64] {
        self.matrix(end, k)
    }

    /// Returns the mixed second derivatives of chord `k`, with a row for each coordinate of the far
    /// point and a column for each coordinate of the near point.
    #[must_use]
    #[inline]
    pub fn lower(&self, k: usize) -> &[f64] {
        self.matrix(2, k)
    }

    #[inline]
    fn matrix(&self, which: usize, k: usize) -> &[f64] {
        let size = self.dimension * self.dimension;
        let begin =
            2 * self.chords * (1 + self.dimension) + (which * self.chords + k) * self.stride();
        &self.numbers[begin..][..size]
    }

    /// Returns the distance from the matrix of a chord to that of the next.
    fn stride(&self) -> usize {
        self.dimension * self.dimension + GAP
    }

    /// Provides memory for this number of chords with so many nodes in all, and returns its parts.
    fn parts(&mut self, dimension: usize, chords: usize, lanes: usize) -> Parts<'_> {
        (self.dimension, self.chords) = (dimension, chords);
        let stride = self.stride();
        let (vectors, matrices) = (2 * chords * (1 + dimension), 3 * chords * stride);
        self.numbers.resize(vectors + matrices + dimension * lanes, 0.0);
        let (energy, rest) = self.numbers.split_at_mut(chords);
        let (trace, rest) = rest.split_at_mut(chords);
        let (near, rest) = rest.split_at_mut(chords * dimension);
        let (far, rest) = rest.split_at_mut(chords * dimension);
        let (near_near, rest) = rest.split_at_mut(chords * stride);
        let (far_far, rest) = rest.split_at_mut(chords * stride);
        let (lower, momentum) = rest.split_at_mut(chords * stride);
        for list in [&mut *energy, &mut *trace, &mut *momentum] {
            list.fill(0.0);
        }
        Parts {
            stride,
            energy,
            trace,
            gradient: [near, far],
            hessian: [near_near, far_far],
            lower,
            momentum,
        }
    }
}

/// The parts of the memory of some models.
struct Parts<'m> {
    stride: usize,
    energy: &'m mut [f64],
    trace: &'m mut [f64],
    gradient: [&'m mut [f64]; 2],
    hessian: [&'m mut [f64]; 2],
    lower: &'m mut [f64],
    momentum: &'m mut [f64],
}

/// The constants of a node, as seen from the near point: its weight, twice its weight, and its
/// distances from the near and from the far point as fractions of the chord.
#[derive(Clone, Copy)]
struct Place {
    once: f64,
    twice: f64,
    far: f64,
    near: f64,
}

impl Place {
    /// Returns the contributions of a node to the entry `(i, j)` of the second derivatives with respect
    /// to the near and to the far point, and to the entries `(i, j)` and `(j, i)` of the block with rows
    /// for the far point. `h` is `Hᵢⱼ` times twice the weight, `bend` is `Qᵢⱼ`, and `turn` is `Pᵢⱼ` and `Pⱼᵢ`.
    #[inline(always)]
    fn entries(self, h: f64, bend: f64, turn: [f64; 2]) -> [f64; 4] {
        let Self { once, twice, far, near } = self;
        let q = bend * once;
        let [p, transposed] = turn.map(|turn| turn * twice);
        let (symmetric, mixed) = (p + transposed, q * (near * far) - h);
        [
            h - symmetric * near + q * (near * near),
            h + symmetric * far + q * (far * far),
            mixed - transposed * far + p * near,
            mixed - p * far + transposed * near,
        ]
    }
}

impl ChordBatch<'_> {
    /// Assembles the models of the first `chords` chords, which were evaluated from their end 0 or 1,
    /// as `end` says.
    ///
    /// The formulas are those of a [`ChordModel`](crate::ChordModel).
    pub fn assemble(&self, end: usize, chords: usize, models: &mut ChordModels) {
        let place = |fraction: f64, weight: f64| {
            let once = weight * self.n;
            let far = if end == 0 { fraction } else { 1.0 - fraction };
            Place { once, twice: 2.0 * once, far, near: 1.0 - far }
        };
        if let [node] = self.nodes {
            assemble(self, &[place(node.fraction, node.weight)], chords, models);
        } else {
            let places: Vec<_> =
                self.nodes.iter().map(|node| place(node.fraction, node.weight)).collect();
            assemble(self, &places, chords, models);
        }
    }

    #[inline(always)]
    fn assemble_inline(&self, places: &[Place], chords: usize, models: &mut ChordModels) {
        let (d, count) = (self.dimension, places.len());
        let lanes = chords * count;
        let mut parts = models.parts(d, chords, lanes);
        for j in 0..d {
            for i in j..d {
                self.assemble_entry([i, j], places, chords, &mut parts);
            }
        }
        let Parts { energy, gradient: [near, far], momentum, .. } = parts;
        for i in 0..d {
            let slope = &self.row(self.layout().slope[i])[..lanes];
            let vector = &self.row((d + i) as Register)[..lanes];
            let momentum = &momentum[i * lanes..][..lanes];
            for k in 0..chords {
                let mut sums = [0.0; 3];
                for (node, place) in places.iter().enumerate() {
                    let lane = k * count + node;
                    let g = slope[lane] * place.once;
                    sums[0] += g * place.near - momentum[lane];
                    sums[1] += g * place.far + momentum[lane];
                    sums[2] += vector[lane] * momentum[lane];
                }
                near[k * d + i] = sums[0];
                far[k * d + i] = sums[1];
                energy[k] += 0.5 * sums[2];
            }
        }
    }

    /// Sets the entries `(i, j)` and `(j, i)`, for `i ≥ j`, of the matrices of all chords, and adds what
    /// the entry `Hᵢⱼ` contributes to `H d`.
    #[inline(always)]
    fn assemble_entry(
        &self,
        [i, j]: [usize; 2],
        places: &[Place],
        chords: usize,
        parts: &mut Parts<'_>,
    ) {
        let (d, count) = (self.dimension, places.len());
        let lanes = chords * count;
        let (below, above) = (j * d + i, i * d + j);
        let Layout { gram, turn, bend, .. } = self.layout();
        let [gram, bend, turn, turned] = [gram[above], bend[above], turn[above], turn[below]]
            .map(|register| &self.row(register)[..lanes]);
        let [d_i, d_j] = [i, j].map(|i| &self.row((d + i) as Register)[..lanes]);
        let (before, rest) = parts.momentum.split_at_mut(i * lanes);
        let hd_i = &mut rest[..lanes];
        let stride = parts.stride;
        let [near_near, far_far] =
            parts.hessian.each_mut().map(|list| &mut list[..chords * stride]);
        let lower = &mut parts.lower[..chords * stride];
        let mut set = |k: usize, entries: [f64; 4]| {
            let place = k * stride;
            near_near[place + below] = entries[0];
            far_far[place + below] = entries[1];
            lower[place + below] = entries[2];
            lower[place + above] = entries[3];
        };
        if let [place] = places {
            for k in 0..chords {
                let h = gram[k] * place.twice;
                hd_i[k] += h * d_j[k];
                set(k, place.entries(h, bend[k], [turn[k], turned[k]]));
            }
        } else {
            for k in 0..chords {
                let mut sum = [0.0; 4];
                for (node, place) in places.iter().enumerate() {
                    let lane = k * count + node;
                    let h = gram[lane] * place.twice;
                    hd_i[lane] += h * d_j[lane];
                    let entries = place.entries(h, bend[lane], [turn[lane], turned[lane]]);
                    sum.iter_mut().zip(entries).for_each(|(sum, entry)| *sum += entry);
                }
                set(k, sum);
            }
        }
        for (node, place) in places.iter().enumerate() {
            if i == j {
                for k in 0..chords {
                    parts.trace[k] += gram[k * count + node] * place.once;
                }
            } else {
                let hd_j = &mut before[j * lanes..][..lanes];
                for k in 0..chords {
                    let lane = k * count + node;
                    hd_j[lane] += gram[lane] * place.twice * d_i[lane];
                }
            }
        }
    }
}

/// AVX instructions take four numbers at once, and write to a third register.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn assemble(batch: &ChordBatch<'_>, places: &[Place], chords: usize, models: &mut ChordModels) {
    batch.assemble_inline(places, chords, models);
}
