/*
 * events of elevator_door
 * numbers that fall through zero where an event happens
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 4, work 5, w 3
 * Operations per call: 16 = 6 mul, 4 select, 2 neg, 2 sub, 1 eq, 1 solve
 * Operations of prepare: 1 = 1 div
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
 * Input p (6): parameters, read by prepare_ only
 *
 * Output events (4)
 *   out[0]  ends.lower
 *   out[1]  ends.upper
 *   out[2]  ends.release
 *   out[3]  motor.sample
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_events(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal door_mass = p[1]; /* kg */
    const wreal M_factor_D_inverse_rail = 1.0 / door_mass;
    w[2] = M_factor_D_inverse_rail;

    /* parameters as they are */
    w[0] = p[2]; /* friction.damping [N*s/m] */
    w[1] = p[3]; /* ends.upper [m] */
}

#include "lanes.h"

/* numbers that fall through zero where an event happens */
CARDAN_API int events(const cardan_in *in, real *CARDAN_RESTRICT out, real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    real *const circuit_matrix = work + 0;
    real *const circuit_right = work + 1;
    real *const circuit_scratch = work + 2;
    int status = CARDAN_OK;

    /* rail: drive */
    /* drive = tau + f - h */
    const real motor_force = s[1];
    const real rail_u = u[0]; /* m/s */
    const wreal friction_damping = w[0]; /* N*s/m */
    const real rail_drive = motor_force - rail_u * friction_damping;

    /* ends: event, G */
    /* event = value that falls through zero */
    /* G = d(rate) / du */
    const real rail_q = q[0]; /* m */
    const real ends = s[0];
    const wreal ends_upper = w[1]; /* m */
    const real ends_eq_zero = cardan_eq(0.0, ends);
    const real ends_G_stop_rail = cardan_select(ends_eq_zero, 0.0, 1.0);
    out[0] = cardan_select(ends_eq_zero, rail_q, 1.0); /* events: ends.lower */
    out[1] = cardan_select(ends_eq_zero, ends_upper - rail_q, 1.0); /* events: ends.upper */

    /* constraints: multipliers */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_rail = w[2];
    const real circuit_ends_stop_ends_stop = ends_G_stop_rail * M_factor_D_inverse_rail *
        ends_G_stop_rail;
    circuit_matrix[0] = circuit_ends_stop_ends_stop;
    const real free_gamma_ends_stop = -rail_drive * M_factor_D_inverse_rail * ends_G_stop_rail;
    circuit_right[0] = free_gamma_ends_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, circuit_matrix, circuit_right, circuit_scratch);

    /* ends: multiplier stop, event */
    /* event = value that falls through zero */
    const real ends_multiplier_stop = circuit_right[0];
    /* events: ends.release */
    out[2] = cardan_select(ends_eq_zero, 1.0, -ends * ends_multiplier_stop);

    /* results that are numbers or inputs */
    out[3] = CARDAN_REAL(1.0); /* events: motor.sample */
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int events_sizes[] = {4, 5, 3, 0, 1, 1, 0, 2, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
