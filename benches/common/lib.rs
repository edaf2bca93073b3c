//! What the benches and the cross-validation share: generated shells, real shells, the CGAL programs, turns and ratios,
//! tables, plots.

pub mod built;
pub mod cgal;
pub mod generate;
pub mod plot;
pub mod prism;
pub mod quads;
pub mod random;
pub mod ratio;
pub mod real;
pub mod results;
pub mod run;
pub mod subject;
pub mod table;
