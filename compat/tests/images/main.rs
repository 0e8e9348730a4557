//! Image files of every format, made here, as both programs read them: the numbers of every pixel.
//!
//! Not compared is what POV-Ray 3.7 cannot read, though it means to: grey PNGs with a transparent
//! colour and TIFFs of fewer than 8 bits (it crashes), BMPs of 1 bit (one colour) and top-down ones, IFF (an
//! error for every file), runs of a TGA that go on into the next row and jumps in a packed BMP
//! (pixels of another colour), interlaced GIFs (rows out of order), HDRs that start at the bottom (upside down).

mod cases;
mod laid;
mod photographic;
mod portable;
mod screen;

pub(crate) use cases::{Cases, HEIGHT, Noise, WIDTH};
