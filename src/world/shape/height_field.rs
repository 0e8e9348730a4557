//! `height_field` (docs/spec/primitives.md 5.4).

mod along;
mod cells;

use std::sync::Arc;

use self::cells::{Cells, Way};
use super::triangle::{Meeting, Sheared, blend, face_normal};
use super::{Crossing, Shape};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec3};
use crate::world::{Range, Ray};

/// Two triangles over each cell of a grid on the unit square in x and z.
///
/// The part of a crossing is the cell's number times 2, and 1 more for the triangle away from the
/// origin; [`Crossing::at`] are the weights of its second and third corner.
#[derive(Clone, Debug)]
pub struct HeightField {
    /// Samples along x and z.
    size: [usize; 2],
    /// Row by row, z downward: shared with an image, whose top row is the farthest.
    heights: Arc<Vec<u16>>,
    /// Where the samples are along x and z.
    places: [Vec<f64>; 2],
    /// Everything below is cut away.
    water: f64,
    smooth: bool,
    bounds: Bounds,
    cells: Cells,
}

/// Samples that make a height of 1; its reciprocal is exact.
const FULL: f64 = 65536.0;

/// Steps of a stored normal.
const NORMAL_STEPS: f64 = 32767.0;

impl HeightField {
    /// From the sizes along x and z, at least 2 each, and the samples row by row from z = 1 down.
    /// `None` where their number is another one.
    pub fn new(size: [usize; 2], heights: Arc<Vec<u16>>, water: f64, smooth: bool) -> Option<Self> {
        let [width, depth] = size;
        if width < 2 || depth < 2 || width.checked_mul(depth) != Some(heights.len()) {
            return None;
        }
        let places: [Vec<f64>; 2] = size.map(|samples| {
            let last = (samples - 1) as f64;
            (0..samples).map(|sample| sample as f64 / last).collect()
        });
        let cells = Cells::new(size, &heights);
        let [least, most] = cells.extremes().map(|height| f64::from(height) / FULL);
        let bounds = Bounds { min: DVec3::new(0.0, least.max(water), 0.0), max: DVec3::new(1.0, most, 1.0) };
        let bounds = if bounds.is_empty() { Bounds::EMPTY } else { bounds };
        Some(Self { size, heights, places, water, smooth, bounds, cells })
    }

    #[inline(always)]
    fn height(&self, x: usize, z: usize) -> f64 {
        f64::from(self.heights[(self.size[1] - 1 - z) * self.size[0] + x])
    }

    /// The point of the surface at a sample.
    #[inline(always)]
    fn corner(&self, x: usize, z: usize) -> DVec3 {
        DVec3::new(self.places[0][x], self.height(x, z) * FULL.recip(), self.places[1][z])
    }

    /// The corners of a part, in the order of a crossing's weights.
    fn triangle(&self, part: u32) -> [DVec3; 3] {
        let (cell, far) = (part as usize / 2, part % 2 == 1);
        let (x, z) = (cell % self.size[0], cell / self.size[0]);
        // No closure for an array: that is not compiled together with what is around it.
        let first = if far { self.corner(x + 1, z + 1) } else { self.corner(x, z) };
        [first, self.corner(x + 1, z), self.corner(x, z + 1)]
    }

    /// Calls back with everything a ray meets above the water; the answer is a new upper end, to which more may come.
    #[inline(always)]
    fn walk(&self, ray: &Ray, range: Range, mut found: impl FnMut(u32, Meeting) -> Option<f64>) {
        widest(
            #[inline(always)]
            || {
                let Some(way) = self.way(ray, range) else { return };
                let sheared = Sheared::new(ray);
                let mut max = range.max;
                self.cells.along(
                    &way,
                    max,
                    #[inline(always)]
                    |x, z| {
                        // Two triangles, as in `triangle`.
                        let cell = (z * self.size[0] + x) as u32;
                        let (right, far) = (self.corner(x + 1, z), self.corner(x, z + 1));
                        let diagonal = sheared.base(right, far);
                        for (near, part) in [((x, z), 2 * cell), ((x + 1, z + 1), 2 * cell + 1)] {
                            let near = self.corner(near.0, near.1);
                            let Some(hit) = sheared.meet_over(&diagonal, near) else { continue };
                            // The triangle's own height: the ray's would fray what lies level with the water.
                            let is_above = || blend([near, right, far], hit.at).y >= self.water;
                            if range.contains(hit.t) && hit.t <= max && is_above() {
                                max = found(part, hit).unwrap_or(max);
                            }
                        }
                        max
                    },
                );
            },
        );
    }

