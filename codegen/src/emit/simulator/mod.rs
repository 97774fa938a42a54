//! `simulator.rs`: controller and plant in closed loop, one run of a campaign.

mod clocks;
mod hardware;
mod start;
mod telemetry;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

use nsv_spec::model::{NoiseModel, Scheme};

use crate::emit::comment::docs;
use crate::emit::function::Function;
use crate::emit::interface::Interface;
use crate::emit::literal::float;
use crate::emit::names::ident;
use crate::emit::pieces::Split;
use crate::emit::plant::noise_channels;
use crate::emit::source::mentions;
use crate::emit::types::index;
use crate::ir::Program;
use crate::opt::dependence::uses;
use hardware::Hardware;
use telemetry::{Column, columns};

/// What the simulator is made of.
pub(crate) struct Simulator<'a> {
    /// Names and values of the model.
    pub(crate) interface: &'a Interface,
    /// The programs' functions.
    pub(crate) plant: &'a Function<'a>,
    /// The pieces of the plant's function.
    pub(crate) dynamics: &'a Split<'a>,
    /// The pieces of the law.
    pub(crate) law: &'a Split<'a>,
    /// V and LV.
    pub(crate) lyapunov: &'a Function<'a>,
    /// Initial states of the controller, for their shapes.
    pub(crate) initial: &'a Program,
    /// The law, for its signals.
    pub(crate) control: &'a Function<'a>,
}

