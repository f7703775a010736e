/*
 * mass_matrix of arm
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * passes: reassociate
 *
 * Sizes: out 9, work 0, w 13
 * Operations per call: 41 = 18 mul, 12 add, 5 sub, 2 cos, 2 neg, 2 sin
 * Operations of prepare: 46 = 22 mul, 19 add, 3 sub, 1 cos, 1 sin
 *
 * Input q (3): generalized coordinates
 *   q[0]  waist [rad]
 *   q[1]  shoulder [rad]
 *   q[2]  elbow [rad]
 *
 * Input p (29): parameters, read by prepare_ only
 *
 * Output M (3 x 3): out[0 ... 8], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    w[7] = forearm_inertia_xz + forearm_inertia_xz; /* upper_arm_inertia_2 */

    /* forearm: mass, first moment */
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
    w[3] = forearm_mass_2 + hand_mass_2; /* forearm_first_moment_x */
    /* forearm_inertia_xy */
    w[4] = wrist_placement_2 * hand_mass_3 - wrist_placement * hand_mass_4
        - forearm_com_y * forearm_mass_2;
    w[5] = forearm_inertia_yy_2; /* forearm_inertia_yy_2 */

    /* upper_arm: inertia */
    const wreal upper_arm_inertia_xx = p[9]; /* kg m^2 */
    const wreal elbow_position_x = p[12]; /* m */
    w[6] = forearm_inertia_zz_2 - forearm_inertia_xx_2; /* upper_arm_inertia */
    w[8] = 0.5 * forearm_mass_5 * elbow_position_x; /* upper_arm_inertia_3 */
    w[9] = elbow_position_x * forearm_first_moment_y; /* upper_arm_inertia_4 */
    w[10] = upper_arm_inertia_xx + forearm_inertia_xx_2; /* upper_arm_inertia_5 */
    w[11] = upper_arm_inertia_yy_2 + forearm_inertia_yy_2; /* upper_arm_inertia_6 */
    w[12] = upper_arm_inertia_zz_2 + forearm_inertia_zz_2; /* upper_arm_inertia_7 */

    /* parameters as they are */
    w[0] = p[5]; /* column.inertia.zz [kg m^2] */
    w[1] = p[12]; /* elbow.position.x [m] */
    w[2] = p[17]; /* forearm.inertia.xz [kg m^2] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
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

    /* upper_arm: inertia, composite inertia */
    const wreal elbow_position_x = w[1]; /* m */
    const wreal forearm_inertia_xz = w[2]; /* kg m^2 */
    const wreal forearm_first_moment_x = w[3];
    const wreal upper_arm_inertia = w[6];
    const wreal upper_arm_inertia_2 = w[7];
    const wreal upper_arm_inertia_5 = w[10];
    const real upper_arm_inertia_8 = elbow_sin * upper_arm_inertia
        + elbow_cos * upper_arm_inertia_2;
    const real upper_arm_inertia_9 = elbow_sin * upper_arm_inertia_8;
    const real upper_arm_composite_inertia_xz = forearm_first_moment_x * elbow_sin *
        elbow_position_x - forearm_inertia_xz + elbow_cos * upper_arm_inertia_8;
    const real upper_arm_composite_inertia_xx = upper_arm_inertia_9 + upper_arm_inertia_5;

    /* shared by several: inertia */
    const wreal forearm_inertia_xy = w[4];
    const real upper_arm_inertia_10 = forearm_inertia_xy * elbow_cos;
    const real upper_arm_inertia_11 = forearm_first_moment_x * elbow_cos;
    const real column_inertia = forearm_inertia_xy * elbow_sin * shoulder_cos;

    /* upper_arm: inertia, composite inertia */
    const wreal upper_arm_inertia_3 = w[8];
    const wreal upper_arm_inertia_4 = w[9];
    const wreal upper_arm_inertia_6 = w[11];
    const wreal upper_arm_inertia_7 = w[12];
    const real upper_arm_inertia_12 = elbow_position_x * (upper_arm_inertia_11
        + upper_arm_inertia_3) * 2.0;
    const real upper_arm_composite_inertia_xy = upper_arm_inertia_10 - upper_arm_inertia_4;
    const real upper_arm_composite_inertia_zz = upper_arm_inertia_7 - upper_arm_inertia_9
        + upper_arm_inertia_12;
    out[4] = upper_arm_inertia_12 + upper_arm_inertia_6; /* M: shoulder.u,shoulder.u */

    /* column: inertia, composite inertia */
    const wreal column_inertia_zz = w[0]; /* kg m^2 */
    const real column_inertia_2 = shoulder_sin * (upper_arm_composite_inertia_zz
        - upper_arm_composite_inertia_xx);
    const real column_inertia_3 = shoulder_sin * (column_inertia_2
        + shoulder_cos * (upper_arm_composite_inertia_xz + upper_arm_composite_inertia_xz));
    /* M: waist.u,waist.u */
    out[0] = column_inertia_zz + upper_arm_composite_inertia_zz - column_inertia_3;

    /* M */
    const wreal forearm_inertia_yy_2 = w[5];
    const real M_2_1 = -(column_inertia + shoulder_sin * upper_arm_composite_inertia_xy);
    const real M_3_2 = forearm_inertia_yy_2 + elbow_position_x * upper_arm_inertia_11;
    const real M_3_1 = -(column_inertia + shoulder_sin * upper_arm_inertia_10);
    out[1] = M_2_1; /* M: waist.u,shoulder.u */
    out[3] = M_2_1; /* M: shoulder.u,waist.u */
    out[5] = M_3_2; /* M: shoulder.u,elbow.u */
    out[7] = M_3_2; /* M: elbow.u,shoulder.u */
    out[2] = M_3_1; /* M: waist.u,elbow.u */
    out[6] = M_3_1; /* M: elbow.u,waist.u */

    /* results that are numbers or inputs */
    out[8] = CARDAN_REAL(w[5]); /* M: elbow.u,elbow.u */
    return CARDAN_OK;
}
