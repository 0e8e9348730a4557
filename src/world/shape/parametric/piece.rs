//! The crossings of a ray with a piece of a parametric surface.
//!
//! A part of the piece is taken for the plane that touches it in the middle, and for what it leaves that plane by.
//! That rules it out, narrows it, or tells that it isn't folded over seen along the ray: then it has one crossing at
//! most, and Newton's method finds it. What is still open is halved. All this is proven where bands of the functions'
//! derivatives are known (docs/spec/primitives.md 4.6). Close to a fold parts are turned so that they
//! lie along the ray, where two crossings are far apart however little the ray goes below the surface.

use smallvec::SmallVec;

use super::local::Local;
use super::{Crossing, Parametric};
use crate::math::{DMat2, DVec2, DVec3};
use crate::world::Ray;
use crate::world::shape::triangle::{Sheared, blend};

/// Steps of Newton's method before it is given up.
const TRIES: usize = 20;

/// By how much of its size a crossing may be beside the part it was looked for in: the neighbour finds it too.
const BESIDE: f64 = 1e-6;

/// Newton's method has got somewhere when its steps are this small a share of the part.
const NEAR: f64 = 0.05;

/// Times a piece is halved or narrowed, at most.
const HALVINGS: u32 = 80;

/// After so many halvings a part is turned, and again and again.
const TURNED_AFTER: u32 = 3;

/// Parts that are looked at in all: poles have many.
const PARTS: usize = 2000;

/// By how much the slopes of a part may change, as a share of themselves, that is taken to have no fold. Below 1 no
/// two points of the part are seen at the same place; the rest is for what isn't bounded where derivatives aren't
/// known, and for a Newton's method that gets somewhere.
const EVEN: f64 = 0.75;

/// A part is narrowed where this share of it is left, or less.
const NARROW: f64 = 0.6;

/// A surface and a ray.
pub(super) struct Piece<'a> {
    surface: &'a Parametric,
    /// The ray from where it is nearest to the surface's middle, so that few digits are lost.
    ray: Ray,
    shift: f64,
    /// Two unit vectors across the ray.
    across: [DVec3; 2],
}

/// A parallelogram of parameters: the middle, and from there to the middles of two sides.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub(super) middle: DVec2,
    pub(super) sides: [DVec2; 2],
    /// How often it was halved, narrowed or turned.
    pub(super) depth: u32,
    /// How often it was halved since it was turned.
    pub(super) halved: u32,
}

impl Part {
    /// A place given by shares of the sides.
    pub(super) fn at(&self, shares: DVec2) -> DVec2 {
        self.middle + self.sides[0] * shares.x + self.sides[1] * shares.y
    }

    /// What is between these shares of the sides.
    fn between(&self, low: DVec2, high: DVec2) -> Self {
        let half = 0.5 * (high - low);
        let sides = [self.sides[0] * half.x, self.sides[1] * half.y];
        Self { middle: self.at(0.5 * (low + high)), sides, depth: self.depth + 1, ..*self }
    }

    fn halves(&self, across: usize) -> [Self; 2] {
        let (mut low, mut high) = (DVec2::ONE, DVec2::NEG_ONE);
        (low[across], high[across]) = (0.0, 0.0);
        let both = [self.between(DVec2::NEG_ONE, low), self.between(high, DVec2::ONE)];
        both.map(|half| Self { halved: self.halved + 1, ..half })
    }

    /// One around it with a side that runs this way, given by shares of the sides: sheared, so that it stays as narrow
    /// as it is and grows twofold at most.
    fn turned(&self, way: DVec2) -> Self {
        let along = usize::from(way.x.abs() < way.y.abs());
        let share = way[1 - along] / way[along];
        let share = if share.is_finite() { share } else { 0.0 };
        let mut sides = self.sides;
        sides[along] += share * sides[1 - along];
        sides[1 - along] *= 1.0 + share.abs();
        Self { sides, depth: self.depth + 1, halved: 0, ..*self }
    }
}

/// What a part has of a ray.
enum Found {
    /// One crossing at most, between these shares of the sides.
    One(DVec2, DVec2),
    /// No crossing.
    None,
    /// Crossings only between these shares of the sides.
    Between(DVec2, DVec2),
    /// It has to be halved across this side.
    Open(usize),
    /// Rounding decides whether there is a crossing.
    Blurred,
}

