//! The gallery, with a search for the constants that its formulas prove.

use std::time::{Duration, Instant};

use tautline::{
    Bounded, CertifiedConstant, CertifyError, Constants, Domain, LocallyBounded, Metric, Quantity,
    SMatrix, SVector,
    certify::{Accuracy, Cell, certify},
    gallery::{
        Bump, Checkerboard, Constant, Corrugated, CoupledCosines, EggCrate, GaussianFisher,
        GaussianFisherPatch, Hill, Hyperbolic, HyperbolicPatch, Lens, Obstacle, Ramp,
        RotatingAnisotropy, Separable, Shear, SineProjection, SineProjections, SoftObstacles,
        Sphere, SpherePatch, Swirl, TwoChannels, TwoLinkArm, Valleys,
    },
};

use crate::{Failure, decoder::decoder};

/// A metric of the gallery and its stated constants.
pub(crate) struct Certified {
    /// Its name.
    pub(crate) metric: &'static str,
    /// The dimension.
    pub(crate) d: usize,
    /// Where its constants are proved.
    pub(crate) on: &'static str,
    /// The stated constants in the order of [`Quantity::ALL`], and whether each is the best one.
    pub(crate) stated: [(f64, bool); 4],
    search: Search,
}

/// The result of a search, without its point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    /// The bound from below.
    pub(crate) lower: f64,
    /// The bound from above.
    pub(crate) upper: f64,
    /// The number of boxes.
    pub(crate) boxes: usize,
    /// How long it took.
    pub(crate) time: Duration,
}

type Search = Box<dyn Fn(Quantity, Accuracy) -> Result<Found, CertifyError>>;

impl Certified {
    /// Encloses a constant.
    pub(crate) fn find(
        &self,
        quantity: Quantity,
        accuracy: Accuracy,
    ) -> Result<Found, CertifyError> {
        (self.search)(quantity, accuracy)
    }

    fn new<M: Metric<D> + 'static, const D: usize>(
        name: &'static str,
        metric: M,
        (on, domain): (&'static str, Domain<D>),
        constants: Constants,
        exact: [bool; 4],
    ) -> Self {
        let c = constants;
        let values = [c.c1(), c.c2(), c.l_h(), c.m_h().unwrap_or(f64::NAN)];
        let search = move |quantity, accuracy| {
            let begun = Instant::now();
            let CertifiedConstant { lower, upper, boxes, .. } =
                certify(&metric, quantity, &domain, accuracy)?;
            Ok(Found { lower, upper, boxes, time: begun.elapsed() })
        };
        let stated = std::array::from_fn(|i| (values[i], exact[i]));
        Certified { metric: name, d: D, on, stated, search: Box::new(search) }
    }
}

/// All of space: a period, or a box outside of which the metric settles.
fn space<const D: usize>(
    metric: &impl Metric<D>,
) -> Result<(&'static str, Domain<D>), CertifyError> {
    let space = Domain::space(metric);
    if space.is_all_of_space() {
        return Ok(("a period", space));
    }
    Ok(("space, as it settles", Domain::settled_space(metric)?))
}

/// A metric with constants on all of space.
fn global<M: Bounded<D> + 'static, const D: usize>(
    name: &'static str,
    metric: M,
    exact: [bool; 4],
) -> Result<Certified, Failure> {
    let (domain, constants) = (space(&metric)?, metric.constants());
    Ok(Certified::new(name, metric, domain, constants, exact))
}

/// A metric with constants on balls.
fn local<M: LocallyBounded<2> + 'static>(
    name: &'static str,
    metric: M,
    on: &'static str,
    (centre, radius): ([f64; 2], f64),
    exact: [bool; 4],
) -> Result<Certified, Failure> {
    let constants = metric.constants_within(&centre.into(), radius)?;
    let ball = Domain::ball(centre, radius)?;
    Ok(Certified::new(name, metric, (on, ball), constants, exact))
}

const ALL: [bool; 4] = [true; 4];
const BUT_M_H: [bool; 4] = [true, true, true, false];
const BUT_L_H: [bool; 4] = [true, true, false, true];
const EIGENVALUES: [bool; 4] = [true, true, false, false];
/// The eigenvalues are stated with a margin for rounding.
const DERIVATIVES: [bool; 4] = [false, false, true, true];
const NONE: [bool; 4] = [false; 4];

