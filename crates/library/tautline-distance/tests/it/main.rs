//! Proposals of certificates, each checked by the checker.

mod attempt;
mod constant_metrics;
mod curved_metrics;
mod exchange;
mod flat;
mod limits;
mod refused;
mod work;
