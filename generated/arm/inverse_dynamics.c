/*
 * inverse_dynamics of arm
 * tau with M udot + h = f + tau
 * formalism: composite
 * passes: reassociate
 *
 * Sizes: out 3, work 0, w 19
 * Operations per call: 156 = 83 mul, 42 add, 27 sub, 2 cos, 2 sin
 * Operations of prepare: 59 = 24 mul, 23 add, 10 sub, 1 cos, 1 sin
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

    /* column: first moment, mass, inertia, inertia force, second moment */
    const wreal column_mass = p[1]; /* kg */
    const wreal column_com_z = p[2]; /* m */
    const wreal column_inertia_xx = p[3]; /* kg m^2 */
    const wreal column_inertia_yy = p[4]; /* kg m^2 */
    const wreal column_inertia_zz = p[5]; /* kg m^2 */
    const wreal column_first_moment_z = column_mass * column_com_z;
    const wreal column_mass_2 = column_com_z * column_first_moment_z;
    const wreal column_inertia_xx_2 = column_inertia_xx + column_mass_2;
    const wreal column_inertia_yy_2 = column_inertia_yy + column_mass_2;
    const wreal column_inertia_force = 0.5 * (column_inertia_zz + column_inertia_xx_2
        + column_inertia_yy_2);
    w[11] = column_inertia_force - column_inertia_xx_2; /* column_second_moment_xx */
    w[12] = column_inertia_force - column_inertia_yy_2; /* column_second_moment_yy */

    /* upper_arm: first moment, mass, inertia, inertia force, second moment */
    const wreal upper_arm_mass = p[7]; /* kg */
    const wreal upper_arm_com_x = p[8]; /* m */
    const wreal upper_arm_inertia_xx = p[9]; /* kg m^2 */
    const wreal upper_arm_inertia_yy = p[10]; /* kg m^2 */
    const wreal upper_arm_inertia_zz = p[11]; /* kg m^2 */
    const wreal upper_arm_first_moment_x = upper_arm_mass * upper_arm_com_x;
    const wreal upper_arm_mass_2 = upper_arm_com_x * upper_arm_first_moment_x;
    const wreal upper_arm_inertia_yy_2 = upper_arm_inertia_yy + upper_arm_mass_2;
    const wreal upper_arm_inertia_zz_2 = upper_arm_inertia_zz + upper_arm_mass_2;
    const wreal upper_arm_inertia_force = 0.5 * (upper_arm_inertia_xx + upper_arm_inertia_zz_2
        + upper_arm_inertia_yy_2);
    w[1] = upper_arm_first_moment_x; /* upper_arm_first_moment_x */
    w[13] = upper_arm_inertia_force - upper_arm_inertia_xx; /* upper_arm_second_moment_xx */
    w[14] = upper_arm_inertia_force - upper_arm_inertia_yy_2; /* upper_arm_second_moment_yy */
    w[15] = upper_arm_inertia_force - upper_arm_inertia_zz_2; /* upper_arm_second_moment_zz */

    /* forearm: mass, first moment */
    const wreal forearm_mass = p[13]; /* kg */
    const wreal forearm_com_x = p[14]; /* m */
    const wreal forearm_com_y = p[15]; /* m */
    const wreal hand_mass = p[22]; /* kg */
    const wreal hand_inertia_xx = p[23]; /* kg m^2 */
    const wreal hand_inertia_yy = p[24]; /* kg m^2 */
    const wreal forearm_mass_3 = forearm_mass * forearm_com_x;
    const wreal forearm_first_moment_y = forearm_mass * forearm_com_y;
    const wreal forearm_mass_4 = forearm_com_x * forearm_mass_3;
    const wreal forearm_mass_5 = forearm_com_y * forearm_first_moment_y;
    const wreal forearm_mass_6 = wrist_placement_2 * hand_inertia_xx * wrist_placement_2
        + wrist_placement * hand_inertia_yy * wrist_placement;
    w[4] = forearm_first_moment_y; /* forearm_first_moment_y */
    w[8] = forearm_mass + hand_mass; /* forearm_mass_2 */

    /* hand: mass */
    const wreal wrist_position_x = p[20]; /* m */
    const wreal hand_mass_2 = wrist_position_x * hand_mass;
    const wreal hand_mass_3 = wrist_placement * hand_inertia_xx;
    const wreal hand_mass_4 = wrist_placement_2 * hand_inertia_yy;
    const wreal hand_mass_5 = wrist_position_x * hand_mass_2;

    /* forearm: first moment, inertia, inertia force, second moment */
    const wreal forearm_inertia_xx = p[16]; /* kg m^2 */
    const wreal forearm_inertia_yy = p[18]; /* kg m^2 */
    const wreal forearm_inertia_zz = p[19]; /* kg m^2 */
    const wreal hand_inertia_zz = p[25]; /* kg m^2 */
    const wreal forearm_inertia_xx_2 = forearm_inertia_xx + forearm_mass_5
        + (wrist_placement * hand_mass_3 + wrist_placement_2 * hand_mass_4);
    const wreal forearm_inertia_yy_2 = forearm_inertia_yy + forearm_mass_4 + hand_mass_5
        + forearm_mass_6;
    const wreal forearm_inertia_zz_2 = forearm_mass_5 + hand_inertia_zz + (forearm_inertia_zz
        + forearm_mass_4 + hand_mass_5);
    const wreal forearm_inertia_force = 0.5 * (forearm_inertia_xx_2 + forearm_inertia_zz_2
        + forearm_inertia_yy_2);
    w[9] = forearm_mass_3 + hand_mass_2; /* forearm_first_moment_x */
    /* forearm_inertia_xy */
    w[10] = wrist_placement_2 * hand_mass_3 - wrist_placement * hand_mass_4
        - forearm_com_y * forearm_mass_3;
    w[16] = forearm_inertia_force - forearm_inertia_xx_2; /* forearm_second_moment_xx */
    w[17] = forearm_inertia_force - forearm_inertia_yy_2; /* forearm_second_moment_yy */
    w[18] = forearm_inertia_force - forearm_inertia_zz_2; /* forearm_second_moment_zz */

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[2] = p[12]; /* elbow.position.x [m] */
    w[3] = p[17]; /* forearm.inertia.xz [kg m^2] */
    w[5] = p[26]; /* waist.damping [N*m*s/rad] */
    w[6] = p[27]; /* shoulder.damping [N*m*s/rad] */
    w[7] = p[28]; /* elbow.damping [N*m*s/rad] */
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

    /* shared by several: cos, sin */
    const real shoulder_q = q[1]; /* rad */
    const real elbow_q = q[2]; /* rad */
    const real angle_2[CARDAN_PADDED(2)] = {shoulder_q, elbow_q};
    real sine_2[CARDAN_PADDED(2)], cosine_2[CARDAN_PADDED(2)];
    cardan_sincos(2, angle_2, sine_2, cosine_2);
    const real shoulder_cos = cosine_2[0];
    const real shoulder_sin = sine_2[0];
    const real elbow_cos = cosine_2[1];
    const real elbow_sin = sine_2[1];

    /* upper_arm: alpha, omega, U, a, n */
    const real waist_u = u[0]; /* rad/s */
    const real shoulder_u = u[1]; /* rad/s */
    const real waist_udot = udot[0]; /* rad/s^2 */
    const real shoulder_udot = udot[1]; /* rad/s^2 */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal upper_arm_first_moment_x = w[1];
    const wreal upper_arm_second_moment_xx = w[13];
    const wreal upper_arm_second_moment_yy = w[14];
    const wreal upper_arm_second_moment_zz = w[15];
    const real upper_arm_alpha = waist_u * shoulder_sin;
    const real upper_arm_omega_z = waist_u * shoulder_cos;
    const real upper_arm_U = shoulder_u * upper_arm_omega_z;
    const real upper_arm_U_2 = shoulder_u * upper_arm_alpha;
    const real upper_arm_alpha_2 = upper_arm_U + waist_udot * shoulder_sin;
    const real upper_arm_alpha_z = waist_udot * shoulder_cos - upper_arm_U_2;
    const real upper_arm_a_x = gravity_z * shoulder_sin;
    const real upper_arm_a = gravity_z * shoulder_cos;
    const real upper_arm_U_3 = upper_arm_alpha * upper_arm_omega_z;
    const real upper_arm_U_xz = shoulder_udot - upper_arm_U_3;
    const real upper_arm_U_yx = upper_arm_alpha_z - upper_arm_U_2;
    const real upper_arm_U_yz = upper_arm_U + upper_arm_alpha_2;
    const real upper_arm_U_4 = shoulder_udot + upper_arm_U_3;
    const real upper_arm_U_zy = upper_arm_U - upper_arm_alpha_2;
    const real upper_arm_n = upper_arm_U_xz * upper_arm_second_moment_zz
        + upper_arm_first_moment_x * upper_arm_a + upper_arm_U_4 * upper_arm_second_moment_xx;
    const real upper_arm_n_2 = (upper_arm_U_2 + upper_arm_alpha_z) * upper_arm_second_moment_yy
        + upper_arm_U_yx * upper_arm_second_moment_xx;

    /* forearm: alpha, omega, a, U, inertia force, n, f */
    const real elbow_u = u[2]; /* rad/s */
    const real elbow_udot = udot[2]; /* rad/s^2 */
    const wreal elbow_position_x = w[2]; /* m */
    const wreal forearm_inertia_xz = w[3]; /* kg m^2 */
    const wreal forearm_first_moment_y = w[4];
    const wreal forearm_mass_2 = w[8];
    const wreal forearm_first_moment_x = w[9];
    const wreal forearm_inertia_xy = w[10];
    const wreal forearm_second_moment_xx = w[16];
    const wreal forearm_second_moment_yy = w[17];
    const wreal forearm_second_moment_zz = w[18];
    const real forearm_alpha = elbow_cos * upper_arm_alpha + elbow_sin * upper_arm_omega_z;
    const real forearm_omega_z = elbow_cos * upper_arm_omega_z - elbow_sin * upper_arm_alpha;
    const real forearm_omega_y = shoulder_u + elbow_u;
    const real forearm_alpha_2 = elbow_u * forearm_omega_z + elbow_cos * upper_arm_alpha_2
        + elbow_sin * upper_arm_alpha_z;
    const real forearm_alpha_y = shoulder_udot + elbow_udot;
    const real forearm_alpha_z = elbow_cos * upper_arm_alpha_z - elbow_sin * upper_arm_alpha_2
        - elbow_u * forearm_alpha;
    const real forearm_a_y = elbow_position_x * upper_arm_U_yx;
    const real forearm_a = upper_arm_a_x - elbow_position_x * (shoulder_u * shoulder_u
        + upper_arm_omega_z * upper_arm_omega_z);
    const real forearm_a_2 = upper_arm_a + elbow_position_x * upper_arm_U_4;
    const real forearm_a_x = elbow_cos * forearm_a + elbow_sin * forearm_a_2;
    const real forearm_a_z = elbow_sin * forearm_a - elbow_cos * forearm_a_2;
    const real forearm_U = forearm_alpha * forearm_alpha;
    const real forearm_U_2 = forearm_omega_y * forearm_omega_y;
    const real forearm_U_3 = forearm_omega_z * forearm_omega_z;
    const real forearm_U_4 = forearm_alpha * forearm_omega_y;
    const real forearm_U_5 = forearm_alpha * forearm_omega_z;
    const real forearm_U_6 = forearm_omega_z * forearm_omega_y;
    const real forearm_U_7 = forearm_U_2 + forearm_U_3;
    const real forearm_U_8 = forearm_alpha_z + forearm_U_4;
    const real forearm_U_xz = forearm_alpha_y - forearm_U_5;
    const real forearm_U_yx = forearm_alpha_z - forearm_U_4;
    const real forearm_U_9 = forearm_U + forearm_U_3;
    const real forearm_U_yz = forearm_alpha_2 + forearm_U_6;
    const real forearm_U_10 = forearm_alpha_y + forearm_U_5;
    const real forearm_U_zy = forearm_U_6 - forearm_alpha_2;
    const real forearm_inertia_force_2 = forearm_inertia_xy * forearm_U_10
        + forearm_U_zy * forearm_second_moment_yy + forearm_first_moment_y * forearm_a_z;
    const real forearm_n_x = forearm_inertia_xz * forearm_U_yx
        - forearm_U_yz * forearm_second_moment_zz + forearm_inertia_force_2;
    const real forearm_inertia_force_3 = forearm_U_10 * forearm_second_moment_xx
        - forearm_inertia_xz * (forearm_U + forearm_U_2);
    const real forearm_inertia_force_4 = forearm_inertia_xz * forearm_U_7
        + forearm_U_xz * forearm_second_moment_zz + forearm_inertia_force_3;
    const real forearm_n_y = forearm_inertia_xy * forearm_U_zy
        - forearm_first_moment_x * forearm_a_z + forearm_inertia_force_4;
    const real forearm_inertia_force_5 = forearm_inertia_xy * forearm_U_9
        - forearm_inertia_xy * forearm_U_7 + forearm_first_moment_x * forearm_a_y;
    const real forearm_inertia_force_6 = forearm_U_yx * forearm_second_moment_xx
        - forearm_inertia_xz * forearm_U_yz + forearm_inertia_force_5;
    const real forearm_n_z = forearm_U_8 * forearm_second_moment_yy
        - forearm_first_moment_y * forearm_a_x + forearm_inertia_force_6;
    const real forearm_f_x = forearm_mass_2 * forearm_a_x - forearm_first_moment_x * forearm_U_7
        - forearm_first_moment_y * forearm_U_8;
    const real forearm_f_y = forearm_mass_2 * forearm_a_y - forearm_first_moment_y * forearm_U_9
        + forearm_first_moment_x * forearm_U_yx;
    const real forearm_f_z = forearm_mass_2 * forearm_a_z - forearm_first_moment_x * forearm_U_10
        + forearm_first_moment_y * forearm_U_zy;

    /* upper_arm: n */
    const real upper_arm_n_3 = upper_arm_U_zy * upper_arm_second_moment_yy
        - upper_arm_U_yz * upper_arm_second_moment_zz + elbow_cos * forearm_n_x;
    const real upper_arm_n_x = elbow_sin * forearm_n_z + upper_arm_n_3;
    const real upper_arm_n_y = forearm_n_y + upper_arm_n
        - elbow_position_x * (elbow_cos * forearm_f_z - elbow_sin * forearm_f_x);
    const real upper_arm_n_z = elbow_position_x * forearm_f_y + upper_arm_n_2
        + elbow_cos * forearm_n_z - elbow_sin * forearm_n_x;

    /* column: n */
    const wreal column_second_moment_xx = w[11];
    const wreal column_second_moment_yy = w[12];
    const real column_n = waist_udot * column_second_moment_yy
        + waist_udot * column_second_moment_xx + shoulder_cos * upper_arm_n_z;
    const real column_n_z = column_n - shoulder_sin * upper_arm_n_x;

    /* elbow: tau */
    const wreal elbow_damping = w[7]; /* N*m*s/rad */
    out[2] = elbow_u * elbow_damping + forearm_n_y; /* tau: elbow.u.tau [N*m] */

    /* shoulder: tau */
    const wreal shoulder_damping = w[6]; /* N*m*s/rad */
    out[1] = shoulder_u * shoulder_damping + upper_arm_n_y; /* tau: shoulder.u.tau [N*m] */

    /* waist: tau */
    const wreal waist_damping = w[5]; /* N*m*s/rad */
    out[0] = waist_u * waist_damping + column_n_z; /* tau: waist.u.tau [N*m] */
    return CARDAN_OK;
}
