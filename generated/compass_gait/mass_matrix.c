/*
 * mass_matrix of compass_gait
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 4
 * Operations per call: 6 = 3 mul, 2 add, 1 cos
 * Operations of prepare: 11 = 8 mul, 3 add
 *
 * Input q (2): generalized coordinates
 *   q[0]  stance [rad]
 *   q[1]  hip [rad]
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* swing_leg: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal swing_leg_mass = p[7]; /* kg */
    const wreal swing_leg_com_z = p[8]; /* m */
    const wreal swing_leg_first_moment_z = swing_leg_mass * swing_leg_com_z;
    const wreal swing_leg_origin_inertia_xx = swing_leg_com_z * swing_leg_first_moment_z;
    w[1] = swing_leg_first_moment_z;
    w[2] = swing_leg_origin_inertia_xx;

    /* stance_leg: origin inertia, base, inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal stance_leg_mass = p[2]; /* kg */
    const wreal stance_leg_com_z = p[3]; /* m */
    const wreal top_position_z = p[4]; /* m */
    const wreal hip_mass_mass = p[5]; /* kg */
    const wreal hip_position_z = p[6]; /* m */
    const wreal stance_leg_origin_inertia_xx = stance_leg_mass * stance_leg_com_z * stance_leg_com_z
        + top_position_z * hip_mass_mass * top_position_z;
    const wreal stance_leg_base_inertia_yy = stance_leg_origin_inertia_xx
        + hip_position_z * swing_leg_mass * hip_position_z;
    const wreal swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy =
        swing_leg_origin_inertia_xx + stance_leg_base_inertia_yy;
    w[3] = swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy;

    /* parameters as they are */
    w[0] = p[6]; /* hip.position.z [m] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* hip: R */
    /* R = R_fixed R_joint(q) */
    const real hip_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hip_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hip_cos = cosine[0];

    /* shared by several: inertia */
    const wreal hip_position_z = w[0]; /* m */
    const wreal swing_leg_first_moment_z = w[1];
    const real hip_position_z_times_stance_leg_inertia_mean_moment_z = swing_leg_first_moment_z *
        hip_cos * hip_position_z;

    /* stance_leg: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy = w[3];
    /* M: stance.u,stance.u */
    out[0] = 2.0 * hip_position_z_times_stance_leg_inertia_mean_moment_z
        + swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy;

    /* M */
    /* M = S . momentum */
    const wreal swing_leg_origin_inertia_xx = w[2];
    const real M_hip_stance = swing_leg_origin_inertia_xx
        + hip_position_z_times_stance_leg_inertia_mean_moment_z;
    out[1] = M_hip_stance; /* M: stance.u,hip.u */
    out[2] = M_hip_stance; /* M: hip.u,stance.u */

    /* results that are numbers or inputs */
    out[3] = CARDAN_REAL(w[2]); /* M: hip.u,hip.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 4, 0, 2, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
