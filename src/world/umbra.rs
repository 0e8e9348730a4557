//! What objects hide from a lamp of one place, told without asking their surfaces wherever no rounding can
//! change the answer.
//!
//! A box hides what is behind its lit faces, as the lamp sees it, and between the planes through the lamp and
//! the edges at which those end; a plane what is on its other side. What is round is held against balls
//! ([`screen`](super::screen)), and of all else the box around it says what it doesn't hide.

use super::accel::{Hull, Pencil, Points, Within};
use super::hit::Geometry;
use super::object::LeafFlags;
use super::screen::{Cone, OPEN, SHUT, Screen, UNKNOWN, Verdict, View, scale};
use super::shape::plane::Plane;
use super::shape::{Primitive, Shape};
use crate::math::{Bounds, DVec3, Lanes, Transform};

/// More objects than these are not worth knowing.
const FEW: usize = 12;

/// Relative errors of distances stay below this.
const BLUR: f64 = 1e-9;

/// Edges that a lamp sees from nearer than this, in parts of the farthest way, throw shadows that are too uncertain.
const ASIDE: f64 = 1e-5;

/// The shadow that an object throws in the light of a lamp.
#[derive(Clone, Debug)]
pub struct Umbra {
    /// The object's number.
    pub object: u32,
    /// Whether a ray that leaves the object towards the outside won't meet it again.
    pub left_for_good: bool,
    form: Form,
}

#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "few are kept, and every ray reads them: in place")]
enum Form {
    /// That of balls.
    Balls(View),
    /// That of a box or a plane; only if the object `fills` it and is opaque it is in the way of all that passes there.
    Sides { sides: Sides, fills: bool },
}

/// What shadows tell about a region of space.
#[derive(Clone, Debug)]
pub enum Shade {
    /// It is in shadow.
    Dark,
    /// Only these objects may be in the way of light to it.
    Among(Vec<Umbra>),
}

impl Umbra {
    /// Whether the object is in the way of light that comes along `way` from the lamp.
    #[inline(always)]
    pub fn verdict(&self, way: DVec3) -> Verdict {
        match &self.form {
            Form::Balls(view) => view.verdict(way.to_array()),
            Form::Sides { sides, fills } => told(sides.side(way), *fills),
        }
    }

    /// The same of all ways to a cell; unknown where it isn't the same to all.
    fn verdict_on_all(&self, lamp: DVec3, cell: &Bounds) -> Verdict {
        let (middle, half) = (cell.center() - lamp, cell.size() / 2.0);
        match &self.form {
            Form::Balls(view) => {
                let cone = Cone::new(middle, half.length());
                cone.map_or(UNKNOWN, |cone| view.verdict_on_all(&cone))
            }
            Form::Sides { sides, fills } => told(sides.side_of_all(middle, half), *fills),
        }
    }
}

/// The verdict of a box, by the signs of places behind its outline: minus for those beside it.
#[inline(always)]
fn told(side: f64, fills: bool) -> Verdict {
    if side < 0.0 {
        OPEN
    } else if side > 0.0 && fills {
        SHUT
    } else {
        UNKNOWN
    }
}

/// The most planes around the shadow of a box: three lit faces, and six edges between those and the others.
const MOST: usize = 3 + 6;

/// So many registers of four hold them.
const GROUPS: usize = MOST.div_ceil(Lanes::COUNT);

/// The planes around the shadow of a box, as ways from the lamp see them: unit normals, which point into the shadow,
/// and distances. Those that are missing have everything far inside.
#[derive(Clone, Debug)]
struct Sides {
    groups: [([Lanes; 3], Lanes); GROUPS],
    /// How many planes there are.
    count: usize,
    /// How far rounding may move places, besides what the length of ways adds.
    blur: f64,
}

