/*
 * mass_matrix of sliding_door
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
 *   q[1]  hook [rad]
 *
 * Input p (19): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* lamp: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal lamp_mass = p[8]; /* kg */
    const wreal lamp_com_z = p[9]; /* m */
    const wreal lamp_inertia_yy = p[11]; /* kg m^2 */
    const wreal lamp_first_moment_z = lamp_mass * lamp_com_z;
    const wreal lamp_origin_inertia_yy = lamp_inertia_yy + lamp_com_z * lamp_first_moment_z;
    w[0] = lamp_first_moment_z;
    w[1] = lamp_origin_inertia_yy;

    /* door: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal door_mass = p[1]; /* kg */
    const wreal door_base_mass = door_mass + lamp_mass;
    w[2] = door_base_mass;
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* hook: R */
    /* R = R_fixed R_joint(q) */
    const real hook_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hook_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hook_cos = cosine[0];

    /* M */
    /* M = S . momentum */
    const wreal lamp_first_moment_z = w[0];
    const real M_hook_rail = lamp_first_moment_z * hook_cos;
    out[1] = M_hook_rail; /* M: rail.u,hook.u */
    out[2] = M_hook_rail; /* M: hook.u,rail.u */

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[2]); /* M: rail.u,rail.u */
    out[3] = CARDAN_REAL(w[1]); /* M: hook.u,hook.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 3, 0, 2, 0, 0, 0, 0, 19, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
