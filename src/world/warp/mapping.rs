//! `warp { spherical | cylindrical | toroidal | planar | cubic }` (docs/spec/patterns-textures.md 5.2):
//! wraps the x-y plane of a pattern around something.

use std::f64::consts::{PI, TAU};

use crate::math::{Band, DVec3, Lanes};

/// What the plane is wrapped around.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Height and angle; z is the distance from the axis.
    Cylindrical,
    /// Longitude and latitude; z is the distance from the origin.
    Spherical,
    /// Both angles; z is the distance from the core circle of this radius.
    Toroidal(f64),
    /// The plane itself at this z.
    Planar(f64),
}

/// A projection and where its axis points.
#[derive(Clone, Debug)]
pub struct Mapping {
    /// What the plane is wrapped around.
    pub projection: Projection,
    /// Unit vector; z leaves the result as it is.
    pub orientation: DVec3,
    /// The result grows with this power of the distance.
    pub dist_exp: f64,
}

/// Angle about the y axis, 0 … 2π from +x towards +z. Images use it too.
pub(crate) fn longitude(x: f64, z: f64) -> f64 {
    if z == 0.0 {
        return if x > 0.0 { 0.0 } else { PI };
    }
    let angle = (x / (x * x + z * z).sqrt()).acos();
    if z < 0.0 { TAU - angle } else { angle }
}

/// Angle around the tube of a torus with core radius `major`, as a share of the turn,
/// and the distance from the core circle. Images use it too.
pub(crate) fn around_tube(p: DVec3, major: f64) -> (f64, f64) {
    let out = (p.x * p.x + p.z * p.z).sqrt() - major;
    let distance = (out * out + p.y * p.y).sqrt();
    let below = (-out / distance).acos();
    let angle = if p.y > 0.0 { TAU - below } else { below };
    (angle / TAU, distance)
}

impl Mapping {
    /// Where the pattern sees `p`.
    pub fn point(&self, p: DVec3) -> DVec3 {
        let from_axis = (p.x * p.x + p.z * p.z).sqrt();
        let (x, y, z) = match self.projection {
            Projection::Cylindrical if from_axis == 0.0 => return p,
            Projection::Cylindrical => (longitude(p.x, p.z) / TAU * self.growth(from_axis), p.y, from_axis),
            Projection::Spherical => {
                let distance = p.length();
                if distance == 0.0 {
                    return p;
                }
                let q = p / distance;
                let turn = if q.x == 0.0 && q.z == 0.0 { 0.0 } else { longitude(q.x, q.z) / TAU };
                let growth = self.growth(distance);
                (turn * growth, (0.5 + q.y.asin() / PI) * growth, distance)
            }
            Projection::Toroidal(_) if from_axis == 0.0 => return p,
            Projection::Toroidal(major) => {
                let (around, distance) = around_tube(p, major);
                let growth = self.growth(distance);
                (longitude(p.x, p.z) / TAU * growth, around * growth, distance)
            }
            Projection::Planar(distance) => (p.x, p.y, distance),
        };
        self.orient(x, y, z)
    }

    fn growth(&self, distance: f64) -> f64 {
        match self.dist_exp {
            0.0 => 1.0,
            1.0 => distance,
            exponent => distance.powf(exponent),
        }
    }

    fn orient(&self, x: f64, y: f64, z: f64) -> DVec3 {
        let o = self.orientation;
        if o.x == 0.0 && o.y == 0.0 && o.z == 1.0 {
            return DVec3::new(x, y, z);
        }
        DVec3::new(o.x * z + o.y * x + o.z * x, o.x * y - o.y * z + o.z * y, -o.x * x + o.y * y + o.z * z)
    }
}

/// What holds [`longitude`]s, as shares of the turn. Images use it too.
pub(crate) fn turn_along(x: Band, z: Band) -> Band {
    // Jumps where the longitude does, on the positive x axis.
    ((-z).atan2(-x) + PI) * (1.0 / TAU)
}

/// What holds the results of [`around_tube`]. Images use it too.
pub(crate) fn around_tube_along([x, y, z]: [Band; 3], major: f64) -> (Band, Band) {
    let out = (x.square() + z.square()).sqrt() - major;
    ((y.atan2(out) + PI) * (1.0 / TAU), (out.square() + y.square()).sqrt())
}

