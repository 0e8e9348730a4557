//! What expressions ask of things that have to be compiled: objects and functions. This is the
//! only file of `interp` that reaches the later stages.

use std::rc::Rc;
use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::arguments;
use crate::compile::image;
pub use crate::compile::probe::Known;
use crate::compile::probe::{Probe, inside_of};
use crate::compile::texture::TextureCompiler;
use crate::compile::{Reason, Unsupported};
use crate::interp::stream::TokenKind;
use crate::interp::tuple::Tuple;
use crate::interp::value::Value;
use crate::interp::{Fault, Result, Vm, Word};
use crate::math::noise::Octaves;
use crate::math::{DVec3, Spline};
use crate::scene::pigment::PigmentKind;
use crate::scene::settings::Settings;
use crate::scene::spline::SplineKind;
use crate::scene::{self, Function, Object};
use crate::source::Span;
use crate::syntax::{Punct, Symbol};
use crate::world;
use crate::world::function::Budget;

/// What has been compiled, by the address of the shared value, which is kept so that it stays its own.
#[derive(Default)]
pub struct Compiled {
    functions: FxHashMap<*const Function, (Arc<Function>, Arc<world::Function>)>,
    objects: FxHashMap<*const Object, (Arc<Object>, Rc<Probe>)>,
    splines: FxHashMap<(*const scene::Spline, SplineKind), Ready>,
    /// What whoever compiles the scene need not make again.
    pub known: Known,
}

/// A spline, and what is ready to be evaluated.
type Ready = (Arc<scene::Spline>, Rc<Spline>);

/// Terms and calls of a function that are done in the time of a step.
const TERMS_A_STEP: u64 = 16;
/// Points of a spline that are made ready in the time of a step.
const POINTS_A_STEP: u64 = 16;

/// Reads the arguments of a function or spline whose name was just taken, and computes it.
pub fn call(vm: &mut Vm, called: &Value, name: Symbol, span: Span) -> Result<Tuple> {
    match called {
        Value::Spline(spline) => arguments(vm, |vm| {
            let at = vm.read_float()?;
            let kind = if vm.accept_punct(Punct::Comma)? { vm.read_spline_kind()? } else { spline.kind };
            let value = ready_spline(vm, spline, kind, span)?.map_or([0.0; 5], |ready| ready.at(at));
            Ok(Tuple::new(&value[..spline.size]))
        }),
        Value::Function(function) => {
            let compiled = compiled_function(vm, function, span)?;
            let numbers = arguments(vm, |vm| {
                let mut numbers = Vec::with_capacity(compiled.parameters);
                for i in 0..compiled.parameters {
                    if i > 0 {
                        vm.comma()?;
                    }
                    numbers.push(vm.read_float()?);
                }
                Ok(numbers)
            });
            let numbers = numbers.map_err(|fault| {
                fault.help(match compiled.parameters {
                    1 => format!("`{}` takes one number", vm.name(name)),
                    count => format!("`{}` takes {count} numbers", vm.name(name)),
                })
            })?;
            let mut value = [0.0; 5];
            let budget = Budget::default();
            let size = compiled.call_within(&numbers, &mut value, &budget);
            check_end(vm, &budget, name, span)?;
            vm.work(budget.spent() / TERMS_A_STEP, span)?;
            Ok(Tuple::new(&value[..size]))
        }
        _ => Err(vm.expected("a number or vector")),
    }
}

/// A spline ready to be evaluated as one of this kind; `None` without points.
fn ready_spline(
    vm: &mut Vm,
    spline: &Arc<scene::Spline>,
    kind: SplineKind,
    span: Span,
) -> Result<Option<Rc<Spline>>> {
    let key = (Arc::as_ptr(spline), kind);
    if let Some((_, ready)) = vm.compiled.splines.get(&key) {
        return Ok(Some(ready.clone()));
    }
    vm.work(spline.points.len() as u64 / POINTS_A_STEP, span)?;
    let ready = Spline::new(kind, &spline.points, spline.size).map(Rc::new);
    if let Some(ready) = &ready {
        vm.compiled.splines.insert(key, (spline.clone(), ready.clone()));
    }
    Ok(ready)
}

/// Makes sure that a function came to its end by itself.
fn check_end(vm: &Vm, budget: &Budget, name: Symbol, span: Span) -> Result<()> {
    let name = vm.name(name);
    let span = span.to(vm.last);
    if budget.is_too_deep() {
        let fault = vm.error(span, format!("`{name}` calls itself more than {} levels deep", Budget::DEPTH));
        return Err(fault.help("a `select` has to choose something else in the end"));
    }
    if budget.is_spent() {
        let message = format!("`{name}` is not done after {} terms and calls", Budget::STEPS);
        return Err(vm.error(span, message).help("does every `sum` and `prod` reach its end?"));
    }
    Ok(())
}

/// `inside(OBJECT, point)`, its name just taken.
pub fn inside(vm: &mut Vm, span: Span) -> Result<f64> {
    arguments(vm, |vm| {
        let object = read_object(vm, span)?;
        vm.comma()?;
        Ok(f64::from(u8::from(object.inside(vm.read_vector()?))))
    })
}

