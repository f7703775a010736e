/*
 * transition of sliding_door
 * speeds, internal and discrete states behind the events e
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 6, work 57, w 9
 * Operations per call: 165 = 58 mul, 34 select, 15 add, 12 neg, 11 sub, 8 lt, 7 le, 5 eq, 5 solve,
 *     4 abs, 2 and, 1 cos, 1 div, 1 not, 1 sin
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
 * Input r (1): inputs of the model
 *   r[0]  goal [m]
 *
 * Input p (19): parameters, read by prepare_ only
 *
 * Input e (6): events that happened, 1 or 0
 *   e[0]  friction.stop
 *   e[1]  friction.slip
 *   e[2]  ends.lower
 *   e[3]  ends.upper
 *   e[4]  ends.release
 *   e[5]  motor.sample
 *
 * Output u (2)
 *   out[0]  rail.u [m/s]
 *   out[1]  hook.u [rad/s]
 *
 * Output z (0): empty
 *
 * Output s (4)
 *   out[2]  friction
 *   out[3]  ends
 *   out[4]  motor.learned
 *   out[5]  motor.force
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_transition(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    w[7] = door_base_mass;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_hook = 1.0 / lamp_origin_inertia_yy;
    w[8] = M_factor_D_inverse_hook;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[2] = p[13]; /* friction.coulomb [N] */
    w[3] = p[14]; /* friction.static [N] */
    w[4] = p[15]; /* friction.viscous [N*s/m] */
    w[5] = p[17]; /* ends.restitution */
    w[6] = p[18]; /* ends.settle [m/s] */
}

#include "lanes.h"

