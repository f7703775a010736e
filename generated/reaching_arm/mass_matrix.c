/*
 * mass_matrix of reaching_arm
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 4
 * Operations per call: 6 = 3 mul, 2 add, 1 cos
 * Operations of prepare: 10 = 6 mul, 4 add
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input p (12): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_mass = p[0]; /* kg */
    const wreal upper_com_x = p[1]; /* m */
    const wreal upper_inertia_zz = p[3]; /* kg m^2 */
    const wreal elbow_position_x = p[4]; /* m */
    const wreal lower_mass = p[5]; /* kg */
    const wreal upper_first_moment_x = upper_mass * upper_com_x;
    const wreal upper_origin_inertia_zz = upper_inertia_zz + upper_com_x * upper_first_moment_x;
    const wreal upper_base_inertia_zz = upper_origin_inertia_zz
        + elbow_position_x * lower_mass * elbow_position_x;

    /* lower: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal lower_com_x = p[6]; /* m */
    const wreal lower_inertia_zz = p[8]; /* kg m^2 */
    const wreal lower_first_moment_x = lower_mass * lower_com_x;
    const wreal lower_origin_inertia_zz = lower_inertia_zz + lower_com_x * lower_first_moment_x;
    w[1] = lower_first_moment_x;
    w[2] = lower_origin_inertia_zz;

    /* upper: inertia */
    const wreal lower_origin_inertia_zz_plus_upper_base_inertia_zz = lower_origin_inertia_zz
        + upper_base_inertia_zz;
    w[3] = lower_origin_inertia_zz_plus_upper_base_inertia_zz;

    /* parameters as they are */
    w[0] = p[4]; /* elbow.position.x [m] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* elbow: R */
    /* R = R_fixed R_joint(q) */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {elbow_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real elbow_cos = cosine[0];

    /* shared by several: inertia */
    const wreal elbow_position_x = w[0]; /* m */
    const wreal lower_first_moment_x = w[1];
    const real elbow_position_x_times_upper_inertia_mean_moment_x = lower_first_moment_x * elbow_cos
        * elbow_position_x;

    /* upper: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal lower_origin_inertia_zz_plus_upper_base_inertia_zz = w[3];
    /* M: shoulder.u,shoulder.u */
    out[0] = 2.0 * elbow_position_x_times_upper_inertia_mean_moment_x
        + lower_origin_inertia_zz_plus_upper_base_inertia_zz;

    /* M */
    /* M = S . momentum */
    const wreal lower_origin_inertia_zz = w[2];
    const real M_elbow_shoulder = lower_origin_inertia_zz
        + elbow_position_x_times_upper_inertia_mean_moment_x;
    out[1] = M_elbow_shoulder; /* M: shoulder.u,elbow.u */
    out[2] = M_elbow_shoulder; /* M: elbow.u,shoulder.u */

    /* results that are numbers or inputs */
    out[3] = CARDAN_REAL(w[2]); /* M: elbow.u,elbow.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 4, 0, 2, 0, 0, 0, 0, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
