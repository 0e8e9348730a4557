//! Boxes around what planes and quadrics have in common, none of which has a box of its own, and around what planes
//! leave of turned solids.

use super::extent::half_space;
use super::object::{Leaf, LeafFlags};
use super::shape::{Primitive, Shape};
use crate::math::{Bounds, DMat3, DVec3, Transform};

/// Sums of normals that miss an axis by less than this, relative to their length, are the axis.
const STRAY: f64 = 1e-12;

/// Boxes are larger than computed by this share of their size, more than rounding can take from them.
const ROOM: f64 = 1e-9;

/// Corners are farther out than computed by this share.
const ASIDE: f64 = 1e-6;

/// Of more planes only so many are asked for corners.
const MOST_PLANES: usize = 16;

/// The points `p` with `normal · p <= distance`.
#[derive(Clone, Copy)]
struct HalfSpace {
    normal: DVec3,
    distance: f64,
}

impl HalfSpace {
    /// The inside of a leaf, if that is a half-space.
    fn of(leaf: &Leaf) -> Option<Self> {
        let Primitive::Plane(plane) = &leaf.primitive else { return None };
        let sign = if leaf.flags.contains(LeafFlags::INVERTED) { -1.0 } else { 1.0 };
        let own = Self { normal: sign * plane.normal, distance: sign * plane.distance };
        Some(leaf.transform.as_ref().map_or(own, |transform| own.seen_from(&transform.inverted())))
    }

    /// The same in the inner space of a transform.
    fn seen_from(self, inner: &Transform) -> Self {
        let normal = inner.forward.matrix3.transpose() * self.normal;
        let distance = self.distance - self.normal.dot(inner.forward.translation);
        let length = normal.length();
        Self { normal: normal / length, distance: distance / length }
    }
}

/// A box around what all the leaves have in common, given one that is known.
pub fn common<'a>(leaves: impl Iterator<Item = &'a Leaf> + Clone, known: Bounds) -> Bounds {
    if known.is_finite() || known.is_empty() {
        return known;
    }
    let half_spaces: Vec<HalfSpace> = leaves.clone().filter_map(HalfSpace::of).take(MOST_PLANES).collect();
    let mut bounds = known.intersection(around(&half_spaces));
    for leaf in leaves.filter(|leaf| !leaf.flags.contains(LeafFlags::INVERTED)) {
        let Primitive::Quadric(quadric) = &leaf.primitive else { continue };
        let identity = Transform::IDENTITY;
        let place = leaf.transform.as_deref().unwrap_or(&identity);
        let inner: Vec<HalfSpace> = half_spaces.iter().map(|half| half.seen_from(place)).collect();
        let within = around(&inner).intersection(bounds.transformed(&place.inverted()));
        bounds = bounds.intersection(quadric.narrowed(within).transformed(place));
    }
    if bounds.is_empty() { known } else { bounds }
}

/// A box around what all the leaves have in common, given one that is known: each leaf's own box, cut by the planes that
/// run along its faces.
pub fn cut<'a>(leaves: impl Iterator<Item = &'a Leaf> + Clone, known: Bounds) -> Bounds {
    let half_spaces: Vec<HalfSpace> = leaves.clone().filter_map(HalfSpace::of).take(MOST_PLANES).collect();
    let mut bounds = known;
    if half_spaces.is_empty() || known.is_empty() {
        return known;
    }
    for leaf in leaves.filter(|leaf| !leaf.flags.intersects(LeafFlags::INVERTED | LeafFlags::BEYOND)) {
        let (Some(place), own) = (&leaf.transform, leaf.primitive.bounds()) else { continue };
        // What has a box of its own may be inside without end: discs, height fields.
        if !own.is_finite() || !leaf.extent().bounds.is_finite() {
            continue;
        }
        let inner = half_spaces.iter().map(|half| half.seen_from(place));
        let planes = inner.map(|half| half_space(half.normal, half.distance, None, STRAY));
        let room = ROOM * own.size().max_element().max(own.max.abs().max(own.min.abs()).max_element());
        let planes = planes.map(|Bounds { min, max }| Bounds { min: min - room, max: max + room });
        let within = planes.fold(own, Bounds::intersection);
        bounds = bounds.intersection(within.transformed(place));
    }
    if bounds.is_empty() { known } else { bounds }
}

/// Points around what all the leaves have in common, which is in a box: all of it is between them, with some room. They
/// are the corners of the planes, where these alone surround it, or else those of the box.
pub fn corners<'a>(leaves: impl Iterator<Item = &'a Leaf>, bounds: Bounds) -> Vec<DVec3> {
    let half_spaces: Vec<HalfSpace> = leaves.filter_map(HalfSpace::of).take(MOST_PLANES + 1).collect();
    if half_spaces.len() > MOST_PLANES || !around(&half_spaces).is_finite() {
        return bounds.corners().to_vec();
    }
    let size = bounds.size().max_element();
    let corners = meetings(&half_spaces, ASIDE * size);
    corners.map(|corner| corner + ASIDE * (corner - bounds.center())).collect()
}

