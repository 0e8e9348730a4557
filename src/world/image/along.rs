//! Images along lines: bounds of what they show, for surfaces that functions of them make.

use super::map::{ImageMap, Interpolation, Projection, cubic_weights};
use super::{Image, Pixels};
use crate::math::color::grey;
use crate::math::noise::EPSILON;
use crate::math::{Band, Lanes, Rgb, Rgbft};
use crate::world::warp::mapping::{around_tube_along, height_along, turn_along};

/// A number made of a colour; linear.
pub(crate) type Of<'a> = &'a dyn Fn(&Rgbft) -> f64;

/// More than single precision takes from a colour's components, as a share of the largest.
pub(crate) const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// So many pixels are looked at one by one.
const PIXELS: f64 = 1024.0;

/// How far beyond the pixels around it the `bicubic` interpolation goes, as a share of their range: its negative
/// weights are an eighth each way, along both axes.
const BEYOND: f64 = 0.3;

/// Where alpha may be less, little is said of what is divided by it.
const FAINT: f64 = 1e-4;

/// Beside the border of a pixel either is meant.
const ROOM: f64 = 1e-9;

/// Where in the image a place may be.
struct Position {
    x: Band,
    y: Band,
    /// Above 0 where it may be outside, and above 0 where it may be inside.
    outside: Lanes,
    inside: Lanes,
}

/// The grey of a colour, without its rounding.
pub(crate) fn greyness(color: &Rgbft) -> f64 {
    [Rgb::X, Rgb::Y, Rgb::Z].map(|axis| f64::from(grey(axis)) * f64::from(color.rgb.dot(axis))).iter().sum()
}

/// What holds both, in each lane, or either where the other has no place.
fn both(inside: Band, outside: Band, position: &Position) -> Band {
    let mixed = inside.hull(outside).where_positive(position.outside, inside);
    mixed.where_positive(position.inside, outside)
}

impl ImageMap {
    /// What holds [`Self::pattern_value`] at all points that these hold.
    pub(crate) fn pattern_along(&self, p: &[Band; 3]) -> Band {
        let of: Of = match (self.use_alpha, self.image.has_alpha) {
            (false, _) => &greyness,
            (true, true) => &|color| f64::from(color.transmit),
            (true, false) => &|color| f64::from(color.rgb.x),
        };
        let (zero, one) = (Band::constant(0.0), Band::constant(1.0));
        let position = self.position_along(p);
        let value = self.shown(&position, of).max(zero).min(one);
        both(value, zero, &position)
    }

    /// What holds a number made of the colours at all points that these hold; outside a `once` image that of
    /// `clear`.
    pub(crate) fn colors_along(&self, p: &[Band; 3], clear: &Rgbft, of: Of) -> Band {
        let position = self.position_along(p);
        let interpolated = self.interpolation != Interpolation::None;
        let shown = match (self.image.premultiplied, interpolated) {
            (false, _) => self.shown(&position, of),
            (true, false) => self.shown(&position, &|color| {
                let alpha = 1.0 - color.transmit;
                let mut color = *color;
                if f64::from(alpha) > EPSILON {
                    color.rgb /= alpha;
                }
                of(&color)
            }),
            (true, true) => self.divided(&position, of),
        };
        let (clear, room) = (of(clear), ROUNDING * of(clear).abs());
        both(shown, Band::between(clear - room, clear + room), &position)
    }

    /// What is shown where colours between pixels are divided by their alpha.
    fn divided(&self, position: &Position, of: Of) -> Band {
        let multiplied = self.shown(position, &|color| of(&Rgbft { filter: 0.0, transmit: 0.0, ..*color }));
        let rest = self.shown(position, &|color| of(&Rgbft { rgb: Rgb::ZERO, ..*color }));
        let alpha = -self.shown(position, &|color| f64::from(color.transmit)) + 1.0;
        let alpha = Band { reach: alpha.reach + ROUNDING, ..alpha };
        // No alpha but 0 is less than the step of single precision below 1.
        let finest = 2.0 / f64::from(f32::EPSILON);
        let zero = Band::constant(0.0);
        let any = (multiplied.min(zero) * finest).hull(multiplied.max(zero) * finest);
        let quotient = (multiplied / alpha).where_positive(alpha.low() - FAINT, any);
        let room = (quotient.middle.abs() + quotient.spread()) * ROUNDING;
        Band { reach: quotient.reach + room, ..quotient }.loose() + rest
    }

