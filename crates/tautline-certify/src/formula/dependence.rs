//! `Dependence`: how a formula depends on each coordinate, read off the formula.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::SVector;
use num_traits::{One, Zero};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Scalar};

use super::operators::operators_follow;

/// The largest ratio of a wave number to the common divisor of all wave numbers.
///
/// Any two doubles have a common divisor; for `0.1` and `0.3` it is `2⁻⁵⁵` and the period is of no
/// use.
const LARGEST_RATIO: f64 = 1024.0;

/// What evaluation of a formula proves about its dependence on `D` coordinates: a function
///
/// `f(x) = a·x + p(x)`
///
/// where `p` depends on coordinate `i` not at all, periodically, or in a way that is not known.
///
/// A number type in which a metric is evaluated as in any other. It follows the formula as it is
/// written, in exact arithmetic on its constants, so a period that it finds is proved. What it does
/// not find may be there all the same: `sin x / cos x` is known to have the period `2π`, not `π`,
/// and of `e^{i·x}` in other guises it knows nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dependence<const D: usize> {
    /// The value of a constant; of no meaning for anything else.
    constant: Interval,
    /// `a`.
    slope: [Interval; D],
    /// For each coordinate a number of which every wave number is a multiple, in `1/ℓ`; 0 if there
    /// is no wave.
    wave_number: [f64; D],
    /// Whether more may happen along a coordinate.
    aperiodic: [bool; D],
}

/// How a function depends on one coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Along {
    /// Not at all.
    Constant,
    /// With the period `2π/κ` for the given `κ`, in `1/ℓ`.
    Periodic(f64),
    /// Perhaps in another way.
    Unknown,
}

impl<const D: usize> Dependence<D> {
    /// Returns how the Gram matrix of `metric` depends on each coordinate.
    pub(crate) fn of(metric: &impl Metric<D>) -> [Along; D] {
        let x = SVector::from_fn(|i, _| Self::variable(i));
        let gram = metric.gram(&x);
        // The entries that are read elsewhere: those on and above the diagonal.
        let upper = (0..D).flat_map(|j| (0..=j).map(move |i| (i, j)));
        let all = upper.fold(Self::zero(), |all, entry| all.joined(gram[entry]));
        std::array::from_fn(|i| {
            if all.aperiodic[i] {
                Along::Unknown
            } else if all.wave_number[i] > 0.0 {
                Along::Periodic(all.wave_number[i])
            } else {
                Along::Constant
            }
        })
    }

    fn variable(i: usize) -> Self {
        let mut variable = Self::zero();
        variable.constant = Interval::REALS;
        variable.slope[i] = Interval::one();
        variable
    }

    fn is_constant(&self) -> bool {
        let none =
            |i: usize| is_zero(self.slope[i]) && self.wave_number[i] == 0.0 && !self.aperiodic[i];
        (0..D).all(none)
    }

    /// Any function of `a·x + p`.
    fn bent(mut self) -> Self {
        for i in 0..D {
            self.aperiodic[i] |= !is_zero(self.slope[i]);
        }
        self.straightened()
    }

    /// A function of `a·x + p` with the period `2π`.
    fn wave(mut self) -> Self {
        for i in 0..D {
            let slope = self.slope[i];
            if slope.lo() == slope.hi() {
                self.add_wave(i, slope.lo().abs());
            } else {
                self.aperiodic[i] = true;
            }
        }
        self.straightened()
    }

    fn straightened(self) -> Self {
        Self { constant: Interval::REALS, slope: [Interval::zero(); D], ..self }
    }

    /// The dependence of a function of both.
    fn joined(self, other: Self) -> Self {
        let mut both = self.bent();
        let other = other.bent();
        for i in 0..D {
            both.aperiodic[i] |= other.aperiodic[i];
            both.add_wave(i, other.wave_number[i]);
        }
        both
    }

    fn add_wave(&mut self, i: usize, wave_number: f64) {
        let largest = self.wave_number[i].max(wave_number);
        let divisor = common_divisor(self.wave_number[i], wave_number);
        self.wave_number[i] = divisor;
        // Not finite, or no divisor to speak of.
        self.aperiodic[i] |= !(largest <= LARGEST_RATIO * divisor);
    }

    fn scaled(self, factor: Interval) -> Self {
        let slope = self.slope.map(|a| if is_zero(a) { a } else { a * factor });
        Self { constant: self.constant * factor, slope, ..self }
    }
}

