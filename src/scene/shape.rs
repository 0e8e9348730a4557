//! Every geometry POV-Ray has, with its parameters as written (docs/spec/language.md 6.5).

use std::sync::Arc;

use super::depth::Nested;
use super::function::Function;
use super::image::ImageSource;
use super::{Light, Object, Texture};
use crate::math::{DVec2, DVec3, DVec4, Transform};

/// A geometry in its own space. Big ones are behind a pointer, to keep an object small.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the fields are the statement's parameters")]
pub enum Shape {
    /// `sphere { center, radius }`.
    Sphere { center: DVec3, radius: f64 },
    /// `box { a, b }`, corners sorted.
    Box { min: DVec3, max: DVec3 },
    /// `cylinder { base, cap, radius [open] }`.
    Cylinder(Box<Cone>),
    /// `cone { base, base_radius, cap, cap_radius [open] }`.
    Cone(Box<Cone>),
    /// `torus { major, minor }`, around the y axis.
    Torus { major: f64, minor: f64 },
    /// `plane { normal, distance }`; unit normal.
    Plane { normal: DVec3, distance: f64 },
    /// `disc { center, normal, radius [, hole] }`; unit normal.
    Disc(Box<Disc>),
    /// `triangle` and `smooth_triangle`.
    Triangle(Box<Triangle>),
    /// `polygon`: closed contours one after another.
    Polygon(Arc<[DVec3]>),
    /// `quadric`: squares, products (xy, xz, yz), linear terms, constant.
    Quadric(Box<Quadric>),
    /// `cubic`, `quartic`, `poly`, `polynomial`.
    Poly(Arc<Poly>),
    /// `bicubic_patch`.
    BicubicPatch(Arc<BicubicPatch>),
    /// `blob`.
    Blob(Arc<Blob>),
    /// `height_field`.
    HeightField(Arc<HeightField>),
    /// `isosurface`.
    Isosurface(Arc<Isosurface>),
    /// `julia_fractal`.
    JuliaFractal(Arc<JuliaFractal>),
    /// `lathe`.
    Lathe(Arc<Lathe>),
    /// `prism`.
    Prism(Arc<Prism>),
    /// `sor`.
    Sor(Arc<Sor>),
    /// `sphere_sweep`.
    SphereSweep(Arc<SphereSweep>),
    /// `superellipsoid { <east-west, north-south> }`.
    Superellipsoid { east: f64, north: f64 },
    /// `ovus { bottom, top }`.
    Ovus { bottom: f64, top: f64 },
    /// `text`.
    Text(Arc<Text>),
    /// `mesh` and `mesh2`.
    Mesh(Arc<Mesh>),
    /// `parametric`.
    Parametric(Arc<Parametric>),
    /// `union`, `merge`, `intersection`, `difference`.
    Csg(Arc<Csg>),
    /// `light_source`.
    Light(Arc<Light>),
    /// `light_group`.
    LightGroup(Arc<LightGroup>),
}

/// A `cone`; a `cylinder` has equal radii.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone {
    /// Centre of the first end.
    pub base: DVec3,
    /// Radius there.
    pub base_radius: f64,
    /// Centre of the second end.
    pub cap: DVec3,
    /// Radius there.
    pub cap_radius: f64,
    /// Without end discs.
    pub open: bool,
}

/// A `disc`.
#[derive(Clone, Debug, PartialEq)]
pub struct Disc {
    /// Centre.
    pub center: DVec3,
    /// Unit normal.
    pub normal: DVec3,
    /// Outer radius.
    pub radius: f64,
    /// Radius of the hole; 0 for none.
    pub hole: f64,
}

/// A `triangle` or `smooth_triangle`.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    /// Corners.
    pub corners: [DVec3; 3],
    /// Normals at the corners of a `smooth_triangle`, as written.
    pub normals: Option<[DVec3; 3]>,
}

/// A `quadric`: A x² + B y² + C z² + D xy + E xz + F yz + G x + H y + I z + J = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadric {
    /// A, B, C.
    pub squares: DVec3,
    /// D (xy), E (xz), F (yz).
    pub products: DVec3,
    /// G, H, I.
    pub linear: DVec3,
    /// J.
    pub constant: f64,
}

