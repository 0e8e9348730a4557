//! What a name can stand for.

mod array;

use super::code::Macro;
use super::file::FileHandle;
use super::tuple::Tuple;
use crate::math::{DVec2, Rgbft, Transform};
use crate::scene::{
    Camera, Density, Finish, Fog, Function, Interior, Media, Normal, Object, Pigment, Rainbow, SkySphere,
    Spline, Texture,
};
use crate::scene::{interior::Material, pigment::BlendMap};
pub use array::Array;
use std::rc::Rc;
use std::sync::Arc;

/// The value of a name. Cloning is cheap: what is big is shared, and copied when it is changed.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the variants not explained are named after the statement that makes them")]
pub enum Value {
    /// The statement that should have given the value had an error: using it is no second one.
    Poisoned,
    Float(f64),
    /// Two components, as `u` has.
    Vector2([f64; 2]),
    Vector3([f64; 3]),
    Vector4(Rc<[f64; 4]>),
    /// Red, green, blue, filter, transmit. Variables hold them in single precision.
    Color([f32; 5]),
    /// Every character is one code unit: none lies beyond U+FFFF.
    Text(Rc<str>),
    Array(Rc<Array>),
    Macro(Rc<Macro>),
    File(Rc<FileHandle>),
    Spline(Arc<Spline>),
    Function(Arc<Function>),
    Object(Arc<Object>),
    Texture(Texture),
    Pigment(Arc<Pigment>),
    Normal(Arc<Normal>),
    Finish(Arc<Finish>),
    Interior(Arc<Interior>),
    Media(Arc<Media>),
    Density(Arc<Density>),
    Material(Arc<Material>),
    Transform(Arc<Transform>),
    Camera(Arc<Camera>),
    Fog(Arc<Fog>),
    Rainbow(Arc<Rainbow>),
    SkySphere(Arc<SkySphere>),
    ColorMap(Arc<BlendMap<Rgbft>>),
    PigmentMap(Arc<BlendMap<Arc<Pigment>>>),
    NormalMap(Arc<BlendMap<Arc<Normal>>>),
    TextureMap(Arc<BlendMap<Texture>>),
    DensityMap(Arc<BlendMap<Arc<Density>>>),
    /// Heights and slopes.
    SlopeMap(Arc<BlendMap<DVec2>>),
}

impl Value {
    /// The value as numbers, if it is one to five of them.
    #[inline]
    pub fn tuple(&self) -> Option<Tuple> {
        Some(match self {
            Value::Float(f) => Tuple::float(*f),
            Value::Vector2(v) => Tuple::new(v),
            Value::Vector3(v) => Tuple::new(v),
            Value::Vector4(v) => Tuple::new(&v[..]),
            Value::Color(c) => Tuple::new(&c.map(f64::from)),
            _ => return None,
        })
    }

    /// What it is called in messages, with its article.
    pub fn kind(&self) -> &'static str {
        match self {
            Value::Poisoned => "a value with an error",
            Value::Float(_) => "a float",
            Value::Vector2(_) => "a 2-component vector",
            Value::Vector3(_) => "a vector",
            Value::Vector4(_) => "a 4-component vector",
            Value::Color(_) => "a color",
            Value::Text(_) => "a string",
            Value::Array(_) => "an array",
            Value::Macro(_) => "a macro",
            Value::File(_) => "a file handle",
            Value::Spline(_) => "a spline",
            Value::Function(_) => "a function",
            Value::Object(_) => "an object",
            Value::Texture(_) => "a texture",
            Value::Pigment(_) => "a pigment",
            Value::Normal(_) => "a normal",
            Value::Finish(_) => "a finish",
            Value::Interior(_) => "an interior",
            Value::Media(_) => "a media",
            Value::Density(_) => "a density",
            Value::Material(_) => "a material",
            Value::Transform(_) => "a transform",
            Value::Camera(_) => "a camera",
            Value::Fog(_) => "a fog",
            Value::Rainbow(_) => "a rainbow",
            Value::SkySphere(_) => "a sky_sphere",
            Value::ColorMap(_) => "a color_map",
            Value::PigmentMap(_) => "a pigment_map",
            Value::NormalMap(_) => "a normal_map",
            Value::TextureMap(_) => "a texture_map",
            Value::DensityMap(_) => "a density_map",
            Value::SlopeMap(_) => "a slope_map",
        }
    }

    /// Whether two values may be elements of one array.
    pub fn same_kind(&self, other: &Value) -> bool {
        std::mem::discriminant(self) == std::mem::discriminant(other)
    }
}

impl From<Tuple> for Value {
    fn from(tuple: Tuple) -> Value {
        let c = tuple.c;
        match tuple.n {
            1 => Value::Float(c[0]),
            2 => Value::Vector2([c[0], c[1]]),
            3 => Value::Vector3([c[0], c[1], c[2]]),
            4 => Value::Vector4(Rc::new([c[0], c[1], c[2], c[3]])),
            _ => Value::Color(c.map(|c| c as f32)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_takes_32_bytes() {
        assert_eq!(size_of::<Value>(), 32);
    }

    #[test]
    fn five_components_are_kept_in_single_precision() {
        let Value::Color(c) = Value::from(Tuple::new(&[0.1; 5])) else {
            panic!("five components are a color")
        };
        assert_eq!(f64::from(c[0]), 0.10000000149011612);
    }
}
