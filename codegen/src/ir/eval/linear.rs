//! Products and the singular vector of small dense arrays, row-major.

/// Number of partial sums of a long sum.
const PARTIAL: usize = 8;

/// Up to seven terms are added left to right. From eight on term k goes to partial sum k mod 8, and the partial sums are added in halves:
/// the first four to the last four, of those the first two to the last two, and then these two. 0 without terms.
pub(super) fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let terms: Vec<f64> = terms.collect();
    if terms.len() < PARTIAL {
        return terms
            .into_iter()
            .reduce(|sum, term| sum + term)
            .unwrap_or(0.0);
    }
    let mut sums = terms[..PARTIAL].to_vec();
    for (k, term) in terms.iter().enumerate().skip(PARTIAL) {
        sums[k % PARTIAL] += term;
    }
    while sums.len() > 1 {
        let half = sums.split_off(sums.len() / 2);
        for (sum, other) in sums.iter_mut().zip(half) {
            *sum += other;
        }
    }
    sums[0]
}

/// Sum of products of paired entries. If it is fused, a product that is added to a sum is not rounded.
pub(super) fn sum_of_products(pairs: impl Iterator<Item = (f64, f64)>, fused: bool) -> f64 {
    if !fused {
        return sum(pairs.map(|(a, b)| a * b));
    }
    let pairs: Vec<(f64, f64)> = pairs.collect();
    let partial = if pairs.len() < PARTIAL { 1 } else { PARTIAL };
    let mut sums: Vec<f64> = Vec::with_capacity(partial);
    for (k, &(a, b)) in pairs.iter().enumerate() {
        match sums.get_mut(k % partial) {
            Some(sum) => *sum = f64::mul_add(a, b, *sum),
            None => sums.push(a * b),
        }
    }
    sum(sums.into_iter())
}

/// Sum of the squares of all entries of an array with `columns` columns: along each row left to right, then of the rows' sums.
pub(super) fn sum_of_squares(a: &[f64], columns: usize, fused: bool) -> f64 {
    if columns == 1 {
        return sum_of_products(a.iter().map(|&x| (x, x)), fused);
    }
    let squares = |row: &[f64]| {
        let (first, rest) = row.split_first()?;
        Some(rest.iter().fold(first * first, |sum, x| {
            if fused {
                f64::mul_add(*x, *x, sum)
            } else {
                sum + x * x
            }
        }))
    };
    sum(a.chunks(columns).filter_map(squares))
}

/// Product of a `rows` x `inner` and an `inner` x `columns` matrix.
pub(super) fn product(
    a: &[f64],
    b: &[f64],
    inner: usize,
    columns: usize,
    fused: bool,
    out: &mut [f64],
) {
    for (index, entry) in out.iter_mut().enumerate() {
        let (i, j) = (index / columns, index % columns);
        let pairs = (0..inner).map(|k| (a[i * inner + k], b[k * columns + j]));
        *entry = sum_of_products(pairs, fused);
    }
}

/// Sweeps of the Jacobi method; it converges quadratically, so eight are ample for the sizes that are emitted.
pub(crate) const SWEEPS: usize = 8;

/// Unit right singular vector of the largest singular value of a matrix with `n` columns: cyclic Jacobi on A^T A with a fixed number of
/// sweeps; its entry of largest magnitude is not negative.
pub(super) fn singular_vector(a: &[f64], n: usize, out: &mut [f64]) {
    let mut s = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in i..n {
            s[i][j] = sum_of_products(a.chunks_exact(n).map(|row| (row[i], row[j])), false);
            s[j][i] = s[i][j];
        }
    }
    let mut v: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect())
        .collect();
    for _ in 0..SWEEPS {
        for p in 0..n {
            for q in p + 1..n {
                rotate(&mut s, &mut v, p, q);
            }
        }
    }
    let largest = (1..n).fold(0, |best, j| if s[j][j] > s[best][best] { j } else { best });
    let lead = (1..n).fold(v[0][largest], |lead, i| {
        if v[i][largest].abs() > lead.abs() {
            v[i][largest]
        } else {
            lead
        }
    });
    for (entry, row) in out.iter_mut().zip(&v) {
        *entry = if lead < 0.0 {
            -row[largest]
        } else {
            row[largest]
        };
    }
}

/// The Jacobi rotation that makes the entry (p, q) of the symmetric `s` zero, collected in the columns of `v`.
fn rotate(s: &mut [Vec<f64>], v: &mut [Vec<f64>], p: usize, q: usize) {
    let off = s[p][q];
    let theta = (s[q][q] - s[p][p]) / (off + off);
    let root = 1.0 / (theta.abs() + f64::sqrt(theta * theta + 1.0));
    let signed = if theta < 0.0 { -root } else { root };
    let tangent = if off == 0.0 { 0.0 } else { signed };
    let cosine = 1.0 / f64::sqrt(tangent * tangent + 1.0);
    let sine = tangent * cosine;
    let shift = tangent * off;
    s[p][p] -= shift;
    s[q][q] += shift;
    s[p][q] = 0.0;
    s[q][p] = 0.0;
    for k in (0..s.len()).filter(|&k| k != p && k != q) {
        let (x, y) = (s[k][p], s[k][q]);
        s[k][p] = cosine * x - sine * y;
        s[p][k] = s[k][p];
        s[k][q] = sine * x + cosine * y;
        s[q][k] = s[k][q];
    }
    for row in v {
        let (x, y) = (row[p], row[q]);
        row[p] = cosine * x - sine * y;
        row[q] = sine * x + cosine * y;
    }
}
