//! What an array holds, docs/spec/language.md 3.6.

use super::Value;
use crate::interp::tuple::to_int;
use crate::scene::depth::Depth;

/// Values in one to five dimensions, all of one kind.
#[derive(Clone, Debug)]
pub struct Array {
    /// The size of each dimension.
    pub sizes: Vec<usize>,
    elements: Vec<Option<Value>>,
    /// An element that is set, which all others must resemble.
    sample: Option<usize>,
    /// How many arrays stand in each other, this one among them.
    depth: u32,
}

impl Array {
    /// An array of unset elements. The caller has checked that so many fit into memory.
    pub fn new(sizes: Vec<usize>) -> Array {
        let count = sizes.iter().product();
        Array { sizes, elements: vec![None; count], sample: None, depth: 1 }
    }

    /// How many elements there are over all dimensions.
    #[expect(clippy::len_without_is_empty, reason = "no array is empty")]
    pub fn len(&self) -> usize {
        self.elements.len()
    }

    /// An element by its place over all dimensions.
    pub fn get(&self, index: usize) -> Option<&Value> {
        self.elements.get(index)?.as_ref()
    }

    /// An element that is set: all others are of its kind.
    pub fn sample(&self) -> Option<&Value> {
        self.get(self.sample?)
    }

    /// Sets an element. The error says what kind the array holds.
    pub fn set(&mut self, index: usize, value: Value) -> Result<(), String> {
        if let Some(sample) = self.sample()
            && !sample.same_kind(&value)
            && !matches!(value, Value::Poisoned)
        {
            return Err(format!("this array holds elements like {}, not {}", sample.kind(), value.kind()));
        }
        if let Value::Array(inner) = &value {
            self.depth = self.depth.max(inner.depth + 1);
        }
        let poisoned = matches!(value, Value::Poisoned);
        if let Some(slot) = self.elements.get_mut(index) {
            *slot = Some(value);
            if !poisoned {
                self.sample.get_or_insert(index);
            }
        }
        Ok(())
    }

    /// Forgets an element; the kind the array holds stays that of the others.
    pub fn clear(&mut self, index: usize) {
        if let Some(slot) = self.elements.get_mut(index) {
            *slot = None;
        }
        if self.sample == Some(index) {
            self.sample = self.elements.iter().position(Option::is_some);
        }
    }

    /// The place of the element with these subscripts, one for each dimension. The error names
    /// what is out of range.
    pub fn index(&self, subscripts: &[f64]) -> Result<usize, String> {
        if let (&[subscript], &[size]) = (subscripts, &self.sizes[..])
            && subscript >= 0.0
            && subscript < size as f64 - 1.0
        {
            return Ok((subscript + 1e-10) as usize);
        }
        let mut index = 0;
        for (&subscript, &size) in subscripts.iter().zip(&self.sizes) {
            let at = to_int(subscript + 1e-10);
            if subscript < -1e-10 || at < 0 || at as usize >= size {
                let shown =
                    if subscript.fract() == 0.0 { format!("{subscript:.0}") } else { subscript.to_string() };
                return Err(format!("subscript {shown} is outside the array's 0 to {}", size - 1));
            }
            index = index * size + at as usize;
        }
        Ok(index)
    }
}

impl Depth for Array {
    fn depth(&self) -> u32 {
        self.depth
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subscripts_are_cut_with_a_little_tolerance() {
        let array = Array::new(vec![3]);
        let at = |s: f64| array.index(&[s]);
        assert_eq!([at(1.9), at(1.0 - 1e-11), at(-1e-11)], [Ok(1), Ok(1), Ok(0)]);
        assert!(at(3.0).is_err() && at(-1.0).is_err());
    }

    #[test]
    fn the_first_element_fixes_the_kind() {
        let mut array = Array::new(vec![2, 2]);
        assert!(array.set(3, Value::Float(1.0)).is_ok());
        assert!(array.set(0, Value::Vector3([0.0; 3])).is_err());
        assert!(array.get(0).is_none());
    }
}
