//! `Hill`: `e^p` for a sum `p` of concave parabolas in linear forms.

use num_traits::{One, Zero};
use tautline_formula::{Arithmetic, Function, Operation, Step};
use tautline_scalar::{Interval, Scalar};

use super::lift::{Lift, Role};

/// The function `e^p` with `p = c + Σ (bₖ yₖ − wₖ yₖ²)`, where `wₖ > 0`.
///
/// In intervals, the derivative `p′ e^p` is `∞ · 0` on a half-line. The hill bounds it instead.
#[derive(Clone, Debug)]
pub(crate) struct Hill {
    constant: Interval,
    pub(crate) terms: Vec<Term>,
}

/// `b y − w y²`, for a form `y`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    pub(crate) form: usize,
    b: Interval,
    w: Interval,
}

impl Hill {
    /// Returns whether it is a hill: the exponent tends to `−∞` along each of its forms.
    pub(crate) fn is_concave(&self) -> bool {
        !self.terms.is_empty() && self.terms.iter().all(|term| term.w.lo() > 0.0)
    }

    /// Returns the exponent `p` that the step at `place` computes, if it is one, given those of the
    /// steps before it and the values of all steps at the origin.
    pub(crate) fn parabola(
        lift: &Lift,
        origin: &[Interval],
        before: &[Option<Self>],
        place: usize,
    ) -> Option<Self> {
        let of = |step: Step| before[step as usize].clone();
        match lift.roles[place] {
            Role::Linear(Some((form, scale))) => {
                let term = Term { form, b: scale, w: Interval::zero() };
                return Some(Self { constant: origin[place], terms: vec![term] });
            }
            Role::Plain => {}
            _ => return None,
        }
        match lift.formula.operations()[place] {
            Operation::Constant(c) => Some(Self::number(c.value())),
            Operation::WithNumber(how, a, c) => of(a)?.combined(how, &Self::number(c.value())),
            Operation::Binary(how, a, b) => of(a)?.combined(how, &of(b)?),
            Operation::Of(Function::Neg, a) => Some(of(a)?.times(Interval::point(-1.0))),
            Operation::Of(Function::Sqr, a) | Operation::Powi(a, 2) => of(a)?.product(&of(a)?),
            _ => None,
        }
    }

    fn number(value: f64) -> Self {
        Self { constant: Interval::point(value), terms: Vec::new() }
    }

    fn combined(self, how: Arithmetic, other: &Self) -> Option<Self> {
        match how {
            Arithmetic::Add => Some(self.plus(other)),
            Arithmetic::Sub => Some(self.plus(&other.clone().times(Interval::point(-1.0)))),
            Arithmetic::Mul => self.product(other),
            Arithmetic::Div if other.terms.is_empty() => Some(self.times(other.constant.recip())),
            Arithmetic::Div => None,
        }
    }

    fn times(mut self, factor: Interval) -> Self {
        self.constant *= factor;
        for term in &mut self.terms {
            (term.b, term.w) = (term.b * factor, term.w * factor);
        }
        self
    }

    fn plus(mut self, other: &Self) -> Self {
        self.constant += other.constant;
        for term in &other.terms {
            match self.terms.iter_mut().find(|mine| mine.form == term.form) {
                Some(mine) => (mine.b, mine.w) = (mine.b + term.b, mine.w + term.w),
                None => self.terms.push(*term),
            }
        }
        self
    }

    /// Returns the product with a constant, or of two linear functions of the same form.
    fn product(self, other: &Self) -> Option<Self> {
        match (&self.terms[..], &other.terms[..]) {
            (_, []) => Some(self.times(other.constant)),
            ([], _) => Some(other.clone().times(self.constant)),
            ([a], [b]) if a.form == b.form && [a, b].iter().all(|it| it.w.magnitude() == 0.0) => {
                let term = Term {
                    form: a.form,
                    b: a.b * other.constant + b.b * self.constant,
                    w: -(a.b * b.b),
                };
                Some(Self { constant: self.constant * other.constant, terms: vec![term] })
            }
            _ => None,
        }
    }

    /// Returns an enclosure of `e^p`, given those of the forms.
    pub(crate) fn value(&self, form: impl Fn(usize) -> Interval) -> Interval {
        let exponent = self
            .terms
            .iter()
            .fold(self.constant, |sum, term| sum + term.top() - term.square(form(term.form)));
        exponent.exp()
    }

