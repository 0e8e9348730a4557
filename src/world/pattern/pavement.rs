//! `pavement`: floors of polyominoes, polyiamonds and polyhexes (docs/spec/patterns-textures.md 2.7.3).

use super::along::on_floor;
use crate::math::{Band, DVec2, DVec3};
use crate::world::function::{Number, Unary};

/// A floor and how its tiles are bevelled.
#[derive(Clone, Debug)]
pub struct Pavement {
    /// 3, 4 or 6.
    sides: u32,
    /// Shape of outer corners.
    exterior: u32,
    /// Shape of inner corners.
    interior: u32,
    /// Shape of tips.
    form: u32,
    cells: Cells,
}

/// Which walls and marks every cell has: a block that repeats, every row of blocks shifted.
#[derive(Clone, Debug)]
struct Cells {
    columns: i64,
    shift: i64,
    rows: i64,
    codes: Vec<u32>,
}

impl Cells {
    /// The table's line for a floor. The table is part of the program.
    fn read(sides: u32, tiles: u32, pattern: u32) -> Option<Self> {
        let numbers = |line: &str| -> Vec<u32> {
            line.split_whitespace().map_while(|word| word.parse().ok()).collect()
        };
        include_str!("pavement.txt").lines().map(numbers).find_map(|line| match &line[..] {
            [s, t, n, columns, shift, rows, codes @ ..] if [*s, *t, *n] == [sides, tiles, pattern] => {
                let codes = codes.to_vec();
                let [columns, shift, rows] = [*columns, *shift, *rows].map(i64::from);
                (codes.len() as i64 == columns * rows).then_some(Self { columns, shift, rows, codes })
            }
            _ => None,
        })
    }

    fn code(&self, column: f64, row: f64) -> u32 {
        let (i, k) = (column as i64, row as i64);
        let block = k.div_euclid(self.rows);
        let row = k.rem_euclid(self.rows);
        let column = i.wrapping_sub(self.shift.wrapping_mul(block)).rem_euclid(self.columns);
        self.codes[(column + self.columns * row) as usize]
    }
}

impl Pavement {
    /// Sides, tiles and number of the floor, and the shapes of its corners;
    /// `None` where there is no such floor.
    pub fn new([sides, tiles, pattern]: [u32; 3], exterior: u32, interior: u32, form: u32) -> Option<Self> {
        let forms = if sides == 4 { 4 } else { 3 };
        Some(Self {
            sides,
            exterior: exterior % 3,
            interior: interior % 3,
            form: form % forms,
            cells: Cells::read(sides, tiles, pattern)?,
        })
    }

    pub(super) fn value(&self, p: DVec3) -> f64 {
        let p = DVec2::new(p.x, p.z);
        if self.sides == 4 { self.squares(p) } else { self.triangles(p) }
    }

    /// What holds the values at all points that these hold.
    pub(super) fn along(&self, [x, _, z]: &[Band; 3]) -> Band {
        if self.sides == 4 {
            return on_floor([*x, *z], [0.0, 1.0], |[x, z], [column, row]| {
                self.square(self.cells.code(column, row), [x - column, z - row])
            });
        }
        // Along the left sides of upright triangles rows go on with the same columns.
        let (row_height, lean) = (3_f64.sqrt() / 2.0, 1.0 / 3_f64.sqrt());
        on_floor([*x - *z * lean, *z * (1.0 / row_height)], [0.0, 1.0], |[slanted, rows], [column, row]| {
            let left = column + 0.5 * row;
            let z = rows * row_height;
            let (x, z) = (slanted + z * lean - left, z - row * row_height);
            let upside_down = (-x + 1.0) * 3_f64.sqrt() - z;
            let code = |column: f64| self.cells.code(column, row);
            upside_down.pick(
                || self.triangle(code(2.0 * left + 1.0), [-x + 1.5, -z + row_height]),
                || self.triangle(code(2.0 * left), [x, z]),
            )
        })
    }

    fn squares(&self, p: DVec2) -> f64 {
        let cell = p.floor();
        self.square(self.cells.code(cell.x, cell.y), (p - cell).to_array())
    }