    /// A ray among the cells; `None` where it passes them all.
    #[inline(always)]
    fn way(&self, ray: &Ray, range: Range) -> Option<Way> {
        let scale = self.steps();
        let in_cells = Ray { origin: ray.origin * scale, direction: ray.direction * scale };
        let bounds = Bounds { min: self.bounds.min * scale, max: self.bounds.max * scale };
        Way::new(&in_cells, &bounds, range)
    }

    /// Cells along x and z, and steps of height, of the unit cube.
    #[inline(always)]
    fn steps(&self) -> DVec3 {
        DVec3::new((self.size[0] - 1) as f64, FULL, (self.size[1] - 1) as f64)
    }

    /// A corner's height where there is water over what lies lower.
    fn height_over_water(&self, x: usize, z: usize) -> f64 {
        (self.height(x, z) / FULL).max(self.water)
    }

    /// The normal POV-Ray keeps for a sample: the mean of up to four triangles around it, in the space
    /// of samples, coarsely rounded.
    fn sample_normal(&self, x: usize, z: usize) -> DVec3 {
        let here = self.height(x, z);
        let rise = |to: Option<(usize, usize)>, sense: f64| {
            let (x, z) = to.filter(|(x, z)| *x < self.size[0] && *z < self.size[1])?;
            Some(sense * (self.height(x, z) - here))
        };
        let along_x = [rise(Some((x + 1, z)), 1.0), rise(x.checked_sub(1).map(|x| (x, z)), -1.0)];
        let along_z = [rise(Some((x, z + 1)), 1.0), rise(z.checked_sub(1).map(|z| (x, z)), -1.0)];
        let mut sum = DVec3::ZERO;
        for x in along_x.into_iter().flatten() {
            for z in along_z.into_iter().flatten() {
                sum += DVec3::new(-x, 1.0, -z).normalize();
            }
        }
        let coarse = (sum.normalize() * NORMAL_STEPS).trunc();
        let [width, depth] = self.size;
        coarse * DVec3::new((width - 1) as f64, FULL, (depth - 1) as f64)
    }
}

