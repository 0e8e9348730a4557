//! The primitives: one file each, all behind [`Shape`].

pub mod bicubic_patch;
pub mod blob;
pub mod r#box;
pub mod cone;
pub mod curve;
pub mod cylinder;
pub mod disc;
pub mod empty;
pub mod height_field;
pub mod isosurface;
pub mod julia_fractal;
pub mod lathe;
pub mod mesh;
pub mod ovus;
pub mod parametric;
pub mod plane;
pub mod poly;
pub mod polygon;
pub mod primitive;
pub mod prism;
pub mod quadric;
pub mod sor;
pub mod sphere;
pub mod sphere_sweep;
pub mod stretch;
pub mod superellipsoid;
pub mod text;
pub mod torus;
pub mod triangle;
mod uncrossed;

#[cfg(test)]
pub(crate) mod battery;

pub use primitive::Primitive;

use std::cell::Cell;
use std::sync::Arc;

use self::r#box::Cuboid;
use super::ray::{Range, Ray, Rays};
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes};

/// One crossing of a ray with a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Distance along the ray.
    pub t: f64,
    /// Which part of the surface was hit: a face, a triangle, a component. The shape's own numbering.
    pub part: u32,
    /// Where on the part: barycentric coordinates of a triangle, parameters of a patch. The shape's own.
    pub at: [f64; 2],
}

impl Crossing {
    /// A crossing whose place on the part needs no saying.
    pub fn new(t: f64, part: u32) -> Self {
        Self { t, part, at: [0.0; 2] }
    }
}

/// What rays have found out about a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Remark {
    /// It is steeper than its author says.
    TooSteep {
        /// The steepest gradient that rays have met.
        found: f64,
        /// What its author says.
        said: f64,
        /// Whether that makes holes.
        holes: bool,
    },
}

thread_local! {
    /// Room for crossings, so that no ray allocates any; calls that nest find none.
    static SPARE: Cell<Vec<Crossing>> = const { Cell::new(Vec::new()) };
}

/// The number that stands for the object's own texture among those of [`Shape::textures`].
pub const OWN_TEXTURE: u32 = u32::MAX;

/// A geometry in its own space. The space is reached by the caller; directions of rays are not unit.
///
/// Distances carry no absolute tolerance: a shape reports every crossing in the open range, as
/// exactly as f64 allows at the ray's and the shape's own scale.
pub trait Shape: Send + Sync + std::fmt::Debug {
    /// A box around the surface and, for solids, the inside; may be unbounded.
    fn bounds(&self) -> Bounds;

    /// The box `min_extent` and `max_extent` report, where POV-Ray's isn't [`Shape::bounds`].
    fn extent(&self) -> Bounds {
        self.bounds()
    }

