//! How a run starts: what is drawn, the initial state, the controller's first measurement.

use proc_macro2::TokenStream;
use quote::quote;

use super::Simulator;
use crate::emit::pieces::call_with;
use crate::emit::types::index;

impl Simulator<'_> {
    /// `new`.
    pub(super) fn start(&self) -> TokenStream {
        let hardware = self.hardware();
        let initial = self.initial_state();
        let noisy = self.channels() > 0;
        let process =
            noisy.then(|| quote!(let process = Noise::process(options.seed, options.run);));
        let noise = noisy.then(|| quote!(noise: options.noise.then_some(process),));
        let prepared = self.dynamics.prepare().map(|prepare| {
            let call = call_with(prepare, |_| quote!(&truth));
            quote!(prepared: plant::#call,)
        });
        let hardware_fields = hardware.initial();
        let from = if hardware.senses() {
            quote!(runs.y)
        } else {
            quote!(x)
        };
        let measured = self.segments_of(&from);
        let measured: Vec<TokenStream> = measured.collect();
        let clocks = self.clocks().into_iter().map(|(_, initial)| initial);
        let fields = quote!(#prepared controller, truth, x, state, output: Output::zero(), sample: 0, #(#clocks,)* #noise #hardware_fields);
        let (controller, made) = if hardware.senses() {
            let start = quote! {
                let controller = Controller::new(Params::design());
                let state = *controller.state();
            };
            let made = quote! {
                let mut runs = Self { #fields };
                runs.measure();
                runs.controller.reset(T::zero(), #(#measured),*);
                runs
            };
            (start, made)
        } else {
            let start = quote! {
                let mut controller = Controller::new(Params::design());
                controller.reset(T::zero(), #(#measured),*);
                let state = *controller.state();
            };
            (start, quote!(Self { #fields }))
        };
        quote! {
            #[inline(always)]
            fn new(options: &Options) -> Self {
                let truth = if options.dispersion {
                    Params::dispersed(&Noise::dispersion(options.seed, options.run))
                } else {
                    Params::plant()
                };
                let x = #initial;
                #controller
                #process
                #made
            }
        }
    }

    fn initial_state(&self) -> TokenStream {
        let dispersed = self
            .interface
            .states()
            .any(|state| state.dispersion.is_some());
        if dispersed {
            quote! {
                if options.dispersion {
                    plant::dispersed_state(&Noise::dispersion(options.seed, options.run))
                } else {
                    Vector::from_f64(INITIAL_STATE)
                }
            }
        } else {
            quote!(Vector::from_f64(INITIAL_STATE))
        }
    }

    /// The state of each block as entries of a packed state.
    fn segments_of(&self, x: &TokenStream) -> impl Iterator<Item = TokenStream> {
        let mut start = 0;
        self.interface.blocks.iter().map(move |block| {
            let entries = (start..start + block.states.len()).map(index);
            start += block.states.len();
            quote!(Vector([#(#x[#entries]),*]))
        })
    }
}