impl Shape for HeightField {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let from = out.len();
        let mut edges = Vec::new();
        self.walk(ray, range, |part, hit| {
            let list = if hit.on_edge { &mut edges } else { &mut *out };
            list.push(Crossing { t: hit.t, part, at: hit.at });
            None
        });
        // Neighbours both report a shared edge: keep one of them.
        edges.sort_by(|a, b| a.t.total_cmp(&b.t));
        edges.dedup_by(|next, kept| (next.t - kept.t).abs() <= 16.0 * f64::EPSILON * kept.t.abs());
        out.append(&mut edges);
        out[from..].sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest: Option<Crossing> = None;
        self.walk(ray, range, |part, hit| {
            // Of two at the very same distance the lesser part, in whatever order they come.
            if nearest.is_none_or(|kept| hit.t < kept.t || part < kept.part) {
                nearest = Some(Crossing { t: hit.t, part, at: hit.at });
            }
            Some(hit.t)
        });
        nearest
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        let mut hidden = false;
        self.walk(ray, range, |_, _| {
            hidden = true;
            Some(f64::NEG_INFINITY)
        });
        hidden
    }

    /// Below the surface without end, and below the water everywhere.
    fn inside(&self, point: DVec3) -> bool {
        let [width, depth] = self.size;
        let (x, z) = (point.x * (width - 1) as f64, point.z * (depth - 1) as f64);
        let within = |v: f64, samples: usize| v >= 0.0 && v < (samples - 1) as f64;
        if !within(x, width) || !within(z, depth) || point.y.is_nan() || point.y >= self.bounds.max.y {
            return false;
        }
        if point.y < self.bounds.min.y {
            return true;
        }
        let (cell_x, cell_z) = (x as usize, z as usize);
        let (u, v) = (x.fract(), z.fract());
        let height = |x: usize, z: usize| self.height_over_water(x, z);
        let (across, along) = (height(cell_x + 1, cell_z), height(cell_x, cell_z + 1));
        let surface = if u + v < 1.0 {
            let near = height(cell_x, cell_z);
            near + u * (across - near) + v * (along - near)
        } else {
            let far = height(cell_x + 1, cell_z + 1);
            far + (1.0 - u) * (along - far) + (1.0 - v) * (across - far)
        };
        point.y < surface
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        self.inside_of_grid(point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.outer_normal(point, crossing, &DVec3::normalize)
    }

    fn outer_normal(&self, point: DVec3, crossing: &Crossing, outer: &dyn Fn(DVec3) -> DVec3) -> DVec3 {
        if !self.smooth {
            return outer(self.geometric_normal(point, crossing));
        }
        let [width, depth] = self.size;
        let cell = crossing.part as usize / 2;
        let (x, z) = (cell % width, cell / width);
        let u = (point.x * (width - 1) as f64 - x as f64).clamp(0.0, 1.0);
        let v = (point.z * (depth - 1) as f64 - z as f64).clamp(0.0, 1.0);
        let corner = |x: usize, z: usize| outer(self.sample_normal(x, z));
        let row = |z: usize| corner(x, z).lerp(corner(x + 1, z), u);
        row(z).lerp(row(z + 1), v).normalize()
    }

    fn interpolates(&self) -> bool {
        self.smooth
    }

    fn geometric_normal(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        upward(face_normal(self.triangle(crossing.part)))
    }

    fn reproject(&self, _point: DVec3, crossing: &Crossing) -> DVec3 {
        blend(self.triangle(crossing.part), crossing.at)
    }

    fn touched(&self, _point: DVec3, crossing: &Crossing) -> Option<(DVec3, DVec3)> {
        if self.smooth {
            return None;
        }
        let corners = self.triangle(crossing.part);
        Some((blend(corners, crossing.at), upward(face_normal(corners))))
    }
}

