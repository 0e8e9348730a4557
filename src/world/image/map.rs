//! `image_map`, `bump_map`, `image_pattern`, `material_map`: finding and reading the pixel
//! (docs/spec/patterns-textures.md 6.2 … 6.6 and 4.5).

use std::f64::consts::{PI, TAU};
use std::ops::{Add, Mul, Neg};
use std::sync::Arc;

use super::{Image, Pixels};
use crate::math::color::grey;
use crate::math::noise::EPSILON;
use crate::math::{DVec2, DVec3, Rgbft, tally};
use crate::world::warp::mapping::{around_tube, longitude};

/// An image laid over space.
#[derive(Clone, Debug)]
pub struct ImageMap {
    /// The pixels.
    pub image: Arc<Image>,
    /// Where they go.
    pub projection: Projection,
    /// How to read between pixels.
    pub interpolation: Interpolation,
    /// There is nothing outside the image.
    pub once: bool,
    /// Width and height of the unit square in pixels.
    pub scale: DVec2,
    /// Added to the position, in pixels.
    pub offset: DVec2,
    /// Added to filter and transmit of images without a palette.
    pub clearness: [f32; 2],
    /// `use_index`: palette indices serve as heights.
    pub use_index: bool,
    /// `use_alpha` of `image_pattern`.
    pub use_alpha: bool,
}

/// `map_type`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the usual names")]
pub enum Projection {
    Planar,
    Spherical,
    Cylindrical,
    Torus,
}

/// `interpolate`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the usual names")]
pub enum Interpolation {
    None,
    Bilinear,
    Bicubic,
    NormalizedDistance,
}

impl ImageMap {
    /// The colour at `p`; `None` outside a `once` image.
    pub fn color(&self, p: DVec3) -> Option<Rgbft> {
        let mut color = self.stored_color(self.position(p)?);
        if self.image.premultiplied {
            let alpha = 1.0 - color.transmit;
            if f64::from(alpha) > EPSILON {
                color.rgb /= alpha;
            }
        }
        Some(color)
    }

    /// `image_pattern`: grey or alpha at `p`, 0 … 1; 0 outside.
    pub fn pattern_value(&self, p: DVec3) -> f64 {
        let Some(at) = self.position(p) else { return 0.0 };
        let color = self.stored_color(at);
        let value = match (self.use_alpha, self.image.has_alpha) {
            (false, _) => grey(color.rgb),
            (true, true) => color.transmit,
            (true, false) => color.rgb.x,
        };
        f64::from(value).clamp(0.0, 1.0)
    }

    /// `material_map`: which of `count` textures is meant at `p`.
    pub fn material(&self, p: DVec3, count: usize) -> usize {
        let last = count.saturating_sub(1);
        let Some(at) = self.position(p) else { return 0 };
        let index = match self.index(at) {
            -1 => (f64::from(self.stored_color(at).rgb.x) * 255.0) as i64,
            index => index,
        };
        let index = usize::try_from(index).unwrap_or(0);
        if index > count { index % count.max(1) } else { index.min(last) }
    }

    /// `bump_map`: the unit normal `n` at `p`, bent; not unit.
    pub fn bend(&self, p: DVec3, n: DVec3, amount: f64) -> DVec3 {
        let Some(at) = self.position(p) else { return n };
        let (width, height) = (self.image.width as f64, self.image.height as f64);
        let once_around = |c: f64, size: f64| {
            if c < 0.0 {
                c + size
            } else if c >= size {
                c - size
            } else {
                c
            }
        };
        let left = DVec2::new(once_around(at.x - 1.0, width), once_around(at.y + 1.0, height));
        let right = DVec2::new(once_around(left.x + 2.0, width), left.y);
        let [h1, h2, h3] = [at, left, right].map(|at| amount * self.height(at));

        // The normal of the triangle through the three heights.
        let (p1, p2, p3) = (DVec3::new(0.0, h1, 0.0), DVec3::new(-1.0, h2, 1.0), DVec3::new(1.0, h3, 1.0));
        let bump = (p3 - p2).cross(p1 - p2).normalize_or_zero();

        // Turn it into the surface's frame.
        let mut up = n;
        let mut across = n.cross(DVec3::Y);
        if across.length() < EPSILON {
            up = if (n.y - 1.0).abs() < EPSILON { DVec3::Y } else { -DVec3::Y };
            across = DVec3::X;
        } else {
            across = across.normalize();
        }
        let along = across.cross(up).normalize_or_zero();
        bump.x * across + bump.y * up - bump.z * along
    }

    fn height(&self, at: DVec2) -> f64 {
        if self.use_index && matches!(self.image.pixels, Pixels::Palette { .. }) {
            return self.index(at) as f64;
        }
        f64::from(grey(self.stored_color(at).rgb))
    }

    /// Where in the image `p` is: pixels from the left and from the top, inside the image.
    fn position(&self, p: DVec3) -> Option<DVec2> {
        tally::image_lookups(1);
        let outside = |c: f64| self.once && !(0.0..=1.0).contains(&c);
        let size = self.scale;
        let at = match self.projection {
            Projection::Planar if outside(p.x) || outside(p.y) => return None,
            Projection::Planar => DVec2::new(rest(p.x * size.x, size.x), rest(p.y * size.y, size.y)),
            Projection::Spherical => {
                let distance = p.length();
                if distance == 0.0 {
                    return None;
                }
                let q = p / distance;
                let turn = if q.x == 0.0 && q.z == 0.0 { 0.0 } else { longitude(q.x, q.z) / TAU };
                DVec2::new(turn * size.x, (0.5 + q.y.asin() / PI) * size.y)
            }
            Projection::Cylindrical => {
                if outside(p.y) || p.x == 0.0 && p.z == 0.0 {
                    return None;
                }
                let q = p / p.length();
                DVec2::new(longitude(q.x, q.z) / TAU * size.x, rest(p.y * size.y, size.y))
            }
            Projection::Torus if p.x == 0.0 && p.z == 0.0 => return None,
            Projection::Torus => {
                let (around, distance) = around_tube(p, 1.0);
                // On the core circle there is no angle.
                let around = if distance == 0.0 { 0.0 } else { around };
                DVec2::new(longitude(p.x, p.z) / TAU * size.x, around * size.y)
            }
        };
        let at = at + self.offset + EPSILON;
        let (width, height) = (self.image.width as f64, self.image.height as f64);
        if self.once && !((0.0..width).contains(&at.x) && (0.0..height).contains(&at.y)) {
            return None;
        }
        Some(DVec2::new(wrap(at.x, width), wrap(-at.y, height)))
    }