/// A polynomial of `order` in x, y, z.
#[derive(Clone, Debug, PartialEq)]
pub struct Poly {
    /// 2 … 35.
    pub order: u32,
    /// (o+1)(o+2)(o+3)/6 coefficients in `poly`'s order (docs/spec/primitives.md 3.9).
    pub coefficients: Vec<f64>,
}

/// A `bicubic_patch`.
#[derive(Clone, Debug, PartialEq)]
pub struct BicubicPatch {
    /// 0 or 1: how it is subdivided.
    pub kind: u32,
    /// Flatness at which subdivision stops.
    pub flatness: f64,
    /// Subdivision limits.
    pub steps: [u32; 2],
    /// Intersection accuracy.
    pub accuracy: f64,
    /// 4 × 4 control points, row by row.
    pub points: [DVec3; 16],
    /// `uv_vectors` of the four corners.
    pub uv: Option<[DVec2; 4]>,
}

/// A `blob`.
#[derive(Clone, Debug)]
pub struct Blob {
    /// Field strength of the surface.
    pub threshold: f64,
    /// Components in order.
    pub components: Nested<Vec<BlobComponent>>,
}

/// One component of a blob.
#[derive(Clone, Debug)]
pub struct BlobComponent {
    /// Geometry, before `transform`.
    pub kind: BlobKind,
    /// Field strength at the centre; negative ones carve.
    pub strength: f64,
    /// From the component's space to the blob's.
    pub transform: Option<Arc<Transform>>,
    /// Own texture.
    pub texture: Option<Texture>,
}

/// The geometry of a blob component.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are the statement's parameters")]
pub enum BlobKind {
    /// `sphere`.
    Sphere { center: DVec3, radius: f64 },
    /// `cylinder`, with half-spheres at both ends.
    Cylinder { base: DVec3, cap: DVec3, radius: f64 },
}

/// A `height_field`, over the unit square in x and z.
#[derive(Clone, Debug)]
pub struct HeightField {
    /// Heights.
    pub image: Arc<ImageSource>,
    /// Everything below is cut away, in 0 … 1.
    pub water_level: f64,
    /// Normals are interpolated.
    pub smooth: bool,
}

/// A box or sphere around an isosurface or parametric surface.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are the statement's parameters")]
pub enum Container {
    /// `box`, corners sorted.
    Box { min: DVec3, max: DVec3 },
    /// `sphere`.
    Sphere { center: DVec3, radius: f64 },
}

/// An `isosurface`.
#[derive(Clone, Debug)]
pub struct Isosurface {
    /// Zero set of `function - threshold`.
    pub function: Arc<Function>,
    /// Where it is looked for.
    pub container: Container,
    /// See `function`.
    pub threshold: f64,
    /// Accuracy of the root.
    pub accuracy: f64,
    /// Bound on the gradient the user claims.
    pub max_gradient: f64,
    /// `evaluate`: three parameters of the adaptive gradient.
    pub evaluate: Option<[f64; 3]>,
    /// Hits per ray; `None` for `all_intersections`.
    pub max_trace: Option<u32>,
    /// The container's own surface is left out.
    pub open: bool,
}

/// A `julia_fractal`.
#[derive(Clone, Debug, PartialEq)]
pub struct JuliaFractal {
    /// The constant added in every turn.
    pub parameter: DVec4,
    /// `hypercomplex` instead of `quaternion`.
    pub hypercomplex: bool,
    /// The function iterated.
    pub function: JuliaFunction,
    /// Iterations.
    pub max_iteration: u32,
    /// Accuracy parameter.
    pub precision: f64,
    /// Normal of the slicing hyperplane and its distance.
    pub slice: (DVec4, f64),
}

/// The functions a `julia_fractal` iterates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum JuliaFunction {
    Sqr,
    Cube,
    Exp,
    Reciprocal,
    Sin,
    Asin,
    Sinh,
    Asinh,
    Cos,
    Acos,
    Cosh,
    Acosh,
    Tan,
    Atan,
    Tanh,
    Atanh,
    Ln,
    Pwr(f64, f64),
}

/// How the points of a `lathe` or `prism` are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum ContourSpline {
    Linear,
    Quadratic,
    Cubic,
    Bezier,
}

/// A `lathe`, around the y axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Lathe {
    /// How points are joined.
    pub spline: ContourSpline,
    /// (radius, height).
    pub points: Vec<DVec2>,
}

