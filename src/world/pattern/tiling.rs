//! `tiling 1` … `tiling 24`: periodic floors (docs/spec/patterns-textures.md 2.7.1).

use std::f64::consts::SQRT_2;
use std::sync::LazyLock;

use super::along::BESIDE;
use crate::math::{Band, DVec2, DVec3};
use crate::world::function::Number;

/// One of the periodic tilings.
#[derive(Clone, Copy, Debug)]
pub struct Tiling {
    number: u32,
    tiles: &'static [Tile],
}

/// A convex tile and all its copies on a lattice.
#[derive(Clone, Debug)]
struct Tile {
    number: u32,
    /// What the value is divided by.
    divisor: f64,
    /// Lattice vectors.
    lattice: [DVec2; 2],
    /// Copies that may cover the lattice's own parallelogram: ranges along both vectors.
    reach: [(i32, i32); 2],
    /// Value at the rim, and the least value.
    rim: f64,
    floor: f64,
    edges: Vec<Edge>,
}

/// An edge: how deep inside a point is, and what this depth counts.
#[derive(Clone, Debug)]
struct Edge {
    start: DVec2,
    /// Unit vector to the inside.
    inward: DVec2,
    weight: f64,
}

/// All tiles, by tiling. The table is part of the program; a line that is no tile would fail the tests.
static TILES: LazyLock<Vec<Tile>> =
    LazyLock::new(|| include_str!("tiling.txt").lines().filter_map(read).collect());

fn read(line: &str) -> Option<Tile> {
    let numbers: Vec<f64> = line.split_whitespace().map_while(|word| word.parse().ok()).collect();
    let [number, divisor, ax, az, bx, bz, rim, floor, _count, vertices @ ..] = &numbers[..] else {
        return None;
    };
    let vertices: Vec<(DVec2, f64)> =
        vertices.chunks_exact(3).map(|v| (DVec2::new(v[0], v[1]), v[2])).collect();
    let lattice = [DVec2::new(*ax, *az), DVec2::new(*bx, *bz)];
    let next = vertices.iter().cycle().skip(1);
    let edges = vertices.iter().zip(next).map(|((start, weight), (end, _))| {
        let along = (*end - *start).normalize();
        Edge { start: *start, inward: along.perp(), weight: *weight }
    });
    let reach = [0, 1].map(|k| {
        let at = || vertices.iter().map(|(v, _)| coordinates(lattice, *v)[k]);
        let low = at().fold(f64::INFINITY, f64::min);
        let high = at().fold(f64::NEG_INFINITY, f64::max);
        // A copy n of the tile covers low + n … high + n; the point is in 0 … 1, give or take rounding.
        ((-high - 1e-6).ceil() as i32, (1.0 - low + 1e-6).floor() as i32)
    });
    let edges = edges.collect();
    Some(Tile { number: *number as u32, divisor: *divisor, lattice, reach, rim: *rim, floor: *floor, edges })
}

/// A point of the plane in lattice vectors.
fn coordinates([a, b]: [DVec2; 2], p: DVec2) -> [f64; 2] {
    let determinant = a.perp_dot(b);
    [p.perp_dot(b) / determinant, a.perp_dot(p) / determinant]
}

impl Tiling {
    /// `None` where there is no periodic tiling with this number.
    pub fn new(number: u32) -> Option<Self> {
        let first = TILES.iter().position(|tile| tile.number == number)?;
        let count = TILES[first..].iter().take_while(|tile| tile.number == number).count();
        Some(Self { number, tiles: &TILES[first..first + count] })
    }

    pub(super) fn value(&self, p: DVec3) -> f64 {
        let p = DVec2::new(p.x, p.z);
        if let Some(value) = self.on_special_line(p) {
            return value;
        }
        // The tile a point is in is the one it is deepest in.
        let mut deepest = (f64::NEG_INFINITY, 0.0);
        for tile in self.tiles {
            let corner = coordinates(tile.lattice, p).map(f64::floor);
            let home = p - corner[0] * tile.lattice[0] - corner[1] * tile.lattice[1];
            tile.copies(home.to_array(), tile.reach, |depth, value| {
                if depth > deepest.0 {
                    deepest = (depth, value);
                }
            });
        }
        let inverted = self.number == 3 && p.x == p.x.floor();
        if inverted { invert_band(deepest.1, p.y) } else { deepest.1 }
    }

