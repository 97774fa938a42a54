// SHA-256 of the text below: d06f0ca7bc31fecef30a6644b097b40350a911417b59c9a8766ee9b396c56089
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `nsv_attitude`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::polynomial::horner;
use nsv_runtime::real::Real;

/// Polynomial data at one `alpha_deg`.
#[derive(Clone, Copy, Debug)]
pub struct AtAlphaDeg2<T> {
    /// `Cm_RUD`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RUD: T,
    /// `CL_alpha`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha: T,
    /// `CY_beta`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta: T,
    /// `Cl_beta`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_beta: T,
    /// `Cl_p`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_p: T,
    /// `Cl_r`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_r: T,
    /// `Cm_alpha`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_alpha: T,
    /// `Cm_q`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_q: T,
    /// `Cn_beta`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_beta: T,
    /// `Cn_p`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_p: T,
    /// `Cn_r`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_r: T,
    /// `CY_LE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE: T,
    /// `CY_RE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE: T,
    /// `Cl_LE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE: T,
    /// `Cl_RE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE: T,
    /// `Cn_LE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE: T,
    /// `Cn_RE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE: T,
    /// `Cl_LE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE_d3: T,
    /// `Cl_RE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE_d3: T,
    /// `Cn_LE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE_d3: T,
    /// `Cn_RE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE_d3: T,
    /// `CL_LE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_LE: T,
    /// `CL_RE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_RE: T,
    /// `CY_RUD`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RUD: T,
    /// `Cl_RUD`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD: T,
    /// `Cm_LE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE: T,
    /// `Cm_RE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE: T,
    /// `Cn_RUD`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD: T,
    /// `Cl_RUD_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD_d3: T,
    /// `Cm_LE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE_d3: T,
    /// `Cm_RE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE_d3: T,
    /// `Cn_RUD_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD_d3: T,
}