/// A `prism`, along the y axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Prism {
    /// How points are joined.
    pub spline: ContourSpline,
    /// `conic_sweep` instead of `linear_sweep`.
    pub conic: bool,
    /// Lower and upper end.
    pub heights: [f64; 2],
    /// Contours (x, z), each closed by repeating its first point.
    pub points: Vec<DVec2>,
    /// Without end faces.
    pub open: bool,
}

/// How near two points of an outline are to count as one, where it has to close: 1e-10 in an outline of
/// size 1. POV-Ray's measure is that in any.
pub fn closing_distance(points: &[DVec2]) -> f64 {
    1e-10 * points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()))
}

/// A `sor`, around the y axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Sor {
    /// (radius, height), heights increasing.
    pub points: Vec<DVec2>,
    /// Without end discs.
    pub open: bool,
}

/// How a `sphere_sweep` joins its spheres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum SweepSpline {
    Linear,
    Cubic,
    BSpline,
}

/// A `sphere_sweep`.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereSweep {
    /// How spheres are joined.
    pub spline: SweepSpline,
    /// Centres and radii.
    pub spheres: Vec<(DVec3, f64)>,
    /// The user's tolerance.
    pub tolerance: f64,
}

/// A `text` object.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Where the glyphs come from.
    pub font: Font,
    /// What is written, as 16-bit units.
    pub text: Vec<u16>,
    /// Depth along z.
    pub thickness: f64,
    /// Added to every advance.
    pub offset: DVec3,
    /// Written in a Unicode `charset`, which decides what table of the font is asked first.
    pub unicode: bool,
}

/// A font of a [`Text`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Font {
    /// `ttf "file"`: the name as written and where it was found.
    File(String, std::path::PathBuf),
    /// `internal n`, and where POV-Ray's file of that font was found.
    Internal(u32, Option<std::path::PathBuf>),
}

/// A `mesh` or `mesh2`, all triangles in one set of shared lists.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Corners.
    pub vertices: Vec<DVec3>,
    /// Normals as written.
    pub normals: Vec<DVec3>,
    /// Texture coordinates.
    pub uvs: Vec<DVec2>,
    /// Textures the faces refer to.
    pub textures: Vec<Texture>,
    /// Triangles.
    pub faces: Vec<Face>,
    /// Direction that decides what is inside; without it the mesh is a surface.
    pub inside_vector: Option<DVec3>,
}

/// One triangle of a [`Mesh`]: indices into its lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Corners.
    pub vertices: [u32; 3],
    /// Normals at the corners, for a smooth triangle.
    pub normals: Option<[u32; 3]>,
    /// Texture coordinates at the corners.
    pub uvs: Option<[u32; 3]>,
    /// Textures: one for the face, or one per corner, blended.
    pub textures: FaceTextures,
}

/// Textures of a [`Face`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceTextures {
    /// The mesh's own.
    Inherited,
    /// One for the whole face.
    One(u32),
    /// One per corner.
    Three([u32; 3]),
}

/// A `parametric` surface.
#[derive(Clone, Debug)]
pub struct Parametric {
    /// x, y and z as functions of u and v.
    pub functions: [Arc<Function>; 3],
    /// Lower corner of the (u, v) rectangle.
    pub from: DVec2,
    /// Upper corner.
    pub to: DVec2,
    /// Where it is looked for.
    pub container: Container,
    /// Accuracy of the root.
    pub accuracy: f64,
    /// Bound on the gradients.
    pub max_gradient: f64,
    /// Depth of the precomputed tree and the functions it covers.
    pub precompute: Option<(u32, [bool; 3])>,
}

/// A constructive solid.
#[derive(Clone, Debug)]
pub struct Csg {
    /// How the children combine.
    pub operation: CsgOperation,
    /// In order; a `difference` takes the others from the first.
    pub children: Nested<Vec<Arc<Object>>>,
    /// `split_union`: a union at the top level is dissolved into its members.
    pub split_union: bool,
    /// How many shapes there are in it over all levels.
    pub parts: u64,
}

/// How a [`Csg`] combines its children.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum CsgOperation {
    Union,
    Merge,
    Intersection,
    Difference,
}

/// A `light_group`.
#[derive(Clone, Debug, Default)]
pub struct LightGroup {
    /// Objects and lights that see each other.
    pub objects: Nested<Vec<Arc<Object>>>,
    /// Whether global lights reach the objects too.
    pub global_lights: bool,
}
