//! What is known at a point where patterns, pigments and normals are asked for, and how they,
//! functions and shapes see each other.

use crate::math::color::FourColors;
use crate::math::{Band, DVec2, DVec3, Lanes, Rgbft, Slant};
use crate::world::warp::Warps;

/// A place where a texture is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a> {
    /// Where patterns are evaluated: the hit point seen from the texture's space, or `<u,v,0>`.
    pub point: DVec3,
    /// The hit point in the world.
    pub position: DVec3,
    /// The surface normal in the world: unit, raw, facing the ray. Zero where there is no surface,
    /// as in functions, media and skies; `slope` and `aoi` are 0 then.
    pub normal: DVec3,
    /// The normal that `slope` and `aoi` see: starts as `normal`, every finished normal block
    /// overwrites it (docs/spec/patterns-textures.md 7.4).
    pub bent: DVec3,
    /// Unit direction of the ray in the world.
    pub direction: DVec3,
    /// Texture coordinates of the hit.
    pub uv: DVec2,
    /// Patterned textures and transforms around the layer being evaluated, innermost first.
    pub enclosing: Option<&'a Enclosing<'a>>,
}

impl Sample<'_> {
    /// A point without a surface.
    #[inline]
    pub const fn at(point: DVec3) -> Self {
        Self {
            point,
            position: point,
            normal: DVec3::ZERO,
            bent: DVec3::ZERO,
            direction: DVec3::ZERO,
            uv: DVec2::new(point.x, point.y),
            enclosing: None,
        }
    }

    /// A hit: world point, raw unit normal facing the ray, unit direction of the ray, texture coordinates.
    #[inline]
    pub fn on_surface(position: DVec3, normal: DVec3, direction: DVec3, uv: DVec2) -> Self {
        Self { position, normal, bent: normal, direction, uv, ..Self::at(position) }
    }

    /// The same place seen from elsewhere.
    #[inline]
    pub fn moved(&self, point: DVec3) -> Self {
        Self { point, ..*self }
    }

    /// The same place seen through `uv_mapping`.
    pub fn uv_mapped(&self) -> Self {
        self.moved(self.uv.extend(0.0))
    }
}

/// Four samples that are evaluated side by side.
#[derive(Clone, Copy, Debug)]
pub struct Samples<'a> {
    /// Where patterns are evaluated, coordinate by coordinate.
    pub point: [Lanes; 3],
    places: Places<'a>,
}

/// What is known of four samples besides.
#[derive(Clone, Copy, Debug)]
enum Places<'a> {
    /// Where they are in the world: there is no surface.
    Points(&'a [Lanes; 3]),
    /// All there is.
    Hits(&'a [Sample<'a>; Lanes::COUNT]),
}

impl<'a> Samples<'a> {
    /// Four points without a surface.
    #[inline(always)]
    pub fn at(point: &'a [Lanes; 3]) -> Self {
        Self { point: *point, places: Places::Points(point) }
    }

    /// These, at their own points.
    #[inline]
    pub fn of(hits: &'a [Sample<'a>; Lanes::COUNT]) -> Self {
        let [a, b, c, d] = hits;
        let axis = |axis: usize| Lanes([a.point[axis], b.point[axis], c.point[axis], d.point[axis]]);
        Self { point: [axis(0), axis(1), axis(2)], places: Places::Hits(hits) }
    }

    /// The same places seen from elsewhere.
    #[inline(always)]
    pub fn moved(&self, point: [Lanes; 3]) -> Self {
        Self { point, ..*self }
    }

    /// The point of one of them.
    #[inline(always)]
    pub fn point_of(&self, lane: usize) -> DVec3 {
        Lanes::point(&self.point, lane)
    }

    /// What is known of one of them besides its point.
    #[inline]
    pub fn surface(&self, lane: usize) -> &Sample<'a> {
        const NONE: &Sample = &Sample::at(DVec3::ZERO);
        match self.places {
            Places::Points(_) => NONE,
            Places::Hits(hits) => &hits[lane],
        }
    }

    /// One of them.
    #[inline]
    pub fn get(&self, lane: usize) -> Sample<'a> {
        let point = self.point_of(lane);
        match self.places {
            Places::Points(places) => Sample::at(Lanes::point(places, lane)).moved(point),
            Places::Hits(hits) => hits[lane].moved(point),
        }
    }

    /// The same places seen through `uv_mapping`.
    pub fn uv_mapped(&self) -> Self {
        let [mut u, mut v] = [Lanes::ZERO; 2];
        for lane in 0..Lanes::COUNT {
            DVec2 { x: u.0[lane], y: v.0[lane] } = self.get(lane).uv;
        }
        self.moved([u, v, Lanes::ZERO])
    }
}

