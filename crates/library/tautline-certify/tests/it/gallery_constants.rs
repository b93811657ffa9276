//! The declared constants of the gallery lie between the bounds proved from its formulas.

use tautline_certify::{Accuracy, Cell, CertifyError, Domain, Quantity, certify};
use tautline_metrics::{Bounded, gallery::*};

/// How a constant is declared.
#[derive(Clone, Copy, PartialEq)]
enum Stated {
    Exact,
    /// Possibly not the best bound.
    Bound,
}
use Stated::{Bound, Exact};

/// Fails unless the declared `c₁`, `c₂`, `L_H` and `M_H` lie between the bounds or, if they are
/// only bounds themselves, do not contradict them.
fn check<const D: usize>(
    metric: impl Bounded<D>,
    stated: [Stated; 4],
    domain: Domain,
    tolerance: f64,
) -> Result<(), CertifyError> {
    let constants = metric.constants();
    let values = [
        constants.c1(),
        constants.c2(),
        constants.l_h(),
        constants.m_h().expect("the gallery states M_H"),
    ];
    for ((quantity, value), stated) in Quantity::ALL.into_iter().zip(values).zip(stated) {
        let found = certify(&metric, quantity, &domain, Accuracy { tolerance, budget: 300_000 })?;
        let holds = match (stated, quantity) {
            // The closed form itself is rounded, by a few ε.
            (Exact, _) => {
                found.lower <= value * (1.0 + 1e-14) && value * (1.0 - 1e-14) <= found.upper
            }
            (Bound, Quantity::C1) => value <= found.upper,
            (Bound, _) => found.lower <= value,
        };
        assert!(holds, "{quantity} = {value}: {found:?}");
        // The relaxations are exact, except for M_H in three dimensions.
        assert!(found.looseness() <= 1.0 + 2.0 * tolerance || D == 3, "{quantity}: {found:?}");
    }
    Ok(())
}

/// Returns all of space if the metric is periodic or settles, and the cell otherwise.
fn space<const D: usize>(metric: &impl Bounded<D>, [low, high]: [[f64; D]; 2]) -> Domain {
    let space = Domain::space(metric);
    if space.is_all_of_space() {
        return space;
    }
    let cell = || Domain::cell(Cell::new(low, high).expect("in order"));
    Domain::settled_space(metric).unwrap_or_else(|_| cell())
}

/// Every sample of the gallery, to within a twentieth. The table of proved constants has closer
/// bounds.
mod samples {
    use super::*;

    macro_rules! sample_constants_are_proved {
        ($(
            $id:ident: $name:literal, $metric:expr, dimension $D:literal, in $cell:expr,
            exact $exact:expr $(, with $distances:ident)?;
        )*) => {$(
            #[test]
            fn $id() {
                let metric = $metric.expect("in range");
                let stated = $exact.map(|exact: bool| if exact { Exact } else { Bound });
                let domain = space::<$D>(&metric, $cell);
                check::<$D>(metric, stated, domain, 5e-2).expect("within the budget");
            }
        )*};
    }

    for_each_sample!(sample_constants_are_proved);
}

macro_rules! stated_constants_are_proved {
    ($($name:ident: $metric:expr, $d:literal, $stated:expr, $tolerance:expr;)*) => {$(
        #[test]
        fn $name() {
            let metric = $metric.expect("parameters in range");
            let domain = space::<$d>(&metric, [[-1.0; $d], [1.0; $d]]);
            check::<$d>(metric, $stated, domain, $tolerance).expect("within the budget");
        }
    )*};
}

const ALL: [Stated; 4] = [Exact; 4];
const VALLEYS: Result<Valleys, GalleryError> = Ok(Valleys);
const COUPLED_COSINES: Result<CoupledCosines, GalleryError> = Ok(CoupledCosines);

stated_constants_are_proved! {
    valleys_on_the_line: VALLEYS, 1, ALL, 1e-4;
    valleys_in_the_plane: VALLEYS, 2, ALL, 1e-4;
    valleys_in_space: VALLEYS, 3, ALL, 1e-4;
    ramp: Ramp::new(0.5, 2.0), 1, [Exact, Exact, Exact, Bound], 1e-3;
    shear: Shear::new(0.7, 1.5), 2, ALL, 1e-3;
    lens: Lens::new(1.0, 0.5), 2, ALL, 1e-2;
    bump: Bump::new(1.0, 2.0), 2, [Exact, Exact, Bound, Exact], 1e-2;
    hill: Hill::new(1.0, 1.0), 2, ALL, 1e-2;
    swirl: Swirl::new(0.5, 1.0), 2, [Exact, Exact, Bound, Bound], 1e-2;
    egg_crate: EggCrate::new(1.0, 1.0), 2, ALL, 1e-2;
    checkerboard: Checkerboard::new(1.0, 2.0), 2, ALL, 1e-3;
    rotating_anisotropy: RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5]), 2, ALL, 1e-3;
    coupled_cosines: COUPLED_COSINES, 3, [Exact, Exact, Exact, Bound], 1e-2;
    gaussian_fisher_patch: GaussianFisherPatch::new(1.0), 2, [Exact, Exact, Bound, Bound], 1e-3;
}

/// A declared constant that is too small by a thousandth is refuted.
#[test]
fn an_error_of_a_thousandth_is_detected() {
    let shear = Shear::new(0.7, 1.5).expect("a wave number");
    let stated = shear.constants().l_h();
    let accuracy = Accuracy { tolerance: 1e-4, ..Accuracy::default() };
    let found =
        certify(&shear, Quantity::LH, &Domain::space(&shear), accuracy).expect("a constant");
    assert!(found.contains(stated) && 0.999 * stated < found.lower, "{found:?}");
}
