//! Solids of degree two, and the torus.

use crate::model::Model;
use crate::real::Real;
use crate::shoot_at;

struct Sphere {
    radius: f64,
}

impl Model for Sphere {
    fn equation<T: Real>(&self, _piece: usize, [x, y, z]: &[T; 3]) -> T {
        x.clone().square() + y.clone().square() + z.clone().square() - T::of(self.radius).square()
    }
    fn reach(&self) -> f64 {
        self.radius
    }
}

#[test]
fn sphere() {
    shoot_at("sphere", |size| (format!("sphere {{ 0, {size:e} }}"), Sphere { radius: size }));
}

/// Faces in x, y and z, each at -half and half.
struct Box {
    half: [f64; 3],
}

impl Model for Box {
    fn pieces(&self) -> usize {
        6
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        let side = if piece < 3 { self.half[piece % 3] } else { -self.half[piece % 3] };
        p[piece % 3].clone().plus(side)
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        let beyond = |i: usize| p[i % 3].clone().abs().plus(-self.half[i % 3]);
        Some(beyond(piece + 1).max(beyond(piece + 2)))
    }
    fn reach(&self) -> f64 {
        self.half.into_iter().fold(0.0, f64::max)
    }
}

#[test]
fn r#box() {
    shoot_at("box", |size| {
        let half = [0.9, 0.5, 0.7].map(|x| x * size);
        let [x, y, z] = half;
        (format!("box {{ <{:e},{:e},{:e}>, <{x:e},{y:e},{z:e}> }}", -x, -y, -z), Box { half })
    });
}

#[test]
fn box_turned_a_thousand_times() {
    shoot_at("box.turned", |size| {
        let half = [0.9, 0.5, 0.7].map(|x| x * size);
        let [x, y, z] = half;
        let turn = "#declare Turned = object { Turned matrix <0,1,0, 0,0,1, 1,0,0, 0,0,0> } ".repeat(999);
        let made = format!("box {{ <{:e},{:e},{:e}>, <{x:e},{y:e},{z:e}> }}", -x, -y, -z);
        (format!("#declare Turned = {made} {turn} object {{ Turned }}"), Box { half })
    });
}

/// Along y from -height to height, closed by two discs; radii at both ends.
struct Cone {
    height: f64,
    radii: [f64; 2],
}

impl Model for Cone {
    fn pieces(&self) -> usize {
        3
    }
    fn equation<T: Real>(&self, piece: usize, [x, y, z]: &[T; 3]) -> T {
        match piece {
            0 => y.clone().plus(self.height),
            1 => y.clone().plus(-self.height),
            _ => {
                // The radius times 2 h, to do without a division.
                let up = T::of(self.radii[1]) - T::of(self.radii[0]);
                let radius =
                    up * y.clone() + (T::of(self.radii[1]) + T::of(self.radii[0])).times(self.height);
                let around = x.clone().square() + z.clone().square();
                around * T::of(2.0 * self.height).square() - radius.square()
            }
        }
    }
    fn limit<T: Real>(&self, piece: usize, [x, y, z]: &[T; 3]) -> Option<T> {
        Some(match piece {
            0 | 1 => x.clone().square() + z.clone().square() - T::of(self.radii[piece]).square(),
            _ => y.clone().square() - T::of(self.height).square(),
        })
    }
    fn reach(&self) -> f64 {
        self.radii.into_iter().fold(self.height, f64::max)
    }
}

#[test]
fn cylinder() {
    shoot_at("cylinder", |size| {
        let (height, radius) = (0.8 * size, 0.6 * size);
        let object = format!("cylinder {{ <0,{:e},0>, <0,{height:e},0>, {radius:e} }}", -height);
        (object, Cone { height, radii: [radius; 2] })
    });
}

#[test]
fn cone() {
    shoot_at("cone", |size| {
        let (height, low, high) = (0.8 * size, 0.7 * size, 0.2 * size);
        let object = format!("cone {{ <0,{:e},0>, {low:e}, <0,{height:e},0>, {high:e} }}", -height);
        (object, Cone { height, radii: [low, high] })
    });
}

struct Torus {
    major: f64,
    minor: f64,
}

impl Model for Torus {
    fn equation<T: Real>(&self, _piece: usize, [x, y, z]: &[T; 3]) -> T {
        let around = x.clone().square() + z.clone().square();
        let (major, minor) = (T::of(self.major).square(), T::of(self.minor).square());
        let sum = around.clone() + y.clone().square() + major.clone() - minor;
        sum.square() - (major * around).times(4.0)
    }
    fn reach(&self) -> f64 {
        self.major + self.minor
    }
}

fn torus_of(major: f64, minor: f64) -> impl Fn(f64) -> (String, Torus) {
    move |size| {
        let (major, minor) = (major * size, minor * size);
        (format!("torus {{ {major:e}, {minor:e} }}"), Torus { major, minor })
    }
}

#[test]
fn torus() {
    shoot_at("torus", torus_of(0.75, 0.25));
}

#[test]
fn thin_torus() {
    shoot_at("torus.thin", torus_of(0.99, 0.01));
}

#[test]
fn spindle_torus() {
    shoot_at("torus.spindle", torus_of(0.4, 0.6));
}
