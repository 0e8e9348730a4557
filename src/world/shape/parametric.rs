//! `parametric` (docs/spec/primitives.md 4.6).

use std::sync::Arc;

use super::r#box::Cuboid;
use super::isosurface::Container;
use super::stretch::Stretch;
use super::triangle::{Sheared, blend};
use super::{Crossing, Shape};
use crate::math::{Bounds, DMat3, DVec2, DVec3};
use crate::world::accel::Bvh;
use crate::world::sample::{Field, Sample};
use crate::world::{Range, Ray};

/// The points that three functions give for a rectangle of parameters u and v, within a container.
///
/// [`Crossing::at`] are the parameters. Nothing is missed if no function is steeper than it is said to be:
/// every tile of parameters has a box that then surely holds its points.
#[derive(Clone, Debug)]
pub struct Parametric {
    description: Description,
    /// Points at the corners of the tiles, for each u along v.
    corners: Vec<DVec3>,
    bvh: Bvh,
    bounds: Bounds,
}

/// What makes a [`Parametric`].
#[derive(Clone, Debug)]
pub struct Description {
    /// x, y and z; u and v are the x and y of the point they are asked at.
    pub functions: [Arc<dyn Field>; 3],
    /// The least parameters.
    pub from: DVec2,
    /// The greatest.
    pub to: DVec2,
    /// What is outside is not there.
    pub container: Container,
    /// The step that gives normals, and the finest division of the parameters; positive.
    pub accuracy: f64,
    /// The steepest the functions are along u and v.
    pub max_gradient: f64,
}

/// Tiles along u and v that are made beforehand.
const TILES: usize = 128;

/// The share of a tile that is small enough to look for a crossing by Newton's method.
const FINE: f64 = 1.0 / 16.0;

/// Steps of Newton's method before it is given up.
const TRIES: usize = 12;

/// By how much of its size a crossing may be beside the piece it was looked for in.
const BESIDE: f64 = 1e-6;

/// The step of slopes for Newton's method, as a share of all parameters.
const STEP: f64 = 1e-6;

/// A rectangle of parameters, with the points at its corners by u and v.
#[derive(Clone, Copy, Debug)]
struct Tile {
    from: DVec2,
    to: DVec2,
    corners: [[DVec3; 2]; 2],
}

impl Tile {
    /// A box around all points, if no coordinate is steeper than `gradient`.
    fn bounds(&self, gradient: f64) -> Bounds {
        let size = self.to - self.from;
        // What a slope can reach beyond both ends of a stretch.
        let room = |p: DVec3, q: DVec3, length: f64| {
            (0.5 * (DVec3::splat(gradient * length) - (p - q).abs())).max(DVec3::ZERO)
        };
        let [(low, high), (low_far, high_far)] = self.corners.map(|[p, q]| {
            let room = room(p, q, size.y);
            (p.min(q) - room, p.max(q) + room)
        });
        Bounds {
            min: low.min(low_far) - room(low, low_far, size.x),
            max: high.max(high_far) + room(high, high_far, size.x),
        }
    }
}

impl Parametric {
    /// `None` where there are no parameters, or no points in the container.
    pub fn new(description: Description) -> Option<Self> {
        let size = description.to - description.from;
        if !(size.cmpgt(DVec2::ZERO).all() && size.is_finite()) {
            return None;
        }
        let mut surface =
            Self { description, corners: Vec::new(), bvh: Bvh::new(Vec::new()), bounds: Bounds::EMPTY };
        let places = (0..=TILES).flat_map(|u| (0..=TILES).map(move |v| (u, v)));
        surface.corners = places.map(|(u, v)| surface.point(surface.parameters(u, v))).collect();
        let container = surface.extent();
        let tiles = (0..(TILES * TILES) as u32).map(|tile| (surface.tile(tile), tile));
        let boxes = tiles.map(|(tile, number)| {
            (tile.bounds(surface.description.max_gradient).intersection(container), number)
        });
        let boxes: Vec<_> = boxes.filter(|(bounds, _)| bounds.is_finite() && !bounds.is_empty()).collect();
        let bounds = boxes.iter().fold(Bounds::EMPTY, |all, (bounds, _)| all.union(*bounds));
        (!boxes.is_empty()).then(|| Self { bvh: Bvh::new(boxes), bounds, ..surface })
    }

