// Slow twins of all kernels, for tests: inputs in the plan's order, then rows or equations.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p sheave-eqgen -- write` writes it anew.

pub fn simple_drive<N: Number>(inputs: &[N]) -> Vec<N> {
    let omega_I = inputs[0];
    let omega_O = inputs[1];
    let M_I = inputs[2];
    let M_O = inputs[3];
    let F_CI = inputs[4];
    let F_CO = inputs[5];
    let v_0 = inputs[6];
    let u = inputs[7];
    let r_I = inputs[8];
    let r_O = inputs[9];
    let phi_O = inputs[10];
    let EA = inputs[11];
    let m_star = inputs[12];
    let mu_star = inputs[13];
    let delta_0 = inputs[14];
    let tan_delta = (delta_0).tan();
    let K = (EA) * ((v_0).power(2)) * (m_star)
        * (((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star))).power(-1));
    let L_Oin = (N::number(-1.0 / 1.0)) * (EA) * ((v_0).power(-1))
        * ((v_0) + ((N::number(-1.0 / 1.0)) * (r_O) * (omega_O)));
    let L_Iin = (N::number(-1.0 / 1.0)) * (EA) * ((v_0).power(-1))
        * ((v_0) + ((N::number(-1.0 / 1.0)) * (r_I) * (omega_I)));
    let ratio_O = ((r_O).power(-1))
        * (((L_Oin) + ((N::number(-1.0 / 1.0)) * (K))).power(-1))
        * (((r_O) * (L_Oin)) + ((N::number(-1.0 / 1.0)) * (r_O) * (K)) + (M_O));
    let ratio_I = ((r_I).power(-1))
        * (((K) + ((N::number(-1.0 / 1.0)) * (L_Iin))).power(-1))
        * (((r_I) * (K)) + ((N::number(-1.0 / 1.0)) * (r_I) * (L_Iin))
            + ((N::number(-1.0 / 1.0)) * (M_I)));
    let log_O = (ratio_O).ln();
    let Phi_O = ((mu_star).power(-1)) * (log_O);
    let log_I = (ratio_I).ln();
    let Phi_I = (N::number(-1.0 / 1.0)) * ((mu_star).power(-1)) * (log_I);
    let speed_O = ((r_I) * (omega_I))
        + ((N::number(-1.0 / 1.0))
            * (((r_O) * (omega_O))
                + (((EA).power(-1)) * (v_0) * ((r_O).power(-1)) * (M_O))));
    let speed_I = ((r_I) * (omega_I))
        + ((N::number(-1.0 / 1.0))
            * (((r_O) * (omega_O))
                + ((N::number(-1.0 / 1.0)) * ((EA).power(-1)) * (v_0) * ((r_I).power(-1))
                    * (M_I))));
    let axial_O = (F_CO)
        + ((N::number(-1.0 / 2.0)) * ((EA).power(-1)) * ((tan_delta).power(-1))
            * ((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)))
            * ((((L_Oin) + ((N::number(-1.0 / 1.0)) * (K)))
                * (((N::number(2.0 / 1.0)) * (phi_O))
                    + ((N::number(-1.0 / 1.0)) * (Phi_O))))
                + (((r_O).power(-1)) * ((mu_star).power(-1)) * (M_O))));
    let axial_I = (F_CI)
        + ((N::number(-1.0 / 2.0)) * ((EA).power(-1)) * ((tan_delta).power(-1))
            * ((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)))
            * (((((N::number(-1.0 / 1.0)) * (K)) + (L_Iin))
                * (((N::number(-1.0 / 1.0)) * (Phi_I))
                    + ((N::number(2.0 / 1.0))
                        * (((N::number(-1.0 / 1.0)) * (phi_O))
                            + (N::number(std::f64::consts::PI))))))
                + ((N::number(-1.0 / 1.0)) * ((r_I).power(-1)) * ((mu_star).power(-1))
                    * (M_I))));
    vec![speed_O, speed_I, axial_O, axial_I]
}
pub fn simple_drive_closed<N: Number>(inputs: &[N]) -> Vec<N> {
    let omega_I = inputs[0];
    let omega_O = inputs[1];
    let M_I = inputs[2];
    let M_O = inputs[3];
    let F_CI = inputs[4];
    let F_CO = inputs[5];
    let v_0 = inputs[6];
    let u = inputs[7];
    let r_I = inputs[8];
    let r_O = inputs[9];
    let phi_O = inputs[10];
    let EA = inputs[11];
    let m_star = inputs[12];
    let mu_star = inputs[13];
    let delta_0 = inputs[14];
    let tan_delta = (delta_0).tan();
    let K = (EA) * ((v_0).power(2)) * (m_star)
        * (((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star))).power(-1));
    let L_Oin = (N::number(-1.0 / 1.0)) * (EA) * ((v_0).power(-1))
        * ((v_0) + ((N::number(-1.0 / 1.0)) * (r_O) * (omega_O)));
    let L_Iin = (N::number(-1.0 / 1.0)) * (EA) * ((v_0).power(-1))
        * ((v_0) + ((N::number(-1.0 / 1.0)) * (r_I) * (omega_I)));
    let a_O = (m_star) * (phi_O) * (u);
    let b_O = ((EA) * (phi_O)) + ((tan_delta) * (F_CO));
    let c_O = (N::number(-1.0 / 1.0)) * (EA) * (phi_O) * (u);
    let root_O = (((N::number(-4.0 / 1.0)) * (a_O) * (c_O)) + ((b_O).power(2))).sqrt();
    let v_0_O = (N::number(-2.0 / 1.0)) * (c_O) * (((b_O) + (root_O)).power(-1));
    let a_I = (N::number(-1.0 / 1.0)) * (m_star) * (u)
        * ((phi_O) + ((N::number(-1.0 / 1.0)) * (N::number(std::f64::consts::PI))));
    let b_I = (N::number(-1.0 / 1.0))
        * (((EA) * (phi_O)) + ((N::number(-1.0 / 1.0)) * (tan_delta) * (F_CI))
            + ((N::number(-1.0 / 1.0)) * (N::number(std::f64::consts::PI)) * (EA)));
    let c_I = (EA) * (u)
        * ((phi_O) + ((N::number(-1.0 / 1.0)) * (N::number(std::f64::consts::PI))));
    let root_I = (((N::number(-4.0 / 1.0)) * (a_I) * (c_I)) + ((b_I).power(2))).sqrt();
    let v_0_I = (N::number(-2.0 / 1.0)) * (c_I) * (((b_I) + (root_I)).power(-1));
    let omega_O_of_M_O = ((EA).power(-1)) * ((r_O).power(-2))
        * (((EA) * (r_I) * (r_O) * (omega_I))
            + ((N::number(-1.0 / 1.0)) * (v_0) * (M_O)));
    let omega_I_of_M_O = ((EA).power(-1)) * ((r_I).power(-1)) * ((r_O).power(-1))
        * (((EA) * ((r_O).power(2)) * (omega_O)) + ((v_0) * (M_O)));
    let M_O_of_speeds = (N::number(-1.0 / 1.0)) * (EA) * ((v_0).power(-1)) * (r_O)
        * (((N::number(-1.0 / 1.0)) * (r_I) * (omega_I)) + ((r_O) * (omega_O)));
    let M_I_of_speeds = (N::number(-1.0 / 1.0)) * (EA) * ((v_0).power(-1)) * (r_I)
        * (((r_I) * (omega_I)) + ((N::number(-1.0 / 1.0)) * (r_O) * (omega_O)));
    let M_O_of_M_I = (N::number(-1.0 / 1.0)) * ((r_I).power(-1)) * (r_O) * (M_I);
    let M_I_of_M_O = (N::number(-1.0 / 1.0)) * (r_I) * ((r_O).power(-1)) * (M_O);
    let lift_off = K;
    let slack_force = L_Oin;
    let tight_force = L_Iin;
    let slack_tension = (L_Oin)
        + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)
            * ((N::number(1.0 / 1.0)) + (((EA).power(-1)) * (L_Oin))));
    let tight_tension = (L_Iin)
        + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)
            * ((N::number(1.0 / 1.0)) + (((EA).power(-1)) * (L_Iin))));
    let ratio_O = (((L_Oin) + ((N::number(-1.0 / 1.0)) * (K))).power(-1))
        * (((N::number(-1.0 / 1.0)) * (K)) + (L_Iin));
    let ratio_I = ((L_Oin) + ((N::number(-1.0 / 1.0)) * (K)))
        * ((((N::number(-1.0 / 1.0)) * (K)) + (L_Iin)).power(-1));
    let log_O = (ratio_O).ln();
    let Phi_O = ((mu_star).power(-1)) * (log_O);
    let log_I = (ratio_I).ln();
    let Phi_I = (N::number(-1.0 / 1.0)) * ((mu_star).power(-1)) * (log_I);
    let sliding_O = Phi_O;
    let F_CO_of_speeds = (N::number(1.0 / 2.0)) * ((EA).power(-1))
        * ((tan_delta).power(-1))
        * ((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)))
        * ((((L_Oin) + ((N::number(-1.0 / 1.0)) * (K)))
            * (((N::number(2.0 / 1.0)) * (phi_O)) + ((N::number(-1.0 / 1.0)) * (Phi_O))))
            + (((r_O).power(-1)) * ((mu_star).power(-1)) * (M_O_of_speeds)));
    let F_slip_O = (N::number(1.0 / 2.0)) * ((EA).power(-1)) * ((r_O).power(-1))
        * ((mu_star).power(-1)) * ((tan_delta).power(-1)) * (M_O)
        * ((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)));
    let sliding_I = Phi_I;
    let F_CI_of_speeds = (N::number(1.0 / 2.0)) * ((EA).power(-1))
        * ((tan_delta).power(-1))
        * ((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)))
        * (((((N::number(-1.0 / 1.0)) * (K)) + (L_Iin))
            * (((N::number(-1.0 / 1.0)) * (Phi_I))
                + ((N::number(2.0 / 1.0))
                    * (((N::number(-1.0 / 1.0)) * (phi_O))
                        + (N::number(std::f64::consts::PI))))))
            + ((N::number(-1.0 / 1.0)) * ((r_I).power(-1)) * ((mu_star).power(-1))
                * (M_I_of_speeds)));
    let F_slip_I = (N::number(-1.0 / 2.0)) * ((EA).power(-1)) * ((r_I).power(-1))
        * ((mu_star).power(-1)) * ((tan_delta).power(-1)) * (M_I)
        * ((EA) + ((N::number(-1.0 / 1.0)) * ((v_0).power(2)) * (m_star)));
    vec![
        v_0_O, v_0_I, omega_O_of_M_O, omega_I_of_M_O, M_O_of_speeds, M_I_of_speeds,
        M_O_of_M_I, M_I_of_M_O, lift_off, slack_force, tight_force, slack_tension,
        tight_tension, sliding_O, sliding_I, F_CO_of_speeds, F_CI_of_speeds, F_slip_O,
        F_slip_I
    ]
}
pub fn belt_pulley<N: Number>(inputs: &[N]) -> Vec<N> {
    let V_A = inputs[0];
    let F_A = inputs[1];
    let V_B = inputs[2];
    let F_B = inputs[3];
    let omega = inputs[4];
    let alpha = inputs[5];
    let T_S = inputs[6];
    let R = inputs[7];
    let J = inputs[8];
    let b = inputs[9];
    let rho = inputs[10];
    let wrap = inputs[11];
    let f = inputs[12];
    let V_thr = inputs[13];
    let F_thr = inputs[14];
    let V_rel = ((N::number(-1.0 / 1.0)) * (R) * (omega)) + (V_B);
    let F_C = ((V_B).power(2)) * (rho);
    let reached = ((N::number(4.0 / 1.0)) * ((V_thr).power(-1)) * (V_rel)).tanh();
    let mu = (N::number(-1.0 / 1.0)) * (f) * (reached);
    let euler = ((mu) * (wrap)).exp();
    let excess = (F_B) + ((N::number(-1.0 / 1.0)) * (F_C));
    let size = (((excess).power(2)) + ((F_thr).power(2))).sqrt();
    let pressing = (N::number(1.0 / 2.0)) * ((excess) + (size));
    let opposite = (V_B) + (V_A);
    let equal = ((N::number(-1.0 / 1.0)) * (V_B)) + (V_A);
    let adhesion = V_rel;
    let friction = ((N::number(-1.0 / 1.0)) * (F_B)) + (F_A)
        + ((N::number(-1.0 / 1.0)) * (pressing) * ((N::number(-1.0 / 1.0)) + (euler)));
    let torque = (T_S)
        + ((N::number(-1.0 / 1.0))
            * (((R) * (F_B)) + ((N::number(-1.0 / 1.0)) * (R) * (F_A))
                + ((N::number(-1.0 / 1.0)) * (omega) * (b))
                + ((N::number(-1.0 / 1.0)) * (J) * (alpha))));
    let relative_velocity = V_rel;
    let centrifugal_tension = F_C;
    let friction_coefficient = mu;
    let belt_power = (V_B) * ((F_B) + ((N::number(-1.0 / 1.0)) * (F_A)));
    let shaft_power = ((R) * (omega) * (F_B))
        + ((N::number(-1.0 / 1.0)) * (R) * (omega) * (F_A))
        + ((N::number(-1.0 / 1.0)) * (omega) * (J) * (alpha))
        + ((N::number(-1.0 / 1.0)) * ((omega).power(2)) * (b));
    let friction_loss = (V_rel) * ((F_B) + ((N::number(-1.0 / 1.0)) * (F_A)));
    let bearing_loss = ((omega).power(2)) * (b);
    let kinetic_power = (omega) * (J) * (alpha);
    vec![
        opposite, equal, adhesion, friction, torque, relative_velocity,
        centrifugal_tension, friction_coefficient, belt_power, shaft_power,
        friction_loss, bearing_loss, kinetic_power
    ]
}
pub fn belt_pulley_limits<N: Number>(inputs: &[N]) -> Vec<N> {
    let f_face = inputs[0];
    let groove = inputs[1];
    let f = inputs[2];
    let wrap = inputs[3];
    let T_tight = inputs[4];
    let T_slack = inputs[5];
    let R = inputs[6];
    let V_thr = inputs[7];
    let ratio = ((T_slack).power(-1)) * (T_tight);
    let log_ratio = (ratio).ln();
    let capstan = ((f) * (wrap)).exp();
    let wedge_coefficient = (f_face)
        * ((((N::number(1.0 / 2.0)) * (groove)).sin()).power(-1));
    let tension_ratio = ratio;
    let largest_ratio = capstan;
    let mean_coefficient = ((wrap).power(-1)) * (log_ratio);
    let used = ((f).power(-1)) * (mean_coefficient);
    let share = used;
    let odds = ((N::number(1.0 / 1.0)) + (used))
        * (((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (used))).power(-1));
    let log_odds = (odds).ln();
    let creep = (N::number(1.0 / 8.0)) * (V_thr) * (log_odds);
    let moment = (R) * (((N::number(-1.0 / 1.0)) * (T_slack)) + (T_tight));
    vec![
        wedge_coefficient, tension_ratio, largest_ratio, mean_coefficient, share, creep,
        moment
    ]
}
pub fn drive_sizing<N: Number>(inputs: &[N]) -> Vec<N> {
    let M_belt = inputs[0];
    let M_load = inputs[1];
    let D_in = inputs[2];
    let D_out = inputs[3];
    let F = inputs[4];
    let F_f = inputs[5];
    let T_out = inputs[6];
    let I_p1 = inputs[7];
    let I_p2 = inputs[8];
    let I_RL = inputs[9];
    let I_idlers = inputs[10];
    let alpha = inputs[11];
    let D = inputs[12];
    let I_idler = inputs[13];
    let ratio = ((D_in).power(-1)) * (D_out);
    let load_inertia = (N::number(1.0 / 4.0)) * ((D_in).power(2))
        * ((M_belt) + (M_load));
    let rotating_inertia = ((D_out).power(-2))
        * ((((D_in).power(2)) * (I_RL)) + (((D_in).power(2)) * (I_p2))
            + (((D_out).power(2)) * (I_p1)) + (((D_out).power(2)) * (I_idlers)));
    let total_inertia = (rotating_inertia) + (load_inertia);
    let external_torque = (N::number(1.0 / 2.0)) * (F) * (D_in);
    let friction_torque = (N::number(1.0 / 2.0)) * (D_in) * (F_f);
    let input_torque = (D_in) * ((D_out).power(-1)) * (T_out);
    let steady_torque = (external_torque) + (friction_torque) + (input_torque);
    let acceleration_torque = (alpha) * (total_inertia);
    let drive_torque = (steady_torque) + (acceleration_torque);
    vec![
        ratio, load_inertia, rotating_inertia, total_inertia, external_torque,
        friction_torque, input_torque, steady_torque, acceleration_torque, drive_torque
    ]
}
pub fn drive_sizing_idler<N: Number>(inputs: &[N]) -> Vec<N> {
    let M_belt = inputs[0];
    let M_load = inputs[1];
    let D_in = inputs[2];
    let D_out = inputs[3];
    let F = inputs[4];
    let F_f = inputs[5];
    let T_out = inputs[6];
    let I_p1 = inputs[7];
    let I_p2 = inputs[8];
    let I_RL = inputs[9];
    let I_idlers = inputs[10];
    let alpha = inputs[11];
    let D = inputs[12];
    let I_idler = inputs[13];
    let reflected_inertia = ((D_in).power(2)) * ((D).power(-2)) * (I_idler);
    vec![reflected_inertia]
}
pub fn flyweight_table<N: Number>(inputs: &[N]) -> Vec<N> {
    let N = inputs[0];
    let m = inputs[1];
    let omega = inputs[2];
    let C = inputs[3];
    let lost = inputs[4];
    let force = ((omega).power(2)) * (N) * (m) * (C)
        * ((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (lost)));
    vec![force]
}
pub fn flyweight_ramp<N: Number>(inputs: &[N]) -> Vec<N> {
    let N = inputs[0];
    let m = inputs[1];
    let omega = inputs[2];
    let r = inputs[3];
    let r_s = inputs[4];
    let rho = inputs[5];
    let tan_rho = (rho).tan();
    let radial = ((omega).power(2)) * (r) * (N) * (m);
    let force = (radial) * (((N::number(1.0 / 1.0)) + ((r_s) * (tan_rho))).power(-1))
        * ((r_s) + ((N::number(-1.0 / 1.0)) * (tan_rho)));
    vec![force]
}
pub fn flyweight_arm<N: Number>(inputs: &[N]) -> Vec<N> {
    let N = inputs[0];
    let m = inputs[1];
    let omega = inputs[2];
    let s = inputs[3];
    let z_0 = inputs[4];
    let R_pivot = inputs[5];
    let R_roller = inputs[6];
    let l_m = inputs[7];
    let delta = inputs[8];
    let xi = inputs[9];
    let xi_d = inputs[10];
    let rho = inputs[11];
    let tan_rho = (rho).tan();
    let z = (s) + (z_0);
    let distance = (((z).power(2))
        + (((R_roller) + ((N::number(-1.0 / 1.0)) * (R_pivot))).power(2)))
        .sqrt();
    let chi = (z).angle((R_roller) + ((N::number(-1.0 / 1.0)) * (R_pivot)));
    let theta = (chi) + ((N::number(-1.0 / 1.0)) * (xi));
    let phi_m = (theta) + (delta);
    let sin_m = (phi_m).sin();
    let cos_m = (phi_m).cos();
    let radius = (R_pivot) + ((l_m) * (sin_m));
    let moment = ((omega).power(2)) * (N) * (m) * (l_m) * (radius) * (cos_m);
    let tan_e = (distance) * (xi_d);
    let tan_t = (((N::number(1.0 / 1.0))
        + ((N::number(-1.0 / 1.0)) * (tan_rho) * (tan_e)))
        .power(-1)) * ((tan_rho) + (tan_e));
    let distance_s = ((distance).power(-1)) * (z);
    let radius_s = (N::number(-1.0 / 1.0)) * ((distance).power(-1)) * (l_m) * (cos_m)
        * ((((distance).power(-1)) * (z) * (tan_e))
            + (((distance).power(-1))
                * ((R_roller) + ((N::number(-1.0 / 1.0)) * (R_pivot)))));
    let force = (N::number(-1.0 / 1.0)) * ((distance).power(-1)) * (moment)
        * ((((distance).power(-1)) * (z) * (tan_t))
            + (((distance).power(-1))
                * ((R_roller) + ((N::number(-1.0 / 1.0)) * (R_pivot)))));
    vec![force, distance, distance_s, radius, radius_s, moment]
}
pub fn flyweight_roller<N: Number>(inputs: &[N]) -> Vec<N> {
    let N = inputs[0];
    let m = inputs[1];
    let omega = inputs[2];
    let theta = inputs[3];
    let R_pivot = inputs[4];
    let l_roller = inputs[5];
    let l_m = inputs[6];
    let delta = inputs[7];
    let h = inputs[8];
    let h_x = inputs[9];
    let rho = inputs[10];
    let tan_rho = (rho).tan();
    let sin_r = (theta).sin();
    let cos_r = (theta).cos();
    let gap = (R_pivot) + ((l_roller) * (sin_r)) + ((N::number(-1.0 / 1.0)) * (h));
    let along = (l_roller) * (cos_r);
    let radius = (R_pivot) + ((l_m) * (((theta) + (delta)).sin()));
    let moment = ((omega).power(2)) * (N) * (m) * (l_m) * (radius)
        * (((theta) + (delta)).cos());
    let h_t = (((N::number(1.0 / 1.0)) + ((tan_rho) * (h_x))).power(-1))
        * (((N::number(-1.0 / 1.0)) * (tan_rho)) + (h_x));
    let theta_s = (N::number(-1.0 / 1.0)) * ((l_roller).power(-1)) * (h_x)
        * ((((h_x) * (sin_r)) + ((N::number(-1.0 / 1.0)) * (cos_r))).power(-1));
    let radius_s = (N::number(-1.0 / 1.0)) * (l_m) * ((l_roller).power(-1)) * (h_x)
        * ((((h_x) * (sin_r)) + ((N::number(-1.0 / 1.0)) * (cos_r))).power(-1))
        * (((theta) + (delta)).cos());
    let force = (N::number(-1.0 / 1.0)) * (moment) * ((l_roller).power(-1)) * (h_t)
        * ((((N::number(-1.0 / 1.0)) * (cos_r)) + ((sin_r) * (h_t))).power(-1));
    vec![force, gap, along, theta_s, radius, radius_s, moment]
}
pub fn compression_spring<N: Number>(inputs: &[N]) -> Vec<N> {
    let F_0 = inputs[0];
    let c = inputs[1];
    let s = inputs[2];
    let force = ((s) * (c)) + (F_0);
    let energy = ((s) * (F_0)) + ((N::number(1.0 / 2.0)) * ((s).power(2)) * (c));
    vec![force, energy]
}
pub fn helix<N: Number>(inputs: &[N]) -> Vec<N> {
    let kappa = inputs[0];
    let phi_0 = inputs[1];
    let phi = inputs[2];
    let r_h = inputs[3];
    let tan_alpha = inputs[4];
    let share = inputs[5];
    let M = inputs[6];
    let rho = inputs[7];
    let tan_rho = (rho).tan();
    let torque = ((M) * (share)) + ((kappa) * ((phi) + (phi_0)));
    let force = (N::number(-1.0 / 1.0)) * ((r_h).power(-1)) * (torque)
        * ((N::number(-1.0 / 1.0)) + ((tan_rho) * (tan_alpha)))
        * (((tan_rho) + (tan_alpha)).power(-1));
    let turn = ((r_h).power(-1)) * ((tan_alpha).power(-1));
    vec![torque, force, turn]
}
pub fn sheave_travel<N: Number>(inputs: &[N]) -> Vec<N> {
    let beta = inputs[0];
    let R = inputs[1];
    let R_0 = inputs[2];
    let tan_beta = (beta).tan();
    let travel = (N::number(2.0 / 1.0)) * (tan_beta)
        * ((R) + ((N::number(-1.0 / 1.0)) * (R_0)));
    vec![travel]
}
pub fn vehicle_load<N: Number>(inputs: &[N]) -> Vec<N> {
    let omega_S = inputs[0];
    let i_f = inputs[1];
    let r_w = inputs[2];
    let m_v = inputs[3];
    let g_0 = inputs[4];
    let c_r = inputs[5];
    let tan_slope = inputs[6];
    let rho_air = inputs[7];
    let CdA = inputs[8];
    let eta_f = inputs[9];
    let a = inputs[10];
    let tilt = (N::number(1.0 / 1.0)) + ((tan_slope).power(2));
    let incline = (tilt).sqrt();
    let speed = ((i_f).power(-1)) * (omega_S) * (r_w);
    let resistance = ((N::number(1.0 / 2.0)) * ((speed).power(2)) * (rho_air) * (CdA))
        + (((incline).power(-1)) * (m_v) * (g_0) * ((tan_slope) + (c_r)));
    let torque = ((i_f).power(-1)) * ((eta_f).power(-1)) * (r_w)
        * (((m_v) * (a)) + (resistance));
    let torque_a = ((i_f).power(-1)) * ((eta_f).power(-1)) * (r_w) * (m_v);
    vec![speed, resistance, torque, torque_a]
}
pub fn hysteresis_contact<N: Number>(inputs: &[N]) -> Vec<N> {
    let T = inputs[0];
    let theta = inputs[1];
    let theta1 = inputs[2];
    let theta2 = inputs[3];
    let x = inputs[4];
    let T_hat_1 = inputs[5];
    let Phi = inputs[6];
    let R = inputs[7];
    let flow = inputs[8];
    let EA = inputs[9];
    let m_o = inputs[10];
    let R_P = inputs[11];
    let omega_P = inputs[12];
    let theta_1 = (theta1) * ((Phi).power(-1));
    let theta_2 = (theta2) * ((Phi).power(-2));
    let arc = (((N::number(-1.0 / 1.0)) * (x)) + (R)) * (((theta).cos()).power(-1));
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((T) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((T) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let material = (Phi) * (arc) * ((stretch).power(-1));
    let curvature = ((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (theta_1)))
        * ((((N::number(-1.0 / 1.0)) * (x)) + (R)).power(-1)) * ((theta).cos());
    let curvature_slope = (N::number(-1.0 / 1.0)) * (stretch)
        * (((x) + ((N::number(-1.0 / 1.0)) * (R))).power(-2))
        * (((theta_2) * ((theta).cos())) + ((theta).sin())
            + ((N::number(-1.0 / 1.0)) * ((theta_1).power(2)) * ((theta).sin())))
        * ((theta).cos());
    let penetration_slope = (N::number(-1.0 / 1.0)) * (stretch) * ((theta).sin());
    let strain = ((EA).power(-1)) * (F);
    let strain_slope = (m_o) * (T_hat_1) * ((material).power(-1))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    vec![material, curvature, curvature_slope, strain, strain_slope, penetration_slope]
}
pub fn hysteresis_span<N: Number>(inputs: &[N]) -> Vec<N> {
    let tau = inputs[0];
    let vartheta1 = inputs[1];
    let vartheta2 = inputs[2];
    let tau_hat_1 = inputs[3];
    let L = inputs[4];
    let flow = inputs[5];
    let EA = inputs[6];
    let m_o = inputs[7];
    let R_P = inputs[8];
    let omega_P = inputs[9];
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((tau) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((tau) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let material = (L) * ((stretch).power(-1));
    let curvature = (vartheta1) * ((L).power(-1));
    let curvature_slope = (vartheta2) * ((L).power(-2)) * (stretch);
    let strain = ((EA).power(-1)) * (F);
    let strain_slope = (m_o) * (tau_hat_1) * ((material).power(-1))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    vec![material, curvature, curvature_slope, strain, strain_slope]
}
pub fn hysteresis<N: Number>(inputs: &[N]) -> Vec<N> {
    let flow = inputs[0];
    let EA = inputs[1];
    let m_o = inputs[2];
    let R_P = inputs[3];
    let omega_P = inputs[4];
    let EI = inputs[5];
    let k = inputs[6];
    let beta = inputs[7];
    let L_0 = inputs[8];
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let revolutions = ((m_o).power(-1)) * (G) * ((L_0).power(-1));
    let bending = ((N::number(std::f64::consts::PI)).power(-1)) * (EI) * (L_0)
        * (revolutions);
    let groove = ((N::number(std::f64::consts::PI)).power(-1)) * (k) * (L_0)
        * (revolutions) * ((beta).sin()) * (((beta).cos()).power(-1));
    let cord = ((N::number(std::f64::consts::PI)).power(-1)) * (EA) * (L_0)
        * (revolutions);
    vec![revolutions, bending, groove, cord]
}
pub fn loss_balance<N: Number>(inputs: &[N]) -> Vec<N> {
    let driving = inputs[0];
    let overall = inputs[1];
    let hysteresis = inputs[2];
    let omega_P = inputs[3];
    let omega_S = inputs[4];
    let drag_P = inputs[5];
    let drag_S = inputs[6];
    let viscous_P = inputs[7];
    let viscous_S = inputs[8];
    let gear_efficiency = inputs[9];
    let driven = (driving) * (overall);
    let primary_drag = (omega_P) * (((omega_P) * (viscous_P)) + (drag_P));
    let secondary_drag = (omega_S) * (((omega_S) * (viscous_S)) + (drag_S));
    let gears = ((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (gear_efficiency)))
        * ((driven) + ((N::number(-1.0 / 1.0)) * (hysteresis))
            + ((N::number(-1.0 / 1.0)) * (primary_drag))
            + ((N::number(-1.0 / 1.0)) * (secondary_drag)));
    let total = (hysteresis) + (primary_drag) + (secondary_drag) + (gears);
    let delivered = (driven) + ((N::number(-1.0 / 1.0)) * (total));
    let efficiency = (overall)
        + ((N::number(-1.0 / 1.0)) * ((driving).power(-1)) * (total));
    vec![primary_drag, secondary_drag, gears, total, delivered, efficiency]
}
/// All twins by the names of their kernels.
#[allow(clippy::type_complexity)]
pub fn all<N: Number>() -> Vec<(&'static str, fn(&[N]) -> Vec<N>)> {
    vec![
        ("simple_drive", simple_drive:: < N >), ("simple_drive_closed",
        simple_drive_closed:: < N >), ("belt_pulley", belt_pulley:: < N >),
        ("belt_pulley_limits", belt_pulley_limits:: < N >), ("drive_sizing",
        drive_sizing:: < N >), ("drive_sizing_idler", drive_sizing_idler:: < N >),
        ("flyweight_table", flyweight_table:: < N >), ("flyweight_ramp", flyweight_ramp::
        < N >), ("flyweight_arm", flyweight_arm:: < N >), ("flyweight_roller",
        flyweight_roller:: < N >), ("compression_spring", compression_spring:: < N >),
        ("helix", helix:: < N >), ("sheave_travel", sheave_travel:: < N >),
        ("vehicle_load", vehicle_load:: < N >), ("hysteresis_contact",
        hysteresis_contact:: < N >), ("hysteresis_span", hysteresis_span:: < N >),
        ("hysteresis", hysteresis:: < N >), ("loss_balance", loss_balance:: < N >)
    ]
}
