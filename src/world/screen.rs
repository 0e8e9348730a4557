//! What may be in the way of light, by a ball around it and one inside of it: most ways miss the one
//! or meet the other, so that the surface itself need not be asked.
//!
//! A verdict is only given where no rounding can change it, so it is the one the surface would give.

use super::object::{Leaf, LeafFlags, Member, RayKind};
use super::parts::{Object, Parts};
use super::shape::Primitive;
use crate::math::{DVec3, Transform};

/// Relative errors of distances and coordinates stay below these.
const BLUR: f64 = 1e-9;
const ROUNDING: f64 = 1e-12;

/// An object that may throw a shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// Its number.
    pub object: u32,
    center: DVec3,
    /// It is in the ball of this radius.
    outer: f64,
    /// It fills the ball of this radius, and lets no light through; negative for none.
    inner: f64,
    /// A point that many ways lead to, and the screen as seen from there.
    eye: DVec3,
    view: View,
}

/// Whether a screen is in the way. The greatest verdict of several screens is that of all.
pub type Verdict = f64;

/// It isn't.
pub const OPEN: Verdict = 0.0;
/// Only the surface knows.
pub const UNKNOWN: Verdict = 1.0;
/// It is.
pub const SHUT: Verdict = 2.0;

/// A screen as a point sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// To the balls' middle.
    toward: DVec3,
    /// Squared length of the tangents to the balls; where the point is inside one, what no way passes.
    outer: f64,
    inner: f64,
    /// Ways whose middle isn't farther along than this lead away from the outer ball.
    away: f64,
}

impl Screen {
    /// The screen that an object is for ways that mostly lead to `eye`; `None` for one that throws no
    /// shadows.
    pub(super) fn new(number: u32, object: &Object, parts: &Parts, eye: DVec3) -> Option<Self> {
        if parts.hidden(object.member).intersects(RayKind::SHADOW) {
            return None;
        }
        let bounds = &parts.extent(object.member).bounds;
        let (mut center, mut outer, mut inner) = (bounds.center(), bounds.size().length() / 2.0, -1.0);
        if let Member::Leaf(leaf) = object.member {
            let leaf = parts.leaf(leaf);
            if let Some(balls) = Balls::of(leaf).filter(|_| !leaf.is_limited()) {
                (center, outer) = (balls.center, balls.outer);
                inner = if leaf.flags.contains(LeafFlags::OPAQUE) { balls.inner } else { -1.0 };
            }
        }
        let view = View::of(center, outer, inner, eye);
        Some(Self { object: number, center, outer, inner, eye, view })
    }

    /// How it is seen from the point that most ways lead to.
    #[inline]
    pub fn as_seen(&self) -> &View {
        &self.view
    }

    /// The screen as seen from a point.
    #[inline(always)]
    pub fn from(&self, point: DVec3) -> View {
        if point == self.eye { self.view } else { View::of(self.center, self.outer, self.inner, point) }
    }
}

impl View {
    /// The balls of two radii as seen from a point.
    #[inline]
    fn of(center: DVec3, outer_radius: f64, inner_radius: f64, point: DVec3) -> Self {
        let toward = center - point;
        let square = toward.length_squared();
        let rounding = ROUNDING * point.abs().max(center.abs()).max_element();
        let outer = outer_radius * (1.0 + BLUR) + rounding;
        let inner = inner_radius * (1.0 - BLUR) - rounding;
        let outside = square * (1.0 - ROUNDING) - outer * outer;
        let beyond = square * (1.0 + ROUNDING) - inner * inner;
        Self {
            toward,
            outer: if outside > 0.0 { outside } else { f64::NEG_INFINITY },
            inner: if inner > 0.0 && outside > 0.0 { beyond } else { f64::INFINITY },
            // Where rays start on a ball it is far enough outside not to meet it again.
            away: if square > outer_radius * outer_radius { 0.0 } else { f64::NEG_INFINITY },
        }
    }

    /// Whether it is in the way of light that comes along `way`, from its end to the point.
    #[inline(always)]
    pub fn verdict(&self, [x, y, z]: [f64; 3]) -> Verdict {
        let along = self.toward.x * x + self.toward.y * y + self.toward.z * z;
        let square = x * x + y * y + z * z;
        let reach = along * along;
        let misses = (along <= self.away) | (reach < self.outer * square);
        let meets = (along > 0.0) & (along < square) & (reach > self.inner * square);
        let verdict = if misses { OPEN } else { UNKNOWN };
        if meets { SHUT } else { verdict }
    }

    /// What it is to all ways of a bundle from the point; unknown where it isn't the same to all.
    #[inline]
    pub fn verdict_on_all(&self, cone: &Cone) -> Verdict {
        let along = self.toward.dot(cone.axis);
        let square = self.toward.length_squared();
        let distance = square.sqrt();
        let blur = BLUR * distance;
        // The cosine of the angles of bundle and ball together, times the distance, and that of their
        // difference.
        let radius = (square - self.outer).sqrt();
        let apart = cone.cos * self.outer.sqrt() - cone.sin * radius;
        if self.outer >= 0.0 && (along < apart - blur || distance - radius > cone.far) {
            return OPEN;
        }
        let radius = (square - self.inner).sqrt();
        let within = cone.cos * self.inner.sqrt() + cone.sin * radius;
        let wide = radius > cone.sin * distance + blur;
        if wide && along > within + blur && distance < cone.near { SHUT } else { UNKNOWN }
    }
}