    /// The parameters at a corner of tiles.
    fn parameters(&self, u: usize, v: usize) -> DVec2 {
        let share = DVec2::new(u as f64, v as f64) / TILES as f64;
        self.description.from * (1.0 - share) + self.description.to * share
    }

    fn tile(&self, number: u32) -> Tile {
        let (u, v) = (number as usize / TILES, number as usize % TILES);
        let corner = |u: usize, v: usize| self.corners[u * (TILES + 1) + v];
        Tile {
            from: self.parameters(u, v),
            to: self.parameters(u + 1, v + 1),
            corners: [u, u + 1].map(|u| [corner(u, v), corner(u, v + 1)]),
        }
    }

    fn point(&self, at: DVec2) -> DVec3 {
        let sample = Sample::at(at.extend(0.0));
        DVec3::from_array(self.description.functions.each_ref().map(|function| function.value(&sample)))
    }

    /// Both halves, across the longer side.
    fn halves(&self, tile: &Tile) -> [Tile; 2] {
        let (mut low, mut high) = (*tile, *tile);
        let middle = 0.5 * (tile.from + tile.to);
        let size = tile.to - tile.from;
        if size.x >= size.y {
            let across = [tile.from.y, tile.to.y].map(|v| self.point(DVec2::new(middle.x, v)));
            (low.to.x, high.from.x) = (middle.x, middle.x);
            (low.corners[1], high.corners[0]) = (across, across);
        } else {
            let across = [tile.from.x, tile.to.x].map(|u| self.point(DVec2::new(u, middle.y)));
            (low.to.y, high.from.y) = (middle.y, middle.y);
            low.corners = [0, 1].map(|u| [tile.corners[u][0], across[u]]);
            high.corners = [0, 1].map(|u| [across[u], tile.corners[u][1]]);
        }
        [low, high]
    }

    /// How fast the point goes along u and v.
    fn slopes(&self, at: DVec2) -> [DVec3; 2] {
        let Description { from, to, .. } = self.description;
        [DVec2::X, DVec2::Y].map(|axis| {
            let step = STEP * (to - from) * axis;
            let (before, after) = ((at - step).max(from), (at + step).min(to));
            (self.point(after) - self.point(before)) / (after - before).dot(axis)
        })
    }

    /// Where a ray meets the surface near `at` and `t`; `None` where Newton's method leads nowhere.
    fn refine(&self, ray: &Ray, mut at: DVec2, mut t: f64, size: DVec2) -> Option<(DVec2, f64)> {
        let (start, reach) = (at, 8.0 * size);
        let mut last = f64::INFINITY;
        for _ in 0..TRIES {
            let [along_u, along_v] = self.slopes(at);
            let matrix = DMat3::from_cols(along_u, along_v, -ray.direction);
            let step = matrix.inverse() * (ray.at(t) - self.point(at));
            if !step.is_finite() {
                return None;
            }
            (at, t) = (at + step.truncate(), t + step.z);
            let length = (step.truncate() / size).length();
            // Rounding alone moves it any more.
            if length < BESIDE && length >= 0.5 * last || length == 0.0 {
                return Some((at, t));
            }
            if (at - start).abs().cmpgt(reach).any() {
                return None;
            }
            last = length;
        }
        (last < BESIDE).then_some((at, t))
    }

