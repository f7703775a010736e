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
    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal drone_inertia_yy = p[3]; /* kg m^2 */
    const wreal M_factor_D_inverse_fly_angle = 1.0 / drone_inertia_yy;
    w[4] = M_factor_D_inverse_fly_angle;

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
    const wreal drone_mass = w[1]; /* kg */
    const real momentum_fly_y_fz = drone_mass * fly_angle_sin;
    const real momentum_fly_x_fz = drone_mass * fly_angle_cos;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const real M_fly_x_fly_x = fly_angle_sin * momentum_fly_y_fz
        + fly_angle_cos * momentum_fly_x_fz;
    const real M_factor_D_inverse_fly_y = 1.0 / M_fly_x_fly_x;

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_fly_x_about_ground_fx = fly_angle_sin * momentum_fly_x_fz
        - fly_angle_cos * momentum_fly_y_fz;

    /* left: force */
    /* force = R (its components) at the origin */
    const real left = r[0];
    const real left_force_on_left_frame_x = left * fly_angle_sin;
    const real left_force_on_left_frame_z = left * fly_angle_cos;
    const real drone_n_y_part = fly_angle_sin * left_force_on_left_frame_x
        + fly_angle_cos * left_force_on_left_frame_z;

    /* right: force */
    /* force = R (its components) at the origin */
    const real right = r[1];
    const real right_force_on_right_frame_x = right * fly_angle_sin;
    const real right_force_on_right_frame_z = right * fly_angle_cos;
    const real drone_n_y_part_2 = fly_angle_sin * right_force_on_right_frame_x
        + fly_angle_cos * right_force_on_right_frame_z;

    /* drone: n, a, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal left_frame_position_x = w[2]; /* m */
    const wreal right_frame_position_x = w[3]; /* m */
    const real drone_n_y = left_frame_position_x * drone_n_y_part
        + right_frame_position_x * drone_n_y_part_2;
    const real drone_a_x = gravity_z * fly_angle_sin;
    const real drone_f_x = fly_angle_sin * left_force_on_left_frame_z
        - fly_angle_cos * right_force_on_right_frame_x + (drone_mass * drone_a_x
        - fly_angle_cos * left_force_on_left_frame_x
        + fly_angle_sin * right_force_on_right_frame_z);
    const real drone_minus_f_z = drone_n_y_part + gravity_z * fly_angle_cos * drone_mass
        + drone_n_y_part_2;

    /* fly: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real fly_u_x_tau = tau[0]; /* N */
    const real fly_u_y_tau = tau[1]; /* N */
    const real fly_u_angle_tau = tau[2]; /* N*m */
    const wreal M_factor_D_inverse_fly_angle = w[4];
    const real fly_tau_y = fly_angle_cos * drone_f_x - fly_angle_sin * drone_minus_f_z;
    const real fly_drive_x = fly_u_x_tau + fly_angle_sin * drone_f_x
        + fly_angle_cos * drone_minus_f_z;
    const real fly_drive_y = fly_u_y_tau - fly_tau_y;
    const real fly_drive_angle = fly_u_angle_tau - drone_n_y;
    out[2] = fly_drive_angle * M_factor_D_inverse_fly_angle; /* udot: fly.u.angledot [rad/s^2] */

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const real M_minus_factor_L_fly_y_fly_x = momentum_fly_x_about_ground_fx *
        M_factor_D_inverse_fly_y;

    /* fly: udot */
    /* udot = M⁻¹ drive */
    const real fly_udot_x = 1.0 / (M_fly_x_fly_x
        - momentum_fly_x_about_ground_fx * M_minus_factor_L_fly_y_fly_x) * (fly_drive_x
        + fly_drive_y * M_minus_factor_L_fly_y_fly_x);
    out[0] = fly_udot_x; /* udot: fly.u.xdot [m/s^2] */
    /* udot: fly.u.ydot [m/s^2] */
    out[1] = fly_drive_y * M_factor_D_inverse_fly_y + M_minus_factor_L_fly_y_fly_x * fly_udot_x;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 0, 5, 0, 3, 0, 0, 0, 2, 7, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0};
#endif