    /// Adds every crossing in `range`, in ascending order of `t`; tangent points count once.
    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>);

    /// The nearest crossing in `range`. Overridden where that is cheaper than finding all.
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut all = SPARE.take();
        all.clear();
        self.crossings(ray, range, &mut all);
        let nearest = all.iter().copied().min_by(|a, b| a.t.total_cmp(&b.t));
        SPARE.set(all);
        nearest
    }

    /// Finds what [`Shape::nearest`] does for those of four rays near each other of which `asked` has the bits, ahead
    /// of their starts and not behind their ends; whether it is quicker to ask that for them together.
    fn nearest_together(
        &self,
        _rays: &Rays,
        _asked: u32,
        _ends: &Lanes,
        _found: &mut [Option<Crossing>; Lanes::COUNT],
    ) -> bool {
        false
    }

    /// Whether no line crosses it more than once.
    fn is_flat(&self) -> bool {
        false
    }

    /// Whether anything is crossed in `range`.
    #[inline(always)]
    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        self.nearest(ray, range).is_some()
    }

    /// Whether it is known that there is surface wherever a ray comes to the inside or leaves it, and that a crossing is
    /// the same but for rounding whatever the range in which it is looked for.
    fn is_closed(&self) -> bool {
        false
    }

    /// Whether `point` is inside, with POV-Ray's rule for points exactly on the surface
    /// (docs/spec/primitives.md, "inside" of each shape). Surfaces without an inside say `false`.
    fn inside(&self, point: DVec3) -> bool;

    /// Whether `point` is inside the inverted shape: the complement, but for shapes of which
    /// neither side has the border.
    fn outside(&self, point: DVec3) -> bool {
        !self.inside(point)
    }

    /// What holds whether points that these hold are [inside](Shape::inside): 1, 0 or both; on the border both. It is
    /// asked near [`Shape::bounds`] only.
    fn inside_along(&self, _point: &[Band; 3]) -> Band {
        Band::between(0.0, 1.0)
    }

    /// Whether the shape has an inside at all.
    fn is_solid(&self) -> bool {
        true
    }

    /// The outward normal at a crossing, not necessarily unit; for smooth triangles the interpolated one.
    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3;

    /// The true surface normal where [`Shape::normal`] is an interpolated one.
    fn geometric_normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.normal(point, crossing)
    }

    /// Whether [`Shape::geometric_normal`] may be another than [`Shape::normal`].
    fn interpolates(&self) -> bool {
        false
    }

    /// [`Shape::normal`] in the space around: `outer` takes a normal there and makes it unit. Overridden
    /// where POV-Ray blends normals that it has taken there.
    fn outer_normal(&self, point: DVec3, crossing: &Crossing, outer: &dyn Fn(DVec3) -> DVec3) -> DVec3 {
        outer(self.normal(point, crossing))
    }

    /// Texture coordinates at a crossing; `None` where POV-Ray has none and takes world x and y.
    fn uv(&self, _point: DVec3, _crossing: &Crossing) -> Option<DVec2> {
        None
    }

    /// Calls back with the number and weight of every texture of the shape's own list that takes part
    /// at a crossing; the weights sum to 1. Never called back: the object's texture, which is otherwise
    /// [`OWN_TEXTURE`].
    fn textures(&self, _point: DVec3, _crossing: &Crossing, _found: &mut dyn FnMut(u32, f64)) {}

    /// How far behind a crossing, as a distance along the ray, POV-Ray takes the surface to be: there
    /// textures are looked up and normals taken, while rays leave from the crossing itself.
    fn lag(&self, _crossing: &Crossing) -> f64 {
        0.0
    }

    /// The same shape, of which mostly what is in a ball matters; `None` where it doesn't profit from knowing that.
    fn at_home_in(&self, _center: DVec3, _radius: f64) -> Option<Arc<dyn Shape>> {
        None
    }

    /// The same shape, which rays miss that neither start in nor hit a box; `None` where somebody else must see to that.
    fn behind_gate(&self, _gate: Cuboid) -> Option<Arc<dyn Shape>> {
        None
    }

    /// A box of which it is known that rays that miss it miss the shape, where that is worth asking four of them.
    fn gate(&self) -> Option<Cuboid> {
        None
    }

    /// What its author should know once rays have been there.
    fn remark(&self) -> Option<Remark> {
        None
    }

    /// [`Shape::reproject`] and [`Shape::normal`] of a computed hit point, where it is cheaper to find both at once.
    fn touched(&self, _point: DVec3, _crossing: &Crossing) -> Option<(DVec3, DVec3)> {
        None
    }

    /// Moves a computed hit point onto the surface as exactly as f64 allows.
    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        point
    }
}

/// Moves a point by a Newton step, given the value and the gradient there of what is zero on the surface, unless that
/// leaps farther than a millionth of a size, given its square: where the gradient nearly vanishes it leads anywhere.
#[inline]
fn downhill(point: DVec3, (value, gradient): (f64, DVec3), size_squared: f64) -> DVec3 {
    let step = gradient * (value / gradient.length_squared());
    if step.length_squared() <= 1e-12 * size_squared { point - step } else { point }
}
