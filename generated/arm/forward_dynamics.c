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
    const wreal wrist_placement = cosine[0];
    const wreal wrist_placement_2 = sine[0];

    /* upper_arm: first moment, mass, inertia */
    const wreal upper_arm_mass = p[7]; /* kg */
    const wreal upper_arm_com_x = p[8]; /* m */
    const wreal upper_arm_inertia_yy = p[10]; /* kg m^2 */
    const wreal upper_arm_inertia_zz = p[11]; /* kg m^2 */
    const wreal forearm_inertia_xz = p[17]; /* kg m^2 */
    const wreal upper_arm_first_moment_x = upper_arm_mass * upper_arm_com_x;
    const wreal upper_arm_mass_2 = upper_arm_com_x * upper_arm_first_moment_x;
    const wreal upper_arm_inertia_yy_2 = upper_arm_inertia_yy + upper_arm_mass_2;
    const wreal upper_arm_inertia_zz_2 = upper_arm_inertia_zz + upper_arm_mass_2;
    w[16] = forearm_inertia_xz + forearm_inertia_xz; /* upper_arm_inertia */

    /* forearm: mass, first moment, base */
    const wreal elbow_position_x = p[12]; /* m */
    const wreal forearm_mass = p[13]; /* kg */
    const wreal forearm_com_x = p[14]; /* m */
    const wreal forearm_com_y = p[15]; /* m */
    const wreal hand_mass = p[22]; /* kg */
    const wreal hand_inertia_xx = p[23]; /* kg m^2 */
    const wreal hand_inertia_yy = p[24]; /* kg m^2 */
    const wreal forearm_mass_2 = forearm_mass * forearm_com_x;
    const wreal forearm_first_moment_y = forearm_mass * forearm_com_y;
    const wreal forearm_mass_3 = forearm_com_x * forearm_mass_2;
    const wreal forearm_mass_4 = forearm_com_y * forearm_first_moment_y;
    const wreal forearm_mass_5 = forearm_mass + hand_mass;
    const wreal forearm_mass_6 = wrist_placement_2 * hand_inertia_xx * wrist_placement_2
        + wrist_placement * hand_inertia_yy * wrist_placement;
    const wreal forearm_base = 0.5 * forearm_mass_5 * elbow_position_x * elbow_position_x;
    const wreal forearm_base_2 = 2.0 * forearm_base;

    /* hand: mass */
    const wreal wrist_position_x = p[20]; /* m */
    const wreal hand_mass_2 = wrist_position_x * hand_mass;
    const wreal hand_mass_3 = wrist_placement * hand_inertia_xx;
    const wreal hand_mass_4 = wrist_placement_2 * hand_inertia_yy;
    const wreal hand_mass_5 = wrist_position_x * hand_mass_2;

    /* forearm: first moment, inertia, base inertia, base */
    const wreal upper_arm_inertia_xx = p[9]; /* kg m^2 */
    const wreal forearm_inertia_xx = p[16]; /* kg m^2 */
    const wreal forearm_inertia_yy = p[18]; /* kg m^2 */
    const wreal forearm_inertia_zz = p[19]; /* kg m^2 */
    const wreal hand_inertia_zz = p[25]; /* kg m^2 */
    const wreal forearm_inertia_xx_2 = forearm_inertia_xx + forearm_mass_4
        + (wrist_placement * hand_mass_3 + wrist_placement_2 * hand_mass_4);
    const wreal forearm_inertia_yy_2 = forearm_inertia_yy + forearm_mass_3 + hand_mass_5
        + forearm_mass_6;
    const wreal forearm_inertia_zz_2 = forearm_mass_4 + hand_inertia_zz + (forearm_inertia_zz
        + forearm_mass_3 + hand_mass_5);
    const wreal forearm_base_inertia_zz = forearm_inertia_zz_2 - forearm_inertia_xx_2;
    const wreal forearm_base_3 = upper_arm_inertia_xx + forearm_inertia_xx_2;
    w[6] = forearm_mass_2 + hand_mass_2; /* forearm_first_moment_x */
    /* forearm_inertia_xy */
    w[7] = wrist_placement_2 * hand_mass_3 - wrist_placement * hand_mass_4
        - forearm_com_y * forearm_mass_2;
    w[8] = forearm_inertia_yy_2; /* forearm_inertia_yy_2 */
    w[9] = forearm_base_inertia_zz; /* forearm_base_inertia_zz */

    /* upper_arm: base second moment, base moment, base inertia, inertia */
    const wreal upper_arm_base_inertia_yy = upper_arm_inertia_yy_2 + forearm_base_2;
    const wreal upper_arm_base_inertia_zz = upper_arm_inertia_zz_2 + forearm_inertia_xx_2
        + (forearm_base_2 - forearm_base_3);
    w[10] = elbow_position_x * forearm_first_moment_y; /* upper_arm_base_second_moment_xy */
    /* upper_arm_base_moment_x */
    w[11] = upper_arm_first_moment_x + elbow_position_x * forearm_mass_5;
    w[12] = upper_arm_base_inertia_zz; /* upper_arm_base_inertia_zz */
    w[17] = forearm_inertia_yy_2 + upper_arm_base_inertia_yy; /* upper_arm_inertia_2 */
    w[18] = forearm_base_inertia_zz + upper_arm_base_inertia_zz; /* upper_arm_inertia_3 */

    /* column: base inertia */
    const wreal column_inertia_zz = p[5]; /* kg m^2 */
    w[13] = column_inertia_zz + forearm_base_3; /* column_base_inertia_zz */

    /* common */
    const wreal mul_1 = 0.5 * (upper_arm_inertia_xx + upper_arm_inertia_zz_2
        + upper_arm_inertia_yy_2);
    const wreal mul_1_2 = 0.5 * (forearm_inertia_xx_2 + forearm_inertia_zz_2
        + forearm_inertia_yy_2);

    /* upper_arm: base second moment */
    const wreal upper_arm_base_second_moment_zz = mul_1 - upper_arm_inertia_zz_2;
    const wreal upper_arm_base_second_moment_xx = mul_1 - upper_arm_inertia_xx + (forearm_base
        + forearm_base);

    /* forearm: base second moment */
    w[14] = mul_1_2 - forearm_inertia_xx_2; /* forearm_base_second_moment_xx */
    w[15] = mul_1_2 - forearm_inertia_zz_2; /* forearm_base_second_moment_zz */

    /* common */
    w[19] = upper_arm_base_second_moment_zz - upper_arm_base_second_moment_xx; /* sub_1 */

    /* M: D inverse */
    w[20] = 1.0 / forearm_inertia_yy_2; /* M_D_inverse_3 */

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

    /* shared by several: R, cos, sin */
    const real shoulder_q = q[1]; /* rad */
    const real elbow_q = q[2]; /* rad */
    const real elbow_R = shoulder_q + elbow_q;
    const real angle_2[CARDAN_PADDED(2)] = {shoulder_q, elbow_R};
    real sine_2[CARDAN_PADDED(2)], cosine_2[CARDAN_PADDED(2)];
    cardan_sincos(2, angle_2, sine_2, cosine_2);
    const real shoulder_cos = cosine_2[0];
    const real shoulder_sin = sine_2[0];
    const real elbow_cos = cosine_2[1];
    const real elbow_sin = sine_2[1];

    /* elbow: p */
    const wreal elbow_position_x = w[1]; /* m */
    const real elbow_p_x = elbow_position_x * shoulder_cos;
    const real elbow_p = elbow_position_x * shoulder_sin;

    /* upper_arm: inertia, U */
    const real waist_u = u[0]; /* rad/s */
    const real shoulder_u = u[1]; /* rad/s */
    const wreal forearm_base_inertia_zz = w[9];
    const wreal upper_arm_base_inertia_zz = w[12];
    const wreal upper_arm_inertia = w[16];
    const wreal upper_arm_inertia_3 = w[18];
    const real upper_arm_inertia_4 = elbow_sin * (forearm_base_inertia_zz * elbow_sin
        + elbow_cos * upper_arm_inertia);
    const real upper_arm_inertia_5 = upper_arm_inertia_3
        - upper_arm_base_inertia_zz * shoulder_sin * shoulder_sin - upper_arm_inertia_4;
    const real upper_arm_U = waist_u * shoulder_u;
    const real upper_arm_U_2 = shoulder_u * shoulder_u;
    const real upper_arm_U_yz = upper_arm_U + upper_arm_U;

    /* shared by several: inertia, U */
    const wreal forearm_first_moment_x = w[6];
    const wreal forearm_inertia_xy = w[7];
    const real upper_arm_inertia_6 = forearm_inertia_xy * elbow_sin;
    const real upper_arm_inertia_7 = forearm_first_moment_x * elbow_sin * elbow_p;
    const real upper_arm_inertia_8 = forearm_first_moment_x * elbow_cos * elbow_p_x
        + upper_arm_inertia_7;
    const real column_U = waist_u * waist_u;

    /* upper_arm: inertia, composite inertia, U */
    const wreal upper_arm_base_second_moment_xy = w[10];
    const wreal upper_arm_inertia_2 = w[17];
    const real upper_arm_inertia_9 = 2.0 * upper_arm_inertia_8;
    const real upper_arm_composite_inertia_yy = upper_arm_inertia_9 + upper_arm_inertia_2;
    const real upper_arm_composite_inertia_yz = upper_arm_base_second_moment_xy * shoulder_sin
        - upper_arm_inertia_6;
    const real upper_arm_composite_inertia_zz = upper_arm_inertia_9 - 2.0 * upper_arm_inertia_7
        + upper_arm_inertia_5;
    const real upper_arm_U_3 = column_U + upper_arm_U_2;

    /* column: composite inertia */
    const wreal column_base_inertia_zz = w[13];
    const real column_composite_inertia_zz = column_base_inertia_zz
        + upper_arm_composite_inertia_zz;

    /* M: L, factor, D inverse */
    const wreal forearm_inertia_yy_2 = w[8];
    const wreal M_D_inverse_3 = w[20];
    const real M_3_2 = forearm_inertia_yy_2 + upper_arm_inertia_8;
    const real M_L_3_2 = M_3_2 * M_D_inverse_3;
    const real M_factor = upper_arm_composite_inertia_yz + upper_arm_inertia_6 * M_L_3_2;
    const real M_factor_2 = upper_arm_inertia_6 * M_D_inverse_3;
    const real M_D_inverse_2 = 1.0 / (upper_arm_composite_inertia_yy - M_3_2 * M_L_3_2);
    const real M_L_2_1 = M_factor * M_D_inverse_2;
    const real M_D_inverse_1 = 1.0 / (column_composite_inertia_zz
        - upper_arm_inertia_6 * M_factor_2 - M_factor * M_L_2_1);

    /* forearm: alpha, omega, a, U, n, inertia force, f */
    const real elbow_u = u[2]; /* rad/s */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal forearm_inertia_xz = w[2]; /* kg m^2 */
    const wreal forearm_base_second_moment_xx = w[14];
    const wreal forearm_base_second_moment_zz = w[15];
    const real forearm_alpha = waist_u * elbow_sin;
    const real forearm_omega_z = waist_u * elbow_cos;
    const real forearm_omega_y = shoulder_u + elbow_u;
    const real forearm_alpha_2 = elbow_u * forearm_omega_z + elbow_cos * upper_arm_U;
    const real forearm_a_z = elbow_cos * (elbow_p * upper_arm_U_2 - gravity_z)
        - elbow_p_x * upper_arm_U_3 * elbow_sin;
    const real forearm_U = forearm_alpha * forearm_alpha;
    const real forearm_U_2 = forearm_omega_y * forearm_omega_y;
    const real forearm_U_3 = forearm_omega_z * forearm_omega_z;
    const real forearm_U_4 = forearm_alpha * forearm_omega_z;
    const real forearm_U_5 = forearm_omega_z * forearm_omega_y;
    const real forearm_U_6 = forearm_U_2 + forearm_U_3;
    const real forearm_U_7 = elbow_u * forearm_alpha + elbow_sin * upper_arm_U
        + forearm_alpha * forearm_omega_y;
    const real forearm_U_yz = forearm_alpha_2 + forearm_U_5;
    const real forearm_U_zy = forearm_U_5 - forearm_alpha_2;
    const real forearm_n_x = forearm_inertia_xy * forearm_U_4 - forearm_inertia_xz * forearm_U_7
        - forearm_base_second_moment_zz * forearm_U_yz;
    const real forearm_inertia_force = forearm_base_second_moment_xx * forearm_U_4
        - forearm_base_second_moment_zz * forearm_U_4;
    const real forearm_inertia_force_2 = forearm_inertia_xz * (forearm_U + forearm_U_2
        - forearm_U_6) + forearm_first_moment_x * forearm_a_z;
    const real forearm_n_y = forearm_inertia_xy * forearm_U_zy + forearm_inertia_force
        - forearm_inertia_force_2;
    const real forearm_inertia_force_3 = forearm_base_second_moment_xx * forearm_U_7
        + elbow_p * upper_arm_U_yz * forearm_first_moment_x;
    const real forearm_inertia_force_4 = forearm_inertia_xy * (forearm_U_6 - (forearm_U
        + forearm_U_3)) + forearm_inertia_xz * forearm_U_yz;
    const real forearm_inertia_force_5 = forearm_first_moment_x * forearm_U_6;
    const real forearm_inertia_force_6 = forearm_first_moment_x * forearm_U_4;
    const real forearm_f = elbow_p_x * (elbow_sin * forearm_inertia_force_5
        - elbow_cos * forearm_inertia_force_6);

    /* common */
    const wreal sub_1 = w[19];
    const real mul_1_3 = shoulder_sin * sub_1 * shoulder_cos;

    /* upper_arm: n */
    const wreal upper_arm_base_moment_x = w[11];
    const real upper_arm_n = mul_1_3 * (upper_arm_U_2 - upper_arm_U_3)
        + upper_arm_base_moment_x * shoulder_cos * gravity_z + forearm_n_y;
    const real upper_arm_n_y = elbow_p * (elbow_cos * forearm_inertia_force_5
        + elbow_sin * forearm_inertia_force_6) - forearm_f + upper_arm_n;
    const real upper_arm_n_2 = upper_arm_base_second_moment_xy * shoulder_cos * (upper_arm_U_3
        - column_U) + upper_arm_U_yz * mul_1_3;
    const real upper_arm_n_3 = upper_arm_n_2 - forearm_first_moment_x * forearm_U_7 * elbow_p_x
        - elbow_sin * forearm_n_x;
    const real upper_arm_n_z = upper_arm_n_3 - elbow_cos * (forearm_inertia_force_3
        + forearm_inertia_force_4);

    /* elbow: tau, drive */
    const real elbow_u_tau = tau[2]; /* N*m */
    const wreal elbow_damping = w[5]; /* N*m*s/rad */
    const real elbow_tau = elbow_u * elbow_damping + forearm_n_y;
    const real elbow_drive = elbow_u_tau - elbow_tau;

    /* shoulder: tau, drive */
    const real shoulder_u_tau = tau[1]; /* N*m */
    const wreal shoulder_damping = w[4]; /* N*m*s/rad */
    const real shoulder_tau = shoulder_u * shoulder_damping + upper_arm_n_y;
    const real shoulder_drive = shoulder_u_tau - shoulder_tau;

    /* waist: tau, drive */
    const real waist_u_tau = tau[0]; /* N*m */
    const wreal waist_damping = w[3]; /* N*m*s/rad */
    const real waist_tau = waist_u * waist_damping + upper_arm_n_z;
    const real waist_drive = waist_u_tau - waist_tau;

    /* M: factor */
    const real M_factor_3 = shoulder_drive - elbow_drive * M_L_3_2;

    /* waist: udot */
    const real waist_udot = M_D_inverse_1 * (waist_drive + elbow_drive * M_factor_2
        - M_L_2_1 * M_factor_3);
    out[0] = waist_udot; /* udot: waist.udot [rad/s^2] */

    /* shoulder: udot */
    const real shoulder_udot = M_D_inverse_2 * M_factor_3 - M_L_2_1 * waist_udot;
    out[1] = shoulder_udot; /* udot: shoulder.udot [rad/s^2] */

    /* elbow: udot */
    /* udot: elbow.udot [rad/s^2] */
    out[2] = elbow_drive * M_D_inverse_3 + M_factor_2 * waist_udot - M_L_3_2 * shoulder_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 0, 21, 0, 3, 3, 0, 0, 0, 29, 0, 0, 0, 0, 3, 0, 0, 0, 0};
#endif
