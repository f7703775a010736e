/*
 * mass_matrix of four_bar
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 9, work 0, w 5
 * Operations per call: 6 = 3 mul, 2 add, 1 cos
 * Operations of prepare: 13 = 8 mul, 5 add
 *
 * Input q (3): generalized coordinates
 *   q[0]  A [rad]
 *   q[1]  B [rad]
 *   q[2]  D [rad]
 *
 * Input p (20): parameters, read by prepare_ only
 *
 * Output M (3 x 3): out[0 ... 8], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* crank: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal crank_mass = p[1]; /* kg */
    const wreal crank_com_x = p[2]; /* m */
    const wreal crank_inertia_zz = p[5]; /* kg m^2 */
    const wreal B_position_x = p[6]; /* m */
    const wreal coupler_mass = p[7]; /* kg */
    const wreal crank_first_moment_x = crank_mass * crank_com_x;
    const wreal crank_origin_inertia_zz = crank_inertia_zz + crank_com_x * crank_first_moment_x;
    const wreal crank_base_inertia_zz = crank_origin_inertia_zz
        + B_position_x * coupler_mass * B_position_x;

    /* coupler: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal coupler_com_x = p[8]; /* m */
    const wreal coupler_inertia_zz = p[11]; /* kg m^2 */
    const wreal coupler_first_moment_x = coupler_mass * coupler_com_x;
    const wreal coupler_origin_inertia_zz = coupler_inertia_zz
        + coupler_com_x * coupler_first_moment_x;
    w[1] = coupler_first_moment_x;
    w[2] = coupler_origin_inertia_zz;

    /* rocker: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal rocker_mass = p[13]; /* kg */
    const wreal rocker_com_x = p[14]; /* m */
    const wreal rocker_inertia_zz = p[17]; /* kg m^2 */
    const wreal rocker_first_moment_x = rocker_mass * rocker_com_x;
    const wreal rocker_origin_inertia_zz = rocker_inertia_zz + rocker_com_x * rocker_first_moment_x;
    w[3] = rocker_origin_inertia_zz;

    /* crank: inertia */
    const wreal coupler_origin_inertia_zz_plus_crank_base_inertia_zz = coupler_origin_inertia_zz
        + crank_base_inertia_zz;
    w[4] = coupler_origin_inertia_zz_plus_crank_base_inertia_zz;

    /* parameters as they are */
    w[0] = p[6]; /* B.position.x [m] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* B: R */
    /* R = R_fixed R_joint(q) */
    const real B_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {B_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real B_cos = cosine[0];

    /* shared by several: inertia */
    const wreal B_position_x = w[0]; /* m */
    const wreal coupler_first_moment_x = w[1];
    const real B_position_x_times_crank_inertia_mean_moment_x = coupler_first_moment_x * B_cos *
        B_position_x;

    /* crank: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal coupler_origin_inertia_zz_plus_crank_base_inertia_zz = w[4];
    /* M: A.u,A.u */
    out[0] = 2.0 * B_position_x_times_crank_inertia_mean_moment_x
        + coupler_origin_inertia_zz_plus_crank_base_inertia_zz;

    /* M */
    /* M = S . momentum */
    const wreal coupler_origin_inertia_zz = w[2];
    const real M_B_A = coupler_origin_inertia_zz + B_position_x_times_crank_inertia_mean_moment_x;
    out[1] = M_B_A; /* M: A.u,B.u */
    out[3] = M_B_A; /* M: B.u,A.u */

    /* results that are numbers or inputs */
    out[2] = CARDAN_REAL(0.0); /* M: A.u,D.u */
    out[4] = CARDAN_REAL(w[2]); /* M: B.u,B.u */
    out[5] = CARDAN_REAL(0.0); /* M: B.u,D.u */
    out[6] = CARDAN_REAL(0.0); /* M: D.u,A.u */
    out[7] = CARDAN_REAL(0.0); /* M: D.u,B.u */
    out[8] = CARDAN_REAL(w[3]); /* M: D.u,D.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {9, 0, 5, 0, 3, 0, 0, 0, 0, 20, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
