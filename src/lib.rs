//! povista renders POV-Ray scene files: the same picture as POV-Ray 3.7, sounder and faster.
//!
//! # The way of a scene
//!
//! ```text
//! text ─source─▶ Source ─syntax─▶ Tree ─interp─▶ Scene ─compile─▶ World ─render─▶ Image
//! ```
//!
//! | stage | entry | from → to | it never |
//! | --- | --- | --- | --- |
//! | [`source`] | [`Library::open`](source::Library::open) | files → text with ids and spans | lets anything else find a file of the scene's |
//! | [`syntax`] | [`syntax::parse`] | text → a [`Tree`](syntax::Tree) of tokens, directives linked | runs anything, knows a keyword of POV-Ray's |
//! | [`interp`] | [`interp::interpret`] | trees → values → [`scene::Scene`] | renders, except to answer `trace()`, `inside()` and extents |
//! | [`compile`] | [`compile::compile`] | [`scene::Scene`] → [`world::World`] | keeps what the scene doesn't need |
//! | [`render`] | [`render::render`] | [`world::World`] → picture and statistics | prints, or gives another picture with another number of threads |
//!
//! Between the stages stand two kinds of data: [`scene`] is the description, plain and without names; [`world`]
//! is what is compiled from it, immutable and without spans, where nothing can fail any more. They don't know each
//! other. [`cli`] joins the stages for the command line; `main.rs` alone prints.
//!
//! ```
//! use povista::{compile, diag, interp, options, render, source};
//!
//! let mut sources = source::Sources::new(source::Library::default());
//! let main = sources.add(source::Source::new(
//!     "scene.pov", "",
//!     b"#version 3.7; global_settings { assumed_gamma 1 }
//!       camera { location -3*z } light_source { <-5, 5, -5> rgb 1 } sphere { 0, 1 pigment { rgb <1, 0.5, 0> } }".to_vec(),
//! ));
//! let mut sink = diag::Collect::default();
//! let scene = interp::interpret(main, &mut sources, &options::LanguageOptions::default(), &mut sink)
//!     .expect("this scene has no errors");
//! let options = options::RenderOptions::new(32, 24);
//! let compiled = compile::compile(scene, &options);
//! let rendered = render::render(&compiled.world, &options, &());
//! let [red, green, blue, _] = rendered.image.pixels[32 * 12 + 16];
//! assert!(red > green && green > blue);
//! ```
//!
//! # Rules that keep it simple
//!
//! - A module imports only from those before it in this order: `math · source · diag · options · syntax · fmt ·
//!   scene · world · compile · interp · reference · index · lint · lsp · render · cli`. `tests/layers.rs` checks it, and the length of files.
//! - A thing is in the file named after the word a user types: `world/shape/torus.rs`, `interp/statement/fog.rs`.
//! - Adding a primitive touches its file under `world/shape`, a variant in `scene/shape.rs`, an arm in
//!   `compile/shape.rs` and a reader under `interp/statement`. Patterns, lights and cameras alike.
//! - A distance along a ray means the same point in every space: directions of rays in an object's own space are not
//!   normalised. No tolerance is absolute: secondary rays start beside the surface by a bound on the rounding error.
//! - Colours are single precision, as POV-Ray keeps them; geometry is double precision.
//! - What is random is a function of pixel, sample and purpose, never of threads or time.
//! - What a scene does not need is not made: `compile` leaves it out, `render::stats` counts what ran, tests assert zeros.
//!
//! # What is kept from the first design, and what was changed
//!
//! - pest gives a flat run of tokens for a file and a small pass links directives to their arms, instead of nested
//!   groups: an arm may open a brace that another closes, and an `#if` may end in another file, so that no grammar of
//!   nested blocks is true of all scenes.
//! - Textures keep the transforms of the objects around them apart from their own, so that a copy of an object shares
//!   its textures however it is moved.
//!
//! `docs/spec` is the description of POV-Ray's behaviour that everything here is built from and refers to.

pub mod cli;
pub mod compile;
pub mod diag;
pub mod fmt;
pub mod index;
pub mod interp;
pub mod lint;
pub mod lsp;
pub mod math;
pub mod options;
pub mod reference;
pub mod render;
pub mod scene;
pub mod source;
pub mod syntax;
pub mod world;

pub use interp::check::{Checked, check};
