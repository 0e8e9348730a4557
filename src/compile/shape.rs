//! Shapes of the description to primitives.

pub mod height_field;
pub mod isosurface;
mod outline;
pub mod parametric;
pub(super) mod settled;
pub mod text;

use std::sync::Arc;

use crate::math::{DMat3, DVec2, DVec3, Transform};
use crate::scene::shape as scene;
use crate::world::shape::bicubic_patch::BicubicPatch;
use crate::world::shape::blob::{self, Blob};
use crate::world::shape::r#box::Cuboid;
use crate::world::shape::cone::Cone;
use crate::world::shape::cylinder::Cylinder;
use crate::world::shape::disc::Disc;
use crate::world::shape::empty::Empty;
use crate::world::shape::julia_fractal::hypercomplex::Function;
use crate::world::shape::julia_fractal::{JuliaFractal, Map, Orbit};
use crate::world::shape::mesh::{self, Mesh};
use crate::world::shape::ovus::Ovus;
use crate::world::shape::plane::Plane;
use crate::world::shape::poly::Poly;
use crate::world::shape::polygon::Polygon;
use crate::world::shape::quadric::Quadric;
use crate::world::shape::sor::Sor;
use crate::world::shape::sphere::Sphere;
use crate::world::shape::superellipsoid::Superellipsoid;
use crate::world::shape::torus::Torus;
use crate::world::shape::triangle::Triangle;
use crate::world::shape::{OWN_TEXTURE, Primitive, Shape};

/// A primitive and where it is in the shape's space.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The primitive in its own space.
    pub primitive: Primitive,
    /// From there to the space the shape was written in; `None` is the identity.
    pub transform: Option<Transform>,
}

impl Compiled {
    fn placed(primitive: Primitive, transform: Transform) -> Self {
        Self { primitive, transform: Some(transform) }
    }

    /// A shape of a rare kind, or nothing where its parameters make none.
    fn rare<S: Shape + 'static>(shape: Option<S>) -> Self {
        shape.map_or_else(Self::nothing, |shape| Primitive::Other(Arc::new(shape)).into())
    }

    fn nothing() -> Self {
        Primitive::Other(Arc::new(Empty)).into()
    }
}

impl From<Primitive> for Compiled {
    fn from(primitive: Primitive) -> Self {
        Self { primitive, transform: None }
    }
}

/// A patch that is seen so many times larger; POV-Ray's flatness is a length in the scene.
pub(super) fn bicubic_patch(patch: &scene::BicubicPatch, enlarged: f64) -> Compiled {
    let flatness = patch.flatness / enlarged;
    Compiled::rare(BicubicPatch::new(&patch.points, flatness, patch.steps, patch.uv))
}

