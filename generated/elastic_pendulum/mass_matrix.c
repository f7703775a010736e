/*
 * mass_matrix of elastic_pendulum
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 3
 * Operations per call: 4 = 2 add, 2 mul
 * Operations of prepare: 3 = 2 mul, 1 add
 *
 * Input q (2): generalized coordinates
 *   q[0]  pivot [rad]
 *   q[1]  slide [m]
 *
 * Input p (10): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* arm: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal arm_mass = p[3]; /* kg */
    const wreal arm_com_z = p[4]; /* m */
    const wreal arm_inertia_yy = p[6]; /* kg m^2 */
    const wreal arm_first_moment_z = arm_mass * arm_com_z;
    const wreal arm_origin_inertia_yy = arm_inertia_yy + arm_com_z * arm_first_moment_z;
    w[1] = arm_origin_inertia_yy;

    /* parameters as they are */
    w[0] = p[0]; /* mass [kg] */
    w[2] = p[8]; /* slide.position.z [m] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* slide: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const real slide_q = q[1]; /* m */
    const wreal slide_position_z = w[2]; /* m */
    const real slide_p_z = slide_position_z + slide_q;

    /* arm: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal mass = w[0]; /* kg */
    const wreal arm_origin_inertia_yy = w[1];
    const real arm_composite_inertia_xx = mass * slide_p_z * slide_p_z;
    out[0] = arm_origin_inertia_yy + arm_composite_inertia_xx; /* M: pivot.u,pivot.u */

    /* results that are numbers or inputs */
    out[1] = CARDAN_REAL(0.0); /* M: pivot.u,slide.u */
    out[2] = CARDAN_REAL(0.0); /* M: slide.u,pivot.u */
    out[3] = CARDAN_REAL(w[0]); /* M: slide.u,slide.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 3, 0, 2, 0, 0, 0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
