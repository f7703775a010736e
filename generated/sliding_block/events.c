/*
 * events of sliding_block
 * numbers that fall through zero where an event happens
 * formalism: composite
 * passes: unroll, reassociate
 *
 * Sizes: out 5, work 13, w 8
 * Operations per call: 32 = 11 mul, 11 select, 3 eq, 2 lt, 2 sub, 1 abs, 1 neg, 1 solve
 * Operations of prepare: 5 = 2 mul, 1 abs, 1 div, 1 solve
 *
 * Input q (1): generalized coordinates
 *   q[0]  slide [m]
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
 * Output events (5)
 *   out[0]  friction.stop
 *   out[1]  friction.slip
 *   out[2]  friction.jam
 *   out[3]  wall.upper
 *   out[4]  wall.release
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_events(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    wreal *const system_matrix = w + 3;
    wreal *const system_right = w + 4;
    wreal *const system_scratch = w + 5;

    /* common */
    const wreal mu = p[0];
    const wreal gravity_z = p[2]; /* m/s^2 */
    const wreal block_mass = p[3]; /* kg */
    const wreal mu_times_block_minus_f_z_abs = mu * cardan_abs(gravity_z * block_mass);
    system_right[0] = mu_times_block_minus_f_z_abs;
    system_matrix[0] = CARDAN_WREAL(1.0);
    /* system_matrix x = system_right; the solution takes its place */
    (void)CARDAN_SOLVE(rank_revealing, 1, 1, system_matrix, system_right, system_scratch);
    const wreal slide_tau_part = system_right[0];
    w[1] = slide_tau_part;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_slide = 1.0 / block_mass;
    w[2] = M_factor_D_inverse_slide;

    /* parameters as they are */
    w[0] = p[7]; /* wall.upper [m] */
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

    /* friction: event, G */
    /* event = value that falls through zero */
    /* G = d(rate) / du */
    const real friction = s[0];
    const real slide_u = u[0]; /* m/s */
    const real friction_eq_two = cardan_eq(friction, 2.0);
    const real friction_eq_zero = cardan_eq(0.0, friction);
    const real friction_G_stick_slide = cardan_select(friction_eq_two, 1.0, 0.0);
    /* events: friction.stop */
    out[0] = cardan_select(friction_eq_two, 1.0, cardan_select(friction_eq_zero, -1.0,
        slide_u * friction));

    /* wall: event, G */
    /* event = value that falls through zero */
    /* G = d(rate) / du */
    const real slide_q = q[0]; /* m */
    const real wall = s[1];
    const wreal wall_upper = w[0]; /* m */
    const real wall_eq_zero = cardan_eq(0.0, wall);
    const real wall_G_stop_slide = cardan_select(wall_eq_zero, 0.0, 1.0);
    out[3] = cardan_select(wall_eq_zero, wall_upper - slide_q, 1.0); /* events: wall.upper */

    /* slide: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal slide_tau_part = w[1];
    const real slide_tau = cardan_select(friction_eq_zero, cardan_select(cardan_lt(0.0, slide_u),
        1.0, cardan_select(cardan_lt(slide_u, 0.0), -1.0, 0.0)), cardan_select(friction_eq_two,
        0.0, friction)) * slide_tau_part;

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_slide = w[2];
    const real free_udot_minus_slide = slide_tau * M_factor_D_inverse_slide;
    const real friction_stick_response_slide = friction_G_stick_slide * M_factor_D_inverse_slide;
    const real circuit_friction_stick_friction_stick = friction_G_stick_slide *
        friction_stick_response_slide;
    circuit_matrix[0][0] = circuit_friction_stick_friction_stick;
    const real circuit_wall_stop_friction_stick = wall_G_stop_slide * friction_stick_response_slide;
    circuit_matrix[0][1] = circuit_wall_stop_friction_stick;
    circuit_matrix[1][0] = circuit_wall_stop_friction_stick;
    const real circuit_wall_stop_wall_stop = wall_G_stop_slide * M_factor_D_inverse_slide *
        wall_G_stop_slide;
    circuit_matrix[1][1] = circuit_wall_stop_wall_stop;
    const real free_gamma_friction_stick = friction_G_stick_slide * free_udot_minus_slide;
    circuit_right[0] = free_gamma_friction_stick;
    const real free_gamma_wall_stop = wall_G_stop_slide * free_udot_minus_slide;
    circuit_right[1] = free_gamma_wall_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* friction: multiplier stick, event */
    /* event = value that falls through zero */
    const real friction_multiplier_stick = circuit_right[0];
    /* events: friction.slip */
    out[1] = cardan_select(friction_eq_two, slide_tau_part
        - cardan_abs(friction_multiplier_stick), 1.0);

    /* wall: multiplier stop, event */
    /* event = value that falls through zero */
    const real wall_multiplier_stop = circuit_right[1];
    /* events: wall.release */
    out[4] = cardan_select(wall_eq_zero, 1.0, -wall * wall_multiplier_stop);

    /* results that are numbers or inputs */
    out[2] = CARDAN_REAL(0.999); /* events: friction.jam */
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int events_sizes[] = {5, 13, 8, 0, 1, 1, 0, 2, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