    /// The colour at a position in the image, as the file stores it.
    fn stored_color(&self, at: DVec2) -> Rgbft {
        let mut sums = [0.0; 5];
        if self.interpolation == Interpolation::None {
            // What is inside the image is rounded down where the pixel is looked up.
            return self.pixel(at.x, at.y);
        }
        self.neighbours(at, |x, y, weight| {
            for (sum, component) in sums.iter_mut().zip(self.pixel(x, y).to_array()) {
                *sum += weight * f64::from(component);
            }
        });
        Rgbft::new(sums.map(|sum| sum as f32))
    }

    /// The palette index at a position in the image. Without a palette every pixel counts as -1,
    /// which weights that don't add up to 1 exactly turn into 0, as in POV-Ray.
    fn index(&self, at: DVec2) -> i64 {
        let of_pixel = |x, y| {
            let (x, y) = self.inside(x, y);
            self.image.index(x, y).map_or(-1.0, f64::from)
        };
        if self.interpolation == Interpolation::None {
            return of_pixel(at.x.trunc(), at.y.trunc()) as i64;
        }
        let mut sum = 0.0;
        self.neighbours(at, |x, y, weight| sum += weight * of_pixel(x, y));
        sum as i64
    }

    /// Calls `each` with the pixels around a position and their weights.
    fn neighbours(&self, at: DVec2, mut each: impl FnMut(f64, f64, f64)) {
        let (a, b) = (at.x + 0.5, at.y + 0.5);
        let (i, j) = (a.trunc(), b.trunc());
        let (p, q) = (a - i, b - j);
        let (p1, q1) = (1.0 - p, 1.0 - q);
        let mut square = |w: [f64; 4]| {
            each(i, j, w[0]);
            each(i - 1.0, j, w[1]);
            each(i, j - 1.0, w[2]);
            each(i - 1.0, j - 1.0, w[3]);
        };
        match self.interpolation {
            Interpolation::None => each(at.x.trunc(), at.y.trunc(), 1.0),
            Interpolation::Bilinear => square([p * q, p1 * q, p * q1, p1 * q1]),
            Interpolation::NormalizedDistance => {
                let (pp, qq, pp1, qq1) = (p * p, q * q, p1 * p1, q1 * q1);
                let near = [pp1 + qq1, pp + qq1, pp1 + qq, pp + qq].map(f64::recip);
                let sum = near[0] + near[1] + near[2] + near[3];
                if sum.is_finite() {
                    square(near.map(|w| w / sum));
                } else {
                    // Exactly at a pixel's centre.
                    square(near.map(|w| f64::from(w.is_infinite())));
                }
            }
            Interpolation::Bicubic => {
                let (across, down) = (cubic_weights(p), cubic_weights(q));
                for (k, across) in (-2..).zip(across) {
                    for (l, down) in (-2..).zip(down) {
                        each(i + f64::from(k), j + f64::from(l), across * down);
                    }
                }
            }
        }
    }

    /// The colour of the pixel with these whole coordinates, which may lie outside.
    pub(super) fn pixel(&self, x: f64, y: f64) -> Rgbft {
        let (x, y) = self.inside(x, y);
        let mut color = self.image.color(x, y);
        color.filter += self.clearness[0];
        color.transmit += self.clearness[1];
        color
    }

    fn inside(&self, x: f64, y: f64) -> (usize, usize) {
        let (width, height) = (self.image.width as f64, self.image.height as f64);
        if self.once {
            (x.clamp(0.0, width - 1.0) as usize, y.clamp(0.0, height - 1.0) as usize)
        } else {
            (wrap(x, width) as usize, wrap(y, height) as usize)
        }
    }
}

/// The weights of four neighbours, of numbers or of what holds them.
pub(super) fn cubic_weights<N>(p: N) -> [N; 4]
where
    N: Copy + Neg<Output = N> + Mul<Output = N> + Mul<f64, Output = N> + Add<f64, Output = N>,
{
    let q = -p + 1.0;
    [
        p * q * q * -0.5,
        q * (q * (p * 3.0 + 1.0) + 1.0) * 0.5,
        p * (p * (q * 3.0 + 1.0) + 1.0) * 0.5,
        q * p * p * -0.5,
    ]
}

/// `a % n`, which most often is `a`: dividing takes long.
#[inline]
fn rest(a: f64, n: f64) -> f64 {
    // A call: a division that may be done without harm is done whether it is needed or not.
    #[cold]
    #[inline(never)]
    fn divided(a: f64, n: f64) -> f64 {
        a % n
    }
    if a.abs() < n { a } else { divided(a, n) }
}

/// `a` modulo `n`, in 0 … n; never `n` itself.
fn wrap(a: f64, n: f64) -> f64 {
    let mut wrapped = rest(a, n);
    if wrapped < 0.0 {
        wrapped += n;
    }
    if wrapped < n { wrapped } else { 0.0 }
}
