use core::array::from_fn;
use std::collections::BTreeSet;
use std::vec::Vec;

use super::{NORMAL, Noise};
use crate::lanes::{Kernel, Width, run, run_portable, run_portable_single, run_single};
use crate::linear::Vector;
use crate::real::Real;

#[test]
fn every_coordinate_of_a_cell_matters() {
    let far = 1 << 40;
    let of = |noise: Noise<f64>, purpose, step, cell| {
        noise.words(purpose, step, cell).map(|word| word as u32)
    };
    let words = |noise: Noise<f64>, step, cell| of(noise, noise.purpose as u32, step, cell);
    let draws = [
        words(Noise::process(1, 2), 3, 4),
        words(Noise::dispersion(1, 2), 3, 4),
        words(Noise::process(1 + far, 2), 3, 4),
        words(Noise::process(1, 2 + far), 3, 4),
        words(Noise::process(1, 2), 3 + far, 4),
        words(Noise::process(1, 2), 3, 5),
        words(Noise::process(1, 3), 2, 4),
        of(Noise::process(1, 2), NORMAL, 3, 4),
    ];
    assert_eq!(draws.iter().collect::<BTreeSet<_>>().len(), draws.len());
}

const DRAWS: u64 = 1_000_000;
const CHANNELS: usize = 8;

/// The mean of each of the functions over normal draws of consecutive steps.
fn means<T: Real, const F: usize>(seed: u64, f: impl Fn(f64) -> [f64; F]) -> [f64; F] {
    let noise = Noise::<T>::process(seed, 3);
    let mut means = [0.0; F];
    for step in 0..DRAWS / CHANNELS as u64 {
        for x in noise.normals::<CHANNELS>(step).0 {
            for (mean, value) in means.iter_mut().zip(f(x.to_f64())) {
                *mean += value / DRAWS as f64;
            }
        }
    }
    means
}

/// Within five standard errors of independent draws: right numbers fail once in 1.7 million checks.
fn check_mean(found: f64, exact: f64, variance: f64) {
    let error = (found - exact).abs();
    let standard_error = (variance / DRAWS as f64).sqrt();
    assert!(error < 5.0 * standard_error, "{found} for {exact}");
}

#[test]
fn truncated_normals_have_the_mean_of_the_truncated_distribution() {
    // Between -1 and 2: quantiles and densities of the standard normal distribution there (mpmath, 17 digits).
    let (low, high) = (0.158_655_253_931_457_05, 0.977_249_868_051_820_8);
    let (density_low, density_high) = (0.241_970_724_519_143_35, 0.053_990_966_513_188_05);
    let share = high - low;
    let exact = (density_low - density_high) / share;
    let second = 1.0 + (-density_low - 2.0 * density_high) / share;
    let noise = Noise::<f64>::dispersion(7, 3);
    let draws = (0..DRAWS).map(|step| noise.normal_between(step, 5, low, high));
    let (mut mean, mut square) = (0.0, 0.0);
    for draw in draws {
        assert!((-1.0 - 1e-15..=2.0 + 1e-15).contains(&draw));
        mean += draw / DRAWS as f64;
        square += draw * draw / DRAWS as f64;
    }
    check_mean(mean, exact, second - exact * exact);
    // The variance of the square is at most a quarter of the square of its range.
    check_mean(square, second, 4.0);
}

#[test]
fn normals_have_the_moments_of_the_normal_distribution() {
    let powers = |x: f64| [x, x * x, x * x * x, x * x * x * x];
    let found = [means::<f64, 4>(7, powers), means::<f32, 4>(7, powers)];
    for moments in found {
        check_mean(moments[0], 0.0, 1.0);
        check_mean(moments[1], 1.0, 2.0);
        check_mean(moments[2], 0.0, 15.0);
        check_mean(moments[3], 3.0, 96.0);
    }
}

