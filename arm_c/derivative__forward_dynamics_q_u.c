/*
 * derivative__forward_dynamics_q_u of arm
 * derivative, q along the speeds, of forward_dynamics: q u
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 32, work 0, w 15
 * Operations per call: 236 = 145 mul, 40 add, 36 sub, 11 neg, 2 div, 1 cos, 1 sin
 * Operations of prepare: 31 = 14 add, 9 mul, 6 sub, 2 div
 *
 * Input q (5): generalized coordinates
 *   q[0]  shoulder.qw
 *   q[1]  shoulder.qx
 *   q[2]  shoulder.qy
 *   q[3]  shoulder.qz
 *   q[4]  elbow [rad]
 *
 * Input u (4): generalized speeds
 *   u[0]  shoulder.u.x [rad/s]
 *   u[1]  shoulder.u.y [rad/s]
 *   u[2]  shoulder.u.z [rad/s]
 *   u[3]  elbow.u [rad/s]
 *
 * Input p (8): parameters, read by prepare_ only
 *
 * Input tau (4): applied generalized forces
 *   tau[0]  shoulder.u.x.tau [N*m]
 *   tau[1]  shoulder.u.y.tau [N*m]
 *   tau[2]  shoulder.u.z.tau [N*m]
 *   tau[3]  elbow.u.tau [N*m]
 *
 * Output d_q (4 x 4): out[0 ... 15], row by row
 *
 * Output d_u (4 x 4): out[16 ... 31], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_derivative__forward_dynamics_q_u(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal m = p[0]; /* kg */
    const wreal upper_com_z = p[2]; /* m */
    const wreal upper_first_moment_z = m * upper_com_z;
    const wreal upper_origin_inertia_xx = 0.08333333333333333 * m
        + upper_com_z * upper_first_moment_z;
    const wreal upper_base_half_trace = 0.5 * (upper_origin_inertia_xx + upper_origin_inertia_xx);
    const wreal upper_base_second_moment_xx = upper_base_half_trace - upper_origin_inertia_xx;
    w[2] = upper_base_second_moment_xx;

    /* hand: base, origin inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal elbow_position_z = p[3]; /* m */
    const wreal hand_mass = p[4]; /* kg */
    const wreal hand_inertia_xx = p[5]; /* kg m^2 */
    const wreal hand_inertia_yy = p[6]; /* kg m^2 */
    const wreal hand_inertia_zz = p[7]; /* kg m^2 */
    const wreal hand_base_mass_moment_z = elbow_position_z * hand_mass;
    const wreal hand_base_half_trace = 0.5 * (hand_inertia_xx + hand_inertia_zz + hand_inertia_yy);
    const wreal hand_base_second_moment_xx = hand_base_half_trace - hand_inertia_xx;
    const wreal hand_base_second_moment_zz = hand_base_half_trace - hand_inertia_zz;
    const wreal hand_origin_inertia_yy = hand_base_second_moment_xx + hand_base_second_moment_zz;
    w[3] = hand_base_second_moment_xx;
    w[4] = hand_base_second_moment_zz;
    w[7] = hand_origin_inertia_yy;

    /* upper: base, origin inertia, inertia, composite */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal upper_base_moment_z = upper_first_moment_z + hand_base_mass_moment_z;
    const wreal upper_base_second_moment_yy = upper_base_second_moment_xx + hand_base_half_trace
        - hand_inertia_yy;
    const wreal upper_base_second_moment_zz = elbow_position_z * hand_base_mass_moment_z
        + upper_base_half_trace;
    const wreal upper_origin_inertia_xx_2 = upper_base_second_moment_yy
        + upper_base_second_moment_zz;
    const wreal upper_origin_inertia_yy = upper_base_second_moment_xx + upper_base_second_moment_zz;
    const wreal upper_origin_inertia_zz = upper_base_second_moment_xx + upper_base_second_moment_yy;
    const wreal hand_base_second_moment_xx_minus_base_second_moment_zz = hand_base_second_moment_xx
        - hand_base_second_moment_zz;
    const wreal hand_base_second_moment_zz_plus_upper_origin_inertia_xx = hand_base_second_moment_zz
        + upper_origin_inertia_xx_2;
    const wreal upper_composite_inertia_yy = upper_origin_inertia_yy + hand_origin_inertia_yy;
    const wreal hand_base_second_moment_xx_plus_upper_origin_inertia_zz = hand_base_second_moment_xx
        + upper_origin_inertia_zz;
    w[1] = upper_base_moment_z;
    w[5] = upper_base_second_moment_yy;
    w[6] = upper_base_second_moment_zz;
    w[8] = hand_base_second_moment_xx_minus_base_second_moment_zz;
    w[9] = hand_base_second_moment_zz_plus_upper_origin_inertia_xx;
    w[10] = upper_composite_inertia_yy;
    w[11] = hand_base_second_moment_xx_plus_upper_origin_inertia_zz;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_elbow = 1.0 / hand_origin_inertia_yy;
    const wreal M_factor_L_elbow_shoulder_y = hand_origin_inertia_yy * M_factor_D_inverse_elbow;
    const wreal M_factor_D_inverse_shoulder_y = 1.0 / (upper_composite_inertia_yy
        - hand_origin_inertia_yy * M_factor_L_elbow_shoulder_y);
    w[12] = M_factor_D_inverse_elbow;
    w[13] = M_factor_L_elbow_shoulder_y;
    w[14] = M_factor_D_inverse_shoulder_y;

    /* parameters as they are */
    w[0] = p[1]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

