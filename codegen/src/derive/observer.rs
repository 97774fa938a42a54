//! Disturbance observers: compound (20) (21) for `bounded`, exosystem (49) (50).

use nsv_spec::model::{Block, Disturbance, Exosystem, Matrix};

use super::law::Law;
use super::symbol::{Symbol, name};
use crate::ir::Shape;

/// M, N and L of a block's exosystems, block-diagonal; N without its zero columns.
pub(crate) struct Assembled {
    /// M.
    pub m: Matrix,
    /// N, states by excited channels.
    pub n: Matrix,
    /// L, block width by states.
    pub l: Matrix,
}

/// The number of the equation of th_i'.
pub(super) fn rate_equation(block: &Block) -> &'static str {
    match block.disturbance {
        Disturbance::Exosystem(_) => "(50)",
        _ => "(21)",
    }
}

impl Law<'_> {
    /// D_hat_i.
    pub(super) fn define_estimate(&mut self, i: usize, block: &Block) {
        let Some(s) = &block.observer else { return };
        let (observed, equation) = match block.disturbance {
            Disturbance::Exosystem(_) => (format!("e{i}"), "(49)"),
            _ => (format!("x{i}"), "(20)"),
        };
        self.group(format!("disturbance observer of block {i} {equation}"));
        let doc = format!("observer state of block {i} {}", rate_equation(block));
        // The first estimate is zero.
        let initial = -self.observed(i, s, name(observed));
        let th = self.state(format!("th{i}"), Shape::Vector(s.rows), doc, initial);
        match &block.disturbance {
            Disturbance::None => {}
            Disturbance::Bounded(_) => {
                let x = name(format!("x{i}"));
                let estimate = th + self.observed(i, s, x);
                self.define(
                    format!("D_hat{i}"),
                    format!("D_hat_{i} = th_{i} + S_{i} x_{i}"),
                    estimate,
                );
            }
            Disturbance::Exosystem(channels) => {
                let e = name(format!("e{i}"));
                let estimate = th + self.observed(i, s, e);
                let w = self.define(
                    format!("w_hat{i}"),
                    format!("w_hat_{i} = th_{i} + S_{i} e_{i}"),
                    estimate,
                );
                let l = self.constant(format!("L{i}"), &format!("L_{i}"), &assemble(channels).l);
                self.define(
                    format!("D_hat{i}"),
                    format!("D_hat_{i} = L_{i} w_hat_{i}"),
                    l.times(w),
                );
            }
        }
    }

    /// th_i'.
    pub(super) fn define_observer_rate(&mut self, i: usize, block: &Block) {
        let Some(s) = &block.observer else { return };
        self.group(format!(
            "observer dynamics of block {i} {}",
            rate_equation(block)
        ));
        let last = i == self.order();
        let known = name(format!("F{i}"));
        let known = if block.network.is_some() {
            known + name(format!("A_hat{i}"))
        } else {
            known
        };
        let g = name(format!("G{i}"));
        match &block.disturbance {
            Disturbance::None => {}
            Disturbance::Bounded(_) => {
                let next = if last {
                    name("u_sat")
                } else {
                    name(format!("x{}", i + 1))
                };
                let flow = name(format!("D_hat{i}")) + known + g.times(next);
                let rate = -self.observed(i, s, flow);
                self.define(format!("th{i}_dot"), compound_rate(i, last), rate);
            }
            Disturbance::Exosystem(channels) => {
                let parts = assemble(channels);
                if last {
                    return self.define_last_observer_rate(i, s, &parts.m);
                }
                let next = name(format!("x{}", i + 1)) - name(format!("zeta{}", i + 1));
                let flow = known + g.times(next) - self.reference_rate(i) + self.leak(i, block);
                let closed = closed_observer(s, &parts);
                let closed = self.constant(
                    format!("w{i}_closed"),
                    &format!("M_{i} - S_{i} L_{i}"),
                    &closed,
                );
                let rate = closed.times(name(format!("w_hat{i}"))) - self.observed(i, s, flow);
                let text = format!(
                    "th_{i}' = (M_{i} - S_{i} L_{i}) w_hat_{i} - S_{i} (F_{i} + G_{i} v_{i} - h_{}' + C_{i} zeta_{i} + A_hat_{i})  (50)",
                    i - 1
                );
                self.define(format!("th{i}_dot"), text, rate);
            }
        }
    }

    /// th_n' of an exosystem. The control (64) makes F + A_hat + G u - h' + C zeta = -(D_hat + Lam), and D_hat = L w_hat, so (50) with
    /// v_n = u is M w_hat + S Lam: the large terms that cancel in the sum are never formed.
    fn define_last_observer_rate(&mut self, i: usize, s: &Matrix, m: &Matrix) {
        let free = self.gain(
            format!("M{i}"),
            &format!("M_{i}"),
            m,
            name(format!("w_hat{i}")),
        );
        let rate = free + self.observed(i, s, name(format!("Lam{i}")));
        let text = format!(
            "th_{i}' = (M_{i} - S_{i} L_{i}) w_hat_{i} - S_{i} (F_{i} + G_{i} u - h_{}' + C_{i} zeta_{i} + A_hat_{i}) (50) = M_{i} w_hat_{i} + S_{i} Lam_{i}, \
             since the sum in brackets is -(D_hat_{i} + Lam_{i}) under (64)",
            i - 1
        );
        self.define(format!("th{i}_dot"), text, rate);
    }

    /// S_i times a vector.
    fn observed(&mut self, i: usize, s: &Matrix, of: Symbol) -> Symbol {
        self.gain(format!("S{i}"), &format!("S_{i}, observer gain"), s, of)
    }
}

