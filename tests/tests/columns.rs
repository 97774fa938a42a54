//! A plant whose noise depends on states gives the columns of its diffusion one by one, and tells which of them depend on states.

use nsv_generated::ghv_unstable::Params;
use nsv_generated::ghv_unstable::plant::{
    INITIAL_STATE, NOISE_CHANNELS, Plant, STATES, clock, prepare,
};
use nsv_runtime::linear::Vector;
use nsv_runtime::sde::Sde;

type Columns = [[u64; STATES]; NOISE_CHANNELS];

#[test]
fn single_columns_are_those_of_the_diffusion() {
    let params = Params::plant();
    let plant = Plant {
        prepared: prepare(&params),
        params,
        u_sat: Vector::zero(),
    };
    let at = clock(0.0);
    let bits = |column: Vector<f64, STATES>| column.0.map(f64::to_bits);
    let whole = |x: &Vector<f64, STATES>| -> Columns {
        std::array::from_fn(|j| bits(plant.diffusion(&at, x).column(j)))
    };
    let single = |x: &Vector<f64, STATES>| -> Columns {
        std::array::from_fn(|j| bits(plant.diffusion_column(&at, x, j)))
    };
    let start = Vector(INITIAL_STATE);
    let moved = Vector(INITIAL_STATE.map(|entry| 1.1 * entry + 0.01));
    assert_eq!(whole(&start), single(&start));
    assert_eq!(whole(&moved), single(&moved));
    let dependent = <Plant<f64> as Sde<f64, STATES, NOISE_CHANNELS>>::STATE_DEPENDENT;
    assert!(dependent.contains(&true) && dependent.contains(&false));
    for (j, dependent) in dependent.into_iter().enumerate() {
        assert_eq!(whole(&start)[j] != whole(&moved)[j], dependent, "{j}");
    }
}
