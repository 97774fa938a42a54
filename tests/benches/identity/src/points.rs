//! Where functions are compared: states of a closed loop, values around them of many magnitudes, and what is likely to break code.

use std::f64::consts::{FRAC_PI_2, PI};

use nsv_codegen::lower::Programs;
use nsv_spec::model::Model;

use crate::draw::Draw;
use crate::emitted::{Function, Module};
use crate::flight::{Scalar, flights};
use crate::layout::{Layout, results};

/// What a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A state of the closed loop, with noise.
    Flight,
    /// Values of many magnitudes around one.
    Around,
    /// A state of the closed loop with some entries that are likely to break code.
    Adversarial,
}

/// Magnitudes of what is put in place of any entry.
const EXTREME: [f64; 16] = [
    0.0,
    5e-324,
    1e-310,
    2.2250738585072014e-308,
    1e-300,
    1e-160,
    1e-9,
    0.5,
    1.0,
    1e6,
    1e80,
    1e154,
    1e300,
    f64::MAX,
    f64::INFINITY,
    f64::NAN,
];

/// Where the points of a specification are drawn from.
pub struct Points {
    layout: Layout,
    seed: u64,
    /// States of the closed loop.
    flights: Vec<f64>,
    /// Pairs of neighbours, of which a control is at its limit in one and beyond it in the other.
    saturating: Vec<f64>,
    /// Of each constraint: its bound k at every state of the flights, and where e, what is followed, and zeta stand.
    constraints: Vec<Constraint>,
    /// ||e|| / k at which the barrier is clamped.
    clamp: f64,
}

/// A constraint ||e|| < k of a block, e = x - followed - zeta.
struct Constraint {
    /// k at every state of the flights.
    bound: Vec<f64>,
    x: usize,
    zeta: usize,
    /// What x follows at every state of the flights: reference, or filtered virtual control.
    followed: Vec<Vec<f64>>,
}

impl Points {
    /// The points of a module.
    pub fn new<M: Module>(model: &Model, programs: &Programs, layout: Layout, seed: u64) -> Self {
        let flights = flights::<M>(model, programs, &layout, seed);
        let mut control = Scalar::new::<M::Control>(results(&programs.control, &M::Control::results()));
        let mut points = Points {
            flights,
            seed,
            saturating: Vec::new(),
            constraints: Vec::new(),
            clamp: (1.0 - 2.0 * model.controller.barrier_margin / PI).sqrt().sqrt(),
            layout,
        };
        points.constraints = (1..=model.blocks.len()).filter_map(|i| points.constraint(i, &mut control)).collect();
        points.saturating = points.saturating(M::LIMITS, &mut control);
        points
    }

    /// The layout of a point.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Draws a point.
    pub fn draw(&self, index: u64, point: &mut [f64]) -> Kind {
        let mut draw = Draw::new(self.seed, index);
        let base = draw.below(self.flights.len() / self.layout.size());
        point.copy_from_slice(row(&self.flights, base, self.layout.size()));
        match index % 3 {
            0 => {
                jitter(&mut draw, point);
                Kind::Flight
            }
            1 => {
                scatter(&mut draw, point);
                Kind::Around
            }
            _ => {
                self.provoke(&mut draw, base, point);
                Kind::Adversarial
            }
        }
    }

    /// Puts a point of the flights next to what is likely to break code.
    fn provoke(&self, draw: &mut Draw, base: usize, point: &mut [f64]) {
        match draw.below(8) {
            0 | 1 => (0..=draw.below(3)).for_each(|_| place(draw, point)),
            2 => {
                let share = draw.of(&[0.05, 0.3, 1.0]);
                point.iter_mut().for_each(|entry| {
                    if draw.chance(share) {
                        *entry = extreme(draw);
                    }
                });
            }
            3 => {
                let share = draw.of(&[0.1, 1.0]);
                let range = if draw.chance(0.7) { self.layout.x.clone() } else { 0..point.len() };
                point[range].iter_mut().for_each(|entry| {
                    if draw.chance(share) {
                        *entry = angle(draw);
                    }
                });
            }
            4 => {
                let time = draw.below(60) as f64 / 2.0; // References switch at such times.
                point[0] = moved(draw, time);
            }
            5 if !self.saturating.is_empty() => {
                let size = self.layout.size();
                let pair = draw.below(self.saturating.len() / size);
                point.copy_from_slice(row(&self.saturating, pair, size));
            }
            _ if !self.constraints.is_empty() => {
                for constraint in &self.constraints {
                    if self.constraints.len() == 1 || draw.chance(0.7) {
                        self.approach(draw, constraint, base, point);
                    }
                }
            }
            _ => place(draw, point),
        }
        if draw.chance(0.2) {
            place(draw, point);
        }
    }

    /// Puts an error at its bound, at the clamp of the barrier, or at one of their neighbours.
    fn approach(&self, draw: &mut Draw, constraint: &Constraint, base: usize, point: &mut [f64]) {
        let followed = &constraint.followed[base];
        let ratio = draw.of(&[1.0, self.clamp, 1.0 - 1e-9, 1.0 + 1e-3, 0.99, 0.0, 2.0]);
        let axis = draw.below(followed.len());
        let spread = draw.chance(0.5);
        let share = if spread { 1.0 / (followed.len() as f64).sqrt() } else { 1.0 };
        for (j, followed) in followed.iter().enumerate() {
            // x - followed is 0 without rounding, so that e = -zeta.
            point[constraint.x + j] = *followed;
            let error = if spread || j == axis { ratio * share * constraint.bound[base] * draw.sign() } else { 0.0 };
            point[constraint.zeta + j] = moved(draw, error);
        }
    }

