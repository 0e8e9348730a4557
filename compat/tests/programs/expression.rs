//! Random expressions of every kind, made of what a program has declared so far.
//!
//! They stay inside the domains of what they call, so that no program is refused.

use crate::random::Random;

/// What is declared where an expression stands.
#[derive(Clone, Default)]
pub(crate) struct Names {
    /// Floats.
    pub(crate) floats: Vec<String>,
    /// Vectors of three components.
    pub(crate) vectors: Vec<String>,
    /// Colours.
    pub(crate) colors: Vec<String>,
    /// Strings.
    pub(crate) strings: Vec<String>,
    /// Arrays of floats, and the sizes of their dimensions.
    pub(crate) arrays: Vec<(String, Vec<usize>)>,
    /// Functions of floats, and how many they take.
    pub(crate) functions: Vec<(String, usize)>,
    /// Functions of x, y and z that give vectors or colours.
    pub(crate) fields: Vec<String>,
    /// Splines of three components.
    pub(crate) splines: Vec<String>,
    /// Macros that leave a float, and how many floats they take.
    pub(crate) macros: Vec<(String, usize)>,
    /// Macros that leave `+ 2` and the like.
    pub(crate) fragments: Vec<String>,
    /// Streams of random numbers.
    pub(crate) streams: Vec<String>,
}

/// Makes expressions of these names.
pub(crate) struct Maker<'a> {
    pub(crate) random: &'a mut Random,
    pub(crate) names: &'a Names,
}

