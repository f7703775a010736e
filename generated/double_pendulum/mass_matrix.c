/*
 * mass_matrix of double_pendulum
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
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input p (3): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* shared by several: mass */
    const wreal m = p[0]; /* kg */
    const wreal l = p[1]; /* m */
    const wreal half_l = 0.5 * l;
    const wreal upper_minus_first_moment_z = m * half_l;
    w[1] = upper_minus_first_moment_z;

    /* upper: origin inertia, base, inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_origin_inertia_xx = l * l * (0.08333333333333333 * m)
        + half_l * upper_minus_first_moment_z;
    const wreal upper_base_inertia_yy = upper_origin_inertia_xx + m * l * l;
    const wreal upper_origin_inertia_xx_plus_base_inertia_yy = upper_origin_inertia_xx
        + upper_base_inertia_yy;
    w[2] = upper_origin_inertia_xx;
    w[3] = upper_origin_inertia_xx_plus_base_inertia_yy;

    /* parameters as they are */
    w[0] = p[1]; /* l [m] */
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
    const wreal l = w[0]; /* m */
    const wreal upper_minus_first_moment_z = w[1];
    const real l_times_upper_minus_inertia_mean_moment_z = upper_minus_first_moment_z * elbow_cos *
        l;

    /* upper: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal upper_origin_inertia_xx_plus_base_inertia_yy = w[3];
    /* M: shoulder.u,shoulder.u */
    out[0] = 2.0 * l_times_upper_minus_inertia_mean_moment_z
        + upper_origin_inertia_xx_plus_base_inertia_yy;

    /* M */
    /* M = S . momentum */
    const wreal upper_origin_inertia_xx = w[2];
    const real M_elbow_shoulder = upper_origin_inertia_xx
        + l_times_upper_minus_inertia_mean_moment_z;
    out[1] = M_elbow_shoulder; /* M: shoulder.u,elbow.u */
    out[2] = M_elbow_shoulder; /* M: elbow.u,shoulder.u */

    /* results that are numbers or inputs */
    out[3] = CARDAN_REAL(w[2]); /* M: elbow.u,elbow.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 4, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