/// `trace(OBJECT, origin, direction [, normal])`, its name just taken.
pub fn trace(vm: &mut Vm, span: Span) -> Result<DVec3> {
    arguments(vm, |vm| {
        let object = read_object(vm, span)?;
        vm.comma()?;
        let origin = vm.read_vector()?;
        vm.comma()?;
        let direction = vm.read_vector()?;
        let (point, normal) = object.trace(origin, direction).unwrap_or_default();
        if vm.accept_punct(Punct::Comma)? {
            let token = vm.peek()?;
            let place = vm.place.clone();
            match place {
                Some(place) if matches!(place.get(), Some(Value::Vector3(_))) => {
                    vm.take(token);
                    let set = place.set(Value::Vector3(normal.to_array()));
                    set.map_err(|message| vm.error(token.span, message))?;
                }
                _ => {
                    let fault = vm.expected("a variable that holds a vector");
                    return Err(fault.help("`trace` stores the normal there: declare the variable first, as in `#declare Normal = <0,0,0>;`"));
                }
            }
        }
        Ok(point)
    })
}

/// `min_extent` or `max_extent`, its name just taken.
pub fn extent(vm: &mut Vm, word: Word, span: Span) -> Result<DVec3> {
    arguments(vm, |vm| {
        if word == Word::MaxExtent
            && let Some(size) = image_size(vm, span)?
        {
            return Ok(size);
        }
        let bounds = read_object(vm, span)?.bounds();
        Ok(if word == Word::MinExtent { bounds.min } else { bounds.max })
    })
}

/// The pixels across and down of the image in a pigment whose name comes next; `None` of anything else.
fn image_size(vm: &mut Vm, span: Span) -> Result<Option<DVec3>> {
    let token = vm.peek()?;
    let named = matches!(token.kind, TokenKind::Name(_));
    let value = vm.place.as_ref().filter(|_| named).and_then(|place| place.get());
    let Some(Value::Pigment(pigment)) = value else { return Ok(None) };
    let PigmentKind::Image { map, .. } = &pigment.kind else {
        let fault = vm.error(token.span, "this pigment has no size");
        return Err(fault.help("`max_extent` tells the size of objects, and of pigments with an `image_map`"));
    };
    let source = map.source.clone();
    vm.take(token);
    let size = image::size(&source).map_err(|lacking| refused(vm, &lacking, span))?;
    Ok(Some(DVec3::new(f64::from(size[0]), f64::from(size[1]), 0.0)))
}

/// `vturbulence(lambda, omega, octaves, point)`, its name just taken.
pub fn turbulence(vm: &mut Vm, _span: Span) -> Result<DVec3> {
    arguments(vm, |vm| {
        let mut numbers = [0.0; 3];
        for number in &mut numbers {
            *number = vm.read_float()?;
            vm.comma()?;
        }
        let [lambda, omega, octaves] = numbers;
        let count = octaves.clamp(1.0, 10.0) as u32;
        Ok(Octaves { count, omega, lambda }.vector(vm.read_vector()?))
    })
}

/// The compiled form of a function.
fn compiled_function(vm: &mut Vm, function: &Arc<Function>, span: Span) -> Result<Arc<world::Function>> {
    if let Some((_, compiled)) = vm.compiled.functions.get(&Arc::as_ptr(function)) {
        return Ok(compiled.clone());
    }
    let settings = settings(vm);
    let compiled = TextureCompiler::new(&settings)
        .with_last_digits()
        .with_objects(&|object| inside_of(object, &settings))
        .function(function);
    let compiled = compiled.map_err(|lacking| refused(vm, &lacking, span))?;
    vm.compiled.functions.insert(Arc::as_ptr(function), (function.clone(), compiled.clone()));
    Ok(compiled)
}

/// Reads the name of an object, and compiles it.
fn read_object(vm: &mut Vm, span: Span) -> Result<Rc<Probe>> {
    let token = vm.peek()?;
    let named = matches!(token.kind, TokenKind::Name(_));
    let value = vm.place.as_ref().filter(|_| named).and_then(|place| place.get());
    let Some(Value::Object(object)) = value else {
        let fault = vm.expected("the name of an object");
        return Err(fault.help("declare the object first: objects can't be written here"));
    };
    vm.take(token);
    if let Some((_, probe)) = vm.compiled.objects.get(&Arc::as_ptr(&object)) {
        return Ok(probe.clone());
    }
    let settings = settings(vm);
    let probe = Probe::knowing(&object, &settings, &mut vm.compiled.known)
        .map_err(|lacking| refused(vm, &first(lacking, object.span), span))?;
    let probe = Rc::new(probe);
    vm.compiled.objects.insert(Arc::as_ptr(&object), (object, probe.clone()));
    Ok(probe)
}

/// The settings so far. While a scene is read there are always ten sources of waves
/// (docs/spec/patterns-textures.md 0.1).
fn settings(vm: &Vm) -> Settings {
    Settings { number_of_waves: 10, ..vm.state.settings_in(vm.version, vm.version_written) }
}

fn first(lacking: Vec<Unsupported>, span: Span) -> Unsupported {
    lacking.into_iter().next().unwrap_or_else(|| Unsupported::new(span, "this object"))
}

/// The error for something that can't be compiled, at the place that asked for it.
fn refused(vm: &Vm, lacking: &Unsupported, span: Span) -> Fault {
    let fault = vm.error(span, lacking.to_string());
    let place = match lacking.reason {
        Reason::NotYet => "needed here",
        Reason::Broken => "asked for here",
    };
    fault.see(lacking.span, place)
}
