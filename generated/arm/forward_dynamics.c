/*
 * forward_dynamics of arm
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 0, w 21
 * Operations per call: 155 = 86 mul, 33 add, 30 sub, 2 cos, 2 div, 2 sin
 * Operations of prepare: 69 = 30 add, 27 mul, 9 sub, 1 cos, 1 div, 1 sin
 *
 * Input q (3): generalized coordinates
 *   q[0]  waist [rad]
 *   q[1]  shoulder [rad]
 *   q[2]  elbow [rad]
 *
 * Input u (3): generalized speeds
 *   u[0]  waist.u [rad/s]
 *   u[1]  shoulder.u [rad/s]
 *   u[2]  elbow.u [rad/s]
 *
 * Input p (29): parameters, read by prepare_ only
 *
 * Input tau (3): applied generalized forces
 *   tau[0]  waist.u.tau [N*m]
 *   tau[1]  shoulder.u.tau [N*m]
 *   tau[2]  elbow.u.tau [N*m]
 *
 * Output udot (3)
 *   out[0]  waist.udot [rad/s^2]
 *   out[1]  shoulder.udot [rad/s^2]
 *   out[2]  elbow.udot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* wrist: placement */
    const wreal wrist_rotation_yaw = p[21]; /* rad */
    const wreal angle[CARDAN_PADDED(1)] = {wrist_rotation_yaw};
    wreal sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const wreal wrist_rotation_yaw_cos = cosine[0];
    const wreal wrist_rotation_yaw_sin = sine[0];

    /* upper_arm: first moment, mass, origin inertia, base, inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_arm_mass = p[7]; /* kg */
    const wreal upper_arm_com_x = p[8]; /* m */
    const wreal upper_arm_inertia_xx = p[9]; /* kg m^2 */
    const wreal upper_arm_inertia_yy = p[10]; /* kg m^2 */
    const wreal upper_arm_inertia_zz = p[11]; /* kg m^2 */
    const wreal forearm_inertia_xz = p[17]; /* kg m^2 */
    const wreal upper_arm_first_moment_x = upper_arm_mass * upper_arm_com_x;
    const wreal upper_arm_com_x_times_first_moment_x = upper_arm_com_x * upper_arm_first_moment_x;
    const wreal upper_arm_origin_inertia_yy = upper_arm_inertia_yy
        + upper_arm_com_x_times_first_moment_x;
    const wreal upper_arm_origin_inertia_zz = upper_arm_inertia_zz
        + upper_arm_com_x_times_first_moment_x;
    const wreal upper_arm_base_half_trace = 0.5 * (upper_arm_inertia_xx
        + upper_arm_origin_inertia_zz + upper_arm_origin_inertia_yy);
    const wreal upper_arm_base_second_moment_zz = upper_arm_base_half_trace
        - upper_arm_origin_inertia_zz;
    const wreal twice_forearm_inertia_xz = forearm_inertia_xz + forearm_inertia_xz;
    w[16] = twice_forearm_inertia_xz;

    /* forearm: mass, first moment, whole mass, base */
    /* first_moment = sum m c */
    /* whole_mass = sum m */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal elbow_position_x = p[12]; /* m */
    const wreal forearm_mass = p[13]; /* kg */
    const wreal forearm_com_x = p[14]; /* m */
    const wreal forearm_com_y = p[15]; /* m */
    const wreal hand_mass = p[22]; /* kg */
    const wreal forearm_mass_times_com_x = forearm_mass * forearm_com_x;
    const wreal forearm_first_moment_y = forearm_mass * forearm_com_y;
    const wreal forearm_com_x_times_mass_times_com_x = forearm_com_x * forearm_mass_times_com_x;
    const wreal forearm_com_y_times_first_moment_y = forearm_com_y * forearm_first_moment_y;
    const wreal forearm_whole_mass = forearm_mass + hand_mass;
    const wreal elbow_position_x_times_forearm_base_mean_moment_x = 0.5 * forearm_whole_mass *
        elbow_position_x * elbow_position_x;
    const wreal forearm_base_shift = 2.0 * elbow_position_x_times_forearm_base_mean_moment_x;

    /* hand: mass */
    const wreal wrist_position_x = p[20]; /* m */
    const wreal hand_inertia_xx = p[23]; /* kg m^2 */
    const wreal hand_inertia_yy = p[24]; /* kg m^2 */
    const wreal wrist_position_x_times_hand_mass = wrist_position_x * hand_mass;
    const wreal hand_mass_half_turned_xx = wrist_rotation_yaw_cos * hand_inertia_xx;
    const wreal hand_minus_mass_half_turned_xy = wrist_rotation_yaw_sin * hand_inertia_yy;
    const wreal wrist_position_x_times_position_x_times_hand_mass = wrist_position_x *
        wrist_position_x_times_hand_mass;

    /* forearm: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal forearm_inertia_xx = p[16]; /* kg m^2 */
    const wreal forearm_inertia_yy = p[18]; /* kg m^2 */
    const wreal forearm_inertia_zz = p[19]; /* kg m^2 */
    const wreal hand_inertia_zz = p[25]; /* kg m^2 */
    const wreal forearm_first_moment_x = forearm_mass_times_com_x
        + wrist_position_x_times_hand_mass;
    const wreal forearm_origin_inertia_xx = forearm_inertia_xx
        + forearm_com_y_times_first_moment_y + (wrist_rotation_yaw_cos * hand_mass_half_turned_xx
        + wrist_rotation_yaw_sin * hand_minus_mass_half_turned_xy);
    const wreal forearm_origin_inertia_xy = wrist_rotation_yaw_sin * hand_mass_half_turned_xx
        - wrist_rotation_yaw_cos * hand_minus_mass_half_turned_xy
        - forearm_com_y * forearm_mass_times_com_x;
    const wreal forearm_origin_inertia_yy = wrist_rotation_yaw_sin * hand_inertia_xx *
        wrist_rotation_yaw_sin
        + wrist_rotation_yaw_cos * hand_inertia_yy * wrist_rotation_yaw_cos + (forearm_inertia_yy
        + forearm_com_x_times_mass_times_com_x + wrist_position_x_times_position_x_times_hand_mass);
    const wreal forearm_origin_inertia_zz = forearm_com_y_times_first_moment_y + hand_inertia_zz
        + (forearm_inertia_zz + forearm_com_x_times_mass_times_com_x
        + wrist_position_x_times_position_x_times_hand_mass);
    const wreal forearm_base_inertia_zz = forearm_origin_inertia_zz - forearm_origin_inertia_xx;
    const wreal upper_arm_base_inertia_zz_2 = upper_arm_inertia_xx + forearm_origin_inertia_xx;
    const wreal forearm_base_half_trace = 0.5 * (forearm_origin_inertia_xx
        + forearm_origin_inertia_zz + forearm_origin_inertia_yy);
    const wreal forearm_base_second_moment_xx = forearm_base_half_trace - forearm_origin_inertia_xx;
    const wreal forearm_base_second_moment_zz = forearm_base_half_trace - forearm_origin_inertia_zz;
    w[6] = forearm_first_moment_x;
    w[7] = forearm_origin_inertia_xy;
    w[8] = forearm_origin_inertia_yy;
    w[9] = forearm_base_inertia_zz;
    w[14] = forearm_base_second_moment_xx;
    w[15] = forearm_base_second_moment_zz;

    /* upper_arm: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_arm_base_second_moment_xy = elbow_position_x * forearm_first_moment_y;
    const wreal upper_arm_base_moment_x = upper_arm_first_moment_x
        + elbow_position_x * forearm_whole_mass;
    const wreal upper_arm_base_inertia_yy = upper_arm_origin_inertia_yy + forearm_base_shift;
    const wreal upper_arm_base_inertia_zz = upper_arm_origin_inertia_zz
        + forearm_origin_inertia_xx + (forearm_base_shift - upper_arm_base_inertia_zz_2);
    const wreal upper_arm_base_second_moment_xx = upper_arm_base_half_trace
        - upper_arm_inertia_xx + (elbow_position_x_times_forearm_base_mean_moment_x
        + elbow_position_x_times_forearm_base_mean_moment_x);
    const wreal forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy = forearm_origin_inertia_yy
        + upper_arm_base_inertia_yy;
    const wreal forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz = forearm_base_inertia_zz
        + upper_arm_base_inertia_zz;
    w[10] = upper_arm_base_second_moment_xy;
    w[11] = upper_arm_base_moment_x;
    w[12] = upper_arm_base_inertia_zz;
    w[17] = forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy;
    w[18] = forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz;

    /* column: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal column_inertia_zz = p[5]; /* kg m^2 */
    const wreal column_base_inertia_zz = column_inertia_zz + upper_arm_base_inertia_zz_2;
    w[13] = column_base_inertia_zz;

    /* common */
    const wreal upper_arm_base_second_moment_zz_minus_base_second_moment_xx =
        upper_arm_base_second_moment_zz - upper_arm_base_second_moment_xx;
    w[19] = upper_arm_base_second_moment_zz_minus_base_second_moment_xx;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_elbow = 1.0 / forearm_origin_inertia_yy;
    w[20] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[12]; /* elbow.position.x [m] */
    w[2] = p[17]; /* forearm.inertia.xz [kg m^2] */
    w[3] = p[26]; /* waist.damping [N*m*s/rad] */
    w[4] = p[27]; /* shoulder.damping [N*m*s/rad] */
    w[5] = p[28]; /* elbow.damping [N*m*s/rad] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real shoulder_q = q[1]; /* rad */
    const real elbow_q = q[2]; /* rad */
    const real elbow_turn = shoulder_q + elbow_q;
    const real angle[CARDAN_PADDED(2)] = {shoulder_q, elbow_turn};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real shoulder_cos = cosine[0];
    const real shoulder_sin = sine[0];
    const real elbow_turn_cos = cosine[1];
    const real elbow_turn_sin = sine[1];

    /* elbow: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal elbow_position_x = w[1]; /* m */
    const real elbow_p_x = elbow_position_x * shoulder_cos;
    const real elbow_minus_p_z = elbow_position_x * shoulder_sin;

    /* shared by several: inertia, U */
    /* U = [alpha] + [omega][omega] */
    const real waist_u = u[0]; /* rad/s */
    const wreal forearm_first_moment_x = w[6];
    const wreal forearm_origin_inertia_xy = w[7];
    const real momentum_minus_elbow_about_upper_arm_mz = forearm_origin_inertia_xy * elbow_turn_sin;
    const real elbow_minus_p_z_times_upper_arm_minus_inertia_mean_moment_z = forearm_first_moment_x
        * elbow_turn_sin * elbow_minus_p_z;
    const real upper_arm_inertia_shift_part = forearm_first_moment_x * elbow_turn_cos * elbow_p_x
        + elbow_minus_p_z_times_upper_arm_minus_inertia_mean_moment_z;
    const real column_minus_U_xx = waist_u * waist_u;

    /* upper_arm: inertia, composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const real shoulder_u = u[1]; /* rad/s */
    const wreal forearm_base_inertia_zz = w[9];
    const wreal upper_arm_base_second_moment_xy = w[10];
    const wreal upper_arm_base_inertia_zz = w[12];
    const wreal twice_forearm_inertia_xz = w[16];
    const wreal forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy = w[17];
    const wreal forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz = w[18];
    const real upper_arm_inertia_shift = 2.0 * upper_arm_inertia_shift_part;
    const real upper_arm_composite_inertia_yy = upper_arm_inertia_shift
        + forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy;
    const real upper_arm_composite_inertia_yz = upper_arm_base_second_moment_xy * shoulder_sin
        - momentum_minus_elbow_about_upper_arm_mz;
    const real upper_arm_composite_inertia_zz_part =
        forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz
        - upper_arm_base_inertia_zz * shoulder_sin * shoulder_sin
        - elbow_turn_sin * (forearm_base_inertia_zz * elbow_turn_sin
        + elbow_turn_cos * twice_forearm_inertia_xz);
    const real upper_arm_composite_inertia_zz = upper_arm_inertia_shift
        - 2.0 * elbow_minus_p_z_times_upper_arm_minus_inertia_mean_moment_z
        + upper_arm_composite_inertia_zz_part;
    const real upper_arm_minus_alpha_x = waist_u * shoulder_u;
    const real upper_arm_minus_U_zz = shoulder_u * shoulder_u;
    const real upper_arm_minus_U_xx = column_minus_U_xx + upper_arm_minus_U_zz;
    const real upper_arm_U_yz = upper_arm_minus_alpha_x + upper_arm_minus_alpha_x;

    /* column: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal column_base_inertia_zz = w[13];
    const real column_composite_inertia_zz = column_base_inertia_zz
        + upper_arm_composite_inertia_zz;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal forearm_origin_inertia_yy = w[8];
    const wreal M_factor_D_inverse_elbow = w[20];
    const real M_elbow_shoulder = forearm_origin_inertia_yy + upper_arm_inertia_shift_part;
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;
    const real M_factor_DL_shoulder_waist = upper_arm_composite_inertia_yz
        + momentum_minus_elbow_about_upper_arm_mz * M_factor_L_elbow_shoulder;
    const real M_minus_factor_L_elbow_waist = momentum_minus_elbow_about_upper_arm_mz *
        M_factor_D_inverse_elbow;
    const real M_factor_D_inverse_shoulder = 1.0 / (upper_arm_composite_inertia_yy
        - M_elbow_shoulder * M_factor_L_elbow_shoulder);
    const real M_factor_L_shoulder_waist = M_factor_DL_shoulder_waist * M_factor_D_inverse_shoulder;

    /* forearm: alpha, omega, a, U, n, inertia force */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real elbow_u = u[2]; /* rad/s */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal forearm_inertia_xz = w[2]; /* kg m^2 */
    const wreal forearm_base_second_moment_xx = w[14];
    const wreal forearm_base_second_moment_zz = w[15];
    const real forearm_minus_omega_x = waist_u * elbow_turn_sin;
    const real forearm_omega_z = waist_u * elbow_turn_cos;
    const real forearm_omega_y = shoulder_u + elbow_u;
    const real forearm_minus_alpha_x = elbow_u * forearm_omega_z
        + elbow_turn_cos * upper_arm_minus_alpha_x;
    const real forearm_a_z = elbow_turn_cos * (elbow_minus_p_z * upper_arm_minus_U_zz
        - gravity_z) - elbow_p_x * upper_arm_minus_U_xx * elbow_turn_sin;
    const real forearm_minus_omega_x_squared = forearm_minus_omega_x * forearm_minus_omega_x;
    const real forearm_omega_y_squared = forearm_omega_y * forearm_omega_y;
    const real forearm_omega_z_squared = forearm_omega_z * forearm_omega_z;
    const real forearm_minus_U_xz = forearm_minus_omega_x * forearm_omega_z;
    const real forearm_omega_z_times_omega_y = forearm_omega_z * forearm_omega_y;
    const real forearm_minus_U_xx = forearm_omega_y_squared + forearm_omega_z_squared;
    const real forearm_minus_U_yx = elbow_u * forearm_minus_omega_x
        + elbow_turn_sin * upper_arm_minus_alpha_x + forearm_minus_omega_x * forearm_omega_y;
    const real forearm_U_yz = forearm_minus_alpha_x + forearm_omega_z_times_omega_y;
    const real forearm_U_zy = forearm_omega_z_times_omega_y - forearm_minus_alpha_x;
    const real forearm_n_x = forearm_origin_inertia_xy * forearm_minus_U_xz
        - forearm_inertia_xz * forearm_minus_U_yx - forearm_base_second_moment_zz * forearm_U_yz;
    const real forearm_n_y = forearm_base_second_moment_xx * forearm_minus_U_xz
        - forearm_base_second_moment_zz * forearm_minus_U_xz
        + forearm_origin_inertia_xy * forearm_U_zy
        - (forearm_inertia_xz * (forearm_minus_omega_x_squared + forearm_omega_y_squared
        - forearm_minus_U_xx) + forearm_first_moment_x * forearm_a_z);
    const real forearm_minus_n_z = forearm_base_second_moment_xx * forearm_minus_U_yx
        + elbow_minus_p_z * upper_arm_U_yz * forearm_first_moment_x
        + (forearm_origin_inertia_xy * (forearm_minus_U_xx - (forearm_minus_omega_x_squared
        + forearm_omega_z_squared)) + forearm_inertia_xz * forearm_U_yz);
    const real forearm_minus_f_x = forearm_first_moment_x * forearm_minus_U_xx;
    const real forearm_minus_f_z = forearm_first_moment_x * forearm_minus_U_xz;

    /* common */
    const wreal upper_arm_base_second_moment_zz_minus_base_second_moment_xx = w[19];
    const real shoulder_cos_times_shear = shoulder_sin *
        upper_arm_base_second_moment_zz_minus_base_second_moment_xx * shoulder_cos;

    /* upper_arm: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_arm_base_moment_x = w[11];
    const real upper_arm_n_y_part = elbow_minus_p_z * (elbow_turn_cos * forearm_minus_f_x
        + elbow_turn_sin * forearm_minus_f_z) - elbow_p_x * (elbow_turn_sin * forearm_minus_f_x
        - elbow_turn_cos * forearm_minus_f_z);
    const real upper_arm_n_y = shoulder_cos_times_shear * (upper_arm_minus_U_zz
        - upper_arm_minus_U_xx) + upper_arm_base_moment_x * shoulder_cos * gravity_z
        + forearm_n_y + upper_arm_n_y_part;
    const real upper_arm_n_z = upper_arm_base_second_moment_xy * shoulder_cos *
        (upper_arm_minus_U_xx - column_minus_U_xx) + upper_arm_U_yz * shoulder_cos_times_shear
        - forearm_first_moment_x * forearm_minus_U_yx * elbow_p_x - elbow_turn_sin * forearm_n_x
        - elbow_turn_cos * forearm_minus_n_z;

    /* elbow: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real elbow_u_tau = tau[2]; /* N*m */
    const wreal elbow_damping = w[5]; /* N*m*s/rad */
    const real elbow_tau = elbow_u * elbow_damping + forearm_n_y;
    const real elbow_drive = elbow_u_tau - elbow_tau;

    /* shoulder: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real shoulder_u_tau = tau[1]; /* N*m */
    const wreal shoulder_damping = w[4]; /* N*m*s/rad */
    const real shoulder_tau = shoulder_u * shoulder_damping + upper_arm_n_y;
    const real shoulder_drive = shoulder_u_tau - shoulder_tau;

    /* waist: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real waist_u_tau = tau[0]; /* N*m */
    const wreal waist_damping = w[3]; /* N*m*s/rad */
    const real waist_tau = waist_u * waist_damping + upper_arm_n_z;
    const real waist_drive = waist_u_tau - waist_tau;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const real M_y_shoulder = shoulder_drive - elbow_drive * M_factor_L_elbow_shoulder;

    /* waist: udot */
    /* udot = M⁻¹ drive */
    const real waist_udot = 1.0 / (column_composite_inertia_zz
        - momentum_minus_elbow_about_upper_arm_mz * M_minus_factor_L_elbow_waist
        - M_factor_DL_shoulder_waist * M_factor_L_shoulder_waist) * (waist_drive
        + elbow_drive * M_minus_factor_L_elbow_waist - M_factor_L_shoulder_waist * M_y_shoulder);
    out[0] = waist_udot; /* udot: waist.udot [rad/s^2] */

    /* shoulder: udot */
    /* udot = M⁻¹ drive */
    const real shoulder_udot = M_factor_D_inverse_shoulder * M_y_shoulder
        - M_factor_L_shoulder_waist * waist_udot;
    out[1] = shoulder_udot; /* udot: shoulder.udot [rad/s^2] */

    /* elbow: udot */
    /* udot = M⁻¹ drive */
    /* udot: elbow.udot [rad/s^2] */
    out[2] = elbow_drive * M_factor_D_inverse_elbow + M_minus_factor_L_elbow_waist * waist_udot
        - M_factor_L_elbow_shoulder * shoulder_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 0, 21, 0, 3, 3, 0, 0, 0, 29, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0};
#endif