impl Simulator<'_> {
    /// The items of the file.
    pub(crate) fn items(&self) -> Vec<TokenStream> {
        let mut items = self.constants();
        items.extend(self.times());
        items.push(self.definition());
        items.push(self.methods());
        items.push(self.closed_loop());
        items
    }

    fn hardware(&self) -> Hardware<'_> {
        Hardware::new(self.interface)
    }

    fn channels(&self) -> usize {
        noise_channels(self.plant.program)
    }

    fn constants(&self) -> Vec<TokenStream> {
        let (horizon, substeps) = (
            float(self.interface.horizon),
            Literal::u32_unsuffixed(self.interface.substeps),
        );
        let horizon_docs = docs(&["Length of a run, s."]);
        let substeps_docs = docs(&["Plant steps per sample."]);
        let step_docs = docs(&["Length of a plant step, s."]);
        let own = [
            quote!(#horizon_docs pub const HORIZON: f64 = #horizon;),
            quote!(#substeps_docs pub const SUBSTEPS: u32 = #substeps;),
            quote!(#step_docs pub const SUBSTEP: f64 = SAMPLE_TIME / SUBSTEPS as f64;),
        ];
        own.into_iter().chain(self.hardware().constants()).collect()
    }

    fn definition(&self) -> TokenStream {
        let docs = docs(&["Runs of controller and plant, one in each lane."]);
        let clocks = self.clocks().into_iter().map(|(field, _)| field);
        let noise = (self.channels() > 0).then(|| quote!(noise: Option<Noise<T>>,));
        let prepared = (self.dynamics.prepare()).map(|_| quote!(prepared: plant::Prepared<T>,));
        let hardware = self.hardware().fields();
        quote! {
            #docs
            #[derive(Clone, Debug)]
            pub struct Simulator<T: Real = f64> {
                controller: Controller<T>,
                truth: Params<T>,
                #prepared
                x: Vector<T, STATES>,
                state: State<T>,
                output: Output<T>,
                sample: u64,
                #(#clocks,)*
                #noise
                #hardware
            }
        }
    }

    fn methods(&self) -> TokenStream {
        let mut start = 0;
        let mut segments = Vec::new();
        for (number, block) in (1..).zip(&self.interface.blocks) {
            segments.push(segment("x", number, start, block.states.len()));
            if self.hardware().senses() {
                segments.push(segment("y", number, start, block.states.len()));
            }
            start += block.states.len();
        }
        start += self.interface.further().len();
        for (number, block) in (1..)
            .zip(&self.interface.blocks)
            .filter(|(_, block)| !block.exosystem.is_empty())
        {
            // Only the Lyapunov function asks for them, which a truth has not.
            let asked = self.lyapunov.arguments().contains(&format!("w{number}"));
            if asked && self.interface.truth.is_none() {
                segments.push(segment("w", number, start, block.exosystem.len()));
            }
            start += block.exosystem.len();
        }
        let (time_docs, params_docs) = (
            docs(&["Time of the sample, s."]),
            docs(&["The plant's parameters in this run."]),
        );
        let (state_docs, output_docs) = (
            docs(&["The plant's state."]),
            docs(&["Output of the controller at the sample."]),
        );
        let normals = ident(if self.plant.program.fused {
            "normals_fused"
        } else {
            "normals"
        });
        let draw = (self.channels() > 0).then(|| {
            let docs =
                docs(&["Standard normal draws of all channels; zeros in a run without noise."]);
            quote! {
                #docs
                #[inline(always)]
                fn draw(&self, step: u64) -> Vector<T, NOISE_CHANNELS> {
                    match &self.noise {
                        Some(noise) => noise.#normals(step),
                        None => Vector::zero(),
                    }
                }
            }
        });
        let hardware = self.hardware().methods();
        quote! {
            impl<T: Real> Simulator<T> {
                #time_docs
                #[inline(always)]
                pub fn time(&self) -> f64 { sample_time(self.sample) }

                #params_docs
                #[inline(always)]
                pub fn params(&self) -> &Params<T> { &self.truth }

                #state_docs
                #[inline(always)]
                pub fn state(&self) -> &Vector<T, STATES> { &self.x }

                #output_docs
                #[inline(always)]
                pub fn output(&self) -> &Output<T> { &self.output }

                #(#segments)*

                #draw

                #hardware
            }
        }
    }

    fn closed_loop(&self) -> TokenStream {
        let name = &self.interface.name;
        let outputs = self
            .interface
            .blocks
            .first()
            .into_iter()
            .flat_map(|block| &block.states)
            .map(|state| &state.name);
        let inputs = self.interface.inputs.iter().map(|input| &input.name);
        let columns = columns(
            self.interface,
            self.control.program,
            self.initial,
            self.plant.program,
        );
        let signals = columns.iter().map(|column| &column.name);
        let (start, control, advance) = (self.start(), self.control(), self.advance());
        let (telemetry, queries) = (self.telemetry(&columns), self.queries());
        quote! {
            impl ClosedLoop for Simulator<f64> {
                const NAME: &'static str = #name;
                const SAMPLE_TIME: f64 = SAMPLE_TIME;
                const OUTPUTS: &'static [&'static str] = &[#(#outputs),*];
                const INPUTS: &'static [&'static str] = &[#(#inputs),*];
                const SIGNALS: &'static [&'static str] = &[#(#signals),*];

                type Runs<T: Real> = Simulator<T>;
            }

            impl<T: Real> Runs<T> for Simulator<T> {
                #start
                #control
                #advance
                #telemetry
                #queries
            }
        }
    }

    fn blocks(&self) -> Vec<proc_macro2::Ident> {
        (1..=self.interface.blocks.len())
            .map(|number| format_ident!("x{number}"))
            .collect()
    }

    fn control(&self) -> TokenStream {
        let senses = self.hardware().senses();
        let letter = if senses { "y" } else { "x" };
        let blocks: Vec<_> = (1..=self.interface.blocks.len())
            .map(|number| format_ident!("{letter}{number}"))
            .collect();
        let measure = senses.then(|| quote!(self.measure();));
        let (clock, step) = if self.law.shares_clock() {
            (
                quote!(let clock = self.clock.at(self.sample, sample_time);),
                quote!(self.controller.step_at(t, &clock, #(self.#blocks()),*)),
            )
        } else {
            (
                quote!(),
                quote!(self.controller.step(t, #(self.#blocks()),*)),
            )
        };
        quote! {
            #[inline(always)]
            fn observe(&mut self) {
                self.state = *self.controller.state();
            }

            #[inline(always)]
            fn control(&mut self) {
                let t = T::from_f64(self.time());
                #measure
                #clock
                self.output = #step;
            }
        }
    }

    /// The scheme that is emitted, and why it is not the one that is asked for. Platen's correction is a difference of the diffusion at two
    /// states, which is 0 where no state changes it: what remains is the scheme of Euler and Maruyama, without an evaluation for each channel.
    fn scheme(&self) -> (&'static str, Option<&'static str>) {
        let additive = !uses(self.plant.program, "diffusion", "x");
        match self.interface.scheme {
            Scheme::Platen if additive => (
                "EulerMaruyama",
                Some(
                    "Platen's scheme: no state changes the diffusion, so that its correction is 0 and the scheme of Euler and Maruyama is of strong order 1 too.",
                ),
            ),
            Scheme::Platen => ("Platen", None),
            Scheme::EulerMaruyama => ("EulerMaruyama", None),
            Scheme::RungeKutta4 => ("RungeKutta4", None),
        }
    }

    fn advance(&self) -> TokenStream {
        let (scheme, scheme_docs) = self.scheme();
        let scheme = ident(scheme);
        let scheme_docs = scheme_docs.map(|text| docs(&[text]));
        let noisy = self.channels() > 0;
        let held = (noisy && self.interface.noise == NoiseModel::Sampled)
            .then(|| quote!(, xi: self.draw(self.sample)));
        let draw = (noisy && self.interface.noise == NoiseModel::Wiener)
            .then(|| quote!(let dw = self.draw(step) * T::from_f64(SUBSTEP).sqrt();));
        let increment = match draw {
            Some(_) => quote!(&dw),
            None => quote!(&Vector([])),
        };
        let prepared = (self.dynamics.prepare()).map(|_| quote!(prepared: self.prepared,));
        let (at, stages) = self.stages();
        let step = quote! {
            #at
            #draw
            self.x = sde::step(Scheme::#scheme, &plant, #stages, &self.x, SUBSTEP, #increment);
        };
        let acts = self.hardware().acts();
        // What a step has its number for.
        let numbered = acts || draw.is_some() || at.is_some();
        let substep = if numbered { quote!(substep) } else { quote!(_) };
        let number = numbered
            .then(|| quote!(let step = self.sample * u64::from(SUBSTEPS) + u64::from(substep);));
        if acts {
            let xi = held.map(|_| quote!(let xi = self.draw(self.sample);));
            let held = xi.as_ref().map(|_| quote!(, xi));
            return quote! {
                #scheme_docs
                #[inline(always)]
                fn advance(&mut self) {
                    #xi
                    for substep in 0..SUBSTEPS {
                        #number
                        let plant = Plant { params: self.truth, #prepared u_sat: self.actuate(step_time(step)) #held };
                        #step
                    }
                    self.sample += 1;
                }
            };
        }
        quote! {
            #scheme_docs
            #[inline(always)]
            fn advance(&mut self) {
                let plant = Plant { params: self.truth, #prepared u_sat: self.output.u_sat #held };
                for #substep in 0..SUBSTEPS {
                    #number
                    #step
                }
                self.sample += 1;
            }
        }
    }

    fn telemetry(&self, columns: &[Column]) -> TokenStream {
        let values: Vec<&TokenStream> = columns.iter().map(|column| &column.value).collect();
        let body = quote!(#(#values),*);
        let mentioned = |name: &str| mentions(&body, name);
        let blocks = self.blocks();
        let plant = mentioned("rate").then(|| {
            let (name, arguments) = (self.plant.name(), self.arguments(self.plant));
            quote!(let rate = plant::#name(#(#arguments),*);)
        });
        let lyapunov = mentioned("lyapunov").then(|| {
            let (name, arguments) = (self.lyapunov.name(), self.arguments(self.lyapunov));
            let results = self.lyapunov.results_type();
            let fields = self.lyapunov.program.outputs.iter();
            let fields = fields.map(|(output, _)| {
                let field = self.lyapunov.output_fields().get(output).clone();
                quote!(#field: T::from_f64(f64::NAN))
            });
            quote! {
                let lyapunov = if T::IS_SCALAR {
                    lyapunov::#name(#(#arguments),*)
                } else {
                    lyapunov::#results { #(#fields),* }
                };
            }
        });
        quote! {
            #[inline(always)]
            fn telemetry(&self, row: &mut [T]) {
                let (t, law) = (T::from_f64(self.time()), &self.output);
                #(let #blocks = self.#blocks();)*
                #plant
                #lyapunov
                let values = [#body];
                row.copy_from_slice(&values);
            }
        }
    }

    /// Arguments of a program's function from the simulator's fields.
    fn arguments(&self, function: &Function<'_>) -> Vec<TokenStream> {
        let argument = |name: &String| match name.as_str() {
            "t" => quote!(t),
            "x" => quote!(self.x),
            "u_sat" => quote!(law.u_sat),
            "state" => quote!(&self.state),
            "plant" => quote!(&self.truth),
            "params" if function.name() == self.plant.name() => quote!(&self.truth),
            "params" => quote!(self.controller.params()),
            block if block.starts_with('x') => ident(block).to_token_stream(),
            exosystem => {
                let exosystem = ident(exosystem);
                quote!(self.#exosystem())
            }
        };
        function.arguments().iter().map(argument).collect()
    }

    fn queries(&self) -> TokenStream {
        let constrained = self
            .control
            .program
            .outputs
            .iter()
            .any(|(name, _)| name == "k1");
        let ratio = if constrained {
            quote!((self.x1() - self.output.y_r).sum_squares().sqrt() / self.output.k1)
        } else {
            quote!(T::from_f64(f64::NAN))
        };
        let inputs: Vec<_> = (0..self.interface.inputs.len()).map(index).collect();
        quote! {
            #[inline(always)]
            fn constraint_ratio(&self) -> T { #ratio }

            #[inline(always)]
            fn tracking_error(&self, error: &mut [T]) {
                error.copy_from_slice(&(self.x1() - self.output.y_r).0);
            }

            #[inline(always)]
            fn saturated(&self, saturated: &mut [T::Mask]) {
                saturated.copy_from_slice(&[#(self.output.u[#inputs].ne(self.output.u_sat[#inputs])),*]);
            }

            #[inline(always)]
            fn is_finite(&self) -> T::Mask {
                self.output.valid.and(self.x.is_finite())
            }
        }
    }
}

/// A method that gives part of the packed state.
fn segment(letter: &str, number: usize, start: usize, length: usize) -> TokenStream {
    let name = format_ident!("{letter}{number}");
    let (of, from) = match letter {
        "x" => ("State", quote!(x)),
        "y" => ("Measured state", quote!(y)),
        _ => ("Exosystem states", quote!(x)),
    };
    let docs = docs(&[format!("{of} of block {number}.")]);
    let entries = (start..start + length).map(index);
    let length = index(length);
    quote! {
        #docs
        #[inline(always)]
        fn #name(&self) -> Vector<T, #length> { Vector([#(self.#from[#entries]),*]) }
    }
}
