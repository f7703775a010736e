/*
 * inverse_dynamics of whirling_rotor
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 7
 * Operations per call: 23 = 13 mul, 7 add, 3 sub
 * Operations of prepare: 3 = 1 add, 1 mul, 1 sub
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
 * Input udot (2): derivatives of the speeds
 *   udot[0]  x.udot [m/s^2]
 *   udot[1]  y.udot [m/s^2]
 *
 * Output tau (2)
 *   out[0]  x.u.tau [N]
 *   out[1]  y.u.tau [N]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* shared by several: data */
    const wreal uneven = p[4];
    const wreal uneven_times_c10000 = 10000.0 * uneven;

    /* on_x: data */
    const wreal cm10000_minus_uneven_times_c10000 = -10000.0 - uneven_times_c10000;
    w[5] = cm10000_minus_uneven_times_c10000;

    /* on_y: data */
    const wreal cm10000_plus_uneven_times_c10000 = uneven_times_c10000 - 10000.0;
    w[6] = cm10000_plus_uneven_times_c10000;

    /* parameters as they are */
    w[0] = p[0]; /* speed [rad/s] */
    w[1] = p[1]; /* inner [N s/m] */
    w[2] = p[2]; /* outer [N s/m] */
    w[3] = p[3]; /* cubic [N s/m^3] */
    w[4] = p[5]; /* disk.mass [kg] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: data */
    const real x_q = q[0]; /* m */
    const real y_q = q[1]; /* m */
    const wreal outer = w[2]; /* N s/m */
    const wreal cubic = w[3]; /* N s/m^3 */
    const real outer_plus_cubic_times_sum_x_squared_plus_y_squared = outer + cubic * (x_q * x_q
        + y_q * y_q);

    /* disk: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real x_udot = udot[0]; /* m/s^2 */
    const real y_udot = udot[1]; /* m/s^2 */
    const wreal disk_mass = w[4]; /* kg */
    const real disk_f_x = disk_mass * x_udot;
    const real disk_f_y = disk_mass * y_udot;

    /* x: tau */
    /* tau = S . [n; f] - force on the joint */
    const real x_u = u[0]; /* m/s */
    const wreal speed = w[0]; /* rad/s */
    const wreal inner = w[1]; /* N s/m */
    const wreal cm10000_minus_uneven_times_c10000 = w[5];
    /* tau: x.u.tau [N] */
    out[0] = disk_f_x - x_q * cm10000_minus_uneven_times_c10000 + inner * (x_u + speed * y_q)
        + x_u * outer_plus_cubic_times_sum_x_squared_plus_y_squared;

    /* y: tau */
    /* tau = S . [n; f] - force on the joint */
    const real y_u = u[1]; /* m/s */
    const wreal cm10000_plus_uneven_times_c10000 = w[6];
    /* tau: y.u.tau [N] */
    out[1] = disk_f_y - y_q * cm10000_plus_uneven_times_c10000 + inner * (y_u - speed * x_q)
        + y_u * outer_plus_cubic_times_sum_x_squared_plus_y_squared;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 7, 0, 2, 2, 0, 0, 0, 9, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
