//! `text` (docs/spec/primitives.md 6.5).

use super::r#box::Cuboid;
use super::curve::Curve;
use super::prism::Prism;
use super::{Crossing, Shape, uncrossed};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes};
use crate::world::accel::Bvh;
use crate::world::{Range, Ray, Rays};

/// Glyphs in a row: [`Prism`]s, so that writing is in the plane of x and z and depth along y.
///
/// Parts: those of every glyph's prism, one glyph after another.
#[derive(Clone, Debug)]
pub struct Text {
    glyphs: Vec<Glyph>,
    bvh: Bvh,
    bounds: Bounds,
    extent: Bounds,
}

#[derive(Clone, Debug)]
struct Glyph {
    /// The number of its first part among the text's.
    first: u32,
    prism: Prism,
}

impl Text {
    /// Of outlines, from y = 0 to `depth`, and the box that POV-Ray reports; `None` without outlines.
    pub fn new(outlines: Vec<Curve>, depth: f64, extent: Bounds) -> Option<Self> {
        let mut first = 0;
        let mut bounds = Bounds::EMPTY;
        let mut glyphs = Vec::with_capacity(outlines.len());
        let mut boxes = Vec::with_capacity(outlines.len());
        for outline in outlines {
            let heights = [depth.min(0.0), depth.max(0.0)];
            let prism = Prism { outline, heights, conic: false, open: false };
            let own = prism.bounds();
            bounds = bounds.union(own);
            boxes.push((own, glyphs.len() as u32));
            let parts = prism.parts();
            glyphs.push(Glyph { first, prism });
            first += parts;
        }
        (!glyphs.is_empty()).then(|| Self { glyphs, bvh: Bvh::new(boxes), bounds, extent })
    }

    /// The glyph that has a crossing, and the crossing as the glyph's prism numbers it.
    fn glyph(&self, crossing: &Crossing) -> (&Prism, Crossing) {
        let after = self.glyphs.partition_point(|glyph| glyph.first <= crossing.part);
        let glyph = &self.glyphs[after - 1];
        (&glyph.prism, Crossing { part: crossing.part - glyph.first, ..*crossing })
    }
}

impl Shape for Text {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn extent(&self) -> Bounds {
        self.extent
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        self.bvh.along(ray, range, |number| {
            let glyph = &self.glyphs[number as usize];
            let start = out.len();
            glyph.prism.crossings(ray, range, out);
            for crossing in &mut out[start..] {
                crossing.part += glyph.first;
            }
            range.max
        });
        out[from..].sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest: Option<Crossing> = None;
        let mut range = range;
        widest(
            #[inline(always)]
            || {
                self.bvh.along(
                    ray,
                    range,
                    #[inline(always)]
                    |number| {
                        let glyph = &self.glyphs[number as usize];
                        if let Some(first) = glyph.prism.first(ray, range, false) {
                            nearest = Some(Crossing { part: first.part + glyph.first, ..first });
                            range.max = first.t;
                        }
                        range.max
                    },
                );
            },
        );
        nearest
    }

    fn nearest_together(
        &self,
        rays: &Rays,
        asked: u32,
        ends: &Lanes,
        found: &mut [Option<Crossing>; Lanes::COUNT],
    ) -> bool {
        let mut ends = *ends;
        for lane in 0..Lanes::COUNT {
            ends.0[lane] = if asked >> lane & 1 == 1 { ends.0[lane].next_up() } else { f64::NEG_INFINITY };
        }
        let farthest = |ends: &Lanes| ends.0.into_iter().fold(f64::NEG_INFINITY, f64::max);
        widest(
            #[inline(always)]
            || {
                self.bvh.along_four(
                    rays,
                    farthest(&ends),
                    #[inline(always)]
                    |number| {
                        let glyph = &self.glyphs[number as usize];
                        let Bounds { min, max } = glyph.prism.bounds();
                        let mut near = Cuboid { min, max }.near_of_four(rays) & asked;
                        while near != 0 {
                            let lane = near.trailing_zeros() as usize % Lanes::COUNT;
                            near &= near - 1;
                            let range = Range { min: 0.0, max: ends.0[lane] };
                            if let Some(first) = glyph.prism.first(&rays.ray(lane), range, false) {
                                found[lane] = Some(Crossing { part: first.part + glyph.first, ..first });
                                ends.0[lane] = first.t;
                            }
                        }
                        farthest(&ends)
                    },
                )
            },
        )
    }

    /// With both faces, other than a prism.
    fn inside(&self, point: DVec3) -> bool {
        self.glyphs.iter().any(|glyph| {
            let [low, high] = glyph.prism.heights;
            low <= point.y && point.y <= high && glyph.prism.outline.encloses(DVec2::new(point.x, point.z))
        })
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        uncrossed::inside_along(self, point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let (prism, crossing) = self.glyph(crossing);
        prism.normal(point, &crossing)
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let (prism, crossing) = self.glyph(crossing);
        prism.reproject(point, &crossing)
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::super::curve::Segment;
    use super::*;

    /// A ring of parabolas, and a triangle to its right.
    fn letters(size: f64) -> Text {
        let p = |x: f64, z: f64| DVec2::new(size * x, size * z);
        let round = |r: f64, s: f64| {
            let ends = [p(r, 0.0), p(0.0, s), p(-r, 0.0), p(0.0, -s), p(r, 0.0)];
            let controls = [p(r, s), p(-r, s), p(-r, -s), p(r, -s)];
            (0..4).map(move |i| Segment::parabola(ends[i], controls[i], ends[i + 1])).collect::<Vec<_>>()
        };
        let corners = [p(1.0, -0.5), p(1.8, -0.5), p(1.3, 0.7), p(1.0, -0.5)];
        let triangle = corners.windows(2).map(|c| Segment::linear(c[0], c[1])).collect();
        let ring = [round(0.8, 0.8), round(0.4, -0.4)].concat();
        Text::new(vec![Curve::new(ring), Curve::new(triangle)], 0.3 * size, Bounds::EMPTY).unwrap()
    }

    battery! {
        written: |size| letters(size);
    }

    #[test]
    fn glyphs_are_solids_with_holes() {
        table(
            &letters(1.0),
            "from <0,-5,0> dir <0,1,0> | miss
            from <0.6,-5,0> dir <0,1,0> | P <0.6, 0, 0> N <0, -1, 0>
            from <0.6,5,0> dir <0,-1,0> | P <0.6, 0.3, 0> N <0, 1, 0>
            from <1.4,5,0> dir <0,-1,0> | P <1.4, 0.3, 0> N <0, 1, 0>
            from <0,0.1,0> dir <1,0,0> | P <0.4, 0.1, 0> N <-1, 0, 0>
            from <0.9,0.1,-0.4> dir <1,0,0> | P <1.025, 0.1, -0.4> N <-0.970142500145332, 0, 0.242535625036333>
            inside <0.6,0,0> | 1
            inside <0.6,0.3,0> | 1
            inside <0.6,0.31,0> | 0
            inside <0,0.1,0> | 0
            inside <1.3,0.1,0> | 1",
        );
    }
}