    /// The crossing of a ray with a small piece that it surely passes close to.
    fn meet(&self, ray: &Ray, sheared: &Sheared, tile: &Tile, near: f64) -> Option<Crossing> {
        let size = tile.to - tile.from;
        if let Some((at, t)) = self.refine(ray, 0.5 * (tile.from + tile.to), near, size) {
            let room = BESIDE * size;
            let within = at.cmpge(tile.from - room).all() && at.cmple(tile.to + room).all();
            let at = at.clamp(self.description.from, self.description.to).to_array();
            return within.then_some(Crossing { t, part: 0, at });
        }
        // Kinks, and pieces that shrink to a point.
        let [[near, near_v], [near_u, far]] = tile.corners;
        let (along_u, along_v) = (size * DVec2::X, size * DVec2::Y);
        let triangles = [
            ([near, near_u, near_v], [tile.from, tile.from + along_u, tile.from + along_v]),
            ([far, near_v, near_u], [tile.to, tile.to - along_u, tile.to - along_v]),
        ];
        triangles.into_iter().find_map(|(corners, parameters)| {
            let hit = sheared.meet(corners)?;
            Some(Crossing { t: hit.t, part: 0, at: blend(parameters, hit.at).to_array() })
        })
    }

    /// Calls back with every crossing; the answer is a new upper end.
    fn walk(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing) -> f64) {
        let Some(stretch) = self.description.container.stretch(ray).filter(|s| s.enter.t.is_finite()) else {
            return;
        };
        let sheared = Sheared::new(ray);
        let speed = ray.direction.length();
        let finest = FINE * (self.description.to - self.description.from) / TILES as f64;
        let fine = finest.max_element().max(self.description.accuracy.min(finest.max_element() / FINE));
        let mut max = range.max;
        let mut waiting = Vec::new();
        self.bvh.along(ray, range, |number| {
            waiting.push(self.tile(number));
            while let Some(tile) = waiting.pop() {
                let bounds = tile.bounds(self.description.max_gradient);
                let cuboid = Cuboid { min: bounds.min, max: bounds.max };
                let Some(Stretch { enter, leave }) = cuboid.stretch(ray) else { continue };
                let (low, high) = (enter.t.max(stretch.enter.t), leave.t.min(stretch.leave.t));
                if low > high || high < range.min || low > max {
                    continue;
                }
                let small = (tile.to - tile.from).max_element() <= fine;
                if !small && (leave.t - enter.t) * speed >= self.description.accuracy {
                    let [low, high] = self.halves(&tile);
                    waiting.extend([high, low]);
                    continue;
                }
                let hit = self.meet(ray, &sheared, &tile, 0.5 * (enter.t + leave.t));
                let seen =
                    |t: f64| range.contains(t) && t < max && stretch.enter.t <= t && t <= stretch.leave.t;
                if let Some(crossing) = hit.filter(|crossing| seen(crossing.t)) {
                    max = found(crossing);
                }
            }
            max
        });
    }
}

impl Shape for Parametric {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn extent(&self) -> Bounds {
        self.description.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        self.walk(ray, range, |crossing| {
            out.push(crossing);
            range.max
        });
        out[from..].sort_by(|a, b| a.t.total_cmp(&b.t));
        // Neighbouring pieces both have a crossing on their common side.
        let room = BESIDE * (self.description.to - self.description.from).max_element();
        let mut kept = from;
        for next in from..out.len() {
            let crossing = out[next];
            let beside = |other: &Crossing| {
                DVec2::from_array(other.at).abs_diff_eq(DVec2::from_array(crossing.at), room)
            };
            if !out[from..kept].iter().any(beside) {
                out[kept] = crossing;
                kept += 1;
            }
        }
        out.truncate(kept);
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest = None;
        self.walk(ray, range, |crossing| {
            nearest = Some(crossing);
            crossing.t
        });
        nearest
    }

