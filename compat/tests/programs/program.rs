//! Random programs that are valid: declarations, loops, arms, macros, functions, splines and arrays, and lines
//! that print what came of them.

use std::fmt::Write;

use crate::expression::{Maker, Names};
use crate::random::Random;

/// Statements of a program before it prints.
const STATEMENTS: usize = 14;

/// What prints a float, a vector, a colour and a string, in lines that POV-Ray does not break: digits enough to
/// tell any two numbers apart.
pub(crate) const PRELUDE: &str = r#"#version 3.7;
global_settings { assumed_gamma 1 }
#macro F(e) #debug concat(str((abs(e) < 1e30 ? e : ln(abs(e) + 1)), 0, 15), "\n") #end
#macro V(e) F(e.x) F(e.y) F(e.z) #end
#macro C(e) V(e) F(e.filter) F(e.transmit) #end
#macro S(e) F(strlen(e)) #debug concat("[", substr(e, 1, min(strlen(e), 60)), "]\n") #end
"#;

/// A program, made of its seed alone.
pub(crate) fn program(seed: u64) -> String {
    let mut writer =
        Writer { random: Random::new(seed), names: Names::default(), text: String::new(), count: 0, seed };
    for _ in 0..STATEMENTS {
        writer.statement(3);
    }
    writer.print();
    writer.text
}

struct Writer {
    random: Random,
    names: Names,
    text: String,
    /// Names given so far.
    count: usize,
    seed: u64,
}

impl Writer {
    fn name(&mut self, kind: &str) -> String {
        self.count += 1;
        format!("{kind}{}_{}", self.seed, self.count)
    }

    fn make<T>(&mut self, make: impl FnOnce(&mut Maker) -> T) -> T {
        make(&mut Maker { random: &mut self.random, names: &self.names })
    }

    /// What a directive asks for. POV-Ray does not survive other directives in it.
    fn condition(&mut self) -> String {
        loop {
            let text = self.make(|maker| maker.float(2));
            if !text.contains('#') && !self.names.macros.iter().any(|(name, _)| text.contains(name)) {
                return text;
            }
        }
    }

    fn line(&mut self, text: &str) {
        writeln!(self.text, "{text}").expect("strings take any text");
    }

    /// Writes what may be run any number of times, and leaves no name that was not there before.
    fn inner(&mut self, depth: u32) {
        let names = self.names.clone();
        for _ in 0..=self.random.below(2) {
            match self.random.below(4) {
                0 => self.assign(),
                1 => self.local_float(),
                2 if depth > 0 => self.arms(depth - 1),
                _ => self.assign(),
            }
        }
        self.names = names;
    }

    fn statement(&mut self, depth: u32) {
        match self.random.below(20) {
            0..=3 => self.local_float(),
            4 | 5 => {
                let (name, value) = (self.name("V"), self.make(|maker| maker.vector(2)));
                self.line(&format!("#declare {name} = {value};"));
                self.names.vectors.push(name);
            }
            6 => {
                let (name, value) = (self.name("C"), self.make(|maker| maker.color(2)));
                self.line(&format!("#declare {name} = {value};"));
                self.names.colors.push(name);
            }
            7 => {
                let (name, value) = (self.name("S"), self.make(|maker| maker.text(2)));
                self.line(&format!("#declare {name} = {value}"));
                self.names.strings.push(name);
            }
            8 | 9 => self.array(),
            10 => self.arms(depth),
            11 | 12 => self.repeat(depth),
            13 => self.choose(depth),
            14 | 15 => self.macros(),
            16 | 17 => self.function(),
            18 => self.spline(),
            _ => {
                let (name, value) = (self.name("R"), self.random.below(1000));
                self.line(&format!("#declare {name} = seed({value});"));
                self.names.streams.push(name);
            }
        }
    }

    fn local_float(&mut self) {
        let (name, value) = (self.name("A"), self.make(|maker| maker.arithmetic(3)));
        let word = self.random.one(&["declare", "local"]);
        self.line(&format!("#{word} {name} = {value};"));
        self.names.floats.push(name);
    }

