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
    /* common */
    const wreal drone_inertia_xx = p[2]; /* kg m^2 */
    const wreal drone_inertia_yy = p[3]; /* kg m^2 */
    const wreal drone_inertia_zz = p[4]; /* kg m^2 */
    const wreal mul_1 = 0.5 * (drone_inertia_xx + drone_inertia_zz + drone_inertia_yy);

    /* drone: base second moment, inertia force */
    const wreal drone_base_second_moment_xx = mul_1 - drone_inertia_xx;
    const wreal drone_base_second_moment_zz = mul_1 - drone_inertia_zz;
    w[4] = drone_base_second_moment_xx + drone_base_second_moment_zz; /* drone_inertia_force */

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

    /* fly: cos, sin */
    const real fly_angle = q[2]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {fly_angle};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real fly_cos = cosine[0];
    const real fly_sin = sine[0];

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

    /* drone: f, a, n */
    const real fly_u_xdot = udot[0]; /* m/s^2 */
    const real fly_u_ydot = udot[1]; /* m/s^2 */
    const real fly_u_angledot = udot[2]; /* rad/s^2 */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal drone_mass = w[1]; /* kg */
    const wreal left_frame_position_x = w[2]; /* m */
    const wreal right_frame_position_x = w[3]; /* m */
    const wreal drone_inertia_force = w[4];
    const real drone_f = fly_sin * left_force_2 - fly_cos * left_force + (fly_sin * right_force_2
        - fly_cos * right_force);
    const real drone_a_x = fly_u_ydot * fly_cos - fly_u_xdot * fly_sin + gravity_z * fly_sin;
    const real drone_f_x = drone_mass * drone_a_x + drone_f;
    const real drone_a_z = fly_u_xdot * fly_cos + fly_u_ydot * fly_sin - gravity_z * fly_cos;
    const real drone_f_z = drone_mass * drone_a_z - (left_force_3 + right_force_3);
    /* tau: fly.u.angle.tau [N*m] */
    out[2] = left_frame_position_x * left_force_3 + fly_u_angledot * drone_inertia_force
        + right_frame_position_x * right_force_3;

    /* fly: tau */
    out[0] = fly_cos * drone_f_z - fly_sin * drone_f_x; /* tau: fly.u.x.tau [N] */
    out[1] = fly_cos * drone_f_x + fly_sin * drone_f_z; /* tau: fly.u.y.tau [N] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {3, 0, 5, 0, 3, 0, 0, 0, 2, 7, 0, 3, 0, 0, 0, 0, 0, 0, 0};
#endif