/* derivative, q along the speeds, of forward_dynamics: q u */
CARDAN_API int derivative__forward_dynamics_q_u(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* elbow: R */
    /* R = R_fixed R_joint(q) */
    const real elbow_q = q[4]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {elbow_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real elbow_cos = cosine[0];
    const real elbow_sin = sine[0];

    /* upper: inertia, composite, U, flow */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const real shoulder_u_x = u[0]; /* rad/s */
    const real shoulder_u_y = u[1]; /* rad/s */
    const real shoulder_u_z = u[2]; /* rad/s */
    const wreal hand_base_second_moment_xx_minus_base_second_moment_zz = w[8];
    const wreal hand_base_second_moment_zz_plus_upper_origin_inertia_xx = w[9];
    const wreal hand_base_second_moment_xx_plus_upper_origin_inertia_zz = w[11];
    const real upper_inertia_shear = elbow_sin *
        hand_base_second_moment_xx_minus_base_second_moment_zz;
    const real elbow_sin_times_upper_inertia_shear = elbow_sin * upper_inertia_shear;
    const real upper_composite_inertia_xz = elbow_cos * upper_inertia_shear;
    const real upper_composite_inertia_xx = elbow_sin_times_upper_inertia_shear
        + hand_base_second_moment_zz_plus_upper_origin_inertia_xx;
    const real upper_composite_inertia_zz = hand_base_second_moment_xx_plus_upper_origin_inertia_zz
        - elbow_sin_times_upper_inertia_shear;
    const real upper_U_xy = shoulder_u_x * shoulder_u_y;
    const real upper_U_yz = shoulder_u_y * shoulder_u_z;
    const real twice_shoulder_u_x = 2.0 * shoulder_u_x;
    const real twice_shoulder_u_z = 2.0 * shoulder_u_z;

    /* shoulder: R, effect */
    /* R = R_fixed R_joint(q) */
    const real shoulder_qw = q[0];
    const real shoulder_qx = q[1];
    const real shoulder_qy = q[2];
    const real shoulder_qz = q[3];
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal upper_base_moment_z = w[1];
    const wreal upper_base_second_moment_yy = w[5];
    const real twice_shoulder_qx = 2.0 * shoulder_qx;
    const real twice_shoulder_qy = 2.0 * shoulder_qy;
    const real twice_shoulder_qz = 2.0 * shoulder_qz;
    const real shoulder_R_zx = shoulder_qx * twice_shoulder_qz - shoulder_qw * twice_shoulder_qy;
    const real shoulder_R_zy = shoulder_qw * twice_shoulder_qx + shoulder_qy * twice_shoulder_qz;
    const real shoulder_R_zz = 1.0 - shoulder_qx * twice_shoulder_qx
        - shoulder_qy * twice_shoulder_qy;
    const real x1_minus_y_1 = gravity_z * shoulder_R_zz * upper_base_moment_z;
    const real x6_minus_y_3 = shoulder_u_x * upper_composite_inertia_zz
        - (upper_base_second_moment_yy * twice_shoulder_u_x
        + shoulder_u_z * upper_composite_inertia_xz);

    /* hand: omega, alpha, U, inertia force, n, flow */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real elbow_u = u[3]; /* rad/s */
    const wreal hand_base_second_moment_xx = w[3];
    const wreal hand_base_second_moment_zz = w[4];
    const real hand_omega_x = shoulder_u_x * elbow_cos - shoulder_u_z * elbow_sin;
    const real hand_omega_z = shoulder_u_x * elbow_sin + shoulder_u_z * elbow_cos;
    const real hand_omega_y = shoulder_u_y + elbow_u;
    const real hand_alpha_z = elbow_u * hand_omega_x;
    const real hand_U_yx = hand_alpha_z + hand_omega_x * hand_omega_y;
    const real hand_U_yz = elbow_u * hand_omega_z + hand_omega_z * hand_omega_y;
    const real hand_minus_n_x = hand_base_second_moment_zz * hand_U_yz;
    const real hand_n_z = hand_base_second_moment_xx * hand_U_yx;
    const real twice_hand_omega_y = 2.0 * hand_omega_y;
    const real hand_base_second_moment_zz_times_twice_hand_omega_y = hand_base_second_moment_zz *
        twice_hand_omega_y;
    const real hand_base_second_moment_xx_times_twice_hand_omega_y = hand_base_second_moment_xx *
        twice_hand_omega_y;

    /* shared by several: effect, flow, dq */
    const real x3_y_2 = gravity_z * shoulder_R_zy * upper_base_moment_z;
    const real twice_shoulder_u_y = 2.0 * shoulder_u_y;
    const real twice_hand_omega_x = 2.0 * hand_omega_x;
    const real twice_hand_omega_z = 2.0 * hand_omega_z;

    /* upper: n, flow */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_base_second_moment_xx = w[2];
    const wreal upper_base_second_moment_zz = w[6];
    const real upper_n_x = upper_base_second_moment_yy * upper_U_yz
        - upper_base_second_moment_zz * upper_U_yz + x3_y_2 + elbow_sin * hand_n_z
        - elbow_cos * hand_minus_n_x;
    const real upper_n_z = upper_base_second_moment_xx * upper_U_xy
        - upper_base_second_moment_yy * upper_U_xy + elbow_sin * hand_minus_n_x
        + elbow_cos * hand_n_z;
    const real x7_minus_y_3_part = elbow_cos * (hand_base_second_moment_zz_times_twice_hand_omega_y
        - hand_base_second_moment_xx_times_twice_hand_omega_y);
    const real x5_y_3_part = elbow_cos * x7_minus_y_3_part;

    /* shoulder: drive, effect */
    /* drive = tau + f - h */
    const real shoulder_u_x_tau = tau[0]; /* N*m */
    const real shoulder_u_z_tau = tau[2]; /* N*m */
    const real shoulder_drive_x = shoulder_u_x_tau - upper_n_x;
    const real shoulder_drive_z = shoulder_u_z_tau - upper_n_z;
    const real x7_minus_y_3 = elbow_sin * x7_minus_y_3_part
        + shoulder_u_y * upper_composite_inertia_xz;
    const real x5_y_3 = x5_y_3_part - (upper_base_second_moment_xx * twice_shoulder_u_y
        + hand_base_second_moment_zz_times_twice_hand_omega_y)
        + shoulder_u_y * upper_composite_inertia_zz;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_L_elbow_shoulder_y = w[13];
    const wreal M_factor_D_inverse_shoulder_y = w[14];
    const real M_factor_D_inverse_shoulder_z = 1.0 / upper_composite_inertia_zz;
    const real M_factor_L_shoulder_z_shoulder_x = upper_composite_inertia_xz *
        M_factor_D_inverse_shoulder_z;
    const real M_factor_D_inverse_shoulder_x = 1.0 / (upper_composite_inertia_xx
        - upper_composite_inertia_xz * M_factor_L_shoulder_z_shoulder_x);
    const real M_factor_D_inverse_shoulder_x_times_x1_minus_y_1 = M_factor_D_inverse_shoulder_x *
        x1_minus_y_1;
    const real M_factor_D_inverse_shoulder_y_times_x1_minus_y_1 = M_factor_D_inverse_shoulder_y *
        x1_minus_y_1;
    const real x3_y_1_times_M_factor_D_inverse_shoulder_x = gravity_z * shoulder_R_zx *
        upper_base_moment_z * M_factor_D_inverse_shoulder_x;
    const real x3_y_2_times_M_factor_D_inverse_shoulder_y = x3_y_2 * M_factor_D_inverse_shoulder_y;
    const real M_factor_D_inverse_shoulder_x_times_x5_y_1 = M_factor_D_inverse_shoulder_x *
        (x7_minus_y_3 - M_factor_L_shoulder_z_shoulder_x * x5_y_3);
    const real M_factor_D_inverse_shoulder_x_times_x6_y_1 = M_factor_D_inverse_shoulder_x *
        (shoulder_u_z * upper_composite_inertia_xx
        - (upper_base_second_moment_yy * twice_shoulder_u_z
        + shoulder_u_x * upper_composite_inertia_xz)
        + M_factor_L_shoulder_z_shoulder_x * x6_minus_y_3);
    const real M_factor_D_inverse_shoulder_x_times_x7_y_1 = M_factor_D_inverse_shoulder_x *
        (upper_base_second_moment_zz * twice_shoulder_u_y
        + hand_base_second_moment_xx_times_twice_hand_omega_y + x5_y_3_part
        - shoulder_u_y * upper_composite_inertia_xx
        + M_factor_L_shoulder_z_shoulder_x * x7_minus_y_3);
    /* d_q: shoulder.u.xdot,shoulder.u.x */
    out[0] = -M_factor_D_inverse_shoulder_x_times_x1_minus_y_1;
    /* d_q: shoulder.u.zdot,shoulder.u.x */
    out[8] = M_factor_L_shoulder_z_shoulder_x * M_factor_D_inverse_shoulder_x_times_x1_minus_y_1;
    /* d_q: shoulder.u.ydot,shoulder.u.y */
    out[5] = -M_factor_D_inverse_shoulder_y_times_x1_minus_y_1;
    /* d_q: elbow.udot,shoulder.u.y */
    out[13] = M_factor_L_elbow_shoulder_y * M_factor_D_inverse_shoulder_y_times_x1_minus_y_1;
    out[2] = x3_y_1_times_M_factor_D_inverse_shoulder_x; /* d_q: shoulder.u.xdot,shoulder.u.z */
    out[6] = x3_y_2_times_M_factor_D_inverse_shoulder_y; /* d_q: shoulder.u.ydot,shoulder.u.z */
    /* d_q: shoulder.u.zdot,shoulder.u.z */
    out[10] = -M_factor_L_shoulder_z_shoulder_x * x3_y_1_times_M_factor_D_inverse_shoulder_x;
    /* d_q: elbow.udot,shoulder.u.z */
    out[14] = -M_factor_L_elbow_shoulder_y * x3_y_2_times_M_factor_D_inverse_shoulder_y;
    out[16] = M_factor_D_inverse_shoulder_x_times_x5_y_1; /* d_u: shoulder.u.xdot,shoulder.u.x */
    /* d_u: shoulder.u.zdot,shoulder.u.x */
    out[24] = M_factor_D_inverse_shoulder_z * x5_y_3
        - M_factor_L_shoulder_z_shoulder_x * M_factor_D_inverse_shoulder_x_times_x5_y_1;
    out[17] = M_factor_D_inverse_shoulder_x_times_x6_y_1; /* d_u: shoulder.u.xdot,shoulder.u.y */
    /* d_u: shoulder.u.zdot,shoulder.u.y */
    out[25] = -(M_factor_D_inverse_shoulder_z * x6_minus_y_3
        + M_factor_L_shoulder_z_shoulder_x * M_factor_D_inverse_shoulder_x_times_x6_y_1);
    out[18] = M_factor_D_inverse_shoulder_x_times_x7_y_1; /* d_u: shoulder.u.xdot,shoulder.u.z */
    /* d_u: shoulder.u.zdot,shoulder.u.z */
    out[26] = -(M_factor_D_inverse_shoulder_z * x7_minus_y_3
        + M_factor_L_shoulder_z_shoulder_x * M_factor_D_inverse_shoulder_x_times_x7_y_1);

    /* shoulder: udot */
    /* udot = M⁻¹ drive */
    const real shoulder_udot_x = M_factor_D_inverse_shoulder_x * (shoulder_drive_x
        - shoulder_drive_z * M_factor_L_shoulder_z_shoulder_x);
    const real shoulder_udot_z = shoulder_drive_z * M_factor_D_inverse_shoulder_z
        - M_factor_L_shoulder_z_shoulder_x * shoulder_udot_x;

    /* hand: flow, alpha */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    const real hand_base_second_moment_xx_times_twice_hand_omega_z = hand_base_second_moment_xx *
        twice_hand_omega_z;
    const real hand_base_second_moment_zz_times_twice_hand_omega_x = hand_base_second_moment_zz *
        twice_hand_omega_x;
    const real x4_y_1_part = elbow_cos * shoulder_udot_x - elbow_sin * shoulder_udot_z;
    const real x4_y_1_part_2 = elbow_sin * shoulder_udot_x + elbow_cos * shoulder_udot_z;

    /* shared by several: flow */
    const real x7_minus_y_4_part = elbow_cos * hand_base_second_moment_zz_times_twice_hand_omega_x +
        elbow_sin * hand_base_second_moment_xx_times_twice_hand_omega_z;
    const real x5_minus_y_4_part = elbow_cos * hand_base_second_moment_xx_times_twice_hand_omega_z -
        elbow_sin * hand_base_second_moment_zz_times_twice_hand_omega_x;

    /* elbow: answer, effect */
    const wreal hand_origin_inertia_yy = w[7];
    const real x5_minus_y_4 = shoulder_u_z * hand_origin_inertia_yy - x5_minus_y_4_part;
    const real x7_minus_y_4 = x7_minus_y_4_part - shoulder_u_x * hand_origin_inertia_yy;
    const real x4_minus_y_4 = hand_omega_z * hand_base_second_moment_xx_times_twice_hand_omega_z
        + hand_omega_x * hand_base_second_moment_zz_times_twice_hand_omega_x
        - hand_origin_inertia_yy * (hand_omega_x * hand_omega_x + hand_omega_z * hand_omega_z);
    const real hand_base_second_moment_zz_times_twice_hand_omega_z = hand_base_second_moment_zz *
        twice_hand_omega_z;
    const real hand_base_second_moment_xx_times_twice_hand_omega_x = hand_base_second_moment_xx *
        twice_hand_omega_x;
    const real x4_y_1_part_3 = hand_base_second_moment_xx * (hand_U_yx + x4_y_1_part_2)
        - hand_omega_x * hand_base_second_moment_zz_times_twice_hand_omega_y
        + hand_base_second_moment_zz * (shoulder_u_y * hand_omega_x - x4_y_1_part_2);
    const real x4_y_1_part_4 = hand_base_second_moment_zz * (hand_U_yz - x4_y_1_part)
        - hand_omega_z * hand_base_second_moment_xx_times_twice_hand_omega_y
        + hand_base_second_moment_xx * (shoulder_u_y * hand_omega_z + x4_y_1_part);

    /* hand: momentum */
    /* momentum = composite inertia S */
    const real x8_minus_y_3 = elbow_sin * hand_base_second_moment_zz_times_twice_hand_omega_z
        + elbow_cos * hand_base_second_moment_xx_times_twice_hand_omega_x;
    const real x4_minus_y_3 = elbow_cos * x4_y_1_part_4 - elbow_sin * x4_y_1_part_3;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal upper_composite_inertia_yy = w[10];
    const wreal M_factor_D_inverse_elbow = w[12];
    const real M_factor_D_inverse_shoulder_x_times_x4_y_1 = M_factor_D_inverse_shoulder_x *
        (M_factor_L_shoulder_z_shoulder_x * x4_minus_y_3 - (elbow_cos * x4_y_1_part_3
        + elbow_sin * x4_y_1_part_4));
    const real M_factor_D_inverse_shoulder_y_times_x4_y_2 = M_factor_D_inverse_shoulder_y *
        (M_factor_L_elbow_shoulder_y * x4_minus_y_4 - x4_minus_y_4);
    const real M_factor_D_inverse_shoulder_y_times_x5_y_2 = M_factor_D_inverse_shoulder_y *
        (upper_base_second_moment_xx * twice_shoulder_u_z
        - shoulder_u_z * upper_composite_inertia_yy + x5_minus_y_4_part
        + M_factor_L_elbow_shoulder_y * x5_minus_y_4);
    const real M_factor_D_inverse_shoulder_y_times_x7_y_2 = M_factor_D_inverse_shoulder_y *
        (shoulder_u_x * upper_composite_inertia_yy
        - upper_base_second_moment_zz * twice_shoulder_u_x - x7_minus_y_4_part
        + M_factor_L_elbow_shoulder_y * x7_minus_y_4);
    const real M_factor_D_inverse_shoulder_x_times_x8_y_1 = M_factor_D_inverse_shoulder_x *
        (elbow_cos * hand_base_second_moment_zz_times_twice_hand_omega_z
        - elbow_sin * hand_base_second_moment_xx_times_twice_hand_omega_x
        + M_factor_L_shoulder_z_shoulder_x * x8_minus_y_3);
    out[3] = M_factor_D_inverse_shoulder_x_times_x4_y_1; /* d_q: shoulder.u.xdot,elbow.u */
    out[7] = M_factor_D_inverse_shoulder_y_times_x4_y_2; /* d_q: shoulder.u.ydot,elbow.u */
    /* d_q: shoulder.u.zdot,elbow.u */
    out[11] = -(M_factor_D_inverse_shoulder_z * x4_minus_y_3
        + M_factor_L_shoulder_z_shoulder_x * M_factor_D_inverse_shoulder_x_times_x4_y_1);
    /* d_q: elbow.udot,elbow.u */
    out[15] = -(M_factor_D_inverse_elbow * x4_minus_y_4
        + M_factor_L_elbow_shoulder_y * M_factor_D_inverse_shoulder_y_times_x4_y_2);
    out[20] = M_factor_D_inverse_shoulder_y_times_x5_y_2; /* d_u: shoulder.u.ydot,shoulder.u.x */
    /* d_u: elbow.udot,shoulder.u.x */
    out[28] = -(M_factor_D_inverse_elbow * x5_minus_y_4
        + M_factor_L_elbow_shoulder_y * M_factor_D_inverse_shoulder_y_times_x5_y_2);
    out[22] = M_factor_D_inverse_shoulder_y_times_x7_y_2; /* d_u: shoulder.u.ydot,shoulder.u.z */
    /* d_u: elbow.udot,shoulder.u.z */
    out[30] = -(M_factor_D_inverse_elbow * x7_minus_y_4
        + M_factor_L_elbow_shoulder_y * M_factor_D_inverse_shoulder_y_times_x7_y_2);
    out[19] = M_factor_D_inverse_shoulder_x_times_x8_y_1; /* d_u: shoulder.u.xdot,elbow.u */
    /* d_u: shoulder.u.zdot,elbow.u */
    out[27] = -(M_factor_D_inverse_shoulder_z * x8_minus_y_3
        + M_factor_L_shoulder_z_shoulder_x * M_factor_D_inverse_shoulder_x_times_x8_y_1);

    /* results that are numbers or inputs */
    out[1] = CARDAN_REAL(0.0); /* d_q: shoulder.u.xdot,shoulder.u.y */
    out[4] = CARDAN_REAL(0.0); /* d_q: shoulder.u.ydot,shoulder.u.x */
    out[9] = CARDAN_REAL(0.0); /* d_q: shoulder.u.zdot,shoulder.u.y */
    out[12] = CARDAN_REAL(0.0); /* d_q: elbow.udot,shoulder.u.x */
    out[21] = CARDAN_REAL(0.0); /* d_u: shoulder.u.ydot,shoulder.u.y */
    out[23] = CARDAN_REAL(0.0); /* d_u: shoulder.u.ydot,elbow.u */
    out[29] = CARDAN_REAL(0.0); /* d_u: elbow.udot,shoulder.u.y */
    out[31] = CARDAN_REAL(0.0); /* d_u: elbow.udot,elbow.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int derivative__forward_dynamics_q_u_sizes[] = {32, 0, 15, 0, 5, 4, 0, 0, 0, 8, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0};
#endif