    /// Returns a bound on all derivatives of `e^p` of order 1 to 3, given enclosures of the forms
    /// and bounds `nₖ ≥ 1` on the derivatives of the forms.
    ///
    /// Let `P₁ = Σ nₖ |bₖ − 2 wₖ yₖ|` and `P₂ = Σ 2 wₖ nₖ²`. The derivatives are at most
    /// `e^p (1 + P₁ + P₂)³ ≤ e^p Π (1 + P₁ₖ + P₂ₖ)³`. With `s² = w (y − b/2w)²`, one factor is
    ///
    /// `e^(b²/4w) e^(−s²) (1 + 2 w n² + 2 √w n s)³ ≤ e^(b²/4w) (1 + 2 w n² + 2 √w n)³ 6 e^(−s²/2)`,
    ///
    /// since `e^(−s²/2) (1 + s)³ ≤ 5.23`, attained where `s² + s = 3`.
    pub(crate) fn slope(
        &self,
        form: impl Fn(usize) -> Interval,
        size: impl Fn(usize) -> f64,
    ) -> f64 {
        let factor = |term: &Term| {
            let n = Interval::point(size(term.form));
            let bend = term.w * n.sqr() * 2.0;
            let factor = Interval::one() + bend + term.w.sqrt() * n * 2.0;
            let least = Interval::point(term.square(form(term.form)).lo());
            factor.powi(3) * (term.top() - least * 0.5).exp() * 6.0
        };
        self.terms.iter().map(factor).fold(self.constant.exp(), |all, one| all * one).hi()
    }
}

impl Term {
    /// The largest value, `b²/4w`.
    fn top(&self) -> Interval {
        self.b.sqr() / (self.w * 4.0)
    }

    /// Returns `s² = w (y − b/2w)²`.
    fn square(&self, y: Interval) -> Interval {
        (y - self.b / (self.w * 2.0)).sqr() * self.w
    }

    /// Returns the distance from the origin at which the hill has nearly vanished.
    pub(crate) fn reach(&self) -> f64 {
        (self.b / (self.w * 2.0)).magnitude() + 6.0 / self.w.lo().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

    use super::{Hill, Term};

    /// The derivatives of `c e^(b y − w y²)` by `x`, where `y` changes by `n` per unit of `x`. The
    /// last one would exceed a bound with a smaller power of `n √w`.
    #[test]
    fn the_slope_of_a_hill_bounds_its_derivatives() {
        for (b, w, n) in [(0.0, 1.0, 1.0), (3.0, 0.5, 2.0), (-2.0, 4.0, 10.0), (0.5, 0.01, 300.0)] {
            let term = Term { form: 0, b: Interval::point(b), w: Interval::point(w) };
            let hill = Hill { constant: Interval::point(-0.5), terms: vec![term] };
            let centre = b / (2.0 * w);
            for k in -60..=60 {
                let s = f64::from(k) * 0.1;
                let y = centre + s / w.sqrt();
                // y + n x, to third order in x: the second-order jet of the first derivative.
                let x = Jet2::variables(&Jet1::variables(&[0.0]))[0];
                let form = x * n + y;
                let e = (form * b - form.sqr() * w - 0.5).exp();
                let third = e.second(0, 0).first(0);
                let derivatives = [e.value().first(0), e.second(0, 0).value(), third];
                let beyond = if s > 0.0 { (y, f64::INFINITY) } else { (f64::NEG_INFINITY, y) };
                let beyond = Interval::new(beyond.0, beyond.1).expect("in order");
                let bound = hill.slope(|_| beyond, |_| n);
                assert!(derivatives.iter().all(|d| d.abs() <= bound), "{derivatives:?} {bound}");
                let value = hill.value(|_| beyond);
                // The value is rounded.
                assert!(e.value().value() <= value.hi() * (1.0 + 1e-12) && value.lo() == 0.0);
            }
            // Far out it is negligible.
            let far = Interval::new(centre + 40.0 / w.sqrt(), f64::INFINITY).expect("in order");
            assert!(hill.slope(|_| far, |_| n) < 1e-200);
        }
    }
}
