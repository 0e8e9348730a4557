//! The povista command.

fn main() {}
