//! The outlines of a `text` (docs/spec/primitives.md 6.5).

use ttf_parser::cmap::Format;
use ttf_parser::{Face, GlyphId, OutlineBuilder, PlatformId, kern};

use super::Compiled;
use crate::compile::Unsupported;
use crate::math::{Bounds, DMat3, DVec2, DVec3, Transform};
use crate::scene::shape::{self as scene, Font};
use crate::source::Span;
use crate::world::shape::Primitive;
use crate::world::shape::curve::{Curve, Segment};
use crate::world::shape::text::Text;

/// By how much POV-Ray's box is deeper than the glyphs, on both sides.
const ROOM: f64 = 1e-6;

/// The degrees about each axis by which POV-Ray turns every text.
const TILT: f64 = 0.001;

/// Where fonts of symbols have the characters below 256.
const SYMBOLS: u32 = 0xf000;

/// Compiles a text.
///
/// # Errors
/// A font that can't be used, and `internal` fonts where POV-Ray's font files aren't installed.
pub fn text(text: &scene::Text, span: Span) -> Result<Compiled, Unsupported> {
    let (name, path) = match &text.font {
        Font::File(name, path) => (name.clone(), path),
        Font::Internal(number, Some(path)) => (format!("internal {number}"), path),
        Font::Internal(_, None) => {
            return Err(Unsupported::new(span, "internal fonts without POV-Ray's font files"));
        }
    };
    let broken = |error: &dyn std::fmt::Display| {
        Unsupported::broken(span, format!("cannot read the font `{name}`: {error}"))
    };
    let bytes = std::fs::read(path).map_err(|error| broken(&error))?;
    let face = Face::parse(&bytes, 0).map_err(|error| broken(&error))?;
    if face.units_per_em() == 0 {
        return Err(broken(&"it has no size"));
    }
    let Some(text) = write(&face, text) else {
        return Ok(Compiled::nothing());
    };
    // The text's y is the z of the outlines, and the other way round.
    let upright = Transform::orthogonal(DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::Y));
    let tilt = Transform::rotate(DVec3::splat(TILT));
    Ok(Compiled::placed(Primitive::Other(std::sync::Arc::new(text)), upright.then(&tilt)))
}

/// Sets the glyphs one after another, in ems.
fn write(face: &Face<'_>, text: &scene::Text) -> Option<Text> {
    let em = f64::from(face.units_per_em());
    let mut outlines = Vec::new();
    let mut extent = Bounds::EMPTY;
    let mut pen = DVec2::ZERO;
    let mut previous = None;
    for &unit in &text.text {
        let glyph = glyph(face, text.unicode, unit.into());
        let outline = if unit == u16::from(b' ') { None } else { outline(face, glyph) };
        let advance = f64::from(face.glyph_hor_advance(glyph).unwrap_or(0));
        let bearing = f64::from(face.glyph_hor_side_bearing(glyph).unwrap_or(0));
        let left = outline.as_ref().map_or(0.0, |outline| outline.bounds[0].x);
        // The first glyph begins at 0, wherever it has its left side.
        let (before, after) = match previous {
            None => (-left, advance - bearing),
            Some(previous) => {
                let kerning = kerning(face, previous, glyph);
                (bearing - left + kerning, advance + kerning)
            }
        };
        if let Some(outline) = outline {
            let place = |p: DVec2| pen + (p + DVec2::X * before) / em;
            let depth = [text.thickness.min(0.0) - ROOM, text.thickness.max(0.0) + ROOM];
            let corners = outline.bounds.map(place);
            let corner = |i: usize| DVec3::new(corners[i].x, depth[i], corners[i].y);
            extent = extent.union(Bounds { min: corner(0), max: corner(1) });
            outlines.push(Curve::new(outline.segments(place)));
        }
        pen += DVec2::X * after / em + text.offset.truncate();
        previous = Some(glyph);
    }
    Text::new(outlines, text.thickness, extent)
}

/// The glyph of a character: that of the first platform with a table POV-Ray reads. 0 for what a font
/// lacks.
fn glyph(face: &Face<'_>, unicode: bool, code: u32) -> GlyphId {
    use PlatformId::{Macintosh, Unicode, Windows};
    let platforms = if unicode { [Unicode, Windows, Macintosh] } else { [Macintosh, Windows, Unicode] };
    let tables = || face.tables().cmap.iter().flat_map(|cmap| cmap.subtables);
    let readable = |format: &Format<'_>| {
        use Format::{ByteEncodingTable, SegmentMappingToDeltaValues, TrimmedTableMapping};
        matches!(format, ByteEncodingTable(_) | SegmentMappingToDeltaValues(_) | TrimmedTableMapping(_))
    };
    let table = platforms
        .into_iter()
        .find_map(|platform| tables().find(|table| table.platform_id == platform && readable(&table.format)));
    let found = table.and_then(|table| {
        let symbols = matches!(table.format, Format::SegmentMappingToDeltaValues(_)) && code < 256;
        let retry = || symbols.then(|| table.glyph_index(SYMBOLS + code)).flatten();
        table.glyph_index(code).or_else(retry)
    });
    found.unwrap_or(GlyphId(0))
}

