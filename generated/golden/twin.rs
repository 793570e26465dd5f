// Slow twins of all kernels, for tests: inputs in the plan's order, then rows or equations.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p sheave-eqgen -- write` writes it anew.

pub fn contact_linearised_viscous_coulomb<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let T = inputs[1];
    let theta = inputs[2];
    let theta1 = inputs[3];
    let theta2 = inputs[4];
    let x = inputs[5];
    let Phi = inputs[6];
    let sigma = inputs[7];
    let flow = inputs[8];
    let EA = inputs[9];
    let EI = inputs[10];
    let k = inputs[11];
    let m_o = inputs[12];
    let R = inputs[13];
    let R_P = inputs[14];
    let beta = inputs[15];
    let mu_k = inputs[16];
    let v_thr = inputs[17];
    let omega_P = inputs[18];
    let theta_1 = (theta1) * ((Phi).power(-1));
    let theta_2 = (theta2) * ((Phi).power(-2));
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((T) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((T) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let omega = (sigma) * (omega_P);
    let r = ((N::number(-1.0 / 1.0)) * (x)) + (R);
    let arc = (((N::number(-1.0 / 1.0)) * (x)) + (R)) * (((theta).cos()).power(-1));
    let tan_theta = (theta).tan();
    let v_r = (V) * ((theta).sin());
    let v_t = ((N::number(-1.0 / 1.0)) * (omega)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R))) + ((V) * ((theta).cos()));
    let v_0 = N::number(0.000000000001);
    let speed = (((v_0).power(2)) + ((v_r).power(2)) + ((v_t).power(2))).sqrt();
    let slip = ((v_thr).power(-1)) * (speed);
    let saturation = (slip).saturate();
    let mu = (mu_k) * (saturation);
    let face_speed = ((((v_r).power(2)) * (((beta).sin()).power(2))
        * (((beta).cos()).power(-2))) + ((speed).power(2)))
        .sqrt();
    let f_r = (v_r) * ((face_speed).power(-1)) * (mu);
    let f_t = (v_t) * ((face_speed).power(-1)) * (mu);
    let p = (N::number(1.0 / 2.0)) * (x) * (k)
        * ((((f_r) * ((beta).sin()) * (((beta).cos()).power(-1))) + ((beta).cos()))
            .power(-1));
    let q = (N::number(2.0 / 1.0)) * (r) * (p);
    let n = (q)
        * (((tan_theta) * (f_t)) + ((N::number(-1.0 / 1.0)) * (f_r)) + ((beta).sin()));
    let t = (q)
        * (((tan_theta) * ((f_r) + ((N::number(-1.0 / 1.0)) * ((beta).sin())))) + (f_t));
    let M_b = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-1))
        * ((N::number(-1.0 / 1.0)) + (theta_1));
    let Q = (N::number(-1.0 / 1.0)) * (EI) * ((R).power(-3))
        * (((N::number(-1.0 / 1.0)) * (x) * (tan_theta)) + ((R) * (theta_2))
            + ((R) * (tan_theta)));
    let theta_30 = ((x) + ((N::number(-1.0 / 1.0)) * (R)))
        * ((((N::number(2.0 / 1.0)) * (x)) + (R)).power(-1))
        * ((theta_1) + ((theta_1) * ((tan_theta).power(2))) + ((tan_theta).power(2)));
    let Q_theta3 = (N::number(-1.0 / 1.0)) * (EI) * ((R).power(-3))
        * (((N::number(2.0 / 1.0)) * (x)) + (R));
    let theta_3 = (theta_30)
        + ((N::number(-1.0 / 1.0)) * ((Q_theta3).power(-1))
            * (((N::number(-1.0 / 1.0)) * (T)) + ((T) * (theta_1)) + (n)));
    let T_hat_1 = (Phi)
        * ((t)
            + ((N::number(-1.0 / 1.0)) * (Q)
                * ((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (theta_1)))));
    let theta_hat_3 = ((Phi).power(3)) * (theta_3);
    let x_hat_1 = (N::number(-1.0 / 1.0)) * (Phi) * (tan_theta)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let axial = (N::number(1.0 / 2.0)) * (x) * (k);
    let loss_radial = (N::number(2.0 / 1.0)) * (v_r) * (f_r) * (p)
        * (((beta).cos()).power(-2));
    let loss_tangential = (N::number(2.0 / 1.0)) * (v_t) * (f_t) * (p);
    let loss = (loss_radial) + (loss_tangential);
    let M_hat_1 = (Phi) * (arc) * (f_t) * (q);
    let A_hat_1 = (Phi) * (arc) * (axial);
    let L_o_hat_1 = (Phi) * (arc) * ((stretch).power(-1));
    let W_hat_1 = (Phi) * (arc) * (loss);
    let A_x_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).cos());
    let A_y_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).sin());
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = ((N::number(-1.0 / 2.0)) * ((x).power(2)) * (k) * ((beta).sin())
        * (((beta).cos()).power(-1)))
        + ((N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2)));
    let E_hat_1 = (T_hat_1) * (V_T) * (stored);
    let gamma_a = (v_r).angle(v_t);
    let gamma = (gamma_a).turn();
    let beta_s = (speed).angle((v_r) * ((beta).sin()) * (((beta).cos()).power(-1)));
    let loss_phi = (arc) * (loss);
    vec![
        T_hat_1, theta1, theta2, theta_hat_3, x_hat_1, M_hat_1, A_hat_1, L_o_hat_1,
        W_hat_1, A_x_hat_1, A_y_hat_1, E_hat_1
    ]
}
pub fn contact_linearised_tanh<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let T = inputs[1];
    let theta = inputs[2];
    let theta1 = inputs[3];
    let theta2 = inputs[4];
    let x = inputs[5];
    let Phi = inputs[6];
    let sigma = inputs[7];
    let flow = inputs[8];
    let EA = inputs[9];
    let EI = inputs[10];
    let k = inputs[11];
    let m_o = inputs[12];
    let R = inputs[13];
    let R_P = inputs[14];
    let beta = inputs[15];
    let mu_k = inputs[16];
    let v_thr = inputs[17];
    let omega_P = inputs[18];
    let theta_1 = (theta1) * ((Phi).power(-1));
    let theta_2 = (theta2) * ((Phi).power(-2));
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((T) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((T) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let omega = (sigma) * (omega_P);
    let r = ((N::number(-1.0 / 1.0)) * (x)) + (R);
    let arc = (((N::number(-1.0 / 1.0)) * (x)) + (R)) * (((theta).cos()).power(-1));
    let tan_theta = (theta).tan();
    let v_r = (V) * ((theta).sin());
    let v_t = ((N::number(-1.0 / 1.0)) * (omega)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R))) + ((V) * ((theta).cos()));
    let v_0 = N::number(0.000000000001);
    let speed = (((v_0).power(2)) + ((v_r).power(2)) + ((v_t).power(2))).sqrt();
    let slip = ((v_thr).power(-1)) * (speed);
    let saturation = ((N::number(4.0 / 1.0)) * (slip)).tanh();
    let mu = (mu_k) * (saturation);
    let face_speed = ((((v_r).power(2)) * (((beta).sin()).power(2))
        * (((beta).cos()).power(-2))) + ((speed).power(2)))
        .sqrt();
    let f_r = (v_r) * ((face_speed).power(-1)) * (mu);
    let f_t = (v_t) * ((face_speed).power(-1)) * (mu);
    let p = (N::number(1.0 / 2.0)) * (x) * (k)
        * ((((f_r) * ((beta).sin()) * (((beta).cos()).power(-1))) + ((beta).cos()))
            .power(-1));
    let q = (N::number(2.0 / 1.0)) * (r) * (p);
    let n = (q)
        * (((tan_theta) * (f_t)) + ((N::number(-1.0 / 1.0)) * (f_r)) + ((beta).sin()));
    let t = (q)
        * (((tan_theta) * ((f_r) + ((N::number(-1.0 / 1.0)) * ((beta).sin())))) + (f_t));
    let M_b = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-1))
        * ((N::number(-1.0 / 1.0)) + (theta_1));
    let Q = (N::number(-1.0 / 1.0)) * (EI) * ((R).power(-3))
        * (((N::number(-1.0 / 1.0)) * (x) * (tan_theta)) + ((R) * (theta_2))
            + ((R) * (tan_theta)));
    let theta_30 = ((x) + ((N::number(-1.0 / 1.0)) * (R)))
        * ((((N::number(2.0 / 1.0)) * (x)) + (R)).power(-1))
        * ((theta_1) + ((theta_1) * ((tan_theta).power(2))) + ((tan_theta).power(2)));
    let Q_theta3 = (N::number(-1.0 / 1.0)) * (EI) * ((R).power(-3))
        * (((N::number(2.0 / 1.0)) * (x)) + (R));
    let theta_3 = (theta_30)
        + ((N::number(-1.0 / 1.0)) * ((Q_theta3).power(-1))
            * (((N::number(-1.0 / 1.0)) * (T)) + ((T) * (theta_1)) + (n)));
    let T_hat_1 = (Phi)
        * ((t)
            + ((N::number(-1.0 / 1.0)) * (Q)
                * ((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (theta_1)))));
    let theta_hat_3 = ((Phi).power(3)) * (theta_3);
    let x_hat_1 = (N::number(-1.0 / 1.0)) * (Phi) * (tan_theta)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let axial = (N::number(1.0 / 2.0)) * (x) * (k);
    let loss_radial = (N::number(2.0 / 1.0)) * (v_r) * (f_r) * (p)
        * (((beta).cos()).power(-2));
    let loss_tangential = (N::number(2.0 / 1.0)) * (v_t) * (f_t) * (p);
    let loss = (loss_radial) + (loss_tangential);
    let M_hat_1 = (Phi) * (arc) * (f_t) * (q);
    let A_hat_1 = (Phi) * (arc) * (axial);
    let L_o_hat_1 = (Phi) * (arc) * ((stretch).power(-1));
    let W_hat_1 = (Phi) * (arc) * (loss);
    let A_x_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).cos());
    let A_y_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).sin());
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = ((N::number(-1.0 / 2.0)) * ((x).power(2)) * (k) * ((beta).sin())
        * (((beta).cos()).power(-1)))
        + ((N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2)));
    let E_hat_1 = (T_hat_1) * (V_T) * (stored);
    let gamma_a = (v_r).angle(v_t);
    let gamma = (gamma_a).turn();
    let beta_s = (speed).angle((v_r) * ((beta).sin()) * (((beta).cos()).power(-1)));
    let loss_phi = (arc) * (loss);
    vec![
        T_hat_1, theta1, theta2, theta_hat_3, x_hat_1, M_hat_1, A_hat_1, L_o_hat_1,
        W_hat_1, A_x_hat_1, A_y_hat_1, E_hat_1
    ]
}
pub fn contact_full_viscous_coulomb<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let T = inputs[1];
    let theta = inputs[2];
    let theta1 = inputs[3];
    let theta2 = inputs[4];
    let x = inputs[5];
    let Phi = inputs[6];
    let sigma = inputs[7];
    let flow = inputs[8];
    let EA = inputs[9];
    let EI = inputs[10];
    let k = inputs[11];
    let m_o = inputs[12];
    let R = inputs[13];
    let R_P = inputs[14];
    let beta = inputs[15];
    let mu_k = inputs[16];
    let v_thr = inputs[17];
    let omega_P = inputs[18];
    let theta_1 = (theta1) * ((Phi).power(-1));
    let theta_2 = (theta2) * ((Phi).power(-2));
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((T) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((T) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let omega = (sigma) * (omega_P);
    let r = ((N::number(-1.0 / 1.0)) * (x)) + (R);
    let arc = (((N::number(-1.0 / 1.0)) * (x)) + (R)) * (((theta).cos()).power(-1));
    let tan_theta = (theta).tan();
    let v_r = (V) * ((theta).sin());
    let v_t = ((N::number(-1.0 / 1.0)) * (omega)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R))) + ((V) * ((theta).cos()));
    let v_0 = N::number(0.000000000001);
    let speed = (((v_0).power(2)) + ((v_r).power(2)) + ((v_t).power(2))).sqrt();
    let slip = ((v_thr).power(-1)) * (speed);
    let saturation = (slip).saturate();
    let mu = (mu_k) * (saturation);
    let face_speed = ((((v_r).power(2)) * (((beta).sin()).power(2))
        * (((beta).cos()).power(-2))) + ((speed).power(2)))
        .sqrt();
    let f_r = (v_r) * ((face_speed).power(-1)) * (mu);
    let f_t = (v_t) * ((face_speed).power(-1)) * (mu);
    let p = (N::number(1.0 / 2.0)) * (x) * (k)
        * ((((f_r) * ((beta).sin()) * (((beta).cos()).power(-1))) + ((beta).cos()))
            .power(-1));
    let q = (N::number(2.0 / 1.0)) * (r) * (p);
    let n = (q)
        * (((tan_theta) * (f_t)) + ((N::number(-1.0 / 1.0)) * (f_r)) + ((beta).sin()));
    let t = (q)
        * (((tan_theta) * ((f_r) + ((N::number(-1.0 / 1.0)) * ((beta).sin())))) + (f_t));
    let M_b = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-1))
        * ((N::number(-1.0 / 1.0)) + (theta_1));
    let Q = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-2))
        * ((theta_2) + (tan_theta)
            + ((N::number(-1.0 / 1.0)) * ((theta_1).power(2)) * (tan_theta)));
    let theta_30 = (N::number(-1.0 / 1.0))
        * ((theta_1) + ((N::number(-4.0 / 1.0)) * (theta_1) * (theta_2) * (tan_theta))
            + ((N::number(-1.0 / 1.0)) * (theta_1) * ((tan_theta).power(2)))
            + ((N::number(-2.0 / 1.0)) * (theta_2) * (tan_theta))
            + ((N::number(2.0 / 1.0)) * ((theta_1).power(2)) * ((tan_theta).power(2)))
            + ((N::number(-1.0 / 1.0)) * ((theta_1).power(3)))
            + (((theta_1).power(3)) * ((tan_theta).power(2)))
            + ((N::number(-2.0 / 1.0)) * ((tan_theta).power(2))));
    let Q_theta3 = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-2));
    let theta_3 = (theta_30)
        + ((N::number(-1.0 / 1.0)) * ((Q_theta3).power(-1))
            * (((N::number(-1.0 / 1.0)) * (T)) + ((T) * (theta_1)) + (n)));
    let T_hat_1 = (Phi)
        * ((t)
            + ((N::number(-1.0 / 1.0)) * (Q)
                * ((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (theta_1)))));
    let theta_hat_3 = ((Phi).power(3)) * (theta_3);
    let x_hat_1 = (N::number(-1.0 / 1.0)) * (Phi) * (tan_theta)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let axial = (N::number(1.0 / 2.0)) * (x) * (k);
    let loss_radial = (N::number(2.0 / 1.0)) * (v_r) * (f_r) * (p)
        * (((beta).cos()).power(-2));
    let loss_tangential = (N::number(2.0 / 1.0)) * (v_t) * (f_t) * (p);
    let loss = (loss_radial) + (loss_tangential);
    let M_hat_1 = (Phi) * (arc) * (f_t) * (q);
    let A_hat_1 = (Phi) * (arc) * (axial);
    let L_o_hat_1 = (Phi) * (arc) * ((stretch).power(-1));
    let W_hat_1 = (Phi) * (arc) * (loss);
    let A_x_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).cos());
    let A_y_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).sin());
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = ((N::number(-1.0 / 2.0)) * ((x).power(2)) * (k) * ((beta).sin())
        * (((beta).cos()).power(-1)))
        + ((N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2)));
    let E_hat_1 = (T_hat_1) * (V_T) * (stored);
    let gamma_a = (v_r).angle(v_t);
    let gamma = (gamma_a).turn();
    let beta_s = (speed).angle((v_r) * ((beta).sin()) * (((beta).cos()).power(-1)));
    let loss_phi = (arc) * (loss);
    vec![
        T_hat_1, theta1, theta2, theta_hat_3, x_hat_1, M_hat_1, A_hat_1, L_o_hat_1,
        W_hat_1, A_x_hat_1, A_y_hat_1, E_hat_1
    ]
}
pub fn contact_full_tanh<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let T = inputs[1];
    let theta = inputs[2];
    let theta1 = inputs[3];
    let theta2 = inputs[4];
    let x = inputs[5];
    let Phi = inputs[6];
    let sigma = inputs[7];
    let flow = inputs[8];
    let EA = inputs[9];
    let EI = inputs[10];
    let k = inputs[11];
    let m_o = inputs[12];
    let R = inputs[13];
    let R_P = inputs[14];
    let beta = inputs[15];
    let mu_k = inputs[16];
    let v_thr = inputs[17];
    let omega_P = inputs[18];
    let theta_1 = (theta1) * ((Phi).power(-1));
    let theta_2 = (theta2) * ((Phi).power(-2));
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((T) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((T) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let omega = (sigma) * (omega_P);
    let r = ((N::number(-1.0 / 1.0)) * (x)) + (R);
    let arc = (((N::number(-1.0 / 1.0)) * (x)) + (R)) * (((theta).cos()).power(-1));
    let tan_theta = (theta).tan();
    let v_r = (V) * ((theta).sin());
    let v_t = ((N::number(-1.0 / 1.0)) * (omega)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R))) + ((V) * ((theta).cos()));
    let v_0 = N::number(0.000000000001);
    let speed = (((v_0).power(2)) + ((v_r).power(2)) + ((v_t).power(2))).sqrt();
    let slip = ((v_thr).power(-1)) * (speed);
    let saturation = ((N::number(4.0 / 1.0)) * (slip)).tanh();
    let mu = (mu_k) * (saturation);
    let face_speed = ((((v_r).power(2)) * (((beta).sin()).power(2))
        * (((beta).cos()).power(-2))) + ((speed).power(2)))
        .sqrt();
    let f_r = (v_r) * ((face_speed).power(-1)) * (mu);
    let f_t = (v_t) * ((face_speed).power(-1)) * (mu);
    let p = (N::number(1.0 / 2.0)) * (x) * (k)
        * ((((f_r) * ((beta).sin()) * (((beta).cos()).power(-1))) + ((beta).cos()))
            .power(-1));
    let q = (N::number(2.0 / 1.0)) * (r) * (p);
    let n = (q)
        * (((tan_theta) * (f_t)) + ((N::number(-1.0 / 1.0)) * (f_r)) + ((beta).sin()));
    let t = (q)
        * (((tan_theta) * ((f_r) + ((N::number(-1.0 / 1.0)) * ((beta).sin())))) + (f_t));
    let M_b = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-1))
        * ((N::number(-1.0 / 1.0)) + (theta_1));
    let Q = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-2))
        * ((theta_2) + (tan_theta)
            + ((N::number(-1.0 / 1.0)) * ((theta_1).power(2)) * (tan_theta)));
    let theta_30 = (N::number(-1.0 / 1.0))
        * ((theta_1) + ((N::number(-4.0 / 1.0)) * (theta_1) * (theta_2) * (tan_theta))
            + ((N::number(-1.0 / 1.0)) * (theta_1) * ((tan_theta).power(2)))
            + ((N::number(-2.0 / 1.0)) * (theta_2) * (tan_theta))
            + ((N::number(2.0 / 1.0)) * ((theta_1).power(2)) * ((tan_theta).power(2)))
            + ((N::number(-1.0 / 1.0)) * ((theta_1).power(3)))
            + (((theta_1).power(3)) * ((tan_theta).power(2)))
            + ((N::number(-2.0 / 1.0)) * ((tan_theta).power(2))));
    let Q_theta3 = (N::number(-1.0 / 1.0)) * (EI) * ((arc).power(-2));
    let theta_3 = (theta_30)
        + ((N::number(-1.0 / 1.0)) * ((Q_theta3).power(-1))
            * (((N::number(-1.0 / 1.0)) * (T)) + ((T) * (theta_1)) + (n)));
    let T_hat_1 = (Phi)
        * ((t)
            + ((N::number(-1.0 / 1.0)) * (Q)
                * ((N::number(1.0 / 1.0)) + ((N::number(-1.0 / 1.0)) * (theta_1)))));
    let theta_hat_3 = ((Phi).power(3)) * (theta_3);
    let x_hat_1 = (N::number(-1.0 / 1.0)) * (Phi) * (tan_theta)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let axial = (N::number(1.0 / 2.0)) * (x) * (k);
    let loss_radial = (N::number(2.0 / 1.0)) * (v_r) * (f_r) * (p)
        * (((beta).cos()).power(-2));
    let loss_tangential = (N::number(2.0 / 1.0)) * (v_t) * (f_t) * (p);
    let loss = (loss_radial) + (loss_tangential);
    let M_hat_1 = (Phi) * (arc) * (f_t) * (q);
    let A_hat_1 = (Phi) * (arc) * (axial);
    let L_o_hat_1 = (Phi) * (arc) * ((stretch).power(-1));
    let W_hat_1 = (Phi) * (arc) * (loss);
    let A_x_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).cos());
    let A_y_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).sin());
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = ((N::number(-1.0 / 2.0)) * ((x).power(2)) * (k) * ((beta).sin())
        * (((beta).cos()).power(-1)))
        + ((N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2)));
    let E_hat_1 = (T_hat_1) * (V_T) * (stored);
    let gamma_a = (v_r).angle(v_t);
    let gamma = (gamma_a).turn();
    let beta_s = (speed).angle((v_r) * ((beta).sin()) * (((beta).cos()).power(-1)));
    let loss_phi = (arc) * (loss);
    vec![
        T_hat_1, theta1, theta2, theta_hat_3, x_hat_1, M_hat_1, A_hat_1, L_o_hat_1,
        W_hat_1, A_x_hat_1, A_y_hat_1, E_hat_1
    ]
}
pub fn span_derived<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let tau = inputs[1];
    let vartheta = inputs[2];
    let vartheta1 = inputs[3];
    let vartheta2 = inputs[4];
    let L = inputs[5];
    let flow = inputs[6];
    let EA = inputs[7];
    let EI = inputs[8];
    let m_o = inputs[9];
    let R_P = inputs[10];
    let omega_P = inputs[11];
    let vartheta_1 = (vartheta1) * ((L).power(-1));
    let vartheta_2 = (vartheta2) * ((L).power(-2));
    let M_b = (EI) * (vartheta_1);
    let Q = (EI) * (vartheta_2);
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((tau) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((tau) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let tau_hat_1 = (N::number(-1.0 / 1.0)) * (vartheta1) * (vartheta2) * ((L).power(-2))
        * (EI);
    let vartheta_hat_3 = (tau) * (vartheta1) * ((L).power(2)) * ((EI).power(-1));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let X_hat_1 = (vartheta).cos();
    let Y_hat_1 = (vartheta).sin();
    let L_o_hat_1 = (L) * ((stretch).power(-1));
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = (N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2));
    let E_hat_1 = (V_T) * (stored) * (tau_hat_1);
    vec![
        tau_hat_1, vartheta1, vartheta2, vartheta_hat_3, X_hat_1, Y_hat_1, L_o_hat_1,
        E_hat_1
    ]
}
pub fn span_as_printed<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let tau = inputs[1];
    let vartheta = inputs[2];
    let vartheta1 = inputs[3];
    let vartheta2 = inputs[4];
    let L = inputs[5];
    let flow = inputs[6];
    let EA = inputs[7];
    let EI = inputs[8];
    let m_o = inputs[9];
    let R_P = inputs[10];
    let omega_P = inputs[11];
    let vartheta_1 = (vartheta1) * ((L).power(-1));
    let vartheta_2 = (vartheta2) * ((L).power(-2));
    let M_b = (EI) * (vartheta_1);
    let Q = (EI) * (vartheta_2);
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((tau) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((tau) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let tau_hat_1 = (N::number(-1.0 / 1.0)) * (vartheta1) * (vartheta2) * ((L).power(2))
        * (EI);
    let vartheta_hat_3 = (tau) * (vartheta1) * ((L).power(-2)) * ((EI).power(-1));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let X_hat_1 = (vartheta).cos();
    let Y_hat_1 = (vartheta).sin();
    let L_o_hat_1 = (L) * ((stretch).power(-1));
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = (N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2));
    let E_hat_1 = (V_T) * (stored) * (tau_hat_1);
    vec![
        tau_hat_1, vartheta1, vartheta2, vartheta_hat_3, X_hat_1, Y_hat_1, L_o_hat_1,
        E_hat_1
    ]
}
pub fn boundary_zero_linearised<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let theta1_P1 = inputs[2];
    let theta2_P1 = inputs[3];
    let x_P1 = inputs[4];
    let T_P2 = inputs[5];
    let theta_P2 = inputs[6];
    let theta1_P2 = inputs[7];
    let theta2_P2 = inputs[8];
    let x_P2 = inputs[9];
    let tau_s1 = inputs[10];
    let vartheta_s1 = inputs[11];
    let vartheta1_s1 = inputs[12];
    let vartheta2_s1 = inputs[13];
    let tau_s2 = inputs[14];
    let vartheta_s2 = inputs[15];
    let vartheta1_s2 = inputs[16];
    let vartheta2_s2 = inputs[17];
    let T_S1 = inputs[18];
    let theta_S1 = inputs[19];
    let theta1_S1 = inputs[20];
    let theta2_S1 = inputs[21];
    let x_S1 = inputs[22];
    let T_S2 = inputs[23];
    let theta_S2 = inputs[24];
    let theta1_S2 = inputs[25];
    let theta2_S2 = inputs[26];
    let x_S2 = inputs[27];
    let tau_t1 = inputs[28];
    let vartheta_t1 = inputs[29];
    let vartheta1_t1 = inputs[30];
    let vartheta2_t1 = inputs[31];
    let tau_t2 = inputs[32];
    let vartheta_t2 = inputs[33];
    let vartheta1_t2 = inputs[34];
    let vartheta2_t2 = inputs[35];
    let M_P = inputs[36];
    let A_P = inputs[37];
    let L_o_P = inputs[38];
    let W_P = inputs[39];
    let A_x_P = inputs[40];
    let A_y_P = inputs[41];
    let E_P = inputs[42];
    let X_s = inputs[43];
    let Y_s = inputs[44];
    let L_o_s = inputs[45];
    let E_s = inputs[46];
    let M_S = inputs[47];
    let A_S = inputs[48];
    let L_o_S = inputs[49];
    let W_S = inputs[50];
    let A_x_S = inputs[51];
    let A_y_S = inputs[52];
    let E_S = inputs[53];
    let X_t = inputs[54];
    let Y_t = inputs[55];
    let L_o_t = inputs[56];
    let E_t = inputs[57];
    let speed_ratio = inputs[58];
    let flow = inputs[59];
    let Phi_P = inputs[60];
    let Phi_S = inputs[61];
    let C_P = inputs[62];
    let C_S = inputs[63];
    let L_t = inputs[64];
    let L_s = inputs[65];
    let EA = inputs[66];
    let EI = inputs[67];
    let k = inputs[68];
    let m_o = inputs[69];
    let R_P = inputs[70];
    let R_S = inputs[71];
    let L_c = inputs[72];
    let beta = inputs[73];
    let mu_k = inputs[74];
    let v_thr = inputs[75];
    let omega_P = inputs[76];
    let M_in = inputs[77];
    let T_slack = inputs[78];
    let s_2 = N::number(1.0);
    let penetration_P1 = ((R_P).power(-1)) * (x_P1);
    let penetration_P2 = ((R_P).power(-1)) * (x_P2);
    let penetration_S1 = ((R_S).power(-1)) * (x_S1);
    let penetration_S2 = ((R_S).power(-1)) * (x_S2);
    let tension_P1 = (T_P1) + ((N::number(-1.0 / 1.0)) * (tau_t2));
    let tension_P2 = (T_P2) + ((N::number(-1.0 / 1.0)) * (tau_s1));
    let tension_S1 = (T_S1) + ((N::number(-1.0 / 1.0)) * (tau_s2));
    let tension_S2 = (T_S2) + ((N::number(-1.0 / 1.0)) * (tau_t1));
    let direction_P1 = (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t2))
        + ((N::number(1.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_P2 = ((Phi_P) * (s_2)) + (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s1))
        + ((N::number(-3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S1 = ((N::number(-1.0 / 1.0)) * (Phi_S) * (s_2))
        + ((N::number(-1.0 / 1.0)) * (C_S)) + ((N::number(-1.0 / 1.0)) * (theta_S1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s2))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S2 = ((N::number(-1.0 / 1.0)) * (C_S))
        + ((N::number(-1.0 / 1.0)) * (theta_S2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t1))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let curvature_P1 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P1)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))).power(-1))
            * ((theta_P1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t2)));
    let curvature_P2 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P2)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P2))).power(-1))
            * ((theta_P2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s1)));
    let curvature_S1 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S1)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))).power(-1))
            * ((theta_S1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s2)));
    let curvature_S2 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S2)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))).power(-1))
            * ((theta_S2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t1)));
    let shear_P1 = (N::number(-1.0 / 1.0)) * ((R_P).power(-1)) * ((Phi_P).power(-2))
        * (((R_P) * (theta2_P1) * ((theta_P1).cos()))
            + ((R_P) * ((Phi_P).power(2)) * ((theta_P1).sin()))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(2)) * (x_P1)
                * ((theta_P1).sin()))) * (((theta_P1).cos()).power(-1));
    let shear_P2 = (N::number(-1.0 / 1.0)) * ((R_P).power(-1)) * ((Phi_P).power(-2))
        * (((R_P) * (theta2_P2) * ((theta_P2).cos()))
            + ((R_P) * ((Phi_P).power(2)) * ((theta_P2).sin()))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(2)) * (x_P2)
                * ((theta_P2).sin()))) * (((theta_P2).cos()).power(-1));
    let shear_S1 = (N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(-1))
        * (((R_S) * (theta2_S1) * ((theta_S1).cos()))
            + (((Phi_S).power(2)) * (R_S) * ((theta_S1).sin()))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(2)) * (x_S1)
                * ((theta_S1).sin()))) * (((theta_S1).cos()).power(-1));
    let shear_S2 = (N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(-1))
        * (((R_S) * (theta2_S2) * ((theta_S2).cos()))
            + (((Phi_S).power(2)) * (R_S) * ((theta_S2).sin()))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(2)) * (x_S2)
                * ((theta_S2).sin()))) * (((theta_S2).cos()).power(-1));
    let closure_X_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).cos()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (X_s))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + (L_c));
    let closure_Y_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).sin()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (Y_s))
            + ((R_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let closure_X_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).cos())) + ((N::number(-1.0 / 1.0)) * (L_t) * (X_t))
            + ((N::number(-1.0 / 1.0))
                * (((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).cos())) + (L_c))));
    let closure_Y_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).sin())) + ((N::number(-1.0 / 1.0)) * (L_t) * (Y_t))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).sin())));
    let torque = (M_in) + (M_P);
    let slack_tension = ((N::number(-1.0 / 1.0)) * (T_slack)) + (T_P2);
    vec![
        penetration_P1, penetration_P2, penetration_S1, penetration_S2, tension_P1,
        tension_P2, tension_S1, tension_S2, direction_P1, direction_P2, direction_S1,
        direction_S2, curvature_P1, curvature_P2, curvature_S1, curvature_S2, shear_P1,
        shear_P2, shear_S1, shear_S2, closure_X_s, closure_Y_s, closure_X_t, closure_Y_t,
        torque, slack_tension
    ]
}
pub fn boundary_zero_full<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let theta1_P1 = inputs[2];
    let theta2_P1 = inputs[3];
    let x_P1 = inputs[4];
    let T_P2 = inputs[5];
    let theta_P2 = inputs[6];
    let theta1_P2 = inputs[7];
    let theta2_P2 = inputs[8];
    let x_P2 = inputs[9];
    let tau_s1 = inputs[10];
    let vartheta_s1 = inputs[11];
    let vartheta1_s1 = inputs[12];
    let vartheta2_s1 = inputs[13];
    let tau_s2 = inputs[14];
    let vartheta_s2 = inputs[15];
    let vartheta1_s2 = inputs[16];
    let vartheta2_s2 = inputs[17];
    let T_S1 = inputs[18];
    let theta_S1 = inputs[19];
    let theta1_S1 = inputs[20];
    let theta2_S1 = inputs[21];
    let x_S1 = inputs[22];
    let T_S2 = inputs[23];
    let theta_S2 = inputs[24];
    let theta1_S2 = inputs[25];
    let theta2_S2 = inputs[26];
    let x_S2 = inputs[27];
    let tau_t1 = inputs[28];
    let vartheta_t1 = inputs[29];
    let vartheta1_t1 = inputs[30];
    let vartheta2_t1 = inputs[31];
    let tau_t2 = inputs[32];
    let vartheta_t2 = inputs[33];
    let vartheta1_t2 = inputs[34];
    let vartheta2_t2 = inputs[35];
    let M_P = inputs[36];
    let A_P = inputs[37];
    let L_o_P = inputs[38];
    let W_P = inputs[39];
    let A_x_P = inputs[40];
    let A_y_P = inputs[41];
    let E_P = inputs[42];
    let X_s = inputs[43];
    let Y_s = inputs[44];
    let L_o_s = inputs[45];
    let E_s = inputs[46];
    let M_S = inputs[47];
    let A_S = inputs[48];
    let L_o_S = inputs[49];
    let W_S = inputs[50];
    let A_x_S = inputs[51];
    let A_y_S = inputs[52];
    let E_S = inputs[53];
    let X_t = inputs[54];
    let Y_t = inputs[55];
    let L_o_t = inputs[56];
    let E_t = inputs[57];
    let speed_ratio = inputs[58];
    let flow = inputs[59];
    let Phi_P = inputs[60];
    let Phi_S = inputs[61];
    let C_P = inputs[62];
    let C_S = inputs[63];
    let L_t = inputs[64];
    let L_s = inputs[65];
    let EA = inputs[66];
    let EI = inputs[67];
    let k = inputs[68];
    let m_o = inputs[69];
    let R_P = inputs[70];
    let R_S = inputs[71];
    let L_c = inputs[72];
    let beta = inputs[73];
    let mu_k = inputs[74];
    let v_thr = inputs[75];
    let omega_P = inputs[76];
    let M_in = inputs[77];
    let T_slack = inputs[78];
    let s_2 = N::number(1.0);
    let penetration_P1 = ((R_P).power(-1)) * (x_P1);
    let penetration_P2 = ((R_P).power(-1)) * (x_P2);
    let penetration_S1 = ((R_S).power(-1)) * (x_S1);
    let penetration_S2 = ((R_S).power(-1)) * (x_S2);
    let tension_P1 = (T_P1) + ((N::number(-1.0 / 1.0)) * (tau_t2));
    let tension_P2 = (T_P2) + ((N::number(-1.0 / 1.0)) * (tau_s1));
    let tension_S1 = (T_S1) + ((N::number(-1.0 / 1.0)) * (tau_s2));
    let tension_S2 = (T_S2) + ((N::number(-1.0 / 1.0)) * (tau_t1));
    let direction_P1 = (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t2))
        + ((N::number(1.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_P2 = ((Phi_P) * (s_2)) + (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s1))
        + ((N::number(-3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S1 = ((N::number(-1.0 / 1.0)) * (Phi_S) * (s_2))
        + ((N::number(-1.0 / 1.0)) * (C_S)) + ((N::number(-1.0 / 1.0)) * (theta_S1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s2))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S2 = ((N::number(-1.0 / 1.0)) * (C_S))
        + ((N::number(-1.0 / 1.0)) * (theta_S2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t1))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let curvature_P1 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P1)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))).power(-1))
            * ((theta_P1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t2)));
    let curvature_P2 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P2)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P2))).power(-1))
            * ((theta_P2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s1)));
    let curvature_S1 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S1)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))).power(-1))
            * ((theta_S1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s2)));
    let curvature_S2 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S2)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))).power(-1))
            * ((theta_S2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t1)));
    let shear_P1 = (N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((Phi_P).power(-2))
        * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))).power(-2))
        * (((theta2_P1) * ((theta_P1).cos())) + (((Phi_P).power(2)) * ((theta_P1).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_P1).power(2)) * ((theta_P1).sin())))
        * ((theta_P1).cos());
    let shear_P2 = (N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((Phi_P).power(-2))
        * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P2))).power(-2))
        * (((theta2_P2) * ((theta_P2).cos())) + (((Phi_P).power(2)) * ((theta_P2).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_P2).power(2)) * ((theta_P2).sin())))
        * ((theta_P2).cos());
    let shear_S1 = (N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(2))
        * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))).power(-2))
        * (((theta2_S1) * ((theta_S1).cos())) + (((Phi_S).power(2)) * ((theta_S1).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_S1).power(2)) * ((theta_S1).sin())))
        * ((theta_S1).cos());
    let shear_S2 = (N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(2))
        * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))).power(-2))
        * (((theta2_S2) * ((theta_S2).cos())) + (((Phi_S).power(2)) * ((theta_S2).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_S2).power(2)) * ((theta_S2).sin())))
        * ((theta_S2).cos());
    let closure_X_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).cos()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (X_s))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + (L_c));
    let closure_Y_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).sin()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (Y_s))
            + ((R_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let closure_X_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).cos())) + ((N::number(-1.0 / 1.0)) * (L_t) * (X_t))
            + ((N::number(-1.0 / 1.0))
                * (((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).cos())) + (L_c))));
    let closure_Y_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).sin())) + ((N::number(-1.0 / 1.0)) * (L_t) * (Y_t))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).sin())));
    let torque = (M_in) + (M_P);
    let slack_tension = ((N::number(-1.0 / 1.0)) * (T_slack)) + (T_P2);
    vec![
        penetration_P1, penetration_P2, penetration_S1, penetration_S2, tension_P1,
        tension_P2, tension_S1, tension_S2, direction_P1, direction_P2, direction_S1,
        direction_S2, curvature_P1, curvature_P2, curvature_S1, curvature_S2, shear_P1,
        shear_P2, shear_S1, shear_S2, closure_X_s, closure_Y_s, closure_X_t, closure_Y_t,
        torque, slack_tension
    ]
}
pub fn boundary_continuous_linearised<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let theta1_P1 = inputs[2];
    let theta2_P1 = inputs[3];
    let x_P1 = inputs[4];
    let T_P2 = inputs[5];
    let theta_P2 = inputs[6];
    let theta1_P2 = inputs[7];
    let theta2_P2 = inputs[8];
    let x_P2 = inputs[9];
    let tau_s1 = inputs[10];
    let vartheta_s1 = inputs[11];
    let vartheta1_s1 = inputs[12];
    let vartheta2_s1 = inputs[13];
    let tau_s2 = inputs[14];
    let vartheta_s2 = inputs[15];
    let vartheta1_s2 = inputs[16];
    let vartheta2_s2 = inputs[17];
    let T_S1 = inputs[18];
    let theta_S1 = inputs[19];
    let theta1_S1 = inputs[20];
    let theta2_S1 = inputs[21];
    let x_S1 = inputs[22];
    let T_S2 = inputs[23];
    let theta_S2 = inputs[24];
    let theta1_S2 = inputs[25];
    let theta2_S2 = inputs[26];
    let x_S2 = inputs[27];
    let tau_t1 = inputs[28];
    let vartheta_t1 = inputs[29];
    let vartheta1_t1 = inputs[30];
    let vartheta2_t1 = inputs[31];
    let tau_t2 = inputs[32];
    let vartheta_t2 = inputs[33];
    let vartheta1_t2 = inputs[34];
    let vartheta2_t2 = inputs[35];
    let M_P = inputs[36];
    let A_P = inputs[37];
    let L_o_P = inputs[38];
    let W_P = inputs[39];
    let A_x_P = inputs[40];
    let A_y_P = inputs[41];
    let E_P = inputs[42];
    let X_s = inputs[43];
    let Y_s = inputs[44];
    let L_o_s = inputs[45];
    let E_s = inputs[46];
    let M_S = inputs[47];
    let A_S = inputs[48];
    let L_o_S = inputs[49];
    let W_S = inputs[50];
    let A_x_S = inputs[51];
    let A_y_S = inputs[52];
    let E_S = inputs[53];
    let X_t = inputs[54];
    let Y_t = inputs[55];
    let L_o_t = inputs[56];
    let E_t = inputs[57];
    let speed_ratio = inputs[58];
    let flow = inputs[59];
    let Phi_P = inputs[60];
    let Phi_S = inputs[61];
    let C_P = inputs[62];
    let C_S = inputs[63];
    let L_t = inputs[64];
    let L_s = inputs[65];
    let EA = inputs[66];
    let EI = inputs[67];
    let k = inputs[68];
    let m_o = inputs[69];
    let R_P = inputs[70];
    let R_S = inputs[71];
    let L_c = inputs[72];
    let beta = inputs[73];
    let mu_k = inputs[74];
    let v_thr = inputs[75];
    let omega_P = inputs[76];
    let M_in = inputs[77];
    let T_slack = inputs[78];
    let s_2 = N::number(1.0);
    let penetration_P1 = ((R_P).power(-1)) * (x_P1);
    let penetration_P2 = ((R_P).power(-1)) * (x_P2);
    let penetration_S1 = ((R_S).power(-1)) * (x_S1);
    let penetration_S2 = ((R_S).power(-1)) * (x_S2);
    let tension_P1 = (T_P1) + ((N::number(-1.0 / 1.0)) * (tau_t2));
    let tension_P2 = (T_P2) + ((N::number(-1.0 / 1.0)) * (tau_s1));
    let tension_S1 = (T_S1) + ((N::number(-1.0 / 1.0)) * (tau_s2));
    let tension_S2 = (T_S2) + ((N::number(-1.0 / 1.0)) * (tau_t1));
    let direction_P1 = (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t2))
        + ((N::number(1.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_P2 = ((Phi_P) * (s_2)) + (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s1))
        + ((N::number(-3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S1 = ((N::number(-1.0 / 1.0)) * (Phi_S) * (s_2))
        + ((N::number(-1.0 / 1.0)) * (C_S)) + ((N::number(-1.0 / 1.0)) * (theta_S1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s2))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S2 = ((N::number(-1.0 / 1.0)) * (C_S))
        + ((N::number(-1.0 / 1.0)) * (theta_S2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t1))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let curvature_P1 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P1)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))).power(-1))
            * ((theta_P1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t2)));
    let curvature_P2 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P2)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P2))).power(-1))
            * ((theta_P2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s1)));
    let curvature_S1 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S1)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))).power(-1))
            * ((theta_S1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s2)));
    let curvature_S2 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S2)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))).power(-1))
            * ((theta_S2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t1)));
    let shear_P1 = ((N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((L_t).power(-2))
        * (vartheta2_t2))
        + ((N::number(-1.0 / 1.0)) * ((R_P).power(-1)) * ((Phi_P).power(-2))
            * (((R_P) * (theta2_P1) * ((theta_P1).cos()))
                + ((R_P) * ((Phi_P).power(2)) * ((theta_P1).sin()))
                + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(2)) * (x_P1)
                    * ((theta_P1).sin()))) * (((theta_P1).cos()).power(-1)));
    let shear_P2 = ((N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((L_s).power(-2))
        * (vartheta2_s1))
        + ((N::number(-1.0 / 1.0)) * ((R_P).power(-1)) * ((Phi_P).power(-2))
            * (((R_P) * (theta2_P2) * ((theta_P2).cos()))
                + ((R_P) * ((Phi_P).power(2)) * ((theta_P2).sin()))
                + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(2)) * (x_P2)
                    * ((theta_P2).sin()))) * (((theta_P2).cos()).power(-1)));
    let shear_S1 = ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(-1))
        * (((R_S) * (theta2_S1) * ((theta_S1).cos()))
            + (((Phi_S).power(2)) * (R_S) * ((theta_S1).sin()))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(2)) * (x_S1)
                * ((theta_S1).sin()))) * (((theta_S1).cos()).power(-1)))
        + ((N::number(-1.0 / 1.0)) * ((L_s).power(-2)) * ((R_S).power(2))
            * (vartheta2_s2));
    let shear_S2 = ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(-1))
        * (((R_S) * (theta2_S2) * ((theta_S2).cos()))
            + (((Phi_S).power(2)) * (R_S) * ((theta_S2).sin()))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(2)) * (x_S2)
                * ((theta_S2).sin()))) * (((theta_S2).cos()).power(-1)))
        + ((N::number(-1.0 / 1.0)) * ((L_t).power(-2)) * ((R_S).power(2))
            * (vartheta2_t1));
    let closure_X_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).cos()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (X_s))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + (L_c));
    let closure_Y_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).sin()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (Y_s))
            + ((R_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let closure_X_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).cos())) + ((N::number(-1.0 / 1.0)) * (L_t) * (X_t))
            + ((N::number(-1.0 / 1.0))
                * (((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).cos())) + (L_c))));
    let closure_Y_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).sin())) + ((N::number(-1.0 / 1.0)) * (L_t) * (Y_t))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).sin())));
    let torque = (M_in) + (M_P);
    let slack_tension = ((N::number(-1.0 / 1.0)) * (T_slack)) + (T_P2);
    vec![
        penetration_P1, penetration_P2, penetration_S1, penetration_S2, tension_P1,
        tension_P2, tension_S1, tension_S2, direction_P1, direction_P2, direction_S1,
        direction_S2, curvature_P1, curvature_P2, curvature_S1, curvature_S2, shear_P1,
        shear_P2, shear_S1, shear_S2, closure_X_s, closure_Y_s, closure_X_t, closure_Y_t,
        torque, slack_tension
    ]
}
pub fn boundary_continuous_full<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let theta1_P1 = inputs[2];
    let theta2_P1 = inputs[3];
    let x_P1 = inputs[4];
    let T_P2 = inputs[5];
    let theta_P2 = inputs[6];
    let theta1_P2 = inputs[7];
    let theta2_P2 = inputs[8];
    let x_P2 = inputs[9];
    let tau_s1 = inputs[10];
    let vartheta_s1 = inputs[11];
    let vartheta1_s1 = inputs[12];
    let vartheta2_s1 = inputs[13];
    let tau_s2 = inputs[14];
    let vartheta_s2 = inputs[15];
    let vartheta1_s2 = inputs[16];
    let vartheta2_s2 = inputs[17];
    let T_S1 = inputs[18];
    let theta_S1 = inputs[19];
    let theta1_S1 = inputs[20];
    let theta2_S1 = inputs[21];
    let x_S1 = inputs[22];
    let T_S2 = inputs[23];
    let theta_S2 = inputs[24];
    let theta1_S2 = inputs[25];
    let theta2_S2 = inputs[26];
    let x_S2 = inputs[27];
    let tau_t1 = inputs[28];
    let vartheta_t1 = inputs[29];
    let vartheta1_t1 = inputs[30];
    let vartheta2_t1 = inputs[31];
    let tau_t2 = inputs[32];
    let vartheta_t2 = inputs[33];
    let vartheta1_t2 = inputs[34];
    let vartheta2_t2 = inputs[35];
    let M_P = inputs[36];
    let A_P = inputs[37];
    let L_o_P = inputs[38];
    let W_P = inputs[39];
    let A_x_P = inputs[40];
    let A_y_P = inputs[41];
    let E_P = inputs[42];
    let X_s = inputs[43];
    let Y_s = inputs[44];
    let L_o_s = inputs[45];
    let E_s = inputs[46];
    let M_S = inputs[47];
    let A_S = inputs[48];
    let L_o_S = inputs[49];
    let W_S = inputs[50];
    let A_x_S = inputs[51];
    let A_y_S = inputs[52];
    let E_S = inputs[53];
    let X_t = inputs[54];
    let Y_t = inputs[55];
    let L_o_t = inputs[56];
    let E_t = inputs[57];
    let speed_ratio = inputs[58];
    let flow = inputs[59];
    let Phi_P = inputs[60];
    let Phi_S = inputs[61];
    let C_P = inputs[62];
    let C_S = inputs[63];
    let L_t = inputs[64];
    let L_s = inputs[65];
    let EA = inputs[66];
    let EI = inputs[67];
    let k = inputs[68];
    let m_o = inputs[69];
    let R_P = inputs[70];
    let R_S = inputs[71];
    let L_c = inputs[72];
    let beta = inputs[73];
    let mu_k = inputs[74];
    let v_thr = inputs[75];
    let omega_P = inputs[76];
    let M_in = inputs[77];
    let T_slack = inputs[78];
    let s_2 = N::number(1.0);
    let penetration_P1 = ((R_P).power(-1)) * (x_P1);
    let penetration_P2 = ((R_P).power(-1)) * (x_P2);
    let penetration_S1 = ((R_S).power(-1)) * (x_S1);
    let penetration_S2 = ((R_S).power(-1)) * (x_S2);
    let tension_P1 = (T_P1) + ((N::number(-1.0 / 1.0)) * (tau_t2));
    let tension_P2 = (T_P2) + ((N::number(-1.0 / 1.0)) * (tau_s1));
    let tension_S1 = (T_S1) + ((N::number(-1.0 / 1.0)) * (tau_s2));
    let tension_S2 = (T_S2) + ((N::number(-1.0 / 1.0)) * (tau_t1));
    let direction_P1 = (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t2))
        + ((N::number(1.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_P2 = ((Phi_P) * (s_2)) + (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s1))
        + ((N::number(-3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S1 = ((N::number(-1.0 / 1.0)) * (Phi_S) * (s_2))
        + ((N::number(-1.0 / 1.0)) * (C_S)) + ((N::number(-1.0 / 1.0)) * (theta_S1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s2))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S2 = ((N::number(-1.0 / 1.0)) * (C_S))
        + ((N::number(-1.0 / 1.0)) * (theta_S2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t1))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let curvature_P1 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P1)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))).power(-1))
            * ((theta_P1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t2)));
    let curvature_P2 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P2)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P2))).power(-1))
            * ((theta_P2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s1)));
    let curvature_S1 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S1)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))).power(-1))
            * ((theta_S1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s2)));
    let curvature_S2 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S2)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))).power(-1))
            * ((theta_S2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t1)));
    let shear_P1 = ((N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((Phi_P).power(-2))
        * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))).power(-2))
        * (((theta2_P1) * ((theta_P1).cos())) + (((Phi_P).power(2)) * ((theta_P1).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_P1).power(2)) * ((theta_P1).sin())))
        * ((theta_P1).cos()))
        + ((N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((L_t).power(-2))
            * (vartheta2_t2));
    let shear_P2 = ((N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((Phi_P).power(-2))
        * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P2))).power(-2))
        * (((theta2_P2) * ((theta_P2).cos())) + (((Phi_P).power(2)) * ((theta_P2).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_P2).power(2)) * ((theta_P2).sin())))
        * ((theta_P2).cos()))
        + ((N::number(-1.0 / 1.0)) * ((R_P).power(2)) * ((L_s).power(-2))
            * (vartheta2_s1));
    let shear_S1 = ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(2))
        * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))).power(-2))
        * (((theta2_S1) * ((theta_S1).cos())) + (((Phi_S).power(2)) * ((theta_S1).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_S1).power(2)) * ((theta_S1).sin())))
        * ((theta_S1).cos()))
        + ((N::number(-1.0 / 1.0)) * ((L_s).power(-2)) * ((R_S).power(2))
            * (vartheta2_s2));
    let shear_S2 = ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-2)) * ((R_S).power(2))
        * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))).power(-2))
        * (((theta2_S2) * ((theta_S2).cos())) + (((Phi_S).power(2)) * ((theta_S2).sin()))
            + ((N::number(-1.0 / 1.0)) * ((theta1_S2).power(2)) * ((theta_S2).sin())))
        * ((theta_S2).cos()))
        + ((N::number(-1.0 / 1.0)) * ((L_t).power(-2)) * ((R_S).power(2))
            * (vartheta2_t1));
    let closure_X_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).cos()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (X_s))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + (L_c));
    let closure_Y_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).sin()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (Y_s))
            + ((R_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let closure_X_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).cos())) + ((N::number(-1.0 / 1.0)) * (L_t) * (X_t))
            + ((N::number(-1.0 / 1.0))
                * (((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).cos())) + (L_c))));
    let closure_Y_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).sin())) + ((N::number(-1.0 / 1.0)) * (L_t) * (Y_t))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).sin())));
    let torque = (M_in) + (M_P);
    let slack_tension = ((N::number(-1.0 / 1.0)) * (T_slack)) + (T_P2);
    vec![
        penetration_P1, penetration_P2, penetration_S1, penetration_S2, tension_P1,
        tension_P2, tension_S1, tension_S2, direction_P1, direction_P2, direction_S1,
        direction_S2, curvature_P1, curvature_P2, curvature_S1, curvature_S2, shear_P1,
        shear_P2, shear_S1, shear_S2, closure_X_s, closure_Y_s, closure_X_t, closure_Y_t,
        torque, slack_tension
    ]
}
pub fn boundary_as_printed<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let theta1_P1 = inputs[2];
    let theta2_P1 = inputs[3];
    let x_P1 = inputs[4];
    let T_P2 = inputs[5];
    let theta_P2 = inputs[6];
    let theta1_P2 = inputs[7];
    let theta2_P2 = inputs[8];
    let x_P2 = inputs[9];
    let tau_s1 = inputs[10];
    let vartheta_s1 = inputs[11];
    let vartheta1_s1 = inputs[12];
    let vartheta2_s1 = inputs[13];
    let tau_s2 = inputs[14];
    let vartheta_s2 = inputs[15];
    let vartheta1_s2 = inputs[16];
    let vartheta2_s2 = inputs[17];
    let T_S1 = inputs[18];
    let theta_S1 = inputs[19];
    let theta1_S1 = inputs[20];
    let theta2_S1 = inputs[21];
    let x_S1 = inputs[22];
    let T_S2 = inputs[23];
    let theta_S2 = inputs[24];
    let theta1_S2 = inputs[25];
    let theta2_S2 = inputs[26];
    let x_S2 = inputs[27];
    let tau_t1 = inputs[28];
    let vartheta_t1 = inputs[29];
    let vartheta1_t1 = inputs[30];
    let vartheta2_t1 = inputs[31];
    let tau_t2 = inputs[32];
    let vartheta_t2 = inputs[33];
    let vartheta1_t2 = inputs[34];
    let vartheta2_t2 = inputs[35];
    let M_P = inputs[36];
    let A_P = inputs[37];
    let L_o_P = inputs[38];
    let W_P = inputs[39];
    let A_x_P = inputs[40];
    let A_y_P = inputs[41];
    let E_P = inputs[42];
    let X_s = inputs[43];
    let Y_s = inputs[44];
    let L_o_s = inputs[45];
    let E_s = inputs[46];
    let M_S = inputs[47];
    let A_S = inputs[48];
    let L_o_S = inputs[49];
    let W_S = inputs[50];
    let A_x_S = inputs[51];
    let A_y_S = inputs[52];
    let E_S = inputs[53];
    let X_t = inputs[54];
    let Y_t = inputs[55];
    let L_o_t = inputs[56];
    let E_t = inputs[57];
    let speed_ratio = inputs[58];
    let flow = inputs[59];
    let Phi_P = inputs[60];
    let Phi_S = inputs[61];
    let C_P = inputs[62];
    let C_S = inputs[63];
    let L_t = inputs[64];
    let L_s = inputs[65];
    let EA = inputs[66];
    let EI = inputs[67];
    let k = inputs[68];
    let m_o = inputs[69];
    let R_P = inputs[70];
    let R_S = inputs[71];
    let L_c = inputs[72];
    let beta = inputs[73];
    let mu_k = inputs[74];
    let v_thr = inputs[75];
    let omega_P = inputs[76];
    let M_in = inputs[77];
    let T_slack = inputs[78];
    let s_2 = N::number(1.0);
    let penetration_P1 = ((R_P).power(-1)) * (x_P1);
    let penetration_P2 = ((R_P).power(-1)) * (x_P2);
    let penetration_S1 = ((R_S).power(-1)) * (x_S1);
    let penetration_S2 = ((R_S).power(-1)) * (x_S2);
    let tension_P1 = (T_P1) + ((N::number(-1.0 / 1.0)) * (tau_t2));
    let tension_P2 = (T_P2) + ((N::number(-1.0 / 1.0)) * (tau_s1));
    let tension_S1 = (T_S1) + ((N::number(-1.0 / 1.0)) * (tau_s2));
    let tension_S2 = (T_S2) + ((N::number(-1.0 / 1.0)) * (tau_t1));
    let direction_P1 = (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t2))
        + ((N::number(1.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_P2 = ((Phi_P) * (s_2)) + (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s1))
        + ((N::number(-3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S1 = ((N::number(-1.0 / 1.0)) * (Phi_S) * (s_2))
        + ((N::number(-1.0 / 1.0)) * (C_S)) + ((N::number(-1.0 / 1.0)) * (theta_S1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s2))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S2 = ((N::number(-1.0 / 1.0)) * (C_S))
        + ((N::number(-1.0 / 1.0)) * (theta_S2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t1))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let curvature_P1 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P1)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))).power(-1))
            * ((theta_P1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t2)));
    let curvature_P2 = (R_P)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_P).power(-1)) * (theta1_P2)))
            * (((R_P) + ((N::number(-1.0 / 1.0)) * (x_P2))).power(-1))
            * ((theta_P2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s1)));
    let curvature_S1 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S1)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))).power(-1))
            * ((theta_S1).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_s).power(-1)) * (vartheta1_s2)));
    let curvature_S2 = (R_S)
        * ((((N::number(1.0 / 1.0))
            + ((N::number(-1.0 / 1.0)) * ((Phi_S).power(-1)) * (theta1_S2)))
            * (((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))).power(-1))
            * ((theta_S2).cos()))
            + ((N::number(-1.0 / 1.0)) * ((L_t).power(-1)) * (vartheta1_t1)));
    let shear_P1 = ((N::number(-1.0 / 1.0)) * (theta2_P1))
        + ((N::number(-1.0 / 1.0)) * ((R_P).power(-1)) * (Phi_P)
            * ((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))) * ((theta_P1).sin())
            * (((theta_P1).cos()).power(-1)));
    let shear_P2 = ((N::number(-1.0 / 1.0)) * (theta2_P2))
        + ((N::number(-1.0 / 1.0)) * ((R_P).power(-1)) * (Phi_P)
            * ((R_P) + ((N::number(-1.0 / 1.0)) * (x_P1))) * ((theta_P1).sin())
            * (((theta_P1).cos()).power(-1)));
    let shear_S1 = ((N::number(-1.0 / 1.0)) * (Phi_S) * ((R_S).power(-1))
        * ((R_S) + ((N::number(-1.0 / 1.0)) * (x_S1))) * ((theta_S1).sin())
        * (((theta_S1).cos()).power(-1))) + ((N::number(-1.0 / 1.0)) * (theta2_S1));
    let shear_S2 = ((N::number(-1.0 / 1.0)) * (Phi_S) * ((R_S).power(-1))
        * ((R_S) + ((N::number(-1.0 / 1.0)) * (x_S2))) * ((theta_S2).sin())
        * (((theta_S2).cos()).power(-1))) + ((N::number(-1.0 / 1.0)) * (theta2_S2));
    let closure_X_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).cos()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (X_s))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + (L_c));
    let closure_Y_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).sin()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (Y_s))
            + ((R_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let closure_X_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).cos())) + ((N::number(-1.0 / 1.0)) * (L_t) * (X_t))
            + ((N::number(-1.0 / 1.0))
                * (((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).cos())) + (L_c))));
    let closure_Y_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).sin())) + ((N::number(-1.0 / 1.0)) * (L_t) * (Y_t))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).sin())));
    let torque = (M_in) + (M_P);
    let slack_tension = ((N::number(-1.0 / 1.0)) * (T_slack)) + (T_P2);
    vec![
        penetration_P1, penetration_P2, penetration_S1, penetration_S2, tension_P1,
        tension_P2, tension_S1, tension_S2, direction_P1, direction_P2, direction_S1,
        direction_S2, curvature_P1, curvature_P2, curvature_S1, curvature_S2, shear_P1,
        shear_P2, shear_S1, shear_S2, closure_X_s, closure_Y_s, closure_X_t, closure_Y_t,
        torque, slack_tension
    ]
}
pub fn outputs<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let theta1_P1 = inputs[2];
    let theta2_P1 = inputs[3];
    let x_P1 = inputs[4];
    let T_P2 = inputs[5];
    let theta_P2 = inputs[6];
    let theta1_P2 = inputs[7];
    let theta2_P2 = inputs[8];
    let x_P2 = inputs[9];
    let tau_s1 = inputs[10];
    let vartheta_s1 = inputs[11];
    let vartheta1_s1 = inputs[12];
    let vartheta2_s1 = inputs[13];
    let tau_s2 = inputs[14];
    let vartheta_s2 = inputs[15];
    let vartheta1_s2 = inputs[16];
    let vartheta2_s2 = inputs[17];
    let T_S1 = inputs[18];
    let theta_S1 = inputs[19];
    let theta1_S1 = inputs[20];
    let theta2_S1 = inputs[21];
    let x_S1 = inputs[22];
    let T_S2 = inputs[23];
    let theta_S2 = inputs[24];
    let theta1_S2 = inputs[25];
    let theta2_S2 = inputs[26];
    let x_S2 = inputs[27];
    let tau_t1 = inputs[28];
    let vartheta_t1 = inputs[29];
    let vartheta1_t1 = inputs[30];
    let vartheta2_t1 = inputs[31];
    let tau_t2 = inputs[32];
    let vartheta_t2 = inputs[33];
    let vartheta1_t2 = inputs[34];
    let vartheta2_t2 = inputs[35];
    let M_P = inputs[36];
    let A_P = inputs[37];
    let L_o_P = inputs[38];
    let W_P = inputs[39];
    let A_x_P = inputs[40];
    let A_y_P = inputs[41];
    let E_P = inputs[42];
    let X_s = inputs[43];
    let Y_s = inputs[44];
    let L_o_s = inputs[45];
    let E_s = inputs[46];
    let M_S = inputs[47];
    let A_S = inputs[48];
    let L_o_S = inputs[49];
    let W_S = inputs[50];
    let A_x_S = inputs[51];
    let A_y_S = inputs[52];
    let E_S = inputs[53];
    let X_t = inputs[54];
    let Y_t = inputs[55];
    let L_o_t = inputs[56];
    let E_t = inputs[57];
    let speed_ratio = inputs[58];
    let flow = inputs[59];
    let Phi_P = inputs[60];
    let Phi_S = inputs[61];
    let C_P = inputs[62];
    let C_S = inputs[63];
    let L_t = inputs[64];
    let L_s = inputs[65];
    let EA = inputs[66];
    let EI = inputs[67];
    let k = inputs[68];
    let m_o = inputs[69];
    let R_P = inputs[70];
    let R_S = inputs[71];
    let L_c = inputs[72];
    let beta = inputs[73];
    let mu_k = inputs[74];
    let v_thr = inputs[75];
    let omega_P = inputs[76];
    let M_in = inputs[77];
    let T_slack = inputs[78];
    let s_2 = N::number(1.0);
    let binding_P = (((A_x_P).power(2)) + ((A_y_P).power(2))).sqrt();
    let binding_S = (((A_x_S).power(2)) + ((A_y_S).power(2))).sqrt();
    let primary__speed = omega_P;
    let primary__torque = (N::number(-1.0 / 1.0)) * (M_P);
    let primary__power = (N::number(-1.0 / 1.0)) * (omega_P) * (M_P);
    let primary__axial_force = A_P;
    let primary__wrap_angle = (Phi_P) * (s_2);
    let primary__entry_angle = theta_P1;
    let primary__exit_angle = theta_P2;
    let primary__orientation_angle = C_P;
    let primary__resultant_x = ((A_P).power(-1))
        * (((A_x_P) * ((C_P).cos()))
            + ((N::number(-1.0 / 1.0)) * (A_y_P) * ((C_P).sin())));
    let primary__resultant_y = ((A_P).power(-1))
        * (((A_x_P) * ((C_P).sin())) + ((A_y_P) * ((C_P).cos())));
    let primary__binding_moment = binding_P;
    let primary__friction_loss = W_P;
    let primary__entry_tension = T_P1;
    let primary__exit_tension = T_P2;
    let secondary__speed = (omega_P) * (speed_ratio);
    let secondary__torque = M_S;
    let secondary__power = (omega_P) * (speed_ratio) * (M_S);
    let secondary__axial_force = A_S;
    let secondary__wrap_angle = (Phi_S) * (s_2);
    let secondary__entry_angle = theta_S1;
    let secondary__exit_angle = theta_S2;
    let secondary__orientation_angle = C_S;
    let secondary__resultant_x = ((A_S).power(-1))
        * (((N::number(-1.0 / 1.0)) * (A_x_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + ((N::number(-1.0 / 1.0)) * (A_y_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let secondary__resultant_y = ((A_S).power(-1))
        * (((A_x_S) * ((((Phi_S) * (s_2)) + (C_S)).sin()))
            + ((N::number(-1.0 / 1.0)) * (A_y_S) * ((((Phi_S) * (s_2)) + (C_S)).cos())));
    let secondary__binding_moment = binding_S;
    let secondary__friction_loss = W_S;
    let secondary__entry_tension = T_S1;
    let secondary__exit_tension = T_S2;
    let tight_span__arc_length = (L_t) * (s_2);
    let tight_span__unstretched_length = L_o_t;
    let slack_span__arc_length = (L_s) * (s_2);
    let slack_span__unstretched_length = L_o_s;
    let efficiency__speed = ((R_P).power(-1)) * (speed_ratio) * (R_S);
    let efficiency__torque = (N::number(-1.0 / 1.0)) * (R_P) * ((R_S).power(-1))
        * ((M_P).power(-1)) * (M_S);
    let efficiency__overall = (N::number(-1.0 / 1.0)) * (speed_ratio) * ((M_P).power(-1))
        * (M_S);
    let belt__mass_flow = (flow) * (m_o) * (R_P) * (omega_P);
    let belt__unstretched_length = (L_o_t) + (L_o_s) + (L_o_P) + (L_o_S);
    let energy__power_in = (N::number(-1.0 / 1.0)) * (omega_P) * (M_P);
    let energy__power_out = (omega_P) * (speed_ratio) * (M_S);
    let energy__friction_loss = (W_P) + (W_S);
    let energy__stretch_work = (E_P) + (E_s) + (E_S) + (E_t);
    let energy__imbalance = (N::number(1.0 / 1.0))
        + (((omega_P).power(-1)) * ((M_P).power(-1))
            * (((omega_P) * (speed_ratio) * (M_S)) + (W_P) + (W_S)));
    let energy__closure = (N::number(1.0 / 1.0))
        + (((omega_P).power(-1)) * ((M_P).power(-1))
            * (((omega_P) * (speed_ratio) * (M_S)) + (W_P) + (W_S) + (E_P) + (E_s)
                + (E_S) + (E_t)));
    vec![
        primary__speed, primary__torque, primary__power, primary__axial_force,
        primary__wrap_angle, primary__entry_angle, primary__exit_angle,
        primary__orientation_angle, primary__resultant_x, primary__resultant_y,
        primary__binding_moment, primary__friction_loss, primary__entry_tension,
        primary__exit_tension, secondary__speed, secondary__torque, secondary__power,
        secondary__axial_force, secondary__wrap_angle, secondary__entry_angle,
        secondary__exit_angle, secondary__orientation_angle, secondary__resultant_x,
        secondary__resultant_y, secondary__binding_moment, secondary__friction_loss,
        secondary__entry_tension, secondary__exit_tension, tight_span__arc_length,
        tight_span__unstretched_length, slack_span__arc_length,
        slack_span__unstretched_length, efficiency__speed, efficiency__torque,
        efficiency__overall, belt__mass_flow, belt__unstretched_length, energy__power_in,
        energy__power_out, energy__friction_loss, energy__stretch_work,
        energy__imbalance, energy__closure
    ]
}
pub fn contact_string_viscous_coulomb<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let T = inputs[1];
    let theta = inputs[2];
    let x = inputs[3];
    let Phi = inputs[4];
    let sigma = inputs[5];
    let flow = inputs[6];
    let EA = inputs[7];
    let EI = inputs[8];
    let k = inputs[9];
    let m_o = inputs[10];
    let R = inputs[11];
    let R_P = inputs[12];
    let beta = inputs[13];
    let mu_k = inputs[14];
    let v_thr = inputs[15];
    let omega_P = inputs[16];
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((T) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((T) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let omega = (sigma) * (omega_P);
    let r = ((N::number(-1.0 / 1.0)) * (x)) + (R);
    let arc = (((N::number(-1.0 / 1.0)) * (x)) + (R)) * (((theta).cos()).power(-1));
    let tan_theta = (theta).tan();
    let v_r = (V) * ((theta).sin());
    let v_t = ((N::number(-1.0 / 1.0)) * (omega)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R))) + ((V) * ((theta).cos()));
    let v_0 = N::number(0.000000000001);
    let speed = (((v_0).power(2)) + ((v_r).power(2)) + ((v_t).power(2))).sqrt();
    let slip = ((v_thr).power(-1)) * (speed);
    let saturation = (slip).saturate();
    let mu = (mu_k) * (saturation);
    let face_speed = ((((v_r).power(2)) * (((beta).sin()).power(2))
        * (((beta).cos()).power(-2))) + ((speed).power(2)))
        .sqrt();
    let f_r = (v_r) * ((face_speed).power(-1)) * (mu);
    let f_t = (v_t) * ((face_speed).power(-1)) * (mu);
    let p = (N::number(1.0 / 2.0)) * (x) * (k)
        * ((((f_r) * ((beta).sin()) * (((beta).cos()).power(-1))) + ((beta).cos()))
            .power(-1));
    let q = (N::number(2.0 / 1.0)) * (r) * (p);
    let n = (q)
        * (((tan_theta) * (f_t)) + ((N::number(-1.0 / 1.0)) * (f_r)) + ((beta).sin()));
    let t = (q)
        * (((tan_theta) * ((f_r) + ((N::number(-1.0 / 1.0)) * ((beta).sin())))) + (f_t));
    let M_b = N::number(0.0);
    let Q = N::number(0.0);
    let theta_1 = ((T).power(-1)) * ((T) + ((N::number(-1.0 / 1.0)) * (n)));
    let T_hat_1 = (Phi) * (t);
    let theta_hat_1 = (Phi) * (theta_1);
    let x_hat_1 = (N::number(-1.0 / 1.0)) * (Phi) * (tan_theta)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let axial = (N::number(1.0 / 2.0)) * (x) * (k);
    let loss_radial = (N::number(2.0 / 1.0)) * (v_r) * (f_r) * (p)
        * (((beta).cos()).power(-2));
    let loss_tangential = (N::number(2.0 / 1.0)) * (v_t) * (f_t) * (p);
    let loss = (loss_radial) + (loss_tangential);
    let M_hat_1 = (Phi) * (arc) * (f_t) * (q);
    let A_hat_1 = (Phi) * (arc) * (axial);
    let L_o_hat_1 = (Phi) * (arc) * ((stretch).power(-1));
    let W_hat_1 = (Phi) * (arc) * (loss);
    let A_x_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).cos());
    let A_y_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).sin());
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = ((N::number(-1.0 / 2.0)) * ((x).power(2)) * (k) * ((beta).sin())
        * (((beta).cos()).power(-1)))
        + ((N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2)));
    let E_hat_1 = (T_hat_1) * (V_T) * (stored);
    let gamma_a = (v_r).angle(v_t);
    let gamma = (gamma_a).turn();
    let beta_s = (speed).angle((v_r) * ((beta).sin()) * (((beta).cos()).power(-1)));
    let loss_phi = (arc) * (loss);
    vec![
        T_hat_1, theta_hat_1, x_hat_1, M_hat_1, A_hat_1, L_o_hat_1, W_hat_1, A_x_hat_1,
        A_y_hat_1, E_hat_1
    ]
}
pub fn contact_string_tanh<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let T = inputs[1];
    let theta = inputs[2];
    let x = inputs[3];
    let Phi = inputs[4];
    let sigma = inputs[5];
    let flow = inputs[6];
    let EA = inputs[7];
    let EI = inputs[8];
    let k = inputs[9];
    let m_o = inputs[10];
    let R = inputs[11];
    let R_P = inputs[12];
    let beta = inputs[13];
    let mu_k = inputs[14];
    let v_thr = inputs[15];
    let omega_P = inputs[16];
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((T) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((T) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let omega = (sigma) * (omega_P);
    let r = ((N::number(-1.0 / 1.0)) * (x)) + (R);
    let arc = (((N::number(-1.0 / 1.0)) * (x)) + (R)) * (((theta).cos()).power(-1));
    let tan_theta = (theta).tan();
    let v_r = (V) * ((theta).sin());
    let v_t = ((N::number(-1.0 / 1.0)) * (omega)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R))) + ((V) * ((theta).cos()));
    let v_0 = N::number(0.000000000001);
    let speed = (((v_0).power(2)) + ((v_r).power(2)) + ((v_t).power(2))).sqrt();
    let slip = ((v_thr).power(-1)) * (speed);
    let saturation = ((N::number(4.0 / 1.0)) * (slip)).tanh();
    let mu = (mu_k) * (saturation);
    let face_speed = ((((v_r).power(2)) * (((beta).sin()).power(2))
        * (((beta).cos()).power(-2))) + ((speed).power(2)))
        .sqrt();
    let f_r = (v_r) * ((face_speed).power(-1)) * (mu);
    let f_t = (v_t) * ((face_speed).power(-1)) * (mu);
    let p = (N::number(1.0 / 2.0)) * (x) * (k)
        * ((((f_r) * ((beta).sin()) * (((beta).cos()).power(-1))) + ((beta).cos()))
            .power(-1));
    let q = (N::number(2.0 / 1.0)) * (r) * (p);
    let n = (q)
        * (((tan_theta) * (f_t)) + ((N::number(-1.0 / 1.0)) * (f_r)) + ((beta).sin()));
    let t = (q)
        * (((tan_theta) * ((f_r) + ((N::number(-1.0 / 1.0)) * ((beta).sin())))) + (f_t));
    let M_b = N::number(0.0);
    let Q = N::number(0.0);
    let theta_1 = ((T).power(-1)) * ((T) + ((N::number(-1.0 / 1.0)) * (n)));
    let T_hat_1 = (Phi) * (t);
    let theta_hat_1 = (Phi) * (theta_1);
    let x_hat_1 = (N::number(-1.0 / 1.0)) * (Phi) * (tan_theta)
        * (((N::number(-1.0 / 1.0)) * (x)) + (R));
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let axial = (N::number(1.0 / 2.0)) * (x) * (k);
    let loss_radial = (N::number(2.0 / 1.0)) * (v_r) * (f_r) * (p)
        * (((beta).cos()).power(-2));
    let loss_tangential = (N::number(2.0 / 1.0)) * (v_t) * (f_t) * (p);
    let loss = (loss_radial) + (loss_tangential);
    let M_hat_1 = (Phi) * (arc) * (f_t) * (q);
    let A_hat_1 = (Phi) * (arc) * (axial);
    let L_o_hat_1 = (Phi) * (arc) * ((stretch).power(-1));
    let W_hat_1 = (Phi) * (arc) * (loss);
    let A_x_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).cos());
    let A_y_hat_1 = (r) * (A_hat_1) * (((s) * (Phi)).sin());
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = ((N::number(-1.0 / 2.0)) * ((x).power(2)) * (k) * ((beta).sin())
        * (((beta).cos()).power(-1)))
        + ((N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2)));
    let E_hat_1 = (T_hat_1) * (V_T) * (stored);
    let gamma_a = (v_r).angle(v_t);
    let gamma = (gamma_a).turn();
    let beta_s = (speed).angle((v_r) * ((beta).sin()) * (((beta).cos()).power(-1)));
    let loss_phi = (arc) * (loss);
    vec![
        T_hat_1, theta_hat_1, x_hat_1, M_hat_1, A_hat_1, L_o_hat_1, W_hat_1, A_x_hat_1,
        A_y_hat_1, E_hat_1
    ]
}
pub fn span_string<N: Number>(inputs: &[N]) -> Vec<N> {
    let s = inputs[0];
    let tau = inputs[1];
    let vartheta = inputs[2];
    let L = inputs[3];
    let flow = inputs[4];
    let EA = inputs[5];
    let EI = inputs[6];
    let m_o = inputs[7];
    let R_P = inputs[8];
    let omega_P = inputs[9];
    let G = (flow) * (m_o) * (R_P) * (omega_P);
    let F = (EA) * (((tau) * (m_o)) + ((G).power(2)))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let V = (G) * ((tau) + (EA))
        * ((((EA) * (m_o)) + ((N::number(-1.0 / 1.0)) * ((G).power(2)))).power(-1));
    let M_b = N::number(0.0);
    let Q = N::number(0.0);
    let tau_hat_1 = N::number(0.0);
    let vartheta_hat_1 = N::number(0.0);
    let stretch = ((EA).power(-1)) * ((EA) + (F));
    let X_hat_1 = (vartheta).cos();
    let Y_hat_1 = (vartheta).sin();
    let L_o_hat_1 = (L) * ((stretch).power(-1));
    let V_T = (N::number(-1.0 / 1.0)) * (G)
        * ((((N::number(-1.0 / 1.0)) * (EA) * (m_o)) + ((G).power(2))).power(-1));
    let stored = (N::number(1.0 / 2.0)) * ((EI).power(-1)) * ((M_b).power(2));
    let E_hat_1 = (V_T) * (stored) * (tau_hat_1);
    vec![tau_hat_1, vartheta_hat_1, X_hat_1, Y_hat_1, L_o_hat_1, E_hat_1]
}
pub fn boundary_string<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let x_P1 = inputs[2];
    let T_P2 = inputs[3];
    let theta_P2 = inputs[4];
    let x_P2 = inputs[5];
    let tau_s1 = inputs[6];
    let vartheta_s1 = inputs[7];
    let tau_s2 = inputs[8];
    let vartheta_s2 = inputs[9];
    let T_S1 = inputs[10];
    let theta_S1 = inputs[11];
    let x_S1 = inputs[12];
    let T_S2 = inputs[13];
    let theta_S2 = inputs[14];
    let x_S2 = inputs[15];
    let tau_t1 = inputs[16];
    let vartheta_t1 = inputs[17];
    let tau_t2 = inputs[18];
    let vartheta_t2 = inputs[19];
    let M_P = inputs[20];
    let A_P = inputs[21];
    let L_o_P = inputs[22];
    let W_P = inputs[23];
    let A_x_P = inputs[24];
    let A_y_P = inputs[25];
    let E_P = inputs[26];
    let X_s = inputs[27];
    let Y_s = inputs[28];
    let L_o_s = inputs[29];
    let E_s = inputs[30];
    let M_S = inputs[31];
    let A_S = inputs[32];
    let L_o_S = inputs[33];
    let W_S = inputs[34];
    let A_x_S = inputs[35];
    let A_y_S = inputs[36];
    let E_S = inputs[37];
    let X_t = inputs[38];
    let Y_t = inputs[39];
    let L_o_t = inputs[40];
    let E_t = inputs[41];
    let speed_ratio = inputs[42];
    let flow = inputs[43];
    let Phi_P = inputs[44];
    let Phi_S = inputs[45];
    let C_P = inputs[46];
    let C_S = inputs[47];
    let L_t = inputs[48];
    let L_s = inputs[49];
    let EA = inputs[50];
    let EI = inputs[51];
    let k = inputs[52];
    let m_o = inputs[53];
    let R_P = inputs[54];
    let R_S = inputs[55];
    let L_c = inputs[56];
    let beta = inputs[57];
    let mu_k = inputs[58];
    let v_thr = inputs[59];
    let omega_P = inputs[60];
    let M_in = inputs[61];
    let T_slack = inputs[62];
    let s_2 = N::number(1.0);
    let penetration_P1 = ((R_P).power(-1)) * (x_P1);
    let penetration_P2 = ((R_P).power(-1)) * (x_P2);
    let penetration_S1 = ((R_S).power(-1)) * (x_S1);
    let penetration_S2 = ((R_S).power(-1)) * (x_S2);
    let tension_P1 = (T_P1) + ((N::number(-1.0 / 1.0)) * (tau_t2));
    let tension_P2 = (T_P2) + ((N::number(-1.0 / 1.0)) * (tau_s1));
    let tension_S1 = (T_S1) + ((N::number(-1.0 / 1.0)) * (tau_s2));
    let tension_S2 = (T_S2) + ((N::number(-1.0 / 1.0)) * (tau_t1));
    let direction_P1 = (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t2))
        + ((N::number(1.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_P2 = ((Phi_P) * (s_2)) + (C_P) + ((N::number(-1.0 / 1.0)) * (theta_P2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s1))
        + ((N::number(-3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S1 = ((N::number(-1.0 / 1.0)) * (Phi_S) * (s_2))
        + ((N::number(-1.0 / 1.0)) * (C_S)) + ((N::number(-1.0 / 1.0)) * (theta_S1))
        + ((N::number(-1.0 / 1.0)) * (vartheta_s2))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let direction_S2 = ((N::number(-1.0 / 1.0)) * (C_S))
        + ((N::number(-1.0 / 1.0)) * (theta_S2))
        + ((N::number(-1.0 / 1.0)) * (vartheta_t1))
        + ((N::number(3.0 / 2.0)) * (N::number(std::f64::consts::PI)));
    let closure_X_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).cos()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (X_s))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + (L_c));
    let closure_Y_s = ((R_P).power(-1))
        * (((N::number(-1.0 / 1.0)) * (R_P) * ((((Phi_P) * (s_2)) + (C_P)).sin()))
            + ((N::number(-1.0 / 1.0)) * (L_s) * (Y_s))
            + ((R_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let closure_X_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).cos())) + ((N::number(-1.0 / 1.0)) * (L_t) * (X_t))
            + ((N::number(-1.0 / 1.0))
                * (((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).cos())) + (L_c))));
    let closure_Y_t = ((R_S).power(-1))
        * (((R_P) * ((C_P).sin())) + ((N::number(-1.0 / 1.0)) * (L_t) * (Y_t))
            + ((N::number(-1.0 / 1.0)) * (R_S) * ((C_S).sin())));
    let torque = (M_in) + (M_P);
    let slack_tension = ((N::number(-1.0 / 1.0)) * (T_slack)) + (T_P2);
    vec![
        penetration_P1, penetration_P2, penetration_S1, penetration_S2, tension_P1,
        tension_P2, tension_S1, tension_S2, direction_P1, direction_P2, direction_S1,
        direction_S2, closure_X_s, closure_Y_s, closure_X_t, closure_Y_t, torque,
        slack_tension
    ]
}
pub fn outputs_string<N: Number>(inputs: &[N]) -> Vec<N> {
    let T_P1 = inputs[0];
    let theta_P1 = inputs[1];
    let x_P1 = inputs[2];
    let T_P2 = inputs[3];
    let theta_P2 = inputs[4];
    let x_P2 = inputs[5];
    let tau_s1 = inputs[6];
    let vartheta_s1 = inputs[7];
    let tau_s2 = inputs[8];
    let vartheta_s2 = inputs[9];
    let T_S1 = inputs[10];
    let theta_S1 = inputs[11];
    let x_S1 = inputs[12];
    let T_S2 = inputs[13];
    let theta_S2 = inputs[14];
    let x_S2 = inputs[15];
    let tau_t1 = inputs[16];
    let vartheta_t1 = inputs[17];
    let tau_t2 = inputs[18];
    let vartheta_t2 = inputs[19];
    let M_P = inputs[20];
    let A_P = inputs[21];
    let L_o_P = inputs[22];
    let W_P = inputs[23];
    let A_x_P = inputs[24];
    let A_y_P = inputs[25];
    let E_P = inputs[26];
    let X_s = inputs[27];
    let Y_s = inputs[28];
    let L_o_s = inputs[29];
    let E_s = inputs[30];
    let M_S = inputs[31];
    let A_S = inputs[32];
    let L_o_S = inputs[33];
    let W_S = inputs[34];
    let A_x_S = inputs[35];
    let A_y_S = inputs[36];
    let E_S = inputs[37];
    let X_t = inputs[38];
    let Y_t = inputs[39];
    let L_o_t = inputs[40];
    let E_t = inputs[41];
    let speed_ratio = inputs[42];
    let flow = inputs[43];
    let Phi_P = inputs[44];
    let Phi_S = inputs[45];
    let C_P = inputs[46];
    let C_S = inputs[47];
    let L_t = inputs[48];
    let L_s = inputs[49];
    let EA = inputs[50];
    let EI = inputs[51];
    let k = inputs[52];
    let m_o = inputs[53];
    let R_P = inputs[54];
    let R_S = inputs[55];
    let L_c = inputs[56];
    let beta = inputs[57];
    let mu_k = inputs[58];
    let v_thr = inputs[59];
    let omega_P = inputs[60];
    let M_in = inputs[61];
    let T_slack = inputs[62];
    let s_2 = N::number(1.0);
    let binding_P = (((A_x_P).power(2)) + ((A_y_P).power(2))).sqrt();
    let binding_S = (((A_x_S).power(2)) + ((A_y_S).power(2))).sqrt();
    let primary__speed = omega_P;
    let primary__torque = (N::number(-1.0 / 1.0)) * (M_P);
    let primary__power = (N::number(-1.0 / 1.0)) * (omega_P) * (M_P);
    let primary__axial_force = A_P;
    let primary__wrap_angle = (Phi_P) * (s_2);
    let primary__entry_angle = theta_P1;
    let primary__exit_angle = theta_P2;
    let primary__orientation_angle = C_P;
    let primary__resultant_x = ((A_P).power(-1))
        * (((A_x_P) * ((C_P).cos()))
            + ((N::number(-1.0 / 1.0)) * (A_y_P) * ((C_P).sin())));
    let primary__resultant_y = ((A_P).power(-1))
        * (((A_x_P) * ((C_P).sin())) + ((A_y_P) * ((C_P).cos())));
    let primary__binding_moment = binding_P;
    let primary__friction_loss = W_P;
    let primary__entry_tension = T_P1;
    let primary__exit_tension = T_P2;
    let secondary__speed = (omega_P) * (speed_ratio);
    let secondary__torque = M_S;
    let secondary__power = (omega_P) * (speed_ratio) * (M_S);
    let secondary__axial_force = A_S;
    let secondary__wrap_angle = (Phi_S) * (s_2);
    let secondary__entry_angle = theta_S1;
    let secondary__exit_angle = theta_S2;
    let secondary__orientation_angle = C_S;
    let secondary__resultant_x = ((A_S).power(-1))
        * (((N::number(-1.0 / 1.0)) * (A_x_S) * ((((Phi_S) * (s_2)) + (C_S)).cos()))
            + ((N::number(-1.0 / 1.0)) * (A_y_S) * ((((Phi_S) * (s_2)) + (C_S)).sin())));
    let secondary__resultant_y = ((A_S).power(-1))
        * (((A_x_S) * ((((Phi_S) * (s_2)) + (C_S)).sin()))
            + ((N::number(-1.0 / 1.0)) * (A_y_S) * ((((Phi_S) * (s_2)) + (C_S)).cos())));
    let secondary__binding_moment = binding_S;
    let secondary__friction_loss = W_S;
    let secondary__entry_tension = T_S1;
    let secondary__exit_tension = T_S2;
    let tight_span__arc_length = (L_t) * (s_2);
    let tight_span__unstretched_length = L_o_t;
    let slack_span__arc_length = (L_s) * (s_2);
    let slack_span__unstretched_length = L_o_s;
    let efficiency__speed = ((R_P).power(-1)) * (speed_ratio) * (R_S);
    let efficiency__torque = (N::number(-1.0 / 1.0)) * (R_P) * ((R_S).power(-1))
        * ((M_P).power(-1)) * (M_S);
    let efficiency__overall = (N::number(-1.0 / 1.0)) * (speed_ratio) * ((M_P).power(-1))
        * (M_S);
    let belt__mass_flow = (flow) * (m_o) * (R_P) * (omega_P);
    let belt__unstretched_length = (L_o_t) + (L_o_s) + (L_o_P) + (L_o_S);
    let energy__power_in = (N::number(-1.0 / 1.0)) * (omega_P) * (M_P);
    let energy__power_out = (omega_P) * (speed_ratio) * (M_S);
    let energy__friction_loss = (W_P) + (W_S);
    let energy__stretch_work = (E_P) + (E_s) + (E_S) + (E_t);
    let energy__imbalance = (N::number(1.0 / 1.0))
        + (((omega_P).power(-1)) * ((M_P).power(-1))
            * (((omega_P) * (speed_ratio) * (M_S)) + (W_P) + (W_S)));
    let energy__closure = (N::number(1.0 / 1.0))
        + (((omega_P).power(-1)) * ((M_P).power(-1))
            * (((omega_P) * (speed_ratio) * (M_S)) + (W_P) + (W_S) + (E_P) + (E_s)
                + (E_S) + (E_t)));
    vec![
        primary__speed, primary__torque, primary__power, primary__axial_force,
        primary__wrap_angle, primary__entry_angle, primary__exit_angle,
        primary__orientation_angle, primary__resultant_x, primary__resultant_y,
        primary__binding_moment, primary__friction_loss, primary__entry_tension,
        primary__exit_tension, secondary__speed, secondary__torque, secondary__power,
        secondary__axial_force, secondary__wrap_angle, secondary__entry_angle,
        secondary__exit_angle, secondary__orientation_angle, secondary__resultant_x,
        secondary__resultant_y, secondary__binding_moment, secondary__friction_loss,
        secondary__entry_tension, secondary__exit_tension, tight_span__arc_length,
        tight_span__unstretched_length, slack_span__arc_length,
        slack_span__unstretched_length, efficiency__speed, efficiency__torque,
        efficiency__overall, belt__mass_flow, belt__unstretched_length, energy__power_in,
        energy__power_out, energy__friction_loss, energy__stretch_work,
        energy__imbalance, energy__closure
    ]
}
/// All twins by the names of their kernels.
#[allow(clippy::type_complexity)]
pub fn all<N: Number>() -> Vec<(&'static str, fn(&[N]) -> Vec<N>)> {
    vec![
        ("contact_linearised_viscous_coulomb", contact_linearised_viscous_coulomb:: < N
        >), ("contact_linearised_tanh", contact_linearised_tanh:: < N >),
        ("contact_full_viscous_coulomb", contact_full_viscous_coulomb:: < N >),
        ("contact_full_tanh", contact_full_tanh:: < N >), ("span_derived", span_derived::
        < N >), ("span_as_printed", span_as_printed:: < N >),
        ("boundary_zero_linearised", boundary_zero_linearised:: < N >),
        ("boundary_zero_full", boundary_zero_full:: < N >),
        ("boundary_continuous_linearised", boundary_continuous_linearised:: < N >),
        ("boundary_continuous_full", boundary_continuous_full:: < N >),
        ("boundary_as_printed", boundary_as_printed:: < N >), ("outputs", outputs:: < N
        >), ("contact_string_viscous_coulomb", contact_string_viscous_coulomb:: < N >),
        ("contact_string_tanh", contact_string_tanh:: < N >), ("span_string",
        span_string:: < N >), ("boundary_string", boundary_string:: < N >),
        ("outputs_string", outputs_string:: < N >)
    ]
}
