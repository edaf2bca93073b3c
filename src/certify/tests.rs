//! Tests of the certifier.
