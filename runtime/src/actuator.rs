//! What happens to a command on its way to the plant: dead time, rounding, faults, rate limit, first-order lag.
//!
//! The controller knows nothing of it. An actuator moves once in each step of the plant, which sees it held over the step.

use crate::quantum::to_multiple;
use crate::real::Real;

/// A fault, from its time on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// Time, s.
    pub at: f64,
    /// What fails.
    pub effect: Effect,
}

/// What a fault does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Effect {
    /// Leaves this share of the effect on the plant.
    Effectiveness(f64),
    /// Holds the actuator where it stands.
    Stuck,
    /// Holds it at a position.
    StuckAt(f64),
}

/// An actuator after its dead time; what it lacks is neutral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Actuator {
    /// Commands are rounded to multiples of it; 0 for none.
    pub quantum: f64,
    /// Share of the way to the command that a step makes: 1 - exp(-h/T) with the lag T; 1 without lag.
    pub approach: f64,
    /// Longest way of a step; infinite without rate limit.
    pub travel: f64,
    /// What fails, in order of time.
    pub faults: &'static [Fault],
}

impl Actuator {
    /// The position after a step that starts at time `t`: towards the command, which is exact for a lag under a held command as long as
    /// the rate limit is not met.
    #[inline(always)]
    pub fn step<T: Real>(&self, t: f64, command: T, position: T) -> T {
        for fault in self.faults.iter().rev().filter(|fault| t >= fault.at) {
            match fault.effect {
                Effect::Stuck => return position,
                Effect::StuckAt(place) => return T::from_f64(place),
                Effect::Effectiveness(_) => {}
            }
        }
        let target = if self.quantum > 0.0 {
            to_multiple(command, self.quantum)
        } else {
            command
        };
        if self.approach == 1.0 && self.travel.is_infinite() {
            return target;
        }
        let mut way = target - position;
        if self.approach != 1.0 {
            way = way * T::from_f64(self.approach);
        }
        if self.travel.is_finite() {
            let travel = T::from_f64(self.travel);
            way = way.max(-travel).min(travel);
        }
        position + way
    }

    /// What the plant feels of a position at time `t`.
    #[inline(always)]
    pub fn effect<T: Real>(&self, t: f64, position: T) -> T {
        let mut effect = position;
        for fault in self.faults.iter().filter(|fault| t >= fault.at) {
            if let Effect::Effectiveness(share) = fault.effect {
                effect = position * T::from_f64(share);
            }
        }
        effect
    }
}

/// A dead time of N steps.
#[derive(Clone, Copy, Debug)]
pub struct Delay<T, const N: usize> {
    commands: [T; N],
    oldest: usize,
}

impl<T: Real, const N: usize> Delay<T, N> {
    /// Filled with a command.
    #[inline(always)]
    pub fn new(command: T) -> Self {
        Self {
            commands: [command; N],
            oldest: 0,
        }
    }

    /// Takes a command and gives the one of N steps ago.
    #[inline(always)]
    pub fn pass(&mut self, command: T) -> T {
        let delayed = self.commands[self.oldest];
        self.commands[self.oldest] = command;
        self.oldest = if self.oldest + 1 == N {
            0
        } else {
            self.oldest + 1
        };
        delayed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const IDEAL: Actuator = Actuator {
        quantum: 0.0,
        approach: 1.0,
        travel: f64::INFINITY,
        faults: &[],
    };

    #[test]
    fn an_ideal_actuator_is_where_it_is_told_to_be() {
        assert_eq!(IDEAL.step(0.0, 0.7, -3.0), 0.7);
        assert_eq!(IDEAL.effect(0.0, 0.7), 0.7);
    }

    #[test]
    fn a_lag_follows_a_held_command_exactly() {
        let (h, lag) = (0.01_f64, 0.2);
        let actuator = Actuator {
            approach: -(-h / lag).exp_m1(),
            ..IDEAL
        };
        let mut position = 0.0;
        for _ in 0..50 {
            position = actuator.step(0.0, 2.0, position);
        }
        let exact = 2.0 * (1.0 - (-0.5_f64 / lag).exp());
        assert!((position - exact).abs() < 1e-13, "{position} {exact}");
    }

    #[test]
    fn a_rate_limit_bounds_every_step_in_both_directions() {
        let actuator = Actuator {
            travel: 0.25,
            ..IDEAL
        };
        assert_eq!(actuator.step(0.0, 2.0, 0.0), 0.25);
        assert_eq!(actuator.step(0.0, -2.0, 0.0), -0.25);
        assert_eq!(actuator.step(0.0, 0.125, 0.0), 0.125);
    }

    #[test]
    fn commands_are_rounded_to_multiples() {
        let actuator = Actuator {
            quantum: 0.5,
            ..IDEAL
        };
        assert_eq!(actuator.step(0.0, 0.7, 0.0), 0.5);
        assert_eq!(actuator.step(0.0, -0.8, 0.0), -1.0);
    }

    #[test]
    fn faults_begin_at_their_time_and_the_last_one_counts() {
        let actuator = Actuator {
            faults: &[
                Fault {
                    at: 1.0,
                    effect: Effect::Effectiveness(0.5),
                },
                Fault {
                    at: 2.0,
                    effect: Effect::Stuck,
                },
                Fault {
                    at: 3.0,
                    effect: Effect::StuckAt(0.25),
                },
            ],
            ..IDEAL
        };
        assert_eq!(actuator.effect(0.9, 4.0), 4.0);
        assert_eq!(actuator.effect(1.0, 4.0), 2.0);
        assert_eq!(actuator.step(1.5, 4.0, 1.0), 4.0);
        assert_eq!(actuator.step(2.5, 4.0, 1.0), 1.0);
        assert_eq!(actuator.step(3.0, 4.0, 1.0), 0.25);
    }

    #[test]
    fn a_delay_gives_the_command_of_so_many_steps_ago() {
        let mut delay = Delay::<f64, 3>::new(9.0);
        let out: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 5.0].map(|command| delay.pass(command));
        assert_eq!(out, [9.0, 9.0, 9.0, 1.0, 2.0]);
    }
}
