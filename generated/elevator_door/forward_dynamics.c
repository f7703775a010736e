/*
 * forward_dynamics of elevator_door
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 1, work 5, w 2
 * Operations per call: 13 = 6 mul, 2 add, 1 eq, 1 neg, 1 select, 1 solve, 1 sub
 * Operations of prepare: 1 = 1 div
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
 * Input tau (1): applied generalized forces
 *   tau[0]  rail.u.tau [N]
 *
 * Output udot (1)
 *   out[0]  rail.udot [m/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal door_mass = p[1]; /* kg */
    const wreal M_factor_D_inverse_rail = 1.0 / door_mass;
    w[1] = M_factor_D_inverse_rail;

    /* parameters as they are */
    w[0] = p[2]; /* friction.damping [N*s/m] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    real *const circuit_matrix = work + 0;
    real *const circuit_right = work + 1;
    real *const circuit_scratch = work + 2;
    int status = CARDAN_OK;

    /* rail: drive */
    /* drive = tau + f - h */
    const real motor_force = s[1];
    const real rail_u_tau = tau[0]; /* N */
    const real rail_u = u[0]; /* m/s */
    const wreal friction_damping = w[0]; /* N*s/m */
    const real rail_drive = motor_force + rail_u_tau - rail_u * friction_damping;

    /* ends: G */
    /* G = d(rate) / du */
    const real ends = s[0];
    const real ends_G_stop_rail = cardan_select(cardan_eq(0.0, ends), 0.0, 1.0);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_rail = w[1];
    const real free_udot_rail = rail_drive * M_factor_D_inverse_rail;
    const real ends_stop_response_rail = ends_G_stop_rail * M_factor_D_inverse_rail;
    const real circuit_ends_stop_ends_stop = ends_G_stop_rail * ends_stop_response_rail;
    circuit_matrix[0] = circuit_ends_stop_ends_stop;
    const real free_gamma_ends_stop = -ends_G_stop_rail * free_udot_rail;
    circuit_right[0] = free_gamma_ends_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, circuit_matrix, circuit_right, circuit_scratch);

    /* ends: multiplier stop */
    const real ends_multiplier_stop = circuit_right[0];

    /* rail: udot */
    /* udot = free_udot + response multipliers */
    /* udot: rail.udot [m/s^2] */
    out[0] = free_udot_rail + ends_stop_response_rail * ends_multiplier_stop;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {1, 5, 2, 0, 0, 1, 0, 2, 0, 6, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0};
#endif
