//! `ovus { bottom, top }`, an egg (docs/spec/primitives.md 3.11).

use super::sphere::{Sphere, spherical_uv};
use super::stretch::{End, Stretch};
use super::torus::Torus;
use super::{Crossing, Shape, uncrossed};
use crate::math::{Band, Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

/// Two balls on the y axis and what lies between them: the inner sheet of a spindle torus that touches
/// both. It is convex, and holds both balls.
///
/// Parts: 0 the ball about the origin, 1 the one above, 2 the band between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ovus {
    bottom: f64,
    top: f64,
    band: Torus,
    /// Height of the band's ring.
    middle: f64,
    /// Where the band begins and ends.
    heights: [f64; 2],
}

const BAND: u32 = 2;

impl Ovus {
    /// From both radii; `None` where they make no egg: POV-Ray takes one ball where `top` is at least
    /// twice `bottom`.
    pub fn new(bottom: f64, top: f64) -> Option<Self> {
        let square = top * top / bottom;
        let (radius, middle) = if bottom > top {
            (2.0 * bottom, 2.0 * top - bottom - 0.5 * square)
        } else {
            (2.0 * top, -2.0 * top + bottom + 1.5 * square)
        };
        let major = if bottom > top {
            (bottom * bottom - middle * middle).sqrt()
        } else {
            (top * top - (middle - bottom) * (middle - bottom)).sqrt()
        };
        let heights = if bottom > top {
            [-middle, (bottom - middle) * top / (radius - top) + bottom]
        } else {
            [-middle * bottom / (radius - bottom), 2.0 * bottom - middle]
        };
        let valid = bottom > 0.0 && top > 0.0 && major > 0.0 && heights[0] <= heights[1];
        valid.then_some(Self { bottom, top, band: Torus { major, minor: radius }, middle, heights })
    }

    fn balls(&self) -> [Sphere; 2] {
        let center = DVec3::Y * self.bottom;
        [Sphere { center: DVec3::ZERO, radius: self.bottom }, Sphere { center, radius: self.top }]
    }

    fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let mut all: Option<Stretch> = None;
        let mut add = |crossing: End| {
            let one = Stretch { enter: crossing, leave: crossing };
            all = Some(all.map_or(one, |all| Stretch {
                enter: if crossing.t < all.enter.t { crossing } else { all.enter },
                leave: if crossing.t > all.leave.t { crossing } else { all.leave },
            }));
        };
        for (part, ball) in (0..).zip(self.balls()) {
            if let Some(stretch) = ball.stretch(ray) {
                add(End { part, ..stretch.enter });
                add(End { part, ..stretch.leave });
            }
        }
        let mut band = Vec::new();
        let below = Ray::new(ray.origin - DVec3::Y * self.middle, ray.direction);
        self.band.crossings(&below, Range::LINE, &mut band);
        for crossing in band.into_iter().filter(|crossing| crossing.part == 1) {
            let y = ray.at(crossing.t).y;
            if self.heights[0] < y && y < self.heights[1] {
                add(End { t: crossing.t, part: BAND });
            }
        }
        all
    }
}

