//! Solids cut by solids.

use povista::math::DVec3;

use crate::curve::{Beam, moved};
use crate::double::Double;
use crate::model::{Exact, Line, Meeting, Model, Subject, half_length};
use crate::real::{Moved, Real};
use crate::shoot::Dice;
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

/// Balls, each added to what those before left or taken away from it, in turn.
struct Nest {
    balls: Vec<([f64; 3], f64)>,
    size: f64,
}

impl Nest {
    fn new(depth: u64, size: f64) -> Self {
        let ball = |number: u64| {
            let mut dice = Dice::new(number);
            let center = dice.cube() * 0.7 * size;
            (center.to_array(), (0.1 + 0.2 * dice.unit()) * size)
        };
        Self { balls: (0..depth).map(ball).collect(), size }
    }

    fn adds(number: usize) -> bool {
        number.is_multiple_of(2)
    }

    fn text(&self) -> String {
        let ball =
            |(c, r): &([f64; 3], f64)| format!("sphere {{ <{:e},{:e},{:e}>, {r:e} }}", c[0], c[1], c[2]);
        let declared = |(number, next): (usize, _)| match number {
            0 => format!("#declare Nest = {} ", ball(next)),
            _ if Self::adds(number) => {
                format!("#declare Nest = merge {{ object {{ Nest }} {} }} ", ball(next))
            }
            _ => format!("#declare Nest = difference {{ object {{ Nest }} {} }} ", ball(next)),
        };
        self.balls.iter().enumerate().map(declared).chain(["object { Nest }".to_owned()]).collect()
    }

    /// How deep a point is in a ball; doubles say whether it is in there at all, mostly.
    fn rough_depth(&self, number: usize, p: &[Double; 3], rough: [f64; 3]) -> Double {
        let (center, radius) = self.balls[number];
        let off = (0..3).map(|i| (rough[i] - center[i]).powi(2));
        let depth = radius * radius - off.sum::<f64>();
        if depth.abs() > 1e-10 * self.size * self.size {
            return Double::of(depth);
        }
        self.depth(number, p)
    }

    /// How deep a point is in a ball.
    fn depth(&self, number: usize, p: &[Double; 3]) -> Double {
        let (center, radius) = self.balls[number];
        let square = |x: Double| x * x;
        let off = (0..3).map(|i| square(p[i] - Double::of(center[i])));
        off.fold(square(Double::of(radius)), |rest, off| rest - off)
    }
}

impl Subject for Nest {
    fn reach(&self) -> f64 {
        self.size
    }

    fn meet(&self, line: &Line) -> Meeting {
        let mut out = Meeting::default();
        if half_length(self, line).is_none() {
            return out;
        }
        let beam = Beam::fine(line);
        let dot = |a: [Double; 3], b: [Double; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let zero = Double::of(0.0);
        let close = 1e2 * line.room * self.size;
        // Only the balls that the line meets matter; doubles say what it passes, mostly.
        let (from, along) = (line.point(zero), line.direction());
        let mut met = Vec::new();
        for (number, (center, radius)) in self.balls.iter().enumerate() {
            let aside = along.cross(DVec3::from_array(*center) - from).length_squared();
            if aside > along.length_squared() * radius * radius + 1e-3 * self.size * self.size {
                continue;
            }
            let off = std::array::from_fn(|i| line.origin[i] - Double::of(center[i]));
            let (a, b) = (dot(line.direction, line.direction), dot(off, line.direction));
            let under = b * b + a * self.depth(number, &line.origin);
            out.close |= under.to_f64().abs() < close;
            if under > zero {
                met.push((number, [-under.sqrt(), under.sqrt()].map(|root| (root - b) / a)));
            }
        }
        for &(number, roots) in &met {
            for t in roots {
                let p = beam.at(t);
                let rough = p.map(Double::to_f64);
                // Whether it is in what the balls before left, and in none of those after.
                let mut inside = false;
                let mut seen = true;
                for &(other, _) in &met {
                    if other == number {
                        seen &= inside != Self::adds(number);
                        continue;
                    }
                    let depth = self.rough_depth(other, &p, rough);
                    out.close |= depth.to_f64().abs() < close;
                    if depth > zero {
                        inside = Self::adds(other);
                        seen &= other < number;
                    }
                }
                if seen {
                    out.crossings.push(Exact { t, piece: number, w: zero });
                }
            }
        }
        out.sorted()
    }

    fn sensitivity(&self, line: &Line, at: &Exact) -> Moved {
        let p = line.point(at.t).to_array();
        let normal = std::array::from_fn(|i| p[i] - self.balls[at.piece].0[i]);
        moved(normal, line, at.t, self.size)
    }
}

#[test]
fn a_thousand_deep() {
    shoot_at("csg.deep", |size| {
        let nest = Nest::new(1000, size);
        (nest.text(), nest)
    });
}