impl Dependence<1> {
    /// Returns whether the formula of `metric` shows that its Gram matrix does not change along
    /// `direction`.
    pub(crate) fn is_constant_along<const N: usize>(
        metric: &impl Metric<N>,
        direction: &SVector<f64, N>,
    ) -> bool {
        // The one coordinate is s, in x + s · direction, whatever x is.
        let x = direction.map(|slope| Self {
            constant: Interval::REALS,
            slope: [Interval::point(slope)],
            ..Self::zero()
        });
        let gram = metric.gram(&x);
        let upper = (0..N).flat_map(|j| (0..=j).map(move |i| (i, j)));
        upper.into_iter().all(|entry| gram[entry].is_constant())
    }
}

fn is_zero(x: Interval) -> bool {
    x.lo() == 0.0 && x.hi() == 0.0
}

/// The greatest common divisor of two doubles, which are multiples of a power of two: remainders of
/// doubles are exact.
fn common_divisor(mut a: f64, mut b: f64) -> f64 {
    while b > 0.0 {
        (a, b) = (b, a % b);
    }
    a
}

impl<const D: usize> Neg for Dependence<D> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { constant: -self.constant, slope: self.slope.map(|a| -a), ..self }
    }
}

impl<const D: usize> Add for Dependence<D> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let mut sum = self;
        sum.constant = self.constant + other.constant;
        for i in 0..D {
            sum.slope[i] = self.slope[i] + other.slope[i];
            sum.aperiodic[i] |= other.aperiodic[i];
            sum.add_wave(i, other.wave_number[i]);
        }
        sum
    }
}

impl<const D: usize> Mul for Dependence<D> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if other.is_constant() {
            self.scaled(other.constant)
        } else if self.is_constant() {
            other.scaled(self.constant)
        } else {
            self.joined(other)
        }
    }
}

impl<const D: usize> Div for Dependence<D> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if !other.is_constant() {
            return self.joined(other);
        }
        Self {
            constant: self.constant / other.constant,
            slope: self.slope.map(|a| if is_zero(a) { a } else { a / other.constant }),
            ..self
        }
    }
}

operators_follow!([const D: usize] Dependence<D>);

impl<const D: usize> Zero for Dependence<D> {
    fn zero() -> Self {
        Self::constant(0.0)
    }
    fn is_zero(&self) -> bool {
        self.is_constant() && is_zero(self.constant)
    }
}

/// A function of a constant is one, whose value is asked for where it is a factor.
macro_rules! of_a_constant {
    ($self:ident, $function:ident, $otherwise:expr) => {{
        let mut result = $otherwise;
        if $self.is_constant() {
            result.constant = $self.constant.$function();
        }
        result
    }};
}

impl<const D: usize> Scalar for Dependence<D> {
    fn constant(value: f64) -> Self {
        Self {
            constant: Interval::point(value),
            slope: [Interval::zero(); D],
            wave_number: [0.0; D],
            aperiodic: [false; D],
        }
    }

    fn sqr(self) -> Self {
        of_a_constant!(self, sqr, self.bent())
    }

    fn powi(self, n: i32) -> Self {
        if n == 1 {
            return self;
        }
        let mut power = self.bent();
        if self.is_constant() {
            power.constant = self.constant.powi(n);
        }
        power
    }

    fn recip(self) -> Self {
        of_a_constant!(self, recip, self.bent())
    }

    fn sqrt(self) -> Self {
        of_a_constant!(self, sqrt, self.bent())
    }

    fn exp(self) -> Self {
        of_a_constant!(self, exp, self.bent())
    }

    fn ln(self) -> Self {
        of_a_constant!(self, ln, self.bent())
    }

    fn sin_cos(self) -> (Self, Self) {
        (of_a_constant!(self, sin, self.wave()), of_a_constant!(self, cos, self.wave()))
    }

    fn tan(self) -> Self {
        of_a_constant!(self, tan, self.wave())
    }

    fn atan(self) -> Self {
        of_a_constant!(self, atan, self.bent())
    }

    fn sinh_cosh(self) -> (Self, Self) {
        (of_a_constant!(self, sinh, self.bent()), of_a_constant!(self, cosh, self.bent()))
    }

