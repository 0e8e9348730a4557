//! Renders the same scenes with POV-Ray and with povista, both driven by command line as a user
//! drives them, and judges how far the pictures agree.
//!
//! - [`scene`]: which scenes there are and the switches each is rendered with
//! - [`parallel`]: several pieces of work at once
//! - [`process`]: one run of a program under limits of time and memory
//! - [`program`]: a renderer, and what became of one scene in it
//! - [`numbers`]: what a scene prints, to the last digit
//! - [`reading`]: scenes read by povista and not rendered
//! - [`cache`]: POV-Ray's pictures, kept by the content they depend on
//! - [`picture`]: 8-bit pixels, the figures of a comparison, the heat map
//! - [`verdict`]: the rule that turns the figures into a verdict
//! - [`timing`]: the two programs timed in turn, with nothing beside
//! - [`suite`]: many scenes side by side
//! - [`expectations`]: which scenes are known not to match, and why
//! - [`report`]: the table, the JSON and the HTML page
//!
//! A module uses only those above it. No povista crate is used: what is judged is the program that
//! is installed.

pub mod cache;
pub mod expectations;
pub mod numbers;
pub mod parallel;
pub mod picture;
pub mod process;
pub mod program;
pub mod reading;
pub mod report;
pub mod scene;
pub mod suite;
pub mod timing;
pub mod verdict;
