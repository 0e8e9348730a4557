//! `blob` (docs/spec/primitives.md 5.1).

mod balls;
mod part;
mod walk;

use self::balls::Balls;
pub use self::part::Part;
use self::walk::{Sought, Spans, Walk, Walked};
use super::{Crossing, OWN_TEXTURE, Shape, downhill, uncrossed};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec3, Lanes};
use crate::world::accel::Bvh;
use crate::world::{Range, Ray, Rays};

/// The surface on which the fields of all parts add up to a threshold; inside they are stronger.
#[derive(Clone, Debug)]
pub struct Blob {
    parts: Vec<Part>,
    /// The same, where all are balls.
    balls: Option<Balls>,
    threshold: f64,
    bounds: Bounds,
    bvh: Bvh,
    /// Whether any part has a texture of its own.
    textured: bool,
    /// Whether any part weakens the field.
    carves: bool,
}

/// Parts that are asked one after the other.
const RUN: usize = 4;

impl Blob {
    /// From parts of any size. Parts without strength are left out.
    pub fn new(mut parts: Vec<Part>, threshold: f64) -> Self {
        parts.retain(|part| part.strength != 0.0 && part.bounds.is_finite());
        let boxes = (0..).zip(&parts).map(|(number, part)| (part.bounds, number));
        let (bvh, order) = Bvh::with_runs(boxes, RUN);
        let parts: Vec<Part> = order.into_iter().map(|number| parts[number as usize].clone()).collect();
        let strong = parts.iter().filter(|part| part.strength > 0.0);
        let bounds = if threshold > 0.0 {
            strong.fold(Bounds::EMPTY, |all, part| all.union(part.bounds))
        } else {
            Bounds::ALL
        };
        let textured = parts.iter().any(|part| part.texture != OWN_TEXTURE);
        let carves = parts.iter().any(|part| part.strength < 0.0);
        Self { bvh, balls: Balls::new(&parts), parts, threshold, bounds, textured, carves }
    }

    /// Strength at a point above the threshold, and the gradient.
    fn value(&self, point: DVec3) -> (f64, DVec3) {
        widest(
            #[inline(always)]
            || {
                let (mut value, mut slope) = (-self.threshold, DVec3::ZERO);
                self.around(
                    point,
                    #[inline(always)]
                    |_, field, gradient| {
                        value += field;
                        slope += gradient;
                    },
                );
                (value, slope)
            },
        )
    }

    /// Calls back with every part whose field reaches a point.
    #[inline(always)]
    fn around(&self, point: DVec3, mut found: impl FnMut(&Part, f64, DVec3)) {
        self.bvh.any_run_around(
            point,
            #[inline(always)]
            |run| {
                if let Some(balls) = &self.balls {
                    balls.fields(
                        run,
                        point,
                        #[inline(always)]
                        |number, field, gradient| found(&self.parts[number], field, gradient),
                    );
                    return false;
                }
                for part in &self.parts[run] {
                    let (field, gradient) = part.field(point);
                    if field != 0.0 {
                        found(part, field, gradient);
                    }
                }
                false
            },
        );
    }

    /// Calls back with the distance of every crossing within the range or close to it, ascending, until it
    /// returns `false`; some may be left out, as `sought` says.
    fn walk(&self, ray: &Ray, range: Range, sought: Sought, found: impl FnMut(f64) -> bool) -> Walked {
        let mut spans = Spans::new();
        let mut walk = Walk::new(self, ray, range, sought, &mut spans);
        let moved = walk.ray;
        widest(
            #[inline(always)]
            || {
                self.bvh.runs_along(
                    &moved,
                    walk.line,
                    #[inline(always)]
                    |run| {
                        if let Some(balls) = &self.balls {
                            let more = balls.meet(
                                run,
                                &moved,
                                #[inline(always)]
                                |span| walk.add(span),
                            );
                            return if more { walk.line.max } else { f64::NEG_INFINITY };
                        }
                        for part in &self.parts[run] {
                            if !walk.take(part) {
                                return f64::NEG_INFINITY;
                            }
                        }
                        walk.line.max
                    },
                );
                walk.cross(found)
            },
        )
    }
}

