//! Solids cut by solids.

use crate::model::Model;
use crate::real::Real;
use crate::shoot_at;

/// A ball without a smaller one, cut by a plane.
struct Cut {
    size: f64,
}

impl Cut {
    fn parts<T: Real>(&self, [x, y, z]: &[T; 3]) -> [T; 3] {
        let around = x.clone().square() + y.clone().square();
        let ball = around.clone() + z.clone().square() - T::of(self.size).square();
        let away = z.clone().plus(0.5 * self.size).square();
        let hollow = T::of(0.7 * self.size).square() - (around + away);
        [ball, hollow, y.clone().plus(-0.4 * self.size)]
    }
}

impl Model for Cut {
    fn pieces(&self) -> usize {
        3
    }
    fn equation<T: Real>(&self, piece: usize, p: &[T; 3]) -> T {
        self.parts(p)[piece].clone()
    }
    fn limit<T: Real>(&self, piece: usize, p: &[T; 3]) -> Option<T> {
        let parts = self.parts(p);
        Some(parts[(piece + 1) % 3].clone().max(parts[(piece + 2) % 3].clone()))
    }
    fn reach(&self) -> f64 {
        self.size
    }
}

fn cut(size: f64) -> (String, Cut) {
    let object = format!(
        "difference {{ sphere {{ 0, {size:e} }} sphere {{ <0,0,{:e}>, {:e} }} plane {{ -y, {:e} }} }}",
        -0.5 * size,
        0.7 * size,
        -0.4 * size
    );
    (object, Cut { size })
}

#[test]
fn difference() {
    shoot_at("csg.difference", cut);
}
