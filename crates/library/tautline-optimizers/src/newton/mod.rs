//! Newton steps: the energy and its derivatives, the factorisation of the Hessian, and the step.

pub(crate) mod arithmetic;
pub(crate) mod chain;
pub(crate) mod discrete_energy;
pub(crate) mod end_frame;
pub(crate) mod factorization;
pub(crate) mod front;
pub(crate) mod magnitude;
pub(crate) mod memory;
pub(crate) mod newton_pass;
pub(crate) mod newton_step;
pub(crate) mod pairs;
pub(crate) mod reduced_system;
pub(crate) mod residual;
pub(crate) mod rounding;
pub(crate) mod side;
pub(crate) mod stationarity;
pub(crate) mod sweep;
pub(crate) mod twisted_factorization;
pub(crate) mod two_threads;
pub(crate) mod workspace;
