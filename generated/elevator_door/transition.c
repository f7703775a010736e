/*
 * transition of elevator_door
 * speeds, internal and discrete states behind the events e
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 26, w 9
 * Operations per call: 70 = 23 mul, 18 select, 8 neg, 5 le, 5 sub, 3 eq, 2 abs, 2 add, 2 lt,
 *     2 solve
 * Operations of prepare: 3 = 1 div, 1 mul, 1 solve
 *
 * Input q (1): generalized coordinates
 *   q[0]  rail [m]
 *
 * Input u (1): generalized speeds
 *   u[0]  rail.u [m/s]
 *
 * Input s (2): discrete states
 *   s[0]  ends
 *   s[1]  motor.force
 *
 * Input r (1): inputs of the model
 *   r[0]  goal [m]
 *
 * Input p (6): parameters, read by prepare_ only
 *
 * Input e (4): events that happened, 1 or 0
 *   e[0]  ends.lower
 *   e[1]  ends.upper
 *   e[2]  ends.release
 *   e[3]  motor.sample
 *
 * Output u (1)
 *   out[0]  rail.u [m/s]
 *
 * Output z (0): empty
 *
 * Output s (2)
 *   out[1]  ends
 *   out[2]  motor.force
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_transition(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    wreal *const unit_matrix = w + 4;
    wreal *const unit_right = w + 5;
    wreal *const unit_scratch = w + 6;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal door_mass = p[1]; /* kg */
    const wreal M_factor_D_inverse_rail = 1.0 / door_mass;
    unit_matrix[0] = M_factor_D_inverse_rail;
    w[2] = M_factor_D_inverse_rail;

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const wreal ends_settle = p[5]; /* m/s */
    unit_right[0] = CARDAN_WREAL(1.0);
    /* unit_matrix lam = unit_right; the solution takes its place */
    (void)CARDAN_SOLVE(semidefinite, 1, 1, unit_matrix, unit_right, unit_scratch);
    const wreal ends_lower_inertia = unit_right[0];
    const wreal ends_settle_times_ends_lower_inertia = ends_settle * ends_lower_inertia;
    w[3] = ends_settle_times_ends_lower_inertia;

    /* parameters as they are */
    w[0] = p[4]; /* ends.restitution */
    w[1] = p[5]; /* ends.settle [m/s] */
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
    real (*const impact_matrix)[2] = (real (*)[2])(work + 0);
    real *const impact_right = work + 4;
    real *const impact_scratch = work + 6;
    real (*const second_impact_matrix)[2] = (real (*)[2])(work + 13);
    real *const second_impact_right = work + 17;
    real *const second_impact_scratch = work + 19;
    int status = CARDAN_OK;

    /* ends: impulse */
    const real ends_lower = e[0];
    const real ends_upper = e[1];
    const real ends = s[0];
    const real rail_u = u[0]; /* m/s */
    const wreal ends_restitution = w[0];
    const real rail_u_times_ends_restitution = rail_u * ends_restitution;
    const real ends_eq_minus_one = cardan_eq(-1.0, ends);
    const real ends_lower_active = cardan_select(ends_eq_minus_one, 1.0, ends_lower);
    const real ends_eq_one = cardan_eq(1.0, ends);
    const real ends_upper_active = cardan_select(ends_eq_one, 1.0, ends_upper);

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const wreal ends_settle = w[1]; /* m/s */
    const wreal M_factor_D_inverse_rail = w[2];
    const real rail_u_minus_ends_impulse_lower_after = rail_u
        - cardan_select(ends_eq_minus_one, 0.0, cardan_select(cardan_lt(rail_u, 0.0),
        cardan_select(cardan_le(-rail_u, ends_settle), 0.0, -rail_u_times_ends_restitution),
        rail_u));
    const real rail_u_plus_ends_impulse_upper_after = rail_u
        + cardan_select(ends_eq_one, 0.0, cardan_select(cardan_lt(-rail_u, 0.0),
        cardan_select(cardan_le(rail_u, ends_settle), 0.0, rail_u_times_ends_restitution),
        -rail_u));
    const real missing_speed_ends_upper = ends_upper_active * rail_u_plus_ends_impulse_upper_after;
    impact_right[1] = missing_speed_ends_upper;
    const real impact_ends_upper_ends_upper = ends_upper_active * M_factor_D_inverse_rail *
        ends_upper_active;
    impact_matrix[1][1] = impact_ends_upper_ends_upper;
    const real missing_speed_ends_lower = -ends_lower_active *
        rail_u_minus_ends_impulse_lower_after;
    impact_right[0] = missing_speed_ends_lower;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const real ends_lower_response_rail = ends_lower_active * M_factor_D_inverse_rail;

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const wreal ends_settle_times_ends_lower_inertia = w[3];
    const real impact_ends_lower_ends_lower = ends_lower_active * ends_lower_response_rail;
    impact_matrix[0][0] = impact_ends_lower_ends_lower;
    const real impact_ends_upper_ends_lower = -ends_upper_active * ends_lower_response_rail;
    impact_matrix[0][1] = impact_ends_upper_ends_lower;
    impact_matrix[1][0] = impact_ends_upper_ends_lower;
    /* impact_matrix lam = impact_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, impact_matrix[0], impact_right, impact_scratch);
    const real ends_lower_impulse = impact_right[0];
    const real ends_upper_impulse = impact_right[1];
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

    /* ends: change */
    const real ends_release = e[2];
    const real ends_change_at_rest = cardan_le(cardan_abs(second_behind_rail)
        - 1e-12 * cardan_abs(rail_u), 1e-12);
    /* s: ends */
    out[1] = cardan_select(ends_release, 0.0, cardan_select(ends_upper,
        cardan_select(ends_change_at_rest, 1.0, 0.0), cardan_select(ends_lower,
        cardan_select(ends_change_at_rest, -1.0, 0.0), cardan_select(cardan_eq(0.0, ends), 0.0,
        cardan_select(ends_change_at_rest, ends, 0.0)))));

    /* motor: change */
    const real motor_sample = e[3];
    const real rail_q = q[0]; /* m */
    const real goal = r[0]; /* m */
    const real motor_force = s[1];
    /* s: motor.force */
    out[2] = cardan_select(motor_sample, 600.0 * goal - 220.0 * rail_u
        - 600.0 * rail_q, motor_force);
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int transition_sizes[] = {3, 26, 9, 0, 1, 1, 0, 2, 1, 6, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0};
#endif
