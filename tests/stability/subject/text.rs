//! Writing: outlines of a font, swept. Needs POV-Ray's fonts: Debian's povray-includes.

use std::f64::consts::PI;

use povista::math::DVec2;
use ttf_parser::{Face, OutlineBuilder};

use super::spline::Prism;
use crate::curve::Piece;
use crate::double::Double;
use crate::model::{Exact, Line, Meeting, Subject};
use crate::real::Moved;
use crate::shoot_at;

const FONT: &str = "/usr/share/povray-3.7/include/timrom.ttf";

/// The strokes of a glyph, in the font's units.
#[derive(Default)]
struct Outline {
    start: DVec2,
    last: DVec2,
    strokes: Vec<[DVec2; 3]>,
}

impl Outline {
    fn to(&mut self, bend: Option<DVec2>, end: DVec2) {
        if self.last != end {
            self.strokes.push([self.last, bend.unwrap_or(DVec2::NAN), end]);
        }
        self.last = end;
    }
}

fn at(x: f32, y: f32) -> DVec2 {
    DVec2::new(x.into(), y.into())
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        (self.start, self.last) = (at(x, y), at(x, y));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.to(None, at(x, y));
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.to(Some(at(x1, y1)), at(x, y));
    }
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {
        unreachable!("the font has parabolas only");
    }
    fn close(&mut self) {
        self.to(None, self.start);
    }
}

/// One glyph of thickness 1/2, scaled, and turned as POV-Ray turns every text.
struct Text {
    glyph: Prism,
    size: f64,
}

impl Text {
    fn new(letter: char, size: f64) -> Self {
        let bytes = std::fs::read(FONT).expect("povray-includes are installed");
        let face = Face::parse(&bytes, 0).expect("it is a font");
        let glyph = face.glyph_index(letter).expect("it has the letter");
        let mut outline = Outline::default();
        let around = face.outline_glyph(glyph, &mut outline).expect("it is no blank");
        let left = face.tables().glyf.and_then(|glyf| glyf.bbox(glyph)).unwrap_or(around).x_min;
        let em = f64::from(face.units_per_em());
        let place = |p: DVec2| ((p - DVec2::X * f64::from(left)) / em).to_array();
        let pieces = outline.strokes.iter().map(|&[a, b, c]| match b.is_nan() {
            true => Piece::linear(&[place(a), place(c)]),
            false => Piece::parabola(&[place(a), place(b), place(c)]),
        });
        let glyph = Prism { outline: pieces.collect(), heights: [0.0, 0.5], axes: [0, 1, 2], reach: 1.0 };
        Self { glyph, size }
    }

    /// The sine and the cosine of the angle it is turned by about each axis.
    fn turn() -> [Double; 2] {
        let pi = Double::of(PI) + Double::of(1.224_646_799_147_353_2e-16);
        let angle = pi * Double::of(0.001) / Double::of(180.0);
        let (mut term, mut sums) = (Double::of(1.0), [Double::of(0.0); 2]);
        for n in 0..12 {
            let sign = if n / 2 % 2 == 0 { 1.0 } else { -1.0 };
            sums[(n + 1) % 2] = sums[(n + 1) % 2] + term * Double::of(sign);
            term = term * angle / Double::of((n + 1) as f64);
        }
        sums
    }

    fn inner(&self, line: &Line) -> Line {
        let [sin, cos] = Self::turn();
        let back = |v: [Double; 3]| {
            let [x, y, z] = v.map(|x| x / Double::of(self.size));
            let (x, y) = (x * cos + y * sin, y * cos - x * sin);
            let (x, z) = (x * cos - z * sin, z * cos + x * sin);
            [x, y * cos + z * sin, z * cos - y * sin]
        };
        Line {
            origin: back(line.origin),
            direction: back(line.direction),
            room: line.room / self.size,
            ..*line
        }
    }
}

impl Subject for Text {
    fn reach(&self) -> f64 {
        self.size
    }

    fn meet(&self, line: &Line) -> Meeting {
        self.glyph.meet(&self.inner(line))
    }

    fn sensitivity(&self, line: &Line, at: &Exact) -> Moved {
        let moved = self.glyph.sensitivity(&self.inner(line), at);
        let [sin, cos] = Self::turn().map(Double::to_f64);
        let [x, y, z] = moved.slope.map(|x| x / self.size);
        let (y, z) = (y * cos - z * sin, z * cos + y * sin);
        let (x, z) = (x * cos + z * sin, z * cos - x * sin);
        Moved { slope: [x * cos - y * sin, x * sin + y * cos, z], ..moved }
    }
}

#[test]
fn text() {
    shoot_at("text", |size| {
        let object = format!("text {{ ttf \"{FONT}\" \"B\" 0.5, 0 scale {size:e} }}");
        (object, Text::new('B', size))
    });
}
