//! Tests of the projection: facts known by hand, generated shells, real shells.

// Equality of doubles is what these tests mean where they say so.
#![allow(clippy::float_cmp)]

mod batch;
mod facts;
mod float;
mod generate;
mod hostile;
mod images;
mod properties;
mod real;
mod section;
mod transfer;
