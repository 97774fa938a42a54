//! The law's quantities in words, for rustdoc and telemetry.

use crate::emit::comment::{code, prose};
use crate::emit::interface::Block;

/// A quantity's letters and block number: `D_hat1` is `("D_hat", 1)`, `u` is `("u", 0)`.
pub(crate) fn split(name: &str) -> (&str, usize) {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    (letters, name[letters.len()..].parse().unwrap_or(0))
}

/// What a controller state is.
pub(crate) fn describe(name: &str, blocks: &[Block]) -> String {
    let (letters, number) = split(name);
    let meaning = match letters {
        "th" => {
            "Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat"
        }
        "h" => "Filtered virtual control h (33)",
        "zeta" => "Auxiliary anti-windup state zeta (13)",
        "W" => "Network weights W_hat, one row per monomial and one column per channel",
        "eps" => "Bound eps_hat of the approximation error (66)",
        "sigma" => "Bound sigma_hat of the noise intensity (67)",
        "phi" => "Noise term phi (68), kept positive",
        _ => return format!("Controller state {}.", prose(name)),
    };
    let of = if letters == "h" {
        number.checked_add(1)
    } else {
        Some(number)
    };
    match of.and_then(|of| blocks.get(of.checked_sub(1)?)) {
        Some(block) => {
            let channels: Vec<String> = block
                .states
                .iter()
                .map(|state| prose(&state.name))
                .collect();
            format!(
                "{meaning}: {} ({}).",
                prose(&block.name),
                channels.join(", ")
            )
        }
        None => format!("{meaning}."),
    }
}

/// What an output without an equation of its own is.
pub(crate) fn output(name: &str) -> String {
    match name {
        "drift" => "Drift, the deterministic part of the rate of the packed state.".to_owned(),
        "diffusion" => "Diffusion, one column per noise channel.".to_owned(),
        "V" => "Lyapunov function.".to_owned(),
        "LV" => "Ito generator of the Lyapunov function (2).".to_owned(),
        _ => format!("{}.", code(name)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_split_into_letters_and_block() {
        assert_eq!(split("D_hat12"), ("D_hat", 12));
        assert_eq!(split("u"), ("u", 0));
        assert_eq!(split(""), ("", 0));
    }
}