    /// The constraint of a block.
    fn constraint(&self, i: usize, control: &mut Scalar) -> Option<Constraint> {
        let (x, zeta) = (self.layout.input(&format!("x{i}"))?, self.layout.input(&format!("state.zeta{i}"))?);
        let filtered = self.layout.input(&format!("state.h{}", i.wrapping_sub(1)));
        let mut constraint = Constraint { bound: Vec::new(), x: x.start, zeta: zeta.start, followed: Vec::new() };
        for point in self.flights.chunks(self.layout.size()) {
            control.run(&self.layout, point);
            constraint.bound.push(control.result(&format!("k{i}"))?[0]);
            let followed = match &filtered {
                Some(range) => &point[range.clone()],
                None => control.result("y_r")?,
            };
            constraint.followed.push(followed.to_vec());
        }
        Some(constraint)
    }

    /// Moves the last measured states of points of the flights until a control leaves its limits, and halves that way down to neighbours.
    fn saturating(&self, limits: &[f64], control: &mut Scalar) -> Vec<f64> {
        let size = self.layout.size();
        let mut draw = Draw::new(self.seed, u64::MAX / 2);
        let last = (1..).map_while(|i| self.layout.input(&format!("x{i}"))).last().expect("there is a block");
        let mut found = Vec::new();
        for _ in 0..500 {
            let inside = row(&self.flights, draw.below(self.flights.len() / size), size).to_vec();
            let at = last.start + draw.below(last.len());
            let mut outside = inside.clone();
            outside[at] += draw.sign() * 10.0_f64.powf(6.0 * draw.uniform() - 3.0);
            let mut saturated = |point: &[f64]| {
                control.run(&self.layout, point);
                let u = control.result("u").expect("every law has it");
                u.iter().zip(limits).any(|(u, limit)| u.abs() > *limit)
            };
            if saturated(&inside) || !saturated(&outside) {
                continue;
            }
            for mut point in halved(inside, outside, at, saturated) {
                control.run(&self.layout, &point);
                point[self.layout.u_sat.clone()].copy_from_slice(control.result("u_sat").expect("every law has it"));
                found.extend(point);
            }
        }
        found
    }
}

/// Brings two points that differ in an entry together until that entry has neighbouring values.
fn halved(mut inside: Vec<f64>, mut outside: Vec<f64>, at: usize, mut is_outside: impl FnMut(&[f64]) -> bool) -> [Vec<f64>; 2] {
    loop {
        let middle = inside[at] + (outside[at] - inside[at]) / 2.0;
        if middle == inside[at] || middle == outside[at] {
            return [inside, outside];
        }
        let mut point = inside.clone();
        point[at] = middle;
        if is_outside(&point) { outside = point } else { inside = point }
    }
}

fn row(points: &[f64], index: usize, size: usize) -> &[f64] {
    &points[index * size..(index + 1) * size]
}

/// Moves every entry a little, from its last digits to a thousandth.
fn jitter(draw: &mut Draw, point: &mut [f64]) {
    let spread = draw.of(&[1e-15, 1e-9, 1e-6, 1e-3]);
    point.iter_mut().for_each(|entry| *entry *= 1.0 + spread * draw.normal());
}

/// Scales entries by powers of ten, from tenths of one to hundreds, and replaces some that are zero.
fn scatter(draw: &mut Draw, point: &mut [f64]) {
    let range = draw.of(&[0.1, 0.5, 1.0, 3.0, 10.0, 100.0]);
    let share = draw.of(&[0.05, 0.3, 1.0]);
    point.iter_mut().for_each(|entry| {
        if draw.chance(share) {
            let size = if *entry == 0.0 { draw.sign() } else { *entry };
            *entry = size * 10.0_f64.powf(range * (2.0 * draw.uniform() - 1.0));
        }
    });
}

/// Puts an extreme value in place of one entry.
fn place(draw: &mut Draw, point: &mut [f64]) {
    let at = draw.below(point.len());
    point[at] = extreme(draw);
}

fn extreme(draw: &mut Draw) -> f64 {
    draw.sign() * draw.of(&EXTREME)
}

/// A neighbour of a multiple of pi/2, or a huge angle.
fn angle(draw: &mut Draw) -> f64 {
    let largest = draw.of(&[1.0, 8.0, 1e3, 1e5, 1e9, 1e17, 1e300]);
    let multiple = (draw.uniform() * largest).round() * FRAC_PI_2;
    draw.sign() * moved(draw, multiple)
}

/// The value or a neighbour of it, up to three places away.
fn moved(draw: &mut Draw, value: f64) -> f64 {
    let places = draw.below(7) as i32 - 3;
    (0..places.abs()).fold(value, |value, _| if places > 0 { value.next_up() } else { value.next_down() })
}
