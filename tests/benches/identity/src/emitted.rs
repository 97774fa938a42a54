//! The committed modules: each function from a point to its results, in numbers of any type.

use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::Real;

/// Inputs of the functions of a module, each list flat: vectors one after another, matrices row by row.
#[derive(Clone, Copy)]
pub struct Point<'a, T> {
    /// Time.
    pub t: T,
    /// State of the plant: measured states of all blocks, further states of a flown plant, exosystems.
    pub x: &'a [T],
    /// States of the exosystems.
    pub exosystems: &'a [T],
    /// States of the controller.
    pub state: &'a [T],
    /// Parameters: of the controller's design, or of the plant for `plant`.
    pub params: &'a [T],
    /// Parameters of the plant where those of the design are given too.
    pub plant: &'a [T],
    /// Control within its limits.
    pub u_sat: &'a [T],
}

/// An emitted function.
pub trait Function {
    /// Name of its program.
    const NAME: &'static str;
    /// Names of its results, in the order in which they are written.
    fn results() -> Vec<String>;
    /// Writes its results, flat.
    fn evaluate<T: Real>(point: Point<'_, T>, results: &mut Sink<'_, T>);
}

/// A generated module.
pub trait Module {
    /// Name of its specification.
    const NAME: &'static str;
    /// Names of the controller's states.
    const STATE: &'static [&'static str];
    /// Names of the parameters.
    const PARAMS: &'static [&'static str];
    /// State of the plant at the start.
    const INITIAL_STATE: &'static [f64];
    /// Magnitude limit of each control.
    const LIMITS: &'static [f64];
    /// Time between samples, s.
    const SAMPLE_TIME: f64;
    /// States of the controller at the first sample.
    type Initial: Function;
    /// Law and next states of the controller.
    type Control: Function;
    /// Rates of the plant.
    type Plant: Function;
    /// Lyapunov function and its generator.
    type Lyapunov: Function;
}

/// Where results are written.
pub struct Sink<'a, T> {
    /// Room for all of them.
    pub entries: &'a mut [T],
    /// Number of those written.
    pub written: usize,
}

impl<T: Real> Sink<'_, T> {
    #[inline(always)]
    fn entry(&mut self, entry: T) {
        self.entries[self.written] = entry;
        self.written += 1;
    }

    /// 1 for true, 0 for false, as the evaluator has it.
    #[inline(always)]
    fn truth(&mut self, mask: T::Mask) {
        self.entry(T::select(mask, T::one(), T::zero()));
    }
}

/// A value as its entries.
trait Flat<T>: Sized {
    /// Takes the first entries off a list.
    fn take(data: &mut &[T]) -> Self;
    fn put(&self, sink: &mut Sink<'_, T>);
}

impl<T: Real> Flat<T> for T {
    #[inline(always)]
    fn take(data: &mut &[T]) -> Self {
        let entry = data[0];
        *data = &data[1..];
        entry
    }

    #[inline(always)]
    fn put(&self, sink: &mut Sink<'_, T>) {
        sink.entry(*self);
    }
}

impl<T: Real, const N: usize> Flat<T> for Vector<T, N> {
    #[inline(always)]
    fn take(data: &mut &[T]) -> Self {
        let (entries, rest) = data.split_at(N);
        *data = rest;
        let mut vector = Self::zero();
        vector.0.copy_from_slice(entries);
        vector
    }

    #[inline(always)]
    fn put(&self, sink: &mut Sink<'_, T>) {
        let mut i = 0;
        while i < N {
            sink.entry(self.0[i]);
            i += 1;
        }
    }
}

impl<T: Real, const R: usize, const C: usize> Flat<T> for Matrix<T, R, C> {
    #[inline(always)]
    fn take(data: &mut &[T]) -> Self {
        let (entries, rest) = data.split_at(R * C);
        *data = rest;
        let mut rows = [[T::zero(); C]; R];
        let mut i = 0;
        while i < R {
            rows[i].copy_from_slice(&entries[i * C..(i + 1) * C]);
            i += 1;
        }
        Matrix::rows(rows)
    }

