//! Axis-aligned boxes.

use glam::DVec3;

use super::Transform;

/// An axis-aligned box; may be unbounded on any side, or empty (`min > max`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lowest corner.
    pub min: DVec3,
    /// Highest corner.
    pub max: DVec3,
}

impl Bounds {
    /// Contains nothing; the neutral element of [`Bounds::union`].
    pub const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
    /// All of space; the neutral element of [`Bounds::intersection`].
    pub const ALL: Self = Self { min: DVec3::NEG_INFINITY, max: DVec3::INFINITY };

    /// The box with the given opposite corners, in any order.
    pub fn new(a: DVec3, b: DVec3) -> Self {
        Self { min: a.min(b), max: a.max(b) }
    }

    /// The smallest box around `points`.
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest box around both.
    #[inline]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// What both share.
    #[inline]
    pub fn intersection(self, other: Self) -> Self {
        Self { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// Whether no point is inside.
    #[inline]
    pub fn is_empty(self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Whether the box is not empty and ends on every side.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.min.is_finite() && self.max.is_finite() && !self.is_empty()
    }

    /// The middle; not finite where the box is not.
    #[inline]
    pub fn center(self) -> DVec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// Edge lengths.
    #[inline]
    pub fn size(self) -> DVec3 {
        self.max - self.min
    }

    /// Half the surface area, the measure of the surface area heuristic.
    #[inline]
    pub fn half_area(self) -> f64 {
        let s = self.size();
        s.x * s.y + s.y * s.z + s.z * s.x
    }

    /// Whether `p` is inside or on the border.
    #[inline]
    pub fn contains(self, p: DVec3) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// The eight corners.
    pub fn corners(self) -> [DVec3; 8] {
        let (DVec3 { x: a, y: b, z: c }, DVec3 { x: p, y: q, z: r }) = (self.min, self.max);
        [
            DVec3::new(a, b, c),
            DVec3::new(p, b, c),
            DVec3::new(a, q, c),
            DVec3::new(p, q, c),
            DVec3::new(a, b, r),
            DVec3::new(p, b, r),
            DVec3::new(a, q, r),
            DVec3::new(p, q, r),
        ]
    }

    /// A box around the image of this one; all of space where this one is unbounded.
    pub fn transformed(self, by: &Transform) -> Self {
        if self.is_empty() {
            Self::EMPTY
        } else if by.is_identity() {
            self
        } else if self.is_finite() {
            // Coordinates of corners are sums of what each axis adds. Rounding keeps order, so the least is the sum of
            // the least, to the bit.
            let columns = by.forward.matrix3;
            let (mut min, mut max) = (DVec3::ZERO, DVec3::ZERO);
            for (axis, column) in [columns.x_axis, columns.y_axis, columns.z_axis].into_iter().enumerate() {
                let (low, high) = (column * self.min[axis], column * self.max[axis]);
                (min, max) = (min + low.min(high), max + low.max(high));
            }
            Self { min: min + by.forward.translation, max: max + by.forward.translation }
        } else {
            Self::ALL
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn union_and_intersection_have_their_neutral_elements() {
        let cube = Bounds::new(DVec3::ONE, -DVec3::ONE);
        assert_eq!(cube.union(Bounds::EMPTY), cube);
        assert_eq!(cube.intersection(Bounds::ALL), cube);
        assert!(cube.intersection(Bounds::new(DVec3::splat(2.0), DVec3::splat(3.0))).is_empty());
        assert!(Bounds::EMPTY.is_empty() && !Bounds::ALL.is_empty() && !Bounds::ALL.is_finite());
    }

    #[test]
    fn a_box_around_the_image_is_that_of_the_corners() {
        let mut number = crate::math::dice::numbers(5);
        for _ in 0..1000 {
            let mut point = || 7.0 * DVec3::new(number(), number(), number());
            let by = Transform::rotate(90.0 * point()).then(&Transform::scale(point()));
            let by = by.then(&Transform::translate(point()));
            let bounds = Bounds::new(point(), point());
            assert_eq!(bounds.transformed(&by), Bounds::of(bounds.corners().map(|c| by.point(c))));
        }
    }

    #[test]
    fn a_turned_cube_needs_a_larger_box() {
        let turned = Bounds::new(-DVec3::ONE, DVec3::ONE).transformed(&Transform::rotate(DVec3::Z * 45.0));
        assert!(turned.max.abs_diff_eq(DVec3::new(2f64.sqrt(), 2f64.sqrt(), 1.0), 1e-14));
    }
}
