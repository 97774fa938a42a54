//! `plant.rs`: drift and diffusion of the disturbed plant, as a function and as a stochastic differential equation.

use proc_macro2::TokenStream;
use quote::quote;

use nsv_spec::model::NoiseModel;

use crate::emit::comment::{Comments, code, docs};
use crate::emit::dispersion::draw;
use crate::emit::function::{Function, Record, Results};
use crate::emit::interface::Interface;
use crate::emit::literal::row;
use crate::emit::names::Fields;
use crate::emit::pieces::Split;
use crate::emit::polynomial::Library;
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
        let dynamics = Split::dynamics(&function);
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
    pub(super) fn held(&self) -> bool {
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
