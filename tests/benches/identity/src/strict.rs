//! Emitted code in every width of lanes, the evaluator on the optimised programs and on the lowered ones: all bits against scalar code.

use std::ops::Range;
use std::time::{Duration, Instant};

use nsv_codegen::ir::Program;
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::optimise;

use crate::emitted::{Function, Module};
use crate::evaluated::Evaluated;
use crate::lanes::Numbers;
use crate::layout::{Layout, results};
use crate::points::{Kind, Points};
use crate::work::{Portion, share};

/// Differences that are printed of each thread.
const SHOWN: usize = 5;

/// Results compared by one way of computing them.
#[derive(Clone, Default)]
pub struct Count {
    points: u64,
    values: u64,
    different: u64,
    time: Duration,
}

/// A function of a module with all ways to compute it.
struct Compared<'p> {
    name: &'static str,
    emitted: fn(Numbers, &Layout, &[f64], &mut [f64]),
    places: Vec<(String, Range<usize>)>,
    evaluated: [Evaluated<'p>; 2],
}

impl<'p> Compared<'p> {
    fn new<F: Function>(layout: &Layout, [optimised, lowered]: [&'p Program; 2]) -> Self {
        let places = results(optimised, &F::results());
        Compared {
            name: F::NAME,
            emitted: |numbers, layout, points, results| numbers.evaluate::<F>(layout, points, results),
            evaluated: [optimised, lowered].map(|program| Evaluated::new(program, layout, &places)),
            places,
        }
    }

    fn size(&self) -> usize {
        self.places.last().map_or(0, |(_, place)| place.end)
    }
}

/// What a thread has found.
struct Worker<'p> {
    functions: [Compared<'p>; 4],
    /// Of scalar code, each type of lanes, and the evaluator on optimised and lowered programs.
    counts: Vec<Count>,
    /// Points of each kind, and those of them whose results are all finite.
    kinds: [[u64; 2]; 3],
    limits: &'static [f64],
    /// Points where a constraint is violated, a control beyond its limit, and a control exactly at it.
    law: [u64; 3],
    shown: usize,
}

impl Worker<'_> {
    fn compare(&mut self, points: &Points, portion: &Portion<'_>, every: u64) {
        let (layout, size) = (points.layout(), points.layout().size());
        let count = portion.kinds.len();
        let lanes = Numbers::in_lanes();
        let mut finite = vec![true; count];
        for at in 0..self.functions.len() {
            let width = self.functions[at].size();
            let emitted = self.functions[at].emitted;
            let mut expected = vec![0.0; width * count];
            let start = Instant::now();
            emitted(Numbers::SCALAR, layout, portion.points, &mut expected);
            self.counts[0].time += start.elapsed();
            if self.functions[at].name == "control" {
                self.classify(at, &expected);
            }
            let mut found = vec![0.0; width * count];
            for (way, numbers) in (1..).zip(&lanes) {
                let start = Instant::now();
                emitted(*numbers, layout, portion.points, &mut found);
                self.counts[way].time += start.elapsed();
                for (point, (expected, found)) in expected.chunks(width).zip(found.chunks(width)).enumerate() {
                    self.check(way, at, portion, point, [expected, found]);
                }
            }
            for (point, expected) in expected.chunks(width).enumerate() {
                finite[point] &= expected.iter().all(|entry| entry.is_finite());
                if !((portion.first + point as u64) / 3).is_multiple_of(every) {
                    continue;
                }
                for stage in 0..2 {
                    let way = 1 + lanes.len() + stage;
                    let start = Instant::now();
                    self.functions[at].evaluated[stage].run(&portion.points[point * size..][..size], &mut found[..width]);
                    self.counts[way].time += start.elapsed();
                    self.check(way, at, portion, point, [expected, &found[..width]]);
                }
            }
        }
        for (kind, finite) in portion.kinds.iter().zip(finite) {
            let counts = &mut self.kinds[*kind as usize];
            counts[0] += 1;
            counts[1] += u64::from(finite);
        }
    }

    /// Counts what the law met.
    fn classify(&mut self, control: usize, results: &[f64]) {
        let places = &self.functions[control].places;
        let place = |name| places.iter().find(|(known, _)| known == name).map(|(_, place)| place);
        let (u, violated) = (place("u").expect("every law has it"), place("violated"));
        for results in results.chunks(self.functions[control].size()) {
            let limited = || results[u.clone()].iter().zip(self.limits);
            self.law[0] += u64::from(violated.is_some_and(|place| results[place.start] != 0.0));
            self.law[1] += u64::from(limited().any(|(u, limit)| u.abs() > *limit));
            self.law[2] += u64::from(limited().any(|(u, limit)| u.abs() == *limit));
        }
    }

