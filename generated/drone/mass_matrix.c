/*
 * mass_matrix of drone
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 9, work 0, w 2
 * Operations per call: 10 = 6 mul, 1 add, 1 cos, 1 sin, 1 sub
 * Operations of prepare: none
 *
 * Input q (3): generalized coordinates
 *   q[0]  fly.x [m]
 *   q[1]  fly.y [m]
 *   q[2]  fly.angle [rad]
 *
 * Input p (7): parameters, read by prepare_ only
 *
 * Output M (3 x 3): out[0 ... 8], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* parameters as they are */
    w[0] = p[1]; /* drone.mass [kg] */
    w[1] = p[3]; /* drone.inertia.yy [kg m^2] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* fly: R */
    /* R = R_fixed R_joint(q) */
    const real fly_angle = q[2]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {fly_angle};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real fly_angle_cos = cosine[0];
    const real fly_angle_sin = sine[0];

    /* momentum */
    /* momentum = composite inertia S */
    const wreal drone_mass = w[0]; /* kg */
    const real momentum_fly_y_fz = drone_mass * fly_angle_sin;
    const real momentum_fly_x_fz = drone_mass * fly_angle_cos;

    /* M */
    /* M = S . momentum */
    const real M_fly_x_fly_x = fly_angle_sin * momentum_fly_y_fz
        + fly_angle_cos * momentum_fly_x_fz;
    out[0] = M_fly_x_fly_x; /* M: fly.u.x,fly.u.x */
    out[4] = M_fly_x_fly_x; /* M: fly.u.y,fly.u.y */

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_fly_y_about_ground_fz = fly_angle_cos * momentum_fly_y_fz
        - fly_angle_sin * momentum_fly_x_fz;
    out[1] = momentum_fly_y_about_ground_fz; /* M: fly.u.x,fly.u.y */
    out[3] = momentum_fly_y_about_ground_fz; /* M: fly.u.y,fly.u.x */

    /* results that are numbers or inputs */
    out[2] = CARDAN_REAL(0.0); /* M: fly.u.x,fly.u.angle */
    out[5] = CARDAN_REAL(0.0); /* M: fly.u.y,fly.u.angle */
    out[6] = CARDAN_REAL(0.0); /* M: fly.u.angle,fly.u.x */
    out[7] = CARDAN_REAL(0.0); /* M: fly.u.angle,fly.u.y */
    out[8] = CARDAN_REAL(w[1]); /* M: fly.u.angle,fly.u.angle */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {9, 0, 2, 0, 3, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
