//! Results of the programs of `--math fast` against those of the strict ones.

use std::ops::Range;

use nsv_codegen::ir::Program;
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::{Arithmetic, optimise_with};

use crate::emitted::{Function, Module};
use crate::evaluated::Evaluated;
use crate::layout::results;
use crate::points::{Kind, Points};
use crate::work::share;

/// Differences of a result: those at states of the closed loop, and at all points.
#[derive(Clone, Default)]
struct Differences {
    flight: Vec<f64>,
    /// Half of the largest difference at states of the closed loop, and the largest entry there.
    absolute: [f64; 2],
    all: Vec<f64>,
    /// Points where the two differ in a truth value, in infinity or NaN.
    of_kind: u64,
}

/// A function in both arithmetics.
struct Pair<'p> {
    name: &'static str,
    places: Vec<(String, Range<usize>)>,
    evaluated: [Evaluated<'p>; 2],
    differences: Vec<Differences>,
}

impl<'p> Pair<'p> {
    fn new<F: Function>(points: &Points, programs: &'p [Program; 2]) -> Self {
        let places = results(&programs[0], &F::results());
        Pair {
            name: F::NAME,
            evaluated: [0, 1].map(|at| Evaluated::new(&programs[at], points.layout(), &places)),
            differences: vec![Differences::default(); places.len()],
            places,
        }
    }

    fn compare(&mut self, kind: Kind, point: &[f64]) {
        let size = self.places.last().map_or(0, |(_, place)| place.end);
        let [strict, fast] = &mut self.evaluated;
        let mut values = [vec![0.0; size], vec![0.0; size]];
        strict.run(point, &mut values[0]);
        fast.run(point, &mut values[1]);
        for ((name, place), differences) in self.places.iter().zip(&mut self.differences) {
            let [a, b] = [0, 1].map(|at| &values[at][place.clone()]);
            let truths = name == "violated" && a != b;
            let Some([off, largest]) = difference(a, b).filter(|_| !truths) else {
                differences.of_kind += 1;
                continue;
            };
            differences.all.push(places(off, largest));
            if kind == Kind::Flight {
                differences.flight.push(places(off, largest));
                let [most, scale] = differences.absolute;
                differences.absolute = [most.max(off), scale.max(largest)];
            }
        }
    }
}

/// Half of the largest difference of finite entries, since that of two finite numbers may overflow, and the largest of them; none if
/// others are not the same.
fn difference(strict: &[f64], fast: &[f64]) -> Option<[f64; 2]> {
    let (mut largest, mut off) = (0.0_f64, 0.0_f64);
    for (strict, fast) in strict.iter().zip(fast) {
        if strict.is_finite() && fast.is_finite() {
            largest = largest.max(strict.abs());
            off = off.max((strict / 2.0 - fast / 2.0).abs());
        } else if strict != fast && !(strict.is_nan() && fast.is_nan()) {
            return None;
        }
    }
    Some([off, largest])
}

/// A difference, of which half is given, in units of the last place of a number.
fn places(half: f64, number: f64) -> f64 {
    let place = number - number.next_down();
    if half == 0.0 { 0.0 } else { 2.0 * (half / place) }
}

/// Compares at `count` points and prints a Markdown table.
pub fn run<M: Module>(points: &Points, programs: &Programs, count: u64) {
    let both = [&programs.initial, &programs.control, &programs.plant, &programs.lyapunov]
        .map(|program| [Arithmetic::Strict, Arithmetic::Fast].map(|arithmetic| optimise_with(program.clone(), arithmetic)));
    let worker = || {
        [
            Pair::new::<M::Initial>(points, &both[0]),
            Pair::new::<M::Control>(points, &both[1]),
            Pair::new::<M::Plant>(points, &both[2]),
            Pair::new::<M::Lyapunov>(points, &both[3]),
        ]
    };
    let workers = share(points, count, worker, |pairs, portion| {
        for (kind, point) in portion.kinds.iter().zip(portion.points.chunks(points.layout().size())) {
            pairs.iter_mut().for_each(|pair| pair.compare(*kind, point));
        }
    });
    println!(
        "| spec | result | closed loop: median | 99.9 % | largest | of the loop's largest value | all points: largest | other truth, infinity or NaN |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut unchanged = Vec::new();
    for (at, pair) in workers[0].iter().enumerate() {
        for (result, (name, _)) in pair.places.iter().enumerate() {
            let of = |list: fn(&Differences) -> &Vec<f64>| {
                let mut all: Vec<f64> = workers.iter().flat_map(|pairs| list(&pairs[at].differences[result])).copied().collect();
                all.sort_by(f64::total_cmp);
                let last = all.len().saturating_sub(1);
                [0.5, 0.999, 1.0].map(|share| all.get(((all.len() as f64 * share) as usize).min(last)).copied().unwrap_or(0.0))
            };
            let (flight, [.., most]) = (of(|differences| &differences.flight), of(|differences| &differences.all));
            let of_kind: u64 = workers.iter().map(|pairs| pairs[at].differences[result].of_kind).sum();
            let text = format!("{}: {name}", pair.name);
            if most == 0.0 && of_kind == 0 {
                unchanged.push(text);
                continue;
            }
            let [median, nearly_all, largest] = flight.map(figure);
            let [off, scale] =
                [0, 1].map(|part| workers.iter().map(|pairs| pairs[at].differences[result].absolute[part]).fold(0.0, f64::max));
            let of_loop = figure(places(off, scale));
            println!("| {} | {text} | {median} | {nearly_all} | {largest} | {of_loop} | {} | {of_kind} |", M::NAME, figure(most));
        }
    }
    println!("\nThe same at every point: {}.", unchanged.join(", "));
}

/// Two digits.
fn figure(value: f64) -> String {
    if value < 100.0 { format!("{}", (10.0 * value).round() / 10.0) } else { format!("{value:.1e}") }
}