impl Sides {
    /// Around the shadow of a box in the space of `place`, for ways from `lamp` that aren't longer than `far`; `None`
    /// where that is too uncertain to tell.
    fn of_box(bounds: &Bounds, place: Option<&Transform>, lamp: DVec3, far: f64) -> Option<Self> {
        let scale = place.map_or(Some(1.0), scale)?;
        let eye = place.map_or(lamp, |place| place.inverse_point(lamp));
        let corners = [(bounds.min - eye).to_array(), (bounds.max - eye).to_array()];
        // Along each axis whether the low face is lit, and the high one.
        let lit = [0, 1, 2].map(|axis| [corners[0][axis] > 0.0, corners[1][axis] < 0.0]);
        let outer = place.map_or(*bounds, |place| bounds.transformed(place));
        let size = outer.min.abs().max(outer.max.abs()).max(lamp.abs()).max_element();
        let mut sides = Self::none(BLUR * size);
        let mut add = |normal: [f64; 3], distance: f64| {
            let normal = DVec3::from_array(normal).normalize_or_zero();
            sides.add(place.map_or(normal, |place| place.normal(normal) * scale), distance);
        };
        for axis in 0..3 {
            for side in [0, 1].into_iter().filter(|&side| lit[axis][side]) {
                // How far inside of a low face a positive number is, and of a high one.
                let inward = |side: usize| if side == 0 { 1.0 } else { -1.0 };
                let face = corners[side][axis];
                let mut normal = [0.0; 3];
                normal[axis] = inward(side);
                add(normal, face.abs() * scale);
                if face.abs() * scale < ASIDE * far {
                    return None;
                }
                for (next, end) in
                    [1, 2].into_iter().flat_map(|step| [((axis + step) % 3, 0), ((axis + step) % 3, 1)])
                {
                    if !lit[next][end] {
                        // Through the lamp and the edge of the two faces.
                        let mut normal = [0.0; 3];
                        normal[next] = inward(end) * face.abs();
                        normal[axis] = -inward(end) * corners[end][next] * face.signum();
                        add(normal, 0.0);
                    }
                }
            }
        }
        (sides.count > 0 && size.is_finite() && far.is_finite()).then_some(sides)
    }

    /// The other side of a plane.
    fn of_plane(plane: &Plane, lamp: DVec3, far: f64) -> Option<Self> {
        let height = plane.normal.dot(lamp) - plane.distance;
        let mut sides = Self::none(BLUR * lamp.abs().max_element().max(plane.distance.abs()));
        sides.add(plane.normal * -height.signum(), height.abs());
        (height.abs() >= ASIDE * far).then_some(sides)
    }

    fn none(blur: f64) -> Self {
        Self { groups: [([Lanes::ZERO; 3], Lanes::splat(f64::NEG_INFINITY)); GROUPS], count: 0, blur }
    }

    fn add(&mut self, normal: DVec3, distance: f64) {
        let (normals, distances) = &mut self.groups[self.count / Lanes::COUNT];
        let lane = self.count % Lanes::COUNT;
        for (lanes, part) in normals.iter_mut().zip(normal.to_array()) {
            lanes.0[lane] = part;
        }
        distances.0[lane] = distance;
        self.count += 1;
    }

    /// The groups that hold anything.
    #[inline(always)]
    fn filled(&self) -> &[([Lanes; 3], Lanes)] {
        &self.groups[..self.count.div_ceil(Lanes::COUNT)]
    }

    /// The sign of a place at the end of a way: above zero in the shadow, below beside it, zero where it is too near
    /// to its border to tell.
    #[inline(always)]
    fn side(&self, way: DVec3) -> f64 {
        let DVec3 { x, y, z } = way;
        let blur = self.blur + BLUR * (x.abs() + y.abs() + z.abs());
        let mut least = Lanes::splat(f64::INFINITY);
        // A loop: closures given to iterators are not compiled together with what is around them.
        for (normals, distances) in self.filled() {
            let inside = normals[0] * x + normals[1] * y + normals[2] * z - *distances;
            least = least.zip(inside, |least, inside| if inside < least { inside } else { least });
        }
        signed(least, blur)
    }

    /// The same for all places around the end of a way, up to `half` away along each axis.
    fn side_of_all(&self, way: DVec3, half: DVec3) -> f64 {
        let span = way.abs() + half;
        let blur = self.blur + BLUR * span.element_sum();
        let (mut least, mut most) = (Lanes::splat(f64::INFINITY), Lanes::splat(f64::INFINITY));
        for (normals, distances) in self.filled() {
            let [a, b, c] = normals;
            let inside = *a * way.x + *b * way.y + *c * way.z - *distances;
            let reach = a.abs() * half.x + b.abs() * half.y + c.abs() * half.z;
            least = least.zip(inside - reach, f64::min);
            most = most.zip(inside + reach, f64::min);
        }
        if signed(most, blur) < 0.0 { -1.0 } else { signed(least, blur).max(0.0) }
    }
}

/// The sign of the least of four numbers; zero where rounding may have changed it.
#[inline(always)]
fn signed(least: Lanes, blur: f64) -> f64 {
    let [a, b, c, d] = least.0;
    let (a, b) = (if b < a { b } else { a }, if d < c { d } else { c });
    let least = if b < a { b } else { a };
    if least > blur {
        1.0
    } else if least < -blur {
        -1.0
    } else {
        0.0
    }
}

