/*
 * events of sliding_door
 * numbers that fall through zero where an event happens
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 6, work 13, w 8
 * Operations per call: 53 = 21 mul, 12 select, 5 sub, 3 eq, 3 neg, 2 add, 2 lt, 1 abs, 1 cos,
 *     1 div, 1 sin, 1 solve
 * Operations of prepare: 5 = 2 add, 2 mul, 1 div
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
 * Output events (6)
 *   out[0]  friction.stop
 *   out[1]  friction.slip
 *   out[2]  ends.lower
 *   out[3]  ends.upper
 *   out[4]  ends.release
 *   out[5]  motor.sample
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_events(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* lamp: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal lamp_mass = p[8]; /* kg */
    const wreal lamp_com_z = p[9]; /* m */
    const wreal lamp_inertia_yy = p[11]; /* kg m^2 */
    const wreal lamp_first_moment_z = lamp_mass * lamp_com_z;
    const wreal lamp_origin_inertia_yy = lamp_inertia_yy + lamp_com_z * lamp_first_moment_z;
    w[1] = lamp_first_moment_z;

    /* door: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal door_mass = p[1]; /* kg */
    const wreal door_base_mass = door_mass + lamp_mass;
    w[6] = door_base_mass;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_hook = 1.0 / lamp_origin_inertia_yy;
    w[7] = M_factor_D_inverse_hook;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[2] = p[13]; /* friction.coulomb [N] */
    w[3] = p[14]; /* friction.static [N] */
    w[4] = p[15]; /* friction.viscous [N*s/m] */
    w[5] = p[16]; /* ends.upper [m] */
}

#include "lanes.h"

/* numbers that fall through zero where an event happens */
CARDAN_API int events(const cardan_in *in, real *CARDAN_RESTRICT out, real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    real (*const circuit_matrix)[2] = (real (*)[2])(work + 0);
    real *const circuit_right = work + 4;
    real *const circuit_scratch = work + 6;
    int status = CARDAN_OK;

    /* hook: R */
    /* R = R_fixed R_joint(q) */
    const real hook_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hook_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hook_cos = cosine[0];
    const real hook_sin = sine[0];

    /* friction: event, G */
    /* event = value that falls through zero */
    /* G = d(rate) / du */
    const real friction = s[0];
    const real rail_u = u[0]; /* m/s */
    const real friction_eq_two = cardan_eq(friction, 2.0);
    const real friction_eq_zero = cardan_eq(0.0, friction);
    const real friction_G_stick_rail = cardan_select(friction_eq_two, 1.0, 0.0);
    /* events: friction.stop */
    out[0] = cardan_select(friction_eq_two, 1.0, cardan_select(friction_eq_zero, -1.0,
        rail_u * friction));

    /* M */
    /* M = S . momentum */
    const wreal lamp_first_moment_z = w[1];
    const real M_hook_rail = lamp_first_moment_z * hook_cos;

    /* lamp: a, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real lamp_a_x = gravity_z * hook_sin;
    const real lamp_n_y = lamp_first_moment_z * lamp_a_x;

    /* rail: drive */
    /* drive = tau + f - h */
    const real motor_force = s[3];
    const real hook_u = u[1]; /* rad/s */
    const wreal friction_coulomb = w[2]; /* N */
    const wreal friction_viscous = w[4]; /* N*s/m */
    const real rail_drive = motor_force - rail_u * friction_viscous
        + hook_u * hook_u * lamp_first_moment_z * hook_sin
        - friction_coulomb * cardan_select(friction_eq_zero, cardan_select(cardan_lt(0.0, rail_u),
        1.0, cardan_select(cardan_lt(rail_u, 0.0), -1.0, 0.0)), cardan_select(friction_eq_two, 0.0,
        friction));

    /* ends: event, G */
    /* event = value that falls through zero */
    /* G = d(rate) / du */
    const real rail_q = q[0]; /* m */
    const real ends = s[1];
    const wreal ends_upper = w[5]; /* m */
    const real ends_eq_zero = cardan_eq(0.0, ends);
    const real ends_G_stop_rail = cardan_select(ends_eq_zero, 0.0, 1.0);
    out[2] = cardan_select(ends_eq_zero, rail_q, 1.0); /* events: ends.lower */
    out[3] = cardan_select(ends_eq_zero, ends_upper - rail_q, 1.0); /* events: ends.upper */

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal door_base_mass = w[6];
    const wreal M_factor_D_inverse_hook = w[7];
    const real M_factor_L_hook_rail = M_hook_rail * M_factor_D_inverse_hook;
    const real M_factor_D_inverse_rail = 1.0 / (door_base_mass
        - M_hook_rail * M_factor_L_hook_rail);
    const real free_udot_rail = M_factor_D_inverse_rail * (rail_drive
        + lamp_n_y * M_factor_L_hook_rail);
    const real friction_stick_response_rail = friction_G_stick_rail * M_factor_D_inverse_rail;
    const real circuit_friction_stick_friction_stick = friction_G_stick_rail *
        friction_stick_response_rail;
    circuit_matrix[0][0] = circuit_friction_stick_friction_stick;
    const real circuit_ends_stop_friction_stick = ends_G_stop_rail * friction_stick_response_rail;
    circuit_matrix[0][1] = circuit_ends_stop_friction_stick;
    circuit_matrix[1][0] = circuit_ends_stop_friction_stick;
    const real circuit_ends_stop_ends_stop = ends_G_stop_rail * M_factor_D_inverse_rail *
        ends_G_stop_rail;
    circuit_matrix[1][1] = circuit_ends_stop_ends_stop;
    const real free_gamma_friction_stick = -friction_G_stick_rail * free_udot_rail;
    circuit_right[0] = free_gamma_friction_stick;
    const real free_gamma_ends_stop = -ends_G_stop_rail * free_udot_rail;
    circuit_right[1] = free_gamma_ends_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* friction: multiplier stick, event */
    /* event = value that falls through zero */
    const wreal friction_static = w[3]; /* N */
    const real friction_multiplier_stick = circuit_right[0];
    /* events: friction.slip */
    out[1] = cardan_select(friction_eq_two, friction_static
        - cardan_abs(friction_multiplier_stick), 1.0);

    /* ends: multiplier stop, event */
    /* event = value that falls through zero */
    const real ends_multiplier_stop = circuit_right[1];
    /* events: ends.release */
    out[4] = cardan_select(ends_eq_zero, 1.0, -ends * ends_multiplier_stop);

    /* results that are numbers or inputs */
    out[5] = CARDAN_REAL(1.0); /* events: motor.sample */
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int events_sizes[] = {6, 13, 8, 0, 2, 2, 0, 4, 0, 19, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
