//! The gains of a block in words, for the rustdoc of the law: in its formulas they are numbers, folded with each other.

use nsv_spec::model::{Block, Disturbance, Exosystem, Matrix, PhiFloor};

/// What a law of `order` blocks uses of the gains of block `i`, with the symbols of its equations: `K = 1.5`, `kbar = 2`, ..
pub(crate) fn gains(i: usize, order: usize, block: &Block) -> Vec<String> {
    let mut list = vec![
        format!("K = {}", diagonal(&block.k)),
        format!("kbar = {}", number(block.kbar)),
        format!("C = {}", matrix(&block.c)),
    ];
    if let Some(filter) = &block.filter {
        list.push(format!("Fl = {} s", diagonal(filter)));
    }
    if let Some(observer) = &block.observer {
        list.push(format!("S = {}", matrix(observer)));
    }
    if let Disturbance::Exosystem(channels) = &block.disturbance {
        list.push(format!("M = {}", blocks(channels, |channel| &channel.m)));
        if channels.iter().any(|channel| channel.n.cols > 0) {
            list.push(format!("N = {}", blocks(channels, |channel| &channel.n)));
        }
        list.push(format!("L = {}", blocks(channels, |channel| &channel.l)));
    }
    if !matches!(block.disturbance, Disturbance::None) {
        list.push(format!("eta_1 = {}", number(block.eta_1)));
    }
    if i < order {
        list.push(format!("eta_2 = {}", number(block.eta_2)));
        list.push(format!("eta_3 = {}", number(block.eta_3)));
    }
    if let Some(network) = &block.network {
        let (gamma, lambda) = (number(network.gamma), number(network.lambda));
        list.push(format!("Gamma = {gamma}"));
        list.push(format!("lambda = {lambda}"));
        list.push(format!("iota = {}", diagonal(&network.iota)));
    }
    if let Some(bound) = &block.error_bound {
        let (rate, b) = (number(bound.rate), diagonal(&bound.b));
        list.push(format!("iota_0 = {rate}"));
        list.push(format!("b = {b}"));
    }
    if let Some(bound) = &block.noise_bound {
        if block.observer.is_some() {
            list.push(format!("eta_noise = {}", number(block.eta_noise)));
        }
        let values = [
            ("taubar", bound.tau),
            ("lambda_sigma", bound.lambda),
            ("varsigma", bound.varsigma),
            ("kappa_phi", bound.phi_kappa),
            ("iota_phi", bound.phi_threshold),
        ];
        list.extend(values.map(|(symbol, value)| format!("{symbol} = {}", number(value))));
        if let PhiFloor::Value(floor) = bound.phi_min {
            list.push(format!("phi_min = {}", number(floor)));
        }
    }
    list
}

/// A number as short as it can be read back.
fn number(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// The diagonal of a matrix, or its one value.
fn diagonal(values: &[f64]) -> String {
    let numbers: Vec<String> = values.iter().copied().map(number).collect();
    match numbers.as_slice() {
        [first, others @ ..] if others.iter().all(|other| other == first) => first.clone(),
        _ => format!("diag({})", numbers.join(", ")),
    }
}

/// A matrix with a block for each channel.
fn blocks(channels: &[Exosystem], of: impl Fn(&Exosystem) -> &Matrix) -> String {
    let blocks: Vec<String> = channels.iter().map(|channel| matrix(of(channel))).collect();
    match blocks.as_slice() {
        [block] => block.clone(),
        [block, others @ ..] if others.iter().all(|other| other == block) => {
            format!("{block} in each channel")
        }
        _ => format!("diag({})", blocks.join(", ")),
    }
}

/// A matrix, as its diagonal where there is nothing else.
fn matrix(matrix: &Matrix) -> String {
    let Matrix { rows, cols, data } = matrix;
    if data.is_empty() {
        return "0".to_owned();
    }
    let on_diagonal = |at: &usize| at / cols == at % cols;
    let other = (0..data.len()).filter(|at| !on_diagonal(at));
    if rows == cols && other.into_iter().all(|at| data[at] == 0.0) {
        let values = (0..data.len()).filter(on_diagonal).map(|at| data[at]);
        let shown = diagonal(&values.collect::<Vec<_>>());
        // One number for several rows is a multiple of the identity.
        return match shown.as_str() {
            "1" if *rows > 1 => "I".to_owned(),
            one if *rows > 1 && !one.starts_with("diag") => format!("{one} I"),
            _ => shown,
        };
    }
    let row = |row: &[f64]| {
        row.iter()
            .copied()
            .map(number)
            .collect::<Vec<_>>()
            .join(" ")
    };
    let rows: Vec<String> = data.chunks(*cols).map(row).collect();
    format!("({})", rows.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_are_as_short_as_they_can_be() {
        let of = |rows: usize, data: &[f64]| Matrix {
            rows,
            cols: data.len() / rows,
            data: data.to_vec(),
        };
        assert_eq!(matrix(&of(2, &[20.0, 0.0, 0.0, 20.0])), "20 I");
        assert_eq!(matrix(&of(2, &[1.0, 0.0, 0.0, 1.0])), "I");
        assert_eq!(matrix(&of(1, &[20.0])), "20");
        assert_eq!(matrix(&of(2, &[20.0, 0.0, 0.0, 1e-9])), "diag(20, 1e-9)");
        assert_eq!(matrix(&of(2, &[1.0, 0.5, 0.0, 1.0])), "(1 0.5; 0 1)");
        assert_eq!(matrix(&of(2, &[1.0, 2.5])), "(1; 2.5)");
        assert_eq!(matrix(&of(2, &[])), "0");
    }
}
