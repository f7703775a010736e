/*
 * inverse_dynamics of v_twin
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 6, work 0, w 17
 * Operations per call: 74 = 36 mul, 18 sub, 10 add, 4 cos, 4 sin, 2 neg
 * Operations of prepare: 62 = 34 mul, 16 add, 4 sub, 2 atan2, 2 cos, 2 neg, 2 sin
 *
 * Input q (6): generalized coordinates
 *   q[0]  right.crank [rad]
 *   q[1]  right.rod [rad]
 *   q[2]  right.piston [m]
 *   q[3]  left.crank [rad]
 *   q[4]  left.rod [rad]
 *   q[5]  left.piston [m]
 *
 * Input u (6): generalized speeds
 *   u[0]  right.crank.u [rad/s]
 *   u[1]  right.rod.u [rad/s]
 *   u[2]  right.piston.u [m/s]
 *   u[3]  left.crank.u [rad/s]
 *   u[4]  left.rod.u [rad/s]
 *   u[5]  left.piston.u [m/s]
 *
 * Input r (4): inputs of the model
 *   r[0]  right.torque [N m]
 *   r[1]  right.force [N]
 *   r[2]  left.torque [N m]
 *   r[3]  left.force [N]
 *
 * Input p (18): parameters, read by prepare_ only
 *
 * Input udot (6): derivatives of the speeds
 *   udot[0]  right.crank.udot [rad/s^2]
 *   udot[1]  right.rod.udot [rad/s^2]
 *   udot[2]  right.piston.udot [m/s^2]
 *   udot[3]  left.crank.udot [rad/s^2]
 *   udot[4]  left.rod.udot [rad/s^2]
 *   udot[5]  left.piston.udot [m/s^2]
 *
 * Output tau (6)
 *   out[0]  right.crank.u.tau [N*m]
 *   out[1]  right.rod.u.tau [N*m]
 *   out[2]  right.piston.u.tau [N]
 *   out[3]  left.crank.u.tau [N*m]
 *   out[4]  left.rod.u.tau [N*m]
 *   out[5]  left.piston.u.tau [N]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* shared by several: placement */
    const wreal right_ground_rotation_angle2 = p[15]; /* rad */
    const wreal left_ground_rotation_angle2 = p[17]; /* rad */
    const wreal angle[CARDAN_PADDED(2)] = {right_ground_rotation_angle2,
        left_ground_rotation_angle2};
    wreal sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const wreal right_ground_rotation_angle2_cos = cosine[0];
    const wreal right_ground_rotation_angle2_sin = sine[0];
    const wreal left_ground_rotation_angle2_cos = cosine[1];
    const wreal left_ground_rotation_angle2_sin = sine[1];

    /* right.crank: mass, first moment, origin inertia, place, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal right_crank_length = p[0]; /* m */
    const wreal right_crank_mass = p[4]; /* kg */
    const wreal half_right_crank_length = 0.5 * right_crank_length;
    const wreal right_crank_first_moment_x = right_crank_mass * half_right_crank_length;
    const wreal right_crank_origin_inertia_yy = right_crank_length * right_crank_length *
        (0.08333333333333333 * right_crank_mass)
        + half_right_crank_length * right_crank_first_moment_x;
    const wreal right_crank_minus_offset = cardan_atan2(-right_ground_rotation_angle2_cos,
        right_ground_rotation_angle2_sin);
    const wreal right_crank_base_half_trace = 0.5 * (right_crank_origin_inertia_yy
        + right_crank_origin_inertia_yy);
    const wreal right_crank_base_second_moment_zz = right_crank_base_half_trace
        - right_crank_origin_inertia_yy;
    w[7] = right_crank_minus_offset;

    /* right.rod: mass, first moment, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal right_rod_length = p[1]; /* m */
    const wreal right_rod_mass = p[5]; /* kg */
    const wreal half_right_rod_length = 0.5 * right_rod_length;
    const wreal right_rod_first_moment_x = right_rod_mass * half_right_rod_length;
    const wreal right_rod_origin_inertia_yy = right_rod_length * right_rod_length *
        (0.08333333333333333 * right_rod_mass) + half_right_rod_length * right_rod_first_moment_x;
    const wreal right_rod_base_mass_moment_x = right_crank_length * right_rod_mass;
    const wreal right_rod_base_second_moment_xx = 0.5 * (right_rod_origin_inertia_yy
        + right_rod_origin_inertia_yy);
    const wreal right_rod_base_second_moment_zz = right_rod_base_second_moment_xx
        - right_rod_origin_inertia_yy;
    const wreal right_rod_base_second_moment_xx_plus_base_second_moment_zz =
        right_rod_base_second_moment_xx + right_rod_base_second_moment_zz;
    w[5] = right_rod_first_moment_x;
    w[14] = right_rod_base_second_moment_xx_plus_base_second_moment_zz;

    /* left.crank: mass, first moment, origin inertia, place, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal left_crank_length = p[7]; /* m */
    const wreal left_crank_mass = p[11]; /* kg */
    const wreal half_left_crank_length = 0.5 * left_crank_length;
    const wreal left_crank_first_moment_x = left_crank_mass * half_left_crank_length;
    const wreal left_crank_origin_inertia_yy = left_crank_length * left_crank_length *
        (0.08333333333333333 * left_crank_mass)
        + half_left_crank_length * left_crank_first_moment_x;
    const wreal left_crank_minus_offset = cardan_atan2(-left_ground_rotation_angle2_cos,
        left_ground_rotation_angle2_sin);
    const wreal left_crank_base_half_trace = 0.5 * (left_crank_origin_inertia_yy
        + left_crank_origin_inertia_yy);
    const wreal left_crank_base_second_moment_zz = left_crank_base_half_trace
        - left_crank_origin_inertia_yy;
    w[8] = left_crank_minus_offset;

    /* left.rod: mass, first moment, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal left_rod_length = p[8]; /* m */
    const wreal left_rod_mass = p[12]; /* kg */
    const wreal half_left_rod_length = 0.5 * left_rod_length;
    const wreal left_rod_first_moment_x = left_rod_mass * half_left_rod_length;
    const wreal left_rod_origin_inertia_yy = left_rod_length * left_rod_length *
        (0.08333333333333333 * left_rod_mass) + half_left_rod_length * left_rod_first_moment_x;
    const wreal left_rod_base_mass_moment_x = left_crank_length * left_rod_mass;
    const wreal left_rod_base_second_moment_xx = 0.5 * (left_rod_origin_inertia_yy
        + left_rod_origin_inertia_yy);
    const wreal left_rod_base_second_moment_zz = left_rod_base_second_moment_xx
        - left_rod_origin_inertia_yy;
    const wreal left_rod_base_second_moment_xx_plus_base_second_moment_zz =
        left_rod_base_second_moment_xx + left_rod_base_second_moment_zz;
    w[6] = left_rod_first_moment_x;
    w[16] = left_rod_base_second_moment_xx_plus_base_second_moment_zz;

    /* left.crank: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal left_crank_base_moment_x = left_crank_first_moment_x + left_rod_base_mass_moment_x;
    const wreal left_crank_base_second_moment_xx = left_crank_length * left_rod_base_mass_moment_x +
        left_crank_base_half_trace;
    const wreal left_crank_base_second_moment_zz_plus_base_second_moment_xx =
        left_crank_base_second_moment_zz + left_crank_base_second_moment_xx;
    w[9] = left_crank_base_moment_x;
    w[15] = left_crank_base_second_moment_zz_plus_base_second_moment_xx;

    /* right.crank: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal right_crank_base_moment_x = right_crank_first_moment_x
        + right_rod_base_mass_moment_x;
    const wreal right_crank_base_second_moment_xx = right_crank_length *
        right_rod_base_mass_moment_x + right_crank_base_half_trace;
    const wreal right_crank_base_second_moment_zz_plus_base_second_moment_xx =
        right_crank_base_second_moment_zz + right_crank_base_second_moment_xx;
    w[10] = right_crank_base_moment_x;
    w[13] = right_crank_base_second_moment_zz_plus_base_second_moment_xx;

    /* right.piston: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = p[14]; /* m/s^2 */
    const wreal gravity_z_times_right_ground_rotation_angle2_sin = gravity_z *
        right_ground_rotation_angle2_sin;
    w[11] = gravity_z_times_right_ground_rotation_angle2_sin;

    /* left.piston: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z_times_left_ground_rotation_angle2_sin = gravity_z *
        left_ground_rotation_angle2_sin;
    w[12] = gravity_z_times_left_ground_rotation_angle2_sin;

    /* parameters as they are */
    w[0] = p[0]; /* right.crank_length [m] */
    w[1] = p[6]; /* right.piston_mass [kg] */
    w[2] = p[7]; /* left.crank_length [m] */
    w[3] = p[13]; /* left.piston_mass [kg] */
    w[4] = p[14]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real right_crank = q[0]; /* rad */
    const real right_rod = q[1]; /* rad */
    const real left_crank = q[3]; /* rad */
    const real left_rod = q[4]; /* rad */
    const wreal right_crank_minus_offset = w[7];
    const wreal left_crank_minus_offset = w[8];
    const real right_crank_angle = right_crank - right_crank_minus_offset;
    const real left_crank_angle = left_crank - left_crank_minus_offset;
    const real angle[CARDAN_PADDED(4)] = {right_crank_angle, right_rod, left_crank_angle, left_rod};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real right_crank_angle_cos = cosine[0];
    const real right_crank_angle_sin = sine[0];
    const real right_rod_cos = cosine[1];
    const real right_rod_sin = sine[1];
    const real left_crank_angle_cos = cosine[2];
    const real left_crank_angle_sin = sine[2];
    const real left_rod_cos = cosine[3];
    const real left_rod_sin = sine[3];

    /* right.crank: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[4]; /* m/s^2 */
    const real right_crank_a_x = gravity_z * right_crank_angle_cos;
    const real right_crank_minus_a_z = gravity_z * right_crank_angle_sin;

    /* right.rod: omega, U, a, tau, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* tau = S . [n; f] - force on the joint */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real right_crank_u = u[0]; /* rad/s */
    const real right_rod_u = u[1]; /* rad/s */
    const real right_crank_udot = udot[0]; /* rad/s^2 */
    const real right_rod_udot = udot[1]; /* rad/s^2 */
    const wreal right_crank_length = w[0]; /* m */
    const wreal right_rod_first_moment_x = w[5];
    const wreal right_rod_base_second_moment_xx_plus_base_second_moment_zz = w[14];
    const real right_rod_minus_omega_y = right_crank_u + right_rod_u;
    const real right_rod_U_zx = right_crank_udot + right_rod_udot;
    const real right_rod_a_z = right_rod_cos * (right_crank_length * right_crank_udot
        - right_crank_minus_a_z) - right_rod_sin * (right_crank_a_x
        - right_crank_u * right_crank_u * right_crank_length);
    const real right_rod_tau = right_rod_U_zx *
        right_rod_base_second_moment_xx_plus_base_second_moment_zz
        + right_rod_first_moment_x * right_rod_a_z;
    const real right_rod_f_z = right_rod_first_moment_x * right_rod_U_zx;
    out[1] = right_rod_tau; /* tau: right.rod.u.tau [N*m] */

    /* left.crank: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const real left_crank_a_x = gravity_z * left_crank_angle_cos;
    const real left_crank_minus_a_z = gravity_z * left_crank_angle_sin;

    /* left.rod: omega, U, a, tau, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* tau = S . [n; f] - force on the joint */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real left_crank_u = u[3]; /* rad/s */
    const real left_rod_u = u[4]; /* rad/s */
    const real left_crank_udot = udot[3]; /* rad/s^2 */
    const real left_rod_udot = udot[4]; /* rad/s^2 */
    const wreal left_crank_length = w[2]; /* m */
    const wreal left_rod_first_moment_x = w[6];
    const wreal left_rod_base_second_moment_xx_plus_base_second_moment_zz = w[16];
    const real left_rod_minus_omega_y = left_crank_u + left_rod_u;
    const real left_rod_U_zx = left_crank_udot + left_rod_udot;
    const real left_rod_a_z = left_rod_cos * (left_crank_length * left_crank_udot
        - left_crank_minus_a_z) - left_rod_sin * (left_crank_a_x
        - left_crank_u * left_crank_u * left_crank_length);
    const real left_rod_tau = left_rod_U_zx *
        left_rod_base_second_moment_xx_plus_base_second_moment_zz
        + left_rod_first_moment_x * left_rod_a_z;
    const real left_rod_f_z = left_rod_first_moment_x * left_rod_U_zx;
    out[4] = left_rod_tau; /* tau: left.rod.u.tau [N*m] */

    /* right.piston: a, f, tau */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* tau = S . [n; f] - force on the joint */
    const real right_force = r[1]; /* N */
    const real right_piston_udot = udot[2]; /* m/s^2 */
    const wreal right_piston_mass = w[1]; /* kg */
    const wreal gravity_z_times_right_ground_rotation_angle2_sin = w[11];
    const real right_piston_a_x = right_piston_udot
        + gravity_z_times_right_ground_rotation_angle2_sin;
    const real right_piston_f_x = right_piston_mass * right_piston_a_x;
    out[2] = right_piston_f_x - right_force; /* tau: right.piston.u.tau [N] */

    /* left.piston: a, f, tau */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* tau = S . [n; f] - force on the joint */
    const real left_force = r[3]; /* N */
    const real left_piston_udot = udot[5]; /* m/s^2 */
    const wreal left_piston_mass = w[3]; /* kg */
    const wreal gravity_z_times_left_ground_rotation_angle2_sin = w[12];
    const real left_piston_a_x = left_piston_udot + gravity_z_times_left_ground_rotation_angle2_sin;
    const real left_piston_f_x = left_piston_mass * left_piston_a_x;
    out[5] = left_piston_f_x - left_force; /* tau: left.piston.u.tau [N] */

    /* right.crank: n, tau */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* tau = S . [n; f] - force on the joint */
    const real right_torque = r[0]; /* N m */
    const wreal right_crank_base_moment_x = w[10];
    const wreal right_crank_base_second_moment_zz_plus_base_second_moment_xx = w[13];
    const real right_crank_n_y_part = right_crank_base_moment_x * right_crank_minus_a_z
        - right_crank_udot * right_crank_base_second_moment_zz_plus_base_second_moment_xx
        - right_crank_length * (right_rod_cos * right_rod_f_z
        - right_rod_minus_omega_y * right_rod_minus_omega_y * right_rod_first_moment_x *
        right_rod_sin);
    const real right_crank_n_y = right_crank_n_y_part - right_rod_tau;
    out[0] = -(right_torque + right_crank_n_y); /* tau: right.crank.u.tau [N*m] */

    /* left.crank: n, tau */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* tau = S . [n; f] - force on the joint */
    const real left_torque = r[2]; /* N m */
    const wreal left_crank_base_moment_x = w[9];
    const wreal left_crank_base_second_moment_zz_plus_base_second_moment_xx = w[15];
    const real left_crank_n_y_part = left_crank_base_moment_x * left_crank_minus_a_z
        - left_crank_udot * left_crank_base_second_moment_zz_plus_base_second_moment_xx
        - left_crank_length * (left_rod_cos * left_rod_f_z
        - left_rod_minus_omega_y * left_rod_minus_omega_y * left_rod_first_moment_x * left_rod_sin);
    const real left_crank_n_y = left_crank_n_y_part - left_rod_tau;
    out[3] = -(left_torque + left_crank_n_y); /* tau: left.crank.u.tau [N*m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {6, 0, 17, 0, 6, 6, 0, 0, 4, 18, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
