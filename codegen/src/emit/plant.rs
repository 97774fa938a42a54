//! `plant.rs`: drift and diffusion of the disturbed plant, as a function and as a stochastic differential equation.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use nsv_spec::model::NoiseModel;

use crate::emit::comment::{Comments, code, docs};
use crate::emit::function::{Function, Record, Results};
use crate::emit::interface::Interface;
use crate::emit::literal::row;
use crate::emit::names::Fields;
use crate::emit::pieces::Split;
use crate::emit::polynomial::Library;
use crate::emit::types::index;
use crate::ir::{Program, Shape};

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
        };
        let mut items = self.constants();
        items.push(self.plant_struct());
        items.push(self.equation(&function));
        items.extend(Split::new(&function, "dynamics").items(comments));
        items
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
        let initial: Vec<f64> = blocks
            .clone()
            .flat_map(|block| block.states.iter().map(|state| state.initial))
            .collect();
        let exosystems = self
            .interface
            .blocks
            .iter()
            .flat_map(|block| block.exosystem.iter().copied());
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

    /// The entries of the packed state in words.
    fn layout(&self) -> String {
        let states = self.interface.blocks.iter().flat_map(|block| &block.states);
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

    fn plant_struct(&self) -> TokenStream {
        let inputs = index(self.interface.inputs.len());
        let (params_docs, u_docs) = (
            docs(&["Parameters."]),
            docs(&["Control, held between samples."]),
        );
        let held = self.held().then(|| {
            let docs = docs(&["Noise, standard normal, held between samples."]);
            quote!(#docs pub xi: Vector<T, NOISE_CHANNELS>,)
        });
        let docs = docs(&["The plant under a control that is held between samples."]);
        quote! {
            #docs
            #[derive(Clone, Copy, Debug)]
            pub struct Plant<T> {
                #params_docs
                pub params: Params<T>,
                #u_docs
                pub u_sat: Vector<T, #inputs>,
                #held
            }
        }
    }

    fn equation(&self, function: &Function<'_>) -> TokenStream {
        let channels = noise_channels(self.plant);
        let call = call(function);
        let drift = if self.held() {
            quote!(let rate = #call; rate.drift + rate.diffusion * self.xi)
        } else {
            quote!(#call.drift)
        };
        let wiener = channels > 0 && !self.held();
        let (columns, diffusion) = if wiener {
            (quote!(NOISE_CHANNELS), quote!(#call.diffusion))
        } else {
            let none = Literal::usize_unsuffixed(0);
            (quote!(#none), quote!(Matrix::zero()))
        };
        let (diffusion_t, diffusion_x) = if wiener {
            (quote!(t), quote!(x))
        } else {
            (quote!(_t), quote!(_x))
        };
        let arguments = function.arguments();
        let drift_t = if arguments.iter().any(|argument| argument == "t") {
            quote!(t)
        } else {
            quote!(_t)
        };
        let diffusion_t = if wiener { drift_t.clone() } else { diffusion_t };
        quote! {
            impl<T: Real> Sde<T, STATES, #columns> for Plant<T> {
                #[inline]
                fn drift(&self, #drift_t: T, x: &Vector<T, STATES>) -> Vector<T, STATES> { #drift }

                #[inline]
                fn diffusion(&self, #diffusion_t: T, #diffusion_x: &Vector<T, STATES>) -> Matrix<T, STATES, #columns> { #diffusion }
            }
        }
    }
}

fn call(function: &Function<'_>) -> TokenStream {
    let name = function.name();
    let arguments = function
        .arguments()
        .into_iter()
        .map(|argument| match argument.as_str() {
            "params" => quote!(&self.params),
            "u_sat" => quote!(self.u_sat),
            "x" => quote!(*x),
            _ => quote!(t),
        });
    quote!(#name(#(#arguments),*))
}
