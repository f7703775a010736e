/*
 * inverse_dynamics of sliding_door
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 6
 * Operations per call: 29 = 12 mul, 5 add, 4 select, 2 eq, 2 lt, 2 sub, 1 cos, 1 sin
 * Operations of prepare: 11 = 6 add, 3 mul, 2 sub
 *
 * Input q (2): generalized coordinates
 *   q[0]  rail [m]
 *   q[1]  hook [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  rail.u [m/s]
 *   u[1]  hook.u [rad/s]
 *
 * Input s (4): discrete states
 *   s[0]  friction
 *   s[1]  ends
 *   s[2]  motor.learned
 *   s[3]  motor.force
 *
 * Input p (19): parameters, read by prepare_ only
 *
 * Input udot (2): derivatives of the speeds
 *   udot[0]  rail.udot [m/s^2]
 *   udot[1]  hook.udot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  rail.u.tau [N]
 *   out[1]  hook.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* lamp: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal lamp_mass = p[8]; /* kg */
    const wreal lamp_com_z = p[9]; /* m */
    const wreal lamp_inertia_xx = p[10]; /* kg m^2 */
    const wreal lamp_inertia_yy = p[11]; /* kg m^2 */
    const wreal lamp_inertia_zz = p[12]; /* kg m^2 */
    const wreal lamp_first_moment_z = lamp_mass * lamp_com_z;
    const wreal lamp_com_z_times_first_moment_z = lamp_com_z * lamp_first_moment_z;
    const wreal lamp_origin_inertia_xx = lamp_inertia_xx + lamp_com_z_times_first_moment_z;
    const wreal lamp_origin_inertia_yy = lamp_inertia_yy + lamp_com_z_times_first_moment_z;
    const wreal lamp_base_half_trace = 0.5 * (lamp_inertia_zz + lamp_origin_inertia_xx
        + lamp_origin_inertia_yy);
    const wreal lamp_base_second_moment_xx = lamp_base_half_trace - lamp_origin_inertia_xx;
    const wreal lamp_base_second_moment_zz = lamp_base_half_trace - lamp_inertia_zz;
    const wreal lamp_base_second_moment_xx_plus_base_second_moment_zz = lamp_base_second_moment_xx +
        lamp_base_second_moment_zz;
    w[1] = lamp_first_moment_z;
    w[5] = lamp_base_second_moment_xx_plus_base_second_moment_zz;

    /* door: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal door_mass = p[1]; /* kg */
    const wreal door_base_mass = door_mass + lamp_mass;
    w[4] = door_base_mass;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[2] = p[13]; /* friction.coulomb [N] */
    w[3] = p[15]; /* friction.viscous [N*s/m] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* hook: R */
    /* R = R_fixed R_joint(q) */
    const real hook_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hook_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hook_cos = cosine[0];
    const real hook_sin = sine[0];

    /* lamp: a, n, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real rail_udot = udot[0]; /* m/s^2 */
    const real hook_udot = udot[1]; /* rad/s^2 */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal lamp_first_moment_z = w[1];
    const wreal lamp_base_second_moment_xx_plus_base_second_moment_zz = w[5];
    const real lamp_a_x = rail_udot * hook_cos + gravity_z * hook_sin;
    const real lamp_f_x = lamp_first_moment_z * hook_udot;
    /* tau: hook.u.tau [N*m] */
    out[1] = hook_udot * lamp_base_second_moment_xx_plus_base_second_moment_zz
        + lamp_first_moment_z * lamp_a_x;

    /* door: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real hook_u = u[1]; /* rad/s */
    const wreal door_base_mass = w[4];
    const real door_f_x = door_base_mass * rail_udot + hook_cos * lamp_f_x
        - hook_u * hook_u * lamp_first_moment_z * hook_sin;

    /* rail: tau */
    /* tau = S . [n; f] - force on the joint */
    const real friction = s[0];
    const real motor_force = s[3];
    const real rail_u = u[0]; /* m/s */
    const wreal friction_coulomb = w[2]; /* N */
    const wreal friction_viscous = w[3]; /* N*s/m */
    /* tau: rail.u.tau [N] */
    out[0] = rail_u * friction_viscous - motor_force + door_f_x
        + friction_coulomb * cardan_select(cardan_eq(0.0, friction), cardan_select(cardan_lt(0.0,
        rail_u), 1.0, cardan_select(cardan_lt(rail_u, 0.0), -1.0, 0.0)),
        cardan_select(cardan_eq(friction, 2.0), 0.0, friction));
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 6, 0, 2, 2, 0, 4, 0, 19, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