/// A normal, turned upward.
fn upward(normal: DVec3) -> DVec3 {
    if normal.y < 0.0 { -normal } else { normal }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    /// The function of the probes, x²/2 + y·0.3, on 4 by 4 samples; row 0 is at the top.
    fn probed(water: f64, smooth: bool) -> HeightField {
        let sample = |i: usize| {
            let (x, z) = ((i % 4) as f64 / 3.0, (3 - i / 4) as f64 / 3.0);
            ((x * x * 0.5 + (1.0 - z) * 0.3) * 65535.0) as u16
        };
        HeightField::new([4, 4], Arc::new((0..16).map(sample).collect()), water, smooth).unwrap()
    }

    fn hills() -> HeightField {
        let sample = |i: usize| {
            let (x, z) = ((i % 40) as f64 / 39.0, (29 - i / 40) as f64 / 29.0);
            ((0.5 + 0.3 * (9.0 * x).sin() * (7.0 * z).cos()) * 65535.0) as u16
        };
        HeightField::new([40, 30], Arc::new((0..1200).map(sample).collect()), 0.0, false).unwrap()
    }

    battery! {
        hilly: || hills(), surface;
    }

    #[test]
    fn probes_agree_with_povray() {
        let bounds = "inside <0.2,0.05,0.3> | 1
            inside <0.2,0.5,0.3> | 0
            inside <0.2,-5,0.3> | 1
            inside <1,0.05,0.3> | 0
            extent | <0, -0.00000001525879, 0> .. <1, 0.799987852573395, 1>";
        table(&probed(0.0, false), bounds);
        table(
            &probed(0.0, false),
            "from <0.2,5,0.3> dir <0,-1,0> | P <0.2, 0.24332275390625, 0.3> N <-0.157603360082419, 0.945851081168625, 0.283772643401146>
            from <0.5,5,0.5> dir <0,-1,0> | P <0.5, 0.28887939453125, 0.5> N <-0.431910997098117, 0.863874720924806, 0.259178234296013>
            from <-1,0.6,0.2> dir <1,-0.3,0.1> | P <0.206132533741517, 0.238160239877545, 0.320613253374152> N <-0.157603360082419, 0.945851081168625, 0.283772643401146>
            from <0.9,-1,0.9> dir <0,1,0> | P <0.9, 0.4466552734375, 0.9> N <-0.623820186898311, 0.748602500706212, 0.224594457533044>",
        );
        table(
            &probed(0.0, true),
            "from <0.2,5,0.3> dir <0,-1,0> | P <0.2, 0.24332275390625, 0.3> N <-0.255393299447329, 0.913575168926646, 0.316472231511799>
            from <0.5,5,0.5> dir <0,-1,0> | P <0.5, 0.28887939453125, 0.5> N <-0.43007348581365, 0.854354501085003, 0.291745065555344>",
        );
        table(
            &probed(0.25, false),
            "from <0.2,5,0.3> dir <0,-1,0> | miss
            from <0.9,5,0.7> dir <0,-1,0> | P <0.9, 0.506655883789063, 0.7> N <-0.623845919823135, 0.748592258565027, 0.224557116869047>
            from <0.2,-5,0.9> dir <0,1,0> | miss
            inside <0.2,0.1,0.3> | 1
            inside <0.9,0.26,0.7> | 1
            extent | <0, 0.249999985098839, 0> .. <1, 0.799987852573395, 1>",
        );
    }

    #[test]
    fn what_lies_level_with_the_water_is_seen_from_everywhere() {
        let flat = HeightField::new([5, 5], Arc::new(vec![0; 25]), 0.0, true).unwrap();
        let aims = (0..1000).map(|i| {
            let (x, z) = (f64::from(i) / 1000.0, f64::from(i * 7 % 1000) / 1000.0);
            Ray::new(
                DVec3::new(1.0 - z, 3.0, 2.0 * x),
                DVec3::new(2.0 * x + z - 1.0, -3.0, z - 2.0 * x) * 0.7,
            )
        });
        let over = |ray: &Ray| {
            let p = ray.at(-ray.origin.y / ray.direction.y);
            p.x > 0.0 && p.x < 1.0 && p.z > 0.0 && p.z < 1.0
        };
        let over: Vec<_> = aims.filter(over).collect();
        assert!(over.len() > 100);
        assert!(over.iter().all(|ray| flat.nearest(ray, Range::AHEAD).is_some()));
    }

    #[test]
    fn no_block_hides_what_a_ray_meets() {
        let mut state = 1_u32;
        let mut random = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1 << 24)
        };
        for [width, depth] in [[2, 2], [5, 6], [3, 66], [18, 4], [17, 65], [2, 258]] {
            let heights = (0..width * depth).map(|_| (random() * 65535.0) as u16).collect();
            let field = HeightField::new([width, depth], Arc::new(heights), 0.2, false).unwrap();
            let cells =
                (0..width * depth).filter(|cell| cell / width < depth - 1 && cell % width < width - 1);
            let parts: Vec<u32> = cells.flat_map(|cell| [2 * cell as u32, 2 * cell as u32 + 1]).collect();
            for number in 0..300 {
                let mut point =
                    |size: f64| DVec3::new(random(), random(), random()) * size - (size - 1.0) / 2.0;
                let (origin, aim) = (point([1.0, 3.0, 1e4][number % 3]), point(1.0));
                // Also along the axes.
                let kept = [DVec3::ONE, DVec3::new(1.0, 1.0, 0.0), DVec3::X, DVec3::Z, DVec3::Y][number % 5];
                let ray = Ray::new(aim + (origin - aim) * kept, (aim - origin) * kept);
                let range = Range { min: if number % 2 == 0 { 0.0 } else { 0.6 }, max: 1.5 };
                let sheared = Sheared::new(&ray);
                let met = parts.iter().filter_map(|part| {
                    let corners = field.triangle(*part);
                    let hit = sheared.meet(corners)?;
                    (range.contains(hit.t) && blend(corners, hit.at).y >= field.water).then_some(hit.t)
                });
                let expected = met.min_by(f64::total_cmp);
                assert_eq!(field.nearest(&ray, range).map(|crossing| crossing.t), expected, "{ray:?}");
                assert_eq!(field.occludes(&ray, range), expected.is_some());
            }
        }
    }

    #[test]
    fn the_wrong_number_of_samples_makes_no_field() {
        assert!(HeightField::new([4, 4], Arc::new(vec![0; 15]), 0.0, false).is_none());
        assert!(HeightField::new([1, 4], Arc::new(vec![0; 4]), 0.0, false).is_none());
    }
}
