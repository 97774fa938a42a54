//! The committed code by names: each function of a generated module from [`Values`] to [`Values`], and its controller.
//!
//! A module's fields are listed once more, in `modules.rs`. A list that is not complete does not compile, and a name that differs from
//! the program's is a missing value in the tests.

use nsv_codegen::ir::Values;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::status::Status;

/// An emitted function, from inputs to outputs.
pub type Emitted = fn(&Values) -> Values;

/// A generated module.
pub struct Module {
    /// Its name.
    pub name: &'static str,
    /// The emitted functions by the names of their programs.
    pub functions: [(&'static str, Emitted); 4],
    /// A controller with design parameters.
    pub controller: fn() -> Box<dyn Sampled>,
    /// Magnitude limit of each control.
    pub limits: &'static [f64],
    /// Control while a measurement is not finite.
    pub safe: &'static [f64],
    /// Time between samples, s.
    pub sample_time: f64,
}

/// A generated controller.
pub trait Sampled {
    /// Starts anew from the measured states of all blocks, one after another.
    fn reset(&mut self, t: f64, measured: &[f64]);
    /// One sample at time `t` with the measured states of all blocks, one after another.
    fn step(&mut self, t: f64, measured: &[f64]) -> Sample;
    /// The states by name.
    fn state(&self) -> Values;
    /// Number of measured states.
    fn measured(&self) -> usize;
}

/// What a step gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// What happened.
    pub status: Status,
    /// Control before its limits.
    pub u: Vec<f64>,
    /// Control to apply.
    pub u_sat: Vec<f64>,
}

/// A value as its entries, row by row.
trait Flat {
    /// Number of entries.
    const SIZE: usize;
    fn read(data: &[f64]) -> Self;
    fn flat(&self) -> Vec<f64>;
}

impl Flat for f64 {
    const SIZE: usize = 1;
    fn read(data: &[f64]) -> Self {
        data[0]
    }
    fn flat(&self) -> Vec<f64> {
        vec![*self]
    }
}

impl Flat for bool {
    const SIZE: usize = 1;
    fn read(data: &[f64]) -> Self {
        data[0] != 0.0
    }
    fn flat(&self) -> Vec<f64> {
        vec![f64::from(u8::from(*self))]
    }
}

impl<const N: usize> Flat for Vector<f64, N> {
    const SIZE: usize = N;
    fn read(data: &[f64]) -> Self {
        Vector(data.try_into().unwrap())
    }
    fn flat(&self) -> Vec<f64> {
        self.0.to_vec()
    }
}

impl<const R: usize, const C: usize> Flat for Matrix<f64, R, C> {
    const SIZE: usize = R * C;
    fn read(data: &[f64]) -> Self {
        let (rows, rest) = data.as_chunks::<C>();
        assert!(rest.is_empty());
        Matrix::rows(rows.try_into().unwrap())
    }
    fn flat(&self) -> Vec<f64> {
        self.to_rows().as_flattened().to_vec()
    }
}

/// Takes the first entries off a list.
fn take<T: Flat>(data: &mut &[f64]) -> T {
    let (first, rest) = data.split_at(T::SIZE);
    *data = rest;
    T::read(first)
}

/// Defines a module of the same name, with the constant `MODULE` that describes it.
macro_rules! module {
    (
        $module:ident,
        params: [$($param:ident)*],
        measured: [$($x:ident)*],
        exosystems: [$($w:ident)*],
        initial: [$($last:ident)?],
        state: [$($state:ident)*],
        truths: [$($truth:ident)?],
        control: [$($control:ident)*],
        plant: [$($plant:ident)*]
    ) => {
        mod $module {
            use nsv_codegen::ir::Values;
            use nsv_generated::$module::controller::{self, Controller, ControlOutputs};
            use nsv_generated::$module::lyapunov::{self, LyapunovOutputs};
            use nsv_generated::$module::plant::{self, PlantOutputs};
            use nsv_generated::$module::{Params, State};

            use super::{Flat, Module, Sample, Sampled, take};

            fn input<T: Flat>(values: &Values, prefix: &str, name: &str) -> T {
                let name = format!("{prefix}{name}");
                T::read(values.get(&name).unwrap_or_else(|| panic!("input `{name}` is given")))
            }
            fn params(values: &Values, prefix: &str) -> Params<f64> {
                Params { $($param: input(values, prefix, stringify!($param))),* }
            }
            fn state(values: &Values) -> State<f64> {
                State { $($state: input(values, "state.", stringify!($state))),* }
            }
            fn states(prefix: &str, state: &State<f64>) -> Values {
                let State { $($state),* } = state;
                [$((format!("{prefix}{}", stringify!($state)), $state.flat())),*].into()
            }
            fn initial(values: &Values) -> Values {
                let t = input(values, "", "t");
                states("", &controller::initial(t, $(input(values, "", stringify!($x)),)* $(&$last(values, "params."))?))
            }
            fn control(values: &Values) -> Values {
                let (t, mut state, params) = (input(values, "", "t"), state(values), params(values, "params."));
                let outputs = controller::control(t, $(input(values, "", stringify!($x)),)* &mut state, &params);
                let ControlOutputs { $($truth,)? $($control),* } = outputs;
                let mut values = states("next.", &state);
                values.extend([$((stringify!($truth).to_owned(), $truth.flat()),)? $((stringify!($control).to_owned(), $control.flat())),*]);
                values
            }
            fn plant(values: &Values) -> Values {
                let (t, x, u_sat) = (input(values, "", "t"), input(values, "", "x"), input(values, "", "u_sat"));
                let PlantOutputs { $($plant),* } = plant::plant(t, x, u_sat, &params(values, "params."));
                [$((stringify!($plant).to_owned(), $plant.flat())),*].into()
            }
            fn lyapunov(values: &Values) -> Values {
                let (t, state) = (input(values, "", "t"), state(values));
                let LyapunovOutputs { V, LV } = lyapunov::lyapunov(
                    t,
                    $(input(values, "", stringify!($x)),)*
                    $(input(values, "", stringify!($w)),)*
                    &state,
                    &params(values, "params."),
                    &params(values, "plant."),
                );
                [("V".to_owned(), vec![V]), ("LV".to_owned(), vec![LV])].into()
            }

            impl Sampled for Controller<f64> {
                fn reset(&mut self, t: f64, mut measured: &[f64]) {
                    $(let $x = take(&mut measured);)*
                    self.reset(t, $($x),*);
                }
                fn step(&mut self, t: f64, mut measured: &[f64]) -> Sample {
                    $(let $x = take(&mut measured);)*
                    let output = self.step(t, $($x),*);
                    Sample { status: output.status, u: output.u.flat(), u_sat: output.u_sat.flat() }
                }
                fn state(&self) -> Values {
                    states("", self.state())
                }
                fn measured(&self) -> usize {
                    controller::INPUT_LIMIT.len() * [$(stringify!($x)),*].len()
                }
            }

            pub(super) const MODULE: Module = Module {
                name: stringify!($module),
                functions: [("initial", initial), ("control", control), ("plant", plant), ("lyapunov", lyapunov)],
                controller: || Box::new(Controller::new(Params::design())),
                limits: &controller::INPUT_LIMIT,
                safe: &controller::SAFE_INPUT,
                sample_time: controller::SAMPLE_TIME,
            };
        }
    };
}

include!("modules.rs");

/// Every generated module.
pub fn modules() -> [Module; 14] {
    [
        active_suspension::MODULE,
        chaotic_jerk::MODULE,
        flexible_joint::MODULE,
        ghv_unstable::MODULE,
        missile_pitch::MODULE,
        motor_arm::MODULE,
        nsv_attitude::MODULE,
        nsv_six_dof::MODULE,
        pendulum::MODULE,
        quadrotor::MODULE,
        six_joint_arm::MODULE,
        surface_vessel::MODULE,
        two_link_arm::MODULE,
        underwater_vehicle::MODULE,
    ]
}
