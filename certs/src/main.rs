//! The `homeo-check` command.

fn main() {}