#[test]
fn normals_have_the_tails_of_the_normal_distribution() {
    // Probabilities beyond 1, 2, 3 and 4 on one side.
    let tails = [
        0.15865525393145707,
        0.022750131948179212,
        0.0013498980316300957,
        3.167124183311996e-5,
    ];
    let is_beyond = |x: f64| [1.0, 2.0, 3.0, 4.0].map(|t| f64::from(u8::from(x > t)));
    let found = [
        means::<f64, 4>(13, is_beyond),
        means::<f64, 4>(13, |x| is_beyond(-x)),
        means::<f32, 4>(13, is_beyond),
        means::<f32, 4>(13, |x| is_beyond(-x)),
    ];
    for beyond in found {
        for (fraction, p) in beyond.into_iter().zip(tails) {
            check_mean(fraction, p, p * (1.0 - p));
        }
    }
}

#[test]
fn channels_and_steps_are_uncorrelated_and_so_are_their_squares() {
    let noise = Noise::<f64>::process(11, 0);
    let square = |x: f64| x * x - 1.0;
    let (mut products, mut of_squares) = ([0.0; 3], [0.0; 3]);
    for step in 0..DRAWS {
        let Vector([a, b, c]) = noise.normals::<3>(step);
        let next = noise.normal(step + 1, 0);
        for (i, (x, y)) in [(a, b), (b, c), (a, next)].into_iter().enumerate() {
            products[i] += x * y / DRAWS as f64;
            of_squares[i] += square(x) * square(y) / DRAWS as f64;
        }
    }
    for (product, of_squares) in products.into_iter().zip(of_squares) {
        check_mean(product, 0.0, 1.0);
        check_mean(of_squares, 0.0, 4.0);
    }
}

/// Draws of channels that fill several cells and leave one half empty, of runs whose numbers carry into their high word.
struct Draws;

const FIRST_RUN: u64 = (1 << 32) - 3;

impl Kernel for Draws {
    type Output = Vec<[f64; 15]>;

    #[inline(always)]
    fn run<T: Real>(self) -> Self::Output {
        let noise = Noise::<T>::process(5, FIRST_RUN);
        let Vector([a, b, c, d, e, f, g]) = noise.normals::<7>(9);
        let Vector([h, i, j, k, l, m, n]) = noise.normals_fused::<7>(9);
        let draws = [
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i,
            j,
            k,
            l,
            m,
            n,
            noise.uniform(9, 1),
        ];
        (0..T::LANES).map(|i| draws.map(|x| x.lane(i))).collect()
    }
}

fn one_by_one<T: Real>(lane: usize) -> [f64; 15] {
    let noise = Noise::<T>::process(5, FIRST_RUN + lane as u64);
    let fused = noise.normals_fused::<7>(9);
    from_fn(|draw| match draw {
        0..7 => noise.normal(9, draw as u32).to_f64(),
        7..14 => fused[draw - 7].to_f64(),
        _ => noise.uniform(9, 1).to_f64(),
    })
}

#[test]
fn fused_draws_differ_from_others_by_roundings_alone() {
    let noise = Noise::<f64>::process(5, 2);
    for step in 0..1000 {
        let (fused, separate) = (noise.normals_fused::<5>(step), noise.normals::<5>(step));
        // Both are within 2 epsilons of the radius and 2.5 of the sine, which at most the largest magnitude of a draw multiplies.
        let error = (fused - separate).abs().0.into_iter().fold(0.0, f64::max);
        assert!(error <= 9.0 * 9.0 * f64::EPSILON, "{error:e}");
    }
}

#[test]
fn lanes_draw_consecutive_runs() {
    let all = |draws: &Vec<_>, f: fn(usize) -> [f64; 15]| {
        assert_eq!(draws, &(0..draws.len()).map(f).collect::<Vec<_>>());
    };
    for draws in Width::ALL.iter().filter_map(|&width| run(width, Draws)) {
        all(&draws, one_by_one::<f64>);
    }
    let single = |&width| run_single(width, Draws);
    for draws in Width::ALL.iter().filter_map(single) {
        all(&draws, one_by_one::<f32>);
    }
    all(&run_portable(Draws), one_by_one::<f64>);
    all(&run_portable_single(Draws), one_by_one::<f32>);
}
