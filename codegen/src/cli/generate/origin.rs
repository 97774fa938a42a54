//! Where in the specification a quantity of the law comes from.

use nsv_spec::diagnostic::Span;
use nsv_spec::model::{Block, Model};

/// Quantities of a block, `#` its number, with the key of the block that asks for them. What follows a whole name after `_`, such
/// as `_dot` or `_next`, is of the same origin.
const QUANTITIES: [(&str, &str); 65] = [
    ("F#", "drift"),
    ("x#", "drift"),
    ("G#", "gain"),
    ("G_norm2_#", "gain"),
    ("d#", "disturbance"),
    ("w#", "disturbance"),
    ("D#", "disturbance"),
    ("M#", "disturbance"),
    ("N#", "disturbance"),
    ("L#", "disturbance"),
    ("N_norm2_#", "disturbance"),
    ("L_norm2_#", "disturbance"),
    ("H#", "noise"),
    ("HSigma#", "noise"),
    ("H_norm2_#", "noise"),
    ("Ybar_square#", "noise"),
    ("Ybar_norm#", "noise"),
    ("k#", "constraint"),
    ("E#", "constraint"),
    ("cosE#", "constraint"),
    ("sec2E#", "constraint"),
    ("violated#", "constraint"),
    ("e#", "K"),
    ("s#", "K"),
    ("c#", "K"),
    ("s_c#", "K"),
    ("V_T#", "K"),
    ("Lam0_#", "K"),
    ("Lam#", "K"),
    ("bracket#", "K"),
    ("alpha#", "K"),
    ("Lam#_disturbance", "eta_1"),
    ("Lam#_filter", "eta_2"),
    ("Lam#_coupling", "eta_3"),
    ("Lam#_network", "network"),
    ("Lam#_error_bound", "error_bound"),
    ("Lam#_noise", "noise_bound"),
    ("Lam#_diffusion", "noise_bound"),
    ("z#", "network"),
    ("P#", "network"),
    ("W#", "network"),
    ("A_hat#", "network"),
    ("V_W#", "network"),
    ("S#", "observer"),
    ("SH#", "observer"),
    ("SH_norm2_#", "observer"),
    ("th#", "observer"),
    ("D_hat#", "observer"),
    ("w_hat#", "observer"),
    ("D_error#", "observer"),
    ("w_error#", "observer"),
    ("V_D#", "observer"),
    ("zeta#", "C"),
    ("V_zeta#", "C"),
    ("h#", "filter"),
    ("chi#", "filter"),
    ("V_chi#", "filter"),
    ("eps#", "error_bound"),
    ("V_eps#", "error_bound"),
    ("Psi#", "noise_bound"),
    ("s_scale#", "noise_bound"),
    ("sigma#", "noise_bound"),
    ("phi#", "noise_bound"),
    ("V_sigma#", "noise_bound"),
    ("V_phi#", "noise_bound"),
];

/// Where a quantity comes from.
pub(super) struct Origin {
    pub(super) span: Span,
    /// What is there, such as `attitude.drift`.
    pub(super) what: String,
}

/// The definition, the key of a block, the reference or the flown plant that a quantity comes from.
pub(super) fn origin(model: &Model, quantity: &str) -> Option<Origin> {
    let found = |span, what: &str| {
        let what = what.to_owned();
        Some(Origin { span, what })
    };
    let mut definitions = model.definitions.iter();
    if let Some(definition) = definitions.find(|known| known.name == quantity) {
        return found(definition.span, quantity);
    }
    let channel = |block: &&Block| block.states.iter().any(|state| state.name == quantity);
    if let Some(block) = model.blocks.iter().find(channel) {
        return found(block.span, &block.name);
    }
    if let Some(truth) = model.truth.as_ref().filter(|_| is_flown(quantity)) {
        return found(truth.span, "truth");
    }
    if rest(quantity, "y_r").is_some() {
        return found(model.reference_span, "reference");
    }
    if let Some(last) = model
        .blocks
        .last()
        .filter(|_| rest(quantity, "u").is_some())
    {
        return found(last.span, &last.name);
    }
    let known = QUANTITIES.iter().filter_map(|(pattern, key)| {
        let (number, length) = numbered(quantity, pattern)?;
        // (38) damps the coupling with the block outside, whose eta_3 it has.
        let outside = usize::from(*key == "eta_3");
        let block = model.blocks.get(number.checked_sub(1 + outside)?)?;
        Some((length, block, *key))
    });
    let (_, block, key) = known.max_by_key(|(length, ..)| *length)?;
    match block.keys.get(key) {
        Some(span) => found(*span, &format!("{}.{key}", block.name)),
        None => found(block.span, &block.name),
    }
}

/// Whether a quantity is a rate of the plant that is flown in place of the blocks.
fn is_flown(quantity: &str) -> bool {
    let flown = numbered(quantity, "x#_flown");
    flown.is_some() || quantity == "drift" || rest(quantity, "truth").is_some()
}

/// The number in a quantity of a pattern, and how much of the name the pattern takes.
fn numbered(quantity: &str, pattern: &str) -> Option<(usize, usize)> {
    let (stem, tail) = pattern.split_once('#')?;
    let numbered = quantity.strip_prefix(stem)?;
    let digits = numbered.bytes().take_while(u8::is_ascii_digit).count();
    let number = numbered[..digits].parse().ok()?;
    rest(&numbered[digits..], tail)?;
    Some((number, stem.len() + digits + tail.len()))
}

/// What follows a whole name.
fn rest<'q>(quantity: &'q str, name: &str) -> Option<&'q str> {
    let rest = quantity.strip_prefix(name)?;
    (rest.is_empty() || rest.starts_with('_')).then_some(rest)
}
