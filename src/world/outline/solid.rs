//! Convex solids with flat faces, and how they are seen.

use smallvec::SmallVec;

use super::{BLUR, Border, ROUNDING, Side, Sight};
use crate::math::{Bounds, DVec3, Transform};

/// Corners that are no farther from a plane, in parts of the coordinates, are taken to be on it.
const ON_PLANE: f64 = 1e-13;

/// The corners of a box's faces, anticlockwise as seen from outside: bits 0 to 2 of a number tell whether
/// its x, y and z are the greater ones.
const BOX_FACES: [[u16; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// A face: what is inside is where `normal` · p < `distance`.
#[derive(Clone, Debug)]
struct Face {
    normal: DVec3,
    distance: f64,
    /// The numbers of its corners, anticlockwise as seen from outside.
    corners: SmallVec<[u16; 8]>,
}

/// An edge that `left` has on its left-hand side, as seen from outside.
#[derive(Clone, Copy, Debug)]
struct Edge {
    ends: [DVec3; 2],
    left: u16,
    right: u16,
}

/// A convex solid with flat faces.
#[derive(Clone, Debug)]
pub(super) struct Solid {
    corners: Vec<DVec3>,
    faces: Vec<Face>,
    edges: Vec<Edge>,
    /// The greatest coordinate.
    size: f64,
    /// A ball around it.
    middle: DVec3,
    radius: f64,
}

impl Solid {
    /// A box in its place; `None` for one without a volume.
    pub(super) fn cuboid(bounds: &Bounds, place: Option<&Transform>) -> Option<Self> {
        let mut corners = bounds.corners().to_vec();
        let mirrored = place.is_some_and(|place| place.forward.matrix3.determinant() < 0.0);
        if let Some(place) = place {
            corners.iter_mut().for_each(|corner| *corner = place.point(*corner));
        }
        let size = corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
        let face = |numbers: [u16; 4]| {
            let mut numbers = SmallVec::from_slice(&numbers);
            if mirrored {
                numbers.reverse();
            }
            let [a, b, c] = [0, 1, 3].map(|place: usize| corners[usize::from(numbers[place])]);
            let normal = (b - a).cross(c - a).try_normalize()?;
            Some(Face { normal, distance: normal.dot(a), corners: numbers })
        };
        let faces = BOX_FACES.into_iter().map(face).collect::<Option<Vec<_>>>()?;
        let mut solid = Self { corners, faces, edges: Vec::new(), size, middle: DVec3::ZERO, radius: 0.0 };
        let thick = |face: &Face| {
            solid.corners.iter().any(|corner| face.normal.dot(*corner) - face.distance < -ON_PLANE * size)
        };
        let known = size.is_finite() && solid.faces.iter().all(thick);
        if !known {
            return None;
        }
        solid.find_edges()?;
        Some(solid)
    }

    /// What of it is inside of all faces of `other`: nothing, or a solid. `None` where that is not known.
    pub(super) fn common(&self, other: &Self) -> Option<Option<Self>> {
        let mut found = self.clone();
        for face in &other.faces {
            match found.cut(face.normal, face.distance)? {
                Some(left) => found = left,
                None => return Some(None),
            }
        }
        Some(Some(found))
    }

    /// Solids that together are what of it is outside of `other`. `None` where that is not known.
    pub(super) fn without(&self, other: &Self) -> Option<Vec<Self>> {
        let rest = other.faces.iter().map(|face| self.cut(-face.normal, -face.distance));
        Some(rest.collect::<Option<Vec<_>>>()?.into_iter().flatten().collect())
    }

    /// What of it is where `normal` · p < `distance`: nothing, or a solid. `None` where that is not known.
    fn cut(&self, normal: DVec3, distance: f64) -> Option<Option<Self>> {
        let room = ON_PLANE * self.size.max(distance.abs());
        let heights: Vec<f64> = self.corners.iter().map(|corner| normal.dot(*corner) - distance).collect();
        if heights.iter().all(|&height| height > room) {
            return Some(None);
        }
        if heights.iter().all(|&height| height > -room) {
            // A skin, or nothing.
            return None;
        }
        if heights.iter().all(|&height| height <= room) {
            return Some(Some(self.clone()));
        }
        let (mut corners, mut faces) = (self.corners.clone(), Vec::new());
        let mut crossed: Vec<([u16; 2], u16)> = Vec::new();
        // From where a face is entered to where it was left, as the face of the cut sees it.
        let mut seams: Vec<[u16; 2]> = Vec::new();
        for face in &self.faces {
            let mut kept = SmallVec::new();
            let (mut entry, mut exit) = (None, None);
            for (place, &corner) in face.corners.iter().enumerate() {
                let next = face.corners[(place + 1) % face.corners.len()];
                let [here, there] = [corner, next].map(|number| heights[usize::from(number)]);
                if here <= room {
                    kept.push(corner);
                }
                if (here <= room) == (there <= room) {
                    continue;
                }
                let ends = [corner.min(next), corner.max(next)];
                let known = crossed.iter().find(|(known, _)| *known == ends).map(|&(_, number)| number);
                let number = known.unwrap_or_else(|| {
                    let [low, high] = ends.map(usize::from);
                    let share = (heights[low] / (heights[low] - heights[high])).clamp(0.0, 1.0);
                    corners.push(self.corners[low].lerp(self.corners[high], share));
                    let number = corners.len() as u16 - 1;
                    crossed.push((ends, number));
                    number
                });
                kept.push(number);
                *(if here <= room { &mut exit } else { &mut entry }) = Some(number);
            }
            if let (Some(entry), Some(exit)) = (entry, exit) {
                seams.push([entry, exit]);
            }
            if !kept.is_empty() {
                faces.push(Face { corners: kept, ..*face });
            }
        }
        let first = *seams.first()?;
        let mut loop_of_cut = SmallVec::from_slice(&[first[0]]);
        let mut last = first[1];
        while last != first[0] {
            if loop_of_cut.len() > seams.len() {
                return None;
            }
            loop_of_cut.push(last);
            last = seams.iter().find(|seam| seam[0] == last)?[1];
        }
        faces.push(Face { normal, distance, corners: loop_of_cut });
        let mut solid = Self { corners, faces, edges: Vec::new(), ..*self };
        solid.find_edges()?;
        Some(Some(solid))
    }

    /// Pairs the sides of faces; `None` where one has no partner.
    fn find_edges(&mut self) -> Option<()> {
        let mut sides: Vec<([u16; 2], u16)> = Vec::new();
        for (number, face) in (0..).zip(&self.faces) {
            let next = face.corners.iter().cycle().skip(1);
            sides.extend(face.corners.iter().zip(next).map(|(&a, &b)| ([a, b], number)));
        }
        self.edges.clear();
        let used = || sides.iter().map(|([corner, _], _)| self.corners[usize::from(*corner)]);
        self.middle = used().sum::<DVec3>() / sides.len() as f64;
        self.radius = used().map(|corner| corner.distance(self.middle)).fold(0.0, f64::max);
        for &([a, b], left) in &sides {
            let right = sides.iter().find(|(ends, _)| *ends == [b, a])?.1;
            if a < b {
                let ends = [a, b].map(|number| self.corners[usize::from(number)]);
                self.edges.push(Edge { ends, left, right });
            }
        }
        Some(())
    }

    /// Whether a point is clearly outside.
    pub(super) fn is_left_by(&self, point: DVec3) -> bool {
        self.faces.iter().any(|face| face.normal.dot(point) > face.distance)
    }

    /// Adds its borders as a point sees them that is outside.
    pub(super) fn look(&self, sight: &Sight, farthest: f64, border: &mut Border) {
        let from = sight.from;
        let size = self.size.max(from.abs().max_element());
        let mut heights = SmallVec::<[f64; 16]>::new();
        let mut highest = f64::NEG_INFINITY;
        for face in &self.faces {
            let height = face.normal.dot(from) - face.distance;
            heights.push(height);
            highest = highest.max(height);
            if height > 0.0 {
                border.add(-face.normal, -height, BLUR * farthest + ROUNDING * size, Side::Both);
                if border.open {
                    return;
                }
            }
        }
        if highest <= BLUR * size {
            border.is_thin();
        }
        let reach = self.middle.distance(from) + self.radius;
        let blur = (BLUR * reach + 2.0 * ROUNDING * size) * reach * farthest;
        for &Edge { ends: [a, b], left, right } in &self.edges {
            let (left, right) = (heights[usize::from(left)] > 0.0, heights[usize::from(right)] > 0.0);
            if left == right {
                continue;
            }
            let (a, b) = (a - from, b - from);
            let normal = if left { b.cross(a) } else { a.cross(b) };
            border.add(normal, 0.0, blur, Side::Both);
            if border.open {
                return;
            }
        }
    }
}