/// A link in the list of what stands around a layer: normals pass through all of it.
#[derive(Clone, Copy, Debug)]
pub struct Enclosing<'a> {
    /// The way into the enclosed space.
    pub warps: &'a Warps,
    /// The way changes the length of normals.
    pub no_bump_scale: bool,
    /// This is merely where a plain texture's layers are, no texture around them.
    pub of_layers: bool,
    /// What stands around this.
    pub outer: Option<&'a Enclosing<'a>>,
}

impl Enclosing<'_> {
    /// Whether this or anything around it has `no_bump_scale`, which holds for every normal inside.
    pub fn is_raw(&self) -> bool {
        self.no_bump_scale || self.outer.is_some_and(Enclosing::is_raw)
    }

    /// A normal of the world seen from the innermost space.
    pub fn inward(&self, normal: DVec3) -> DVec3 {
        let normal = self.outer.map_or(normal, |outer| outer.inward(normal));
        self.warps.normal_inward(normal, self.no_bump_scale)
    }

    /// A normal of the innermost space seen from the world.
    pub fn outward(&self, normal: DVec3) -> DVec3 {
        let normal = self.warps.normal_outward(normal, self.no_bump_scale);
        self.outer.map_or(normal, |outer| outer.outward(normal))
    }
}

/// Gives a number at every sample: patterns, functions and pigments seen as grey.
pub trait Field: Send + Sync + std::fmt::Debug {
    /// The number at `sample`.
    fn value(&self, sample: &Sample) -> f64;

    /// The number at a point without a surface.
    fn at(&self, point: DVec3) -> f64 {
        self.value(&Sample::at(point))
    }

    /// The numbers at four samples, the same bits as one by one.
    fn four(&self, samples: &Samples) -> Lanes {
        one_by_one(|lane| self.value(&samples.get(lane)))
    }

    /// The numbers at four points without a surface, given by their coordinates. Sines and cosines may be off by
    /// [`Lanes::SINE_ERROR`].
    fn at_four(&self, point: &[Lanes; 3]) -> Lanes {
        self.four(&Samples::at(point))
    }

    /// What holds the numbers at all points without a surface whose coordinates these hold.
    fn enclose(&self, _point: &[Band; 3]) -> Band {
        Band::UNKNOWN
    }

    /// The same where texture coordinates are those of other points, from which these were moved.
    fn enclose_mapped(&self, point: &[Band; 3], _uv: &[Band; 2]) -> Band {
        self.enclose(point)
    }

    /// The same with how fast the numbers rise, where that is known.
    fn slant(&self, point: &[Slant; 3]) -> Slant {
        Slant::unknown_rise(self.enclose(&point.map(|p| p.value)))
    }

    /// Whether [`Field::enclose`] knows the field: the bands of short stretches are narrow, wherever it is
    /// continuous.
    fn is_known(&self) -> bool {
        false
    }

    /// Whether the numbers are rounded to single precision, as those of colours are.
    fn is_single(&self) -> bool {
        false
    }
}

/// A number for each of four lanes, one after the other.
#[inline]
pub fn one_by_one(number: impl Fn(usize) -> f64) -> Lanes {
    Lanes([number(0), number(1), number(2), number(3)])
}

/// Gives a colour at every sample: pigments.
pub trait Colors: Send + Sync + std::fmt::Debug {
    /// The colour at `sample`, white and clear where there is none.
    fn color(&self, sample: &Sample) -> Rgbft;

    /// The colours at four samples, the same bits as one by one.
    fn four_colors(&self, samples: &Samples) -> FourColors;

    /// What holds a component (0 … 4: red, green, blue, filter, transmit; or their
    /// [`GREY`](crate::math::color::GREY)) of the colours of all points whose coordinates these hold.
    fn enclose(&self, _point: &[Band; 3], _component: u8) -> Band {
        Band::UNKNOWN
    }

    /// Whether [`Colors::enclose`] knows the colours, as [`Field::is_known`].
    fn is_known(&self) -> bool {
        false
    }
}

/// Has an inside: objects as patterns see them.
pub trait Inside: Send + Sync + std::fmt::Debug {
    /// Whether the point, in the space where the object was written, is inside.
    fn inside(&self, point: DVec3) -> bool;

    /// What holds whether points are inside whose coordinates these hold: 1, 0 or both.
    fn enclose(&self, _point: &[Band; 3]) -> Band {
        Band::between(0.0, 1.0)
    }
}
