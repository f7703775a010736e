/*
 * mass_matrix of arm
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 9, work 0, w 11
 * Operations per call: 31 = 15 mul, 7 add, 4 sub, 2 cos, 2 sin, 1 neg
 * Operations of prepare: 53 = 24 mul, 23 add, 4 sub, 1 cos, 1 sin
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
    w[8] = forearm_inertia_xz + forearm_inertia_xz; /* upper_arm_inertia */

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
    const wreal forearm_base = 0.5 * forearm_mass_5 * elbow_position_x * elbow_position_x * 2.0;

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
    const wreal forearm_base_2 = upper_arm_inertia_xx + forearm_inertia_xx_2;
    w[1] = forearm_mass_2 + hand_mass_2; /* forearm_first_moment_x */
    /* forearm_inertia_xy */
    w[2] = wrist_placement_2 * hand_mass_3 - wrist_placement * hand_mass_4
        - forearm_com_y * forearm_mass_2;
    w[3] = forearm_inertia_yy_2; /* forearm_inertia_yy_2 */
    w[4] = forearm_base_inertia_zz; /* forearm_base_inertia_zz */

    /* upper_arm: base second moment, base inertia, inertia */
    const wreal upper_arm_base_inertia_yy = upper_arm_inertia_yy_2 + forearm_base;
    const wreal upper_arm_base_inertia_zz = upper_arm_inertia_zz_2 + forearm_inertia_xx_2
        + (forearm_base - forearm_base_2);
    w[5] = elbow_position_x * forearm_first_moment_y; /* upper_arm_base_second_moment_xy */
    w[6] = upper_arm_base_inertia_zz; /* upper_arm_base_inertia_zz */
    w[9] = forearm_inertia_yy_2 + upper_arm_base_inertia_yy; /* upper_arm_inertia_2 */
    w[10] = forearm_base_inertia_zz + upper_arm_base_inertia_zz; /* upper_arm_inertia_3 */

    /* column: base inertia */
    const wreal column_inertia_zz = p[5]; /* kg m^2 */
    w[7] = column_inertia_zz + forearm_base_2; /* column_base_inertia_zz */

    /* parameters as they are */
    w[0] = p[12]; /* elbow.position.x [m] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
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
    const wreal elbow_position_x = w[0]; /* m */
    const real elbow_p_x = elbow_position_x * shoulder_cos;

    /* upper_arm: inertia */
    const wreal forearm_base_inertia_zz = w[4];
    const wreal upper_arm_base_inertia_zz = w[6];
    const wreal upper_arm_inertia = w[8];
    const wreal upper_arm_inertia_3 = w[10];
    const real upper_arm_inertia_4 = elbow_sin * (forearm_base_inertia_zz * elbow_sin
        + elbow_cos * upper_arm_inertia);
    const real upper_arm_inertia_5 = upper_arm_inertia_3
        - upper_arm_base_inertia_zz * shoulder_sin * shoulder_sin - upper_arm_inertia_4;

    /* shared by several: inertia */
    const wreal forearm_first_moment_x = w[1];
    const wreal forearm_inertia_xy = w[2];
    const real upper_arm_inertia_6 = forearm_inertia_xy * elbow_sin;
    const real upper_arm_inertia_7 = elbow_position_x * shoulder_sin * (forearm_first_moment_x *
        elbow_sin);
    const real upper_arm_inertia_8 = forearm_first_moment_x * elbow_cos * elbow_p_x
        + upper_arm_inertia_7;

    /* upper_arm: composite inertia, inertia */
    const wreal upper_arm_base_second_moment_xy = w[5];
    const wreal upper_arm_inertia_2 = w[9];
    const real upper_arm_composite_inertia_yz = upper_arm_base_second_moment_xy * shoulder_sin
        - upper_arm_inertia_6;
    const real upper_arm_inertia_9 = 2.0 * upper_arm_inertia_8;
    const real upper_arm_composite_inertia_zz = upper_arm_inertia_9 - 2.0 * upper_arm_inertia_7
        + upper_arm_inertia_5;
    out[1] = upper_arm_composite_inertia_yz; /* M: waist.u,shoulder.u */
    out[3] = upper_arm_composite_inertia_yz; /* M: shoulder.u,waist.u */
    out[4] = upper_arm_inertia_9 + upper_arm_inertia_2; /* M: shoulder.u,shoulder.u */

    /* M */
    const wreal forearm_inertia_yy_2 = w[3];
    const real M_3_1 = -upper_arm_inertia_6;
    const real M_3_2 = forearm_inertia_yy_2 + upper_arm_inertia_8;
    out[2] = M_3_1; /* M: waist.u,elbow.u */
    out[6] = M_3_1; /* M: elbow.u,waist.u */
    out[5] = M_3_2; /* M: shoulder.u,elbow.u */
    out[7] = M_3_2; /* M: elbow.u,shoulder.u */

    /* column: composite inertia */
    const wreal column_base_inertia_zz = w[7];
    out[0] = column_base_inertia_zz + upper_arm_composite_inertia_zz; /* M: waist.u,waist.u */

    /* results that are numbers or inputs */
    out[8] = CARDAN_REAL(w[3]); /* M: elbow.u,elbow.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {9, 0, 11, 0, 3, 0, 0, 0, 0, 29, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
