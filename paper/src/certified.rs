//! The gallery, with a search for the constants that can be proved from its formulas.

use std::time::{Duration, Instant};

use tautline::{
    Bounded, CertifiedConstant, CertifyError, Constants, Domain, LocallyBounded, Metric, Quantity,
    certify::{Accuracy, Cell, certify},
    gallery::*,
};

use crate::Failure;

/// A metric of the gallery with its stated constants.
pub(crate) struct Certified {
    /// Its name.
    pub(crate) metric: &'static str,
    /// The dimension.
    pub(crate) d: usize,
    /// The domain on which its constants are proved.
    pub(crate) on: String,
    /// The stated constants in the order of [`Quantity::ALL`], and whether each is the best
    /// constant.
    pub(crate) stated: [(f64, bool); 4],
    search: Search,
}

/// The result of a search, without its point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    /// The lower bound.
    pub(crate) lower: f64,
    /// The upper bound.
    pub(crate) upper: f64,
    /// The number of boxes.
    pub(crate) boxes: usize,
    /// The time that the search took.
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
        (on, domain): (String, Domain),
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

/// Returns all of space if the metric is periodic or settles, and the cell otherwise.
fn domain<const D: usize>(
    metric: &impl Metric<D>,
    [low, high]: [[f64; D]; 2],
) -> Result<(String, Domain), Failure> {
    let space = Domain::space(metric);
    if space.is_one_period() {
        return Ok(("a period".to_owned(), space));
    }
    if space.is_all_of_space() && space.is_sharp() {
        return Ok(("space".to_owned(), space));
    }
    let space = Domain::settled_space(metric);
    if let Some(space) = space.ok().filter(Domain::is_sharp) {
        return Ok(("space, as it settles".to_owned(), space));
    }
    let label = format!("$\\lvert x_i \\rvert \\le {}$", high[0]);
    Ok((label, Domain::cell(Cell::new(low, high)?)))
}

/// Returns a metric with constants on all of space.
fn global<M: Bounded<D> + 'static, const D: usize>(
    name: &'static str,
    metric: M,
    cell: [[f64; D]; 2],
    exact: [bool; 4],
) -> Result<Certified, Failure> {
    let (domain, constants) = (domain(&metric, cell)?, metric.constants());
    Ok(Certified::new(name, metric, domain, constants, exact))
}

/// Returns a metric with constants on balls, all of them exact, in a ball about the origin.
fn local<M: LocallyBounded<2> + 'static>(
    name: &'static str,
    metric: M,
    radius: f64,
    shown: &str,
) -> Result<Certified, Failure> {
    let constants = metric.constants_within(&[0.0, 0.0].into(), radius)?;
    let on = format!("$\\lvert x \\rvert \\le {shown}$");
    let ball = Domain::ball([0.0, 0.0], radius)?;
    Ok(Certified::new(name, metric, (on, ball), constants, [true; 4]))
}

/// Returns the accuracy of a search: a thousandth, or a hundredth for `M_H`, which costs most.
pub(crate) fn accuracy(quantity: Quantity) -> Accuracy {
    let tolerance = if quantity == Quantity::MH { 1e-2 } else { 1e-3 };
    Accuracy { tolerance, ..Accuracy::default() }
}

macro_rules! rows {
    ($(
        $id:ident: $name:literal, $metric:expr, dimension $D:literal, in $cell:expr,
        exact $exact:expr $(, with $distances:ident)?;
    )*) => { vec![$(global::<_, $D>($name, $metric?, $cell, $exact)?),*] };
}

/// Returns the samples of the gallery. Metrics with constants on balls come before their patches.
pub(crate) fn gallery() -> Result<Vec<Certified>, Failure> {
    let mut gallery = for_each_sample!(rows);
    let balls = [
        local("sphere", Sphere, 1.0, "1")?,
        local("hyperbolic", Hyperbolic, 0.5, "1/2")?,
        local("Gaussian Fisher", GaussianFisher, 0.75, "3/4")?,
    ];
    let patches = gallery.iter().position(|row| row.metric == "sphere patch");
    let patches = patches.unwrap_or(gallery.len());
    gallery.splice(patches..patches, balls);
    Ok(gallery)
}
