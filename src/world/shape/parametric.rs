//! `parametric` (docs/spec/primitives.md 4.6).

mod local;
mod piece;

use std::sync::Arc;

use super::r#box::Cuboid;
use super::isosurface::Container;
use super::stretch::Stretch;
use super::{Crossing, Shape};
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes};
use crate::world::accel::Bvh;
use crate::world::sample::{Field, Sample};
use crate::world::{Range, Ray};
use piece::Piece;

/// The points that three functions give for a rectangle of parameters u and v, within a container.
///
/// [`Crossing::at`] are the parameters. Nothing is missed: every tile of parameters has a box that surely holds
/// its points, by the bands of the functions, or where nothing is known of them if none is steeper than it is
/// said to be.
#[derive(Clone, Debug)]
pub struct Parametric {
    description: Description,
    /// Points at the corners of the tiles, for each u along v.
    corners: Vec<DVec3>,
    bvh: Bvh,
    bounds: Bounds,
    /// Whether bands tell what the functions do.
    known: bool,
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

/// Crossings nearer to each other, as a share of all parameters, are one.
const SAME: f64 = 1e-10;

/// A rectangle of parameters, with the points at its corners by u and v.
#[derive(Clone, Copy, Debug)]
struct Tile {
    from: DVec2,
    to: DVec2,
    corners: [[DVec3; 2]; 2],
    /// A box around all points.
    bounds: Bounds,
}

impl Tile {
    /// A box around all points, if no coordinate is steeper than `gradient`.
    fn bounds_by_gradient(&self, gradient: f64) -> Bounds {
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

impl Description {
    /// Puts the boxes around two tiles.
    fn bound(&self, tiles: &mut [Tile; 2]) {
        if !self.functions.iter().all(|function| function.is_known()) {
            for tile in tiles {
                tile.bounds = tile.bounds_by_gradient(self.max_gradient);
            }
            return;
        }
        // For each tile twice: lines along u with all of v beside them, and the other way round.
        let [(a, p), (b, q)] =
            tiles.each_ref().map(|tile| (0.5 * (tile.from + tile.to), 0.5 * (tile.to - tile.from)));
        let u = Band {
            reach: Lanes([0.0, p.x, 0.0, q.x]),
            ..Band::line(Lanes([a.x, a.x, b.x, b.x]), Lanes([p.x, 0.0, q.x, 0.0]))
        };
        let v = Band {
            reach: Lanes([p.y, 0.0, q.y, 0.0]),
            ..Band::line(Lanes([a.y, a.y, b.y, b.y]), Lanes([0.0, p.y, 0.0, q.y]))
        };
        let at = [u.loose(), v.loose(), Band::constant(0.0)];
        let boxes = self.functions.each_ref().map(|function| {
            let band = function.enclose(&at);
            (band.low().0, band.high().0)
        });
        for (i, tile) in tiles.iter_mut().enumerate() {
            let (lines, across) = (2 * i, 2 * i + 1);
            // What is no number says nothing.
            let low = |n: usize| boxes[n].0[lines].max(boxes[n].0[across]).max(f64::NEG_INFINITY);
            let high = |n: usize| boxes[n].1[lines].min(boxes[n].1[across]).min(f64::INFINITY);
            let min = DVec3::new(low(0), low(1), low(2));
            tile.bounds = Bounds { min, max: DVec3::new(high(0), high(1), high(2)) };
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
        let known = description.functions.iter().all(|function| function.is_known());
        let mut surface = Self {
            description,
            corners: Vec::new(),
            bvh: Bvh::new(Vec::new()),
            bounds: Bounds::EMPTY,
            known,
        };
        let places = (0..=TILES).flat_map(|u| (0..=TILES).map(move |v| (u, v)));
        surface.corners = places.map(|(u, v)| surface.point(surface.parameters(u, v))).collect();
        let container = surface.extent();
        let boxes = (0..(TILES * TILES / 2) as u32).flat_map(|pair| {
            let numbers = [2 * pair, 2 * pair + 1];
            let mut tiles = numbers.map(|number| surface.tile(number));
            surface.description.bound(&mut tiles);
            tiles.map(|tile| tile.bounds.intersection(container)).into_iter().zip(numbers)
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
            bounds: Bounds::ALL,
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
        let mut halves = [low, high];
        self.description.bound(&mut halves);
        halves
    }

    /// Calls back with every crossing; the answer is a new upper end.
    fn walk(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing) -> f64) {
        let Some(stretch) = self.description.container.stretch(ray).filter(|s| s.enter.t.is_finite()) else {
            return;
        };
        let speed = ray.direction.length();
        let finest = FINE * (self.description.to - self.description.from) / TILES as f64;
        let fine = finest.max_element().max(self.description.accuracy.min(finest.max_element() / FINE));
        let mut max = range.max;
        let mut waiting = Vec::new();
        let piece = Piece::new(self, ray);
        self.bvh.along(ray, range, |number| {
            let tile = self.tile(number);
            // Bands tell of a whole tile whether it has to be divided.
            if self.known {
                waiting.push(tile)
            } else {
                waiting.extend(self.halves(&tile))
            }
            while let Some(tile) = waiting.pop() {
                if !self.known {
                    let cuboid = Cuboid { min: tile.bounds.min, max: tile.bounds.max };
                    let Some(Stretch { enter, leave }) = cuboid.stretch(ray) else { continue };
                    let (low, high) = (enter.t.max(stretch.enter.t), leave.t.min(stretch.leave.t));
                    if low > high || high < range.min || low > max {
                        continue;
                    }
                    let small = (tile.to - tile.from).max_element() <= fine;
                    if !small && (leave.t - enter.t) * speed >= self.description.accuracy {
                        waiting.extend(self.halves(&tile));
                        continue;
                    }
                }
                piece.meet(tile.from, tile.to, &mut |crossing| {
                    let t = crossing.t;
                    if range.contains(t) && t < max && stretch.enter.t <= t && t <= stretch.leave.t {
                        max = found(crossing);
                    }
                });
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
        let room = SAME * (self.description.to - self.description.from).max_element();
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
mod tests;
