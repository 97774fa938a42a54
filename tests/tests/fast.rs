//! What `--math fast` costs: results of the programs it gives against those of the strict ones, at every point of the reference.

use nsv_codegen::ir::eval::eval;
use nsv_codegen::ir::{Program, Values};
use nsv_codegen::opt::{Arithmetic, optimise, optimise_with};
use nsv_tests::points::{names, points};
use nsv_tests::specification::{compiled, named};

/// Largest difference of an entry to be accepted, in units of 2^-52 of the largest entry of its array. The law amplifies roundings: a
/// barrier near its bound by about a hundred, and a control that is the small difference of large terms by more; the largest found at
/// the points is 286, in a control at random states.
const UNITS: f64 = 1024.0;

/// The largest difference in those units, and the output that has it.
fn difference(strict: &Values, fast: &Values) -> (f64, String) {
    let mut worst = (0.0, String::new());
    for (name, strict) in strict {
        let size = strict.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let off = strict
            .iter()
            .zip(&fast[name])
            .fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
        let units = off / (size * f64::EPSILON).max(f64::MIN_POSITIVE);
        if off > 0.0 && units > worst.0 {
            worst = (units, name.clone());
        }
    }
    worst
}

#[test]
fn fast_arithmetic_changes_no_more_than_roundings() {
    for spec in names() {
        let (model, programs) = compiled(&named(&spec));
        for program in [programs.initial, programs.control, programs.plant] {
            let (name, strict): (String, Program) =
                (program.name.clone(), optimise(program.clone()));
            let fast = optimise_with(program, Arithmetic::Fast);
            let mut worst = (0.0, String::new());
            for point in points(&spec) {
                let values = point.values(&model, &point.params);
                let (strict, fast) = (eval(&strict, &values), eval(&fast, &values));
                let found = difference(&strict.unwrap(), &fast.unwrap());
                if found.0 > worst.0 {
                    worst = (found.0, format!("{} at {}", found.1, point.label));
                }
            }
            println!("{spec} {name}: {:.1} units, {}", worst.0, worst.1);
            assert!(worst.0 <= UNITS, "{spec} {name}: {worst:?}");
        }
    }
}