/// How much nearer two glyphs are, in the font's units. The pairs need not be in order, as they are not in
/// POV-Ray's own fonts.
fn kerning(face: &Face<'_>, left: GlyphId, right: GlyphId) -> f64 {
    let tables = face.tables().kern.iter().flat_map(|kern| kern.subtables);
    let level = tables.filter(|table| table.horizontal && !table.has_cross_stream && !table.variable);
    let pairs = level.filter_map(|table| match table.format {
        kern::Format::Format0(table) => {
            table.pairs.into_iter().find(|pair| (pair.left(), pair.right()) == (left, right))
        }
        _ => None,
    });
    pairs.map(|pair| f64::from(pair.value)).sum()
}

/// One piece of an outline, in the font's units, from the point before.
enum Stroke {
    Start(DVec2),
    Line(DVec2),
    Parabola(DVec2, DVec2),
    Cubic(DVec2, DVec2, DVec2),
    Close,
}

/// A glyph's outline, in the font's units.
struct Outline {
    strokes: Vec<Stroke>,
    /// The box the font tells, and all points: the boxes that fonts tell may be wrong.
    bounds: [DVec2; 2],
}

/// `None` for a blank.
fn outline(face: &Face<'_>, glyph: GlyphId) -> Option<Outline> {
    let mut outline = Outline { strokes: Vec::new(), bounds: [DVec2::ZERO; 2] };
    let around = face.outline_glyph(glyph, &mut outline)?;
    let told = face.tables().glyf.and_then(|glyf| glyf.bbox(glyph)).unwrap_or(around);
    let corner = |x: i16, y: i16| DVec2::new(x.into(), y.into());
    let told = [corner(told.x_min, told.y_min), corner(told.x_max, told.y_max)];
    outline.bounds = outline.points().fold(told, |[low, high], p| [low.min(p), high.max(p)]);
    Some(outline)
}

impl Outline {
    /// All points, those that only bend the outline too.
    fn points(&self) -> impl Iterator<Item = DVec2> {
        self.strokes.iter().flat_map(|stroke| match *stroke {
            Stroke::Start(p) | Stroke::Line(p) => vec![p],
            Stroke::Parabola(a, b) => vec![a, b],
            Stroke::Cubic(a, b, c) => vec![a, b, c],
            Stroke::Close => Vec::new(),
        })
    }

    /// The closed contours, with every point moved by `place`.
    fn segments(&self, place: impl Fn(DVec2) -> DVec2) -> Vec<Segment> {
        let mut segments = Vec::new();
        let (mut start, mut last) = (DVec2::ZERO, DVec2::ZERO);
        for stroke in &self.strokes {
            let from = last;
            match *stroke {
                Stroke::Start(p) => (start, last) = (place(p), place(p)),
                Stroke::Line(p) => last = place(p),
                Stroke::Parabola(_, p) | Stroke::Cubic(_, _, p) => last = place(p),
                Stroke::Close => last = start,
            }
            match *stroke {
                Stroke::Parabola(a, _) => segments.push(Segment::parabola(from, place(a), last)),
                Stroke::Cubic(a, b, _) => segments.push(Segment::bezier(from, place(a), place(b), last)),
                Stroke::Line(_) | Stroke::Close if from != last => segments.push(Segment::linear(from, last)),
                Stroke::Start(_) | Stroke::Line(_) | Stroke::Close => {}
            }
        }
        segments
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.strokes.push(Stroke::Start(point(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.strokes.push(Stroke::Line(point(x, y)));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.strokes.push(Stroke::Parabola(point(x1, y1), point(x, y)));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.strokes.push(Stroke::Cubic(point(x1, y1), point(x2, y2), point(x, y)));
    }

    fn close(&mut self) {
        self.strokes.push(Stroke::Close);
    }
}

fn point(x: f32, y: f32) -> DVec2 {
    DVec2::new(x.into(), y.into())
}

#[cfg(test)]
mod tests;