/// Polynomial data in `alpha_deg` by Horner's scheme, with its other arguments, which are
/// constants, in the coefficients.
///
/// 32 polynomials; 88 additions, 88 multiplications. A row of a table holds the coefficients of
/// one power, the highest first.
#[inline(always)]
pub fn at_alpha_deg_2<T: Real>(alpha_deg: T) -> AtAlphaDeg2<T> {
    const DEGREE_7: [[f64; 1]; 8] = [
        [5.74e-12],
        [-2.18e-10],
        [3.14e-9],
        [-2.1e-8],
        [6.42e-8],
        [-5.89e-8],
        [-2.79e-5],
        [-0.0006960547200340074],
    ];
    let [Cm_RUD] = horner(&DEGREE_7, alpha_deg);
    const DEGREE_5: [[f64; 10]; 6] = [
        [
            1.3e-8,
            -5.2083e-7,
            -3.353e-21,
            -1.15e-7,
            -1.06e-9,
            -2.789e-7,
            -5.93e-6,
            -2.504059032375198e-7,
            2.96e-19,
            -1.18e-6,
        ],
        [
            -3.91e-7,
            2.6339103531325548e-5,
            3.803e-19,
            4.21e-6,
            3.19e-8,
            8.288e-6,
            0.000169,
            8.91655428592757e-6,
            -9.18e-18,
            3.6e-5,
        ],
        [
            4.08e-6,
            -0.00037405,
            -8.964e-18,
            -3.86e-5,
            -2.7e-7,
            -7.887e-5,
            -0.00148,
            -9.666552330262917e-5,
            1.01e-16,
            -0.000387,
        ],
        [
            -9.062657615458775e-5,
            0.0011599602768678128,
            1.2843196244639332e-6,
            -0.00021957389052504618,
            -5.159554706746226e-6,
            0.00023209157584728094,
            0.0021602033781326314,
            0.0002291367121137426,
            -4.64e-16,
            0.0011433093746625953,
        ],
        [
            0.013812178997103516,
            -4.938083058843431e-5,
            -0.0006719891980107862,
            0.0004912670527392995,
            0.0011150371844903522,
            -0.0004298984411761429,
            0.0022021140389122786,
            -6.18987959153497e-5,
            7.61e-16,
            -0.0006244511847666697,
        ],
        [
            -0.00883815039052084,
            -0.4193602461541422,
            -0.022083557553724334,
            -0.04859140704194431,
            0.05946039898789246,
            0.002783872039364598,
            -0.2480990578146105,
            -0.030296143941408966,
            0.048444529933999336,
            -0.4913589178158497,
        ],
    ];
    let [CL_alpha, CY_beta, Cl_beta, Cl_p, Cl_r, Cm_alpha, Cm_q, Cn_beta, Cn_p, Cn_r] = horner(
        &DEGREE_5,
        alpha_deg,
    );
    const DEGREE_2: [[f64; 10]; 3] = [
        [-2.82e-9, 2.82e-9, -4.95e-6, 4.95e-6, 6.39e-7, -6.39e-7, 0.0, -0.0, -0.0, 0.0],
        [
            1.12e-7,
            -1.12e-7,
            9.569e-5,
            -9.569e-5,
            -1.83e-5,
            1.83e-5,
            -2.8281547319435047e-7,
            2.8281547319435047e-7,
            9.03916311963332e-7,
            -9.03916311963332e-7,
        ],
        [
            -1.0967135008936997e-6,
            1.0967135008936997e-6,
            -0.00013737247838665077,
            0.00013737247838665077,
            6.674465384308486e-5,
            -6.674465384308486e-5,
            -0.000117,
            0.000117,
            1.3e-5,
            -1.3e-5,
        ],
    ];
    let [CY_LE, CY_RE, Cl_LE, Cl_RE, Cn_LE, Cn_RE, Cl_LE_d3, Cl_RE_d3, Cn_LE_d3, Cn_RE_d3,
    ] = horner(&DEGREE_2, alpha_deg);
    const DEGREE_1: [[f64; 11]; 2] = [
        [
            0.0001485745427349122,
            0.0001485745427349122,
            4.86e-20,
            2.8103916253686545e-20,
            -0.00011104520438249116,
            -0.00011104520438249116,
            -2.0008078277912303e-19,
            -2.1201397605752832e-6,
            5.463882032730525e-6,
            5.463882032730525e-6,
            1.073173789871755e-5,
        ],
        [
            5.73679262591227e-5,
            5.73679262591227e-5,
            4.527372231263129e-19,
            -2.639873102625161e-19,
            -7.198458713398243e-5,
            -7.198458713398243e-5,
            1.5745973649789493e-18,
            7.848008576769269e-5,
            0.00022958243279703517,
            0.00022958243279703517,
            -0.0003609829882710529,
        ],
    ];
    let [CL_LE, CL_RE, CY_RUD, Cl_RUD, Cm_LE, Cm_RE, Cn_RUD, Cl_RUD_d3, Cm_LE_d3,
    Cm_RE_d3, Cn_RUD_d3] = horner(&DEGREE_1, alpha_deg);
    AtAlphaDeg2 {
        Cm_RUD,
        CL_alpha,
        CY_beta,
        Cl_beta,
        Cl_p,
        Cl_r,
        Cm_alpha,
        Cm_q,
        Cn_beta,
        Cn_p,
        Cn_r,
        CY_LE,
        CY_RE,
        Cl_LE,
        Cl_RE,
        Cn_LE,
        Cn_RE,
        Cl_LE_d3,
        Cl_RE_d3,
        Cn_LE_d3,
        Cn_RE_d3,
        CL_LE,
        CL_RE,
        CY_RUD,
        Cl_RUD,
        Cm_LE,
        Cm_RE,
        Cn_RUD,
        Cl_RUD_d3,
        Cm_LE_d3,
        Cm_RE_d3,
        Cn_RUD_d3,
    }
}

