/*
 * transition of sliding_block
 * speeds, internal and discrete states behind the events e
 * formalism: composite
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 31, w 9
 * Operations per call: 88 = 24 select, 23 mul, 8 lt, 7 add, 5 sub, 4 abs, 4 eq, 4 le, 3 neg,
 *     3 solve, 2 and, 1 not
 * Operations of prepare: 5 = 2 mul, 1 abs, 1 div, 1 solve
 *
 * Input u (1): generalized speeds
 *   u[0]  slide.u [m/s]
 *
 * Input s (2): discrete states
 *   s[0]  friction
 *   s[1]  wall
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Input e (5): events that happened, 1 or 0
 *   e[0]  friction.stop
 *   e[1]  friction.slip
 *   e[2]  friction.jam
 *   e[3]  wall.upper
 *   e[4]  wall.release
 *
 * Output u (1)
 *   out[0]  slide.u [m/s]
 *
 * Output z (0): empty
 *
 * Output s (2)
 *   out[1]  friction
 *   out[2]  wall
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_transition(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    wreal *const system_matrix = w + 4;
    wreal *const system_right = w + 5;
    wreal *const system_scratch = w + 6;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal block_mass = p[3]; /* kg */
    const wreal M_factor_D_inverse_slide = 1.0 / block_mass;
    w[2] = M_factor_D_inverse_slide;

    /* friction: change */
    const wreal mu = p[0];
    const wreal gravity_z = p[2]; /* m/s^2 */
    const wreal mu_times_block_minus_f_z_abs = mu * cardan_abs(gravity_z * block_mass);
    system_right[0] = mu_times_block_minus_f_z_abs;
    system_matrix[0] = CARDAN_WREAL(1.0);
    /* system_matrix x = system_right; the solution takes its place */
    (void)CARDAN_SOLVE(rank_revealing, 1, 1, system_matrix, system_right, system_scratch);
    const wreal slide_tau_part = system_right[0];
    w[3] = slide_tau_part;

    /* parameters as they are */
    w[0] = p[1]; /* e */
    w[1] = p[8]; /* wall.settle [m/s] */
}

#include "lanes.h"