/// Returns the accuracy of a search: a thousandth, and a hundredth for `M_H`, which costs most.
pub(crate) fn accuracy(quantity: Quantity) -> Accuracy {
    let tolerance = if quantity == Quantity::MH { 1e-2 } else { 1e-3 };
    Accuracy { tolerance, ..Accuracy::default() }
}

/// Returns the metrics of the gallery in at most three dimensions.
pub(crate) fn gallery() -> Result<Vec<Certified>, Failure> {
    let matrix = SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0);
    let one = Obstacle { centre: [0.0, 0.0].into(), height: 2.0, width: 0.5 };
    let two = Obstacle { centre: [1.0, 1.0].into(), height: 1.0, width: 0.7 };
    let sine = |wave_vector: [f64; 2], direction: [f64; 2]| SineProjection {
        wave_vector: SVector::from(wave_vector),
        direction: SVector::from(direction),
    };
    let sines =
        SineProjections::new(vec![sine([1.0, 0.0], [1.0, 0.5]), sine([1.0, 1.0], [0.0, 1.0])])?;
    let decoder = decoder()?;
    let decoded = Domain::cell(Cell::new([-6.0, -6.0], [6.0, 6.0])?);
    let stated = Bounded::<2>::constants(&decoder);
    Ok(vec![
        global("constant", Constant::new(matrix)?, DERIVATIVES)?,
        global::<_, 1>("valleys", Valleys, ALL)?,
        global::<_, 2>("valleys", Valleys, ALL)?,
        global::<_, 3>("valleys", Valleys, ALL)?,
        global("ramp", Ramp::new(0.5, 1.0)?, BUT_M_H)?,
        global("separable", Separable::new([0.3, 0.5], [1.0, 2.0])?, ALL)?,
        global("shear", Shear::new(0.5, 1.0)?, ALL)?,
        global::<_, 2>("lens", Lens::new(1.0, 0.5)?, ALL)?,
        global::<_, 3>("lens", Lens::new(1.0, 0.5)?, ALL)?,
        global::<_, 2>("bump", Bump::new(1.0, 0.5)?, BUT_L_H)?,
        global::<_, 2>("hill", Hill::new(0.5, 0.5)?, ALL)?,
        global("soft obstacles", SoftObstacles::new(vec![one, two])?, NONE)?,
        global("swirl", Swirl::new(1.0, 0.5)?, EIGENVALUES)?,
        global("egg crate", EggCrate::new(0.5, 1.0)?, ALL)?,
        global::<_, 2>("corrugated", Corrugated::new(0.5, 1.0)?, ALL)?,
        global("checkerboard", Checkerboard::new(2.0, 1.0)?, ALL)?,
        global("two channels", TwoChannels::new(2.0, 1.0, 0.5)?, EIGENVALUES)?,
        global("rotating anisotropy", RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5])?, ALL)?,
        global("two-link arm", TwoLinkArm::new(4.0, 0.8, 1.0)?, ALL)?,
        global("coupled cosines", CoupledCosines, BUT_M_H)?,
        global("sine projections", sines, NONE)?,
        local("sphere", Sphere, "$\\lvert x \\rvert \\le 1$", ([0.0, 0.0], 1.0), ALL)?,
        local("hyperbolic", Hyperbolic, "$\\lvert x \\rvert \\le 1/2$", ([0.0, 0.0], 0.5), ALL)?,
        local(
            "Gaussian Fisher",
            GaussianFisher,
            "$\\lvert x \\rvert \\le 3/4$",
            ([0.0, 0.0], 0.75),
            ALL,
        )?,
        global::<_, 2>("sphere patch", SpherePatch::new(1.0)?, EIGENVALUES)?,
        global::<_, 2>("hyperbolic patch", HyperbolicPatch::new(0.5)?, EIGENVALUES)?,
        global("Gaussian Fisher patch", GaussianFisherPatch::new(0.75)?, EIGENVALUES)?,
        Certified::new(
            "tanh decoder",
            decoder,
            ("$\\lvert x_i \\rvert \\le 6$", decoded),
            stated,
            NONE,
        ),
    ])
}