/// Polynomial data at one `alpha_deg`.
#[derive(Clone, Copy, Debug)]
pub struct AtAlphaDeg<T> {
    /// `CL_alpha`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha: T,
    /// `CY_beta`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta: T,
    /// `CY_LE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE: T,
    /// `CY_RE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE: T,
    /// `CL_LE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_LE: T,
    /// `CL_RE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_RE: T,
    /// `CY_RUD`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RUD: T,
}

/// Polynomial data in `alpha_deg` by Horner's scheme, with its other arguments, which are
/// constants, in the coefficients.
///
/// 7 polynomials; 17 additions, 17 multiplications. A row of a table holds the coefficients of
/// one power, the highest first.
#[inline(always)]
pub fn at_alpha_deg<T: Real>(alpha_deg: T) -> AtAlphaDeg<T> {
    const DEGREE_5: [[f64; 2]; 6] = [
        [1.3e-8, -5.2083e-7],
        [-3.91e-7, 2.6339103531325548e-5],
        [4.08e-6, -0.00037405],
        [-9.062657615458775e-5, 0.0011599602768678128],
        [0.013812178997103516, -4.938083058843431e-5],
        [-0.00883815039052084, -0.4193602461541422],
    ];
    let [CL_alpha, CY_beta] = horner(&DEGREE_5, alpha_deg);
    const DEGREE_2: [[f64; 2]; 3] = [
        [-2.82e-9, 2.82e-9],
        [1.12e-7, -1.12e-7],
        [-1.0967135008936997e-6, 1.0967135008936997e-6],
    ];
    let [CY_LE, CY_RE] = horner(&DEGREE_2, alpha_deg);
    const DEGREE_1: [[f64; 3]; 2] = [
        [0.0001485745427349122, 0.0001485745427349122, 4.86e-20],
        [5.73679262591227e-5, 5.73679262591227e-5, 4.527372231263129e-19],
    ];
    let [CL_LE, CL_RE, CY_RUD] = horner(&DEGREE_1, alpha_deg);
    AtAlphaDeg {
        CL_alpha,
        CY_beta,
        CY_LE,
        CY_RE,
        CL_LE,
        CL_RE,
        CY_RUD,
    }
}

/// Polynomial data at one `alpha_deg`.
#[derive(Clone, Copy, Debug)]
pub struct AtAlphaDeg22<T> {
    /// `Cm_RUD`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RUD: T,
    /// `CL_alpha`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha: T,
    /// `CY_beta`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta: T,
    /// `Cl_beta`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_beta: T,
    /// `Cl_p`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_p: T,
    /// `Cl_r`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_r: T,
    /// `Cm_alpha`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_alpha: T,
    /// `Cm_q`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_q: T,
    /// `Cn_beta`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_beta: T,
    /// `Cn_p`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_p: T,
    /// `Cn_r`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_r: T,
    /// `CL_alpha_d1`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha_d1: T,
    /// `CY_beta_d1`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta_d1: T,
    /// `CY_LE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE: T,
    /// `CY_RE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE: T,
    /// `Cl_LE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE: T,
    /// `Cl_RE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE: T,
    /// `Cn_LE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE: T,
    /// `Cn_RE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE: T,
    /// `Cl_LE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE_d3: T,
    /// `Cl_RE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE_d3: T,
    /// `Cn_LE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE_d3: T,
    /// `Cn_RE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE_d3: T,
    /// `CL_LE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_LE: T,
    /// `CL_RE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_RE: T,
    /// `CY_RUD`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RUD: T,
    /// `Cl_RUD`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD: T,
    /// `Cm_LE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE: T,
    /// `Cm_RE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE: T,
    /// `Cn_RUD`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD: T,
    /// `Cl_RUD_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD_d3: T,
    /// `Cm_LE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE_d3: T,
    /// `Cm_RE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE_d3: T,
    /// `Cn_RUD_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD_d3: T,
    /// `CY_LE_d1`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE_d1: T,
    /// `CY_RE_d1`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE_d1: T,
}