    /// Gives something that is there another value.
    fn assign(&mut self) {
        if self.random.below(3) == 0
            && let Some(element) = self.make(|maker| maker.element(1))
        {
            let value = self.make(|maker| maker.arithmetic(2));
            return self.line(&format!("#declare {element} = {value};"));
        }
        if self.random.below(4) == 0 && !self.names.vectors.is_empty() {
            let name = self.names.vectors[self.random.below(self.names.vectors.len())].clone();
            let value = self.make(|maker| maker.vector(2));
            return self.line(&format!("#declare {name} = {value};"));
        }
        if self.names.floats.is_empty() {
            return self.local_float();
        }
        let name = self.names.floats[self.random.below(self.names.floats.len())].clone();
        let value = self.make(|maker| maker.arithmetic(2));
        self.line(&format!("#declare {name} = {value};"));
    }

    fn array(&mut self) {
        let name = self.name("T");
        if self.random.below(3) == 0 {
            let sizes = [1 + self.random.below(3), 1 + self.random.below(3)];
            let row = |writer: &mut Self| {
                let values: Vec<String> =
                    (0..sizes[1]).map(|_| writer.make(|maker| maker.float(1))).collect();
                format!("{{{}}}", values.join(", "))
            };
            let rows: Vec<String> = (0..sizes[0]).map(|_| row(self)).collect();
            self.line(&format!("#declare {name} = array[{}][{}] {{{}}}", sizes[0], sizes[1], rows.join(" ")));
            self.names.arrays.push((name, sizes.to_vec()));
            return;
        }
        let size = 1 + self.random.below(6);
        self.line(&format!("#declare {name} = array[{size}]"));
        let value = self.make(|maker| maker.arithmetic(2));
        let index = self.name("I");
        self.line(&format!(
            "#for ({index}, 0, {}) #declare {name}[{index}] = {index} * {value}; #end",
            size - 1
        ));
        self.names.arrays.push((name, vec![size]));
    }

    fn arms(&mut self, depth: u32) {
        let condition = self.condition();
        let relation = self.random.one(&["<", ">", "=", "<=", "!="]);
        let other = self.make(|maker| maker.number());
        self.line(&format!("#if ({condition} {relation} {other})"));
        self.inner(depth);
        if self.random.below(3) == 0 {
            let condition = self.condition();
            self.line(&format!("#elseif ({condition})"));
            self.inner(depth);
        }
        if self.random.below(2) == 0 {
            self.line("#else");
            self.inner(depth);
        }
        self.line("#end");
    }

    fn repeat(&mut self, depth: u32) {
        let index = self.name("I");
        if self.random.below(2) == 0 {
            let head = self.random.one(&["1, 5", "0, 1, 0.25", "5, 1, -2", "3 1", "-1 1"]);
            self.line(&format!("#for ({index}, {head})"));
            self.names.floats.push(index);
        } else {
            let last = 1 + self.random.below(5);
            self.line(&format!("#declare {index} = 0;\n#while ({index} < {last})"));
            self.line(&format!("#declare {index} = {index} + 1;"));
        }
        if self.random.below(4) == 0 {
            let condition = self.condition();
            self.line(&format!("#if ({condition}) #break #end"));
        }
        // What counts is not given other values.
        let names = self.names.clone();
        self.names.floats.retain(|name| !name.starts_with('I'));
        self.inner(depth);
        self.names = names;
        self.names.floats.retain(|name| !name.starts_with('I'));
        self.line("#end");
    }

    fn choose(&mut self, depth: u32) {
        let value = self.condition();
        self.line(&format!("#switch (mod(int({value}), 4))"));
        for number in 0..=self.random.below(3) {
            match self.random.below(3) {
                0 => self.line(&format!("#range ({number}, {number}.5)")),
                _ => self.line(&format!("#case ({number})")),
            }
            self.inner(depth.saturating_sub(1));
            if self.random.below(3) > 0 {
                self.line("#break");
            }
        }
        if self.random.below(2) == 0 {
            self.line("#else");
            self.inner(depth.saturating_sub(1));
        }
        self.line("#end");
    }

