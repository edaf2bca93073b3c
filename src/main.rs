//! The `homeo` command.

fn main() {}