    /// Counts results that differ in a bit, other than in the payload of NaN.
    fn check(&mut self, way: usize, function: usize, portion: &Portion<'_>, point: usize, [expected, found]: [&[f64]; 2]) {
        let count = &mut self.counts[way];
        // The first function of a point counts it.
        count.points += u64::from(function == 0);
        count.values += expected.len() as u64;
        let same = |at: &usize| expected[*at].to_bits() == found[*at].to_bits() || (expected[*at].is_nan() && found[*at].is_nan());
        let mut differences = (0..expected.len()).filter(|at| !same(at));
        let Some(first) = differences.next() else { return };
        count.different += 1 + differences.count() as u64;
        if self.shown < SHOWN {
            self.shown += 1;
            let compared = &self.functions[function];
            let (name, place) = compared.places.iter().find(|(_, place)| place.contains(&first)).expect("it is a result");
            eprintln!(
                "{} by {}: {name}[{}] is {:e} ({:#x}), scalar {:e} ({:#x}), at point {} ({:?})",
                compared.name,
                ways()[way],
                first - place.start,
                found[first],
                found[first].to_bits(),
                expected[first],
                expected[first].to_bits(),
                portion.first + point as u64,
                portion.kinds[point]
            );
        }
    }
}

/// What is compared.
fn ways() -> Vec<String> {
    let lanes = Numbers::in_lanes();
    let emitted = [Numbers::SCALAR].iter().chain(&lanes).map(Numbers::to_string);
    emitted.chain(["evaluator".to_owned(), "evaluator, lowered".to_owned()]).collect()
}

/// Compares at `count` points, the evaluator at each group of three kinds whose number is a multiple of `every`. Prints rows of a
/// Markdown table; whether all bits agree.
pub fn run<M: Module>(points: &Points, programs: &Programs, count: u64, every: u64) -> bool {
    let lowered = [&programs.initial, &programs.control, &programs.plant, &programs.lyapunov];
    let optimised = lowered.map(|program| optimise(program.clone()));
    let layout = points.layout();
    let worker = || Worker {
        functions: [
            Compared::new::<M::Initial>(layout, [&optimised[0], lowered[0]]),
            Compared::new::<M::Control>(layout, [&optimised[1], lowered[1]]),
            Compared::new::<M::Plant>(layout, [&optimised[2], lowered[2]]),
            Compared::new::<M::Lyapunov>(layout, [&optimised[3], lowered[3]]),
        ],
        counts: vec![Count::default(); ways().len()],
        kinds: [[0; 2]; 3],
        limits: M::LIMITS,
        law: [0; 3],
        shown: 0,
    };
    let start = Instant::now();
    let workers = share(points, count, worker, |worker, portion| worker.compare(points, &portion, every));
    report(M::NAME, &workers, start.elapsed())
}

fn report(name: &str, workers: &[Worker<'_>], elapsed: Duration) -> bool {
    let kinds: Vec<String> = [Kind::Flight, Kind::Around, Kind::Adversarial]
        .iter()
        .map(|kind| {
            let [all, finite] = [0, 1].map(|at| workers.iter().map(|worker| worker.kinds[*kind as usize][at]).sum::<u64>());
            format!("{:?} {all}, of which {:.1} % finite", kind, 100.0 * finite as f64 / all as f64)
        })
        .collect();
    let [violated, beyond, exactly] = [0, 1, 2].map(|at| workers.iter().map(|worker| worker.law[at]).sum::<u64>());
    println!("{name}: {}", kinds.join("; "));
    println!("a constraint violated at {violated}, a control beyond its limit at {beyond}, exactly at it at {exactly}");
    println!("{:.0} s by two threads\n", elapsed.as_secs_f64());
    println!("| spec | against emitted scalar code | points | results | different bits | us per point |\n|---|---|---|---|---|---|");
    let mut same = true;
    for (way, text) in ways().iter().enumerate() {
        let sum = |of: fn(&Count) -> u64| workers.iter().map(|worker| of(&worker.counts[way])).sum::<u64>();
        let time: Duration = workers.iter().map(|worker| worker.counts[way].time).sum();
        let (points, values, different) = (sum(|count| count.points), sum(|count| count.values), sum(|count| count.different));
        let cost = 1e6 * time.as_secs_f64() / points as f64;
        if way > 0 {
            println!("| {name} | {text} | {points} | {values} | {different} | {cost:.1} |");
        }
        same &= different == 0;
    }
    same
}
