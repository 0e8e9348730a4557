//! Warps: what moves a point before a pattern sees it (docs/spec/patterns-textures.md 5).

pub mod black_hole;
pub mod mapping;
pub mod repeat;

pub use black_hole::BlackHole;
pub use mapping::{Mapping, Projection};
pub use repeat::Repeat;

use crate::math::noise::Octaves;
use crate::math::wide::widest;
use crate::math::{Band, DVec3, Lanes, Transform, unit};

/// One step on the way to a pattern.
#[derive(Clone, Debug)]
pub enum Warp {
    /// Acts inversely.
    Transform(Box<Transform>),
    /// `turbulence`: strength along each axis, and the noise.
    Turbulence(DVec3, Octaves),
    /// `repeat`.
    Repeat(Box<Repeat>),
    /// `black_hole`.
    BlackHole(Box<BlackHole>),
    /// `spherical`, `cylindrical`, `toroidal`, `planar`.
    Mapping(Box<Mapping>),
    /// `cubic`.
    Cubic,
}

/// Coordinates are kept within this (docs/spec/patterns-textures.md 5.1).
const FARTHEST: DVec3 = DVec3::splat(1e17);

/// The way from a space to that of a pattern, in the order a point goes.
#[derive(Clone, Debug, Default)]
pub struct Warps {
    steps: Box<[Warp]>,
}

impl Warps {
    /// The steps in the order a point goes through them.
    pub fn new(steps: impl IntoIterator<Item = Warp>) -> Self {
        Self { steps: steps.into_iter().collect() }
    }

    /// Whether nothing moves.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// Whether a point takes hardly any time on the way: transforms alone.
    pub fn is_soon_gone(&self) -> bool {
        self.steps.iter().all(|step| matches!(step, Warp::Transform(_)))
    }

    /// Where the pattern sees `p`.
    pub fn point(&self, mut p: DVec3) -> DVec3 {
        for step in &self.steps {
            p = match step {
                Warp::Transform(transform) => transform.inverse_point(p),
                Warp::Turbulence(amount, octaves) => p + octaves.vector(p) * *amount,
                Warp::Repeat(repeat) => repeat.point(p),
                Warp::BlackHole(hole) => hole.point(p),
                Warp::Mapping(mapping) => mapping.point(p),
                Warp::Cubic => mapping::cubic(p),
            };
        }
        p.clamp(-FARTHEST, FARTHEST)
    }

    /// [`Warps::point`] if it [is soon gone](Self::is_soon_gone), compiled together with what is around it.
    #[inline(always)]
    pub fn soon_point(&self, mut p: DVec3) -> Option<DVec3> {
        for step in &self.steps {
            let Warp::Transform(transform) = step else { return None };
            p = transform.inverse_point(p);
        }
        Some(p.clamp(-FARTHEST, FARTHEST))
    }

    /// Where the pattern sees four points.
    pub fn four(&self, point: &[Lanes; 3]) -> [Lanes; 3] {
        if self.steps.is_empty() {
            return within_reach(point);
        }
        widest(
            #[inline(always)]
            || self.four_steps(*point),
        )
    }

    /// The same, compiled together with what is around it: within [`widest`].
    #[inline(always)]
    pub fn four_steps(&self, mut p: [Lanes; 3]) -> [Lanes; 3] {
        for step in &self.steps {
            p = match step {
                Warp::Transform(transform) => transform.inverse_points(&p),
                Warp::Turbulence(amount, octaves) => {
                    let [x, y, z] = octaves.vector_at_four(&p);
                    [p[0] + x * amount.x, p[1] + y * amount.y, p[2] + z * amount.z]
                }
                Warp::Repeat(repeat) => repeat.four(p),
                Warp::BlackHole(hole) => one_by_one(p, |p| hole.point(p)),
                Warp::Mapping(mapping) => one_by_one(p, |p| mapping.point(p)),
                Warp::Cubic => one_by_one(p, mapping::cubic),
            };
        }
        within_reach(&p)
    }

    /// What holds the places where the pattern sees all points that these hold.
    pub fn along(&self, p: [Band; 3]) -> [Band; 3] {
        if self.steps.is_empty() {
            return p;
        }
        widest(
            #[inline(always)]
            || self.steps_along(p),
        )
    }

    #[inline(always)]
    fn steps_along(&self, mut p: [Band; 3]) -> [Band; 3] {
        for step in &self.steps {
            p = match step {
                Warp::Transform(transform) => transform.inverse_along(p),
                Warp::Turbulence(amount, octaves) => {
                    let [x, y, z] = octaves.vector_along(p);
                    [p[0] + x * amount.x, p[1] + y * amount.y, p[2] + z * amount.z]
                }
                Warp::Repeat(repeat) => repeat.along(p),
                Warp::BlackHole(hole) => hole.along(p),
                Warp::Mapping(mapping) => mapping.along(p),
                Warp::Cubic => mapping::cubic_along(p),
            };
        }
        p
    }

