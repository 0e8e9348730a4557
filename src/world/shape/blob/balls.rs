//! Blobs that are made of balls: four in a row are asked side by side.

use std::ops::Range;

use super::part::{CLEAR, Part, Span};
use crate::math::{DVec3, Lanes};
use crate::world::Ray;

/// The numbers of balls in lists, each of which ends with room for three more.
#[derive(Clone, Debug, Default)]
pub(super) struct Balls {
    /// From space to that of each ball, in which its field ends at distance 1.
    scale: Vec<f64>,
    moved: [Vec<f64>; 3],
    strength: Vec<f64>,
}

/// Four numbers from one on.
#[inline(always)]
fn four(numbers: &[f64], from: usize) -> Lanes {
    numbers.get(from..).and_then(|rest| rest.first_chunk()).map_or(Lanes::ZERO, |four| Lanes(*four))
}

impl Balls {
    /// `None` unless all parts are balls.
    pub(super) fn new(parts: &[Part]) -> Option<Self> {
        let mut balls = Self::default();
        for part in parts {
            let (scale, moved) = part.even_ball()?;
            balls.scale.push(scale);
            for (all, moved) in balls.moved.iter_mut().zip(moved.to_array()) {
                all.push(moved);
            }
            balls.strength.push(part.strength);
        }
        let room = [0.0; Lanes::COUNT - 1];
        balls.scale.extend(room);
        balls.moved.iter_mut().for_each(|moved| moved.extend(room));
        balls.strength.extend(room);
        Some(balls)
    }

    /// Calls back with what [`Part::meet`] finds of up to four balls, to the last bit, until that returns `false`; whether
    /// it never did.
    #[inline(always)]
    pub(super) fn meet(&self, run: Range<usize>, ray: &Ray, mut found: impl FnMut(Span) -> bool) -> bool {
        let scale = four(&self.scale, run.start);
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let (mut f, mut e) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        for axis in 0..3 {
            f[axis] = scale * origin[axis] + four(&self.moved[axis], run.start);
            e[axis] = scale * direction[axis];
        }
        let (a, b, c) = (Lanes::dot(&e, &e), Lanes::dot(&f, &e), Lanes::dot(&f, &f));
        let least = c - 1.0;
        let aside =
            (a * least - b * b).zip(a * CLEAR * c, |aside, room| if aside > room { 1.0 } else { 0.0 });
        let mut near = ((1 << run.len()) - 1) & !aside.bits(|aside| aside > 0.0);
        if near == 0 {
            return true;
        }
        let strength = four(&self.strength, run.start);
        let along = b / a;
        for axis in 0..3 {
            f[axis] = f[axis] - along * e[axis];
        }
        let rest = Lanes::splat(1.0) - Lanes::dot(&f, &f);
        let q = -(b + (a * rest).sqrt().zip(b, f64::copysign));
        let (one, other) = (q / a, least / q);
        let (enter, leave) =
            (one.lesser(other), other.zip(one, |other, one| if one < other { other } else { one }));
        let peak = strength * rest * rest;
        while near != 0 {
            let lane = near.trailing_zeros() as usize % Lanes::COUNT;
            near &= near - 1;
            let (enter, leave, strength) = (enter.0[lane], leave.0[lane], strength.0[lane]);
            if enter < leave && leave.is_finite() && enter.is_finite() {
                let square = [c.0[lane], b.0[lane], a.0[lane]];
                if !found(Span { enter, leave, square, strength, peak: peak.0[lane].max(0.0) }) {
                    return false;
                }
            }
        }
        true
    }

    /// Calls back with the number of each of up to four balls whose field reaches a point, and with what
    /// [`Part::field`] tells.
    #[inline(always)]
    pub(super) fn fields(&self, run: Range<usize>, point: DVec3, mut found: impl FnMut(usize, f64, DVec3)) {
        let (scale, strength) = (four(&self.scale, run.start), four(&self.strength, run.start));
        let (mut from, point) = ([Lanes::ZERO; 3], point.to_array());
        for axis in 0..3 {
            from[axis] = scale * point[axis] + four(&self.moved[axis], run.start);
        }
        let rest = Lanes::splat(1.0) - Lanes::dot(&from, &from);
        let mut near = ((1 << run.len()) - 1) & rest.bits(|rest| rest > 0.0);
        if near == 0 {
            return;
        }
        let steep = strength * -4.0 * rest;
        let slope = [steep * from[0] * scale, steep * from[1] * scale, steep * from[2] * scale];
        let field = strength * rest * rest;
        while near != 0 {
            let lane = near.trailing_zeros() as usize % Lanes::COUNT;
            near &= near - 1;
            found(run.start + lane, field.0[lane], Lanes::point(&slope, lane));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Transform;
    use crate::math::dice::numbers;
    use crate::world::shape::OWN_TEXTURE;

    #[test]
    fn four_balls_are_what_each_is_alone() {
        let mut number = numbers(17);
        let mut seen = [0; 3];
        for turn in 0..3000 {
            let mut point = || DVec3::new(number(), number(), number());
            let parts: Vec<Part> = (0..1 + turn % 6)
                .map(|_| {
                    let place = Transform::scale(DVec3::splat(0.2 + point().x.abs()));
                    Part::ball(&place.then(&Transform::translate(point())), point().x, OWN_TEXTURE)
                })
                .collect();
            let balls = Balls::new(&parts).unwrap();
            let (ray, place) = (Ray::new(2.0 * point(), point()), point());
            for start in 0..parts.len() {
                let run = start..parts.len().min(start + Lanes::COUNT);
                let mut met = Vec::new();
                balls.meet(run.clone(), &ray, |span| {
                    met.push(span);
                    true
                });
                let alone: Vec<Span> = parts[run.clone()].iter().filter_map(|part| part.meet(&ray)).collect();
                assert_eq!(met, alone, "{ray:?}");
                seen[met.len().min(1)] += 1;
                let (mut around, mut each) = (Vec::new(), Vec::new());
                balls.fields(run.clone(), place, |number, field, slope| around.push((number, field, slope)));
                for number in run {
                    let (field, slope) = parts[number].field(place);
                    if field != 0.0 {
                        each.push((number, field, slope));
                    }
                }
                assert_eq!(around, each, "{place}");
                seen[2] += around.len();
            }
        }
        assert!(seen.iter().all(|count| *count > 1000), "{seen:?}");
    }

    #[test]
    fn what_is_no_ball_is_not_taken_for_one() {
        let turned = Transform::scale(DVec3::new(1.0, 2.0, 1.0));
        assert!(Balls::new(&[Part::ball(&turned, 1.0, OWN_TEXTURE)]).is_none());
        assert!(Balls::new(&Part::capsule(&Transform::scale(DVec3::ONE), 1.0, 1.0, OWN_TEXTURE)).is_none());
    }
}
