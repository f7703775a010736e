/*
 * inverse_dynamics of trolley
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate
 *
 * Sizes: out 5, work 0, w 14
 * Operations per call: 178 = 107 mul, 31 sub, 30 add, 4 cos, 4 sin, 1 table, 1 tanh
 * Operations of prepare: 40 = 22 mul, 12 add, 5 sub, 1 div
 *
 * Input t (1): time
 *   t[0]  t [s]
 *
 * Input q (5): generalized coordinates
 *   q[0]  track [m]
 *   q[1]  left.hang.angle1 [rad]
 *   q[2]  left.hang.angle2 [rad]
 *   q[3]  right.hang.angle1 [rad]
 *   q[4]  right.hang.angle2 [rad]
 *
 * Input u (5): generalized speeds
 *   u[0]  track.u [m/s]
 *   u[1]  left.hang.u.angle1 [rad/s]
 *   u[2]  left.hang.u.angle2 [rad/s]
 *   u[3]  right.hang.u.angle1 [rad/s]
 *   u[4]  right.hang.u.angle2 [rad/s]
 *
 * Input r (1): inputs of the model
 *   r[0]  push [N]
 *
 * Input p (13): parameters, read by prepare_ only
 *
 * Input udot (5): derivatives of the speeds
 *   udot[0]  track.udot [m/s^2]
 *   udot[1]  left.hang.u.angle1dot [rad/s^2]
 *   udot[2]  left.hang.u.angle2dot [rad/s^2]
 *   udot[3]  right.hang.u.angle1dot [rad/s^2]
 *   udot[4]  right.hang.u.angle2dot [rad/s^2]
 *
 * Output tau (5)
 *   out[0]  track.u.tau [N]
 *   out[1]  left.hang.u.angle1.tau [N*m]
 *   out[2]  left.hang.u.angle2.tau [N*m]
 *   out[3]  right.hang.u.angle1.tau [N*m]
 *   out[4]  right.hang.u.angle2.tau [N*m]
 */
#include "cardan.h"

static const double table_0_inverse_dynamics_breaks[5] = {
    -3.0, -1.0, 0.0, 1.0, 3.0
};

