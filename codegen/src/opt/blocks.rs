//! Block triangular form of a square matrix by its zeros: rows and columns in an order in which all that is not zero lies in blocks on the
//! diagonal and below them (Duff and Reid, "An implementation of Tarjan's algorithm for the block triangularization of a matrix", 1978).

/// A block on the diagonal: its rows and columns, as many of one as of the other, ascending.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) rows: Vec<usize>,
    pub(super) columns: Vec<usize>,
}

/// The smallest blocks, in an order in which a row of one has nothing but zeros in the columns of those behind it; `None` if the zeros alone
/// make the matrix singular. `full` tells where the matrix is not zero.
pub(super) fn blocks(n: usize, full: impl Fn(usize, usize) -> bool) -> Option<Vec<Block>> {
    let mut transversal = Transversal {
        n,
        full: &full,
        row_of: vec![None; n],
    };
    for row in 0..n {
        if !transversal.place(row, &mut vec![false; n]) {
            return None;
        }
    }
    let row_of: Vec<usize> = transversal.row_of.into_iter().collect::<Option<_>>()?;
    let mut components = Components {
        full: &full,
        row_of: &row_of,
        order: vec![None; n],
        low: vec![0; n],
        open: Vec::new(),
        reached: 0,
        found: Vec::new(),
    };
    for column in 0..n {
        if components.order[column].is_none() {
            components.visit(column);
        }
    }
    let block = |mut columns: Vec<usize>| {
        columns.sort_unstable();
        let mut rows: Vec<usize> = columns.iter().map(|&column| row_of[column]).collect();
        rows.sort_unstable();
        Block { rows, columns }
    };
    Some(components.found.into_iter().map(block).collect())
}

/// Maximum transversal: a row for each column in which the column is not zero, by augmenting paths.
struct Transversal<'f, F> {
    n: usize,
    full: &'f F,
    row_of: Vec<Option<usize>>,
}

impl<F: Fn(usize, usize) -> bool> Transversal<'_, F> {
    /// Finds a column for a row; rows that have one may move.
    fn place(&mut self, row: usize, tried: &mut Vec<bool>) -> bool {
        for column in 0..self.n {
            if !(self.full)(row, column) || std::mem::replace(&mut tried[column], true) {
                continue;
            }
            let free = match self.row_of[column] {
                None => true,
                Some(other) => self.place(other, tried),
            };
            if free {
                self.row_of[column] = Some(row);
                return true;
            }
        }
        false
    }
}

/// Strongly connected components (Tarjan, 1972) of the graph in which a column leads to the others that its row needs. A component is found
/// after those it leads to, which is the order of substitution.
struct Components<'f, F> {
    full: &'f F,
    row_of: &'f [usize],
    /// When each column was reached.
    order: Vec<Option<usize>>,
    /// The earliest open column that each leads back to.
    low: Vec<usize>,
    open: Vec<usize>,
    reached: usize,
    found: Vec<Vec<usize>>,
}

impl<F: Fn(usize, usize) -> bool> Components<'_, F> {
    fn visit(&mut self, column: usize) {
        let order = self.reached;
        self.reached += 1;
        self.order[column] = Some(order);
        self.low[column] = order;
        let start = self.open.len();
        self.open.push(column);
        for next in 0..self.row_of.len() {
            if !(self.full)(self.row_of[column], next) {
                continue;
            }
            match self.order[next] {
                None => {
                    self.visit(next);
                    self.low[column] = self.low[column].min(self.low[next]);
                }
                Some(at) if self.open.contains(&next) => {
                    self.low[column] = self.low[column].min(at);
                }
                Some(_) => {}
            }
        }
        if self.low[column] == order {
            self.found.push(self.open.split_off(start));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The blocks of a matrix written as rows of `x` and `.`.
    fn of(rows: &[&str]) -> Option<Vec<(Vec<usize>, Vec<usize>)>> {
        let full = |row: usize, column: usize| rows[row].as_bytes()[column] == b'x';
        let found = blocks(rows.len(), full)?.into_iter();
        Some(found.map(|block| (block.rows, block.columns)).collect())
    }

    #[test]
    fn a_dense_matrix_is_one_block() {
        assert_eq!(of(&["xx", "xx"]), Some(vec![(vec![0, 1], vec![0, 1])]));
        assert_eq!(
            of(&[".x.", "..x", "x.."]).map(|blocks| blocks.len()),
            Some(3)
        );
        assert_eq!(
            of(&["xx.", ".xx", "x.x"]),
            Some(vec![(vec![0, 1, 2], vec![0, 1, 2])])
        );
    }

    #[test]
    fn a_permuted_triangle_is_solved_row_by_row() {
        let found = of(&["xxx", ".x.", ".xx"]).expect("blocks");
        assert_eq!(
            found,
            [(vec![1], vec![1]), (vec![2], vec![2]), (vec![0], vec![0])]
        );
    }

    #[test]
    fn a_matrix_that_its_zeros_make_singular_has_no_blocks() {
        assert_eq!(of(&["x.x", "x..", "x.."]), None);
        assert_eq!(of(&["x.", ".."]), None);
    }

    #[test]
    fn no_row_needs_a_column_of_a_later_block() {
        let mut state = 1_u64;
        for _ in 0..2000 {
            let n = 1 + (state >> 40) as usize % 7;
            let cells: Vec<bool> = (0..n * n)
                .map(|_| {
                    state = state
                        .wrapping_mul(6_364_136_223_846_793_005)
                        .wrapping_add(1_442_695_040_888_963_407);
                    (state >> 33).is_multiple_of(3)
                })
                .collect();
            let full = |row: usize, column: usize| cells[row * n + column];
            let Some(found) = blocks(n, full) else {
                continue;
            };
            let mut solved = vec![false; n];
            let mut rows: Vec<usize> = Vec::new();
            for block in &found {
                for &column in &block.columns {
                    assert!(!std::mem::replace(&mut solved[column], true));
                }
                for &row in &block.rows {
                    assert!((0..n).all(|column| !full(row, column) || solved[column]));
                }
                rows.extend(&block.rows);
            }
            rows.sort_unstable();
            assert_eq!(rows, (0..n).collect::<Vec<usize>>());
        }
    }
}
