/*
 * inverse_dynamics of drone
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 3, work 0, w 5
 * Operations per call: 45 = 27 mul, 10 add, 6 sub, 1 cos, 1 sin
 * Operations of prepare: 6 = 3 add, 2 sub, 1 mul
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
 * Input udot (3): derivatives of the speeds
 *   udot[0]  fly.u.xdot [m/s^2]
 *   udot[1]  fly.u.ydot [m/s^2]
 *   udot[2]  fly.u.angledot [rad/s^2]
 *
 * Output tau (3)
 *   out[0]  fly.u.x.tau [N]
 *   out[1]  fly.u.y.tau [N]
 *   out[2]  fly.u.angle.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* drone: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal drone_inertia_xx = p[2]; /* kg m^2 */
    const wreal drone_inertia_yy = p[3]; /* kg m^2 */
    const wreal drone_inertia_zz = p[4]; /* kg m^2 */
    const wreal drone_base_half_trace = 0.5 * (drone_inertia_xx + drone_inertia_zz
        + drone_inertia_yy);
    const wreal drone_base_second_moment_xx = drone_base_half_trace - drone_inertia_xx;
    const wreal drone_base_second_moment_zz = drone_base_half_trace - drone_inertia_zz;
    const wreal drone_base_second_moment_xx_plus_base_second_moment_zz = drone_base_second_moment_xx
        + drone_base_second_moment_zz;
    w[4] = drone_base_second_moment_xx_plus_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[1]; /* drone.mass [kg] */
    w[2] = p[5]; /* left.frame.position.x [m] */
    w[3] = p[6]; /* right.frame.position.x [m] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* fly: R */
    /* R = R_fixed R_joint(q) */
    const real fly_angle = q[2]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {fly_angle};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real fly_angle_cos = cosine[0];
    const real fly_angle_sin = sine[0];

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
    const real drone_f_z_part = fly_angle_sin * right_force_on_right_frame_x
        + fly_angle_cos * right_force_on_right_frame_z;

    /* drone: a, f, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real fly_u_xdot = udot[0]; /* m/s^2 */
    const real fly_u_ydot = udot[1]; /* m/s^2 */
    const real fly_u_angledot = udot[2]; /* rad/s^2 */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal drone_mass = w[1]; /* kg */
    const wreal left_frame_position_x = w[2]; /* m */
    const wreal right_frame_position_x = w[3]; /* m */
    const wreal drone_base_second_moment_xx_plus_base_second_moment_zz = w[4];
    const real drone_a_x = fly_u_ydot * fly_angle_cos - fly_u_xdot * fly_angle_sin
        + gravity_z * fly_angle_sin;
    const real drone_f_x = fly_angle_sin * left_force_on_left_frame_z
        - fly_angle_cos * left_force_on_left_frame_x
        + (fly_angle_sin * right_force_on_right_frame_z
        - fly_angle_cos * right_force_on_right_frame_x) + drone_mass * drone_a_x;
    const real drone_a_z = fly_u_xdot * fly_angle_cos + fly_u_ydot * fly_angle_sin
        - gravity_z * fly_angle_cos;
    const real drone_f_z = drone_mass * drone_a_z - (drone_n_y_part + drone_f_z_part);
    /* tau: fly.u.angle.tau [N*m] */
    out[2] = left_frame_position_x * drone_n_y_part
        + fly_u_angledot * drone_base_second_moment_xx_plus_base_second_moment_zz
        + right_frame_position_x * drone_f_z_part;

    /* fly: tau */
    /* tau = S . [n; f] - force on the joint */
    out[0] = fly_angle_cos * drone_f_z - fly_angle_sin * drone_f_x; /* tau: fly.u.x.tau [N] */
    out[1] = fly_angle_cos * drone_f_x + fly_angle_sin * drone_f_z; /* tau: fly.u.y.tau [N] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {3, 0, 5, 0, 3, 0, 0, 0, 2, 7, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
