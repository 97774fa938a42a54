//! Numbers in emitted code: the shortest decimal that reads back as the same `f64`, named where `core` has a name for them.

use core::f64::consts;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::names::ident;

/// Numbers that `core::f64::consts` names, and that people would rather read by name; files import them from there.
pub(crate) const NAMED: [(f64, &str); 5] = [
    (consts::TAU, "TAU"),
    (consts::PI, "PI"),
    (consts::FRAC_PI_2, "FRAC_PI_2"),
    (consts::FRAC_PI_4, "FRAC_PI_4"),
    (consts::FRAC_1_PI, "FRAC_1_PI"),
];

/// An `f64` expression of exactly this value (the sign of zero included; every NaN is `f64::NAN`).
pub(crate) fn float(value: f64) -> TokenStream {
    if value.is_nan() {
        return quote!(f64::NAN);
    }
    let magnitude = magnitude(value.abs());
    if value.is_sign_negative() {
        quote!(-#magnitude)
    } else {
        magnitude
    }
}

fn magnitude(value: f64) -> TokenStream {
    if value == f64::INFINITY {
        return quote!(f64::INFINITY);
    }
    if let Some((_, name)) = NAMED.iter().find(|(named, _)| *named == value) {
        let name = ident(name);
        return quote!(#name);
    }
    let literal: Literal = format!("{value:?}")
        .parse()
        .expect("invariant: the debug form of a finite float is a literal");
    quote!(#literal)
}

/// `[a, b, ..]`.
pub(crate) fn row(values: &[f64]) -> TokenStream {
    let values = values.iter().copied().map(float);
    quote!([#(#values),*])
}

/// `[[a, b, ..], ..]` of row-major values.
pub(crate) fn rows(values: &[f64], columns: usize) -> TokenStream {
    let rows = values.chunks(columns).map(row);
    quote!([#(#rows),*])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_print_in_shortest_form() {
        let cases = [
            (1.5, "1.5"),
            (-0.0, "- 0.0"),
            (1e-310, "1e-310"),
            (1e300, "1e300"),
            (-2.5e-8, "- 2.5e-8"),
            (0.1 + 0.2, "0.30000000000000004"),
            (f64::NAN, "f64 :: NAN"),
            (f64::NEG_INFINITY, "- f64 :: INFINITY"),
            (consts::PI, "PI"),
        ];
        for (value, expected) in cases {
            assert_eq!(float(value).to_string(), expected);
        }
        assert_eq!(
            rows(&[1.0, 2.0, 3.0, 4.0], 2).to_string(),
            "[[1.0 , 2.0] , [3.0 , 4.0]]"
        );
    }

    #[test]
    fn numbers_read_back_bit_for_bit() {
        let mut bits: u64 = 0x9e37_79b9_7f4a_7c15;
        for _ in 0..20_000 {
            bits = bits
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let value = f64::from_bits(bits ^ (bits >> 31));
            if value.is_finite() {
                let text: String = float(value).to_string().replace(' ', "");
                assert_eq!(
                    text.parse::<f64>().map(f64::to_bits),
                    Ok(value.to_bits()),
                    "{text}"
                );
            }
        }
    }
}