/// Compiles a geometry; the error is the keyword of one that povista can't render yet.
///
/// What POV-Ray accepts and never hits (docs/spec/primitives.md 1.9) becomes an empty shape. Compound
/// objects and lights are no primitives: they come back as errors too, and height fields, isosurfaces,
/// parametric surfaces and texts, whose images, functions and fonts may be broken, have functions of their
/// own: [`height_field::height_field`], [`isosurface::isosurface`], [`parametric::parametric`], [`text::text`].
pub fn shape(shape: &scene::Shape) -> Result<Compiled, &'static str> {
    use scene::Shape as S;
    Ok(match shape {
        S::Sphere { radius: 0.0, .. } => Compiled::nothing(),
        &S::Sphere { center, radius } => Primitive::Sphere(Sphere { center, radius }).into(),
        &S::Box { min, max } => Primitive::Box(Cuboid { min: min.min(max), max: min.max(max) }).into(),
        S::Cylinder(cone) | S::Cone(cone) => conical(cone),
        &S::Torus { major, minor } if major != 0.0 && minor > 0.0 => {
            Primitive::Torus(Torus { major: major.abs(), minor }).into()
        }
        S::Torus { .. } => Compiled::nothing(),
        &S::Plane { normal, distance } => Primitive::Plane(Plane { normal, distance }).into(),
        S::Disc(disc) => flat(disc),
        S::Triangle(triangle) => Triangle::new(triangle.corners, triangle.normals)
            .map_or_else(Compiled::nothing, |triangle| Primitive::Triangle(Box::new(triangle)).into()),
        S::Polygon(points) => Compiled::rare(Polygon::new(points)),
        S::Quadric(q) => {
            let quadric = Quadric::new(q.squares, q.products, q.linear, q.constant);
            Primitive::Quadric(Arc::new(quadric)).into()
        }
        S::Mesh(mesh) => triangles(mesh),
        S::Poly(poly) => Compiled::rare(Poly::new(poly.order, &poly.coefficients)),
        S::BicubicPatch(patch) => bicubic_patch(patch, 1.0),
        S::Blob(blob) => Compiled::rare(Some(field(blob))),
        S::HeightField(_) => return Err("height_field"),
        S::Isosurface(_) => return Err("isosurface"),
        S::JuliaFractal(julia) => Compiled::rare(fractal(julia)),
        S::Lathe(lathe) => Compiled::rare(outline::lathe(lathe)),
        S::Prism(prism) => Compiled::rare(outline::prism(prism)),
        S::Sor(sor) => Compiled::rare(Sor::new(&sor.points, sor.open)),
        S::SphereSweep(sweep) => Compiled::rare(outline::sphere_sweep(sweep)),
        &S::Superellipsoid { east, north } => Compiled::rare(Superellipsoid::new(east, north)),
        &S::Ovus { bottom, top } if top >= 2.0 * bottom && top > 0.0 => {
            Primitive::Sphere(Sphere { center: DVec3::Y * bottom, radius: top }).into()
        }
        &S::Ovus { bottom, top } => Compiled::rare(Ovus::new(bottom, top)),
        S::Text(_) => return Err("text"),
        S::Parametric(_) => return Err("parametric"),
        S::Csg(_) => return Err("csg"),
        S::Light(_) => return Err("light_source"),
        S::LightGroup(_) => return Err("light_group"),
    })
}

/// Turns +z to the unit vector `axis`, about the horizontal line across it as POV-Ray does.
fn turn_z_to(axis: DVec3) -> Transform {
    let sine = axis.x.hypot(axis.y);
    let about = if sine == 0.0 { DVec3::X } else { DVec3::new(-axis.y, axis.x, 0.0) / sine };
    // Rodrigues' formula, whose sine and cosine are known.
    let cross = DMat3::from_cols(
        DVec3::new(0.0, about.z, -about.y),
        DVec3::new(-about.z, 0.0, about.x),
        DVec3::new(about.y, -about.x, 0.0),
    );
    let outer = DMat3::from_cols(about * about.x, about * about.y, about * about.z);
    Transform::orthogonal(DMat3::IDENTITY * axis.z + cross * sine + outer * (1.0 - axis.z))
}

/// A cylinder or cone: the wider end is at z = 1 of the primitive, the first one where they are equal.
fn conical(cone: &scene::Cone) -> Compiled {
    let ends = [(cone.cap, cone.cap_radius), (cone.base, cone.base_radius)];
    let [(low, tip), (high, radius)] =
        if ends[0].1.abs() > ends[1].1.abs() { [ends[1], ends[0]] } else { ends };
    let axis = high - low;
    let length = axis.length();
    if radius == 0.0 || length == 0.0 {
        return Compiled::nothing();
    }
    let open = cone.open;
    let primitive = if tip == radius {
        Primitive::Cylinder(Cylinder { open })
    } else {
        Primitive::Cone(Cone { tip: tip / radius, open })
    };
    let size = Transform::scale(DVec3::new(radius.abs(), radius.abs(), length));
    Compiled::placed(primitive, size.then(&turn_z_to(axis / length)).then(&Transform::translate(low)))
}

fn flat(disc: &scene::Disc) -> Compiled {
    let Some(normal) = disc.normal.try_normalize() else {
        return Compiled::nothing();
    };
    let primitive = Primitive::Disc(Disc { radius: disc.radius, hole: disc.hole });
    Compiled::placed(primitive, turn_z_to(normal).then(&Transform::translate(disc.center)))
}

