//! The cylinder x² + y² = 1 between z = 0 and z = 1, and how it is seen.

use super::{Border, Side, Sight};
use crate::math::DVec3;

/// Directions that differ less than this from a border, in the cylinder's own space, may be on either side.
const BLUR: f64 = 1e-7;

/// From nearer to it, or farther away, the cylinder's borders are not known.
const NEAR: f64 = 1e-5;
const FAR: f64 = 1e4;

/// Adds the borders of the cylinder; `sight` is in its own space. `false` where they are not known.
pub(super) fn look(sight: &Sight, border: &mut Border) -> bool {
    let from = sight.from;
    let square = from.x * from.x + from.y * from.y;
    if !(square > 1.0 + NEAR && from.abs().max_element() < FAR) {
        return false;
    }
    let distance = square.sqrt();
    // Across the cylinder: towards the axis, and to the side.
    let toward = DVec3::new(-from.x, -from.y, 0.0);
    let side = DVec3::new(from.y, -from.x, 0.0);
    // Ways get so far towards the axis where the cylinder begins and ends, and between the points where
    // ways touch it.
    let (begin, end, touch) = (square - distance, square + distance, square - 1.0);
    let farthest = sight.farthest();
    let mut add = |normal: DVec3, constant: f64, which| {
        border.add(normal, constant, BLUR * (normal.length() * farthest + constant.abs()), which);
    };
    let slope = touch.sqrt();
    add(toward + slope * side, 0.0, Side::Both);
    add(toward - slope * side, 0.0, Side::Both);
    // How far the end is above, and how far below.
    for (room, up) in [(1.0 - from.z, 1.0), (from.z, -1.0)] {
        let outermost = if room > 0.0 { begin } else { end };
        add(room * toward - (up * outermost) * DVec3::Z, 0.0, Side::Outer);
        add(room * toward - (up * touch) * DVec3::Z, 0.0, Side::Inner);
    }
    add(toward, -begin, Side::Outer);
    add(toward, -touch, Side::Inner);
    true
}
