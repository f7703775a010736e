/*
 * mass_matrix of bucket
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 2
 * Operations per call: 7 = 4 mul, 1 add, 1 cos, 1 sin
 * Operations of prepare: 8 = 7 mul, 1 add
 *
 * Input q (2): generalized coordinates
 *   q[0]  hang.angle1 [rad]
 *   q[1]  hang.angle2 [rad]
 *
 * Input p (4): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bucket: mass, origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal load = p[0]; /* kg */
    const wreal rope = p[1]; /* m */
    const wreal size = p[2]; /* m */
    const wreal size_squared = size * size;
    const wreal bucket_origin_inertia_zz = 0.5 * load * size_squared;
    const wreal bucket_origin_inertia_xx = 0.3333333333333333 * load * size_squared
        + load * rope * rope;
    w[0] = bucket_origin_inertia_zz;
    w[1] = bucket_origin_inertia_xx;
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* hang: R */
    /* R = R_fixed R_joint(q) */
    const real hang_angle2 = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hang_angle2};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hang_angle2_cos = cosine[0];
    const real hang_angle2_sin = sine[0];

    /* momentum */
    /* momentum = composite inertia S */
    const wreal bucket_origin_inertia_zz = w[0];
    const wreal bucket_origin_inertia_xx = w[1];
    const real momentum_hang_angle1_mx = bucket_origin_inertia_xx * hang_angle2_cos;
    const real momentum_hang_angle1_mz = bucket_origin_inertia_zz * hang_angle2_sin;

    /* M */
    /* M = S . momentum */
    /* M: hang.u.angle1,hang.u.angle1 */
    out[0] = hang_angle2_cos * momentum_hang_angle1_mx + hang_angle2_sin * momentum_hang_angle1_mz;

    /* results that are numbers or inputs */
    out[1] = CARDAN_REAL(0.0); /* M: hang.u.angle1,hang.u.angle2 */
    out[2] = CARDAN_REAL(0.0); /* M: hang.u.angle2,hang.u.angle1 */
    out[3] = CARDAN_REAL(w[1]); /* M: hang.u.angle2,hang.u.angle2 */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 2, 0, 2, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