    /// A place in a unit square.
    fn square<N: Number>(&self, code: u32, [x, z]: [N; 2]) -> N {
        let [x1, z1] = [-x + 1.0, -z + 1.0];
        let one = N::constant(1.0);
        // Corners: mark, the walls that touch it, twice the distances from it.
        let corners = [(16, 1 | 4, x, z), (32, 2 | 4, x1, z), (64, 1 | 8, x, z1), (128, 2 | 8, x1, z1)]
            .map(|(mark, touching, u, v)| (mark, touching, u * 2.0, v * 2.0));
        if self.form < 3 {
            for index in [3, 2, 1, 0] {
                let (mark, touching, u, v) = corners[index];
                let opposite = 15 ^ touching;
                if code & mark != 0 && code & opposite == opposite {
                    return (square_norm(self.form, u, v) - 1.0).abs().min(one);
                }
            }
        }
        let mut r = N::constant(0.0);
        for (wall, distance) in [(1, x), (2, x1), (4, z), (8, z1)] {
            if code & wall != 0 {
                r = r.max(distance * -2.0 + 1.0);
            }
        }
        for (mark, touching, u, v) in corners {
            if code & mark != 0 {
                r = r.max(-square_norm(self.interior, u, v) + 1.0);
            }
            if code & touching == touching {
                match self.exterior {
                    1 => r = r.max((-(u + v) + 2.0).min(one)),
                    // Beside the corner's quarter both walls are already as high as this.
                    2 => {
                        let [u, v] = [u, v].map(|c| (-c + 1.0).max(N::constant(0.0)));
                        r = r.max(length([u, v]).min(one));
                    }
                    _ => {}
                }
            }
        }
        r
    }

    fn triangles(&self, p: DVec2) -> f64 {
        let row_height = 3_f64.sqrt() / 2.0;
        let row = (p.y / row_height).floor();
        let z = p.y - row * row_height;
        // Vertices of a row line lie at integers, those of the next line half a unit off.
        let base_offset = if row.rem_euclid(2.0) == 0.0 { 0.0 } else { 0.5 };
        let left = (p.x - z / 3_f64.sqrt() - base_offset).floor() + base_offset;
        let at = DVec2::new(p.x - left, z);
        let upright = 3_f64.sqrt() * (1.0 - at.x) >= z;
        if upright {
            let code = self.cells.code(2.0 * left, row);
            return self.triangle(code, at.to_array());
        }
        let bottom = left + 1.0;
        let code = self.cells.code(2.0 * bottom - 1.0, row);
        self.triangle(code, [0.5 - (p.x - bottom), row_height - z])
    }

    /// A point of the triangle with corners (0,0), (1,0) and the top (½, √3/2).
    fn triangle<N: Number>(&self, code: u32, p: [N; 2]) -> N {
        let root = 3_f64.sqrt();
        let kappa = 2.0 * root;
        let [x, z] = p;
        let [left, right, base] = [(x * root - z) / 2.0, ((-x + 1.0) * root - z) / 2.0, z];
        let sides = Sides {
            left_top: -(z * root + x) + 1.0,
            right_top: -(z * root - x + 1.0) + 1.0,
            left_right: x * -2.0 + 1.0,
        };
        let Sides { left_top, right_top, .. } = sides;
        let wall = |bit: u32| code & bit != 0;

        let mut r = N::constant(0.0);
        for (bit, distance) in [(1, left), (2, right), (4, base)] {
            if wall(bit) {
                r = r.max(distance * -kappa + 1.0);
            }
        }

        // Marks: bit, corner, height over the opposite direction, kite, the two bevels of interior 1.
        let marks = [
            (
                8,
                TOP,
                -z + root / 2.0,
                sides.top(),
                ((-left_top + 1.0) * 1.5 - 2.0, (-right_top + 1.0) * 1.5 - 2.0),
            ),
            (16, LEFT, (x * root + z) / 2.0, sides.left(), ((-left_top + 1.0) * -1.5 + 1.0, x * -3.0 + 1.0)),
            (
                32,
                RIGHT,
                ((-x + 1.0) * root + z) / 2.0,
                sides.right(),
                ((-right_top + 1.0) * -1.5 + 1.0, x * 3.0 - 2.0),
            ),
        ];
        for (bit, corner, height, kite, bevels) in marks {
            if !wall(bit) {
                continue;
            }
            r = match self.interior {
                0 => r.max(height * -kappa + 1.0),
                2 => r.max(length(from(p, corner())) * -3.0 + 1.0),
                _ => kite.pick(|| r.max(bevels.0.min(bevels.1)), || r),
            };
        }

        if self.sides == 3 {
            r = self.outer_corner(code, p, [left, right, base], &sides, r);
        }
        self.tip(code, p, &sides, r)
    }

