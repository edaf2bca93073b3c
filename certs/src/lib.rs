//! The certificate checker.