    #[inline(always)]
    fn put(&self, sink: &mut Sink<'_, T>) {
        let rows = self.to_rows();
        let mut i = 0;
        while i < R * C {
            sink.entry(rows[i / C][i % C]);
            i += 1;
        }
    }
}

/// Defines a module of the same name with its [`Module`], `Emitted`.
macro_rules! module {
    (
        $module:ident,
        params: [$($param:ident)*],
        measured: [$($x:ident)*],
        exosystems: [$($w:ident)*],
        initial: [$($last:ident)?],
        state: [$($state:ident)*],
        truths: [$($truth:ident)?],
        control: [u u_sat $($control:ident)*],
        plant: [$($plant:ident)*]
    ) => {
        #[doc = concat!("`nsv_generated::", stringify!($module), "`")]
        pub mod $module {
            use nsv_generated::$module::controller::{self, ControlOutputs};
            use nsv_generated::$module::lyapunov::{self, LyapunovOutputs};
            use nsv_generated::$module::plant::{self, PlantOutputs};
            use nsv_generated::$module::{Params, State};
            use nsv_runtime::real::Real;

            use super::{Flat, Function, Module, Point, Sink};

            /// The module.
            pub struct Emitted;
            /// Its `initial`.
            pub struct Initial;
            /// Its `control`.
            pub struct Control;
            /// Its `plant`.
            pub struct Plant;
            /// Its `lyapunov`.
            pub struct Lyapunov;

            impl Module for Emitted {
                const NAME: &'static str = stringify!($module);
                const STATE: &'static [&'static str] = &[$(stringify!($state)),*];
                const PARAMS: &'static [&'static str] = &[$(stringify!($param)),*];
                const INITIAL_STATE: &'static [f64] = &plant::INITIAL_STATE;
                const LIMITS: &'static [f64] = &controller::INPUT_LIMIT;
                const SAMPLE_TIME: f64 = controller::SAMPLE_TIME;
                type Initial = Initial;
                type Control = Control;
                type Plant = Plant;
                type Lyapunov = Lyapunov;
            }

            #[inline(always)]
            fn params<T: Real>(mut data: &[T]) -> Params<T> {
                Params { $($param: Flat::take(&mut data)),* }
            }

            #[inline(always)]
            fn state<T: Real>(mut data: &[T]) -> State<T> {
                State { $($state: Flat::take(&mut data)),* }
            }

            #[inline(always)]
            fn put_state<T: Real>(state: &State<T>, sink: &mut Sink<'_, T>) {
                let State { $($state),* } = state;
                $($state.put(sink);)*
            }

            impl Function for Initial {
                const NAME: &'static str = "initial";

                fn results() -> Vec<String> {
                    Emitted::STATE.iter().map(|name| (*name).to_owned()).collect()
                }

                #[inline(always)]
                fn evaluate<T: Real>(point: Point<'_, T>, results: &mut Sink<'_, T>) {
                    let mut x = point.x;
                    $(let $x = Flat::take(&mut x);)*
                    let state = controller::initial(point.t, $($x,)* $(&$last(point.params))?);
                    put_state(&state, results);
                }
            }

            impl Function for Control {
                const NAME: &'static str = "control";

                fn results() -> Vec<String> {
                    let signals = ["u", "u_sat", $(stringify!($truth),)? $(stringify!($control)),*].map(str::to_owned);
                    signals.into_iter().chain(Emitted::STATE.iter().map(|name| format!("next.{name}"))).collect()
                }

                #[inline(always)]
                fn evaluate<T: Real>(point: Point<'_, T>, results: &mut Sink<'_, T>) {
                    let mut x = point.x;
                    $(let $x = Flat::take(&mut x);)*
                    let mut state = state(point.state);
                    let outputs = controller::control(point.t, $($x,)* &mut state, &params(point.params));
                    let ControlOutputs { u, u_sat, $($truth,)? $($control),* } = outputs;
                    u.put(results);
                    u_sat.put(results);
                    $(results.truth($truth);)?
                    $($control.put(results);)*
                    put_state(&state, results);
                }
            }

            impl Function for Plant {
                const NAME: &'static str = "plant";

                fn results() -> Vec<String> {
                    [$(stringify!($plant)),*].map(str::to_owned).into()
                }

                #[inline(always)]
                fn evaluate<T: Real>(point: Point<'_, T>, results: &mut Sink<'_, T>) {
                    let (mut x, mut u_sat) = (point.x, point.u_sat);
                    let (x, u_sat) = (Flat::take(&mut x), Flat::take(&mut u_sat));
                    let PlantOutputs { $($plant),* } = plant::plant(point.t, x, u_sat, &params(point.params));
                    $($plant.put(results);)*
                }
            }

            impl Function for Lyapunov {
                const NAME: &'static str = "lyapunov";

                fn results() -> Vec<String> {
                    ["V", "LV"].map(str::to_owned).into()
                }

                #[inline(always)]
                fn evaluate<T: Real>(point: Point<'_, T>, results: &mut Sink<'_, T>) {
                    let mut x = point.x;
                    #[allow(unused_mut, unused_variables, reason = "not every plant has exosystems")]
                    let mut w = point.exosystems;
                    $(let $x = Flat::take(&mut x);)*
                    $(let $w = Flat::take(&mut w);)*
                    let (state, design, plant) = (state(point.state), params(point.params), params(point.plant));
                    let LyapunovOutputs { V, LV } = lyapunov::lyapunov(point.t, $($x,)* $($w,)* &state, &design, &plant);
                    V.put(results);
                    LV.put(results);
                }
            }
        }
    };
}

include!("../../../src/modules.rs");