/// Where three planes meet no farther outside of all the half-spaces than `room`.
fn meetings(half_spaces: &[HalfSpace], room: f64) -> impl Iterator<Item = DVec3> {
    let below = |end: usize| half_spaces[..end].iter().enumerate();
    let threes = below(half_spaces.len())
        .flat_map(move |(i, a)| below(i).map(move |(j, b)| (a, j, b)))
        .flat_map(move |(a, j, b)| below(j).map(move |(_, c)| [a, b, c]));
    let meeting = |[a, b, c]: [&HalfSpace; 3]| {
        let normals = DMat3::from_cols(a.normal, b.normal, c.normal).transpose();
        normals.inverse() * DVec3::new(a.distance, b.distance, c.distance)
    };
    let is_kept =
        move |point: &DVec3| half_spaces.iter().all(|half| half.normal.dot(*point) <= half.distance + room);
    threes.map(meeting).filter(|point| point.is_finite()).filter(is_kept)
}

/// A box around what half-spaces have in common.
fn around(half_spaces: &[HalfSpace]) -> Bounds {
    let mut bounds = Bounds::ALL;
    for axis in 0..3 {
        bounds.max[axis] = reach(half_spaces, DVec3::AXES[axis]);
        bounds.min[axis] = -reach(half_spaces, -DVec3::AXES[axis]);
    }
    let room = if bounds.is_finite() { ROOM * bounds.size().max_element() } else { 0.0 };
    Bounds { min: bounds.min - room, max: bounds.max + room }
}

/// How far along `direction` the common part of half-spaces goes: each sum of normals, none taken
/// negatively, that gives the direction gives a bound, and the least of those of three is the least of all.
fn reach(half_spaces: &[HalfSpace], direction: DVec3) -> f64 {
    let mut least = f64::INFINITY;
    let mut consider = |shares: DVec3, chosen: [&HalfSpace; 3]| {
        let pairs = || shares.to_array().into_iter().zip(chosen);
        let sum = pairs().fold(DVec3::ZERO, |sum, (share, half)| sum + share * half.normal);
        if shares.min_element() >= 0.0 && (sum - direction).abs().max_element() <= STRAY {
            least = least.min(pairs().map(|(share, half)| share * half.distance).sum());
        }
    };
    for (i, a) in half_spaces.iter().enumerate() {
        consider(DVec3::new(direction.dot(a.normal), 0.0, 0.0), [a; 3]);
        for (j, b) in half_spaces.iter().enumerate().take(i) {
            let across = a.normal.cross(b.normal);
            let shares = |c: DVec3| DMat3::from_cols(a.normal, b.normal, c).inverse() * direction;
            // Of two planes, a third direction has no share.
            let [one, other, none] = shares(across).to_array();
            if none.abs() <= STRAY {
                consider(DVec3::new(one, other, 0.0), [a, b, b]);
            }
            for c in &half_spaces[..j] {
                consider(shares(c.normal), [a, b, c]);
            }
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half(normal: [f64; 3], distance: f64) -> HalfSpace {
        HalfSpace { normal: DVec3::from_array(normal).normalize(), distance }
    }

    #[test]
    fn planes_around_a_solid_have_a_box() {
        let third = 1.0 / 3.0_f64.sqrt();
        let corners = [[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]];
        let tetrahedron = corners.map(|normal| half(normal, third));
        let bounds = around(&tetrahedron);
        assert!(bounds.min.abs_diff_eq(-DVec3::ONE, 1e-8) && bounds.max.abs_diff_eq(DVec3::ONE, 1e-8));
        let wedge = around(&tetrahedron[..3]);
        assert!(!wedge.is_finite());
    }

    #[test]
    fn planes_around_a_solid_meet_at_its_corners() {
        let normals = [[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [0., -1., -1.]];
        let wedge = normals.map(|normal| half(normal, 0.5));
        let corners: Vec<DVec3> = meetings(&wedge, 1e-6).collect();
        assert_eq!(corners.len(), 6, "{corners:?}");
        let far = -0.5 - 0.5_f64.sqrt();
        for (x, [y, z]) in
            [-0.5, 0.5].map(|x| [[0.5, 0.5], [0.5, far], [far, 0.5]].map(|at| (x, at))).concat()
        {
            let corner = DVec3::new(x, y, z);
            assert!(corners.iter().any(|other| other.abs_diff_eq(corner, 1e-12)), "{corner} in {corners:?}");
        }
    }

    #[test]
    fn a_plane_across_an_axis_bounds_only_that() {
        let slab = around(&[half([0., 1., 0.], 2.0), half([0., -1., 0.], 1.0)]);
        assert_eq!([slab.min.y, slab.max.y], [-1.0, 2.0]);
        assert_eq!([slab.min.x, slab.max.z], [f64::NEG_INFINITY, f64::INFINITY]);
    }

    #[test]
    fn half_spaces_move_into_a_space() {
        let place = Transform::scale(DVec3::new(2.0, 3.0, 1.0)).then(&Transform::rotate(DVec3::Z * 30.0));
        let place = place.then(&Transform::translate(DVec3::new(5.0, 6.0, 7.0)));
        let outer = half([0.3, -0.5, 0.7], 4.0);
        let inner = outer.seen_from(&place);
        let on = DVec3::new(1.0, 2.0, 3.0);
        let on = on + inner.normal * (inner.distance - inner.normal.dot(on));
        assert!((outer.normal.dot(place.point(on)) - outer.distance).abs() < 1e-12);
    }
}
