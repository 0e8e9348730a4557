//! The tests every shape is put under: enrol one with a line of [`battery!`].
//!
//! Each line makes the shape at a size, and where it can be told a place; rays from near and far, from
//! inside and grazing, are shot at it. What may fail is bounded by a rate, printed with `--nocapture`.
//! Rays are numbered: a failure names the one to run again.

mod checks;
mod oracle;
mod probe;

pub(crate) use oracle::oracle;
pub(crate) use probe::{Probe, table, uv};

use super::Shape;
use crate::math::DVec3;
use checks::Tally;

/// Enrols shapes: `name: |size, at| expression;`, where `at` or both may be left out (`|size|`, `||`).
/// `, surface` after it says that crossings don't
/// alternate between in and out, `, inward` that normals point to the inside.
macro_rules! battery {
    (@) => {};
    (@ $name:ident: |$size:ident, $at:ident| $make:expr $(, $kind:ident)?; $($rest:tt)*) => {
        #[test]
        fn $name() {
            let make = |$size: f64, $at: crate::math::DVec3| -> Box<dyn Shape> { Box::new($make) };
            Battery { kind: stringify!($($kind)?), sizes: &SIZES, places: &PLACES }.run(make);
        }
        battery! { @ $($rest)* }
    };
    (@ $name:ident: |$size:ident| $make:expr $(, $kind:ident)?; $($rest:tt)*) => {
        #[test]
        fn $name() {
            let make = |$size: f64, _| -> Box<dyn Shape> { Box::new($make) };
            Battery { kind: stringify!($($kind)?), sizes: &SIZES, places: &[0.0] }.run(make);
        }
        battery! { @ $($rest)* }
    };
    (@ $name:ident: || $make:expr $(, $kind:ident)?; $($rest:tt)*) => {
        #[test]
        fn $name() {
            let make = |_, _| -> Box<dyn Shape> { Box::new($make) };
            Battery { kind: stringify!($($kind)?), sizes: &[1.0], places: &[0.0] }.run(make);
        }
        battery! { @ $($rest)* }
    };
    ($name:ident: $($rest:tt)*) => {
        #[allow(unused_imports, reason = "each line of the macro needs some of them")]
        mod enrolled {
            use super::*;
            use crate::world::shape::battery::{Battery, PLACES, SIZES, battery};
            battery! { @ $name: $($rest)* }
        }
    };
}
pub(crate) use battery;

/// The sizes a shape is made in.
pub(crate) const SIZES: [f64; 5] = [1e-8, 1e-4, 1.0, 1e4, 1e8];

/// How far from the origin, in its own size, a shape is put.
pub(crate) const PLACES: [f64; 3] = [0.0, 1e3, 1e6];

/// Rays to a shape, size and place.
const RAYS: u64 = 1500;

/// What a line of [`battery!`] asks for.
pub(crate) struct Battery<'a> {
    /// `surface` or `inward` as written, else empty.
    pub(crate) kind: &'a str,
    pub(crate) sizes: &'a [f64],
    pub(crate) places: &'a [f64],
}

impl Battery<'_> {
    /// Shoots at what `make` makes in all sizes and places.
    pub(crate) fn run(&self, make: impl Fn(f64, DVec3) -> Box<dyn Shape>) {
        for &size in self.sizes {
            for &place in self.places {
                let at = DVec3::new(1.0, -0.7, 0.4) * place * size;
                let shape = make(size, at);
                assert!(
                    self.kind != "surface" || !shape.is_closed(),
                    "crossings of what is closed alternate"
                );
                let mut tally = Tally::new(&*shape, size, at, self.kind);
                for number in 0..RAYS {
                    tally.shoot(number);
                }
                tally.shoot_nonsense();
                tally.judge();
            }
        }
    }
}

/// Numbers evenly spread over 0 … 1 that depend on nothing but a counter.
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(number: u64) -> Self {
        Self(number.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (x ^ (x >> 31)) as f64 / u64::MAX as f64
    }

    /// Evenly in the cube from -1 to 1.
    pub(crate) fn cube(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }
}