    fn inside(&self, _point: DVec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    /// By differences with the accuracy as step, as in POV-Ray; beside poles, where it has none.
    fn normal(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        let Description { from, to, accuracy, .. } = self.description;
        let across = |at: DVec2| {
            let here = self.point(at);
            let rise = |axis: DVec2| self.point(at + accuracy * axis) - here;
            rise(DVec2::X).cross(rise(DVec2::Y)).try_normalize()
        };
        let at = DVec2::from_array(crossing.at);
        let inward = at + accuracy * (0.5 * (from + to) - at).signum();
        across(at).or_else(|| across(inward)).unwrap_or(DVec3::X)
    }

    fn uv(&self, _point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        Some(DVec2::from_array(crossing.at))
    }

    fn reproject(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        self.point(DVec2::from_array(crossing.at))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::super::battery::{Probe, battery};
    use super::super::sphere::Sphere;
    use super::*;

    /// A coordinate by its formula.
    #[derive(Debug)]
    struct Formula(fn(f64, f64) -> f64);

    impl Field for Formula {
        fn value(&self, sample: &Sample) -> f64 {
            (self.0)(sample.point.x, sample.point.y)
        }
    }

    fn make(formulas: [fn(f64, f64) -> f64; 3], to: DVec2, from: DVec2, container: Container) -> Parametric {
        let functions = formulas.map(|formula| Arc::new(Formula(formula)) as Arc<dyn Field>);
        let description = Description { functions, from, to, container, accuracy: 1e-4, max_gradient: 2.0 };
        Parametric::new(description).unwrap()
    }

    fn ball() -> Parametric {
        make(
            [|u, v| u.sin() * v.cos(), |u, v| u.sin() * v.sin(), |u, _| u.cos()],
            DVec2::new(TAU, PI),
            DVec2::ZERO,
            Container::Sphere(Sphere { center: DVec3::ZERO, radius: 1.1 }),
        )
    }

    fn saddle() -> Parametric {
        let half = DVec3::splat(1.1);
        let container = Container::Box(Cuboid { min: -half, max: half });
        make([|u, _| u, |_, v| v, |u, v| u * v], DVec2::ONE, DVec2::NEG_ONE, container)
    }

    battery! {
        round: || ball(), surface;
        saddled: || saddle(), surface;
    }

    /// POV-Ray's points are short of the surface by up to the accuracy.
    #[test]
    fn surfaces_are_found_where_povray_finds_them() {
        let near =
            |shape: &Parametric, from: [f64; 3], direction: [f64; 3], point: [f64; 3], normal: [f64; 3]| {
                let hit = Probe::new(from.into(), direction.into()).hit(shape).unwrap();
                assert!(hit.point.abs_diff_eq(point.into(), 3e-4), "{}", hit.point);
                assert!(hit.normal.abs_diff_eq(normal.into(), 1e-3), "{}", hit.normal);
            };
        let ahead = [0.0, 0.0, 1.0];
        near(
            &ball(),
            [0.1, 0.2, -5.0],
            ahead,
            [0.1, 0.2, -0.974868664083149],
            [0.100020842249008, 0.200019702881127, -0.974673252723775],
        );
        near(
            &saddle(),
            [0.3, 0.4, -5.0],
            [0.01, 0.02, 1.0],
            [0.351771216800005, 0.503542433600009, 0.177121680000457],
            [-0.429067144587172, -0.299744366034327, 0.852088434651293],
        );
    }

    #[test]
    fn rays_meet_both_sides_exactly() {
        let ray = Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z);
        let mut all = Vec::new();
        ball().crossings(&ray, Range::AHEAD, &mut all);
        let half = (1.0_f64 - 0.05).sqrt();
        let distances: Vec<_> = all.iter().map(|crossing| crossing.t - 5.0).collect();
        assert_eq!(distances.len(), 2, "{distances:?}");
        assert!((distances[0] + half).abs() < 1e-13 && (distances[1] - half).abs() < 1e-13, "{distances:?}");
    }

    #[test]
    fn what_is_outside_the_container_is_not_there() {
        let half = DVec3::new(1.1, 1.1, 0.5);
        let container = Container::Box(Cuboid { min: -half, max: half });
        let cut = Parametric::new(Description { container, ..saddle().description }).unwrap();
        let at = |x: f64, y: f64| cut.nearest(&Ray::new(DVec3::new(x, y, -5.0), DVec3::Z), Range::AHEAD);
        assert!(at(0.9, 0.9).is_none());
        assert_eq!(at(0.5, 0.5).map(|crossing| crossing.at), Some([0.5, 0.5]));
        let nothing = Parametric::new(Description { to: cut.description.from, ..cut.description });
        assert!(nothing.is_none());
    }
}
