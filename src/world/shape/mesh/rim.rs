//! The rim of a mesh that is not closed: what is inside goes on behind it.
//!
//! A point is inside where its ray along `inside_vector` meets an odd number of faces. Between the faces that changes at
//! the points whose rays meet an edge of an odd number of faces: strips that begin at these edges and run against the
//! vector without an end.

use std::collections::HashMap;

use crate::math::DVec3;
use crate::world::{Range, Ray};

/// Coordinates are taken to be off by this share of themselves.
const ROUGH: f64 = 1e-12;

/// A part of a ray as flat against a strip as so many times that is taken to cross it.
const FLAT: f64 = 1e3;

/// The share of a part of a ray that the place where it crosses the plane of a strip may be off: what [`FLAT`] leaves.
const OFF: f64 = 4.0 / FLAT;

/// The edges at which an odd number of faces meet.
#[derive(Clone, Debug)]
pub(super) struct Rim {
    edges: Vec<[DVec3; 2]>,
}

impl Rim {
    /// Of faces by their corners; corners at one place are one.
    pub(super) fn new(faces: impl Iterator<Item = [DVec3; 3]>) -> Self {
        // Both zeros are one number.
        let place = |corner: DVec3| (corner + DVec3::ZERO).to_array().map(f64::to_bits);
        let mut odd = HashMap::new();
        for [a, b, c] in faces {
            for edge in [[a, b], [b, c], [c, a]] {
                let [p, q] = edge.map(place);
                let key = if p < q { [p, q] } else { [q, p] };
                if odd.insert(key, edge).is_some() {
                    odd.remove(&key);
                }
            }
        }
        Self { edges: odd.into_values().collect() }
    }

    /// Whether a part of a ray crosses a strip that runs from the rim against `vector`, or perhaps does.
    pub(super) fn is_passed_behind(&self, vector: DVec3, ray: &Ray, range: Range) -> bool {
        self.edges.iter().any(|edge| crosses(edge, vector, ray, range))
    }
}

/// The same for the strip of one edge.
fn crosses([from, to]: &[DVec3; 2], vector: DVec3, ray: &Ray, range: Range) -> bool {
    let along = *to - *from;
    let normal = along.cross(vector);
    let square = normal.length_squared();
    // Rays along the edge itself meet no more of one side than of the other.
    if square == 0.0 {
        return false;
    }
    let way = ray.direction * (range.max - range.min);
    let begin = ray.at(range.min) - *from;
    let [first, last] = [begin, begin + way].map(|end| end.dot(normal));
    let far = from.abs().max(ray.origin.abs()).max(way.abs()).max_element();
    let rough = ROUGH * far * normal.length();
    if first.min(last) > rough || first.max(last) < -rough {
        return false;
    }
    if (last - first).abs() <= FLAT * rough {
        return true;
    }
    // place = u along - s vector
    let place = begin + way * (first / (first - last)).clamp(0.0, 1.0);
    let u = place.cross(vector).dot(normal) / square;
    let s = -along.cross(place).dot(normal) / square;
    let off = |side: DVec3| OFF * (side.cross(way).length() + ROUGH * far * side.length()) / square.sqrt();
    let (off_u, off_s) = (off(vector), off(along));
    -off_u <= u && u <= 1.0 + off_u && s >= -off_s
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles that make a square in the x-z plane.
    fn square() -> Rim {
        let [a, b, c, d] =
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, z)| DVec3::new(x, 0.0, z));
        Rim::new([[a, b, c], [c, d, a]].into_iter())
    }

    #[test]
    fn the_edge_that_two_faces_share_is_no_rim() {
        assert_eq!(square().edges.len(), 4);
    }

    #[test]
    fn strips_run_against_the_vector() {
        let passes = |from: DVec3, to: DVec3| {
            square().is_passed_behind(DVec3::Y, &Ray::new(from, to - from), Range { min: 0.0, max: 1.0 })
        };
        let at = |x: f64, y: f64| DVec3::new(x, y, 0.3);
        assert!(passes(at(0.5, -3.0), at(1.5, -2.0)), "through a strip");
        assert!(!passes(at(0.5, 3.0), at(1.5, 2.0)), "in front of the rim");
        assert!(!passes(at(0.5, -3.0), at(0.9, -2.0)), "between strips");
        assert!(!passes(at(1.2, -3.0), at(1.1, -20.0)), "beside them");
        assert!(passes(at(1.0, -3.0), at(1.0, -4.0)), "in a strip");
    }
}