/// Polynomial data in `alpha_deg` by Horner's scheme, with its other arguments, which are
/// constants, in the coefficients.
///
/// 36 polynomials; 98 additions, 98 multiplications. A row of a table holds the coefficients of
/// one power, the highest first.
#[inline(always)]
pub fn at_alpha_deg_2_2<T: Real>(alpha_deg: T) -> AtAlphaDeg22<T> {
    const DEGREE_7: [[f64; 1]; 8] = [
        [5.74e-12],
        [-2.18e-10],
        [3.14e-9],
        [-2.1e-8],
        [6.42e-8],
        [-5.89e-8],
        [-2.79e-5],
        [-0.0006960547200340074],
    ];
    let [Cm_RUD] = horner(&DEGREE_7, alpha_deg);
    const DEGREE_5: [[f64; 10]; 6] = [
        [
            1.3e-8,
            -5.2083e-7,
            -3.353e-21,
            -1.15e-7,
            -1.06e-9,
            -2.789e-7,
            -5.93e-6,
            -2.504059032375198e-7,
            2.96e-19,
            -1.18e-6,
        ],
        [
            -3.91e-7,
            2.6339103531325548e-5,
            3.803e-19,
            4.21e-6,
            3.19e-8,
            8.288e-6,
            0.000169,
            8.91655428592757e-6,
            -9.18e-18,
            3.6e-5,
        ],
        [
            4.08e-6,
            -0.00037405,
            -8.964e-18,
            -3.86e-5,
            -2.7e-7,
            -7.887e-5,
            -0.00148,
            -9.666552330262917e-5,
            1.01e-16,
            -0.000387,
        ],
        [
            -9.062657615458775e-5,
            0.0011599602768678128,
            1.2843196244639332e-6,
            -0.00021957389052504618,
            -5.159554706746226e-6,
            0.00023209157584728094,
            0.0021602033781326314,
            0.0002291367121137426,
            -4.64e-16,
            0.0011433093746625953,
        ],
        [
            0.013812178997103516,
            -4.938083058843431e-5,
            -0.0006719891980107862,
            0.0004912670527392995,
            0.0011150371844903522,
            -0.0004298984411761429,
            0.0022021140389122786,
            -6.18987959153497e-5,
            7.61e-16,
            -0.0006244511847666697,
        ],
        [
            -0.00883815039052084,
            -0.4193602461541422,
            -0.022083557553724334,
            -0.04859140704194431,
            0.05946039898789246,
            0.002783872039364598,
            -0.2480990578146105,
            -0.030296143941408966,
            0.048444529933999336,
            -0.4913589178158497,
        ],
    ];
    let [CL_alpha, CY_beta, Cl_beta, Cl_p, Cl_r, Cm_alpha, Cm_q, Cn_beta, Cn_p, Cn_r] = horner(
        &DEGREE_5,
        alpha_deg,
    );
    const DEGREE_4: [[f64; 2]; 5] = [
        [6.5e-8, -2.6041500000000003e-6],
        [-1.564e-6, 0.00010535641412530219],
        [1.224e-5, -0.0011221500000000001],
        [-0.0001812531523091755, 0.0023199205537356255],
        [0.013812178997103516, -4.938083058843431e-5],
    ];
    let [CL_alpha_d1, CY_beta_d1] = horner(&DEGREE_4, alpha_deg);
    const DEGREE_2: [[f64; 10]; 3] = [
        [-2.82e-9, 2.82e-9, -4.95e-6, 4.95e-6, 6.39e-7, -6.39e-7, 0.0, -0.0, -0.0, 0.0],
        [
            1.12e-7,
            -1.12e-7,
            9.569e-5,
            -9.569e-5,
            -1.83e-5,
            1.83e-5,
            -2.8281547319435047e-7,
            2.8281547319435047e-7,
            9.03916311963332e-7,
            -9.03916311963332e-7,
        ],
        [
            -1.0967135008936997e-6,
            1.0967135008936997e-6,
            -0.00013737247838665077,
            0.00013737247838665077,
            6.674465384308486e-5,
            -6.674465384308486e-5,
            -0.000117,
            0.000117,
            1.3e-5,
            -1.3e-5,
        ],
    ];
    let [CY_LE, CY_RE, Cl_LE, Cl_RE, Cn_LE, Cn_RE, Cl_LE_d3, Cl_RE_d3, Cn_LE_d3, Cn_RE_d3,
    ] = horner(&DEGREE_2, alpha_deg);
    const DEGREE_1: [[f64; 13]; 2] = [
        [
            0.0001485745427349122,
            0.0001485745427349122,
            4.86e-20,
            2.8103916253686545e-20,
            -0.00011104520438249116,
            -0.00011104520438249116,
            -2.0008078277912303e-19,
            -2.1201397605752832e-6,
            5.463882032730525e-6,
            5.463882032730525e-6,
            1.073173789871755e-5,
            -5.64e-9,
            5.64e-9,
        ],
        [
            5.73679262591227e-5,
            5.73679262591227e-5,
            4.527372231263129e-19,
            -2.639873102625161e-19,
            -7.198458713398243e-5,
            -7.198458713398243e-5,
            1.5745973649789493e-18,
            7.848008576769269e-5,
            0.00022958243279703517,
            0.00022958243279703517,
            -0.0003609829882710529,
            1.12e-7,
            -1.12e-7,
        ],
    ];
    let [CL_LE, CL_RE, CY_RUD, Cl_RUD, Cm_LE, Cm_RE, Cn_RUD, Cl_RUD_d3, Cm_LE_d3,
    Cm_RE_d3, Cn_RUD_d3, CY_LE_d1, CY_RE_d1] = horner(&DEGREE_1, alpha_deg);
    AtAlphaDeg22 {
        Cm_RUD,
        CL_alpha,
        CY_beta,
        Cl_beta,
        Cl_p,
        Cl_r,
        Cm_alpha,
        Cm_q,
        Cn_beta,
        Cn_p,
        Cn_r,
        CL_alpha_d1,
        CY_beta_d1,
        CY_LE,
        CY_RE,
        Cl_LE,
        Cl_RE,
        Cn_LE,
        Cn_RE,
        Cl_LE_d3,
        Cl_RE_d3,
        Cn_LE_d3,
        Cn_RE_d3,
        CL_LE,
        CL_RE,
        CY_RUD,
        Cl_RUD,
        Cm_LE,
        Cm_RE,
        Cn_RUD,
        Cl_RUD_d3,
        Cm_LE_d3,
        Cm_RE_d3,
        Cn_RUD_d3,
        CY_LE_d1,
        CY_RE_d1,
    }
}