    /// Step 3: corners between two walls, shaped by `exterior`.
    fn outer_corner<N: Number>(
        &self,
        code: u32,
        p: [N; 2],
        [left, right, base]: [N; 3],
        sides: &Sides<N>,
        r: N,
    ) -> N {
        let root = 3_f64.sqrt();
        let kappa = 2.0 * root;
        let between = |walls: u32| code & walls == walls;
        let [x, z] = from(p, [0.5, root / 6.0]);
        let one = N::constant(1.0);
        match self.exterior {
            2 => {
                // Up to 0 where a corner is rounded.
                let corners = [(1 | 2, sides.top()), (1 | 4, sides.left()), (2 | 4, sides.right())];
                let of_walls = corners.into_iter().filter(|(walls, _)| between(*walls));
                let rounded = of_walls.map(|(_, corner)| corner).reduce(N::min).unwrap_or(one);
                (-rounded).pick(|| r, || (length([x, z]) * kappa).min(one))
            }
            1 => {
                let away = |d: N| d * -kappa + 1.0;
                let x = x * root;
                let bevels = [
                    (1 | 2, left, right, z.abs() * kappa),
                    (2 | 4, right, base, (x - z).abs() * root),
                    (1 | 4, left, base, (x + z).abs() * root),
                ];
                // The last that is met counts.
                bevels
                    .into_iter()
                    .filter(|(walls, ..)| between(*walls))
                    .fold(r, |r, (_, a, b, height)| away(a).min(away(b)).pick(|| r, || height.min(one)))
            }
            _ => r,
        }
    }

    /// Step 4: pieces shaped by `form`.
    fn tip<N: Number>(&self, code: u32, p: [N; 2], sides: &Sides<N>, r: N) -> N {
        let root = 3_f64.sqrt();
        let Sides { left_top, right_top, left_right } = *sides;
        // Bit, kite, arc centre, bevel. The last that is met counts.
        let pieces = [
            (2048, sides.right(), LEFT, -left_right),
            (1024, sides.left(), RIGHT, left_right),
            (512, sides.right(), TOP, right_top),
            (256, sides.top(), RIGHT, -right_top),
            (128, sides.left(), TOP, left_top),
            (64, sides.top(), LEFT, -left_top),
        ];
        let (zero, one) = (N::constant(0.0), N::constant(1.0));
        let of_code = pieces.into_iter().filter(|(bit, ..)| code & bit != 0 && self.form != 0);
        of_code.fold(r, |r, (_, kite, center, bevel)| {
            let shaped = || match self.form {
                2 => ((length(from(p, center())) - root / 3.0) * (2.0 * root)).max(zero).min(one),
                _ => (bevel * 2.0).min(one),
            };
            kite.pick(shaped, || r)
        })
    }
}

/// A corner of the triangle.
type Corner = fn() -> [f64; 2];

const TOP: Corner = || [0.5, 3_f64.sqrt() / 2.0];
const LEFT: Corner = || [0.0, 0.0];
const RIGHT: Corner = || [1.0, 0.0];

/// On which side of the bisectors between two corners of the triangle a place is.
struct Sides<N> {
    left_top: N,
    right_top: N,
    left_right: N,
}

/// The kites that are nearest to the corners: below 0 inside.
impl<N: Number> Sides<N> {
    fn top(&self) -> N {
        self.left_top.max(self.right_top)
    }

    fn left(&self) -> N {
        (-self.left_top).max(-self.left_right)
    }

    fn right(&self) -> N {
        (-self.right_top).max(self.left_right)
    }
}

fn from<N: Number>([x, z]: [N; 2], corner: [f64; 2]) -> [N; 2] {
    [x - corner[0], z - corner[1]]
}

fn length<N: Number>([x, z]: [N; 2]) -> N {
    (x.unary(Unary::Square) + z.unary(Unary::Square)).sqrt()
}

/// The norm that a corner shape measures with: 0 maximum, 1 sum, 2 Euclid.
fn square_norm<N: Number>(shape: u32, u: N, v: N) -> N {
    match shape {
        0 => u.max(v),
        1 => u + v,
        _ => length([u, v]),
    }
}