/// The rectangle of parameters that crossings are looked for in, and those found.
struct Catch {
    from: DVec2,
    to: DVec2,
    /// With what they may be off by.
    found: SmallVec<[(DVec2, DVec2); 4]>,
}

impl<'a> Piece<'a> {
    pub(super) fn new(surface: &'a Parametric, ray: &Ray) -> Self {
        let middle = surface.bounds.center();
        let shift = (middle - ray.origin).dot(ray.direction) / ray.direction.length_squared();
        let (u, v) = ray.direction.normalize().any_orthonormal_pair();
        let near = Ray::new(ray.at(shift), ray.direction);
        Self { surface, ray: near, shift, across: [u, v] }
    }

    /// Calls back with the crossings in a rectangle of parameters.
    pub(super) fn meet(&self, from: DVec2, to: DVec2, found: &mut dyn FnMut(Crossing)) {
        let half = 0.5 * (to - from);
        let sides = [half * DVec2::X, half * DVec2::Y];
        let mut waiting: SmallVec<[Part; 16]> = SmallVec::new();
        waiting.push(Part { middle: 0.5 * (from + to), sides, depth: 0, halved: 0 });
        let mut catch = Catch { from, to, found: SmallVec::new() };
        let mut parts = 0;
        while let Some(mut part) = waiting.pop() {
            if catch.is_beside(&part) {
                continue;
            }
            parts += 1;
            let mut local = self.surface.local(&part);
            let mut look = self.look(&local);
            if matches!(look, Found::Open(_)) {
                local = self.surface.closer(&part, local);
                look = self.look(&local);
            }
            let across = match look {
                Found::None => continue,
                Found::Between(low, high) if part.depth < HALVINGS => {
                    waiting.push(part.between(low, high));
                    continue;
                }
                Found::One(low, high) => match self.refine(&part, 0.5 * (low + high), &mut catch) {
                    Some(hit) => {
                        hit.into_iter().for_each(&mut *found);
                        continue;
                    }
                    None => {
                        part = part.between(low, high);
                        usize::from(part.sides[0].length_squared() < part.sides[1].length_squared())
                    }
                },
                Found::Open(across) => across,
                Found::Between(..) | Found::Blurred => 0,
            };
            if matches!(look, Found::Blurred) || part.depth >= HALVINGS || parts >= PARTS {
                self.flat(&part, &mut catch).into_iter().for_each(&mut *found);
            } else if part.halved >= TURNED_AFTER {
                waiting.push(part.turned(local.way(self.ray.direction)));
            } else {
                waiting.extend(part.halves(across));
            }
        }
    }

    fn project(&self, v: DVec3) -> DVec2 {
        DVec2::from_array(self.across.map(|axis| axis.dot(v)))
    }

    /// At least what a vector, whose coordinates are at most these, has across the ray.
    fn room(&self, v: DVec3) -> DVec2 {
        DVec2::from_array(self.across.map(|axis| axis.abs().dot(v)))
    }

    fn look(&self, local: &Local) -> Found {
        let off = self.project(local.point - self.ray.origin);
        let slopes = local.slopes.map(|slope| self.project(slope));
        let room = self.room(local.room);
        let inverse = DMat2::from_cols(slopes[0], slopes[1]).inverse();
        let size = DMat2::from_cols(inverse.x_axis.abs(), inverse.y_axis.abs());
        let start = -(inverse * off);
        let mut low = DVec2::NEG_ONE;
        let mut high = DVec2::ONE;
        // What is no number rules nothing out.
        let mut meet = |side: usize, middle: f64, beside: f64| {
            low[side] = low[side].max(middle - beside - BESIDE);
            high[side] = high[side].min(middle + beside + BESIDE);
        };
        let beside = size * room;
        meet(0, start.x, beside.x);
        meet(1, start.y, beside.y);
        for side in [0, 1] {
            // Seen along one side, whatever the other does.
            let (along, other) = (slopes[side], slopes[1 - side]);
            let square = along.length_squared();
            let beside = along.dot(other).abs() + along.abs().dot(room);
            meet(side, -along.dot(off) / square, beside / square);
        }
        if low.cmpgt(high).any() || off.abs().cmpgt(slopes[0].abs() + slopes[1].abs() + room).any() {
            return Found::None;
        }
        let norm = |m: DMat2| (m.x_axis + m.y_axis).max_element();
        let columns = |turns: [DVec3; 2]| {
            let [u, v] = turns.map(|turn| self.room(turn));
            DMat2::from_cols(u, v)
        };
        if norm(size * columns(local.turns)) < EVEN {
            return Found::One(low, high);
        }
        if (high - low).min_element() < 2.0 * NARROW {
            return Found::Between(low, high);
        }
        if room.cmple(2.0 * self.room(local.rounding)).all() {
            return Found::Blurred;
        }
        let [by_u, by_v] = local.along.map(|turns| norm(size * columns(turns)));
        Found::Open(usize::from(by_u.is_nan() || by_v.is_nan() || by_u < by_v))
    }

