//! Tests of the projection: facts known by hand, generated shells, real shells.

mod facts;
mod float;
mod generate;
mod hostile;
mod properties;
mod real;
mod section;
mod transfer;
