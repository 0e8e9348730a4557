//! Compiles user functions: expression trees become tapes (docs/spec/language.md 4).

use std::sync::Arc;

use super::Unsupported;
use super::tape::Writer;
use super::texture::{DEEPEST, TextureCompiler};
use crate::math::Spline;
use crate::scene;
use crate::scene::function::FunctionBody;
use crate::world::function::{Body, Function, Internal};

/// A spline ready to be evaluated.
pub fn spline(spline: &scene::Spline) -> Option<Spline> {
    Spline::new(spline.kind, &spline.points, spline.size)
}

impl TextureCompiler<'_> {
    /// A function with the settings of the scene.
    ///
    /// # Errors
    /// What it uses that povista lacks, or a file that can't be read.
    pub fn function(&mut self, function: &Arc<scene::Function>) -> Result<Arc<Function>, Unsupported> {
        if let Some((_, compiled)) = self.functions.get(&Arc::as_ptr(function)) {
            return Ok(compiled.clone());
        }
        let (body, depth) = self.nested(function.span, |this| this.function_body(function))?;
        if depth > DEEPEST {
            return Err(Unsupported::new(
                function.span,
                format!("more than {DEEPEST} functions inside each other"),
            ));
        }
        let compiled = Arc::new(Function::new(function.parameters, depth, body));
        self.functions.insert(Arc::as_ptr(function), (function.clone(), compiled.clone()));
        Ok(compiled)
    }

    /// The body, and how many functions deep it calls.
    fn function_body(&mut self, function: &scene::Function) -> Result<(Body, u32), Unsupported> {
        let body = match &*function.body {
            FunctionBody::Expression(expression) => {
                let (tape, depth) = Writer::new(self, function).tape(expression)?;
                return Ok((Body::Tape(tape), depth));
            }
            FunctionBody::Internal(number) => {
                let internal = Internal::new(*number, self.settings.noise_generator);
                let message = format!("there is no `internal({number})`");
                Body::Internal(internal.ok_or_else(|| Unsupported::broken(function.span, message))?)
            }
            FunctionBody::Pattern(field) => Body::Pattern(Arc::new(self.pattern(field)?)),
            FunctionBody::Pigment(pigment) => Body::Pigment(self.pigment(pigment)?),
            FunctionBody::Transform(transform) => Body::Transform(Box::new(**transform)),
            FunctionBody::Spline(spline) => {
                let spline = self::spline(spline);
                let message = "a spline without points";
                Body::Spline(Box::new(spline.ok_or_else(|| Unsupported::broken(function.span, message))?))
            }
        };
        Ok((body, 1))
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;
    use crate::math::{Band, DVec3, Lanes, Transform};
    use crate::scene::depth::Nested;
    use crate::scene::function::{BinaryOp, Builtin, Expr};
    use crate::scene::settings::Settings;
    use crate::source::Span;
    use crate::world::function::Budget;
    use crate::world::shape::Shape;
    use crate::world::shape::r#box::Cuboid;
    use crate::world::shape::isosurface::{Container, Isosurface, Steepest};
    use crate::world::{Range, Ray};

    fn of(parameters: usize, body: FunctionBody) -> Arc<scene::Function> {
        Arc::new(scene::Function {
            span: Span::default(),
            name: "f".into(),
            parameters,
            body: Nested::new(body),
        })
    }

    fn expression(parameters: usize, expression: Expr) -> Arc<scene::Function> {
        of(parameters, FunctionBody::Expression(expression))
    }

    fn compile(function: &Arc<scene::Function>) -> Result<Arc<Function>, Unsupported> {
        TextureCompiler::new(&Settings::default()).function(function)
    }

    fn call(function: &Arc<scene::Function>, arguments: &[f64]) -> f64 {
        compile(function).unwrap().call(arguments)
    }

    fn number(value: f64) -> Expr {
        Expr::Constant(value)
    }

    fn parameter(index: u16) -> Expr {
        Expr::Parameter(index)
    }

    fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
        Expr::Binary(op, Box::new(a), Box::new(b))
    }

    #[test]
    fn sums_and_products_nest_and_may_be_empty() {
        let sum = |from, to, e| Expr::Sum(Box::new([from, to, e]));
        let nested = sum(number(1.0), number(3.0), sum(number(1.0), Expr::Running(0), Expr::Running(1)));
        assert_eq!(call(&expression(1, nested), &[0.0]), 10.0);
        let product = Expr::Product(Box::new([number(1.0), parameter(0), Expr::Running(0)]));
        let product = expression(1, product);
        assert_eq!(call(&product, &[4.0]), 24.0);
        assert_eq!(call(&product, &[0.0]), 1.0);
        assert_eq!(call(&expression(1, sum(number(0.5), number(2.0), Expr::Running(0))), &[]), 2.0);
    }

    #[test]
    fn select_takes_one_of_its_branches() {
        let select = |branches: &[f64]| {
            let branches = branches.iter().map(|v| binary(BinaryOp::Add, number(*v), parameter(0)));
            let arguments = std::iter::once(parameter(0)).chain(branches).collect();
            expression(1, Expr::Call(Builtin::Select, arguments))
        };
        let (two, three) = (select(&[10.0, 20.0]), select(&[10.0, 20.0, 30.0]));
        assert_eq!([-1.0, 0.0, 1.0].map(|x| call(&two, &[x])), [9.0, 20.0, 21.0]);
        assert_eq!([-1.0, 0.0, 1.0].map(|x| call(&three, &[x])), [9.0, 20.0, 31.0]);
    }

    #[test]
    fn constant_powers_are_products() {
        for exponent in 0..=9 {
            let power = Expr::Call(Builtin::Pow, vec![parameter(0), number(f64::from(exponent))]);
            let found = call(&expression(1, power), &[1.7]);
            assert!((found - 1.7_f64.powi(exponent)).abs() < 1e-12, "{exponent}: {found}");
        }
    }

    #[test]
    fn functions_call_functions_and_take_components() {
        let transform =
            Transform::translate(DVec3::new(1.0, 2.0, 3.0)).then(&Transform::scale(DVec3::splat(2.0)));
        let transform = of(3, FunctionBody::Transform(Arc::new(transform)));
        let mut components = [0.0; 5];
        assert_eq!(compile(&transform).unwrap().call_vector(&[1.0; 3], &mut components), 3);
        assert_eq!(components[..3], [4.0, 6.0, 8.0]);

        let radius = of(3, FunctionBody::Internal(57));
        let point =
            |_| vec![parameter(0), number(4.0), binary(BinaryOp::Multiply, parameter(0), number(0.0))];
        let sum =
            binary(BinaryOp::Add, Expr::User(radius, point(())), Expr::Component(transform, point(()), 1));
        assert_eq!(call(&expression(1, sum), &[3.0]), 5.0 + 12.0);
    }

    #[test]
    fn a_function_may_call_itself() {
        let less = binary(BinaryOp::Subtract, parameter(0), number(1.0));
        let product = binary(BinaryOp::Multiply, Expr::Recursion(vec![less.clone()]), parameter(0));
        let branches = vec![parameter(0), number(0.0), number(1.0), product];
        let factorial = expression(1, Expr::Call(Builtin::Select, branches));
        assert_eq!(call(&factorial, &[5.0]), 120.0);
        // No call of itself ends this one.
        let endless = binary(BinaryOp::Add, Expr::Recursion(vec![less]), number(1.0));
        let budget = Budget::default();
        let mut value = [0.0_f64; 5];
        let endless = compile(&expression(1, endless)).unwrap();
        endless.call_within(&[1.0], &mut value, &budget);
        assert!(value[0].is_nan() && budget.is_too_deep());
    }

    #[test]
    fn endless_sums_come_to_an_end() {
        let sum = Expr::Sum(Box::new([number(0.0), parameter(0), number(1.0)]));
        let sum = compile(&expression(1, sum)).unwrap();
        let budget = Budget::default();
        let mut value = [0.0_f64; 5];
        sum.call_within(&[1e300], &mut value, &budget);
        assert!(value[0].is_nan() && budget.is_spent() && !budget.is_too_deep());
    }

    #[test]
    fn long_and_deep_expressions_are_compiled_or_refused() {
        let long = (0..20000).fold(number(0.0), |e, _| binary(BinaryOp::Add, e, parameter(0)));
        assert_eq!(call(&expression(1, long), &[0.5]), 10000.0);
        let deep = (0..2000).fold(parameter(0), |e, _| Expr::Negate(Box::new(e)));
        assert!(compile(&expression(1, deep)).is_err());
        let chain = (0..2000)
            .fold(expression(1, parameter(0)), |f, _| expression(1, Expr::User(f, vec![parameter(0)])));
        assert!(compile(&chain).is_err());
    }

    /// Checks that bands hold the values of a function of one number, and says how wide the narrowest are.
    fn held(function: &Arc<scene::Function>) -> f64 {
        let compiled = compile(function).unwrap();
        let mut reach: f64 = 0.0;
        for n in 0..300 {
            let (middle, half) = (f64::from(n) * 0.02 - 3.0, 0.6_f64.powi(n % 25));
            let found = compiled.enclose(&[Band::line(Lanes::splat(middle), Lanes::splat(half))]);
            for step in -4..=4 {
                let s = f64::from(step) / 4.0;
                let off =
                    (compiled.call(&[middle + half * s]) - found.middle.0[1] - found.slope.0[1] * s).abs();
                assert!(
                    off.partial_cmp(&found.reach.0[1]) != Some(Ordering::Greater),
                    "{off:e} off at {s} of {found:?}"
                );
            }
            if n % 25 == 24 {
                reach = reach.max(found.reach.0[1]);
            }
        }
        reach
    }

    #[test]
    fn bands_hold_choices_sums_and_functions_of_functions() {
        let square = expression(1, binary(BinaryOp::Multiply, parameter(0), parameter(0)));
        let choice = |zero: Option<Expr>| {
            let branches = [parameter(0), Expr::Negate(Box::new(parameter(0)))].into_iter().chain(zero);
            Expr::Call(
                Builtin::Select,
                branches.chain([Expr::User(square.clone(), vec![parameter(0)])]).collect(),
            )
        };
        assert!(held(&expression(1, choice(None))) < 1e-4);
        assert!(held(&expression(1, choice(Some(number(0.0))))) < 1e-4);
        let term = Expr::Call(Builtin::Sin, vec![binary(BinaryOp::Multiply, Expr::Running(0), parameter(0))]);
        assert!(held(&expression(1, Expr::Sum(Box::new([number(1.0), number(20.0), term])))) < 1e-4);
        let whole = Expr::Call(Builtin::Floor, vec![parameter(0)]);
        assert!(held(&expression(1, binary(BinaryOp::Subtract, parameter(0), whole))) <= 0.51);
    }

    #[test]
    fn of_what_calls_itself_without_end_nothing_is_known() {
        let body = binary(BinaryOp::Add, Expr::Recursion(vec![parameter(0)]), number(1.0));
        let function = compile(&expression(1, body)).unwrap();
        assert_eq!(function.enclose(&[Band::constant(1.0)]).reach.0[0], f64::INFINITY);
    }

    #[test]
    fn bands_hold_what_calls_itself_so_many_times() {
        let less = binary(BinaryOp::Subtract, parameter(1), number(1.0));
        let again = Expr::Recursion(vec![binary(BinaryOp::Multiply, parameter(0), number(1.3)), less]);
        let wave = binary(BinaryOp::Add, Expr::Call(Builtin::Sin, vec![again]), parameter(0));
        let choice = vec![parameter(1), number(7.0), parameter(0), wave];
        let counted = expression(2, Expr::Call(Builtin::Select, choice));
        assert!(held(&expression(1, Expr::User(counted, vec![parameter(0), number(5.0)]))) < 1e-4);
    }

    #[test]
    fn a_surface_of_what_calls_itself_has_no_holes() {
        let less = binary(BinaryOp::Subtract, parameter(3), number(1.0));
        let wider = binary(BinaryOp::Multiply, parameter(0), number(1.1));
        let again = Expr::Recursion(vec![wider, parameter(1), parameter(2), less]);
        let square = |index| binary(BinaryOp::Multiply, parameter(index), parameter(index));
        let sum = binary(BinaryOp::Add, binary(BinaryOp::Add, square(0), square(1)), square(2));
        let thin = binary(
            BinaryOp::Subtract,
            Expr::Call(Builtin::Abs, vec![binary(BinaryOp::Subtract, sum, number(1.0))]),
            number(1e-3),
        );
        let counted =
            expression(4, Expr::Call(Builtin::Select, vec![parameter(3), number(9.0), thin, again]));
        let called = vec![parameter(0), parameter(1), parameter(2), number(3.0)];
        let half = DVec3::splat(1.5);
        let shell = Isosurface {
            function: compile(&expression(3, Expr::User(counted, called))).unwrap(),
            threshold: 0.0,
            container: Container::Box(Cuboid { min: -half, max: half }),
            accuracy: 1e-3,
            max_gradient: 0.01,
            adaptive: None,
            most: 1,
            open: false,
            steepest: Steepest::default(),
        };
        for n in 0..50 {
            let (y, z) = (f64::from(n % 7) * 0.1 - 0.3, f64::from(n / 7) * 0.1 - 0.3);
            let ray = Ray::new(DVec3::new(-3.0, y, z), DVec3::X);
            let expected = 3.0 - (1.0 + 1e-3 - y * y - z * z).sqrt() / 1.1_f64.powi(3);
            let found = shell.nearest(&ray, Range::AHEAD).map(|crossing| crossing.t);
            assert!(found.is_some_and(|t| (t - expected).abs() < 1e-9), "{y} {z}: {found:?} {expected}");
        }
    }

    #[test]
    fn short_functions_are_written_out_where_they_are_called() {
        let square = expression(1, binary(BinaryOp::Multiply, parameter(0), parameter(0)));
        let of_sum = |arguments: Vec<Expr>| Expr::User(square.clone(), arguments);
        let sum = binary(BinaryOp::Add, parameter(0), parameter(1));
        let both = binary(BinaryOp::Subtract, of_sum(vec![sum]), of_sum(vec![of_sum(vec![parameter(1)])]));
        assert_eq!(call(&expression(2, both), &[3.0, 2.0]), 9.0);
    }
}