    fn macros(&mut self) {
        let name = self.name("M");
        match self.random.below(4) {
            0 => {
                let operand = self.make(|maker| maker.float(1));
                let operator = self.random.one(&["+", "-", "*", "/"]);
                self.line(&format!("#macro {name}() {operator} {operand} #end"));
                self.names.fragments.push(name);
            }
            1 => {
                // By reference, and by value where an expression is given.
                let value = self.make(|maker| maker.arithmetic(1));
                self.line(&format!("#macro {name}(P) #declare P = P * 0.5 + {value}; #end"));
                for _ in 0..2 {
                    let given = self.make(|maker| match maker.random.below(3) {
                        0 => maker.arithmetic(1),
                        _ => maker.float(0),
                    });
                    // A name that is reserved, or a constant, is given by value.
                    self.line(&format!("{name}({given})"));
                }
            }
            _ => {
                let count = self.random.below(4);
                let parameters: Vec<String> = (0..count).map(|at| format!("P{at}")).collect();
                let outer = self.names.clone();
                self.names.macros.clear();
                self.names.fragments.clear();
                self.names.floats.extend(parameters.iter().cloned());
                let local = self.make(|maker| maker.arithmetic(2));
                let result = self.name("L");
                self.names.floats.push(result.clone());
                let value = self.make(|maker| maker.float(2));
                self.names = outer;
                let separator = self.random.one(&[", ", " ", ","]);
                let head = parameters.join(separator);
                let body = match self.random.below(3) {
                    0 => format!("#local {result} = {local}; ({value})"),
                    1 => format!("#local {result} = {local};\n#local {result} = {value}; {result}"),
                    _ => format!("#local {result} = {local}; (#if ({result} > 0) {value} #else 1 #end)"),
                };
                self.line(&format!("#macro {name}({head})\n{body} #end"));
                self.names.macros.push((name, count));
            }
        }
    }

    fn function(&mut self) {
        let name = self.name("f");
        if self.random.below(4) == 0 {
            let body = self.random.one(&[
                "transform { rotate <10, 20, 30> scale <1, 2, 3> translate x }",
                "pigment { gradient x color_map { [0 rgb <1, 2, 3>] [1 rgbft <3, 4, 5, 6, 7>] } }",
                "transform { matrix <1, 2, 0, 0, 1, 3, 2, 0, 1, 4, 5, 6> inverse }",
                "pigment { bozo color_map { [0.2 rgb <1, 0.5, 0>] [0.7 rgb 2] } turbulence 0.3 }",
            ]);
            self.line(&format!("#declare {name} = function {{ {body} }}"));
            self.names.fields.push(name);
            return;
        }
        let (head, parameters): (&str, &[&str]) = match self.random.below(4) {
            0 => ("(a)", &["a"]),
            1 => ("(a, b)", &["a", "b"]),
            2 => ("(x y)", &["x", "y"]),
            _ => ("", &["x", "y", "z"]),
        };
        let body = self.make(|maker| maker.body(parameters, 3));
        self.line(&format!("#declare {name} = function{head} {{ {body} }}"));
        self.names.functions.push((name, parameters.len()));
    }

    fn spline(&mut self) {
        let name = self.name("K");
        let kind =
            self.random.one(&["linear_spline", "quadratic_spline", "cubic_spline", "natural_spline", ""]);
        let mut points = String::new();
        let mut key = -2.0;
        for _ in 0..3 + self.random.below(4) {
            key += [0.5, 1.0, 0.3, 2.7][self.random.below(4)];
            let [x, y, z] = [9, 99, 999].map(|most| self.random.below(most));
            write!(points, "{key}, <{x}, {y} / 10, {z} / 100>, ").expect("strings take any text");
        }
        self.line(&format!("#declare {name} = spline {{ {kind} {points} }}"));
        self.names.splines.push(name);
    }

    /// Prints everything that has a name, and some more.
    fn print(&mut self) {
        let names = self.names.clone();
        let kinds =
            [("F", &names.floats), ("V", &names.vectors), ("C", &names.colors), ("S", &names.strings)];
        for (with, name) in kinds.iter().flat_map(|(with, names)| names.iter().map(move |name| (with, name)))
        {
            self.line(&format!("{with}({name})"));
        }
        for (name, sizes) in &names.arrays {
            let zeros = "[0]".repeat(sizes.len());
            self.line(&format!("F({name}{zeros} + dimension_size({name}, 1))"));
        }
        for _ in 0..3 {
            let (float, vector, text) = self.make(|maker| (maker.float(3), maker.vector(3), maker.text(2)));
            self.line(&format!("F(({float}))\nV(({vector}))\nS({text})"));
        }
    }
}
