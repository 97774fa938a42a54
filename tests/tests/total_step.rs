//! A controller's step is total: whatever the measurements are, the control is finite and within its limits, and the states stay usable.

use nsv_codegen::ir::Values;
use nsv_runtime::noise::Noise;
use nsv_runtime::status::Status;
use nsv_tests::compiled::{Module, Sample, Sampled, modules};
use nsv_tests::points::points;

/// Numbers that a broken sensor may give.
const HOSTILE: [f64; 10] = [
    f64::MAX,
    f64::MIN,
    1e160,
    -1e80,
    1e12,
    -1e6,
    1e3,
    5e-324,
    -0.0,
    0.0,
];

/// The measurement where the scenario begins.
fn calm(module: &Module) -> Vec<f64> {
    let mut points = points(module.name).into_iter();
    let start = points.find(|point| point.label == "initial state of the scenario");
    let inputs = start.unwrap().inputs;
    let blocks = (1..).map_while(|block| inputs.get(&format!("x{block}")));
    blocks.flatten().copied().collect()
}

/// A controller after a calm start, and the time.
fn started(module: &Module) -> (Box<dyn Sampled>, f64) {
    let mut controller = (module.controller)();
    let calm = calm(module);
    for sample in 0..100 {
        let output = controller.step(f64::from(sample) * module.sample_time, &calm);
        check(module, &output, &controller.state());
        assert!(
            !output.status.contains(Status::NON_FINITE_INPUT),
            "{}, sample {sample}",
            module.name
        );
    }
    (controller, 100.0 * module.sample_time)
}

/// What holds after every step.
fn check(module: &Module, output: &Sample, state: &Values) {
    for ((u, u_sat), limit) in output.u.iter().zip(&output.u_sat).zip(module.limits) {
        assert!(
            u.is_finite() && u_sat.abs() <= *limit,
            "{}: {output:?}",
            module.name
        );
        assert_eq!(u.abs() > *limit, u != u_sat, "{}: {output:?}", module.name);
    }
    let saturated = output.u != output.u_sat;
    assert_eq!(
        output.status.contains(Status::SATURATED),
        saturated,
        "{}: {output:?}",
        module.name
    );
    for (name, value) in state {
        assert!(
            value.iter().all(|entry| entry.is_finite()),
            "{}: {name} = {value:?}",
            module.name
        );
        assert!(
            !name.starts_with("phi") || value[0] > 0.0,
            "{}: {name} = {value:?}",
            module.name
        );
    }
}

#[test]
fn a_broken_measurement_gives_the_safe_control_and_keeps_the_states() {
    for module in modules() {
        let (mut controller, t) = started(&module);
        let before = controller.state();
        let calm = calm(&module);
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut outputs = vec![controller.step(broken, &calm)];
            for channel in 0..calm.len() {
                let mut measured = calm.clone();
                measured[channel] = broken;
                outputs.push(controller.step(t, &measured));
            }
            for output in outputs {
                assert_eq!(output.status, Status::NON_FINITE_INPUT, "{}", module.name);
                assert_eq!(
                    (&output.u[..], &output.u_sat[..]),
                    (module.safe, module.safe),
                    "{}",
                    module.name
                );
                assert_eq!(controller.state(), before, "{}", module.name);
            }
        }
        let output = controller.step(t, &calm);
        assert!(
            !output.status.contains(Status::NON_FINITE_INPUT),
            "{}: the loop goes on",
            module.name
        );
    }
}

#[test]
fn a_controller_starts_with_the_first_finite_measurement() {
    for module in modules() {
        let mut late = (module.controller)();
        let broken = vec![f64::NAN; late.measured()];
        assert_eq!(late.step(0.0, &broken).status, Status::NON_FINITE_INPUT);
        let mut prompt = (module.controller)();
        let calm = calm(&module);
        assert_eq!(
            late.step(0.0, &calm),
            prompt.step(0.0, &calm),
            "{}",
            module.name
        );
        assert_eq!(late.state(), prompt.state(), "{}", module.name);
    }
}

/// One measurement far out of any flight can drive the states so far that the law overflows; the controller then starts anew
/// instead of refusing for good.
#[test]
fn an_overflow_is_not_for_good() {
    for (module, size) in modules()
        .iter()
        .flat_map(|module| SIZES.map(|size| (module, size)))
    {
        let (mut controller, start) = started(module);
        let calm = calm(module);
        controller.step(start, &vec![size; controller.measured()]);
        let mut refused = 0;
        for sample in 1..=200 {
            let t = start + f64::from(sample) * module.sample_time;
            let output = controller.step(t, &calm);
            check(module, &output, &controller.state());
            refused += u32::from(output.status.contains(Status::NON_FINITE_INPUT));
        }
        assert!(
            refused < 100,
            "{}: after {size:e}, refused {refused} of 200",
            module.name
        );
    }
}

/// From large to far beyond any flight.
const SIZES: [f64; 6] = [10.0, 1e3, 1e6, 1e12, 1e30, 1e60];

/// Thousands of steps with measurements from tiny to the largest numbers, among calm ones. Numbers far out of any flight can leave
/// states behind from which the law overflows for good; so each controller flies 20 samples.
#[test]
fn hostile_measurements_do_no_harm() {
    for module in modules() {
        let mut refused = 0;
        for flight in 0..200 {
            let (mut controller, t) = started(&module);
            let draw = Noise::process(7, flight);
            for step in 0..20 {
                let channels = (0..).take(controller.measured());
                let measured: Vec<f64> = channels
                    .map(|channel| measurement(&draw, step, channel))
                    .collect();
                let before = controller.state();
                let time = t + step as f64 * module.sample_time;
                let output = controller.step(time, &measured);
                check(&module, &output, &controller.state());
                if output.status.contains(Status::NON_FINITE_INPUT) {
                    assert_eq!(output.u_sat, module.safe, "{}", module.name);
                    let kept = controller.state() == before;
                    let origin = begun(&module, 0.0, &vec![0.0; measured.len()]);
                    assert!(
                        kept || controller.state() == origin,
                        "{}: a refusal keeps the states or, after an overflow, begins anew",
                        module.name
                    );
                    refused += 1;
                }
            }
        }
        assert!(
            (10..3990).contains(&refused),
            "{}: both kinds are met, {refused} refused",
            module.name
        );
    }
}

/// The states of a controller that begins with this measurement.
fn begun(module: &Module, t: f64, measured: &[f64]) -> Values {
    let mut controller = (module.controller)();
    controller.reset(t, measured);
    controller.state()
}

/// One in twenty is hostile, the others have magnitudes from 1e-4 to 10.
fn measurement(draw: &Noise, step: u64, channel: u32) -> f64 {
    let [kind, which, sign] = [0, 100, 200].map(|stream| draw.uniform(step, stream + channel));
    if kind < 0.05 {
        return HOSTILE[(which * HOSTILE.len() as f64) as usize];
    }
    libm::copysign(libm::pow(10.0, 5.0 * which - 4.0), sign - 0.5)
}
