/*
 * mass_matrix of rotor
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 25, work 0, w 6
 * Operations per call: 16 = 7 mul, 2 add, 2 cos, 2 sin, 2 sub, 1 neg
 * Operations of prepare: 3 = 2 sub, 1 add
 *
 * Input q (5): generalized coordinates
 *   q[0]  x [m]
 *   q[1]  y [m]
 *   q[2]  tilt [rad]
 *   q[3]  lean [rad]
 *   q[4]  spin [rad]
 *
 * Input p (6): parameters, read by prepare_ only
 *
 * Output M (5 x 5): out[0 ... 24], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* disk: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal disk_inertia_xx = p[3]; /* kg m^2 */
    const wreal disk_inertia_yy = p[4]; /* kg m^2 */
    const wreal disk_base_inertia_yy = disk_inertia_yy - disk_inertia_xx;
    w[3] = disk_base_inertia_yy;

    /* shaft: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal disk_inertia_zz = p[5]; /* kg m^2 */
    const wreal disk_inertia_xx_plus_base_inertia_yy = disk_inertia_xx + disk_base_inertia_yy;
    const wreal shaft_composite_inertia_zz = disk_inertia_zz - disk_inertia_xx;
    w[4] = disk_inertia_xx_plus_base_inertia_yy;
    w[5] = shaft_composite_inertia_zz;

    /* parameters as they are */
    w[0] = p[2]; /* disk.mass [kg] */
    w[1] = p[3]; /* disk.inertia.xx [kg m^2] */
    w[2] = p[5]; /* disk.inertia.zz [kg m^2] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* zeros among the results; what stands between them follows */
    memset(out + 1, 0, 23 * sizeof(real));

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real lean_q = q[3]; /* rad */
    const real spin_q = q[4]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {spin_q, lean_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real spin_cos = cosine[0];
    const real spin_sin = sine[0];
    const real lean_cos = cosine[1];
    const real lean_sin = sine[1];

    /* shaft: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal disk_base_inertia_yy = w[3];
    const wreal disk_inertia_xx_plus_base_inertia_yy = w[4];
    const real shaft_minus_inertia_shear = disk_base_inertia_yy * spin_sin;
    const real shaft_composite_inertia_xx = spin_sin * shaft_minus_inertia_shear;
    /* M: lean.u,lean.u */
    out[18] = disk_inertia_xx_plus_base_inertia_yy - shaft_composite_inertia_xx;

    /* shared by several: inertia */
    const real c_composite_inertia_xy = -spin_cos * shaft_minus_inertia_shear * lean_cos;
    out[13] = c_composite_inertia_xy; /* M: tilt.u,lean.u */
    out[17] = c_composite_inertia_xy; /* M: lean.u,tilt.u */

    /* c: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal disk_inertia_xx = w[1]; /* kg m^2 */
    const wreal shaft_composite_inertia_zz = w[5];
    /* M: tilt.u,tilt.u */
    out[12] = disk_inertia_xx + shaft_composite_inertia_xx
        + lean_sin * (shaft_composite_inertia_zz - shaft_composite_inertia_xx) * lean_sin;

    /* M */
    /* M = S . momentum */
    const wreal disk_inertia_zz = w[2]; /* kg m^2 */
    const real M_spin_tilt = disk_inertia_zz * lean_sin;
    out[14] = M_spin_tilt; /* M: tilt.u,spin.u */
    out[22] = M_spin_tilt; /* M: spin.u,tilt.u */

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[0]); /* M: x.u,x.u */
    out[6] = CARDAN_REAL(w[0]); /* M: y.u,y.u */
    out[24] = CARDAN_REAL(w[2]); /* M: spin.u,spin.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {25, 0, 6, 0, 5, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