/* speeds, internal and discrete states behind the events e */
CARDAN_API int transition(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const e = in->e;
    real *const unit_matrix = work + 0;
    real *const unit_right = work + 1;
    real *const unit_scratch = work + 2;
    real (*const impact_matrix)[2] = (real (*)[2])(work + 5);
    real *const impact_right = work + 9;
    real *const impact_scratch = work + 11;
    real (*const second_impact_matrix)[2] = (real (*)[2])(work + 18);
    real *const second_impact_right = work + 22;
    real *const second_impact_scratch = work + 24;
    real (*const response_matrix)[2] = (real (*)[2])(work + 31);
    real *const response_right = work + 35;
    real *const response_scratch = work + 37;
    real (*const circuit_matrix)[2] = (real (*)[2])(work + 44);
    real *const circuit_right = work + 48;
    real *const circuit_scratch = work + 50;
    int status = CARDAN_OK;

    /* hook: R */
    /* R = R_fixed R_joint(q) */
    const real hook_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hook_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hook_cos = cosine[0];
    const real hook_sin = sine[0];

    /* ends: impulse */
    const real ends_lower = e[2];
    const real ends_upper = e[3];
    const real ends = s[1];
    const real rail_u = u[0]; /* m/s */
    const wreal ends_restitution = w[5];
    const real rail_u_times_ends_restitution = rail_u * ends_restitution;
    const real ends_eq_minus_one = cardan_eq(-1.0, ends);
    const real ends_lower_active = cardan_select(ends_eq_minus_one, 1.0, ends_lower);
    const real ends_eq_one = cardan_eq(1.0, ends);
    const real ends_upper_active = cardan_select(ends_eq_one, 1.0, ends_upper);

    /* shared by several: change */
    const real friction = s[0];
    const real rail_u_lt_zero = cardan_lt(rail_u, 0.0);
    const real friction_eq_two = cardan_eq(friction, 2.0);
    const real ends_eq_zero = cardan_eq(0.0, ends);
    const real rail_u_abs = cardan_abs(rail_u);

    /* friction: G, change */
    /* G = d(rate) / du */
    const real friction_G_stick_rail = cardan_select(friction_eq_two, 1.0, 0.0);
    const real friction_eq_zero = cardan_eq(0.0, friction);
    const real friction_friction_direction = cardan_select(friction_eq_zero,
        cardan_select(cardan_lt(0.0, rail_u), 1.0, cardan_select(rail_u_lt_zero, -1.0, 0.0)),
        cardan_select(friction_eq_two, 0.0, friction));

    /* ends: G */
    /* G = d(rate) / du */
    const real ends_G_stop_rail = cardan_select(ends_eq_zero, 0.0, 1.0);

    /* M */
    /* M = S . momentum */
    const wreal lamp_first_moment_z = w[1];
    const real M_hook_rail = lamp_first_moment_z * hook_cos;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal door_base_mass = w[7];
    const wreal M_factor_D_inverse_hook = w[8];
    const real M_factor_L_hook_rail = M_hook_rail * M_factor_D_inverse_hook;
    const real M_factor_D_inverse_rail = 1.0 / (door_base_mass
        - M_hook_rail * M_factor_L_hook_rail);
    unit_matrix[0] = M_factor_D_inverse_rail;
    const real ends_lower_response_rail = ends_lower_active * M_factor_D_inverse_rail;

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const wreal ends_settle = w[6]; /* m/s */
    unit_right[0] = CARDAN_REAL(1.0);
    /* unit_matrix lam = unit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, unit_matrix, unit_right, unit_scratch);
    const real ends_lower_inertia = unit_right[0];
    const real rail_u_minus_ends_impulse_lower_after = rail_u
        - cardan_select(ends_eq_minus_one, 0.0, cardan_select(rail_u_lt_zero,
        cardan_select(cardan_le(-rail_u, ends_settle), 0.0, -rail_u_times_ends_restitution),
        rail_u));
    const real rail_u_plus_ends_impulse_upper_after = rail_u
        + cardan_select(ends_eq_one, 0.0, cardan_select(cardan_lt(-rail_u, 0.0),
        cardan_select(cardan_le(rail_u, ends_settle), 0.0, rail_u_times_ends_restitution),
        -rail_u));
    const real missing_speed_ends_upper = ends_upper_active * rail_u_plus_ends_impulse_upper_after;
    impact_right[1] = missing_speed_ends_upper;
    const real impact_ends_lower_ends_lower = ends_lower_active * ends_lower_response_rail;
    impact_matrix[0][0] = impact_ends_lower_ends_lower;
    const real impact_ends_upper_ends_lower = -ends_upper_active * ends_lower_response_rail;
    impact_matrix[0][1] = impact_ends_upper_ends_lower;
    impact_matrix[1][0] = impact_ends_upper_ends_lower;
    const real impact_ends_upper_ends_upper = ends_upper_active * M_factor_D_inverse_rail *
        ends_upper_active;
    impact_matrix[1][1] = impact_ends_upper_ends_upper;
    const real missing_speed_ends_lower = -ends_lower_active *
        rail_u_minus_ends_impulse_lower_after;
    impact_right[0] = missing_speed_ends_lower;
    /* impact_matrix lam = impact_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, impact_matrix[0], impact_right, impact_scratch);
    const real ends_lower_impulse = impact_right[0];
    const real ends_upper_impulse = impact_right[1];
    const real ends_settle_times_ends_lower_inertia = ends_settle * ends_lower_inertia;
    const real ends_lower_second_active = ends_lower_active *
        cardan_select(cardan_le(-ends_lower_impulse, ends_settle_times_ends_lower_inertia), 1.0,
        0.0);
    const real ends_upper_second_active = ends_upper_active *
        cardan_select(cardan_le(-ends_upper_impulse, ends_settle_times_ends_lower_inertia), 1.0,
        0.0);
    const real missing_speed_second_ends_upper = rail_u_plus_ends_impulse_upper_after *
        ends_upper_second_active;
    second_impact_right[1] = missing_speed_second_ends_upper;
    const real missing_speed_second_ends_lower = -rail_u_minus_ends_impulse_lower_after *
        ends_lower_second_active;
    second_impact_right[0] = missing_speed_second_ends_lower;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const real second_ends_lower_response_rail = M_factor_D_inverse_rail * ends_lower_second_active;
    const real second_ends_upper_minus_response_rail = M_factor_D_inverse_rail *
        ends_upper_second_active;

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const real hook_u = u[1]; /* rad/s */
    const real second_impact_second_ends_lower_second_ends_lower = ends_lower_second_active *
        second_ends_lower_response_rail;
    second_impact_matrix[0][0] = second_impact_second_ends_lower_second_ends_lower;
    const real second_impact_second_ends_upper_second_ends_lower = -ends_upper_second_active *
        second_ends_lower_response_rail;
    second_impact_matrix[0][1] = second_impact_second_ends_upper_second_ends_lower;
    second_impact_matrix[1][0] = second_impact_second_ends_upper_second_ends_lower;
    const real second_impact_second_ends_upper_second_ends_upper = ends_upper_second_active *
        second_ends_upper_minus_response_rail;
    second_impact_matrix[1][1] = second_impact_second_ends_upper_second_ends_upper;
    /* second_impact_matrix lam = second_impact_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, second_impact_matrix[0], second_impact_right,
        second_impact_scratch);
    const real ends_lower_second_impulse = second_impact_right[0];
    const real ends_upper_second_impulse = second_impact_right[1];
    const real second_behind_rail = rail_u
        + second_ends_lower_response_rail * ends_lower_second_impulse
        - second_ends_upper_minus_response_rail * ends_upper_second_impulse;
    out[0] = second_behind_rail; /* u: rail.u [m/s] */
    /* u: hook.u [rad/s] */
    out[1] = hook_u
        + M_factor_L_hook_rail * second_ends_upper_minus_response_rail * ends_upper_second_impulse -
        M_factor_L_hook_rail * second_ends_lower_response_rail * ends_lower_second_impulse;

    /* friction: change */
    const real friction_change_along = cardan_select(cardan_lt(0.0, second_behind_rail), 1.0, -1.0);

    /* shared by several: change */
    const real friction_stick_response_rail = friction_G_stick_rail * M_factor_D_inverse_rail;
    const real ends_stop_response_rail = ends_G_stop_rail * M_factor_D_inverse_rail;
    const real response_friction_stick_friction_stick = friction_G_stick_rail *
        friction_stick_response_rail;
    response_matrix[0][0] = response_friction_stick_friction_stick;
    circuit_matrix[0][0] = response_friction_stick_friction_stick;
    const real response_ends_stop_friction_stick = ends_G_stop_rail * friction_stick_response_rail;
    response_matrix[0][1] = response_ends_stop_friction_stick;
    response_matrix[1][0] = response_ends_stop_friction_stick;
    circuit_matrix[0][1] = response_ends_stop_friction_stick;
    circuit_matrix[1][0] = response_ends_stop_friction_stick;
    const real response_ends_stop_ends_stop = ends_G_stop_rail * ends_stop_response_rail;
    response_matrix[1][1] = response_ends_stop_ends_stop;
    circuit_matrix[1][1] = response_ends_stop_ends_stop;
    const real second_behind_rail_abs = cardan_abs(second_behind_rail);

    /* friction: change, response multiplier stick */
    const real response_gamma_friction_stick = -friction_stick_response_rail;
    response_right[0] = response_gamma_friction_stick;
    const real response_gamma_ends_stop = -ends_stop_response_rail;
    response_right[1] = response_gamma_ends_stop;
    /* response_matrix lam = response_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, response_matrix[0], response_right,
        response_scratch);
    const real friction_response_multiplier_stick = response_right[0];

    /* ends: response multiplier stop, change */
    const real ends_release = e[4];
    const real ends_response_multiplier_stop = response_right[1];
    const real ends_change_at_rest = cardan_le(second_behind_rail_abs - 1e-12 * rail_u_abs, 1e-12);
    /* s: ends */
    out[3] = cardan_select(ends_release, 0.0, cardan_select(ends_upper,
        cardan_select(ends_change_at_rest, 1.0, 0.0), cardan_select(ends_lower,
        cardan_select(ends_change_at_rest, -1.0, 0.0), cardan_select(ends_eq_zero, 0.0,
        cardan_select(ends_change_at_rest, ends, 0.0)))));

    /* friction: change */
    const real friction_change_response = M_factor_D_inverse_rail
        + friction_stick_response_rail * friction_response_multiplier_stick
        + ends_stop_response_rail * ends_response_multiplier_stop;

    /* lamp: a, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real lamp_a_x = gravity_z * hook_sin;
    const real lamp_n_y = lamp_first_moment_z * lamp_a_x;

    /* rail: drive */
    /* drive = tau + f - h */
    const real motor_force = s[3];
    const wreal friction_coulomb = w[2]; /* N */
    const wreal friction_viscous = w[4]; /* N*s/m */
    const real rail_drive = motor_force - rail_u * friction_viscous
        + hook_u * hook_u * lamp_first_moment_z * hook_sin
        - friction_coulomb * friction_friction_direction;

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real free_udot_rail = M_factor_D_inverse_rail * (rail_drive
        + M_factor_L_hook_rail * lamp_n_y);
    const real free_gamma_friction_stick = -friction_G_stick_rail * free_udot_rail;
    circuit_right[0] = free_gamma_friction_stick;
    const real free_gamma_ends_stop = -ends_G_stop_rail * free_udot_rail;
    circuit_right[1] = free_gamma_ends_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* friction: multiplier stick */
    const real friction_multiplier_stick = circuit_right[0];

    /* ends: multiplier stop */
    const real ends_multiplier_stop = circuit_right[1];

    /* rail: udot */
    /* udot = free_udot + response multipliers */
    const real rail_udot = free_udot_rail
        + friction_stick_response_rail * friction_multiplier_stick
        + ends_stop_response_rail * ends_multiplier_stop;

    /* friction: change */
    const real friction_stop = e[0];
    const real friction_slip = e[1];
    const wreal friction_static = w[3]; /* N */
    const real friction_change_rate = rail_udot
        + friction_coulomb * friction_change_response * friction_friction_direction;
    const real friction_change_stopped = cardan_select(cardan_and(friction_eq_zero, cardan_lt(0.0,
        rail_u_abs)), friction_change_along,
        cardan_select(cardan_le(cardan_abs(friction_change_rate)
        - friction_static * friction_change_response, 0.0), 2.0, cardan_select(cardan_lt(0.0,
        friction_change_rate), 1.0, -1.0)));
    const real friction_change_unless_struck = cardan_select(friction_stop,
        friction_change_stopped, cardan_select(friction_slip,
        cardan_select(cardan_lt(friction_multiplier_stick, 0.0), 1.0, -1.0), friction));
    /* s: friction */
    out[2] = cardan_select(cardan_and(cardan_lt(1e-12 * (1.0
        + second_behind_rail_abs), cardan_abs(second_behind_rail
        - rail_u)), cardan_not(friction_eq_zero)), cardan_select(cardan_le(second_behind_rail_abs,
        1e-12 * (1.0 + rail_u_abs)), 2.0, friction_change_along), friction_change_unless_struck);

    /* motor: change */
    const real motor_sample = e[5];
    const real rail_q = q[0]; /* m */
    const real goal = r[0]; /* m */
    const real motor_learned = s[2];
    /* s: motor.learned */
    out[4] = cardan_select(motor_sample, motor_learned + 2.0 * goal - 2.0 * rail_q, motor_learned);
    /* s: motor.force */
    out[5] = cardan_select(motor_sample, motor_learned + 60.0 * goal - (30.0 * rail_u
        + 60.0 * rail_q), motor_force);
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int transition_sizes[] = {6, 57, 9, 0, 2, 2, 0, 4, 1, 19, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0};
#endif
