//! The telemetry columns of the simulator: names, and the expressions of their values.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::emit::interface::Interface;
use crate::emit::names::ident;
use crate::emit::types::index;
use crate::ir::{Program, Shape};

/// A column.
pub(crate) struct Column {
    /// Name, such as `e1.alpha`.
    pub(crate) name: String,
    /// Value, in terms of `t`, `x1`, .., `law` (the controller's output), `rate` (the plant's), `lyapunov` and `self.state`.
    pub(crate) value: TokenStream,
}

/// The columns: time, then for each block states, errors, bound, ratio, virtual control, filter, disturbance and its estimate, then
/// reference, control and Lyapunov function, or the further states of the flown plant in its place. The first block has its tracking
/// error before e_1, and its ratio is that of the tracking error.
pub(crate) fn columns(
    interface: &Interface,
    control: &Program,
    initial: &Program,
    plant: &Program,
) -> Vec<Column> {
    let mut table = Table {
        columns: Vec::new(),
    };
    table.scalar("t", quote!(t));
    for (position, block) in interface.blocks.iter().enumerate() {
        let number = position + 1;
        let own: Vec<&str> = block
            .states
            .iter()
            .map(|state| state.name.as_str())
            .collect();
        let next = interface.blocks.get(position + 1);
        let next: Vec<&str> = next
            .into_iter()
            .flat_map(|block| &block.states)
            .map(|state| state.name.as_str())
            .collect();
        let named = |letters: &str| format!("{letters}{number}");
        let x = format_ident!("x{number}");
        table.vector(&named("x"), &own, &quote!(#x));
        if number == 1 {
            table.vector("error", &own, &quote!((x1 - law.y_r)));
        }
        table.output(control, &named("e"), &own, &quote!(law));
        table.output(control, &named("k"), &own, &quote!(law));
        if has(control, &named("k")) && has(control, &named("e")) {
            let (e, k) = (ident(&named("e")), ident(&named("k")));
            // The output's constraint is on the tracking error; e_1 lacks what the limits of the inputs keep it from.
            let e = match number {
                1 => quote!((x1 - law.y_r)),
                _ => quote!(law.#e),
            };
            table.scalar(&named("ratio"), quote!(#e.sum_squares().sqrt() / law.#k));
        }
        table.output(control, &named("alpha"), &next, &quote!(law));
        table.output(initial, &named("h"), &next, &quote!(self.state));
        table.output(plant, &named("d"), &own, &quote!(rate));
        table.output(control, &named("D_hat"), &own, &quote!(law));
    }
    let outputs = interface.blocks.first();
    let outputs: Vec<&str> = outputs
        .into_iter()
        .flat_map(|block| &block.states)
        .map(|state| state.name.as_str())
        .collect();
    let inputs: Vec<&str> = interface
        .inputs
        .iter()
        .map(|input| input.name.as_str())
        .collect();
    table.output(control, "y_r", &outputs, &quote!(law));
    table.output(control, "u", &inputs, &quote!(law));
    table.output(control, "u_sat", &inputs, &quote!(law));
    let mut first = 0;
    for block in &interface.blocks {
        for (at, state) in (first..).zip(&block.states) {
            if state.sensor.is_some() {
                let at = index(at);
                table.scalar(&format!("y.{}", state.name), quote!(self.y[#at]));
            }
        }
        first += block.states.len();
    }
    for (at, input) in interface.inputs.iter().enumerate() {
        if input.actuator.is_some() {
            let at = index(at);
            table.scalar(&format!("u_act.{}", input.name), quote!(self.u_act[#at]));
        }
    }
    match &interface.truth {
        // The function and its generator are those of the plant that the controller is designed on.
        None => {
            table.scalar("V", quote!(lyapunov.V));
            table.scalar("LV", quote!(lyapunov.LV));
        }
        Some(states) => {
            let first: usize = interface
                .blocks
                .iter()
                .map(|block| block.states.len())
                .sum();
            for (at, state) in (first..).zip(states) {
                let at = index(at);
                table.scalar(&format!("truth.{}", state.name), quote!(self.x[#at]));
            }
        }
    }
    table.columns
}

fn has(program: &Program, name: &str) -> bool {
    program.outputs.iter().any(|(output, _)| output == name)
}

struct Table {
    columns: Vec<Column>,
}

impl Table {
    fn scalar(&mut self, name: &str, value: TokenStream) {
        self.columns.push(Column {
            name: name.to_owned(),
            value,
        });
    }

    fn vector(&mut self, name: &str, channels: &[&str], value: &TokenStream) {
        for (position, channel) in channels.iter().enumerate() {
            let position = index(position);
            self.scalar(&format!("{name}.{channel}"), quote!(#value[#position]));
        }
    }

    /// Columns of a program's output, if it has that output.
    fn output(&mut self, program: &Program, name: &str, channels: &[&str], source: &TokenStream) {
        let Some((_, id)) = program.outputs.iter().find(|(output, _)| output == name) else {
            return;
        };
        let field = ident(name);
        match program.shape(*id) {
            Shape::Scalar => self.scalar(name, quote!(#source.#field)),
            _ => self.vector(name, channels, &quote!(#source.#field)),
        }
    }
}