    /// [`Self::position`] along lines, in pixels, which may lie outside where the image repeats.
    fn position_along(&self, p: &[Band; 3]) -> Position {
        let size = self.scale;
        let [x, y, z] = *p;
        let never = Lanes::splat(-1.0);
        let mut outside = never;
        let mut inside = Lanes::splat(1.0);
        let mut limit = |c: Band, most: f64| {
            if !self.once {
                return;
            }
            let room = ROOM * most;
            let may = Lanes::splat(1.0);
            for beyond in [-c.low() + room, c.high() - most + room] {
                outside = may.where_positive(beyond, outside);
            }
            for beyond in [-c.high() - room, c.low() - most - room] {
                inside = never.where_positive(beyond, inside);
            }
        };
        // A remainder keeps the sign of what it is of.
        let wrapped = |c: Band, size: f64| (c * size).remainder(Band::constant(size));
        let (across, down) = match self.projection {
            Projection::Planar => {
                limit(x, 1.0);
                limit(y, 1.0);
                (wrapped(x, size.x), wrapped(y, size.y))
            }
            Projection::Spherical => {
                let turn = turn_along(x, z);
                let from_axis = (x.square() + z.square()).sqrt();
                let turn = turn.where_positive(from_axis.low(), turn.hull(Band::constant(0.0)));
                (turn * size.x, height_along(*p) * size.y)
            }
            Projection::Cylindrical => {
                limit(y, 1.0);
                (turn_along(x, z) * size.x, wrapped(y, size.y))
            }
            Projection::Torus => {
                let (tube, distance) = around_tube_along(*p, 1.0);
                let tube = tube.where_positive(distance.low(), tube.hull(Band::constant(0.0)));
                (turn_along(x, z) * size.x, tube * size.y)
            }
        };
        let (across, down) = (across + (self.offset.x + EPSILON), down + (self.offset.y + EPSILON));
        limit(across, self.image.width as f64);
        limit(down, self.image.height as f64);
        if self.projection != Projection::Planar {
            // On the axis there is nothing.
            let on_axis = -(x.abs().max(z.abs())).low();
            outside = Lanes::splat(1.0).where_positive(on_axis + f64::MIN_POSITIVE, outside);
        }
        let round = |c: Band, size: usize| {
            let n = size as f64;
            let turns = (c * (1.0 / n)).floor();
            // Where the image begins again anything may be shown.
            let all = Band::between(0.0, n);
            all.where_positive(turns.reach, c - turns * n)
        };
        Position { x: round(across, self.image.width), y: round(-down, self.image.height), outside, inside }
    }

    fn shown(&self, position: &Position, of: Of) -> Band {
        let shift = if self.interpolation == Interpolation::None { 0.0 } else { 0.5 };
        let (x, y) = (position.x + shift, position.y + shift);
        let mut lows = Lanes::splat(f64::NEG_INFINITY);
        let mut highs = Lanes::splat(f64::INFINITY);
        let mut single = Lanes::splat(-1.0);
        let mut cells = [(0.0, 0.0); Lanes::COUNT];
        for (lane, cell) in cells.iter_mut().enumerate() {
            let [from_x, to_x, from_y, to_y] =
                [x.low() - ROOM, x.high() + ROOM, y.low() - ROOM, y.high() + ROOM].map(|c| c.0[lane].floor());
            if from_x == to_x && from_y == to_y && self.interpolation != Interpolation::None {
                single.0[lane] = 1.0;
                *cell = (from_x, from_y);
            }
            // The pixels that are weighed, before and behind the place.
            let (before, behind) = match self.interpolation {
                Interpolation::None => (0.0, 0.0),
                Interpolation::Bicubic => (2.0, 1.0),
                _ => (1.0, 0.0),
            };
            let (columns, rows) =
                (to_x - from_x + before + behind + 1.0, to_y - from_y + before + behind + 1.0);
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            if columns * rows <= PIXELS {
                for j in 0..rows as u32 {
                    for i in 0..columns as u32 {
                        let (i, j) = (from_x - before + f64::from(i), from_y - before + f64::from(j));
                        let v = of(&self.pixel(i, j));
                        (low, high) = (low.min(v), high.max(v));
                    }
                }
            } else {
                [low, high] = self.any(of);
            }
            let beyond =
                if self.interpolation == Interpolation::Bicubic { BEYOND * (high - low) } else { 0.0 };
            let room = ROUNDING * low.abs().max(high.abs());
            (lows.0[lane], highs.0[lane]) = (low - beyond - room, high + beyond + room);
        }
        let bounds = Band::within(lows, highs);
        if (-single).all_positive() || self.interpolation == Interpolation::None {
            return bounds;
        }
        let between = self.between(x, y, &cells, of);
        // Whichever says more; what is no number says nothing.
        let narrower = bounds.spread().zip(between.spread(), |a, b| f64::from(u8::from(b < a)));
        between.where_positive(narrower.zip(single, f64::min), bounds)
    }