impl Shape for Blob {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.walk(ray, range, Sought::All, |t| {
            if range.contains(t) {
                out.push(Crossing::new(t, 0));
            }
            t < range.max
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let seek = |sought| {
            let mut nearest = None;
            let walked = self.walk(ray, range, sought, |t| {
                nearest = range.contains(t).then(|| Crossing::new(t, 0));
                nearest.is_none() && t < range.max
            });
            (nearest, walked)
        };
        // A ray that starts inside may meet nothing before the middle of a part.
        match seek(Sought::First) {
            (None, Walked::Briefly) => seek(Sought::All).0,
            (nearest, _) => nearest,
        }
    }

    fn nearest_together(
        &self,
        rays: &Rays,
        asked: u32,
        ends: &Lanes,
        found: &mut [Option<Crossing>; Lanes::COUNT],
    ) -> bool {
        let range = |lane: usize| Range { min: 0.0, max: ends.0[lane].next_up() };
        let (mut a, mut b, mut c, mut d) = (Spans::new(), Spans::new(), Spans::new(), Spans::new());
        let walk = |lane: usize, spans| Walk::new(self, &rays.ray(lane), range(lane), Sought::First, spans);
        let mut walks = [walk(0, &mut a), walk(1, &mut b), walk(2, &mut c), walk(3, &mut d)];
        let moved = Rays::of(&[walks[0].ray, walks[1].ray, walks[2].ray, walks[3].ray]);
        let lanes = || (0..Lanes::COUNT).filter(|lane| asked >> lane & 1 == 1);
        let end = |walks: &[Walk; Lanes::COUNT]| {
            lanes().fold(f64::NEG_INFINITY, |farthest, lane| farthest.max(walks[lane].end()))
        };
        let told = widest(
            #[inline(always)]
            || {
                self.bvh.runs_along_four(
                    rays,
                    end(&walks),
                    #[inline(always)]
                    |run| {
                        for part in &self.parts[run] {
                            part.meet_of_four(
                                &moved,
                                asked,
                                #[inline(always)]
                                |lane, span| {
                                    walks[lane].add(span);
                                },
                            );
                        }
                        end(&walks)
                    },
                )
            },
        );
        if !told {
            return false;
        }
        for lane in lanes() {
            let range = range(lane);
            let mut nearest = None;
            let walked = widest(
                #[inline(always)]
                || {
                    walks[lane].cross(
                        #[inline(always)]
                        |t| {
                            nearest = range.contains(t).then(|| Crossing::new(t, 0));
                            nearest.is_none() && t < range.max
                        },
                    )
                },
            );
            found[lane] = match (nearest, walked) {
                (None, Walked::Briefly) => self.nearest(&rays.ray(lane), range),
                (nearest, _) => nearest,
            };
        }
        true
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        let mut is_met = false;
        let walked = self.walk(ray, range, Sought::Any, |t| {
            is_met = range.contains(t);
            !is_met && t < range.max
        });
        match walked {
            Walked::Met => true,
            Walked::Wholly => is_met,
            Walked::Briefly => is_met || self.nearest(ray, range).is_some(),
        }
    }

    fn is_closed(&self) -> bool {
        true
    }

    fn inside(&self, point: DVec3) -> bool {
        let rounding = 8.0 * f64::EPSILON * self.threshold.abs();
        self.value(point).0 >= -rounding
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        uncrossed::inside_along(self, point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.touched(point, crossing).map_or(DVec3::X, |(_, normal)| normal)
    }

    fn textures(&self, point: DVec3, _crossing: &Crossing, found: &mut dyn FnMut(u32, f64)) {
        if !self.textured {
            return;
        }
        let mut sum = 0.0;
        self.around(point, |_, field, _| sum += field.abs());
        self.around(point, |part, field, _| found(part.texture, field.abs() / sum));
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.touched(point, crossing).map_or(point, |(on, _)| on)
    }

    fn touched(&self, point: DVec3, _crossing: &Crossing) -> Option<(DVec3, DVec3)> {
        let (value, slope) = self.value(point);
        let on = downhill(point, (value, slope), self.bounds.size().length_squared());
        Some((on, if slope == DVec3::ZERO { DVec3::X } else { -slope }))
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;
    use crate::math::Transform;
    use crate::math::dice::numbers;

    fn ball(center: [f64; 3], radius: f64, strength: f64) -> Part {
        let place = Transform::scale(DVec3::splat(radius)).then(&Transform::translate(center.into()));
        Part::ball(&place, strength, OWN_TEXTURE)
    }

    /// The probed blob of three, in another size and place.
    fn three(size: f64, at: DVec3) -> Blob {
        let parts = [([0.0, 0.0, 0.0], 1.5, 1.2), ([1.0, 0.3, 0.0], 1.4, 0.9), ([0.4, 0.6, -0.5], 0.6, -0.7)];
        let place = |center: [f64; 3]| (at + size * DVec3::from(center)).to_array();
        let parts = parts.map(|(center, radius, strength)| ball(place(center), size * radius, strength));
        Blob::new(parts.to_vec(), 0.4)
    }

    fn capsule() -> Blob {
        let place = Transform::rotate(DVec3::Y * 90.0).then(&Transform::translate(DVec3::NEG_X));
        Blob::new(Part::capsule(&place, 2.0, 1.0, OWN_TEXTURE).to_vec(), 0.5)
    }

    battery! {
        balls: |size, at| three(0.6 * size, at);
        tube: || capsule();
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &Blob::new(vec![ball([0.0; 3], 2.0, 1.0)], 0.5),
            "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -1.059043377418418> N <0.092387953251129, 0.184775906502257, -0.978428500438502>
            from <0,0,0> dir <1,0,0> | P <1.082392200292394, 0, 0> N <1, 0, 0>
            inside <1.0823921,0,0> | 1
            inside <1.0823926,0,0> | 0
            extent | <-2, -2, -2> .. <2, 2, 2>",
        );
        table(
            &three(1.0, DVec3::ZERO),
            "from <0.1,0.2,-5> dir <0.05,0.01,1> | P <0.302017233595763, 0.240403446719153, -0.959655328084748> N <0.000014241195265, 0.209314027365438, -0.977848473816495>
            from <0.45,0.5,-5> dir <0,0,1> | P <0.45, 0.5, -0.468250058361426> N <-0.176895318621634, 0.738015236367854, -0.651184733496303>
            inside <0.4,0.6,-0.5> | 0
            inside <0.5,0.2,0> | 1
            extent | <-1.5, -1.5, -1.5> .. <2.400000095367432, 1.700000047683716, 1.5>",
        );
        table(
            &capsule(),
            "from <0.3,5,0.1> dir <0,-1,0> | P <0.3, 0.53187707114845, 0.1> N <0, 0.982780679692203, 0.184775906502257>
            from <1.3,5,0.1> dir <0,-1,0> | P <1.3, 0.439196105188969, 0.1> N <0.554327719507048, 0.811528584685931, 0.184775906502349>
            from <-5,0.1,0.1> dir <1,0,0> | P <-1.522391824987195, 0.1, 0.1> N <-0.965254230113776, 0.184775906502257, 0.184775906502257>
            inside <1.5,0,0> | 1
            inside <1.55,0,0> | 0",
        );
    }

    #[test]
    fn a_stretched_and_turned_component_keeps_its_tips() {
        // POV-Ray's box cuts them at 7.778.
        let place = Transform::scale(DVec3::new(1.0, 1.0, 10.0)).then(&Transform::rotate(DVec3::Y * 45.0));
        let blob = Blob::new(vec![Part::ball(&place, 1.0, OWN_TEXTURE)], 0.1);
        table(&blob, "inside <5.7,0,5.7> | 1\ninside <5.4,0,5.4> | 1\ninside <5.9,0,5.9> | 0");
        assert!(blob.bounds().max.x > 7.0 && blob.bounds().max.x < 7.2);
    }

    #[test]
    fn textures_are_weighed_by_the_strength_of_their_fields() {
        let mut parts = [ball([-0.5, 0.0, 0.0], 1.0, 1.0), ball([0.5, 0.0, 0.0], 1.0, -3.0)];
        parts[0].texture = 4;
        let mut found = Vec::new();
        let blob = Blob::new(parts.to_vec(), 0.5);
        blob.textures(DVec3::ZERO, &Crossing::new(0.0, 0), &mut |texture, weight| {
            found.push((texture, weight))
        });
        found.sort_by_key(|(texture, _)| *texture);
        assert_eq!(found, [(4, 0.25), (OWN_TEXTURE, 0.75)]);
    }

    #[test]
    fn what_is_in_the_way_of_light_is_what_would_be_met() {
        let all = [
            three(1.0, DVec3::ZERO),
            Blob::new(vec![ball([0.5; 3], 1.0, 1.0), ball([0.0; 3], 1.2, 2.0)], 0.4),
        ];
        let mut number = numbers(11);
        let mut seen = [0; 2];
        for blob in all {
            for _ in 0..5000 {
                let mut point = || 1.5 * DVec3::new(number(), number(), number());
                let ray = Ray::new(point(), point());
                let range = Range { min: 0.0, max: 4.0 * number().abs() };
                let mut crossings = Vec::new();
                blob.crossings(&ray, range, &mut crossings);
                let nearest = blob.nearest(&ray, range);
                let gap = crossings.first().zip(nearest.as_ref()).map_or(0.0, |(one, other)| one.t - other.t);
                assert!(gap.abs() < 1e-12 && crossings.is_empty() == nearest.is_none(), "{ray:?} {range:?}");
                assert_eq!(blob.occludes(&ray, range), nearest.is_some(), "{ray:?} {range:?}");
                seen[usize::from(nearest.is_some())] += 1;
            }
        }
        assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
    }

    #[test]
    fn light_leaves_the_surface_as_a_ray_would() {
        let mut number = numbers(13);
        let mut seen = [0; 2];
        for turn in 0..200 {
            let mut point = || DVec3::new(number(), number(), number());
            let parts = (0..12).map(|part| {
                let (center, size) = (point(), point());
                ball(
                    center.to_array(),
                    0.4 + 0.2 * size.x.abs(),
                    if part < 10 { 1.0 } else { -0.4 * size.y.abs() },
                )
            });
            let blob = Blob::new(parts.take(if turn % 2 == 0 { 10 } else { 12 }).collect(), 0.5);
            for _ in 0..100 {
                let (ray, way) = (Ray::new(4.0 * point(), point()), point().normalize());
                let Some(hit) = blob.nearest(&ray, Range::AHEAD) else { continue };
                let (on, normal) = blob.touched(ray.at(hit.t), &hit).unwrap();
                let side = normal.normalize() * way.dot(normal).signum();
                let leaving = Ray::new(on + 3e-13 * side, way);
                let again = blob.nearest(&leaving, Range::AHEAD).is_some();
                assert_eq!(blob.occludes(&leaving, Range::AHEAD), again, "{leaving:?}");
                seen[usize::from(again)] += 1;
            }
        }
        assert!(seen[0] > 400 && seen[1] > 400, "{seen:?}");
    }

    #[test]
    fn a_blob_that_only_carves_is_nowhere() {
        let blob = Blob::new(vec![ball([0.0; 3], 1.0, -1.0)], 0.5);
        assert!(blob.bounds().is_empty() && !blob.inside(DVec3::ZERO));
    }
}
