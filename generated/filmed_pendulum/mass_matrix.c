/*
 * mass_matrix of filmed_pendulum
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 4
 * Operations per call: 6 = 3 mul, 2 add, 1 cos
 * Operations of prepare: 18 = 14 mul, 4 add
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input p (7): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal m1 = p[0]; /* kg */
    const wreal m2 = p[1]; /* kg */
    const wreal l1 = p[2]; /* m */
    const wreal half_l1 = 0.5 * l1;
    const wreal upper_origin_inertia_xx = l1 * l1 * (0.08333333333333333 * m1)
        + m1 * half_l1 * half_l1;
    const wreal upper_base_inertia_yy = upper_origin_inertia_xx + m2 * l1 * l1;

    /* lower: mass, origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal l2 = p[3]; /* m */
    const wreal half_l2 = 0.5 * l2;
    const wreal lower_minus_first_moment_z = m2 * half_l2;
    const wreal lower_origin_inertia_xx = l2 * l2 * (0.08333333333333333 * m2)
        + half_l2 * lower_minus_first_moment_z;
    w[1] = lower_minus_first_moment_z;
    w[2] = lower_origin_inertia_xx;

    /* upper: inertia */
    const wreal lower_origin_inertia_xx_plus_upper_base_inertia_yy = lower_origin_inertia_xx
        + upper_base_inertia_yy;
    w[3] = lower_origin_inertia_xx_plus_upper_base_inertia_yy;

    /* parameters as they are */
    w[0] = p[2]; /* l1 [m] */
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
    const wreal l1 = w[0]; /* m */
    const wreal lower_minus_first_moment_z = w[1];
    const real l1_times_upper_minus_inertia_mean_moment_z = lower_minus_first_moment_z * elbow_cos *
        l1;

    /* upper: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal lower_origin_inertia_xx_plus_upper_base_inertia_yy = w[3];
    /* M: shoulder.u,shoulder.u */
    out[0] = 2.0 * l1_times_upper_minus_inertia_mean_moment_z
        + lower_origin_inertia_xx_plus_upper_base_inertia_yy;

    /* M */
    /* M = S . momentum */
    const wreal lower_origin_inertia_xx = w[2];
    const real M_elbow_shoulder = lower_origin_inertia_xx
        + l1_times_upper_minus_inertia_mean_moment_z;
    out[1] = M_elbow_shoulder; /* M: shoulder.u,elbow.u */
    out[2] = M_elbow_shoulder; /* M: elbow.u,shoulder.u */

    /* results that are numbers or inputs */
    out[3] = CARDAN_REAL(w[2]); /* M: elbow.u,elbow.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 4, 0, 2, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
