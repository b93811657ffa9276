//! The metrics of the gallery and the compositions of metrics: values, laws and proved constants.

mod about;
mod composition;
mod gallery;
mod laws;
mod measure;