/// Values of the 19 monomials `basis1` of z = (`alpha`, `beta`, `mu`).
#[inline(always)]
pub fn basis1<T: Real>(z: Vector<T, 3>) -> Vector<T, 19> {
    let one = T::one();
    let alpha = z[0];
    let beta = z[1];
    let mu = z[2];
    let alpha2 = alpha * alpha;
    let alpha_beta = alpha * beta;
    let alpha_mu = alpha * mu;
    let beta2 = beta * beta;
    let beta_mu = beta * mu;
    let mu2 = mu * mu;
    let alpha3 = alpha2 * alpha;
    let alpha2_beta = alpha2 * beta;
    let alpha2_mu = alpha2 * mu;
    let alpha_beta2 = alpha_beta * beta;
    let alpha_mu2 = alpha_mu * mu;
    let beta3 = beta2 * beta;
    let beta2_mu = beta2 * mu;
    let beta_mu2 = beta_mu * mu;
    let mu3 = mu2 * mu;
    Vector([
        one,
        alpha,
        beta,
        mu,
        alpha2,
        alpha_beta,
        alpha_mu,
        beta2,
        beta_mu,
        mu2,
        alpha3,
        alpha2_beta,
        alpha2_mu,
        alpha_beta2,
        alpha_mu2,
        beta3,
        beta2_mu,
        beta_mu2,
        mu3,
    ])
}

