//! `plant.rs`: drift and diffusion of the disturbed plant, as a function and as a stochastic differential equation.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use nsv_spec::model::NoiseModel;

use crate::emit::comment::{Comments, code, docs};
use crate::emit::dispersion::draw;
use crate::emit::function::{Function, Record, Results};
use crate::emit::interface::Interface;
use crate::emit::literal::row;
use crate::emit::names::{Fields, ident};
use crate::emit::pieces::{Split, call_with};
use crate::emit::polynomial::Library;
use crate::emit::source::mentions;
use crate::emit::types::index;
use crate::ir::build::size;
use crate::ir::{Op, Program, Shape, ValueId};
use crate::opt::dependence::uses;
use crate::opt::hoist;

/// The plant's program and names.
pub(crate) struct Plant<'a> {
    /// Names and values of the model.
    pub(crate) interface: &'a Interface,
    /// Drift and diffusion.
    pub(crate) plant: &'a Program,
    /// Fields of `Params`.
    pub(crate) params: &'a Fields,
    /// Names of the polynomial functions.
    pub(crate) tables: &'a Library,
}

/// Number of noise channels: columns of the diffusion.
pub(crate) fn noise_channels(plant: &Program) -> usize {
    let diffusion = plant.outputs.iter().find(|(name, _)| name == "diffusion");
    match diffusion.map(|(_, id)| plant.shape(*id)) {
        Some(Shape::Matrix(_, columns)) => columns,
        _ => 0,
    }
}