/// A bundle of ways from a point to the places of an area light.
#[derive(Clone, Copy, Debug)]
pub struct Cone {
    axis: DVec3,
    /// The half-angle.
    cos: f64,
    sin: f64,
    /// The least distance of a place, and the greatest.
    near: f64,
    far: f64,
}

impl Cone {
    /// The bundle to all places that are no farther than `radius` from the end of `way`; `None` where
    /// that is all around.
    pub fn new(way: DVec3, radius: f64) -> Option<Self> {
        let length = way.length();
        let sin = radius / length * (1.0 + BLUR);
        let known = sin < 1.0 && length.is_finite();
        known.then(|| Self {
            axis: way / length,
            cos: (1.0 - sin * sin).sqrt(),
            sin,
            near: (length - radius) * (1.0 - BLUR),
            far: (length + radius) * (1.0 + BLUR),
        })
    }
}

/// The verdict on a way of several screens, each with how it is seen, if that is known; `near` is
/// filled with those that only their surfaces can decide on.
#[inline]
pub fn sift<'a>(
    screens: impl Iterator<Item = (&'a Screen, Option<&'a View>)>,
    way: DVec3,
    near: &mut Vec<u32>,
) -> Verdict {
    let way = way.to_array();
    near.clear();
    let mut verdict = OPEN;
    for (screen, view) in screens {
        let found = view.map_or(UNKNOWN, |view| view.verdict(way));
        if found == UNKNOWN {
            near.push(screen.object);
        }
        verdict = verdict.max(found);
    }
    verdict
}

/// The balls of a leaf that is all but round, or lies around a point.
struct Balls {
    center: DVec3,
    outer: f64,
    inner: f64,
}

impl Balls {
    fn of(leaf: &Leaf) -> Option<Self> {
        let own = match &leaf.primitive {
            Primitive::Sphere(sphere) => {
                let radius = sphere.radius.abs();
                Self { center: sphere.center, outer: radius, inner: radius }
            }
            Primitive::Box(solid) => {
                let half = (solid.max - solid.min) / 2.0;
                Self { center: solid.min + half, outer: half.length(), inner: half.min_element() }
            }
            Primitive::Torus(torus) => {
                Self { center: DVec3::ZERO, outer: torus.major + torus.minor, inner: -1.0 }
            }
            _ => return None,
        };
        let Some(transform) = &leaf.transform else { return Some(own) };
        let scale = scale(transform)?;
        Some(Self { center: transform.point(own.center), outer: own.outer * scale, inner: own.inner * scale })
    }
}

/// How much a transform makes everything larger; `None` where that depends on the direction.
pub(super) fn scale(transform: &Transform) -> Option<f64> {
    let [x, y, z] = DVec3::AXES.map(|axis| transform.vector(axis));
    let square = x.length_squared();
    let off = [x.dot(y), y.dot(z), z.dot(x), y.length_squared() - square, z.length_squared() - square];
    off.iter().all(|off| off.abs() <= ROUNDING * square).then(|| square.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn verdicts_are_those_of_the_balls() {
        let mut number = numbers(11);
        let mut seen = [0; 3];
        for _ in 0..20_000 {
            let mut point = || 4.0 * DVec3::new(number(), number(), number());
            let (from, lamp, center) = (point(), point(), point());
            let inner = 0.3 + number().abs();
            let outer = inner + number().abs();
            let way = lamp - from;
            let nearest = from + way * ((center - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            let distance = nearest.distance(center);
            let view = View::of(center, outer, inner, from);
            let verdict = view.verdict(way.to_array());
            seen[verdict as usize] += 1;
            assert!(verdict != OPEN || distance > outer, "{from} {lamp} {center} {outer}");
            assert!(verdict != SHUT || distance < inner, "{from} {lamp} {center} {inner}");
        }
        assert!(seen.iter().all(|&count| count > 300), "{seen:?}");
    }

    #[test]
    fn verdicts_on_a_bundle_are_those_on_its_ways() {
        let mut number = numbers(17);
        let mut seen = [0; 3];
        for _ in 0..4000 {
            let mut point = || 4.0 * DVec3::new(number(), number(), number());
            let (from, lamp, center) = (point(), point(), point());
            let (inner, outer) = (0.5, 0.5 + number().abs());
            let radius = number().abs();
            let Some(cone) = Cone::new(lamp - from, radius) else { continue };
            let verdict = View::of(center, outer, inner, from).verdict_on_all(&cone);
            seen[verdict as usize] += 1;
            for _ in 0..40 {
                let aside = DVec3::new(number(), number(), number()).normalize() * radius;
                let way = lamp + aside - from;
                let share = ((center - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
                let distance = (from + way * share).distance(center);
                assert!(verdict != OPEN || distance > outer, "{from} {lamp} {center} {radius}");
                assert!(verdict != SHUT || distance < inner, "{from} {lamp} {center} {radius}");
            }
        }
        assert!(seen.iter().all(|&count| count > 20), "{seen:?}");
    }

    #[test]
    fn only_transforms_that_keep_balls_round_have_a_scale() {
        let turned =
            Transform::rotate(DVec3::new(20.0, 30.0, 40.0)).then(&Transform::scale(DVec3::splat(3.0)));
        assert!((scale(&turned).unwrap() - 3.0).abs() < 1e-12);
        assert_eq!(scale(&Transform::scale(DVec3::new(1.0, 1.0, 2.0))), None);
    }
}