/// Rates of the 19 monomials `basis1` of z = (`alpha`, `beta`, `mu`), along the rate `z_d1` of
/// z.
#[inline(always)]
pub fn basis1_rate<T: Real>(z: Vector<T, 3>, z_d1: Vector<T, 3>) -> Vector<T, 19> {
    let one_d1 = T::zero();
    let alpha = z[0];
    let alpha_d1 = z_d1[0];
    let beta = z[1];
    let beta_d1 = z_d1[1];
    let mu = z[2];
    let mu_d1 = z_d1[2];
    let alpha2 = alpha * alpha;
    let alpha2_d1 = alpha_d1 * alpha + alpha * alpha_d1;
    let alpha_beta = alpha * beta;
    let alpha_beta_d1 = alpha_d1 * beta + alpha * beta_d1;
    let alpha_mu = alpha * mu;
    let alpha_mu_d1 = alpha_d1 * mu + alpha * mu_d1;
    let beta2 = beta * beta;
    let beta2_d1 = beta_d1 * beta + beta * beta_d1;
    let beta_mu = beta * mu;
    let beta_mu_d1 = beta_d1 * mu + beta * mu_d1;
    let mu2 = mu * mu;
    let mu2_d1 = mu_d1 * mu + mu * mu_d1;
    let alpha3_d1 = alpha2_d1 * alpha + alpha2 * alpha_d1;
    let alpha2_beta_d1 = alpha2_d1 * beta + alpha2 * beta_d1;
    let alpha2_mu_d1 = alpha2_d1 * mu + alpha2 * mu_d1;
    let alpha_beta2_d1 = alpha_beta_d1 * beta + alpha_beta * beta_d1;
    let alpha_mu2_d1 = alpha_mu_d1 * mu + alpha_mu * mu_d1;
    let beta3_d1 = beta2_d1 * beta + beta2 * beta_d1;
    let beta2_mu_d1 = beta2_d1 * mu + beta2 * mu_d1;
    let beta_mu2_d1 = beta_mu_d1 * mu + beta_mu * mu_d1;
    let mu3_d1 = mu2_d1 * mu + mu2 * mu_d1;
    Vector([
        one_d1,
        alpha_d1,
        beta_d1,
        mu_d1,
        alpha2_d1,
        alpha_beta_d1,
        alpha_mu_d1,
        beta2_d1,
        beta_mu_d1,
        mu2_d1,
        alpha3_d1,
        alpha2_beta_d1,
        alpha2_mu_d1,
        alpha_beta2_d1,
        alpha_mu2_d1,
        beta3_d1,
        beta2_mu_d1,
        beta_mu2_d1,
        mu3_d1,
    ])
}

/// Values of the 19 monomials `basis2` of z = (`p`, `q`, `r`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 3>) -> Vector<T, 19> {
    let one = T::one();
    let p = z[0];
    let q = z[1];
    let r = z[2];
    let p2 = p * p;
    let p_q = p * q;
    let p_r = p * r;
    let q2 = q * q;
    let q_r = q * r;
    let r2 = r * r;
    let p3 = p2 * p;
    let p2_q = p2 * q;
    let p2_r = p2 * r;
    let p_q2 = p_q * q;
    let p_r2 = p_r * r;
    let q3 = q2 * q;
    let q2_r = q2 * r;
    let q_r2 = q_r * r;
    let r3 = r2 * r;
    Vector([
        one,
        p,
        q,
        r,
        p2,
        p_q,
        p_r,
        q2,
        q_r,
        r2,
        p3,
        p2_q,
        p2_r,
        p_q2,
        p_r2,
        q3,
        q2_r,
        q_r2,
        r3,
    ])
}