/// A blob; the textures of its components are numbered in their order.
fn field(blob: &scene::Blob) -> Blob {
    let mut parts = Vec::new();
    let mut textures = 0..;
    for component in blob.components.iter() {
        let texture = component.texture.as_ref().and_then(|_| textures.next()).unwrap_or(OWN_TEXTURE);
        let place = |radius: f64, turn: Transform, at: DVec3| {
            let own = Transform::scale(DVec3::splat(radius)).then(&turn).then(&Transform::translate(at));
            component.transform.as_ref().map_or(own, |further| own.then(further))
        };
        match component.kind {
            scene::BlobKind::Sphere { center, radius } if radius != 0.0 => {
                let place = place(radius.abs(), Transform::IDENTITY, center);
                parts.push(blob::Part::ball(&place, component.strength, texture));
            }
            scene::BlobKind::Cylinder { base, cap, radius } if radius != 0.0 && base != cap => {
                let (axis, radius) = (cap - base, radius.abs());
                let length = axis.length();
                let place = place(radius, turn_z_to(axis / length), base);
                let strength = component.strength;
                parts.extend(blob::Part::capsule(&place, length / radius, strength, texture));
            }
            _ => {}
        }
    }
    Blob::new(parts, blob.threshold)
}

fn fractal(julia: &scene::JuliaFractal) -> Option<JuliaFractal> {
    use scene::JuliaFunction as F;
    let map = match (julia.hypercomplex, julia.function) {
        // Of quaternions there are no others.
        (false, function) => {
            if function == F::Cube {
                Map::Cube
            } else {
                Map::Square
            }
        }
        (true, F::Sqr) => Map::HypercomplexSquare { cube: false },
        (true, F::Cube) => Map::HypercomplexSquare { cube: true },
        (true, F::Exp) => Map::Hypercomplex(Function::Exp),
        (true, F::Reciprocal) => Map::Hypercomplex(Function::Reciprocal),
        (true, F::Sin) => Map::Hypercomplex(Function::Sin),
        (true, F::Asin) => Map::Hypercomplex(Function::Asin),
        (true, F::Sinh) => Map::Hypercomplex(Function::Sinh),
        (true, F::Asinh) => Map::Hypercomplex(Function::Asinh),
        (true, F::Cos) => Map::Hypercomplex(Function::Cos),
        (true, F::Acos) => Map::Hypercomplex(Function::Acos),
        (true, F::Cosh) => Map::Hypercomplex(Function::Cosh),
        (true, F::Acosh) => Map::Hypercomplex(Function::Acosh),
        (true, F::Tan) => Map::Hypercomplex(Function::Tan),
        (true, F::Atan) => Map::Hypercomplex(Function::Atan),
        (true, F::Tanh) => Map::Hypercomplex(Function::Tanh),
        (true, F::Atanh) => Map::Hypercomplex(Function::Atanh),
        (true, F::Ln) => Map::Hypercomplex(Function::Ln),
        (true, F::Pwr(re, im)) => Map::Hypercomplex(Function::Power(DVec2::new(re, im))),
    };
    let (normal, distance) = julia.slice;
    let normal = normal.try_normalize().filter(|normal| normal.w != 0.0)?;
    let orbit = Orbit {
        constant: julia.parameter,
        map,
        iterations: julia.max_iteration.max(1),
        slice: (-normal.truncate()).extend(distance) / normal.w,
    };
    Some(JuliaFractal::new(orbit, 1.0 / julia.precision.max(1.0)))
}

fn triangles(mesh: &Arc<scene::Mesh>) -> Compiled {
    let lists =
        mesh::Lists { vertices: mesh.vertices.clone(), normals: mesh.normals.clone(), uvs: mesh.uvs.clone() };
    Mesh::new(lists, &mesh.faces, mesh.inside_vector)
        .map_or_else(Compiled::nothing, |mesh| Primitive::Mesh(Arc::new(mesh)).into())
}

impl From<scene::Face> for mesh::Face {
    fn from(face: scene::Face) -> Self {
        let textures = match face.textures {
            scene::FaceTextures::Inherited => None,
            scene::FaceTextures::One(texture) => Some([texture; 3]),
            scene::FaceTextures::Three(textures) => Some(textures),
        };
        Self { vertices: face.vertices, normals: face.normals, uvs: face.uvs, textures }
    }
}

#[cfg(test)]
mod tests;
