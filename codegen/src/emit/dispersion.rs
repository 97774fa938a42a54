//! Draws from the distributions of a specification.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use nsv_spec::model::Dispersion;

use crate::emit::literal::float;

/// A draw of one quantity from `noise`, for the channel of its own.
pub(crate) fn draw(dispersion: &Dispersion, channel: usize) -> TokenStream {
    let channel_literal = Literal::usize_unsuffixed(channel);
    let real = |value: f64| {
        let value = float(value);
        quote!(T::from_f64(#value))
    };
    let uniform = quote!(noise.uniform(0, #channel_literal));
    let normal = quote!(noise.normal(0, #channel_literal));
    match dispersion {
        Dispersion::Uniform(least, largest) => {
            let (least, width) = (real(*least), {
                let (least, largest) = (float(*least), float(*largest));
                quote!(T::from_f64(#largest - #least))
            });
            quote!(#least + #width * #uniform)
        }
        Dispersion::Normal(mean, deviation) => {
            let (mean, deviation) = (real(*mean), real(*deviation));
            quote!(#mean + #deviation * #normal)
        }
        Dispersion::TruncatedNormal(cut) => {
            let (mean, deviation) = (real(cut.mean), real(cut.deviation));
            let (low, high) = (float(cut.quantiles.0), float(cut.quantiles.1));
            let (least, largest) = (real(cut.least), real(cut.largest));
            quote!((#mean + #deviation * noise.normal_between(0, #channel_literal, #low, #high)).max(#least).min(#largest))
        }
        Dispersion::Lognormal { median, sigma } => {
            let (median, sigma) = (real(*median), real(*sigma));
            quote!(#median * (#sigma * #normal).exp())
        }
        Dispersion::Discrete(values) => discrete(values, &uniform),
        Dispersion::Correlated { mean, factors } => {
            let mean = real(*mean);
            let terms = factors.iter().map(|(other, factor)| {
                let (other, factor) = (Literal::usize_unsuffixed(*other), real(*factor));
                quote!(#factor * noise.normal(0, #other))
            });
            quote!(#mean #(+ #terms)*)
        }
    }
}

/// The first value whose probabilities add up to more than the draw.
fn discrete(values: &[(f64, f64)], uniform: &TokenStream) -> TokenStream {
    let mut below = 0.0;
    let choices = values.iter().map(|&(value, probability)| {
        below += probability;
        (float(value), float(below))
    });
    let choices: Vec<(TokenStream, TokenStream)> = choices.collect();
    let (last, others) = choices.split_last().expect("invariant: a value");
    let last = &last.0;
    let chosen = others.iter().rev().fold(quote!(T::from_f64(#last)), |rest, (value, below)| {
        quote!(T::select(draw.lt(T::from_f64(#below)), T::from_f64(#value), #rest))
    });
    quote!({ let draw = #uniform; #chosen })
}

/// What the quantity is, for docs: `, dispersed ..`.
pub(crate) fn described(dispersion: Option<&Dispersion>) -> String {
    let Some(dispersion) = dispersion else {
        return String::new();
    };
    let text = match dispersion {
        Dispersion::Uniform(least, largest) => {
            format!("uniformly between {least:?} and {largest:?}")
        }
        Dispersion::Normal(mean, deviation) => {
            format!("normally with mean {mean:?} and standard deviation {deviation:?}")
        }
        Dispersion::TruncatedNormal(cut) => format!(
            "normally with mean {:?} and standard deviation {:?}, cut off at {:?} and {:?}",
            cut.mean, cut.deviation, cut.least, cut.largest
        ),
        Dispersion::Lognormal { median, sigma } => {
            format!(
                "lognormally with median {median:?} and standard deviation {sigma:?} of the logarithm"
            )
        }
        Dispersion::Discrete(values) => {
            let values = values
                .iter()
                .map(|(value, share)| format!("{value:?} with probability {share:?}"));
            format!("to {}", values.collect::<Vec<_>>().join(", "))
        }
        Dispersion::Correlated { mean, .. } => {
            format!("normally with mean {mean:?}, correlated with others")
        }
    };
    format!(", dispersed {text}")
}