/// The rate of a compound observer (21), in words.
pub(super) fn compound_rate(i: usize, last: bool) -> String {
    let next = match last {
        true => "sat(u)".to_owned(),
        false => format!("x_{}", i + 1),
    };
    format!("th_{i}' = -S_{i} (D_hat_{i} + F_{i} + G_{i} {next} + A_hat_{i})")
}

/// Block-diagonal M, N, L of one exosystem per channel.
pub(crate) fn assemble(channels: &[Exosystem]) -> Assembled {
    let m = block_diagonal(channels.iter().map(|channel| channel.m.clone()));
    let n = block_diagonal(channels.iter().map(|channel| excited(&channel.n)));
    let l = block_diagonal(channels.iter().map(|channel| channel.l.clone()));
    Assembled { m, n, l }
}

/// M - S L, the dynamics of the estimation error.
pub(crate) fn closed_observer(s: &Matrix, parts: &Assembled) -> Matrix {
    subtract(&parts.m, &product(s, &parts.l))
}

/// Without the columns that are zero.
fn excited(n: &Matrix) -> Matrix {
    let kept: Vec<usize> = (0..n.cols)
        .filter(|col| (0..n.rows).any(|row| n.data[row * n.cols + col] != 0.0))
        .collect();
    let data = (0..n.rows)
        .flat_map(|row| kept.iter().map(move |col| (row, *col)))
        .map(|(row, col)| n.data[row * n.cols + col]);
    Matrix {
        rows: n.rows,
        cols: kept.len(),
        data: data.collect(),
    }
}

fn block_diagonal(blocks: impl Iterator<Item = Matrix> + Clone) -> Matrix {
    let (rows, cols) = blocks.clone().fold((0, 0), |(rows, cols), block| {
        (rows + block.rows, cols + block.cols)
    });
    let mut data = vec![0.0; rows * cols];
    let (mut top, mut left) = (0, 0);
    for block in blocks {
        for row in 0..block.rows {
            for col in 0..block.cols {
                data[(top + row) * cols + left + col] = block.data[row * block.cols + col];
            }
        }
        top += block.rows;
        left += block.cols;
    }
    Matrix { rows, cols, data }
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |row: usize, col: usize| {
        (0..a.cols)
            .map(|k| a.data[row * a.cols + k] * b.data[k * b.cols + col])
            .sum::<f64>()
    };
    let data = (0..a.rows)
        .flat_map(|row| (0..b.cols).map(move |col| (row, col)))
        .map(|(row, col)| entry(row, col))
        .collect();
    Matrix {
        rows: a.rows,
        cols: b.cols,
        data,
    }
}

fn subtract(a: &Matrix, b: &Matrix) -> Matrix {
    Matrix {
        rows: a.rows,
        cols: a.cols,
        data: a.data.iter().zip(&b.data).map(|(a, b)| a - b).collect(),
    }
}