    /// The crossing in a part that has one at most; `None` where Newton's method leads nowhere or out of the part,
    /// which doesn't prove that there is none.
    fn refine(&self, part: &Part, start: DVec2, catch: &mut Catch) -> Option<Option<Crossing>> {
        let shares = DMat2::from_cols(part.sides[0], part.sides[1]).inverse();
        let mut at = part.at(start.clamp(DVec2::NEG_ONE, DVec2::ONE));
        let mut inverse = DMat2::ZERO;
        let mut last = f64::INFINITY;
        for _ in 0..TRIES {
            if last > BESIDE {
                let [u, v] = self.surface.slopes(at).map(|slope| self.project(slope));
                inverse = DMat2::from_cols(u, v).inverse();
            }
            let by = inverse * self.project(self.ray.origin - self.surface.point(at));
            let length = (shares * by).abs().max_element();
            if length.is_nan() || length > 4.0 {
                return None;
            }
            at += by;
            // Rounding alone moves it any more.
            let ends = length < NEAR && length >= 0.5 * last || length == 0.0;
            last = length;
            if ends {
                break;
            }
            if (shares * (at - part.middle)).abs().max_element() > 4.0 {
                return None;
            }
        }
        if last >= NEAR {
            return None;
        }
        let beside = BESIDE + 2.0 * last;
        if (shares * (at - part.middle)).abs().max_element() > 1.0 + beside {
            return None;
        }
        let off = beside * (part.sides[0].abs() + part.sides[1].abs());
        Some(catch.take(at, off, self.surface).then(|| {
            let at = at.clamp(self.surface.description.from, self.surface.description.to);
            let way = self.surface.point(at) - self.ray.origin;
            let t = self.shift + way.dot(self.ray.direction) / self.ray.direction.length_squared();
            Crossing { t, part: 0, at: at.to_array() }
        }))
    }

    /// The crossing with a part that is as small as it gets, or beside a kink or a pole.
    fn flat(&self, part: &Part, catch: &mut Catch) -> Option<Crossing> {
        let corner = |u: f64, v: f64| {
            let at = part.at(DVec2::new(u, v)).clamp(catch.from, catch.to);
            (at, self.surface.point(at))
        };
        let [near, up, right, far] =
            [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, -1.0), corner(1.0, 1.0)];
        let sheared = Sheared::new(&self.ray);
        let (at, t) = [[near, right, up], [far, up, right]].into_iter().find_map(|corners| {
            let hit = sheared.meet(corners.map(|corner| corner.1))?;
            Some((blend(corners.map(|corner| corner.0), hit.at), hit.t))
        })?;
        let off = part.sides[0].abs() + part.sides[1].abs();
        catch.take(at, off, self.surface).then(|| Crossing { t: self.shift + t, part: 0, at: at.to_array() })
    }
}

impl Catch {
    /// Whether no place of a part is in the rectangle.
    fn is_beside(&self, part: &Part) -> bool {
        let half = part.sides[0].abs() + part.sides[1].abs();
        let room = half + BESIDE * (self.to - self.from);
        part.middle.cmplt(self.from - room).any() || part.middle.cmpgt(self.to + room).any()
    }

    /// Whether a crossing is in the rectangle, and a new one.
    fn take(&mut self, at: DVec2, off: DVec2, surface: &Parametric) -> bool {
        let room = BESIDE * (self.to - self.from);
        let all = &surface.description;
        let ends = f64::EPSILON * (all.from.abs() + all.to.abs());
        let there = at.cmpge((self.from - room).max(all.from - ends)).all()
            && at.cmple((self.to + room).min(all.to + ends)).all();
        let new = self.found.iter().all(|(other, beside)| (*other - at).abs().cmpgt(*beside + off).any());
        if there && new {
            self.found.push((at, off));
        }
        there && new
    }
}
