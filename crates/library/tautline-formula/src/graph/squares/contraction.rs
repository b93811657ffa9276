//! The contraction of squares of vectors, with the formulas of [the module](super).

use super::Squares;
use crate::{
    graph::{Graph, contraction::Sums, derivative::Order, derivatives::Derivatives},
    operation::Step,
};

impl Graph {
    /// Adds the contraction of the squares, given the derivatives of their functions.
    pub(in crate::graph) fn add_squares(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        order: Order,
        d: &[Step],
        sums: &mut Sums,
    ) {
        let Squares { forms, vectors, .. } = squares;
        // The numbers `vₒ` and `wₒ vₒ`.
        let (mut along, mut weighted) = (Vec::new(), Vec::new());
        for vector in vectors {
            let terms: Vec<Step> = vector.entries.iter().map(|&(i, a)| self.mul(a, d[i])).collect();
            let sum = self.sum(terms);
            along.push(sum);
            weighted.push(self.times(sum, vector.weight));
        }
        let square = self.weighted(&weighted, along.into_iter().map(Some));
        sums.square = self.add(sums.square, square);
        for (vector, &weighted) in vectors.iter().zip(&weighted) {
            for &(i, a) in &vector.entries {
                let term = self.mul(a, weighted);
                sums.momentum[i] = self.add(sums.momentum[i], term);
            }
        }
        if order == Order::Zero {
            return;
        }
        // For each form: `gᵀd`, and `Σₒ wₒ vₒ f`, which is its weight in the sum of all `wₒ vₒ aₒ`.
        let forms_along: Vec<Step> = forms
            .iter()
            .map(|form| self.combination(d.iter().copied().zip(form.vector.iter().copied())))
            .collect();
        let mut terms = vec![Vec::new(); forms.len()];
        for (vector, &weighted) in vectors.iter().zip(&weighted) {
            for &(form, factor) in &vector.factors {
                terms[form].push(self.times(weighted, factor));
            }
        }
        let counts: Vec<Step> = terms.into_iter().map(|terms| self.sum(terms)).collect();
        // The terms of `2 hₐ`.
        let mut terms = vec![Vec::new(); squares.functions.len()];
        for (form, (&along, &count)) in forms.iter().zip(forms_along.iter().zip(&counts)) {
            terms[form.function].push(self.mul(along, count));
        }
        let mut doubled = Vec::new();
        for terms in terms {
            let sum = self.sum(terms);
            doubled.push(self.times(sum, 2.0));
        }
        for (k, slope) in sums.slope.iter_mut().enumerate() {
            let first = derivatives.iter().map(|of| of.first(k));
            let sum = self.weighted(&doubled, first);
            *slope = self.add(*slope, sum);
        }
        if order == Order::Second {
            let slopes = self.slopes_along(squares, derivatives, &forms_along, d.len());
            self.add_turn(squares, derivatives, &slopes, &counts, &mut sums.turn);
            self.add_bend(squares, derivatives, &slopes, &doubled, &mut sums.bend);
        }
    }

    /// Returns `∂ₖvₒ` at `[k][o]`.
    fn slopes_along(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        forms_along: &[Step],
        dimension: usize,
    ) -> Vec<Vec<Step>> {
        let mut slopes = Vec::with_capacity(dimension);
        for k in 0..dimension {
            let of_forms = self.times_slopes(squares, derivatives, forms_along, k);
            let mut of_vectors = Vec::with_capacity(squares.vectors.len());
            for vector in &squares.vectors {
                let factors = vector.factors.iter();
                let terms = factors.filter_map(|&(form, factor)| Some((of_forms[form]?, factor)));
                of_vectors.push(self.combination(terms));
            }
            slopes.push(of_vectors);
        }
        slopes
    }

    /// Returns the number of each form times `∂ₖ` of its function; `None` is 0.
    fn times_slopes(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        of_forms: &[Step],
        k: usize,
    ) -> Vec<Option<Step>> {
        let pairs = squares.forms.iter().zip(of_forms);
        pairs
            .map(|(form, &number)| {
                let slope = derivatives[form.function].first(k)?;
                Some(self.mul(number, slope))
            })
            .collect()
    }

    fn add_turn(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        slopes: &[Vec<Step>],
        counts: &[Step],
        turn: &mut [Step],
    ) {
        let dimension = slopes.len();
        for (k, slopes) in slopes.iter().enumerate() {
            let of_forms = self.times_slopes(squares, derivatives, counts, k);
            let mut terms = vec![Vec::new(); dimension];
            for (vector, &slope) in squares.vectors.iter().zip(slopes) {
                for &(i, a) in &vector.entries {
                    let product = self.mul(a, slope);
                    terms[i].push(self.times(product, vector.weight));
                }
            }
            for (i, mut terms) in terms.into_iter().enumerate() {
                for (form, number) in squares.forms.iter().zip(&of_forms) {
                    if let Some(number) = *number
                        && form.vector[i] != 0.0
                    {
                        terms.push(self.times(number, form.vector[i]));
                    }
                }
                let sum = self.sum(terms);
                let place = i * dimension + k;
                turn[place] = self.add(turn[place], sum);
            }
        }
    }

    fn add_bend(
        &mut self,
        squares: &Squares,
        derivatives: &[Derivatives],
        slopes: &[Vec<Step>],
        doubled: &[Step],
        bend: &mut [Step],
    ) {
        let upper = (0..slopes.len()).flat_map(|k| (k..slopes.len()).map(move |l| (k, l)));
        for (place, bend) in upper.zip(bend) {
            let pairs = slopes[place.0].iter().zip(&slopes[place.1]);
            let mut terms = Vec::with_capacity(squares.vectors.len());
            for ((&one, &other), vector) in pairs.zip(&squares.vectors) {
                let product = self.mul(one, other);
                terms.push(self.times(product, 2.0 * vector.weight));
            }
            let of_slopes = self.sum(terms);
            let second = derivatives.iter().map(|of| of.second(place));
            let of_functions = self.weighted(doubled, second);
            let sum = self.add(of_slopes, of_functions);
            *bend = self.add(*bend, sum);
        }
    }
}
