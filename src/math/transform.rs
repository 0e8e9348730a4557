//! Affine transforms, kept with their inverses so that neither is ever solved for at a hit.

use glam::{DAffine3, DMat3, DVec3};

use super::{Band, Lanes};

/// An affine map and its inverse.
///
/// POV-Ray writes points as rows, `p' = p M`; here they are columns, so a `matrix` statement's rows
/// become columns. Left-handed coordinates, angles in degrees (docs/spec/primitives.md 1.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Maps the inner space to the outer one.
    pub forward: DAffine3,
    /// Maps back.
    pub inverse: DAffine3,
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Transform {
    /// Changes nothing.
    pub const IDENTITY: Self = Self { forward: DAffine3::IDENTITY, inverse: DAffine3::IDENTITY };

    /// `translate <x,y,z>`.
    pub fn translate(by: DVec3) -> Self {
        Self { forward: DAffine3::from_translation(by), inverse: DAffine3::from_translation(-by) }
    }

    /// `scale <x,y,z>`; the caller has replaced zero components (POV-Ray takes 1 and warns).
    pub fn scale(by: DVec3) -> Self {
        Self { forward: DAffine3::from_scale(by), inverse: DAffine3::from_scale(by.recip()) }
    }

    /// `rotate <x,y,z>` in degrees: about x first, then y, then z.
    pub fn rotate(degrees: DVec3) -> Self {
        let mut matrix = DMat3::IDENTITY;
        for (angle, about) in [
            (degrees.x, DMat3::from_rotation_x as fn(f64) -> DMat3),
            (degrees.y, DMat3::from_rotation_y),
            (degrees.z, DMat3::from_rotation_z),
        ] {
            if angle != 0.0 {
                matrix = about(angle.to_radians()) * matrix;
            }
        }
        Self::orthogonal(matrix)
    }

    /// Rotation by `degrees` about the unit vector `axis`, in the sense of `vaxis_rotate`.
    pub fn rotate_about(axis: DVec3, degrees: f64) -> Self {
        Self::orthogonal(DMat3::from_axis_angle(axis, degrees.to_radians()))
    }

    /// A rotation or reflection given by its matrix, whose columns are orthonormal.
    pub fn orthogonal(matrix: DMat3) -> Self {
        Self { forward: DAffine3::from_mat3(matrix), inverse: DAffine3::from_mat3(matrix.transpose()) }
    }

    /// The `matrix` statement: four rows of three, the last one the translation.
    /// `None` where the determinant is exactly zero or not finite.
    pub fn from_rows(rows: [f64; 12]) -> Option<Self> {
        Self::from_affine(DAffine3::from_cols_array(&rows))
    }

    /// Pairs a map with its numeric inverse; `None` where there is none.
    ///
    /// The inverse is the adjugate over the determinant, the translation as well: each element is
    /// rounded only once after its cofactor, which a factor 1/determinant would do twice.
    pub fn from_affine(forward: DAffine3) -> Option<Self> {
        let DMat3 { x_axis: a, y_axis: b, z_axis: c } = forward.matrix3;
        let rows = [b.cross(c), c.cross(a), a.cross(b)];
        let determinant = a.dot(rows[0]);
        let translation = -DVec3::from_array(rows.map(|row| row.dot(forward.translation))) / determinant;
        let [x, y, z] = rows.map(|row| row / determinant);
        let matrix3 = DMat3::from_cols(x, y, z).transpose();
        let inverse = DAffine3 { matrix3, translation };
        (determinant != 0.0 && determinant.is_finite()).then_some(Self { forward, inverse })
    }

    /// This map followed by `next`, as when `next` is written after it.
    pub fn then(&self, next: &Self) -> Self {
        Self { forward: next.forward * self.forward, inverse: self.inverse * next.inverse }
    }

    /// The map that undoes this one (`transform { … inverse }`).
    pub fn inverted(&self) -> Self {
        Self { forward: self.inverse, inverse: self.forward }
    }

    /// Whether this is exactly the identity.
    pub fn is_identity(&self) -> bool {
        self.forward == DAffine3::IDENTITY
    }

    /// A point of the inner space seen from the outer one.
    #[inline]
    pub fn point(&self, p: DVec3) -> DVec3 {
        self.forward.transform_point3(p)
    }

    /// A direction of the inner space seen from the outer one; its length changes with scale.
    #[inline]
    pub fn vector(&self, v: DVec3) -> DVec3 {
        self.forward.transform_vector3(v)
    }

    /// A surface normal seen from the outer space: by the inverse transpose, not normalised.
    #[inline]
    pub fn normal(&self, n: DVec3) -> DVec3 {
        self.inverse.matrix3.transpose() * n
    }

    /// A point of the outer space seen from the inner one.
    #[inline]
    pub fn inverse_point(&self, p: DVec3) -> DVec3 {
        self.inverse.transform_point3(p)
    }

    /// Points of the outer space seen from the inner one.
    #[inline(always)]
    pub fn inverse_along(&self, [x, y, z]: [Band; 3]) -> [Band; 3] {
        let DAffine3 { matrix3, translation } = self.inverse;
        let mut seen = [x; 3];
        for (i, seen) in seen.iter_mut().enumerate() {
            *seen = x * matrix3.x_axis[i] + y * matrix3.y_axis[i] + z * matrix3.z_axis[i] + translation[i];
        }
        seen
    }

    /// Four points of the outer space seen from the inner one.
    #[inline(always)]
    pub fn inverse_points(&self, points: &[Lanes; 3]) -> [Lanes; 3] {
        let mut seen = self.inverse_vectors(points);
        for (axis, seen) in seen.iter_mut().enumerate() {
            *seen = *seen + self.inverse.translation[axis];
        }
        seen
    }

    /// Four directions of the outer space seen from the inner one.
    #[inline(always)]
    pub fn inverse_vectors(&self, [x, y, z]: &[Lanes; 3]) -> [Lanes; 3] {
        let DAffine3 { matrix3, .. } = self.inverse;
        let mut seen = [*x; 3];
        for (axis, seen) in seen.iter_mut().enumerate() {
            *seen = *x * matrix3.x_axis[axis] + *y * matrix3.y_axis[axis] + *z * matrix3.z_axis[axis];
        }
        seen
    }

    /// A direction of the outer space seen from the inner one.
    #[inline]
    pub fn inverse_vector(&self, v: DVec3) -> DVec3 {
        self.inverse.transform_vector3(v)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: DVec3, b: DVec3) {
        assert!(a.abs_diff_eq(b, 1e-14), "{a} is not {b}");
    }

    #[test]
    fn quarter_turns_carry_the_axes_as_povray_turns_them() {
        close(Transform::rotate(DVec3::Z * 90.0).point(DVec3::X), DVec3::Y);
        close(Transform::rotate(DVec3::X * 90.0).point(DVec3::Y), DVec3::Z);
        close(Transform::rotate(DVec3::Y * 90.0).point(DVec3::Z), DVec3::X);
        close(Transform::rotate(DVec3::new(90.0, 90.0, 0.0)).point(DVec3::Y), DVec3::X);
    }

    #[test]
    fn transforms_act_in_the_order_they_are_written() {
        let moved = Transform::translate(DVec3::X).then(&Transform::scale(DVec3::splat(2.0)));
        close(moved.point(DVec3::ZERO), DVec3::new(2.0, 0.0, 0.0));
        close(moved.inverse_point(DVec3::new(2.0, 0.0, 0.0)), DVec3::ZERO);
    }

    #[test]
    fn matrix_rows_are_images_of_the_axes() {
        let shear = Transform::from_rows([1., 0., 0., 0.5, 1., 0., 0., 0., 1., 3., 0., 0.]).unwrap();
        close(shear.point(DVec3::Y), DVec3::new(3.5, 1.0, 0.0));
        assert!(Transform::from_rows([1., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0.]).is_none());
    }

    #[test]
    fn normals_stay_perpendicular_under_uneven_scale() {
        let stretch =
            Transform::scale(DVec3::new(3.0, 1.0, 0.5)).then(&Transform::rotate(DVec3::new(20., 30., 40.)));
        let (tangent, normal) = (DVec3::new(1.0, -1.0, 2.0), DVec3::new(1.0, 1.0, 0.0));
        assert!(stretch.vector(tangent).dot(stretch.normal(normal)).abs() < 1e-14);
    }
}