/* speeds, internal and discrete states behind the events e */
CARDAN_API int transition(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    const real *const e = in->e;
    real *const impact_matrix = work + 0;
    real *const impact_right = work + 1;
    real *const impact_scratch = work + 2;
    real (*const response_matrix)[2] = (real (*)[2])(work + 5);
    real *const response_right = work + 9;
    real *const response_scratch = work + 11;
    real (*const circuit_matrix)[2] = (real (*)[2])(work + 18);
    real *const circuit_right = work + 22;
    real *const circuit_scratch = work + 24;
    int status = CARDAN_OK;

    /* wall: impulse */
    const real wall_upper = e[3];
    const real wall = s[1];
    const real wall_eq_one = cardan_eq(1.0, wall);
    const real wall_upper_active = cardan_select(wall_eq_one, 1.0, wall_upper);

    /* shared by several: change */
    const real friction = s[0];
    const real slide_u = u[0]; /* m/s */
    const real friction_eq_two = cardan_eq(friction, 2.0);
    const real wall_eq_zero = cardan_eq(0.0, wall);
    const real slide_u_abs = cardan_abs(slide_u);

    /* friction: G, change */
    /* G = d(rate) / du */
    const real friction_G_stick_slide = cardan_select(friction_eq_two, 1.0, 0.0);
    const real friction_eq_zero = cardan_eq(0.0, friction);
    const real friction_friction_direction = cardan_select(friction_eq_zero,
        cardan_select(cardan_lt(0.0, slide_u), 1.0, cardan_select(cardan_lt(slide_u, 0.0), -1.0,
        0.0)), cardan_select(friction_eq_two, 0.0, friction));

    /* wall: G */
    /* G = d(rate) / du */
    const real wall_G_stop_slide = cardan_select(wall_eq_zero, 0.0, 1.0);

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const wreal e_value = w[0];
    const wreal wall_settle = w[1]; /* m/s */
    const real missing_speed_wall_upper = wall_upper_active * (slide_u
        + cardan_select(wall_eq_one, 0.0, cardan_select(cardan_lt(-slide_u, 0.0),
        cardan_select(cardan_le(slide_u, wall_settle), 0.0, e_value * slide_u), -slide_u)));
    impact_right[0] = missing_speed_wall_upper;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_slide = w[2];
    const real wall_upper_minus_response_slide = wall_upper_active * M_factor_D_inverse_slide;

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const real impact_wall_upper_wall_upper = wall_upper_active * wall_upper_minus_response_slide;
    impact_matrix[0] = impact_wall_upper_wall_upper;
    /* impact_matrix lam = impact_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, impact_matrix, impact_right, impact_scratch);
    const real wall_upper_impulse = impact_right[0];
    const real behind_slide = slide_u - wall_upper_minus_response_slide * wall_upper_impulse;
    out[0] = behind_slide; /* u: slide.u [m/s] */

    /* friction: change */
    const real friction_change_along = cardan_select(cardan_lt(0.0, behind_slide), 1.0, -1.0);

    /* shared by several: change */
    const real friction_stick_response_slide = friction_G_stick_slide * M_factor_D_inverse_slide;
    const real wall_stop_response_slide = wall_G_stop_slide * M_factor_D_inverse_slide;
    const real response_friction_stick_friction_stick = friction_G_stick_slide *
        friction_stick_response_slide;
    response_matrix[0][0] = response_friction_stick_friction_stick;
    circuit_matrix[0][0] = response_friction_stick_friction_stick;
    const real response_wall_stop_friction_stick = wall_G_stop_slide *
        friction_stick_response_slide;
    response_matrix[0][1] = response_wall_stop_friction_stick;
    response_matrix[1][0] = response_wall_stop_friction_stick;
    circuit_matrix[0][1] = response_wall_stop_friction_stick;
    circuit_matrix[1][0] = response_wall_stop_friction_stick;
    const real response_wall_stop_wall_stop = wall_G_stop_slide * wall_stop_response_slide;
    response_matrix[1][1] = response_wall_stop_wall_stop;
    circuit_matrix[1][1] = response_wall_stop_wall_stop;
    const real behind_slide_abs = cardan_abs(behind_slide);

    /* friction: change, response multiplier stick */
    const real response_gamma_friction_stick = -friction_stick_response_slide;
    response_right[0] = response_gamma_friction_stick;
    const real response_gamma_wall_stop = -wall_stop_response_slide;
    response_right[1] = response_gamma_wall_stop;
    /* response_matrix lam = response_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, response_matrix[0], response_right,
        response_scratch);
    const real friction_response_multiplier_stick = response_right[0];

    /* wall: response multiplier stop, change */
    const real wall_release = e[4];
    const real wall_response_multiplier_stop = response_right[1];
    const real wall_change_at_rest = cardan_le(behind_slide_abs - 1e-12 * slide_u_abs, 1e-12);
    /* s: wall */
    out[2] = cardan_select(wall_release, 0.0, cardan_select(wall_upper,
        cardan_select(wall_change_at_rest, 1.0, 0.0), cardan_select(wall_eq_zero, 0.0,
        cardan_select(wall_change_at_rest, wall, 0.0))));

    /* slide: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal slide_tau_part = w[3];
    const real slide_tau = friction_friction_direction * slide_tau_part;

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real free_udot_minus_slide = M_factor_D_inverse_slide * slide_tau;
    const real free_gamma_friction_stick = friction_G_stick_slide * free_udot_minus_slide;
    circuit_right[0] = free_gamma_friction_stick;
    const real free_gamma_wall_stop = wall_G_stop_slide * free_udot_minus_slide;
    circuit_right[1] = free_gamma_wall_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* friction: multiplier stick, change */
    const real friction_multiplier_stick = circuit_right[0];
    const real friction_change_rate_part = (M_factor_D_inverse_slide
        + friction_stick_response_slide * friction_response_multiplier_stick
        + wall_stop_response_slide * wall_response_multiplier_stop) * slide_tau_part;

    /* wall: multiplier stop */
    const real wall_multiplier_stop = circuit_right[1];

    /* slide: udot */
    /* udot = free_udot + response multipliers */
    const real slide_udot = friction_stick_response_slide * friction_multiplier_stick
        - free_udot_minus_slide + wall_stop_response_slide * wall_multiplier_stop;

    /* friction: change */
    const real friction_stop = e[0];
    const real friction_slip = e[1];
    const real friction_change_rate = slide_udot
        + friction_friction_direction * friction_change_rate_part;
    const real friction_change_stopped = cardan_select(cardan_and(friction_eq_zero, cardan_lt(0.0,
        slide_u_abs)), friction_change_along,
        cardan_select(cardan_le(cardan_abs(friction_change_rate)
        - friction_change_rate_part, 0.0), 2.0, cardan_select(cardan_lt(0.0, friction_change_rate),
        1.0, -1.0)));
    const real friction_change_unless_struck = cardan_select(friction_stop,
        friction_change_stopped, cardan_select(friction_slip,
        cardan_select(cardan_lt(friction_multiplier_stick, 0.0), 1.0, -1.0), friction));
    /* s: friction */
    out[1] = cardan_select(cardan_and(cardan_lt(1e-12 * (1.0
        + behind_slide_abs), cardan_abs(behind_slide
        - slide_u)), cardan_not(friction_eq_zero)), cardan_select(cardan_le(behind_slide_abs,
        1e-12 * (1.0 + slide_u_abs)), 2.0, friction_change_along), friction_change_unless_struck);
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int transition_sizes[] = {3, 31, 9, 0, 0, 1, 0, 2, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0};
#endif
