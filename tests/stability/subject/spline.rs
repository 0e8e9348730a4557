//! Outlines of cubic pieces, turned about an axis or swept along one.

use crate::certify::Zeros;
use crate::curve::{Beam, Made, Piece, Poly, moved, plus, raised, scaled, times, zeros_between};
use crate::double::Double;
use crate::interval::{Interval, Scalar};
use crate::model::{Exact, Line, Meeting, Subject, half_length};
use crate::real::Moved;
use crate::shoot_at;

/// Radius and height of a profile.
struct Lathe {
    pieces: Vec<Piece<2>>,
    reach: f64,
}

/// How much the square of the line's distance from the axis exceeds that of the surface at its height, times
/// the square of the line's rise.
struct Gap(Piece<2>);

impl Made for Gap {
    fn made<S: Scalar>(&self, Beam { origin: o, direction: d }: &Beam<S>) -> Poly<S> {
        let above = raised(self.0.coordinate(1), -o[1]);
        let across = |i: usize| raised(scaled(&above, d[i]), o[i] * d[1]);
        let (x, z, radius) = (across(0), across(2), scaled(&self.0.coordinate(0), d[1]));
        let around = plus(&times(&x, &x), &times(&z, &z));
        plus(&around, &scaled(&times(&radius, &radius), Interval::of(-1.0)))
    }
}

impl Subject for Lathe {
    fn reach(&self) -> f64 {
        self.reach
    }

    fn meet(&self, line: &Line) -> Meeting {
        let mut out = Meeting::default();
        if half_length(self, line).is_none() {
            return out;
        }
        let (origin, rise) = (line.origin[1], line.direction[1]);
        for (number, piece) in self.pieces.iter().enumerate() {
            let Zeros { at, doubtful, close } = zeros_between(line, &Gap(*piece), 0.0, 1.0);
            out.crossings.extend(at.into_iter().map(|w| Exact {
                t: (piece.at(w)[1] - origin) / rise,
                piece: number,
                w,
            }));
            out.doubtful.extend(doubtful);
            out.close |= close || rise.to_f64() == 0.0;
        }
        out.sorted()
    }

    fn sensitivity(&self, line: &Line, at: &Exact) -> Moved {
        let p = line.point(at.t);
        let [out, up] = self.pieces[at.piece].slope(at.w);
        let radius = p.x.hypot(p.z);
        moved([up * p.x, -out * radius, up * p.z], line, at.t, self.reach)
    }
}

/// The solid between two heights within closed outlines.
pub(super) struct Prism {
    pub(super) outline: Vec<Piece<2>>,
    pub(super) heights: [f64; 2],
    /// The axes of the outline, and the one along which it is swept.
    pub(super) axes: [usize; 3],
    pub(super) reach: f64,
}

/// How far beside a line in the outline's plane a piece is.
struct Beside<'a>(&'a Prism, Piece<2>);

impl Made for Beside<'_> {
    fn made<S: Scalar>(&self, Beam { origin: o, direction: d }: &Beam<S>) -> Poly<S> {
        let [u, v, _] = self.0.axes;
        let across = scaled(&raised(self.1.coordinate(0), -o[u]), d[v]);
        let along = scaled(&raised(self.1.coordinate(1), -o[v]), -d[u]);
        plus(&across, &along)
    }
}

/// How far above a point of the outline's plane a piece is.
struct Above {
    piece: Piece<2>,
    height: Double,
    room: f64,
}

impl Made for Above {
    fn made<S: Scalar>(&self, _: &Beam<S>) -> Poly<S> {
        raised(self.piece.coordinate(1), -S::loosely(self.height, self.room))
    }
}

impl Prism {
    /// Whether the outline goes round a point; whether it passes close to the line that decides.
    fn encloses(&self, line: &Line, [x, y]: [Double; 2], room: f64, out: &mut Meeting) -> bool {
        let mut inside = false;
        for &piece in &self.outline {
            let Zeros { at, doubtful, close } =
                zeros_between(line, &Above { piece, height: y, room }, 0.0, 1.0);
            out.close |= close;
            out.doubtful.extend(doubtful);
            for w in at {
                let away = piece.at(w)[0] - x;
                out.close |= away.to_f64().abs() <= 1e3 * room;
                inside ^= away > Double::of(0.0);
            }
        }
        inside
    }
}

impl Subject for Prism {
    fn reach(&self) -> f64 {
        self.reach
    }

    fn meet(&self, line: &Line) -> Meeting {
        let mut out = Meeting::default();
        if half_length(self, line).is_none() {
            return out;
        }
        let [u, v, up] = self.axes;
        let beam = Beam::fine(line);
        let (o, d) = (line.origin, line.direction);
        let flat = d[u] * d[u] + d[v] * d[v];
        let slant = (d[up].to_f64() / flat.to_f64().sqrt()).abs().max(1.0);
        for (number, &piece) in self.outline.iter().enumerate() {
            let Zeros { at, doubtful, close } = zeros_between(line, &Beside(self, piece), 0.0, 1.0);
            out.doubtful.extend(doubtful);
            out.close |= close;
            for w in at {
                let p = piece.at(w);
                let t = ((p[0] - o[u]) * d[u] + (p[1] - o[v]) * d[v]) / flat;
                let above = beam.at(t)[up];
                let [low, high] = self.heights.map(|height| above - Double::of(height));
                out.close |= [low, high].iter().any(|off| off.to_f64().abs() < 1e3 * slant * line.room);
                if low > Double::of(0.0) && high < Double::of(0.0) {
                    out.crossings.push(Exact { t, piece: number, w });
                }
            }
        }
        for (end, height) in self.heights.into_iter().enumerate() {
            let t = (Double::of(height) - o[up]) / d[up];
            let p = beam.at(t);
            // Where the line meets an end's plane at a slant, its room there is larger.
            let room = line.room * (1.0 + flat.to_f64().sqrt() / d[up].to_f64().abs());
            if room.is_finite()
                && p.iter().all(|x| x.to_f64().abs() <= 2.0 * self.reach)
                && self.encloses(line, [p[u], p[v]], room, &mut out)
            {
                out.crossings.push(Exact { t, piece: self.outline.len() + end, w: Double::of(0.0) });
            }
        }
        out.sorted()
    }

