/*
 * inverse_dynamics of dual_spin
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 8
 * Operations per call: 58 = 33 mul, 13 add, 12 sub
 * Operations of prepare: 6 = 3 sub, 2 add, 1 mul
 *
 * Input q (5): generalized coordinates
 *   q[0]  attitude.qw
 *   q[1]  attitude.qx
 *   q[2]  attitude.qy
 *   q[3]  attitude.qz
 *   q[4]  tube [m]
 *
 * Input u (4): generalized speeds
 *   u[0]  attitude.u.x [rad/s]
 *   u[1]  attitude.u.y [rad/s]
 *   u[2]  attitude.u.z [rad/s]
 *   u[3]  tube.u [m/s]
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Input udot (4): derivatives of the speeds
 *   udot[0]  attitude.u.xdot [rad/s^2]
 *   udot[1]  attitude.u.ydot [rad/s^2]
 *   udot[2]  attitude.u.zdot [rad/s^2]
 *   udot[3]  tube.udot [m/s^2]
 *
 * Output tau (4)
 *   out[0]  attitude.u.x.tau [N*m]
 *   out[1]  attitude.u.y.tau [N*m]
 *   out[2]  attitude.u.z.tau [N*m]
 *   out[3]  tube.u.tau [N]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bus: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal bus_inertia_xx = p[2]; /* kg m^2 */
    const wreal bus_inertia_yy = p[3]; /* kg m^2 */
    const wreal bus_inertia_zz = p[4]; /* kg m^2 */
    const wreal bus_base_half_trace = 0.5 * (bus_inertia_xx + bus_inertia_zz + bus_inertia_yy);
    const wreal bus_base_second_moment_xx = bus_base_half_trace - bus_inertia_xx;
    const wreal bus_base_second_moment_yy = bus_base_half_trace - bus_inertia_yy;
    const wreal bus_base_second_moment_zz = bus_base_half_trace - bus_inertia_zz;
    w[5] = bus_base_second_moment_xx;
    w[6] = bus_base_second_moment_yy;
    w[7] = bus_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[0]; /* hs [N m s] */
    w[1] = p[5]; /* tube.position.x [m] */
    w[2] = p[6]; /* ball.mass [kg] */
    w[3] = p[7]; /* oil.stiffness [N/m] */
    w[4] = p[8]; /* oil.damping [N*s/m] */
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

    /* shared by several: U */
    /* U = [alpha] + [omega][omega] */
    const real attitude_u_x = u[0]; /* rad/s */
    const real attitude_u_y = u[1]; /* rad/s */
    const real attitude_u_z = u[2]; /* rad/s */
    const real attitude_u_y_squared = attitude_u_y * attitude_u_y;
    const real attitude_u_x_times_u_y = attitude_u_x * attitude_u_y;
    const real attitude_u_x_times_u_z = attitude_u_x * attitude_u_z;
    const real attitude_u_y_times_u_z = attitude_u_y * attitude_u_z;

    /* bus: U */
    /* U = [alpha] + [omega][omega] */
    const real attitude_u_xdot = udot[0]; /* rad/s^2 */
    const real attitude_u_ydot = udot[1]; /* rad/s^2 */
    const real attitude_u_zdot = udot[2]; /* rad/s^2 */
    const real bus_U_xy = attitude_u_x_times_u_y - attitude_u_zdot;
    const real bus_U_yx = attitude_u_zdot + attitude_u_x_times_u_y;
    const real bus_U_xz = attitude_u_ydot + attitude_u_x_times_u_z;
    const real bus_U_zx = attitude_u_x_times_u_z - attitude_u_ydot;
    const real bus_U_yz = attitude_u_y_times_u_z - attitude_u_xdot;
    const real bus_U_zy = attitude_u_xdot + attitude_u_y_times_u_z;

    /* ball: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real tube_q = q[4]; /* m */
    const real tube_u = u[3]; /* m/s */
    const real tube_udot = udot[3]; /* m/s^2 */
    const wreal tube_position_x = w[1]; /* m */
    const wreal ball_mass = w[2]; /* kg */
    const real ball_a_x = attitude_u_y * tube_u * 2.0 + tube_q * bus_U_xz
        - tube_position_x * (attitude_u_y_squared + attitude_u_z * attitude_u_z);
    const real ball_f_x = ball_mass * ball_a_x;
    const real ball_a_y = tube_position_x * bus_U_yx - attitude_u_x * tube_u * 2.0
        + tube_q * bus_U_yz;
    const real ball_f_y = ball_mass * ball_a_y;
    const real ball_a_z = tube_udot + tube_position_x * bus_U_zx
        - tube_q * (attitude_u_x * attitude_u_x + attitude_u_y_squared);
    const real ball_f_z = ball_mass * ball_a_z;

    /* tube: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal oil_stiffness = w[3]; /* N/m */
    const wreal oil_damping = w[4]; /* N*s/m */
    out[3] = tube_q * oil_stiffness + tube_u * oil_damping + ball_f_z; /* tau: tube.u.tau [N] */

    /* bus: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal hs = w[0]; /* N m s */
    const wreal bus_base_second_moment_xx = w[5];
    const wreal bus_base_second_moment_yy = w[6];
    const wreal bus_base_second_moment_zz = w[7];
    /* tau: attitude.u.y.tau [N*m] */
    out[1] = bus_base_second_moment_zz * bus_U_xz - hs * attitude_u_x
        - bus_base_second_moment_xx * bus_U_zx + tube_q * ball_f_x - tube_position_x * ball_f_z;
    /* tau: attitude.u.x.tau [N*m] */
    out[0] = hs * attitude_u_y + bus_base_second_moment_yy * bus_U_zy
        - bus_base_second_moment_zz * bus_U_yz - tube_q * ball_f_y;
    /* tau: attitude.u.z.tau [N*m] */
    out[2] = bus_base_second_moment_xx * bus_U_yx - bus_base_second_moment_yy * bus_U_xy
        + tube_position_x * ball_f_y;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {4, 0, 8, 0, 5, 4, 0, 0, 0, 9, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
