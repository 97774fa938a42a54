// The fields of every generated module, for a macro `module!` of the file that includes this one. `violated` is there where a constraint is.

module!(
    active_suspension,
    params: [body_mass],
    measured: [x1 x2 x3],
    exosystems: [w2],
    initial: [params],
    state: [zeta1 zeta2 zeta3 h1 W2 th2 eps2 h2 sigma3 phi3],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 e2 alpha2 D_hat2 e3],
    plant: [drift diffusion d2]
);

module!(
    chaotic_jerk,
    params: [a b c],
    measured: [x1 x2 x3],
    exosystems: [],
    initial: [],
    state: [zeta1 zeta2 zeta3 W3 th3],
    truths: [],
    control: [u u_sat y_r e1 alpha1 e2 alpha2 e3 D_hat3],
    plant: [drift d3]
);

module!(
    flexible_joint,
    params: [weight stiffness],
    measured: [x1 x2 x3 x4],
    exosystems: [w4],
    initial: [params],
    state: [zeta1 zeta2 zeta3 zeta4 h1 W2 th2 h2 h3 th4],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 e2 alpha2 D_hat2 e3 alpha3 e4 D_hat4],
    plant: [drift d2 d4]
);

module!(
    ghv_unstable,
    params: [CL_scale CD_scale CY_scale Cl_scale Cm_scale Cn_scale],
    measured: [x1 x2],
    exosystems: [w2],
    initial: [params],
    state: [zeta1 zeta2 W1 th1 h1 W2 th2 eps2 sigma2 phi2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 D_hat1 e2 k2 D_hat2],
    plant: [drift diffusion d1 d2]
);

module!(
    missile_pitch,
    params: [CN_scale CM_scale fin_scale],
    measured: [x1 x2],
    exosystems: [],
    initial: [params],
    state: [zeta1 zeta2 th1 h1 W2 th2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 D_hat1 e2 D_hat2],
    plant: [drift d1 d2]
);

module!(
    motor_arm,
    params: [load_mass],
    measured: [x1 x2 x3],
    exosystems: [w2],
    initial: [params],
    state: [zeta1 zeta2 zeta3 h1 W2 th2 eps2 sigma2 phi2 h2 th3],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 e2 alpha2 D_hat2 e3 D_hat3],
    plant: [drift diffusion d2 d3]
);

module!(
    nsv_attitude,
    params: [CL_scale CD_scale CY_scale Cl_scale Cm_scale Cn_scale],
    measured: [x1 x2],
    exosystems: [w2],
    initial: [params],
    state: [zeta1 zeta2 W1 th1 h1 W2 th2 eps2 sigma2 phi2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 D_hat1 e2 k2 D_hat2],
    plant: [drift diffusion d1 d2]
);

module!(
    nsv_six_dof,
    params: [CL_scale CD_scale CY_scale Cl_scale Cm_scale Cn_scale],
    measured: [x1 x2],
    exosystems: [w2],
    initial: [params],
    state: [zeta1 zeta2 W1 th1 h1 W2 th2 eps2 sigma2 phi2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 D_hat1 e2 k2 D_hat2],
    plant: [drift diffusion d1 d2]
);

module!(
    pendulum,
    params: [mass],
    measured: [x1 x2],
    exosystems: [],
    initial: [],
    state: [zeta1 zeta2 h1 W2 th2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 e2 D_hat2],
    plant: [drift d2]
);

module!(
    quadrotor,
    params: [roll_scale pitch_scale yaw_scale],
    measured: [x1 x2],
    exosystems: [w2],
    initial: [],
    state: [zeta1 zeta2 h1 W2 th2 eps2 sigma2 phi2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 e2 D_hat2],
    plant: [drift diffusion d2]
);

module!(
    six_joint_arm,
    params: [load dry_scale],
    measured: [x1 x2],
    exosystems: [],
    initial: [],
    state: [zeta1 zeta2 h1 th2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 e2 D_hat2],
    plant: [drift d2]
);

module!(
    surface_vessel,
    params: [added_scale damping_scale],
    measured: [x1 x2],
    exosystems: [w2],
    initial: [],
    state: [zeta1 zeta2 th1 h1 W2 th2 eps2 sigma2 phi2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 D_hat1 e2 D_hat2],
    plant: [drift diffusion d1 d2]
);

module!(
    two_link_arm,
    params: [m_e],
    measured: [x1 x2],
    exosystems: [w2],
    initial: [],
    state: [zeta1 zeta2 h1 W2 th2 eps2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 e2 k2 D_hat2],
    plant: [drift d2]
);

module!(
    underwater_vehicle,
    params: [added_scale drag_scale torque_scale],
    measured: [x1 x2],
    exosystems: [w2],
    initial: [],
    state: [zeta1 zeta2 th1 h1 W2 th2 eps2 sigma2 phi2],
    truths: [violated],
    control: [u u_sat y_r e1 k1 alpha1 D_hat1 e2 D_hat2],
    plant: [drift diffusion d1 d2]
);
