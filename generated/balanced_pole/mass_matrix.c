/*
 * mass_matrix of balanced_pole
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 3
 * Operations per call: 2 = 1 cos, 1 mul
 * Operations of prepare: 4 = 2 add, 2 mul
 *
 * Input q (2): generalized coordinates
 *   q[0]  rail [m]
 *   q[1]  hinge [rad]
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* pole: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal pole_mass = p[5]; /* kg */
    const wreal pole_com_z = p[6]; /* m */
    const wreal pole_inertia_yy = p[8]; /* kg m^2 */
    const wreal pole_first_moment_z = pole_mass * pole_com_z;
    const wreal pole_origin_inertia_yy = pole_inertia_yy + pole_com_z * pole_first_moment_z;
    w[0] = pole_first_moment_z;
    w[1] = pole_origin_inertia_yy;

    /* cart: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal cart_mass = p[1]; /* kg */
    const wreal cart_base_mass = cart_mass + pole_mass;
    w[2] = cart_base_mass;
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* hinge: R */
    /* R = R_fixed R_joint(q) */
    const real hinge_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hinge_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hinge_cos = cosine[0];

    /* cart: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal pole_first_moment_z = w[0];
    const real cart_composite_moment_z = pole_first_moment_z * hinge_cos;
    out[1] = cart_composite_moment_z; /* M: rail.u,hinge.u */
    out[2] = cart_composite_moment_z; /* M: hinge.u,rail.u */

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[2]); /* M: rail.u,rail.u */
    out[3] = CARDAN_REAL(w[1]); /* M: hinge.u,hinge.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 3, 0, 2, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