    fn tanh(self) -> Self {
        of_a_constant!(self, tanh, self.bent())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline_metrics::{
        Metric,
        gallery::{
            Checkerboard, CoupledCosines, GaussianFisher, Lens, RotatingAnisotropy, Shear, Valleys,
        },
    };
    use tautline_scalar::Scalar;

    use super::{Along, Dependence, common_divisor};

    #[test]
    fn the_gallery_has_the_periods_of_its_formulas() {
        use Along::{Constant, Periodic, Unknown};
        assert_eq!(Dependence::<3>::of(&Valleys), [Periodic(1.0), Constant, Constant]);
        let shear = Shear::new(0.5, 3.0).expect("a wave number");
        assert_eq!(Dependence::of(&shear), [Constant, Periodic(3.0)]);
        assert_eq!(Dependence::of(&CoupledCosines), [Periodic(1.0); 3]);
        assert_eq!(Dependence::of(&GaussianFisher), [Constant, Unknown]);
        let lens = Lens::new(1.0, 1.0).expect("a width");
        assert_eq!(Dependence::<2>::of(&lens), [Unknown; 2]);
        let board = Checkerboard::new(1.0, 2.0).expect("an edge");
        let [Periodic(k), Periodic(l)] = Dependence::of(&board) else { panic!("not periodic") };
        // sin² has the half of that period, which is more than is read off the formula.
        assert!(k == l && (k / std::f64::consts::FRAC_PI_2 - 1.0).abs() < 1e-15, "{k}");
        let anisotropy = RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5]).expect("eigenvalues");
        // By the double angle.
        assert_eq!(Dependence::of(&anisotropy), [Periodic(1.0), Periodic(3.0)]);
    }

    /// A metric on the line by a formula.
    struct Line<F>(F);

    trait Formula: Sync {
        fn at<S: Scalar>(&self, x: S) -> S;
    }

    impl<F: Formula> Metric<1> for Line<F> {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            SMatrix::from_element(self.0.at(x[0]))
        }
    }

    macro_rules! along {
        (|$x:ident: $S:ident| $formula:expr) => {{
            struct Given;
            impl Formula for Given {
                fn at<$S: Scalar>(&self, $x: $S) -> $S {
                    $formula
                }
            }
            Dependence::of(&Line(Given))[0]
        }};
    }

    #[test]
    fn a_period_is_found_only_where_there_is_one() {
        use Along::{Constant, Periodic, Unknown};
        assert_eq!(along!(|x: S| x - x + 2.0), Constant);
        assert_eq!(along!(|x: S| (x * 3.0 - x + 1.0).sin() + 2.0), Periodic(2.0));
        assert_eq!(along!(|x: S| (x * 4.0).cos() + (x * 6.0).sin() + 3.0), Periodic(2.0));
        assert_eq!(along!(|x: S| ((x * 2.0).cos() + x * 4.0).sin() + 3.0), Periodic(2.0));
        assert_eq!(along!(|x: S| (x * S::constant(0.25).sqrt()).cos() + 3.0), Periodic(0.5));
        assert_eq!(along!(|x: S| (x / 0.5).tan().atan().exp()), Periodic(2.0));
        // No common period, or none that is known.
        assert_eq!(along!(|x: S| x.sin() + (x * 2.0_f64.sqrt()).sin() + 3.0), Unknown);
        assert_eq!(along!(|x: S| (x * 0.1).sin() + (x * 0.3).sin() + 3.0), Unknown);
        assert_eq!(along!(|x: S| (x / 3.0).sin() + 3.0), Unknown);
        // Not periodic.
        assert_eq!(along!(|x: S| x + x.cos()), Unknown);
        assert_eq!(along!(|x: S| x * x.cos()), Unknown);
        assert_eq!(along!(|x: S| x.cos() / x), Unknown);
        assert_eq!(along!(|x: S| x.sqr().cos()), Unknown);
        assert_eq!(along!(|x: S| (x * x).cos()), Unknown);
        assert_eq!(along!(|x: S| x.powi(3).sin()), Unknown);
        assert_eq!(along!(|x: S| x.cos() + x.tanh()), Unknown);
        assert_eq!(along!(|x: S| (x.exp() * 2.0).cos()), Unknown);
        assert_eq!(along!(|x: S| (x.cos() * x).sin()), Unknown);
        // Inside of a wave each function is a trap of its own.
        assert_eq!(along!(|x: S| (x + 2.0).recip().cos()), Unknown);
        assert_eq!(along!(|x: S| x.sqrt().cos()), Unknown);
        assert_eq!(along!(|x: S| x.ln().cos()), Unknown);
        assert_eq!(along!(|x: S| x.atan().cos()), Unknown);
        assert_eq!(along!(|x: S| x.sinh().cos()), Unknown);
        assert_eq!(along!(|x: S| x.cosh().cos()), Unknown);
        assert_eq!(along!(|x: S| x.tanh().cos()), Unknown);
        assert_eq!(along!(|x: S| (S::one() / x).cos()), Unknown);
    }

    #[test]
    fn common_divisors_are_exact() {
        assert_eq!(common_divisor(6.0, 4.0), 2.0);
        assert_eq!(common_divisor(0.0, 0.75), 0.75);
        assert_eq!(common_divisor(0.75, 0.0), 0.75);
        assert_eq!(common_divisor(0.75, 0.5), 0.25);
    }
}
