//! Surfaces that the scene's own functions make.

use crate::model::Model;
use crate::real::Real;
use crate::shoot_at;

/// Σ u⁴ - 5 u² + 11.8 for coordinates over the unit, in a cube that cuts it.
struct Tangle {
    unit: f64,
    half: f64,
}

impl Tangle {
    fn value<T: Real>(&self, p: &[T; 3]) -> T {
        let term = |x: &T| {
            let square = (x.clone() / T::of(self.unit)).square();
            square.clone().square() - square.times(5.0)
        };
        term(&p[0]) + term(&p[1]) + term(&p[2]).plus(11.8)
    }
}

impl Model for Tangle {
    fn pieces(&self) -> usize {
        7
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        match piece {
            0 => self.value(p),
            _ if piece < 4 => p[piece - 1].clone().plus(self.half),
            _ => p[piece - 4].clone().plus(-self.half),
        }
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        let beyond = |i: usize| p[i % 3].clone().abs().plus(-self.half);
        Some(match piece {
            0 => beyond(0).max(beyond(1)).max(beyond(2)),
            _ => beyond(piece).max(beyond(piece + 1)).max(self.value(p)),
        })
    }
    fn reach(&self) -> f64 {
        self.half
    }
}

#[test]
fn isosurface_of_a_polynomial() {
    shoot_at("isosurface.polynomial", |size| {
        let (unit, half) = (0.4 * size, 0.8 * size);
        let term = |x: &str| format!("pow({x}/{unit:e},4) - 5*pow({x}/{unit:e},2)");
        let object = format!(
            "isosurface {{ function {{ {} + {} + {} + 11.8 }} contained_by {{ box {{ {:e}, {half:e} }} }}
             accuracy {:e} max_gradient {:e} all_intersections }}",
            term("x"),
            term("y"),
            term("z"),
            -half,
            1e-6 * size,
            200.0 / size
        );
        (object, Tangle { unit, half })
    });
}

/// The distance from a circle about the y axis.
struct Ring {
    major: f64,
    minor: f64,
}

impl Model for Ring {
    fn equation<T: Real>(&self, _piece: usize, [x, y, z]: &[T; 3]) -> T {
        let around = (x.clone().square() + z.clone().square()).sqrt();
        let out = around.plus(-self.major);
        (out.square() + y.clone().square()).sqrt().plus(-self.minor)
    }
    fn reach(&self) -> f64 {
        self.major + self.minor
    }
}

#[test]
fn isosurface_of_distances() {
    shoot_at("isosurface.distance", |size| {
        let (major, minor) = (0.7 * size, 0.25 * size);
        let object = format!(
            "isosurface {{ function {{ sqrt(pow(sqrt(x*x + z*z) - {major:e}, 2) + y*y) - {minor:e} }}
             contained_by {{ sphere {{ 0, {size:e} }} }} accuracy {:e} max_gradient 1.1 all_intersections }}",
            1e-6 * size
        );
        (object, Ring { major, minor })
    });
}

/// What two parameters from -1 to 1 give.
#[derive(Clone, Copy)]
enum Sheet {
    /// u, u² - v², v.
    Saddle,
    /// u³ - u / 3, u, v.
    Fold,
}

struct Parametric {
    sheet: Sheet,
    size: f64,
}

impl Model for Parametric {
    fn equation<T: Real>(&self, _piece: usize, [x, y, z]: &[T; 3]) -> T {
        let square = T::of(self.size).square();
        match self.sheet {
            Sheet::Saddle => y.clone().times(self.size) - x.clone().square() + z.clone().square(),
            Sheet::Fold => {
                let cube = y.clone().square() * y.clone();
                (x.clone() * square.clone() - cube).times(3.0) + y.clone() * square
            }
        }
    }
    fn limit<T: Real>(&self, _piece: usize, [x, y, z]: &[T; 3]) -> Option<T> {
        let u = match self.sheet {
            Sheet::Saddle => x,
            Sheet::Fold => y,
        };
        Some(u.clone().abs().max(z.clone().abs()).plus(-self.size))
    }
    fn reach(&self) -> f64 {
        self.size
    }
}

fn parametric(name: &str, sheet: Sheet, functions: [&str; 3]) {
    shoot_at(name, |size| {
        let list = functions.map(|f| format!("function {{ {size:e} * ({f}) }}")).join(", ");
        let object = format!(
            "parametric {{ {list} <-1,-1>, <1,1> contained_by {{ box {{ {:e}, {:e} }} }}
             accuracy 1e-6 max_gradient {:e} }}",
            -1.5 * size,
            1.5 * size,
            4.0 * size
        );
        (object, Parametric { sheet, size })
    });
}

#[test]
fn parametric_saddle() {
    parametric("parametric.saddle", Sheet::Saddle, ["u", "u*u - v*v", "v"]);
}

#[test]
fn parametric_fold() {
    parametric("parametric.fold", Sheet::Fold, ["u*u*u - u/3", "u", "v"]);
}
