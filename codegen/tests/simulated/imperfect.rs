//! What lies between controller and plant, in a simulated run: actuator, sensors and further states do what the specification says.

use super::program::{campaign, check_campaign, flown};

const NAME: &str = "imperfect_plant";
/// Length of a plant step of it, s, and plant steps of a sample.
const STEP: f64 = 0.0005;
const SUBSTEPS: usize = 4;

fn mean(values: impl Iterator<Item = f64> + Clone) -> f64 {
    values.clone().sum::<f64>() / values.count() as f64
}

#[test]
fn the_actuator_lags_is_limited_rounded_delayed_and_fails_in_time() {
    let run = flown(NAME, 0, &[]);
    let (command, felt) = (&run["u_sat.torque"], &run["u_act.torque"]);
    let approach = 1.0 - f64::exp(-STEP / 0.005);
    let (mut position, mut delayed) = (0.0, [0.0; 2]);
    for (sample, pair) in felt.windows(2).enumerate() {
        let mut effect = 0.0;
        for substep in 0..SUBSTEPS {
            let t = run["t"][sample] + substep as f64 * STEP;
            let target = (delayed[0] / 0.01_f64).round_ties_even() * 0.01;
            delayed = [delayed[1], command[sample]];
            if t < 4.5 {
                position += (approach * (target - position)).clamp(-400.0 * STEP, 400.0 * STEP);
            }
            effect = if t < 3.0 { position } else { 0.8 * position };
        }
        assert!(
            (pair[1] - effect).abs() < 1e-9,
            "sample {sample}: {} {effect}",
            pair[1]
        );
    }
}

#[test]
fn sensors_are_biased_noisy_rounded_and_lose_samples() {
    let run = flown(NAME, 1, &[]);
    let (angle, measured) = (&run["x1.theta"], &run["y.theta"]);
    let quantum = 0.01_f64.to_radians();
    let whole = |value: &f64| (value / quantum - (value / quantum).round()).abs() < 1e-9;
    assert!(measured.iter().all(whole));
    let errors = measured.iter().zip(angle).map(|(y, x)| y - x);
    let bias = mean(errors.clone());
    assert!(
        bias != 0.0 && bias.abs() < 5.0 * 0.05_f64.to_radians(),
        "{bias}"
    );
    let spread = mean(errors.map(|error| (error - bias).powi(2))).sqrt();
    // A lost sample is off by what the angle moved since the last one, which adds a little.
    let noise = 0.02_f64.to_radians();
    assert!((0.9 * noise..2.0 * noise).contains(&spread), "{spread}");
    let errors = run["y.omega"]
        .iter()
        .zip(&run["x2.omega"])
        .map(|(y, x)| y - x);
    let count = angle.len() as f64;
    assert!((mean(errors.clone()) - 0.01).abs() < 5.0 * 0.01 / count.sqrt());
    let second = mean(errors.map(|error| (error - 0.01).powi(2)));
    assert!(
        (second / 1e-4 - 1.0).abs() < 5.0 * (2.0 / count).sqrt(),
        "{second}"
    );
}

#[test]
fn further_states_follow_their_rates() {
    let run = flown(NAME, 2, &[]);
    let (heat, wear) = (&run["truth.heat"], &run["truth.wear"]);
    assert!((10.0..30.0).contains(&heat[0]) && wear[0] == 0.0);
    for (heat, wear) in heat.windows(2).zip(wear.windows(2)) {
        let expected = 0.002 * 0.5 * (heat[0] + heat[1]) / 1e5;
        assert!(((wear[1] - wear[0]) / expected - 1.0).abs() < 1e-5);
    }
}

#[test]
fn a_run_of_a_campaign_is_the_run_alone_and_ideal_without_noise_and_dispersion() {
    check_campaign(NAME, &[]);
    let rows = campaign(NAME, &["--no-noise", "--no-dispersion"]);
    assert!(rows["ratio"].iter().all(|ratio| *ratio == rows["ratio"][0]));
}