impl Geometry {
    /// What is in the way of light from a lamp to a cell; `None` if that is many.
    pub fn shade(&self, lamp: DVec3, cell: &Bounds) -> Option<Shade> {
        if !lamp.is_finite() || !cell.is_finite() {
            return None;
        }
        let mut among = Vec::new();
        let mut is_dark = |number: u32| {
            let Some(umbra) = self.umbra(number, lamp, cell) else { return false };
            let verdict = umbra.verdict_on_all(lamp, cell);
            among.extend((verdict == UNKNOWN).then_some(umbra));
            verdict == SHUT || among.len() > FEW
        };
        let mut points = Points::from_slice(&[lamp, cell.center()]);
        points.extend(cell.corners());
        let ways = Pencil { from: *cell, through: Bounds { min: lamp, max: lamp }, ends: true };
        let mut within = Within::default();
        let dark = if self.within(&ways, &mut within) {
            let items = within.items().iter().map(|boxed| boxed.number);
            let mut near = self.unbounded().iter().copied().chain(items);
            near.any(|number| !self.is_apart_from(number, &points) && is_dark(number))
        } else {
            let mut near = Vec::new();
            if !self.between(&Hull::new(&points), &mut near) {
                return None;
            }
            near.iter().any(|screen| is_dark(screen.object))
        };
        let many = among.len() > FEW;
        (!many).then_some(if dark { Shade::Dark } else { Shade::Among(among) })
    }

    /// The shadow of an object as it falls on a cell; `None` where it throws none.
    fn umbra(&self, object: u32, lamp: DVec3, cell: &Bounds) -> Option<Umbra> {
        let parts = self.parts();
        let screen = Screen::new(object, &parts.objects[object as usize], parts, lamp)?;
        let far = cell.center().distance(lamp) + cell.size().length();
        let box_of = |bounds: &Bounds, place| Sides::of_box(bounds, place, lamp, far);
        let leaf = self.lone(object).filter(|leaf| !leaf.is_limited());
        let place = leaf.and_then(|leaf| leaf.transform.as_deref());
        let opaque = leaf.is_some_and(|leaf| leaf.flags.contains(LeafFlags::OPAQUE));
        let (sides, fills) = match leaf.map(|leaf| &leaf.primitive) {
            Some(Primitive::Sphere(_) | Primitive::Torus(_)) => (None, false),
            Some(Primitive::Plane(plane)) if place.is_none() => (Sides::of_plane(plane, lamp, far), opaque),
            Some(Primitive::Box(solid)) => (box_of(&solid.bounds(), place), opaque),
            _ => (
                Some(self.bounds(object)).filter(|all| all.is_finite()).and_then(|all| box_of(&all, None)),
                false,
            ),
        };
        let form = match sides {
            Some(sides) => Form::Sides { sides, fills },
            None => Form::Balls(*screen.as_seen()),
        };
        Some(Umbra { object, left_for_good: self.is_left_for_good(object), form })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::world::shape::r#box::Cuboid;
    use crate::world::{Range, Ray};

    #[test]
    fn verdicts_are_those_of_boxes() {
        let mut number = numbers(23);
        let mut seen = [0; 3];
        for round in 0..3000 {
            let mut point = |size: f64| size * DVec3::new(number(), number(), number());
            let (lamp, corner, size, turn) = (point(16.0), point(4.0), point(8.0).abs(), point(720.0));
            let place =
                (round % 2 == 1).then(|| Transform::rotate(turn).then(&Transform::scale(DVec3::splat(1.7))));
            let bounds = Bounds::new(corner, corner + size);
            let Some(sides) = Sides::of_box(&bounds, place.as_ref(), lamp, 50.0) else { continue };
            let solid = Cuboid { min: bounds.min, max: bounds.max };
            let shut = |way: DVec3| {
                let ray = Ray::new(lamp + way, -way);
                let ray = place.as_ref().map_or(ray, |place| ray.to_inner(place));
                solid.occludes(&ray, Range { min: 0.0, max: 1.0 })
            };
            for _ in 0..20 {
                let way = point(16.0) - lamp;
                let verdict = told(sides.side(way), true);
                seen[verdict as usize] += 1;
                assert_eq!(verdict == SHUT, shut(way), "{lamp} {bounds:?} {way}");
                let half = point(0.6).abs();
                let verdict = told(sides.side_of_all(way, half), true);
                for _ in 0..if verdict == UNKNOWN { 0 } else { 10 } {
                    let way = way + half * point(2.0);
                    assert_eq!(verdict == SHUT, shut(way), "{lamp} {bounds:?} {way} {half}");
                }
            }
        }
        assert!(seen[0] > 9000 && seen[2] > 2000, "{seen:?}");
    }
}
