//! `pavement`: floors of polyominoes, polyiamonds and polyhexes (docs/spec/patterns-textures.md 2.7.3).

use crate::math::{DVec2, DVec3};

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

    fn squares(&self, p: DVec2) -> f64 {
        let cell = p.floor();
        let code = self.cells.code(cell.x, cell.y);
        let at = p - cell;
        let walls = [(1, at.x), (2, 1.0 - at.x), (4, at.y), (8, 1.0 - at.y)];
        // Corners: mark, the walls that touch it, twice the distances from it.
        let corners = [
            (16, 1 | 4, at.x, at.y),
            (32, 2 | 4, 1.0 - at.x, at.y),
            (64, 1 | 8, at.x, 1.0 - at.y),
            (128, 2 | 8, 1.0 - at.x, 1.0 - at.y),
        ]
        .map(|(mark, touching, u, v)| (mark, touching, 2.0 * u, 2.0 * v));
        if self.form < 3 {
            for index in [3, 2, 1, 0] {
                let (mark, touching, u, v) = corners[index];
                let opposite = 15 ^ touching;
                if code & mark != 0 && code & opposite == opposite {
                    return (square_norm(self.form, u, v) - 1.0).abs().min(1.0);
                }
            }
        }
        let mut r = 0_f64;
        for (wall, distance) in walls {
            if code & wall != 0 {
                r = r.max(1.0 - 2.0 * distance);
            }
        }
        for (mark, touching, u, v) in corners {
            if code & mark != 0 {
                r = r.max(1.0 - square_norm(self.interior, u, v));
            }
            if code & touching == touching {
                match self.exterior {
                    1 => r = r.max((2.0 - (u + v)).min(1.0)),
                    2 if u <= 1.0 && v <= 1.0 => {
                        r = r.max(((1.0 - u).powi(2) + (1.0 - v).powi(2)).sqrt().min(1.0));
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
            return self.triangle(code, at);
        }
        let bottom = left + 1.0;
        let code = self.cells.code(2.0 * bottom - 1.0, row);
        self.triangle(code, DVec2::new(0.5 - (p.x - bottom), row_height - z))
    }

    /// A point of the triangle with corners (0,0), (1,0) and the top (½, √3/2).
    fn triangle(&self, code: u32, p: DVec2) -> f64 {
        let root = 3_f64.sqrt();
        let kappa = 2.0 * root;
        let (x, z) = (p.x, p.y);
        let [left, right, base] = [(root * x - z) / 2.0, (root * (1.0 - x) - z) / 2.0, z];
        // Signed sides of the bisectors between two corners.
        let left_top = 1.0 - (root * z + x);
        let right_top = 1.0 - (root * z - x + 1.0);
        let left_right = 1.0 - 2.0 * x;
        let wall = |bit: u32| code & bit != 0;

        let mut r = 0_f64;
        for (bit, distance) in [(1, left), (2, right), (4, base)] {
            if wall(bit) {
                r = r.max(1.0 - kappa * distance);
            }
        }

        // Marks: bit, corner, height over the opposite direction, kite, the two bevels of interior 1.
        let marks = [
            (
                8,
                DVec2::new(0.5, root / 2.0),
                root / 2.0 - z,
                left_top < 0.0 && right_top < 0.0,
                (1.5 * (1.0 - left_top) - 2.0, 1.5 * (1.0 - right_top) - 2.0),
            ),
            (
                16,
                DVec2::ZERO,
                (root * x + z) / 2.0,
                left_top > 0.0 && left_right > 0.0,
                (1.0 - 1.5 * (1.0 - left_top), 1.0 - 3.0 * x),
            ),
            (
                32,
                DVec2::X,
                (root * (1.0 - x) + z) / 2.0,
                right_top > 0.0 && left_right < 0.0,
                (1.0 - 1.5 * (1.0 - right_top), 3.0 * x - 2.0),
            ),
        ];
        for (bit, corner, height, in_kite, bevels) in marks {
            if !wall(bit) {
                continue;
            }
            match self.interior {
                0 => r = r.max(1.0 - kappa * height),
                2 => r = r.max(1.0 - 3.0 * (p - corner).length()),
                _ if in_kite => r = r.max(bevels.0.min(bevels.1)),
                _ => {}
            }
        }

        if self.sides == 3 {
            r = self
                .outer_corner(code, p, [left, right, base], [left_top, right_top, left_right])
                .unwrap_or(r);
        }
        self.tip(code, p, [left_top, right_top, left_right]).unwrap_or(r)
    }

    /// Step 3: corners between two walls, shaped by `exterior`.
    fn outer_corner(
        &self,
        code: u32,
        p: DVec2,
        [left, right, base]: [f64; 3],
        [left_top, right_top, left_right]: [f64; 3],
    ) -> Option<f64> {
        let root = 3_f64.sqrt();
        let kappa = 2.0 * root;
        let middle = DVec2::new(0.5, root / 6.0);
        let between = |walls: u32| code & walls == walls;
        match self.exterior {
            2 => {
                let rounded = between(1 | 2) && left_top <= 0.0 && right_top <= 0.0
                    || between(1 | 4) && left_top >= 0.0 && left_right >= 0.0
                    || between(2 | 4) && right_top >= 0.0 && left_right <= 0.0;
                rounded.then(|| (kappa * (p - middle).length()).min(1.0))
            }
            1 => {
                let near = |d: f64| 1.0 - kappa * d >= 0.0;
                let (x, z) = (root * (p.x - 0.5), p.y - root / 6.0);
                let bevels = [
                    (1 | 4, left, base, root * (x + z).abs()),
                    (2 | 4, right, base, root * (x - z).abs()),
                    (1 | 2, left, right, kappa * z.abs()),
                ];
                let meeting =
                    bevels.into_iter().find(|&(walls, a, b, _)| between(walls) && near(a) && near(b));
                meeting.map(|(.., height)| height.min(1.0))
            }
            _ => None,
        }
    }

    /// Step 4: pieces shaped by `form`.
    fn tip(&self, code: u32, p: DVec2, [left_top, right_top, left_right]: [f64; 3]) -> Option<f64> {
        let root = 3_f64.sqrt();
        let (top, left, right) = (DVec2::new(0.5, root / 2.0), DVec2::ZERO, DVec2::X);
        let in_top = left_top < 0.0 && right_top < 0.0;
        let in_left = left_top > 0.0 && left_right > 0.0;
        let in_right = right_top > 0.0 && left_right < 0.0;
        // Bit, kite, arc centre, bevel.
        let pieces = [
            (64, in_top, left, -left_top),
            (128, in_left, top, left_top),
            (256, in_top, right, -right_top),
            (512, in_right, top, right_top),
            (1024, in_left, right, left_right),
            (2048, in_right, left, -left_right),
        ];
        let (.., center, bevel) = pieces.into_iter().find(|&(bit, inside, ..)| code & bit != 0 && inside)?;
        match self.form {
            2 => Some((2.0 * root * ((p - center).length() - root / 3.0)).clamp(0.0, 1.0)),
            1 => Some((2.0 * bevel).min(1.0)),
            _ => None,
        }
    }
}

/// The norm that a corner shape measures with: 0 maximum, 1 sum, 2 Euclid.
fn square_norm(shape: u32, u: f64, v: f64) -> f64 {
    match shape {
        0 => u.max(v),
        1 => u + v,
        _ => (u * u + v * v).sqrt(),
    }
}
