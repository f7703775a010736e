/*
 * forward_dynamics of dual_spin
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 4, work 0, w 16
 * Operations per call: 82 = 46 mul, 17 add, 16 sub, 3 div
 * Operations of prepare: 12 = 5 mul, 4 sub, 2 add, 1 div
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
 * Input tau (4): applied generalized forces
 *   tau[0]  attitude.u.x.tau [N*m]
 *   tau[1]  attitude.u.y.tau [N*m]
 *   tau[2]  attitude.u.z.tau [N*m]
 *   tau[3]  tube.u.tau [N]
 *
 * Output udot (4)
 *   out[0]  attitude.u.xdot [rad/s^2]
 *   out[1]  attitude.u.ydot [rad/s^2]
 *   out[2]  attitude.u.zdot [rad/s^2]
 *   out[3]  tube.udot [m/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bus: base, composite, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal bus_inertia_xx = p[2]; /* kg m^2 */
    const wreal bus_inertia_yy = p[3]; /* kg m^2 */
    const wreal bus_inertia_zz = p[4]; /* kg m^2 */
    const wreal tube_position_x = p[5]; /* m */
    const wreal ball_mass = p[6]; /* kg */
    const wreal bus_base_half_trace = 0.5 * (bus_inertia_xx + bus_inertia_zz + bus_inertia_yy);
    const wreal bus_base_second_moment_xx = bus_base_half_trace - bus_inertia_xx;
    const wreal bus_base_second_moment_yy = bus_base_half_trace - bus_inertia_yy;
    const wreal bus_base_second_moment_zz = bus_base_half_trace - bus_inertia_zz;
    const wreal bus_composite_moment_x = tube_position_x * ball_mass;
    const wreal tube_position_x_times_bus_composite_moment_x = tube_position_x *
        bus_composite_moment_x;
    const wreal bus_composite_inertia_xx_part = bus_inertia_xx
        - tube_position_x_times_bus_composite_moment_x;
    w[7] = bus_base_second_moment_xx;
    w[8] = bus_base_second_moment_yy;
    w[9] = bus_base_second_moment_zz;
    w[10] = bus_composite_moment_x;
    w[11] = tube_position_x_times_bus_composite_moment_x;
    w[12] = bus_composite_inertia_xx_part;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_tube = 1.0 / ball_mass;
    const wreal M_minus_factor_L_tube_attitude_y = bus_composite_moment_x * M_factor_D_inverse_tube;
    const wreal M_factor_D_attitude_y_part = bus_composite_moment_x *
        M_minus_factor_L_tube_attitude_y;
    w[13] = M_factor_D_inverse_tube;
    w[14] = M_minus_factor_L_tube_attitude_y;
    w[15] = M_factor_D_attitude_y_part;

    /* parameters as they are */
    w[0] = p[0]; /* hs [N m s] */
    w[1] = p[3]; /* bus.inertia.yy [kg m^2] */
    w[2] = p[4]; /* bus.inertia.zz [kg m^2] */
    w[3] = p[5]; /* tube.position.x [m] */
    w[4] = p[6]; /* ball.mass [kg] */
    w[5] = p[7]; /* oil.stiffness [N/m] */
    w[6] = p[8]; /* oil.damping [N*s/m] */
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

    /* bus: composite, inertia, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const real tube_q = q[4]; /* m */
    const real attitude_u_x = u[0]; /* rad/s */
    const real attitude_u_y = u[1]; /* rad/s */
    const real attitude_u_z = u[2]; /* rad/s */
    const wreal bus_inertia_yy = w[1]; /* kg m^2 */
    const wreal bus_inertia_zz = w[2]; /* kg m^2 */
    const wreal ball_mass = w[4]; /* kg */
    const wreal bus_composite_moment_x = w[10];
    const wreal tube_position_x_times_bus_composite_moment_x = w[11];
    const wreal bus_composite_inertia_xx_part = w[12];
    const real bus_composite_moment_z = ball_mass * tube_q;
    const real bus_minus_composite_inertia_xz = tube_q * bus_composite_moment_x;
    const real tube_times_bus_composite_moment_z = tube_q * bus_composite_moment_z;
    const real bus_composite_inertia_xx_part_2 = tube_position_x_times_bus_composite_moment_x
        + tube_times_bus_composite_moment_z;
    const real bus_composite_inertia_xx = bus_composite_inertia_xx_part_2
        + bus_composite_inertia_xx_part;
    const real bus_composite_inertia_yy = bus_inertia_yy + bus_composite_inertia_xx_part_2;
    const real bus_composite_inertia_zz = bus_inertia_zz - tube_times_bus_composite_moment_z
        + bus_composite_inertia_xx_part_2;
    const real bus_U_xy = attitude_u_x * attitude_u_y;
    const real bus_U_xz = attitude_u_x * attitude_u_z;
    const real bus_U_yz = attitude_u_y * attitude_u_z;

    /* shared by several: U */
    /* U = [alpha] + [omega][omega] */
    const real attitude_u_y_squared = attitude_u_y * attitude_u_y;

    /* ball: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real tube_u = u[3]; /* m/s */
    const wreal tube_position_x = w[3]; /* m */
    const real ball_a_z = tube_position_x * bus_U_xz - tube_q * (attitude_u_x * attitude_u_x
        + attitude_u_y_squared);
    const real ball_a_x = attitude_u_y * tube_u * 2.0 + tube_q * bus_U_xz
        - tube_position_x * (attitude_u_y_squared + attitude_u_z * attitude_u_z);
    const real ball_a_y = tube_position_x * bus_U_xy + tube_q * bus_U_yz
        - attitude_u_x * tube_u * 2.0;
    const real ball_f_x = ball_mass * ball_a_x;
    const real ball_f_y = ball_mass * ball_a_y;
    const real ball_f_z = ball_mass * ball_a_z;

    /* bus: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal hs = w[0]; /* N m s */
    const wreal bus_base_second_moment_xx = w[7];
    const wreal bus_base_second_moment_yy = w[8];
    const wreal bus_base_second_moment_zz = w[9];
    const real bus_n_x = hs * attitude_u_y + bus_base_second_moment_yy * bus_U_yz
        - bus_base_second_moment_zz * bus_U_yz - tube_q * ball_f_y;
    const real bus_n_y = bus_base_second_moment_zz * bus_U_xz - hs * attitude_u_x
        - bus_base_second_moment_xx * bus_U_xz + tube_q * ball_f_x - tube_position_x * ball_f_z;
    const real bus_n_z = bus_base_second_moment_xx * bus_U_xy
        - bus_base_second_moment_yy * bus_U_xy + tube_position_x * ball_f_y;

    /* tube: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real tube_u_tau = tau[3]; /* N */
    const wreal oil_stiffness = w[5]; /* N/m */
    const wreal oil_damping = w[6]; /* N*s/m */
    const real tube_tau = tube_q * oil_stiffness + tube_u * oil_damping + ball_f_z;
    const real tube_drive = tube_u_tau - tube_tau;

    /* attitude: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real attitude_u_x_tau = tau[0]; /* N*m */
    const real attitude_u_y_tau = tau[1]; /* N*m */
    const real attitude_u_z_tau = tau[2]; /* N*m */
    const wreal M_minus_factor_L_tube_attitude_y = w[14];
    const wreal M_factor_D_attitude_y_part = w[15];
    const real attitude_drive_x = attitude_u_x_tau - bus_n_x;
    const real attitude_drive_y = attitude_u_y_tau - bus_n_y;
    const real attitude_drive_z = attitude_u_z_tau - bus_n_z;
    const real attitude_udot_y = 1.0 / (bus_composite_inertia_yy
        - M_factor_D_attitude_y_part) * (attitude_drive_y
        + tube_drive * M_minus_factor_L_tube_attitude_y);
    out[1] = attitude_udot_y; /* udot: attitude.u.ydot [rad/s^2] */

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const real M_factor_D_inverse_attitude_z = 1.0 / bus_composite_inertia_zz;
    const real M_minus_factor_L_attitude_z_attitude_x = bus_minus_composite_inertia_xz *
        M_factor_D_inverse_attitude_z;

    /* attitude: udot */
    /* udot = M⁻¹ drive */
    const real attitude_udot_x = 1.0 / (bus_composite_inertia_xx
        - bus_minus_composite_inertia_xz * M_minus_factor_L_attitude_z_attitude_x) *
        (attitude_drive_x + attitude_drive_z * M_minus_factor_L_attitude_z_attitude_x);
    out[0] = attitude_udot_x; /* udot: attitude.u.xdot [rad/s^2] */
    /* udot: attitude.u.zdot [rad/s^2] */
    out[2] = attitude_drive_z * M_factor_D_inverse_attitude_z
        + M_minus_factor_L_attitude_z_attitude_x * attitude_udot_x;

    /* tube: udot */
    /* udot = M⁻¹ drive */
    const wreal M_factor_D_inverse_tube = w[13];
    /* udot: tube.udot [m/s^2] */
    out[3] = tube_drive * M_factor_D_inverse_tube
        + M_minus_factor_L_tube_attitude_y * attitude_udot_y;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {4, 0, 16, 0, 5, 4, 0, 0, 0, 9, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0};
#endif
