//! Uses the emitted module `pitch` as flight software and the runner would.

use emitted::pitch::controller::SAFE_INPUT;
use emitted::pitch::{Controller, Params, Simulator};
use emitted::{bare, wandering, wiener};
use nsv_runtime::closed_loop::{ClosedLoop, Options, Runs};
use nsv_runtime::linear::Vector;
use nsv_runtime::status::Status;

fn non_finite_input_leaves_the_states_alone() {
    let mut controller = Controller::new(Params::<f64>::design());
    let bad = controller.step(0.0, Vector([f64::NAN, 0.0]), Vector::zero());
    assert!(bad.status.contains(Status::NON_FINITE_INPUT));
    assert_eq!(bad.u_sat.0, SAFE_INPUT);
    let good = controller.step(0.002, Vector([0.01, 0.02]), Vector::zero());
    assert_eq!(good.status, Status::OK);
    let before = *controller.state();
    assert_eq!(
        controller
            .step(f64::INFINITY, Vector([0.01, 0.02]), Vector::zero())
            .u
            .0,
        SAFE_INPUT
    );
    assert_eq!(*controller.state(), before);
    let mut fresh = Controller::new(Params::<f64>::design());
    fresh.reset(0.002, Vector([0.01, 0.02]), Vector::zero());
    assert_eq!(
        fresh.step(0.002, Vector([0.01, 0.02]), Vector::zero()).u.0,
        good.u.0
    );
    assert_eq!(*fresh.state(), before);
}

fn events_are_reported() {
    let mut controller = Controller::new(Params::<f64>::design());
    let far = controller.step(0.0, Vector([5.0, 0.0]), Vector([3.0, 0.0]));
    assert_eq!(far.status, Status::CONSTRAINT_VIOLATED | Status::SATURATED);
    assert!(far.u_sat[0] > far.u[0]);
}

fn a_run_depends_on_its_seed_and_number_alone<L: ClosedLoop>() {
    let run = |seed, run, noise| {
        let mut simulator = L::Runs::<f64>::new(&Options {
            seed,
            run,
            noise,
            dispersion: true,
        });
        let mut row = vec![0.0; L::SIGNALS.len()];
        for _ in 0..100 {
            simulator.observe();
            simulator.control();
            simulator.telemetry(&mut row);
            simulator.advance();
        }
        assert!(simulator.is_finite());
        row.iter().map(|value| value.to_bits()).collect::<Vec<_>>()
    };
    assert_eq!(run(1, 2, true), run(1, 2, true));
    assert_ne!(run(1, 2, true), run(1, 3, true));
    assert_ne!(run(1, 2, true), run(1, 2, false));
}

fn a_bare_loop_decays() {
    let mut simulator = bare::Simulator::<f64>::new(&Options {
        seed: 1,
        run: 1,
        noise: true,
        dispersion: true,
    });
    assert!(simulator.constraint_ratio().is_nan());
    let mut error = [0.0];
    for _ in 0..1000 {
        simulator.control();
        simulator.advance();
    }
    simulator.tracking_error(&mut error);
    assert!((error[0] - 0.01 * f64::exp(-2.0)).abs() < 1e-5);
}

fn main() {
    non_finite_input_leaves_the_states_alone();
    events_are_reported();
    a_run_depends_on_its_seed_and_number_alone::<Simulator>();
    a_run_depends_on_its_seed_and_number_alone::<wiener::Simulator>();
    a_run_depends_on_its_seed_and_number_alone::<wandering::Simulator>();
    a_bare_loop_decays();
    println!("ok");
}