/// What holds the latitude as a share of the way between the poles. Images use it too.
pub(crate) fn height_along([x, y, z]: [Band; 3]) -> Band {
    let from_axis = (x.square() + z.square()).sqrt();
    y.atan2(from_axis).max(Band::constant(-PI / 2.0)).min(Band::constant(PI / 2.0)) * (1.0 / PI) + 0.5
}

impl Mapping {
    /// What holds the places where the pattern sees all points that these hold.
    pub(super) fn along(&self, p: [Band; 3]) -> [Band; 3] {
        let from_axis = (p[0].square() + p[2].square()).sqrt();
        let around = turn_along(p[0], p[2]);
        let (mapped, apart) = match self.projection {
            Projection::Cylindrical => ([around * self.growth_along(from_axis), p[1], from_axis], from_axis),
            Projection::Spherical => {
                let distance = (p[0].square() + p[1].square() + p[2].square()).sqrt();
                let growth = self.growth_along(distance);
                // Below and above the middle there is no turn.
                let around = around.where_positive(from_axis.low(), around.hull(Band::constant(0.0)));
                ([around * growth, height_along(p) * growth, distance], distance)
            }
            Projection::Toroidal(major) => {
                let (tube, distance) = around_tube_along(p, major);
                let growth = self.growth_along(distance);
                ([around * growth, tube * growth, distance], from_axis)
            }
            Projection::Planar(distance) => {
                return self.orient_along([p[0], p[1], Band::constant(distance)]);
            }
        };
        let mapped = self.orient_along(mapped);
        // What is on the axis stays.
        [0, 1, 2].map(|i| mapped[i].where_positive(apart.low(), mapped[i].hull(p[i])))
    }

    fn growth_along(&self, distance: Band) -> Band {
        match self.dist_exp {
            0.0 => Band::constant(1.0),
            1.0 => distance,
            exponent => distance.powf(Band::constant(exponent)),
        }
    }

    fn orient_along(&self, [x, y, z]: [Band; 3]) -> [Band; 3] {
        let o = self.orientation;
        if o.x == 0.0 && o.y == 0.0 && o.z == 1.0 {
            return [x, y, z];
        }
        [x * (o.y + o.z) + z * o.x, y * (o.x + o.z) - z * o.y, y * o.y + z * o.z - x * o.x]
    }
}

/// What holds the results of [`cubic`].
pub(super) fn cubic_along([x, y, z]: [Band; 3]) -> [Band; 3] {
    const THIRD: f64 = 1.0 / 3.0;
    let one = Band::constant(1.0);
    // Between -1 and 1 wherever the face is the one that is meant.
    let half = |a: Band, b: Band| {
        let quotient = (a / b).where_positive(b.low(), Band::between(-1.0, 1.0)).max(-one).min(one);
        (quotient + 1.0) * 0.5
    };
    let faces = [
        (x, [-half(z, x) * 0.25 + 0.75, half(y, x) * THIRD + THIRD, x]),
        (y, [half(x, y) * 0.25 + 0.25, -half(z, y) * THIRD + 1.0, y]),
        (z, [half(x, z) * 0.25 + 0.25, half(y, z) * THIRD + THIRD, z]),
        (-x, [half(z, -x) * 0.25, half(y, -x) * THIRD + THIRD, -x]),
        (-y, [half(x, -y) * 0.25 + 0.25, half(z, -y) * THIRD, -y]),
        (-z, [-half(x, -z) * 0.25 + 1.0, half(y, -z) * THIRD + THIRD, -z]),
    ];
    let most = x.abs().max(y.abs()).max(z.abs());
    let mut found = Lanes::splat(-1.0);
    let mut all = [Band::UNKNOWN; 3];
    for (height, place) in faces {
        // The lanes where this may be the face.
        let may = (height - most).high() + f64::MIN_POSITIVE;
        all = [0, 1, 2].map(|i| {
            let more = all[i].hull(place[i]).where_positive(found, place[i]);
            more.where_positive(may, all[i])
        });
        found = Lanes::splat(1.0).where_positive(may, found);
    }
    all
}

