//! Renders the same scenes with POV-Ray and povista and reports the differences.

fn main() {}