    /// Lines on which POV-Ray's formulas give neither neighbour's value.
    fn on_special_line(&self, p: DVec2) -> Option<f64> {
        match self.number {
            12 => {
                let height = (p.y.rem_euclid(6.0) - 3.0).abs();
                if p.x.rem_euclid(6.0) == 0.0 {
                    Some(if (1.0..2.0).contains(&height) { 4.0 / 3.0 } else { 7.0 / 3.0 })
                } else {
                    (p.y.rem_euclid(6.0) == 0.0).then_some(7.0 / 3.0)
                }
            }
            13 | 14 if p.y == 0.0 => Some(0.0),
            13 | 14 if p.x == 0.0 => {
                let phase = (SQRT_2 * p.y).rem_euclid(4.0);
                let height = (phase - 2.0).abs();
                let (near, far) = (2.0 * (1.5 - height).abs(), SQRT_2 * (2.0 - height).abs());
                Some(if (1.0..=2.0).contains(&height) {
                    0.0
                } else if self.number == 13 {
                    (1.0 + near).max(2.0 - far) / 3.0
                } else {
                    (near.max(1.0 - far) + if phase < 2.0 { 2.0 } else { 3.0 }) / 5.0
                })
            }
            _ => None,
        }
    }
}

fn invert_band(value: f64, z: f64) -> f64 {
    let height = 3_f64.sqrt();
    if z.rem_euclid(height) <= height / 2.0 { value - 0.5 } else { value + 0.5 }
}

impl Tile {
    /// Calls `found` with depth and value of a place in copies of the tile, in ranges along both lattice vectors.
    #[inline(always)]
    fn copies<N: Number>(&self, [x, z]: [N; 2], copies: [(i32, i32); 2], mut found: impl FnMut(N, N)) {
        let [a, b] = self.lattice;
        let [along_a, along_b] = copies.map(|(from, to)| (from..=to).map(f64::from));
        for i in along_a {
            for j in along_b.clone() {
                let at = [x - i * a.x - j * b.x, z - i * a.y - j * b.y];
                let distances = self.edges.iter().map(|edge| {
                    let distance =
                        (at[0] - edge.start.x) * edge.inward.x + (at[1] - edge.start.y) * edge.inward.y;
                    (distance, distance.abs() * edge.weight)
                });
                let least = distances.reduce(|(d, r), (distance, rise)| (d.min(distance), r.min(rise)));
                let Some((depth, rise)) = least else { continue };
                let value = (-rise + self.rim).max(N::constant(self.floor)) / self.divisor;
                found(depth, value);
            }
        }
    }

    /// The copies that may cover places, if these are near each other.
    fn copies_near(&self, [x, z]: [Band; 2]) -> Option<[(i32, i32); 2]> {
        let [[u, v], [p, q]] = [DVec2::X, DVec2::Y].map(|axis| coordinates(self.lattice, axis));
        let at = [x * u + z * p, x * v + z * q].map(|c| [c.low().0[0].floor(), c.high().0[0].floor()]);
        let is_small = |[from, to]: [f64; 2]| to - from <= MOST_CELLS && from.abs().max(to.abs()) < FAR;
        let range = |k: usize| (at[k][0] as i32 + self.reach[k].0, at[k][1] as i32 + self.reach[k].1);
        at.into_iter().all(is_small).then(|| [range(0), range(1)])
    }
}

/// So many cells of the lattice are gone through beside the first.
const MOST_CELLS: f64 = 3.0;

/// Places up to here are looked at.
const FAR: f64 = 1e9;

impl Tiling {
    /// What holds the values at all points that these hold.
    pub(super) fn along(&self, [x, _, z]: &[Band; 3]) -> Band {
        Band::by_lanes([*x, *z], |at| {
            let inside = self.in_tiles(at).unwrap_or(Band::between(0.0, 1.0));
            self.on_lines(at, inside)
        })
    }

    /// The values of all tiles that may be those which places are deepest in.
    fn in_tiles(&self, at: [Band; 2]) -> Option<Band> {
        let mut found = Vec::new();
        for tile in self.tiles {
            tile.copies(at, tile.copies_near(at)?, |depth, value| found.push((depth, value)));
        }
        let bound = |band: Band| [band.low().0[0] - BESIDE, band.high().0[0] + BESIDE];
        let deepest = found.iter().map(|(depth, _)| bound(*depth)[0]).fold(f64::NEG_INFINITY, f64::max);
        let may = found.into_iter().filter(|(depth, _)| bound(*depth)[1] >= deepest);
        may.map(|(_, value)| value).reduce(Band::hull)
    }

    /// With the values on the lines where there are others, if these may be met.
    fn on_lines(&self, [x, z]: [Band; 2], inside: Band) -> Band {
        let is_whole = |c: Band| c.low().0[0].ceil() <= c.high().0[0];
        let is_zero = |c: Band| c.low().0[0] <= 0.0 && c.high().0[0] >= 0.0;
        let mut all = inside;
        match self.number {
            3 if is_whole(x) => all = (inside - 0.5).hull(inside + 0.5),
            12 => {
                for (c, least) in [(x, 4.0 / 3.0), (z, 7.0 / 3.0)] {
                    if is_whole(c * (1.0 / 6.0)) {
                        all = all.hull(Band::between(least, 7.0 / 3.0));
                    }
                }
            }
            13 | 14 if is_zero(x) => all = all.hull(Band::between(0.0, 4.0 / 3.0)),
            13 | 14 if is_zero(z) => all = all.hull(Band::constant(0.0)),
            _ => {}
        }
        all
    }
}