    /// The colours between the pixels around, where each lane is within one square of them.
    fn between(&self, x: Band, y: Band, cells: &[(f64, f64); Lanes::COUNT], of: Of) -> Band {
        let (i, j) = (Lanes(cells.map(|cell| cell.0)), Lanes(cells.map(|cell| cell.1)));
        let (p, q) = (x - Band::numbers(i), y - Band::numbers(j));
        let pixel = |k: f64, l: f64| Band::numbers(Lanes(cells.map(|(i, j)| of(&self.pixel(i + k, j + l)))));
        let (p1, q1) = (-p + 1.0, -q + 1.0);
        let value = match self.interpolation {
            Interpolation::None => return Band::UNKNOWN,
            Interpolation::Bilinear => {
                let upper = p * pixel(0.0, 0.0) + p1 * pixel(-1.0, 0.0);
                q * upper + q1 * (p * pixel(0.0, -1.0) + p1 * pixel(-1.0, -1.0))
            }
            Interpolation::NormalizedDistance => {
                let (pp, qq, pp1, qq1) = (p.square(), q.square(), p1.square(), q1.square());
                let near = [pp1 + qq1, pp + qq1, pp1 + qq, pp + qq].map(Band::inverse);
                let colors = [pixel(0.0, 0.0), pixel(-1.0, 0.0), pixel(0.0, -1.0), pixel(-1.0, -1.0)];
                let sum = near[0] + near[1] + near[2] + near[3];
                let all =
                    near[0] * colors[0] + near[1] * colors[1] + near[2] * colors[2] + near[3] * colors[3];
                all / sum
            }
            Interpolation::Bicubic => {
                let (across, down) = (cubic_weights(p), cubic_weights(q));
                let mut sum = Band::constant(0.0);
                for (l, down) in (-2..).zip(down) {
                    let mut row = Band::constant(0.0);
                    for (k, across) in (-2..).zip(across) {
                        row = row + across * pixel(f64::from(k), f64::from(l));
                    }
                    sum = sum + row * down;
                }
                sum
            }
        };
        let room = (value.middle.abs() + value.spread()) * ROUNDING;
        Band { reach: value.reach + room, ..value }.loose()
    }

    /// What all pixels of the image are between.
    fn any(&self, of: Of) -> [f64; 2] {
        let Image { pixels, .. } = &*self.image;
        if self.image.premultiplied || matches!(pixels, Pixels::Floats(_)) {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        // Every component is between 0 and 1, but for what is added.
        let units: [Rgbft; 5] = std::array::from_fn(|i| {
            let mut unit = [0.0; 5];
            unit[i] = 1.0;
            Rgbft::new(unit)
        });
        let none = of(&Rgbft::new([0.0, 0.0, 0.0, self.clearness[0], self.clearness[1]]));
        units.iter().fold([none, none], |[low, high], unit| {
            let v = of(unit);
            [low + v.min(0.0), high + v.max(0.0)]
        })
    }
}
