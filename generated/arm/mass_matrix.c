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
    const wreal wrist_rotation_yaw_cos = cosine[0];
    const wreal wrist_rotation_yaw_sin = sine[0];

    /* upper_arm: first moment, mass, origin inertia, inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal upper_arm_mass = p[7]; /* kg */
    const wreal upper_arm_com_x = p[8]; /* m */
    const wreal upper_arm_inertia_yy = p[10]; /* kg m^2 */
    const wreal upper_arm_inertia_zz = p[11]; /* kg m^2 */
    const wreal forearm_inertia_xz = p[17]; /* kg m^2 */
    const wreal upper_arm_first_moment_x = upper_arm_mass * upper_arm_com_x;
    const wreal upper_arm_com_x_times_first_moment_x = upper_arm_com_x * upper_arm_first_moment_x;
    const wreal upper_arm_origin_inertia_yy = upper_arm_inertia_yy
        + upper_arm_com_x_times_first_moment_x;
    const wreal upper_arm_origin_inertia_zz = upper_arm_inertia_zz
        + upper_arm_com_x_times_first_moment_x;
    const wreal twice_forearm_inertia_xz = forearm_inertia_xz + forearm_inertia_xz;
    w[8] = twice_forearm_inertia_xz;

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
    const wreal forearm_base_shift = 0.5 * forearm_whole_mass * elbow_position_x * elbow_position_x
        * 2.0;

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
    const wreal upper_arm_inertia_xx = p[9]; /* kg m^2 */
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
    w[1] = forearm_first_moment_x;
    w[2] = forearm_origin_inertia_xy;
    w[3] = forearm_origin_inertia_yy;
    w[4] = forearm_base_inertia_zz;

    /* upper_arm: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_arm_base_second_moment_xy = elbow_position_x * forearm_first_moment_y;
    const wreal upper_arm_base_inertia_yy = upper_arm_origin_inertia_yy + forearm_base_shift;
    const wreal upper_arm_base_inertia_zz = upper_arm_origin_inertia_zz
        + forearm_origin_inertia_xx + (forearm_base_shift - upper_arm_base_inertia_zz_2);
    const wreal forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy = forearm_origin_inertia_yy
        + upper_arm_base_inertia_yy;
    const wreal forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz = forearm_base_inertia_zz
        + upper_arm_base_inertia_zz;
    w[5] = upper_arm_base_second_moment_xy;
    w[6] = upper_arm_base_inertia_zz;
    w[9] = forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy;
    w[10] = forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz;

    /* column: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal column_inertia_zz = p[5]; /* kg m^2 */
    const wreal column_base_inertia_zz = column_inertia_zz + upper_arm_base_inertia_zz_2;
    w[7] = column_base_inertia_zz;

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
    const wreal elbow_position_x = w[0]; /* m */
    const real elbow_p_x = elbow_position_x * shoulder_cos;

    /* upper_arm: inertia */
    const wreal forearm_base_inertia_zz = w[4];
    const wreal upper_arm_base_inertia_zz = w[6];
    const wreal twice_forearm_inertia_xz = w[8];
    const wreal forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz = w[10];
    const real upper_arm_composite_inertia_zz_part =
        forearm_base_inertia_zz_plus_upper_arm_base_inertia_zz
        - upper_arm_base_inertia_zz * shoulder_sin * shoulder_sin
        - elbow_turn_sin * (forearm_base_inertia_zz * elbow_turn_sin
        + elbow_turn_cos * twice_forearm_inertia_xz);

    /* shared by several: inertia */
    const wreal forearm_first_moment_x = w[1];
    const wreal forearm_origin_inertia_xy = w[2];
    const real momentum_minus_elbow_about_upper_arm_mz = forearm_origin_inertia_xy * elbow_turn_sin;
    const real elbow_minus_p_z_times_upper_arm_minus_inertia_mean_moment_z = elbow_position_x *
        shoulder_sin * (forearm_first_moment_x * elbow_turn_sin);
    const real upper_arm_inertia_shift_part = forearm_first_moment_x * elbow_turn_cos * elbow_p_x
        + elbow_minus_p_z_times_upper_arm_minus_inertia_mean_moment_z;
    const real momentum_elbow_about_upper_arm_mz = -momentum_minus_elbow_about_upper_arm_mz;
    out[2] = momentum_elbow_about_upper_arm_mz; /* M: waist.u,elbow.u */
    out[6] = momentum_elbow_about_upper_arm_mz; /* M: elbow.u,waist.u */

    /* upper_arm: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal upper_arm_base_second_moment_xy = w[5];
    const wreal forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy = w[9];
    const real upper_arm_composite_inertia_yz = upper_arm_base_second_moment_xy * shoulder_sin
        - momentum_minus_elbow_about_upper_arm_mz;
    const real upper_arm_inertia_shift = 2.0 * upper_arm_inertia_shift_part;
    const real upper_arm_composite_inertia_zz = upper_arm_inertia_shift
        - 2.0 * elbow_minus_p_z_times_upper_arm_minus_inertia_mean_moment_z
        + upper_arm_composite_inertia_zz_part;
    out[1] = upper_arm_composite_inertia_yz; /* M: waist.u,shoulder.u */
    out[3] = upper_arm_composite_inertia_yz; /* M: shoulder.u,waist.u */
    /* M: shoulder.u,shoulder.u */
    out[4] = upper_arm_inertia_shift + forearm_origin_inertia_yy_plus_upper_arm_base_inertia_yy;

    /* column: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal column_base_inertia_zz = w[7];
    out[0] = column_base_inertia_zz + upper_arm_composite_inertia_zz; /* M: waist.u,waist.u */

    /* M */
    /* M = S . momentum */
    const wreal forearm_origin_inertia_yy = w[3];
    const real M_elbow_shoulder = forearm_origin_inertia_yy + upper_arm_inertia_shift_part;
    out[5] = M_elbow_shoulder; /* M: shoulder.u,elbow.u */
    out[7] = M_elbow_shoulder; /* M: elbow.u,shoulder.u */

    /* results that are numbers or inputs */
    out[8] = CARDAN_REAL(w[3]); /* M: elbow.u,elbow.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {9, 0, 11, 0, 3, 0, 0, 0, 0, 29, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
