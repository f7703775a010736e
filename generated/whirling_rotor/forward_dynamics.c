/*
 * forward_dynamics of whirling_rotor
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 7
 * Operations per call: 23 = 13 mul, 5 add, 5 sub
 * Operations of prepare: 4 = 1 add, 1 div, 1 mul, 1 sub
 *
 * Input q (2): generalized coordinates
 *   q[0]  x [m]
 *   q[1]  y [m]
 *
 * Input u (2): generalized speeds
 *   u[0]  x.u [m/s]
 *   u[1]  y.u [m/s]
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  x.u.tau [N]
 *   tau[1]  y.u.tau [N]
 *
 * Output udot (2)
 *   out[0]  x.udot [m/s^2]
 *   out[1]  y.udot [m/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* shared by several: data */
    const wreal uneven = p[4];
    const wreal uneven_times_c10000 = 10000.0 * uneven;

    /* on_x: data */
    const wreal cm10000_minus_uneven_times_c10000 = -10000.0 - uneven_times_c10000;
    w[4] = cm10000_minus_uneven_times_c10000;

    /* on_y: data */
    const wreal cm10000_plus_uneven_times_c10000 = uneven_times_c10000 - 10000.0;
    w[5] = cm10000_plus_uneven_times_c10000;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal disk_mass = p[5]; /* kg */
    const wreal M_factor_D_inverse_x = 1.0 / disk_mass;
    w[6] = M_factor_D_inverse_x;

    /* parameters as they are */
    w[0] = p[0]; /* speed [rad/s] */
    w[1] = p[1]; /* inner [N s/m] */
    w[2] = p[2]; /* outer [N s/m] */
    w[3] = p[3]; /* cubic [N s/m^3] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: data */
    const real x_q = q[0]; /* m */
    const real y_q = q[1]; /* m */
    const wreal outer = w[2]; /* N s/m */
    const wreal cubic = w[3]; /* N s/m^3 */
    const real outer_plus_cubic_times_sum_x_squared_plus_y_squared = outer + cubic * (x_q * x_q
        + y_q * y_q);

    /* x: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real x_u_tau = tau[0]; /* N */
    const real x_u = u[0]; /* m/s */
    const wreal speed = w[0]; /* rad/s */
    const wreal inner = w[1]; /* N s/m */
    const wreal cm10000_minus_uneven_times_c10000 = w[4];
    const wreal M_factor_D_inverse_x = w[6];
    const real x_drive = x_q * cm10000_minus_uneven_times_c10000 + x_u_tau - inner * (x_u
        + speed * y_q) - x_u * outer_plus_cubic_times_sum_x_squared_plus_y_squared;
    out[0] = x_drive * M_factor_D_inverse_x; /* udot: x.udot [m/s^2] */

    /* y: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real y_u_tau = tau[1]; /* N */
    const real y_u = u[1]; /* m/s */
    const wreal cm10000_plus_uneven_times_c10000 = w[5];
    const real y_drive = y_q * cm10000_plus_uneven_times_c10000 + y_u_tau - inner * (y_u
        - speed * x_q) - y_u * outer_plus_cubic_times_sum_x_squared_plus_y_squared;
    out[1] = y_drive * M_factor_D_inverse_x; /* udot: y.udot [m/s^2] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 7, 0, 2, 2, 0, 0, 0, 9, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