static const double table_0_inverse_dynamics_coefficients[16] = {
    0.2118644067796609, -6.673728813559322, 0.0, 120.0, 70.84745762711864, -141.6949152542373,
    -24.152542372881356, 95.0, 70.84745762711864, -70.84745762711864, -95.0, 0.0,
    0.2118644067796609, 5.402542372881356, -24.152542372881356, -95.0
};

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* left.bucket: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal left_load = p[3]; /* kg */
    const wreal left_rope = p[4]; /* m */
    const wreal left_size = p[5]; /* m */
    const wreal left_size_squared = left_size * left_size;
    const wreal left_bucket_origin_inertia_zz = 0.5 * left_load * left_size_squared;
    const wreal left_bucket_minus_first_moment_z = left_load * left_rope;
    const wreal left_bucket_origin_inertia_xx = 0.3333333333333333 * left_load * left_size_squared +
        left_rope * left_bucket_minus_first_moment_z;
    const wreal left_bucket_base_half_trace = 0.5 * (left_bucket_origin_inertia_zz
        + left_bucket_origin_inertia_xx + left_bucket_origin_inertia_xx);
    const wreal left_bucket_base_second_moment_xx = left_bucket_base_half_trace
        - left_bucket_origin_inertia_xx;
    const wreal left_bucket_base_second_moment_zz = left_bucket_base_half_trace
        - left_bucket_origin_inertia_zz;
    w[3] = left_bucket_minus_first_moment_z;
    w[9] = left_bucket_base_second_moment_xx;
    w[10] = left_bucket_base_second_moment_zz;

    /* right.bucket: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal right_load = p[6]; /* kg */
    const wreal right_rope = p[7]; /* m */
    const wreal right_size = p[8]; /* m */
    const wreal right_size_squared = right_size * right_size;
    const wreal right_bucket_origin_inertia_zz = 0.5 * right_load * right_size_squared;
    const wreal right_bucket_minus_first_moment_z = right_load * right_rope;
    const wreal right_bucket_origin_inertia_xx = 0.3333333333333333 * right_load *
        right_size_squared + right_rope * right_bucket_minus_first_moment_z;
    const wreal right_bucket_base_half_trace = 0.5 * (right_bucket_origin_inertia_zz
        + right_bucket_origin_inertia_xx + right_bucket_origin_inertia_xx);
    const wreal right_bucket_base_second_moment_xx = right_bucket_base_half_trace
        - right_bucket_origin_inertia_xx;
    const wreal right_bucket_base_second_moment_zz = right_bucket_base_half_trace
        - right_bucket_origin_inertia_zz;
    w[4] = right_bucket_minus_first_moment_z;
    w[11] = right_bucket_base_second_moment_xx;
    w[12] = right_bucket_base_second_moment_zz;

    /* wheel: mass, origin inertia, base, inertia force */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal wheel = p[1]; /* kg */
    const wreal radius = p[2]; /* m */
    const wreal radius_squared = radius * radius;
    const wreal wheel_origin_inertia_xx = 0.2708333333333333 * wheel * radius_squared;
    const wreal wheel_origin_inertia_yy = 0.5 * wheel * radius_squared;
    const wreal wheel_base_second_moment_xx = 0.5 * (wheel_origin_inertia_xx
        + wheel_origin_inertia_xx + wheel_origin_inertia_yy) - wheel_origin_inertia_xx;
    const wreal twice_wheel_base_second_moment_xx = wheel_base_second_moment_xx
        + wheel_base_second_moment_xx;
    w[13] = twice_wheel_base_second_moment_xx;

    /* axle: coupling */
    const wreal radius_inverse = 1.0 / radius;
    w[5] = radius_inverse;

    /* trolley: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal trolley_mass = p[10]; /* kg */
    const wreal trolley_base_mass = left_load + right_load + (wheel + trolley_mass);
    w[8] = trolley_base_mass;

    /* parameters as they are */
    w[0] = p[4]; /* left.rope [m] */
    w[1] = p[7]; /* right.rope [m] */
    w[2] = p[9]; /* gravity.z [m/s^2] */
    w[6] = p[11]; /* buffer.stiffness [N/m] */
    w[7] = p[12]; /* buffer.rest [m] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const t = in->t;
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real left_hang_angle1 = q[1]; /* rad */
    const real left_hang_angle2 = q[2]; /* rad */
    const real right_hang_angle1 = q[3]; /* rad */
    const real right_hang_angle2 = q[4]; /* rad */
    const real angle[CARDAN_PADDED(4)] = {left_hang_angle1, left_hang_angle2, right_hang_angle1,
        right_hang_angle2};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real left_hang_angle1_cos = cosine[0];
    const real left_hang_angle1_sin = sine[0];
    const real left_hang_angle2_cos = cosine[1];
    const real left_hang_angle2_sin = sine[1];
    const real right_hang_angle1_cos = cosine[2];
    const real right_hang_angle1_sin = sine[2];
    const real right_hang_angle2_cos = cosine[3];
    const real right_hang_angle2_sin = sine[3];

    /* left.hang: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real left_hang_u_angle1 = u[1]; /* rad/s */
    const real left_hang_u_angle2 = u[2]; /* rad/s */
    const real left_hang_R_yx = left_hang_angle1_sin * left_hang_angle2_sin;
    const real left_hang_minus_R_yz = left_hang_angle1_sin * left_hang_angle2_cos;
    const real left_hang_u_angle1_times_hang_u_angle2 = left_hang_u_angle1 * left_hang_u_angle2;

    /* left.bucket: omega, v, alpha, a, U, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* v = Rᵀ (v_parent + omega_parent x p) + S_v u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real track_u = u[0]; /* m/s */
    const real track_udot = udot[0]; /* m/s^2 */
    const real left_hang_u_angle1dot = udot[1]; /* rad/s^2 */
    const real left_hang_u_angle2dot = udot[2]; /* rad/s^2 */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal left_bucket_base_second_moment_xx = w[9];
    const real left_bucket_omega_x = left_hang_u_angle1 * left_hang_angle2_cos;
    const real left_bucket_omega_z = left_hang_u_angle1 * left_hang_angle2_sin;
    const real left_bucket_v_x = track_u * left_hang_angle2_cos;
    const real left_bucket_v_z = track_u * left_hang_angle2_sin;
    const real left_bucket_alpha_x = left_hang_u_angle1dot * left_hang_angle2_cos
        - left_hang_angle2_sin * left_hang_u_angle1_times_hang_u_angle2;
    const real left_bucket_alpha_z = left_hang_angle2_cos * left_hang_u_angle1_times_hang_u_angle2 +
        left_hang_u_angle1dot * left_hang_angle2_sin;
    const real left_bucket_a_x = track_udot * left_hang_angle2_cos
        + left_hang_angle1_cos * left_hang_angle2_sin * gravity_z;
    const real left_hang_u_angle2_times_left_bucket_omega_x = left_hang_u_angle2 *
        left_bucket_omega_x;
    const real left_bucket_omega_x_times_omega_z = left_bucket_omega_x * left_bucket_omega_z;
    const real left_hang_u_angle2_times_left_bucket_omega_z = left_hang_u_angle2 *
        left_bucket_omega_z;
    const real left_bucket_U_xy = left_hang_u_angle2_times_left_bucket_omega_x
        - left_bucket_alpha_z;
    const real left_bucket_U_xz = left_hang_u_angle2dot + left_bucket_omega_x_times_omega_z;
    const real left_bucket_U_yx = left_bucket_alpha_z
        + left_hang_u_angle2_times_left_bucket_omega_x;
    const real left_bucket_U_yz = left_hang_u_angle2_times_left_bucket_omega_z
        - left_bucket_alpha_x;
    const real left_bucket_U_zx = left_bucket_omega_x_times_omega_z - left_hang_u_angle2dot;
    const real left_bucket_U_zy = left_bucket_alpha_x
        + left_hang_u_angle2_times_left_bucket_omega_z;
    const real left_bucket_n_z = left_bucket_base_second_moment_xx * left_bucket_U_yx
        - left_bucket_base_second_moment_xx * left_bucket_U_xy;

    /* right.hang: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real right_hang_u_angle1 = u[3]; /* rad/s */
    const real right_hang_u_angle2 = u[4]; /* rad/s */
    const real right_hang_R_yx = right_hang_angle1_sin * right_hang_angle2_sin;
    const real right_hang_minus_R_yz = right_hang_angle1_sin * right_hang_angle2_cos;
    const real right_hang_u_angle1_times_hang_u_angle2 = right_hang_u_angle1 * right_hang_u_angle2;

    /* right.bucket: omega, v, alpha, a, U, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* v = Rᵀ (v_parent + omega_parent x p) + S_v u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real right_hang_u_angle1dot = udot[3]; /* rad/s^2 */
    const real right_hang_u_angle2dot = udot[4]; /* rad/s^2 */
    const wreal right_bucket_base_second_moment_xx = w[11];
    const real right_bucket_omega_x = right_hang_u_angle1 * right_hang_angle2_cos;
    const real right_bucket_omega_z = right_hang_u_angle1 * right_hang_angle2_sin;
    const real right_bucket_v_x = track_u * right_hang_angle2_cos;
    const real right_bucket_v_z = track_u * right_hang_angle2_sin;
    const real right_bucket_alpha_x = right_hang_u_angle1dot * right_hang_angle2_cos
        - right_hang_angle2_sin * right_hang_u_angle1_times_hang_u_angle2;
    const real right_bucket_alpha_z = right_hang_angle2_cos *
        right_hang_u_angle1_times_hang_u_angle2 + right_hang_u_angle1dot * right_hang_angle2_sin;
    const real right_bucket_a_x = track_udot * right_hang_angle2_cos
        + right_hang_angle1_cos * right_hang_angle2_sin * gravity_z;
    const real right_hang_u_angle2_times_right_bucket_omega_x = right_hang_u_angle2 *
        right_bucket_omega_x;
    const real right_bucket_omega_x_times_omega_z = right_bucket_omega_x * right_bucket_omega_z;
    const real right_hang_u_angle2_times_right_bucket_omega_z = right_hang_u_angle2 *
        right_bucket_omega_z;
    const real right_bucket_U_xy = right_hang_u_angle2_times_right_bucket_omega_x
        - right_bucket_alpha_z;
    const real right_bucket_U_xz = right_hang_u_angle2dot + right_bucket_omega_x_times_omega_z;
    const real right_bucket_U_yx = right_bucket_alpha_z
        + right_hang_u_angle2_times_right_bucket_omega_x;
    const real right_bucket_U_yz = right_hang_u_angle2_times_right_bucket_omega_z
        - right_bucket_alpha_x;
    const real right_bucket_U_zx = right_bucket_omega_x_times_omega_z - right_hang_u_angle2dot;
    const real right_bucket_U_zy = right_bucket_alpha_x
        + right_hang_u_angle2_times_right_bucket_omega_z;
    const real right_bucket_n_z = right_bucket_base_second_moment_xx * right_bucket_U_yx
        - right_bucket_base_second_moment_xx * right_bucket_U_xy;

    /* left.air: force, data */
    /* force = R (its components) at the origin */
    const wreal left_rope = w[0]; /* m */
    const real left_bucket_v_x_minus_left_rope_times_hang_u_angle2 = left_bucket_v_x
        - left_rope * left_hang_u_angle2;
    const real left_air_minus_force_on_left_middle_x = 2.0 * (left_hang_angle2_cos *
        left_bucket_v_x_minus_left_rope_times_hang_u_angle2
        + left_hang_angle2_sin * left_bucket_v_z);
    const real left_air_minus_force_on_left_middle_y = 2.0 * (left_hang_R_yx *
        left_bucket_v_x_minus_left_rope_times_hang_u_angle2
        - left_hang_minus_R_yz * left_bucket_v_z
        + left_rope * left_bucket_omega_x * left_hang_angle1_cos);
    const real left_bucket_n_y_part = left_hang_angle2_cos * left_air_minus_force_on_left_middle_x +
        left_hang_R_yx * left_air_minus_force_on_left_middle_y;

    /* right.air: force, data */
    /* force = R (its components) at the origin */
    const wreal right_rope = w[1]; /* m */
    const real right_bucket_v_x_minus_right_rope_times_hang_u_angle2 = right_bucket_v_x
        - right_rope * right_hang_u_angle2;
    const real right_air_minus_force_on_right_middle_x = 2.0 * (right_hang_angle2_cos *
        right_bucket_v_x_minus_right_rope_times_hang_u_angle2
        + right_hang_angle2_sin * right_bucket_v_z);
    const real right_air_minus_force_on_right_middle_y = 2.0 * (right_hang_R_yx *
        right_bucket_v_x_minus_right_rope_times_hang_u_angle2
        - right_hang_minus_R_yz * right_bucket_v_z
        + right_rope * right_bucket_omega_x * right_hang_angle1_cos);
    const real right_bucket_n_y_part = right_hang_angle2_cos *
        right_air_minus_force_on_right_middle_x
        + right_hang_R_yx * right_air_minus_force_on_right_middle_y;

    /* wheel: alpha, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal radius_inverse = w[5];
    const wreal twice_wheel_base_second_moment_xx = w[13];
    const real wheel_alpha_y = radius_inverse * track_udot;
    const real wheel_n_y = wheel_alpha_y * twice_wheel_base_second_moment_xx;

    /* left.bucket: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal left_bucket_minus_first_moment_z = w[3];
    const wreal left_bucket_base_second_moment_zz = w[10];
    const real left_bucket_n_x = left_bucket_base_second_moment_xx * left_bucket_U_zy
        - gravity_z * left_hang_angle1_sin * left_bucket_minus_first_moment_z
        - left_bucket_base_second_moment_zz * left_bucket_U_yz
        + left_hang_angle1_cos * left_air_minus_force_on_left_middle_y * left_rope;
    const real left_bucket_f_x = left_bucket_n_y_part
        - left_bucket_minus_first_moment_z * left_bucket_U_xz;
    const real left_bucket_f_z = left_hang_angle2_sin * left_air_minus_force_on_left_middle_x
        + left_bucket_minus_first_moment_z * (left_bucket_omega_x * left_bucket_omega_x
        + left_hang_u_angle2 * left_hang_u_angle2)
        - left_hang_minus_R_yz * left_air_minus_force_on_left_middle_y;
    /* tau: left.hang.u.angle2.tau [N*m] */
    out[2] = left_bucket_base_second_moment_zz * left_bucket_U_xz
        - left_bucket_base_second_moment_xx * left_bucket_U_zx
        - left_bucket_minus_first_moment_z * left_bucket_a_x - left_rope * left_bucket_n_y_part;

    /* right.bucket: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal right_bucket_minus_first_moment_z = w[4];
    const wreal right_bucket_base_second_moment_zz = w[12];
    const real right_bucket_n_x = right_bucket_base_second_moment_xx * right_bucket_U_zy
        - gravity_z * right_hang_angle1_sin * right_bucket_minus_first_moment_z
        - right_bucket_base_second_moment_zz * right_bucket_U_yz
        + right_hang_angle1_cos * right_air_minus_force_on_right_middle_y * right_rope;
    const real right_bucket_f_x = right_bucket_n_y_part
        - right_bucket_minus_first_moment_z * right_bucket_U_xz;
    const real right_bucket_f_z = right_hang_angle2_sin * right_air_minus_force_on_right_middle_x
        + right_bucket_minus_first_moment_z * (right_bucket_omega_x * right_bucket_omega_x
        + right_hang_u_angle2 * right_hang_u_angle2)
        - right_hang_minus_R_yz * right_air_minus_force_on_right_middle_y;
    /* tau: right.hang.u.angle2.tau [N*m] */
    out[4] = right_bucket_base_second_moment_zz * right_bucket_U_xz
        - right_bucket_base_second_moment_xx * right_bucket_U_zx
        - right_bucket_minus_first_moment_z * right_bucket_a_x - right_rope * right_bucket_n_y_part;

    /* right.hang: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: right.hang.u.angle1.tau [N*m] */
    out[3] = right_hang_angle2_cos * right_bucket_n_x + right_hang_angle2_sin * right_bucket_n_z;

    /* left.hang: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: left.hang.u.angle1.tau [N*m] */
    out[1] = left_hang_angle2_cos * left_bucket_n_x + left_hang_angle2_sin * left_bucket_n_z;

    /* trolley: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal trolley_base_mass = w[8];
    const real trolley_f_x = right_hang_angle2_sin * right_bucket_f_z
        + left_hang_angle2_cos * left_bucket_f_x + (trolley_base_mass * track_udot
        + left_hang_angle2_sin * left_bucket_f_z + right_hang_angle2_cos * right_bucket_f_x);

    /* track: tau */
    /* tau = S . [n; f] - force on the joint */
    const real track_q = q[0]; /* m */
    const real push = r[0]; /* N */
    const real t_value = t[0]; /* s */
    const wreal buffer_stiffness = w[6]; /* N/m */
    const wreal buffer_rest = w[7]; /* m */
    /* tau: track.u.tau [N] */
    out[0] = buffer_stiffness * (track_q - buffer_rest) + radius_inverse * wheel_n_y
        - cardan_piecewise(4, 4, table_0_inverse_dynamics_breaks,
        table_0_inverse_dynamics_coefficients, 0, track_u) - push * cardan_tanh(2.0 * t_value)
        + trolley_f_x;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {5, 0, 14, 1, 5, 5, 0, 0, 1, 13, 0, 5, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