impl Plant<'_> {
    /// The items of the file.
    pub(crate) fn items(&self, comments: &mut Comments) -> Vec<TokenStream> {
        let records = [Record {
            prefix: "params",
            ty: "Params",
            fields: self.params,
        }];
        let function_docs = ["Drift and diffusion of the plant and its disturbances.".to_owned()];
        let function = Function {
            program: self.plant,
            docs: &function_docs,
            records: &records,
            results: Results::Own,
            tables: self.tables,
            updates: None,
        };
        let dynamics = Split::new(&function, "dynamics");
        let mut items = self.constants();
        items.extend(self.dispersed_state());
        items.push(self.plant_struct(&dynamics));
        let diffusion = self.diffusion_alone(&dynamics);
        let alone = diffusion.as_ref().unwrap_or(dynamics.rest());
        items.push(self.equation(&dynamics, alone));
        items.extend(self.diffuse());
        items.extend(dynamics.items(comments));
        let docs = ["Diffusion of the plant and its disturbances.".to_owned()];
        items.extend(
            diffusion
                .iter()
                .flat_map(|diffusion| dynamics.part(diffusion, &docs, comments)),
        );
        items
    }

    /// The diffusion as a program of its own, if an integrator asks for it at other states than for the drift.
    fn diffusion_alone(&self, dynamics: &Split<'_>) -> Option<Program> {
        let again = !self.held() && uses(self.plant, "diffusion", "x");
        again.then(|| hoist::part(dynamics.rest(), "diffusion"))
    }

    /// Whether noise is held over a sample and so is part of the drift.
    fn held(&self) -> bool {
        self.interface.noise == NoiseModel::Sampled && noise_channels(self.plant) > 0
    }

    fn constants(&self) -> Vec<TokenStream> {
        let (states, noise) = (
            index(self.interface.plant_states()),
            index(noise_channels(self.plant)),
        );
        let blocks = self.interface.blocks.iter();
        let initial: Vec<f64> = (self.interface.states())
            .map(|state| state.initial)
            .collect();
        let exosystems = blocks.flat_map(|block| block.exosystem.iter().copied());
        let initial = row(&initial.into_iter().chain(exosystems).collect::<Vec<_>>());
        let states_docs = docs(&[self.layout()]);
        let noise_docs = docs(&["Number of noise channels."]);
        let initial_docs = docs(&["Initial state, SI."]);
        vec![
            quote!(#states_docs pub const STATES: usize = #states;),
            quote!(#noise_docs pub const NOISE_CHANNELS: usize = #noise;),
            quote!(#initial_docs pub const INITIAL_STATE: [f64; STATES] = #initial;),
        ]
    }

    /// The initial state where some of it is drawn in each run.
    fn dispersed_state(&self) -> Option<TokenStream> {
        let drawn = self
            .interface
            .states()
            .any(|state| state.dispersion.is_some());
        if !drawn {
            return None;
        }
        let first = self.interface.parameters.len();
        let drawn = self
            .interface
            .states()
            .enumerate()
            .filter_map(|(at, state)| {
                let (draw, at) = (draw(state.dispersion.as_ref()?, first + at), index(at));
                Some(quote!(x[#at] = #draw;))
            });
        let drawn: Vec<TokenStream> = drawn.collect();
        let docs = docs(&[
            "Initial state in each lane's run, drawn from the dispersions of the specification, SI.",
        ]);
        Some(quote! {
            #docs
            #[inline(always)]
            pub fn dispersed_state<T: Real>(noise: &Noise<T>) -> Vector<T, STATES> {
                let mut x = Vector::from_f64(INITIAL_STATE);
                #(#drawn)*
                x
            }
        })
    }

    /// The entries of the packed state in words.
    fn layout(&self) -> String {
        let states = self.interface.states();
        let names: Vec<String> = states
            .map(|state| format!("{} ({})", code(&state.name), state.unit))
            .collect();
        let exosystems = (1..)
            .zip(&self.interface.blocks)
            .filter(|(_, block)| !block.exosystem.is_empty());
        let exosystems = exosystems.map(|(number, block): (usize, _)| {
            format!(
                ", then {} states of the exosystems of block {number}",
                block.exosystem.len()
            )
        });
        format!(
            "Number of plant states: {}{}.",
            names.join(", "),
            exosystems.collect::<String>()
        )
    }

    fn plant_struct(&self, dynamics: &Split<'_>) -> TokenStream {
        let inputs = index(self.interface.inputs.len());
        let (params_docs, u_docs) = (
            docs(&["Parameters."]),
            docs(&["Control, held between samples."]),
        );
        let held = self.held().then(|| {
            let docs = docs(&["Noise, standard normal, held between samples."]);
            quote!(#docs pub xi: Vector<T, NOISE_CHANNELS>,)
        });
        let prepared = dynamics.prepare().map(|_| {
            let docs = docs(&["Values of [`prepare`] for these parameters."]);
            quote!(#docs pub prepared: Prepared<T>,)
        });
        let docs = docs(&["The plant under a control that is held between samples."]);
        quote! {
            #docs
            #[derive(Clone, Copy, Debug)]
            pub struct Plant<T> {
                #params_docs
                pub params: Params<T>,
                #prepared
                #u_docs
                pub u_sat: Vector<T, #inputs>,
                #held
            }
        }
    }

    /// The equation by `dynamics`, and by `alone` where the diffusion is all that is asked for.
    fn equation(&self, dynamics: &Split<'_>, alone: &Program) -> TokenStream {
        let (held, rate, alone_rate) = (
            self.held(),
            rate(dynamics, dynamics.rest()),
            rate(dynamics, alone),
        );
        let wiener = noise_channels(self.plant) > 0 && !held;
        let vector = quote!(Vector<T, STATES>);
        let columns = if wiener {
            quote!(NOISE_CHANNELS)
        } else {
            let none = Literal::usize_unsuffixed(0);
            quote!(#none)
        };
        let (drift_docs, drift) = if held {
            (
                "Drift, with the noise that is held between samples.",
                quote!(#rate rate.drift + diffuse(&rate.diffusion, &self.plant.xi)),
            )
        } else {
            ("Drift.", quote!(#rate rate.drift))
        };
        let ((time, t, given), (alone_time, alone_t, alone_given)) =
            (time_of(dynamics.rest()), time_of(alone));
        let (time, alone_time) = (time.as_ref(), alone_time.as_ref());
        let mut parts = vec![part("Drift", drift_docs, &vector, &drift, [time, None])];
        let diffusion = if wiener {
            let matrix = quote!(Matrix<T, STATES, NOISE_CHANNELS>);
            let both = quote!(#rate (rate.drift, diffuse(&rate.diffusion, self.dw)));
            parts.push(part(
                "Diffusion",
                "Diffusion.",
                &matrix,
                &quote!(#alone_rate rate.diffusion),
                [alone_time, None],
            ));
            parts.push(part(
                "Rates",
                "Drift, and diffusion times noise.",
                &quote!((#vector, #vector)),
                &both,
                [time, Some(&quote!(dw: &'a Vector<T, NOISE_CHANNELS>))],
            ));
            quote! {
                #[inline(always)]
                fn diffusion(&self, #alone_t: f64, x: &#vector) -> #matrix {
                    T::outlined(Diffusion { plant: self, #alone_given x })
                }

                #[inline(always)]
                fn drift_and_noise(&self, #t: f64, x: &#vector, dw: &Vector<T, NOISE_CHANNELS>) -> (#vector, #vector) {
                    T::outlined(Rates { plant: self, #given x, dw })
                }
            }
        } else {
            quote! {
                #[inline(always)]
                fn diffusion(&self, _t: f64, _x: &#vector) -> Matrix<T, STATES, #columns> { Matrix::zero() }
            }
        };
        quote! {
            impl<T: Real> Sde<T, STATES, #columns> for Plant<T> {
                #[inline(always)]
                fn drift(&self, #t: f64, x: &#vector) -> #vector {
                    T::outlined(Drift { plant: self, #given x })
                }

                #diffusion
            }

            #(#parts)*
        }
    }

    /// The product of the diffusion and noise. Which of its entries are zero is known, and so is that noise is finite.
    fn diffuse(&self) -> Option<TokenStream> {
        let (_, id) = self
            .plant
            .outputs
            .iter()
            .find(|(name, _)| name == "diffusion")?;
        let Shape::Matrix(_, columns) = self.plant.shape(*id) else {
            return None;
        };
        let is_zero = entries_zero(self.plant, *id);
        let rows = is_zero.chunks(columns).enumerate().map(|(row, is_zero)| {
            let row = index(row);
            let products = (0..columns)
                .filter(|&column| !is_zero[column])
                .map(|column| {
                    let column = index(column);
                    quote!(diffusion[(#row, #column)] * noise[#column])
                });
            let sum = products.reduce(|sum, product| quote!(#sum + #product));
            sum.unwrap_or_else(|| quote!(T::zero()))
        });
        let docs = docs(&["Diffusion times noise, without the entries that are always 0."]);
        Some(quote! {
            #docs
            #[inline(always)]
            fn diffuse<T: Real>(diffusion: &Matrix<T, STATES, NOISE_CHANNELS>, noise: &Vector<T, NOISE_CHANNELS>) -> Vector<T, STATES> {
                Vector([#(#rows),*])
            }
        })
    }
}

/// Whether each entry of an array is the literal 0.
fn entries_zero(program: &Program, array: ValueId) -> Vec<bool> {
    let zero = |entry: f64| entry == 0.0;
    match &program.instruction(array).op {
        Op::Const(data) => data.iter().map(|&entry| zero(entry)).collect(),
        Op::Array(items) => items
            .iter()
            .map(|&item| matches!(&program.instruction(item).op, Op::Const(data) if zero(data[0])))
            .collect(),
        _ => vec![false; size(program.shape(array))],
    }
}

/// A part of the plant's equation as a function of its own: an integrator asks for it several times in a step.
fn part(
    name: &str,
    about: &str,
    output: &TokenStream,
    body: &TokenStream,
    arguments: [Option<&TokenStream>; 2],
) -> TokenStream {
    let (name, docs) = (ident(name), docs(&[about]));
    let [t, noise] = arguments;
    let unused = (!mentions(body, "plant"))
        .then(|| quote!(#[allow(dead_code, reason = "a diffusion may need states alone")]));
    quote! {
        #docs
        #unused
        struct #name<'a, T> {
            plant: &'a Plant<T>,
            #t
            x: &'a Vector<T, STATES>,
            #noise
        }

        impl<T: Real> Part for #name<'_, T> {
            type Output = #output;

            #[inline(always)]
            fn run(self) -> #output { #body }
        }
    }
}

/// The field for the time of a part that calls a program, the parameter that gives it, and the argument: none if the program does not
/// read the time.
fn time_of(program: &Program) -> (Option<TokenStream>, TokenStream, TokenStream) {
    if reads_clock(program) || program.inputs.iter().any(|input| input.name == "t") {
        (Some(quote!(t: f64,)), quote!(t), quote!(t,))
    } else {
        (None, quote!(_t), quote!())
    }
}

/// Whether a program needs values of `clock`.
fn reads_clock(program: &Program) -> bool {
    let mut names = program.inputs.iter().map(|input| &input.name);
    names.any(|name| name.starts_with("clock."))
}

/// `let rate = ..;` of a part of the plant's equation, by a piece. A clock that depends on time alone serves all lanes.
fn rate(dynamics: &Split<'_>, piece: &Program) -> TokenStream {
    let clock = dynamics.clock().filter(|_| reads_clock(piece));
    let clock = clock.map(|clock| {
        let shared = clock.inputs.iter().all(|input| input.name == "t");
        let call = call_with(clock, |argument| match argument {
            "t" if shared => quote!(T::Scalar::from_f64(self.t)),
            other => self::argument(other),
        });
        if shared {
            quote!(let clock = Clock::splat(&#call);)
        } else {
            quote!(let clock = #call;)
        }
    });
    let call = call_with(piece, argument);
    quote!(#clock let rate = #call;)
}

/// An argument of the plant's functions inside a part of its equation.
fn argument(name: &str) -> TokenStream {
    match name {
        "t" => quote!(T::from_f64(self.t)),
        "params" => quote!(&self.plant.params),
        "prepared" => quote!(&self.plant.prepared),
        "clock" => quote!(&clock),
        "u_sat" => quote!(self.plant.u_sat),
        _ => quote!(*self.x),
    }
}
