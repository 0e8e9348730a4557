//! Balls that move and grow along splines.

use crate::certify::Zeros;
use crate::curve::{
    Beam, Made, Piece, Poly, derivative, moved, plus, raised, scaled, times, value, zeros_between,
};
use crate::double::Double;
use crate::interval::{Interval, Scalar};
use crate::model::{Exact, Line, Meeting, Subject, half_length};
use crate::real::Moved;
use crate::shoot_at;

/// Centres and radii.
struct SphereSweep {
    pieces: Vec<Piece<4>>,
    reach: f64,
}

fn squared<S: Scalar>(parts: &[Poly<S>]) -> Poly<S> {
    let squares = parts.iter().map(|part| times(part, part));
    squares.reduce(|sum, square| plus(&sum, &square)).expect("there are coordinates")
}

fn dot<S: Scalar>(parts: &[Poly<S>], d: &[Interval<S>; 3]) -> Poly<S> {
    let terms = parts.iter().zip(d).map(|(part, d)| scaled(part, *d));
    terms.reduce(|sum, term| plus(&sum, &term)).expect("there are coordinates")
}

fn less<S: Scalar>(a: &Poly<S>, b: &Poly<S>) -> Poly<S> {
    plus(a, &scaled(b, Interval::of(-1.0)))
}

/// The square of half the chord that each ball cuts out of the line, times that of the direction's square.
struct Chord(Piece<4>);

impl Chord {
    fn centers<S: Scalar>(&self, origin: &[Interval<S>; 3]) -> [Poly<S>; 3] {
        std::array::from_fn(|i| raised(self.0.coordinate(i), -origin[i]))
    }

    /// How far along the line the centres are, times the direction's square.
    fn along<S: Scalar>(&self, beam: &Beam<S>) -> Poly<S> {
        dot(&self.centers(&beam.origin), &beam.direction)
    }
}

impl Made for Chord {
    fn made<S: Scalar>(&self, beam: &Beam<S>) -> Poly<S> {
        let (centers, radius, d) = (self.centers(&beam.origin), self.0.coordinate(3), &beam.direction);
        let length = d[0].square() + d[1].square() + d[2].square();
        let along = self.along(beam);
        let depth = less(&times(&radius, &radius), &squared(&centers));
        plus(&scaled(&depth, length), &times(&along, &along))
    }
}

/// Zero where a chord's beginning or end turns round.
struct Turn(Chord);

impl Made for Turn {
    fn made<S: Scalar>(&self, beam: &Beam<S>) -> Poly<S> {
        let chord = self.0.made(beam);
        let (slope, bend) = (derivative(&self.0.along(beam)), derivative(&chord));
        less(&scaled(&times(&times(&slope, &slope), &chord), Interval::of(4.0)), &times(&bend, &bend))
    }
}

/// The stretches of the line in a run of balls: where it begins and ends, each with a place on the spline.
type Stretch = [Exact; 2];

impl SphereSweep {
    fn stretches(&self, line: &Line, number: usize, out: &mut Meeting) -> Vec<Stretch> {
        let chord = Chord(self.pieces[number]);
        let Zeros { at, doubtful, close } = zeros_between(line, &chord, 0.0, 1.0);
        out.doubtful.extend(doubtful);
        out.close |= close;
        let beam = Beam::fine(line);
        let (along, half) = (chord.along(&beam), chord.made(&beam));
        let [x, y, z] = line.direction;
        let length = x * x + y * y + z * z;
        let ends = [Double::of(0.0)].into_iter().chain(at).chain([Double::of(1.0)]).collect::<Vec<_>>();
        let mut turns = None;
        let mut stretches = Vec::new();
        for pair in ends.windows(2) {
            let middle = (pair[0] + pair[1]) * Double::of(0.5);
            if value(&half, middle) < Double::of(0.0) {
                continue;
            }
            let turns = turns.get_or_insert_with(|| {
                // A place in doubt is as good a ball as any, and as far out as makes no difference.
                let found = zeros_between(line, &Turn(Chord(self.pieces[number])), 0.0, 1.0);
                found.at.into_iter().chain(found.doubtful.into_iter().map(Double::of)).collect::<Vec<_>>()
            });
            let within = turns.iter().filter(|w| pair[0] < **w && **w < pair[1]);
            let place = |w: Double, sign: f64| {
                let reach = value(&half, w).sqrt() * Double::of(sign);
                Exact { t: (value(&along, w) + reach) / length, piece: number, w }
            };
            let outermost = |sign: f64| {
                let all = within.clone().chain(pair).map(|w| place(*w, sign));
                let farther = |a: Exact, b: Exact| if (a.t < b.t) == (sign < 0.0) { a } else { b };
                all.reduce(farther).expect("a stretch has ends")
            };
            stretches.push([outermost(-1.0), outermost(1.0)]);
        }
        stretches
    }
}

impl Subject for SphereSweep {
    fn reach(&self) -> f64 {
        self.reach
    }

    fn meet(&self, line: &Line) -> Meeting {
        let mut out = Meeting::default();
        if half_length(self, line).is_none() {
            return out;
        }
        let mut all: Vec<Stretch> =
            (0..self.pieces.len()).flat_map(|number| self.stretches(line, number, &mut out)).collect();
        all.sort_by(|a, b| a[0].t.partial_cmp(&b[0].t).expect("ends are at numbers"));
        let mut merged: Vec<Stretch> = Vec::new();
        for next in all {
            match merged.last_mut() {
                Some(last) => {
                    let gap = next[0].t - last[1].t;
                    out.close |= gap.to_f64().abs() < 1e4 * line.room;
                    if gap > Double::of(0.0) {
                        merged.push(next);
                    } else if next[1].t > last[1].t {
                        last[1] = next[1];
                    }
                }
                None => merged.push(next),
            }
        }
        out.crossings.extend(merged.into_iter().flatten());
        out.sorted()
    }

    fn sensitivity(&self, line: &Line, at: &Exact) -> Moved {
        let [x, y, z, _] = self.pieces[at.piece].at(at.w).map(|x| x.to_f64());
        let p = line.point(at.t);
        moved([p.x - x, p.y - y, p.z - z], line, at.t, self.reach)
    }
}

const BALLS: [[f64; 4]; 6] = [
    [-0.8, -0.6, 0.0, 0.15],
    [-0.5, 0.1, 0.1, 0.25],
    [0.0, 0.5, -0.3, 0.15],
    [0.5, 0.0, 0.1, 0.3],
    [0.1, -0.5, 0.4, 0.1],
    [-0.7, -0.5, 0.2, 0.2],
];

fn sweep_of(spline: &str, make: fn(&[[f64; 4]; 4]) -> Piece<4>) -> impl Fn(f64) -> (String, SphereSweep) {
    move |size| {
        let balls = BALLS.map(|ball| ball.map(|x| x * size));
        let list: Vec<_> = balls.iter().map(|[x, y, z, r]| format!("<{x:e},{y:e},{z:e}>, {r:e}")).collect();
        let object = format!("sphere_sweep {{ {spline}_spline {}, {} }}", list.len(), list.join(", "));
        let window = |w: &[[f64; 4]]| make(w.try_into().expect("four balls"));
        (object, SphereSweep { pieces: balls.windows(4).map(window).collect(), reach: 1.2 * size })
    }
}

#[test]
fn cubic_sweep() {
    shoot_at("sphere_sweep.cubic", sweep_of("cubic", Piece::cubic));
}

#[test]
fn b_spline_sweep() {
    shoot_at("sphere_sweep.b-spline", sweep_of("b", Piece::b_spline));
}
