//! Strategies and properties.