impl Maker<'_> {
    fn named(&mut self, names: &[String], otherwise: &str) -> String {
        match names.len() {
            0 => otherwise.to_owned(),
            count => names[self.random.below(count)].clone(),
        }
    }

    /// A number as it may be written.
    pub(crate) fn number(&mut self) -> String {
        match self.random.below(8) {
            0 => format!(".{}", 1 + self.random.below(99)),
            1 => format!(
                "{}.{}e{}",
                self.random.below(10),
                self.random.below(100),
                self.random.one(&["0", "-2", "+1"])
            ),
            2 => self
                .random
                .one(&["0", "1", "pi", "true", "off", "clock", "1e-3", "100", "2.", "version"])
                .to_owned(),
            3 => format!("{}.{:03}", self.random.below(20), self.random.below(1000)),
            _ => format!("{}", 1 + self.random.below(9)),
        }
    }

    fn comma(&mut self) -> &'static str {
        self.random.one(&[", ", ",", ", ", " , /* comma */ "])
    }

    /// A float: one operand, so that it can stand between any operators.
    pub(crate) fn float(&mut self, depth: u32) -> String {
        if depth == 0 {
            return match self.random.below(3) {
                0 => self.number(),
                _ => {
                    let names = &self.names.floats;
                    self.named(names, "3")
                }
            };
        }
        let d = depth - 1;
        match self.random.below(30) {
            0..=4 => format!("({})", self.arithmetic(d)),
            5 => format!("-{}", self.float(d)),
            6 => format!("!{}", self.float(d)),
            7 => format!(
                "({} {} {})",
                self.arithmetic(d),
                self.random.one(&["<", "<=", "=", "!=", ">=", ">"]),
                self.arithmetic(d)
            ),
            8 => format!("({} {} {})", self.float(d), self.random.one(&["&", "|"]), self.float(d)),
            9 => format!("({} ? {} : {})", self.arithmetic(d), self.arithmetic(d), self.arithmetic(d)),
            10 | 11 => {
                let call = self.random.one(&[
                    "abs", "sin", "cos", "atan", "asinh", "floor", "ceil", "int", "degrees", "radians",
                    "tanh", "asin", "acos",
                ]);
                format!("{call}({})", self.arithmetic(d))
            }
            12 => format!("{}(abs({}))", self.random.one(&["sqrt", "sqrt", "abs"]), self.arithmetic(d)),
            13 => format!("{}(abs({}) + 0.25)", self.random.one(&["ln", "log"]), self.arithmetic(d)),
            14 => format!(
                "pow(abs({}) + 0.5{}{})",
                self.float(d),
                self.comma(),
                self.random.one(&["2", "0.5", "-1", "3.25"])
            ),
            15 => format!(
                "atan2({}{}{})",
                self.arithmetic(d),
                self.comma(),
                self.random.one(&["1.5", "-0.75", "(-2)", "4"])
            ),
            16 => format!(
                "{}({}{}{})",
                self.random.one(&["mod", "div"]),
                self.arithmetic(d),
                self.comma(),
                self.arithmetic(d)
            ),
            17 => {
                let (a, b, c) = (self.arithmetic(d), self.arithmetic(d), self.float(d));
                format!(
                    "{}({a}, {b}, {c})",
                    self.random.one(&["min", "max", "bitwise_and", "bitwise_or", "bitwise_xor", "select"])
                )
            }
            18 => {
                format!("select({}, {}, {}, {})", self.float(d), self.float(d), self.float(d), self.float(d))
            }
            19 => format!("vdot({}{}{})", self.vector(d), self.comma(), self.vector(d)),
            20 => format!("vlength({})", self.vector(d)),
            21 => format!(
                "{}.{}",
                self.vector_operand(d),
                self.random.one(&["x", "y", "z", "u", "v", "red", "green", "blue", "gray"])
            ),
            22 => {
                let colors = &self.names.colors;
                let color = self.named(colors, "<1, 2, 3, 4, 5>");
                format!(
                    "{color}.{}",
                    self.random.one(&["red", "green", "blue", "filter", "transmit", "gray", "t", "x"])
                )
            }
            23 => self.of_text(d),
            24 => self.element(d).unwrap_or_else(|| self.number()),
            25 => self.call(d).unwrap_or_else(|| self.number()),
            26 => {
                let splines = &self.names.splines;
                match self.named(splines, "").as_str() {
                    "" => self.number(),
                    // POV-Ray does not survive what is no number.
                    spline => {
                        format!(
                            "{spline}(max(-9, min(20, {})){}).{}",
                            self.arithmetic(d),
                            self.random.one(&["", "", ", quadratic_spline", ", natural_spline"]),
                            self.random.one(&["x", "y", "z"])
                        )
                    }
                }
            }
            27 => {
                let macros = &self.names.macros;
                if macros.is_empty() {
                    return self.number();
                }
                let (name, count) = &macros[self.random.below(macros.len())];
                let given: Vec<String> = (0..*count).map(|_| self.arithmetic(d.min(1))).collect();
                format!("(0 + {name}({}))", given.join(", "))
            }
            28 => {
                let (fragments, streams) = (&self.names.fragments, &self.names.streams);
                match (self.named(fragments, ""), self.named(streams, "")) {
                    (fragment, _) if !fragment.is_empty() => format!("({} {fragment}())", self.float(d)),
                    (_, stream) if !stream.is_empty() => format!("rand({stream})"),
                    _ => self.number(),
                }
            }
            _ => {
                // More than this between the arms, and POV-Ray crashes at times.
                let (a, b) = (self.float(d), self.float(0));
                format!("({a} #if ({}) + {b} #else * 2 #end)", self.float(0))
            }
        }
    }

    /// A float with operators outside of parentheses.
    pub(crate) fn arithmetic(&mut self, depth: u32) -> String {
        let mut text = self.float(depth);
        for _ in 0..self.random.below(3) {
            let operator = self.random.one(&[" + ", " - ", "*", " / ", "-", " * "]);
            text = format!("{text}{operator}{}", self.float(depth.saturating_sub(1)));
        }
        text
    }

    fn of_text(&mut self, depth: u32) -> String {
        let (a, b) = (self.text(depth), self.text(depth));
        match self.random.below(6) {
            0 => format!("strlen({a})"),
            1 => format!("strcmp({a}, {b})"),
            2 => format!("asc({a})"),
            3 => format!("val({a})"),
            4 => format!("({a} {} {b})", self.random.one(&["<", "=", "!=", ">="])),
            _ => format!("val(str({}, 0, 6))", self.arithmetic(depth.saturating_sub(1))),
        }
    }

    /// An element of an array, by a subscript that is always in range.
    pub(crate) fn element(&mut self, depth: u32) -> Option<String> {
        let arrays = &self.names.arrays;
        if arrays.is_empty() {
            return None;
        }
        let (name, sizes) = &arrays[self.random.below(arrays.len())];
        let mut text = name.clone();
        for size in sizes {
            let at = match self.random.below(2) {
                0 => self.random.below(*size).to_string(),
                _ => format!("mod(abs(int({})), {size})", self.arithmetic(depth.min(1))),
            };
            text.push_str(&format!("[{at}]"));
        }
        Some(text)
    }

    fn call(&mut self, depth: u32) -> Option<String> {
        let (functions, fields) = (&self.names.functions, &self.names.fields);
        if (self.random.below(4) == 0) && !fields.is_empty() {
            let name = &fields[self.random.below(fields.len())];
            let point = format!(
                "max(-9, min(20, {})), 1, max(-9, min(20, {}))",
                self.arithmetic(depth),
                self.float(depth)
            );
            return Some(format!("{name}({point}).{}", self.random.one(&["x", "y", "z", "red", "gray"])));
        }
        if functions.is_empty() {
            return None;
        }
        let (name, count) = &functions[self.random.below(functions.len())];
        let given: Vec<String> = (0..*count).map(|_| self.arithmetic(depth)).collect();
        Some(format!("{name}({})", given.join(", ")))
    }

    /// A vector of three components as one operand.
    pub(crate) fn vector_operand(&mut self, depth: u32) -> String {
        if depth == 0 {
            let vectors = &self.names.vectors;
            return match self.random.below(3) {
                0 => self.random.one(&["x", "y", "z", "<1, 2, 3>", "<-1,.5,2>"]).to_owned(),
                _ => self.named(vectors, "<3, 1, 2>"),
            };
        }
        let d = depth - 1;
        match self.random.below(9) {
            0 | 1 => format!("<{}, {}, {}>", self.arithmetic(d), self.arithmetic(d), self.arithmetic(d)),
            2 => format!("<{} {} {}>", self.float(0), self.float(0).trim_start_matches('-'), self.number()),
            3 => format!("({})", self.vector(d)),
            4 => format!("vcross({}, {})", self.vector(d), self.vector(d)),
            5 => format!("vnormalize({} + <0.1, 0.2, 0.3>)", self.vector_operand(d)),
            6 => format!("vrotate({}, {})", self.vector(d), self.vector(d)),
            7 => format!("vaxis_rotate({}, <1, 2, {}>, {})", self.vector(d), self.number(), self.float(d)),
            _ => {
                let splines = &self.names.splines;
                match self.named(splines, "").as_str() {
                    "" => "<0, 1, 0>".to_owned(),
                    spline => format!("{spline}(max(-9, min(20, {})))", self.arithmetic(d)),
                }
            }
        }
    }

    /// A vector of three components.
    pub(crate) fn vector(&mut self, depth: u32) -> String {
        let mut text = self.vector_operand(depth);
        for _ in 0..self.random.below(3) {
            let d = depth.saturating_sub(1);
            text = match self.random.below(4) {
                0 => format!("{text} * {}", self.float(d)),
                1 => format!("{text} / {}", self.float(d)),
                2 => format!("{text} - {}", self.vector_operand(d)),
                _ => format!("{text} + {}", self.vector_operand(d)),
            };
        }
        text
    }

    /// A colour with its keyword.
    pub(crate) fn color(&mut self, depth: u32) -> String {
        let float = |maker: &mut Self| maker.arithmetic(depth.min(1));
        match self.random.below(7) {
            0 => format!("rgb <{}, {}, {}>", float(self), float(self), float(self)),
            1 => format!("color rgbf <{}, {}, {}, {}>", float(self), float(self), float(self), float(self)),
            2 => format!("rgbt {}", float(self)),
            3 => format!("red {} green {} filter {}", float(self), float(self), float(self)),
            4 => format!("srgb <{}, {}, {}>", float(self), float(self), float(self)),
            5 => format!(
                "rgbft <{}, {}, {}, {}, {}>",
                float(self),
                float(self),
                float(self),
                float(self),
                float(self)
            ),
            _ => {
                let colors = &self.names.colors;
                format!("{} * {} + <1, 2, 3>", self.named(colors, "color <1, 2, 3>"), float(self))
            }
        }
    }

    /// A string.
    pub(crate) fn text(&mut self, depth: u32) -> String {
        if depth == 0 {
            let strings = &self.names.strings;
            return match self.random.below(3) {
                0 => self
                    .random
                    .one(&["\"\"", "\"abc\"", "\"a\\\"b\"", "\"12.5x\"", "\"\\u0041b\"", "\"Z\\\\\""])
                    .to_owned(),
                _ => self.named(strings, "\"text\""),
            };
        }
        let d = depth - 1;
        match self.random.below(8) {
            0 => format!(
                // The sign of what is no number is nobody's promise.
                "str(max(-1e9, min(1e9, {})), {}, {})",
                self.arithmetic(d),
                self.random.one(&["0", "8", "-8"]),
                self.random.one(&["0", "3", "-1", "12"])
            ),
            1 => format!(
                "vstr({}, <max(-1e9, min(1e9, {})), {}, 2.5>, \"{}\", 0, 4)",
                self.random.one(&["2", "3", "5"]),
                self.arithmetic(d),
                self.number(),
                self.random.one(&[",", " ", "ab"])
            ),
            2 => format!("concat({}, {})", self.text(d), self.text(d)),
            3 => format!("strupr({})", self.text(d)),
            4 => format!("strlwr({})", self.text(d)),
            5 => format!(
                "substr(concat({}, \"abcdef\"), {}, {})",
                self.text(d),
                1 + self.random.below(4),
                self.random.below(4)
            ),
            6 => format!("chr({})", 32 + self.random.below(90)),
            _ => self.text(0),
        }
    }

    /// The body of a function of these parameters.
    pub(crate) fn body(&mut self, parameters: &[&str], depth: u32) -> String {
        let operand = |maker: &mut Self| match maker.random.below(4) {
            0 => format!("{}", 1 + maker.random.below(9)),
            1 => {
                let floats = &maker.names.floats;
                maker.named(floats, "pi")
            }
            _ => maker.random.one(parameters).to_owned(),
        };
        if depth == 0 {
            return operand(self);
        }
        let d = depth - 1;
        let body = |maker: &mut Self| maker.body(parameters, d);
        match self.random.below(12) {
            0..=3 => {
                let mut text = body(self);
                for _ in 0..=self.random.below(3) {
                    text = match self.random.below(6) {
                        0 => format!("{text} / (abs({}) + 0.5)", body(self)),
                        1 => format!("{text} / {}", 1 + self.random.below(9)),
                        2 => format!("{text} * {}", body(self)),
                        3 => format!("{text} - {}", body(self)),
                        _ => format!("{text} + {}", body(self)),
                    };
                }
                text
            }
            4 => format!(
                "({} {} {})",
                body(self),
                self.random.one(&["<", "<=", "=", "!=", ">", "&", "|"]),
                body(self)
            ),
            5 => format!(
                "{}({})",
                self.random.one(&["sin", "cos", "abs", "floor", "atan", "tanh", "exp", "int", "ceil"]),
                body(self)
            ),
            6 => format!("{}(abs({}))", self.random.one(&["sqrt", "ln", "log"]), body(self)),
            7 => format!(
                "{}({}, {})",
                self.random.one(&["min", "max", "mod", "atan2", "div"]),
                body(self),
                body(self)
            ),
            8 => format!(
                "pow({}, {})",
                body(self),
                self.random.one(&["1", "2", "3", "4", "5", "6", "7", "8", "-1", "2.5"])
            ),
            9 => format!(
                "{}(i, 1, {}, i * {})",
                self.random.one(&["sum", "prod"]),
                1 + self.random.below(4),
                body(self)
            ),
            10 => format!("select({}, {}, {})", body(self), body(self), body(self)),
            _ => {
                let functions = &self.names.functions;
                if functions.is_empty() {
                    return format!("-({})", body(self));
                }
                let (name, count) = &functions[self.random.below(functions.len())];
                let given: Vec<String> = (0..*count).map(|_| body(self)).collect();
                format!("{name}({})", given.join(", "))
            }
        }
    }
}
