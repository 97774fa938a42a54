//! Well-formed specifications at random: a chain of 1 to 4 blocks of 1 to 3 channels with drifts, functions, tables, polynomial data, units,
//! disturbances, noise, networks, dispersions, actuators and sensors.

use super::draw::Draw;
use super::style::{Tree, keys, number, text};

const UNITS: [&str; 7] = ["m", "rad", "kg", "km/h", "mV", "deg/s", "m/sqrt(s)"];

pub fn specification(draw: &mut Draw) -> Tree {
    let (blocks, width) = (1 + draw.below(4), 1 + draw.below(3));
    let chain = Chain {
        units: (0..=blocks)
            .map(|_| (0..width).map(|_| draw.of(&UNITS)).collect())
            .collect(),
        wiener: draw.chance(50),
        exact: draw.chance(20),
        draw,
    };
    chain.specification(blocks, width)
}

struct Chain<'d> {
    /// Units of the states of each block, and of the inputs.
    units: Vec<Vec<&'static str>>,
    wiener: bool,
    exact: bool,
    draw: &'d mut Draw,
}

fn state(block: usize, channel: usize) -> String {
    format!("x{}_{}", block + 1, channel + 1)
}

impl Chain<'_> {
    fn specification(mut self, blocks: usize, width: usize) -> Tree {
        let mut plant = Vec::new();
        let mut gains = Vec::new();
        for block in 0..blocks {
            let last = block + 1 == blocks;
            let (one, other) = self.block(block, width, last);
            plant.push((format!("b{}", block + 1), one));
            gains.push((format!("b{}", block + 1), other));
        }
        let inputs = (0..width)
            .map(|channel| (format!("push{}", channel + 1), self.input(blocks, channel)))
            .collect();
        let reference = (0..width).map(|channel| {
            let unit = self.units[0][channel];
            (
                state(0, channel),
                text(format!("0.1 {unit}*sin({}*t/(1 s))", self.draw.positive())),
            )
        });
        let reference = Tree::Keys(reference.collect());
        let mut controller = vec![
            ("sample_time".to_owned(), text("2 ms")),
            ("blocks".to_owned(), Tree::Ordered(gains)),
        ];
        if self.exact {
            controller.push(("virtual_derivative".to_owned(), text("exact")));
        }
        let noise = if self.wiener { "wiener" } else { "sampled" };
        keys([
            ("nsv", number("1")),
            ("name", text("random")),
            (
                "title",
                text("It is random - isn't it?".replace('\'', "\u{2019}")),
            ),
            (
                "constants",
                Tree::Ordered(vec![
                    ("half".to_owned(), text("0.5")),
                    ("pace".to_owned(), text("2*half/(1 s)")),
                ]),
            ),
            (
                "parameters",
                Tree::Ordered(vec![
                    (
                        "scale".to_owned(),
                        keys([
                            ("value", text(self.draw.positive())),
                            ("dispersion", self.dispersion("")),
                        ]),
                    ),
                    ("offset".to_owned(), text(self.draw.positive())),
                ]),
            ),
            (
                "functions",
                keys([(
                    "sat",
                    keys([
                        ("arguments", Tree::List(vec![text("value"), text("limit")])),
                        ("value", text("limit*tanh(value/limit)")),
                    ]),
                )]),
            ),
            (
                "polynomials",
                keys([(
                    "poly",
                    keys([
                        ("arguments", Tree::List(vec![text("u")])),
                        (
                            "parts",
                            keys([(
                                "p",
                                Tree::List(vec![
                                    Tree::List(vec![number(self.draw.positive()), number("1")]),
                                    Tree::List(vec![number("0.01"), number("3")]),
                                ]),
                            )]),
                        ),
                    ]),
                )]),
            ),
            ("tables", keys([("lut", self.table())])),
            (
                "definitions",
                Tree::Ordered(vec![(
                    "first".to_owned(),
                    text(format!("{}/(1 {})", state(0, 0), self.units[0][0])),
                )]),
            ),
            (
                "plant",
                keys([
                    ("blocks", Tree::Ordered(plant)),
                    ("inputs", Tree::Ordered(inputs)),
                ]),
            ),
            ("reference", reference),
            ("controller", Tree::Keys(controller)),
            (
                "scenario",
                keys([
                    ("horizon", text("1 s")),
                    ("substeps", number("2")),
                    ("noise", text(noise)),
                    ("seed", number("3")),
                ]),
            ),
        ])
    }

    fn table(&mut self) -> Tree {
        let list = |items: Vec<String>| Tree::List(items.into_iter().map(Tree::Number).collect());
        let mut points = vec![-3.0];
        for _ in 0..3 + self.draw.below(4) {
            points.push(points[points.len() - 1] + 1.25 + self.draw.below(8) as f64 / 4.0);
        }
        let values = points.iter().map(|_| self.draw.positive()).collect();
        let points = points.iter().map(f64::to_string).collect();
        keys([
            ("axes", keys([("u", list(points))])),
            ("values", list(values)),
            ("interpolation", text(self.draw.of(&["linear", "cubic"]))),
            ("extrapolation", text(self.draw.of(&["clamp", "error"]))),
        ])
    }

    fn dispersion(&mut self, unit: &str) -> Tree {
        let quantities = |numbers: &[&str]| {
            let written = numbers
                .iter()
                .map(|number| text(format!("{number} {unit}").trim()));
            Tree::List(written.collect())
        };
        match self.draw.below(3) {
            0 => keys([("uniform", quantities(&["0.5", "1.5"]))]),
            1 => keys([("normal", quantities(&["1", "0.1"]))]),
            _ => keys([("truncated_normal", quantities(&["1", "0.1", "0.8", "1.2"]))]),
        }
    }

    /// Something of the state's unit per second that depends on this block and the blocks outside it.
    fn drift(&mut self, block: usize, channel: usize, width: usize) -> String {
        let unit = self.units[block][channel];
        let mut sum = format!("-{}*{}/(1 s)", self.draw.positive(), state(block, channel));
        for _ in 0..self.draw.below(3) {
            let (b, c) = (self.draw.below(block + 1), self.draw.below(width));
            let argument = format!("{}/(1 {})", state(b, c), self.units[b][c]);
            let form = self.draw.of(&[
                "sin(#)",
                "tanh(scale*#)",
                "cos(#)^2",
                "sat(#, half)",
                "lut(#)",
                "poly.p(#)",
                "exp(-abs(#))",
                "if(# > 0, #, 0)",
                "first*#",
            ]);
            sum += &format!(
                " + 0.1 {unit}*{}*pace",
                form.replace('#', &format!("({argument})"))
            );
        }
        sum
    }

    fn block(&mut self, block: usize, width: usize, last: bool) -> (Tree, Tree) {
        let states = (0..width)
            .map(|channel| (state(block, channel), self.state(block, channel)))
            .collect();
        let drift = (0..width)
            .map(|channel| text(self.drift(block, channel, width)))
            .collect();
        let gain = (0..width).map(|row| {
            let entry = |column: usize| match row == column {
                true => text(format!(
                    "{} {}/(s*({}))",
                    1 + row,
                    self.units[block][row],
                    self.units[block + 1][column]
                )),
                false => text("0"),
            };
            Tree::List((0..width).map(entry).collect())
        });
        let mut plant = vec![
            ("states", Tree::Ordered(states)),
            ("drift", Tree::List(drift)),
            ("gain", Tree::List(gain.collect())),
        ];
        let mut gains = vec![
            ("K", text(self.draw.positive())),
            ("kbar", text("auto")),
            ("C", text(format!("{} 1/s", self.draw.positive()))),
        ];
        if !last {
            gains.extend([("eta_2", text("0.1")), ("eta_3", text("2"))]);
            if !self.exact {
                gains.push(("filter", text("20 ms")));
            }
        }
        let disturbed = self.disturb(block, width, &mut plant, &mut gains);
        if self.draw.chance(30) {
            self.shake(block, width, disturbed, &mut plant, &mut gains);
        }
        let named = |entries: Vec<(&str, Tree)>| {
            Tree::Keys(
                entries
                    .into_iter()
                    .map(|(key, value)| (key.to_owned(), value))
                    .collect(),
            )
        };
        (named(plant), named(gains))
    }

    fn state(&mut self, block: usize, channel: usize) -> Tree {
        let unit = self.units[block][channel];
        let initial = text(format!("0.01 {unit}"));
        match self.draw.below(4) {
            0 => keys([("initial", text("0.01")), ("unit", text(unit))]),
            1 => keys([
                ("initial", initial),
                (
                    "dispersion",
                    keys([(
                        "uniform",
                        Tree::List(vec![
                            text(format!("0 {unit}")),
                            text(format!("0.02 {unit}")),
                        ]),
                    )]),
                ),
            ]),
            2 => keys([
                ("initial", initial),
                (
                    "sensor",
                    keys([
                        ("noise", text(format!("0.001 {unit}"))),
                        ("dropout", text("0.01")),
                    ]),
                ),
            ]),
            _ => initial,
        }
    }

    fn input(&mut self, blocks: usize, channel: usize) -> Tree {
        let limit = text(format!("100 {}", self.units[blocks][channel]));
        match self.draw.below(3) {
            0 => keys([
                ("limit", limit),
                (
                    "actuator",
                    keys([("lag", text("5 ms")), ("delay", text("2 ms"))]),
                ),
            ]),
            _ => limit,
        }
    }

    fn disturb(
        &mut self,
        block: usize,
        width: usize,
        plant: &mut Vec<(&'static str, Tree)>,
        gains: &mut Vec<(&'static str, Tree)>,
    ) -> bool {
        let matrix = |rows: &[&[&str]]| {
            Tree::List(
                rows.iter()
                    .map(|row| Tree::List(row.iter().map(|&entry| text(entry)).collect()))
                    .collect(),
            )
        };
        match self.draw.below(3) {
            0 => {
                let rows = (0..width).map(|channel| {
                    text(format!(
                        "0.01 {}/s*sin(t/(1 s))",
                        self.units[block][channel]
                    ))
                });
                plant.push((
                    "disturbance",
                    keys([("bounded", Tree::List(rows.collect()))]),
                ));
                gains.extend([("eta_1", text("0.1")), ("observer", text("10"))]);
                true
            }
            1 => {
                let channel = keys([
                    ("M", matrix(&[&["-1"]])),
                    ("L", Tree::List(vec![text("1")])),
                ]);
                plant.push((
                    "disturbance",
                    keys([("exosystem", Tree::List(vec![channel; width]))]),
                ));
                let row = |at: usize| {
                    Tree::List(
                        (0..width)
                            .map(|column| text(if at == column { "3" } else { "0" }))
                            .collect(),
                    )
                };
                gains.extend([
                    ("eta_1", text("0.1")),
                    ("observer", Tree::List((0..width).map(row).collect())),
                ]);
                true
            }
            _ => false,
        }
    }

    fn shake(
        &mut self,
        block: usize,
        width: usize,
        disturbed: bool,
        plant: &mut Vec<(&'static str, Tree)>,
        gains: &mut Vec<(&'static str, Tree)>,
    ) {
        let per = if self.wiener { "sqrt(s)" } else { "s" };
        let rows = (0..width).map(|channel| {
            Tree::List(vec![text(format!(
                "0.01 {}/{per}",
                self.units[block][channel]
            ))])
        });
        plant.push((
            "noise",
            keys([
                ("effectiveness", Tree::List(rows.collect())),
                ("intensity", Tree::List(vec![text("1")])),
            ]),
        ));
        let phi = keys([
            ("initial", text("10")),
            ("kappa", text("2")),
            ("threshold", text("0.01")),
        ]);
        gains.push((
            "noise_bound",
            keys([
                ("tau", text("1")),
                ("lambda", text("0.1")),
                ("varsigma", text("1")),
                ("phi", phi),
            ]),
        ));
        if disturbed {
            gains.push(("eta_noise", text("0.1")));
        }
    }
}