impl Shape for Ovus {
    fn bounds(&self) -> Bounds {
        let radius = (self.band.minor - self.band.major).max(self.bottom).max(self.top);
        Bounds::new(
            DVec3::new(-radius, -self.bottom, -radius),
            DVec3::new(radius, self.bottom + self.top, radius),
        )
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if let Some(stretch) = self.stretch(ray) {
            stretch.push(range, out);
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.stretch(ray)?.nearest(range)
    }

    fn inside(&self, point: DVec3) -> bool {
        let around = point.x.hypot(point.z) + self.band.major;
        let in_band = self.heights[0] < point.y
            && point.y < self.heights[1]
            && around.hypot(point.y - self.middle) < self.band.minor;
        in_band || self.balls().iter().any(|ball| ball.inside(point))
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        uncrossed::inside_along(self, point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part {
            0 => point,
            1 => point - DVec3::Y * self.bottom,
            _ => self.band.normal(point - DVec3::Y * self.middle, &Crossing::new(crossing.t, 1)),
        }
    }

    fn uv(&self, point: DVec3, _crossing: &Crossing) -> Option<DVec2> {
        Some(spherical_uv(point - DVec3::Y * (0.5 * self.top)))
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part {
            BAND => {
                let up = DVec3::Y * self.middle;
                up + self.band.reproject(point - up, crossing)
            }
            ball => self.balls()[ball as usize].reproject(point, crossing),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, battery, table};
    use super::*;

    fn make(bottom: f64, top: f64) -> Ovus {
        Ovus::new(bottom, top).unwrap()
    }

    battery! {
        egg: |size| make(0.6 * size, 0.4 * size);
        upside_down: |size| make(0.4 * size, 0.6 * size);
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &make(1.0, 0.7),
            "from <0.1,0.2,-5> dir <0.05,0.1,1> | P <0.304484532406154, 0.608969064812308, -0.910309351876918> N <0.308930585719754, 0.226984532406172, -0.923601599855263>
            from <0.1,-0.6,-5> dir <0,0,1> | P <0.1, -0.6, -0.793725393319376> N <0.1, -0.6, -0.793725393319377>
            from <0.1,1.5,-5> dir <0,0,1> | P <0.1, 1.5, -0.479583152331268> N <0.142857142857143, 0.714285714285717, -0.685118789044671>
            from <0,0.5,0> dir <1,0.2,0.3> | P <0.902113799771057, 0.680422759954212, 0.270634139931317> N <0.924182123335127, 0.262711379977109, 0.277254637000538>
            from <0,5,0> dir <0,-1,0> | P <0, 1.7, 0> N <0, 1, 0>
            from <0,-5,0> dir <0,1,0> | P <0, -1, 0> N <0, -1, 0>
            extent | <-1.012085556983948, -1, -1.012085556983948> .. <1.012085556983948, 1.700000047683716, 1.012085556983948>
            inside <0,1.69,0> | 1
            inside <0.9,0.3,0> | 1
            inside <0.999,0.1,0> | 1",
        );
        table(
            &make(1.0, 1.4),
            "from <0.1,0.2,-5> dir <0.05,0.1,1> | P <0.28411320063116, 0.568226401262319, -1.317735987376806> N <0.206322712527369, -0.20420485669193, -0.956938511503627>
            from <0.1,-0.6,-5> dir <0,0,1> | P <0.1, -0.6, -0.794467097998464> N <0.097843849670452, -0.621428571428574, -0.777337193046819>
            from <0.1,1.5,-5> dir <0,0,1> | P <0.1, 1.5, -1.303840481040529> N <0.071428571428571, 0.357142857142857, -0.931314629314664>
            extent | <-1.407017588615417, -1, -1.407017588615417> .. <1.407017588615417, 2.400000095367432, 1.407017588615417>",
        );
        table(
            &make(1.0, 1.0),
            "from <0.1,0.2,-5> dir <0.05,0.1,1> | P <0.295365022229952, 0.590730044459904, -1.092699555400964> N <0.260673984904823, 0.045365022229893, -0.964360455613938>",
        );
    }

    #[test]
    fn uv_agrees_with_povray() {
        battery::uv(&make(1.0, 0.7), [0.1, 0.2, -5.0], [0.0, 0.0, 1.0], [0.76576, 0.45315]);
        battery::uv(&make(1.0, 0.7), [0.3, 1.5, -5.0], [0.0, 0.0, 1.0], [0.85489, 0.87181]);
    }

    #[test]
    fn a_top_that_swallows_the_bottom_makes_no_egg() {
        assert_eq!(Ovus::new(1.0, 2.5), None);
        assert_eq!(Ovus::new(0.0, 0.0), None);
    }
}
