/*
 * mass_matrix of dual_spin
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 16, work 0, w 7
 * Operations per call: 9 = 4 add, 3 mul, 1 neg, 1 sub
 * Operations of prepare: 4 = 2 mul, 1 neg, 1 sub
 *
 * Input q (5): generalized coordinates
 *   q[0]  attitude.qw
 *   q[1]  attitude.qx
 *   q[2]  attitude.qy
 *   q[3]  attitude.qz
 *   q[4]  tube [m]
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Output M (4 x 4): out[0 ... 15], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bus: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal bus_inertia_xx = p[2]; /* kg m^2 */
    const wreal tube_position_x = p[5]; /* m */
    const wreal ball_mass = p[6]; /* kg */
    const wreal bus_composite_moment_x = tube_position_x * ball_mass;
    const wreal tube_position_x_times_bus_composite_moment_x = tube_position_x *
        bus_composite_moment_x;
    const wreal bus_composite_inertia_xx_part = bus_inertia_xx
        - tube_position_x_times_bus_composite_moment_x;
    w[3] = bus_composite_moment_x;
    w[4] = tube_position_x_times_bus_composite_moment_x;
    w[5] = bus_composite_inertia_xx_part;

    /* shared by several: M */
    /* M = S . momentum */
    const wreal momentum_tube_about_bus_my = -bus_composite_moment_x;
    w[6] = momentum_tube_about_bus_my;

    /* parameters as they are */
    w[0] = p[3]; /* bus.inertia.yy [kg m^2] */
    w[1] = p[4]; /* bus.inertia.zz [kg m^2] */
    w[2] = p[6]; /* ball.mass [kg] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* bus: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real tube_q = q[4]; /* m */
    const wreal bus_inertia_yy = w[0]; /* kg m^2 */
    const wreal bus_inertia_zz = w[1]; /* kg m^2 */
    const wreal ball_mass = w[2]; /* kg */
    const wreal bus_composite_moment_x = w[3];
    const wreal tube_position_x_times_bus_composite_moment_x = w[4];
    const wreal bus_composite_inertia_xx_part = w[5];
    const real bus_composite_moment_z = ball_mass * tube_q;
    const real tube_times_bus_composite_moment_z = tube_q * bus_composite_moment_z;
    const real bus_composite_inertia_xz = -tube_q * bus_composite_moment_x;
    const real bus_composite_inertia_zz_part = tube_position_x_times_bus_composite_moment_x
        + tube_times_bus_composite_moment_z;
    out[2] = bus_composite_inertia_xz; /* M: attitude.u.x,attitude.u.z */
    out[8] = bus_composite_inertia_xz; /* M: attitude.u.z,attitude.u.x */
    /* M: attitude.u.z,attitude.u.z */
    out[10] = bus_inertia_zz - tube_times_bus_composite_moment_z + bus_composite_inertia_zz_part;
    /* M: attitude.u.x,attitude.u.x */
    out[0] = bus_composite_inertia_zz_part + bus_composite_inertia_xx_part;
    out[5] = bus_inertia_yy + bus_composite_inertia_zz_part; /* M: attitude.u.y,attitude.u.y */

    /* results that are numbers or inputs */
    out[1] = CARDAN_REAL(0.0); /* M: attitude.u.x,attitude.u.y */
    out[3] = CARDAN_REAL(0.0); /* M: attitude.u.x,tube.u */
    out[4] = CARDAN_REAL(0.0); /* M: attitude.u.y,attitude.u.x */
    out[6] = CARDAN_REAL(0.0); /* M: attitude.u.y,attitude.u.z */
    out[7] = CARDAN_REAL(w[6]); /* M: attitude.u.y,tube.u */
    out[9] = CARDAN_REAL(0.0); /* M: attitude.u.z,attitude.u.y */
    out[11] = CARDAN_REAL(0.0); /* M: attitude.u.z,tube.u */
    out[12] = CARDAN_REAL(0.0); /* M: tube.u,attitude.u.x */
    out[13] = CARDAN_REAL(w[6]); /* M: tube.u,attitude.u.y */
    out[14] = CARDAN_REAL(0.0); /* M: tube.u,attitude.u.z */
    out[15] = CARDAN_REAL(w[2]); /* M: tube.u,tube.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {16, 0, 7, 0, 5, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
