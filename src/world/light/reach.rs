//! Which part of a ray a light's cone or beam reaches (docs/spec/atmosphere-gi.md 2.5).

use super::{Kind, Light};
use crate::math::DVec3;
use crate::world::ray::{Range, Ray};

/// Stretches that end nearer to the origin of the ray than this don't count.
const NEAREST: f64 = 0.001;

impl Light {
    /// The part of a ray between 0 and `length` inside the light's cone or beam; all of it for
    /// lights without one. `None` where the light doesn't reach.
    pub fn reach(&self, ray: &Ray, length: f64) -> Option<Range> {
        let from = ray.origin - self.location;
        let inside = match &self.kind {
            Kind::Point => return Some(Range { min: 0.0, max: length }),
            Kind::Spotlight(spot) => cone(from, ray.direction, self.axis, spot.cos_falloff()),
            Kind::Cylinder(cylinder) => beam(from, ray.direction, self.axis, cylinder.falloff),
        }?;
        let counts = inside.min < length && inside.max > NEAREST;
        counts.then(|| Range { min: inside.min.max(0.0), max: inside.max.min(length) })
    }
}

/// The part of the line `from + t direction` inside the cone around the unit `axis` from the origin,
/// where the cosine to the axis is over `cosine`; cones wider than a half-space count as one.
fn cone(from: DVec3, direction: DVec3, axis: DVec3, cosine: f64) -> Option<Range> {
    let ahead = half_space(from.dot(axis), direction.dot(axis))?;
    if cosine <= 0.0 {
        return Some(ahead);
    }
    // Where (p·axis)² - cosine² p² has its zeros, from the point of the line nearest to the tip.
    let middle = -from.dot(direction);
    let near = from + middle * direction;
    let (along, slope) = (near.dot(axis), direction.dot(axis));
    let square = cosine * cosine;
    let a = slope * slope - square;
    let b = along * slope;
    let c = along * along - square * near.length_squared();
    let root = b * b - a * c;
    let inside = if a < 0.0 {
        // Steeper than the cone: inside between the zeros.
        if root <= 0.0 {
            return None;
        }
        ordered((b + root.sqrt()) / -a, (b - root.sqrt()) / -a)
    } else {
        // Both halves of the double cone are met, or the tip: inside beyond the zero ahead.
        let edge = match a {
            0.0 if b == 0.0 => return None,
            0.0 => -c / (2.0 * b),
            _ if slope > 0.0 => (-b + root.max(0.0).sqrt()) / a,
            _ => (-b - root.max(0.0).sqrt()) / a,
        };
        if slope > 0.0 {
            Range { min: edge, max: f64::INFINITY }
        } else {
            Range { min: f64::NEG_INFINITY, max: edge }
        }
    };
    overlap(ahead, Range { min: inside.min + middle, max: inside.max + middle })
}

/// The part of a line inside the beam of some radius around the unit `axis`, ahead of the origin.
fn beam(from: DVec3, direction: DVec3, axis: DVec3, radius: f64) -> Option<Range> {
    let ahead = half_space(from.dot(axis), direction.dot(axis))?;
    let off = from - from.dot(axis) * axis;
    let drift = direction - direction.dot(axis) * axis;
    let a = drift.length_squared();
    let b = off.dot(drift);
    let inside = if a == 0.0 {
        (off.length() < radius).then_some(Range::LINE)?
    } else {
        let near = off - b / a * drift;
        let square = radius * radius - near.length_squared();
        let half = (square > 0.0).then(|| (square / a).sqrt())?;
        Range { min: -b / a - half, max: -b / a + half }
    };
    overlap(ahead, inside)
}

/// Where `height + t slope` is positive.
fn half_space(height: f64, slope: f64) -> Option<Range> {
    let crossing = -height / slope;
    if slope == 0.0 {
        (height > 0.0).then_some(Range::LINE)
    } else if slope > 0.0 {
        Some(Range { min: crossing, max: f64::INFINITY })
    } else {
        Some(Range { min: f64::NEG_INFINITY, max: crossing })
    }
}

fn ordered(a: f64, b: f64) -> Range {
    Range { min: a.min(b), max: a.max(b) }
}

fn overlap(a: Range, b: Range) -> Option<Range> {
    let both = Range { min: a.min.max(b.min), max: a.max.min(b.max) };
    (both.min < both.max).then_some(both)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::world::light::{Cylinder, Spotlight};

    fn light(kind: Kind) -> Light {
        Light {
            location: DVec3::new(1.0, 2.0, 3.0),
            point_at: DVec3::new(1.0, -2.0, 4.0),
            axis: DVec3::new(0.0, -4.0, 1.0).normalize(),
            ..super::super::tests::light(kind)
        }
    }

    /// Along many lines the parts said to be reached are those that get light.
    fn check(light: &Light) {
        const LENGTH: f64 = 12.0;
        let number = |i: u32| f64::from(i.wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 24) - 0.5;
        let mut reached = 0;
        for i in 0..2000 {
            let place = |k: u32| number(6 * i + k);
            let origin = 10.0 * DVec3::new(place(0), place(1), place(2));
            let Some(direction) = DVec3::new(place(3), place(4), place(5)).try_normalize() else { continue };
            let ray = Ray::new(origin, direction);
            let reach = light.reach(&ray, LENGTH);
            reached += u32::from(reach.is_some());
            for step in 0..60 {
                let t = (f64::from(step) + 0.5) / 60.0 * LENGTH;
                let lit = light.reaching(ray.at(t)).attenuation > 0.0;
                let said = reach.is_some_and(|reach| reach.contains(t));
                let edge = reach.is_some_and(|r| (t - r.min).abs().min((t - r.max).abs()) < 1e-6);
                assert!(lit == said || edge, "ray {i} at {t}: {reach:?}");
            }
        }
        assert!(reached > 50, "{reached}");
    }

    #[test]
    fn cones_reach_where_they_light() {
        for falloff in [3.0, 20.0, 45.0, 80.0, 90.0] {
            check(&light(Kind::Spotlight(Spotlight::new(falloff, falloff, 0.0))));
        }
    }

    #[test]
    fn beams_reach_where_they_light() {
        check(&light(Kind::Cylinder(Cylinder { radius: 1.5, falloff: 1.5, tightness: 0.0 })));
    }

    #[test]
    fn rays_along_the_axis_stay_inside() {
        let spot = light(Kind::Spotlight(Spotlight::new(20.0, 20.0, 0.0)));
        let ray = Ray::new(spot.location, spot.axis);
        assert_eq!(spot.reach(&ray, 5.0), Some(Range { min: 0.0, max: 5.0 }));
        let against = Ray::new(spot.location - 2.0 * spot.axis, spot.axis);
        let reach = spot.reach(&against, 5.0).unwrap();
        assert!((reach.min - 2.0).abs() < 1e-12 && reach.max == 5.0, "{reach:?}");
    }
}
