//! What every random program has: inputs, and data of every kind.

use nsv_spec::interpolation::{Degree, Extrapolation, Interpolant};
use nsv_spec::model::Basis as Kind;

use super::SHAPES;
use crate::ir::{
    FamilyMember, Input, MonomialBasis, Origin, PolynomialData, PolynomialFamily, Program,
    TableData, TableFamily, TableId, TableMember,
};

/// Inputs and tables of every random program.
pub(super) fn frame() -> Program {
    let inputs = SHAPES
        .iter()
        .enumerate()
        .map(|(index, &shape)| Input {
            name: format!("x{index}"),
            shape,
        })
        .collect();
    let terms = vec![
        (0.5, vec![0, 0]),
        (-1.25, vec![2, 1]),
        (3.0, vec![0, 3]),
        (0.1, vec![4, 0]),
        (2.0, vec![2, 0]),
    ];
    let names = |names: &[&str]| {
        names
            .iter()
            .map(|&name| name.to_owned())
            .collect::<Vec<String>>()
    };
    Program {
        name: "random".into(),
        inputs,
        polynomials: vec![
            PolynomialData {
                name: "f".into(),
                arguments: names(&["a", "b"]),
                terms,
            },
            PolynomialData {
                name: "g".into(),
                arguments: names(&["a"]),
                terms: vec![(-2.5, vec![3])],
            },
        ],
        tables: vec![
            table("l1", Degree::Linear, Extrapolation::Clamp, 1),
            table("l2", Degree::Linear, Extrapolation::Error, 2),
            table("l3", Degree::Cubic, Extrapolation::Clamp, 1),
            table("l4", Degree::Cubic, Extrapolation::Clamp, 2),
            table("l5", Degree::Cubic, Extrapolation::Error, 3),
            table("l6", Degree::Cubic, Extrapolation::Error, 2),
        ],
        table_families: vec![TableFamily {
            name: "k".into(),
            arguments: names(&["a", "b"]),
            members: vec![
                member_of(3, [0, 0]),
                member_of(5, [0, 0]),
                member_of(5, [1, 2]),
            ],
        }],
        families: vec![PolynomialFamily {
            name: "h".into(),
            argument: "a".into(),
            members: vec![
                member("h1", &[0.5, -0.0, 1.25, -3.0]),
                member("h2", &[-0.75, 0.0, 2.0, 0.5]),
                member("h3", &[0.0, 1.0]),
                member("h4", &[4.0]),
            ],
        }],
        bases: vec![
            MonomialBasis::new("basis1", 3, Kind::Pairwise, &names(&["p", "q", "r"])),
            MonomialBasis::new("basis2", 2, Kind::Complete, &names(&["p", "q"])),
        ],
        origins: vec![Origin {
            group: "random values".into(),
            equation: "v = \"any\" \\ value  (1)".into(),
        }],
        ..Program::default()
    }
}

fn member(name: &str, coefficients: &[f64]) -> FamilyMember {
    FamilyMember {
        name: name.to_owned(),
        coefficients: coefficients.to_vec(),
    }
}

fn member_of(table: u32, orders: [u32; 2]) -> TableMember {
    TableMember {
        table: TableId(table),
        orders: orders.to_vec(),
    }
}

/// A table of up to three axes around the numbers that are drawn.
fn table(name: &str, degree: Degree, extrapolation: Extrapolation, axes: usize) -> TableData {
    let points = [
        vec![-1.5, -0.625, 0.0, 0.1, 1.0, 1.25],
        vec![-1.0, 0.0, 0.3, 1.0, 2.0],
        vec![-2.0, -1.0, 0.5, 1.5],
    ];
    let count: usize = points[..axes].iter().map(Vec::len).product();
    // Without order: 37 and 101 have no common divisor.
    let values = (0..count).map(|at| (at * 37 % 101) as f64 / 32.0 - 1.5);
    TableData {
        name: name.to_owned(),
        arguments: ["a", "b", "c"][..axes]
            .iter()
            .map(|&name| name.to_owned())
            .collect(),
        interpolant: Interpolant::new(degree, extrapolation, &points[..axes], values.collect()),
    }
}
