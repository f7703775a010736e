/*
 * forward_dynamics of drone
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 0, w 5
 * Operations per call: 58 = 35 mul, 12 add, 7 sub, 2 div, 1 cos, 1 sin
 * Operations of prepare: 1 = 1 div
 *
 * Input q (3): generalized coordinates
 *   q[0]  fly.x [m]
 *   q[1]  fly.y [m]
 *   q[2]  fly.angle [rad]
 *
 * Input r (2): inputs of the model
 *   r[0]  left
 *   r[1]  right
 *
 * Input p (7): parameters, read by prepare_ only
 *
 * Input tau (3): applied generalized forces
 *   tau[0]  fly.u.x.tau [N]
 *   tau[1]  fly.u.y.tau [N]
 *   tau[2]  fly.u.angle.tau [N*m]
 *
 * Output udot (3)
 *   out[0]  fly.u.xdot [m/s^2]
 *   out[1]  fly.u.ydot [m/s^2]
 *   out[2]  fly.u.angledot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* M: D inverse */
    const wreal drone_inertia_yy = p[3]; /* kg m^2 */
    w[4] = 1.0 / drone_inertia_yy; /* M_D_inverse_3 */

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[1]; /* drone.mass [kg] */
    w[2] = p[5]; /* left.frame.position.x [m] */
    w[3] = p[6]; /* right.frame.position.x [m] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* fly: cos, sin */
    const real fly_angle = q[2]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {fly_angle};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real fly_cos = cosine[0];
    const real fly_sin = sine[0];

    /* fly: momentum fz */
    const wreal drone_mass = w[1]; /* kg */
    const real fly_momentum_fz = drone_mass * fly_sin;
    const real fly_momentum_fz_2 = drone_mass * fly_cos;

    /* M: D inverse */
    const real M_1_1 = fly_sin * fly_momentum_fz + fly_cos * fly_momentum_fz_2;
    const real M_D_inverse_2 = 1.0 / M_1_1;

    /* shared by several: M */
    const real fly_M = fly_sin * fly_momentum_fz_2 - fly_cos * fly_momentum_fz;

    /* left: force */
    const real left = r[0];
    const real left_force = left * fly_sin;
    const real left_force_2 = left * fly_cos;
    const real left_force_3 = fly_sin * left_force + fly_cos * left_force_2;

    /* right: force */
    const real right = r[1];
    const real right_force = right * fly_sin;
    const real right_force_2 = right * fly_cos;
    const real right_force_3 = fly_sin * right_force + fly_cos * right_force_2;

    /* drone: n, a, f */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal left_frame_position_x = w[2]; /* m */
    const wreal right_frame_position_x = w[3]; /* m */
    const real drone_n_y = left_frame_position_x * left_force_3
        + right_frame_position_x * right_force_3;
    const real drone_a_x = gravity_z * fly_sin;
    const real drone_f = drone_mass * drone_a_x - fly_cos * left_force + fly_sin * right_force_2;
    const real drone_f_x = fly_sin * left_force_2 - fly_cos * right_force + drone_f;
    const real drone_f_2 = left_force_3 + gravity_z * fly_cos * drone_mass + right_force_3;

    /* fly: tau, drive, drive angle, udot angle */
    const real fly_u_x_tau = tau[0]; /* N */
    const real fly_u_y_tau = tau[1]; /* N */
    const real fly_u_angle_tau = tau[2]; /* N*m */
    const wreal M_D_inverse_3 = w[4];
    const real fly_tau_y = fly_cos * drone_f_x - fly_sin * drone_f_2;
    const real fly_drive_x = fly_u_x_tau + fly_sin * drone_f_x + fly_cos * drone_f_2;
    const real fly_drive_y = fly_u_y_tau - fly_tau_y;
    const real fly_drive_angle = fly_u_angle_tau - drone_n_y;
    out[2] = fly_drive_angle * M_D_inverse_3; /* udot: fly.u.angledot [rad/s^2] */

    /* M: factor, D inverse */
    const real M_factor = fly_M * M_D_inverse_2;
    const real M_D_inverse_1 = 1.0 / (M_1_1 - fly_M * M_factor);

    /* fly: udot */
    const real fly_udot_x = M_D_inverse_1 * (fly_drive_x + fly_drive_y * M_factor);
    out[0] = fly_udot_x; /* udot: fly.u.xdot [m/s^2] */
    out[1] = fly_drive_y * M_D_inverse_2 + M_factor * fly_udot_x; /* udot: fly.u.ydot [m/s^2] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 0, 5, 0, 3, 0, 0, 0, 2, 7, 0, 0, 0, 0, 3, 0, 0, 0, 0};
#endif
