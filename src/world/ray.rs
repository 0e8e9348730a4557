//! Rays and the stretch of them that counts.

use crate::math::{DVec3, Lanes, Transform};

/// A half-line. World-space rays have unit directions; in an object's space the direction keeps
/// whatever length the transform gives it, so a distance `t` means the same point in every space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
}

impl Ray {
    /// A ray as given.
    #[inline]
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction }
    }

    /// The point at distance `t`.
    #[inline]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// The distance at which the ray passes `center`, and the ray starting there.
    ///
    /// Solving from there instead of from a far origin keeps the digits that `origin - center` would
    /// eat; the new origin is rounded only once.
    #[inline]
    pub fn moved_to(&self, center: DVec3) -> (f64, Self) {
        let t = (center - self.origin).dot(self.direction) / self.direction.length_squared();
        if !t.is_finite() {
            return (0.0, *self);
        }
        (t, Self { origin: self.direction.mul_add(DVec3::splat(t), self.origin), direction: self.direction })
    }

    /// The same ray in the inner space of `transform`.
    #[inline]
    pub fn to_inner(&self, transform: &Transform) -> Self {
        Self {
            origin: transform.inverse_point(self.origin),
            direction: transform.inverse_vector(self.direction),
        }
    }
}

/// Four rays side by side.
#[derive(Clone, Copy, Debug)]
pub struct Rays {
    /// Where they start, by axes.
    pub origin: [Lanes; 3],
    /// Where they go.
    pub direction: [Lanes; 3],
}

impl Rays {
    /// Makes directions unit that have a length.
    #[inline(always)]
    pub fn normalize(&mut self) {
        let inverse = Lanes::splat(1.0) / Lanes::dot(&self.direction, &self.direction).sqrt();
        for direction in &mut self.direction {
            *direction = *direction * inverse;
        }
    }

    /// The same rays in the inner space of `transform`.
    #[inline(always)]
    pub fn to_inner(&self, transform: &Transform) -> Self {
        Self {
            origin: transform.inverse_points(&self.origin),
            direction: transform.inverse_vectors(&self.direction),
        }
    }

    /// Puts four rays side by side.
    #[inline(always)]
    pub fn of(rays: &[Ray; Lanes::COUNT]) -> Self {
        let mut all = Self { origin: [Lanes::ZERO; 3], direction: [Lanes::ZERO; 3] };
        for (lane, ray) in rays.iter().enumerate() {
            for axis in 0..3 {
                all.origin[axis].0[lane] = ray.origin[axis];
                all.direction[axis].0[lane] = ray.direction[axis];
            }
        }
        all
    }

    /// One of them.
    #[inline(always)]
    pub fn ray(&self, lane: usize) -> Ray {
        let vector = |[x, y, z]: &[Lanes; 3]| DVec3::new(x.0[lane], y.0[lane], z.0[lane]);
        Ray { origin: vector(&self.origin), direction: vector(&self.direction) }
    }
}

/// The open interval of distances in which crossings count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end, excluded.
    pub min: f64,
    /// Upper end, excluded.
    pub max: f64,
}

impl Range {
    /// Everything in front of the origin.
    pub const AHEAD: Self = Self { min: 0.0, max: f64::INFINITY };
    /// Nothing, as a start for ends that grow.
    pub const EMPTY: Self = Self { min: f64::INFINITY, max: f64::NEG_INFINITY };
    /// The whole line.
    pub const LINE: Self = Self { min: f64::NEG_INFINITY, max: f64::INFINITY };

    /// Whether `t` is strictly inside.
    #[inline]
    pub fn contains(self, t: f64) -> bool {
        self.min < t && t < self.max
    }
}