    /// A normal seen from the pattern's space; only transforms turn it
    /// (docs/spec/patterns-textures.md 4.1, step 1). Unit unless `raw`.
    pub fn normal_inward(&self, normal: DVec3, raw: bool) -> DVec3 {
        let mut n = unit_unless(raw, normal);
        for step in &self.steps {
            if let Warp::Transform(transform) = step {
                n = transform.forward.matrix3.transpose() * n;
            }
        }
        unit_unless(raw, n)
    }

    /// A normal of the pattern's space seen from outside (docs/spec/patterns-textures.md 4.1, step 4).
    /// Unit unless `raw`.
    pub fn normal_outward(&self, normal: DVec3, raw: bool) -> DVec3 {
        let mut n = unit_unless(raw, normal);
        for step in self.steps.iter().rev() {
            if let Warp::Transform(transform) = step {
                n = transform.normal(n);
            }
        }
        unit_unless(raw, n)
    }
}

/// Where each of four points goes.
#[inline(never)]
fn one_by_one(points: [Lanes; 3], go: impl Fn(DVec3) -> DVec3) -> [Lanes; 3] {
    let mut seen = [Lanes::ZERO; 3];
    for lane in 0..Lanes::COUNT {
        let p = go(Lanes::point(&points, lane));
        (seen[0].0[lane], seen[1].0[lane], seen[2].0[lane]) = (p.x, p.y, p.z);
    }
    seen
}

/// Four points kept within [`FARTHEST`], as `DVec3::clamp` does.
#[inline(always)]
fn within_reach([x, y, z]: &[Lanes; 3]) -> [Lanes; 3] {
    #[inline(always)]
    fn clamped(c: f64) -> f64 {
        let above = if c > -FARTHEST.x { c } else { -FARTHEST.x };
        if above < FARTHEST.x { above } else { FARTHEST.x }
    }
    [x.map(clamped), y.map(clamped), z.map(clamped)]
}

fn unit_unless(raw: bool, n: DVec3) -> DVec3 {
    if raw { n } else { unit(n) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TURBULENCE: Octaves = Octaves { count: 6, omega: 0.5, lambda: 2.0 };

    fn check(warps: &Warps, expected: [[f64; 3]; 3]) {
        let points = [[0.1, 0.2, 0.3], [-1.3, 2.7, 0.45], [0.55, 0.7, 0.5]];
        for (p, expected) in points.into_iter().zip(expected) {
            let found = warps.point(DVec3::from_array(p));
            let shown = found.map(|v| if v < 0.0 { v - v.floor() } else { v });
            assert!(shown.abs_diff_eq(DVec3::from_array(expected), 2e-15), "{p:?}: {shown} not {expected:?}");
        }
    }

    /// docs/spec/patterns-textures.md 5.3.
    #[test]
    fn turbulence_moves_points_as_povray_does() {
        check(
            &Warps::new([Warp::Turbulence(DVec3::new(0.3, 0.4, 0.5), TURBULENCE)]),
            [
                [0.085242282497882, 0.117128669121276, 0.022562419265250],
                [0.800903589810997, 2.611329978756541, 0.545159202753761],
                [0.557975626066967, 0.576041439137104, 0.616467304606640],
            ],
        );
    }

    #[test]
    fn steps_act_in_order() {
        let width = Repeat::new(DVec3::X * 0.7, DVec3::ZERO, DVec3::ZERO);
        let scale = Transform::scale(DVec3::new(2.0, 3.0, 4.0));
        let outer = Transform::rotate(DVec3::new(10.0, 20.0, 30.0))
            .then(&Transform::translate(DVec3::new(1.0, 2.0, 3.0)));
        check(
            &Warps::new([
                Warp::Transform(Box::new(outer)),
                Warp::Repeat(Box::new(width)),
                Warp::Transform(Box::new(scale)),
            ]),
            [
                [0.022656551568311, 0.455894091553452, 0.282063550591595],
                [0.014654551865517, 0.405308804741879, 0.195551559574790],
                [0.289020593137592, 0.547721063928303, 0.373171677882650],
            ],
        );
    }

    #[test]
    fn normals_come_back_as_they_went() {
        let skewed = Transform::scale(DVec3::new(2.0, 0.3, 1.0)).then(&Transform::rotate(DVec3::splat(33.0)));
        let warps = Warps::new([Warp::Transform(Box::new(skewed)), Warp::Cubic]);
        let n = DVec3::new(0.48, 0.6, 0.64);
        for raw in [false, true] {
            let there = warps.normal_inward(n, raw);
            assert!(warps.normal_outward(there, raw).abs_diff_eq(n, 1e-14));
        }
    }
}