/// Which face of a cube around the origin `p` lies on: 0 +x, 1 +y, 2 +z, 3 -x, 4 -y, 5 -z.
pub(crate) fn cube_face(p: DVec3) -> usize {
    let DVec3 { x, y, z } = p;
    let [ax, ay, az] = [x.abs(), y.abs(), z.abs()];
    if x >= 0.0 && x >= ay && x >= az {
        0
    } else if y >= 0.0 && y >= ax && y >= az {
        1
    } else if z >= 0.0 && z >= ax && z >= ay {
        2
    } else if x < 0.0 && x <= -ay && x <= -az {
        3
    } else if y < 0.0 && y <= -ax && y <= -az {
        4
    } else {
        5
    }
}

/// `warp { cubic }`: the six faces of a cube unfolded into a cross in the unit square.
pub(super) fn cubic(p: DVec3) -> DVec3 {
    const THIRD: f64 = 1.0 / 3.0;
    let DVec3 { x, y, z } = p;
    let half = |a: f64, b: f64| (a / b + 1.0) / 2.0;
    match cube_face(p) {
        0 => DVec3::new(0.75 - 0.25 * half(z, x), THIRD + THIRD * half(y, x), x),
        1 => DVec3::new(0.25 + 0.25 * half(x, y), 1.0 - THIRD * half(z, y), y),
        2 => DVec3::new(0.25 + 0.25 * half(x, z), THIRD + THIRD * half(y, z), z),
        3 => DVec3::new(0.25 * half(z, -x), THIRD + THIRD * half(y, -x), -x),
        4 => DVec3::new(0.25 + 0.25 * half(x, -y), THIRD * half(z, -y), -y),
        _ => DVec3::new(1.0 - 0.25 * half(x, -z), THIRD + THIRD * half(y, -z), -z),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of docs/spec/patterns-textures.md 5.3 at <-1.3,2.7,0.45>; negative coordinates are shown as v - ⌊v⌋.
    #[test]
    fn mappings_are_povrays() {
        let skew = DVec3::new(1.0, 2.0, 3.0).normalize();
        let rows = [
            (Projection::Cylindrical, DVec3::Z, 0.0, [0.446962522220873, 2.7, 1.375681649219761]),
            (Projection::Cylindrical, DVec3::X, 1.0, [1.375681649219761, 2.7, 0.385121860291765]),
            (Projection::Spherical, DVec3::Z, 0.0, [0.446962522220873, 0.850003469027120, 3.030264014900352]),
            (Projection::Spherical, skew, 2.5, [10.357121506396382, 12.905312670848001, 7.782694954712873]),
            (
                Projection::Toroidal(0.8),
                DVec3::Z,
                0.0,
                [0.446962522220873, 0.716566351538867, 2.760690015421576],
            ),
            (
                Projection::Toroidal(0.8),
                DVec3::Y,
                1.0,
                [1.233924972362809, 0.239309984578424, 1.978217572080417],
            ),
            (Projection::Planar(0.0), DVec3::Z, 0.0, [0.7, 2.7, 0.0]),
            (Projection::Planar(0.4), skew, 0.0, [0.369706424334211, 2.672612419124244, 2.111363811108153]),
        ];
        for (projection, orientation, dist_exp, expected) in rows {
            let mapping = Mapping { projection, orientation, dist_exp };
            let found = mapping.point(DVec3::new(-1.3, 2.7, 0.45));
            let shown = found.map(|v| if v < 0.0 { v - v.floor() } else { v });
            assert!(shown.abs_diff_eq(DVec3::from_array(expected), 2e-14), "{mapping:?}: {shown}");
        }
    }

    #[test]
    fn the_cube_is_unfolded_as_povrays() {
        let found = cubic(DVec3::new(-1.3, 2.7, 0.45));
        assert!(found.abs_diff_eq(DVec3::new(0.314814814814815, 0.805555555555556, 2.7), 1e-14));
        let found = cubic(DVec3::new(0.55, 0.7, 0.5));
        assert!(found.abs_diff_eq(DVec3::new(0.473214285714286, 0.714285714285714, 0.7), 1e-14));
    }
}