    fn sensitivity(&self, line: &Line, at: &Exact) -> Moved {
        let [u, v, up] = self.axes;
        let mut normal = [0.0; 3];
        match self.outline.get(at.piece) {
            Some(piece) => {
                [normal[v], normal[u]] = {
                    let [x, y] = piece.slope(at.w);
                    [-x, y]
                }
            }
            None => normal[up] = 1.0,
        }
        moved(normal, line, at.t, self.reach)
    }
}

fn scaled_points<const N: usize>(points: [[f64; 2]; N], size: f64) -> [[f64; 2]; N] {
    points.map(|p| p.map(|x| x * size))
}

fn list(points: &[[f64; 2]]) -> String {
    let all = points.iter().map(|[x, y]| format!("<{x:e},{y:e}>")).collect::<Vec<_>>();
    format!("{}, {}", all.len(), all.join(", "))
}

/// The pieces of a spline over each few of the points.
fn pieces<const N: usize>(
    points: &[[f64; 2]],
    step: usize,
    make: fn(&[[f64; 2]; N]) -> Piece<2>,
) -> Vec<Piece<2>> {
    let windows = points.windows(N).step_by(step);
    windows.map(|window| make(window.try_into().expect("a window is as long as asked for"))).collect()
}

fn lathe_of<const N: usize, const M: usize>(
    spline: &str,
    points: [[f64; 2]; N],
    step: usize,
    make: fn(&[[f64; 2]; M]) -> Piece<2>,
) -> impl Fn(f64) -> (String, Lathe) {
    move |size| {
        let points = scaled_points(points, size);
        let object = format!("lathe {{ {spline}_spline {} }}", list(&points));
        (object, Lathe { pieces: pieces(&points, step, make), reach: 1.2 * size })
    }
}

const PROFILE: [[f64; 2]; 7] =
    [[0.2, -1.2], [0.3, -0.9], [0.9, -0.4], [0.35, 0.1], [0.6, 0.5], [0.2, 0.9], [0.1, 1.3]];

#[test]
fn quadratic_lathe() {
    shoot_at("lathe.quadratic", lathe_of("quadratic", PROFILE, 1, Piece::quadratic));
}

#[test]
fn cubic_lathe() {
    shoot_at("lathe.cubic", lathe_of("cubic", PROFILE, 1, Piece::cubic));
}

#[test]
fn bezier_lathe() {
    const POINTS: [[f64; 2]; 8] =
        [[0.0, -0.9], [0.9, -0.9], [1.0, -0.2], [0.4, 0.0], [0.4, 0.0], [0.1, 0.2], [0.9, 0.9], [0.0, 0.8]];
    shoot_at("lathe.bezier", lathe_of("bezier", POINTS, 4, Piece::bezier));
}

fn prism_of<const N: usize, const M: usize>(
    spline: &str,
    points: [[f64; 2]; N],
    step: usize,
    make: fn(&[[f64; 2]; M]) -> Piece<2>,
) -> impl Fn(f64) -> (String, Prism) {
    move |size| {
        let points = scaled_points(points, size);
        let heights = [-0.5 * size, 0.4 * size];
        let object =
            format!("prism {{ {spline}_spline {:e}, {:e}, {} }}", heights[0], heights[1], list(&points));
        let outline = pieces(&points, step, make);
        (object, Prism { outline, heights, axes: [0, 2, 1], reach: 1.2 * size })
    }
}

#[test]
fn quadratic_prism() {
    const POINTS: [[f64; 2]; 7] =
        [[-0.8, 0.2], [0.7, 0.1], [0.3, 0.7], [-0.6, 0.5], [-0.4, -0.6], [0.4, -0.5], [0.7, 0.1]];
    shoot_at("prism.quadratic", prism_of("quadratic", POINTS, 1, Piece::quadratic));
}

#[test]
fn cubic_prism() {
    const POINTS: [[f64; 2]; 8] =
        [[0.4, -0.5], [0.7, 0.1], [0.3, 0.7], [-0.6, 0.5], [-0.2, -0.6], [0.4, -0.5], [0.7, 0.1], [0.3, 0.7]];
    shoot_at("prism.cubic", prism_of("cubic", POINTS, 1, Piece::cubic));
}

#[test]
fn bezier_prism() {
    const POINTS: [[f64; 2]; 12] = [
        [0.8, 0.1],
        [0.9, 0.9],
        [-0.2, 0.9],
        [-0.5, 0.4],
        [-0.5, 0.4],
        [-0.9, -0.2],
        [0.1, 0.1],
        [-0.3, -0.7],
        [-0.3, -0.7],
        [0.2, -0.9],
        [0.7, -0.5],
        [0.8, 0.1],
    ];
    shoot_at("prism.bezier", prism_of("bezier", POINTS, 4, Piece::bezier));
}
