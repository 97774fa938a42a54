//! Times, and the values at them that all runs have in common.

use proc_macro2::TokenStream;
use quote::quote;

use nsv_spec::model::Scheme;

use super::Simulator;
use crate::emit::comment::docs;
use crate::emit::equation::Instant;

impl Simulator<'_> {
    /// Times by numbers.
    pub(super) fn times(&self) -> Vec<TokenStream> {
        let sample = docs(&["Time of a sample, s."]);
        let step = docs(&["Time of a step of the plant, s."]);
        let mut times = vec![quote! {
            #sample
            #[inline(always)]
            fn sample_time(sample: u64) -> f64 { sample as f64 * SAMPLE_TIME }
        }];
        if Instant::of(self.dynamics) != Instant::Nothing || self.hardware().acts() {
            times.push(quote! {
                #step
                #[inline(always)]
                fn step_time(step: u64) -> f64 {
                    let (sample, substep) = (step / u64::from(SUBSTEPS), step % u64::from(SUBSTEPS));
                    sample_time(sample) + substep as f64 * SUBSTEP
                }
            });
        }
        times
    }

    /// Fields for what all runs have in common, with their initial values.
    pub(super) fn clocks(&self) -> Vec<(TokenStream, TokenStream)> {
        let law = self.law.shares_clock().then(|| {
            (
                quote!(clock: Ahead<controller::Clock<T>>),
                quote!(clock: Ahead::new(sample_time)),
            )
        });
        let plant = (Instant::of(self.dynamics) == Instant::Clock).then(|| {
            if self.has_stages() {
                (
                    quote!(plant_clock: Stages<plant::Clock<T>>),
                    quote!(plant_clock: Stages::new(step_time, SUBSTEP)),
                )
            } else {
                (
                    quote!(plant_clock: Ahead<plant::Clock<T>>),
                    quote!(plant_clock: Ahead::new(step_time)),
                )
            }
        });
        law.into_iter().chain(plant).collect()
    }

    /// What a step of the plant takes of its times: the statement that gives it, and the instants of the scheme's stages.
    pub(super) fn stages(&self) -> (Option<TokenStream>, TokenStream) {
        match Instant::of(self.dynamics) {
            Instant::Nothing => (None, quote!([&(); 3])),
            Instant::Time => (
                Some(quote!(let at = sde::stages(step_time(step), SUBSTEP);)),
                quote!(at.each_ref()),
            ),
            Instant::Clock if self.has_stages() => (
                Some(quote!(let at = self.plant_clock.at(step, step_time, SUBSTEP);)),
                quote!(at.each_ref()),
            ),
            Instant::Clock => (
                Some(quote!(let at = self.plant_clock.at(step, step_time);)),
                quote!([&at; 3]),
            ),
        }
    }

    /// Whether the scheme asks for more than the start of a step.
    fn has_stages(&self) -> bool {
        self.interface.scheme == Scheme::RungeKutta4
    }
}
