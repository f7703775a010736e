/*
 * inverse_dynamics of arm
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 3, work 0, w 16
 * Operations per call: 129 = 69 mul, 35 add, 21 sub, 2 cos, 2 sin
 * Operations of prepare: 71 = 29 add, 29 mul, 11 sub, 1 cos, 1 sin
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
 * Input udot (3): derivatives of the speeds
 *   udot[0]  waist.udot [rad/s^2]
 *   udot[1]  shoulder.udot [rad/s^2]
 *   udot[2]  elbow.udot [rad/s^2]
 *
 * Output tau (3)
 *   out[0]  waist.u.tau [N*m]
 *   out[1]  shoulder.u.tau [N*m]
 *   out[2]  elbow.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* wrist: placement */
    const wreal wrist_rotation_yaw = p[21]; /* rad */
    const wreal angle[CARDAN_PADDED(1)] = {wrist_rotation_yaw};
    wreal sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const wreal wrist_placement = cosine[0];
    const wreal wrist_placement_2 = sine[0];

    /* column: first moment, mass, inertia */
    const wreal column_mass = p[1]; /* kg */
    const wreal column_com_z = p[2]; /* m */
    const wreal column_inertia_xx = p[3]; /* kg m^2 */
    const wreal column_inertia_yy = p[4]; /* kg m^2 */
    const wreal column_first_moment_z = column_mass * column_com_z;
    const wreal column_mass_2 = column_com_z * column_first_moment_z;
    const wreal column_inertia_xx_2 = column_inertia_xx + column_mass_2;
    const wreal column_inertia_yy_2 = column_inertia_yy + column_mass_2;

    /* upper_arm: first moment, mass, inertia */
    const wreal upper_arm_mass = p[7]; /* kg */
    const wreal upper_arm_com_x = p[8]; /* m */
    const wreal upper_arm_inertia_yy = p[10]; /* kg m^2 */
    const wreal upper_arm_inertia_zz = p[11]; /* kg m^2 */
    const wreal upper_arm_first_moment_x = upper_arm_mass * upper_arm_com_x;
    const wreal upper_arm_mass_2 = upper_arm_com_x * upper_arm_first_moment_x;
    const wreal upper_arm_inertia_yy_2 = upper_arm_inertia_yy + upper_arm_mass_2;
    const wreal upper_arm_inertia_zz_2 = upper_arm_inertia_zz + upper_arm_mass_2;

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

    /* hand: mass */
    const wreal wrist_position_x = p[20]; /* m */
    const wreal hand_mass_2 = wrist_position_x * hand_mass;
    const wreal hand_mass_3 = wrist_placement * hand_inertia_xx;
    const wreal hand_mass_4 = wrist_placement_2 * hand_inertia_yy;
    const wreal hand_mass_5 = wrist_position_x * hand_mass_2;

    /* forearm: first moment, inertia */
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
    w[6] = forearm_mass_2 + hand_mass_2; /* forearm_first_moment_x */
    /* forearm_inertia_xy */
    w[7] = wrist_placement_2 * hand_mass_3 - wrist_placement * hand_mass_4
        - forearm_com_y * forearm_mass_2;

    /* upper_arm: base second moment, base moment */
    w[8] = elbow_position_x * forearm_first_moment_y; /* upper_arm_base_second_moment_xy */
    /* upper_arm_base_moment_x */
    w[9] = upper_arm_first_moment_x + elbow_position_x * forearm_mass_5;

    /* common */
    const wreal column_inertia_zz = p[5]; /* kg m^2 */
    const wreal upper_arm_inertia_xx = p[9]; /* kg m^2 */
    const wreal mul_1 = 0.5 * (column_inertia_zz + column_inertia_xx_2 + column_inertia_yy_2);
    const wreal mul_1_2 = 0.5 * (upper_arm_inertia_xx + upper_arm_inertia_zz_2
        + upper_arm_inertia_yy_2);
    const wreal mul_1_3 = 0.5 * (forearm_inertia_xx_2 + forearm_inertia_zz_2
        + forearm_inertia_yy_2);

    /* column: base second moment, inertia force */
    const wreal column_base_second_moment_xx = mul_1 - column_inertia_xx_2;
    const wreal column_base_second_moment_yy = mul_1_3 - forearm_inertia_yy_2 + (mul_1
        - column_inertia_yy_2 + (mul_1_2 - upper_arm_inertia_yy_2));
    w[14] = column_base_second_moment_xx + column_base_second_moment_yy; /* column_inertia_force */

    /* upper_arm: base second moment */
    const wreal upper_arm_base_second_moment_zz = mul_1_2 - upper_arm_inertia_zz_2;
    const wreal upper_arm_base_second_moment_xx = mul_1_2 - upper_arm_inertia_xx + (forearm_base
        + forearm_base);
    w[10] = upper_arm_base_second_moment_zz; /* upper_arm_base_second_moment_zz */
    w[13] = upper_arm_base_second_moment_xx; /* upper_arm_base_second_moment_xx */

    /* forearm: base second moment */
    w[11] = mul_1_3 - forearm_inertia_xx_2; /* forearm_base_second_moment_xx */
    w[12] = mul_1_3 - forearm_inertia_zz_2; /* forearm_base_second_moment_zz */

    /* common */
    w[15] = upper_arm_base_second_moment_zz - upper_arm_base_second_moment_xx; /* sub_1 */

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[12]; /* elbow.position.x [m] */
    w[2] = p[17]; /* forearm.inertia.xz [kg m^2] */
    w[3] = p[26]; /* waist.damping [N*m*s/rad] */
    w[4] = p[27]; /* shoulder.damping [N*m*s/rad] */
    w[5] = p[28]; /* elbow.damping [N*m*s/rad] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
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

    /* forearm: alpha, omega, U, inertia force, f */
    const real waist_u = u[0]; /* rad/s */
    const real shoulder_u = u[1]; /* rad/s */
    const real elbow_u = u[2]; /* rad/s */
    const real shoulder_udot = udot[1]; /* rad/s^2 */
    const real elbow_udot = udot[2]; /* rad/s^2 */
    const wreal forearm_first_moment_x = w[6];
    const wreal forearm_base_second_moment_xx = w[11];
    const wreal forearm_base_second_moment_zz = w[12];
    const real forearm_alpha = waist_u * elbow_sin;
    const real forearm_omega_z = waist_u * elbow_cos;
    const real forearm_omega_y = shoulder_u + elbow_u;
    const real forearm_alpha_y = shoulder_udot + elbow_udot;
    const real forearm_U = forearm_alpha * forearm_alpha;
    const real forearm_U_2 = forearm_omega_y * forearm_omega_y;
    const real forearm_U_3 = forearm_omega_z * forearm_omega_z;
    const real forearm_U_4 = forearm_alpha * forearm_omega_z;
    const real forearm_U_5 = forearm_omega_z * forearm_omega_y;
    const real forearm_U_6 = forearm_U_2 + forearm_U_3;
    const real forearm_inertia_force = forearm_first_moment_x * forearm_U_6;
    const real forearm_U_xz = forearm_alpha_y - forearm_U_4;
    const real forearm_U_7 = forearm_alpha_y + forearm_U_4;
    const real forearm_inertia_force_2 = forearm_base_second_moment_zz * forearm_U_xz
        + forearm_base_second_moment_xx * forearm_U_7;
    const real forearm_inertia_force_3 = forearm_first_moment_x * forearm_U_7;
    const real forearm_f = elbow_p * (elbow_cos * forearm_inertia_force
        + elbow_sin * forearm_inertia_force_3);

    /* shared by several: U */
    const real column_U = waist_u * waist_u;

    /* upper_arm: U, turned, n */
    const wreal upper_arm_base_second_moment_xy = w[8];
    const real upper_arm_U = waist_u * shoulder_u;
    const real upper_arm_U_2 = shoulder_u * shoulder_u;
    const real upper_arm_U_3 = column_U + upper_arm_U_2;
    const real upper_arm_U_yz = upper_arm_U + upper_arm_U;
    const real upper_arm_turned = upper_arm_base_second_moment_xy * shoulder_sin;
    const real upper_arm_n = upper_arm_base_second_moment_xy * shoulder_cos * (upper_arm_U_3
        - column_U) + shoulder_udot * upper_arm_turned;

    /* forearm: alpha, a, U, inertia force, n, f */
    const real waist_udot = udot[0]; /* rad/s^2 */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal forearm_inertia_xz = w[2]; /* kg m^2 */
    const wreal forearm_inertia_xy = w[7];
    const real forearm_alpha_2 = elbow_cos * upper_arm_U + waist_udot * elbow_sin
        + elbow_u * forearm_omega_z;
    const real forearm_alpha_z = waist_udot * elbow_cos - elbow_sin * upper_arm_U
        - elbow_u * forearm_alpha;
    const real forearm_a_y = waist_udot * elbow_p_x - elbow_p * upper_arm_U_yz;
    const real forearm_a = elbow_cos * (elbow_p * upper_arm_U_2 - gravity_z
        - shoulder_udot * elbow_p_x);
    const real forearm_a_z = forearm_a - elbow_sin * (elbow_p_x * upper_arm_U_3
        + shoulder_udot * elbow_p);
    const real forearm_U_yx = forearm_alpha_z - forearm_alpha * forearm_omega_y;
    const real forearm_U_yz = forearm_alpha_2 + forearm_U_5;
    const real forearm_U_zy = forearm_U_5 - forearm_alpha_2;
    const real forearm_inertia_force_4 = forearm_inertia_xy * forearm_U_zy
        - forearm_inertia_xz * (forearm_U + forearm_U_2 - forearm_U_6);
    const real forearm_inertia_force_5 = forearm_inertia_xy * (forearm_U_6 - (forearm_U
        + forearm_U_3)) + forearm_inertia_xz * forearm_U_yz;
    const real forearm_n_x = forearm_inertia_xy * forearm_U_7 + forearm_inertia_xz * forearm_U_yx
        - forearm_base_second_moment_zz * forearm_U_yz;
    const real forearm_n_y = forearm_inertia_force_2 - forearm_first_moment_x * forearm_a_z
        + forearm_inertia_force_4;
    const real forearm_n_z = forearm_base_second_moment_xx * forearm_U_yx
        + forearm_first_moment_x * forearm_a_y - forearm_inertia_force_5;
    const real forearm_f_y = forearm_first_moment_x * forearm_U_yx;

    /* common */
    const wreal upper_arm_base_second_moment_xx = w[13];
    const wreal sub_1 = w[15];
    const real mul_1_4 = shoulder_sin * sub_1;
    const real mul_1_5 = shoulder_sin * mul_1_4;
    const real mul_1_6 = shoulder_cos * mul_1_4;
    const real add_1 = upper_arm_base_second_moment_xx + mul_1_5;

    /* upper_arm: n */
    const wreal upper_arm_base_moment_x = w[9];
    const wreal upper_arm_base_second_moment_zz = w[10];
    const real upper_arm_n_2 = waist_udot * upper_arm_turned
        + upper_arm_base_moment_x * shoulder_cos * gravity_z + mul_1_6 * (upper_arm_U_2
        - upper_arm_U_3);
    const real upper_arm_n_3 = upper_arm_U_yz * mul_1_6 + upper_arm_n + waist_udot * add_1
        + elbow_p_x * forearm_f_y + elbow_cos * forearm_n_z;
    const real upper_arm_n_z = upper_arm_n_3 - elbow_sin * forearm_n_x;
    const real upper_arm_n_4 = forearm_n_y - elbow_p_x * (elbow_sin * forearm_inertia_force
        - elbow_cos * forearm_inertia_force_3);
    const real upper_arm_n_y = shoulder_udot * (upper_arm_base_second_moment_zz - mul_1_5
        + add_1) + upper_arm_n_2 + forearm_f + upper_arm_n_4;

    /* elbow: tau */
    const wreal elbow_damping = w[5]; /* N*m*s/rad */
    out[2] = elbow_u * elbow_damping + forearm_n_y; /* tau: elbow.u.tau [N*m] */

    /* column: n */
    const wreal column_inertia_force = w[14];
    const real column_n_z = waist_udot * column_inertia_force + upper_arm_n_z;

    /* waist: tau */
    const wreal waist_damping = w[3]; /* N*m*s/rad */
    out[0] = waist_u * waist_damping + column_n_z; /* tau: waist.u.tau [N*m] */

    /* shoulder: tau */
    const wreal shoulder_damping = w[4]; /* N*m*s/rad */
    out[1] = shoulder_u * shoulder_damping + upper_arm_n_y; /* tau: shoulder.u.tau [N*m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {3, 0, 16, 0, 3, 3, 0, 0, 0, 29, 0, 3, 0, 0, 0, 0, 0, 0, 0};
#endif
