/*
 * forward_dynamics of sliding_block
 * udot with M udot + h = f + tau
 * formalism: composite
 * passes: unroll, reassociate
 *
 * Sizes: out 1, work 13, w 7
 * Operations per call: 28 = 11 mul, 6 select, 3 eq, 2 add, 2 lt, 2 neg, 1 solve, 1 sub
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
 * Input tau (1): applied generalized forces
 *   tau[0]  slide.u.tau [N]
 *
 * Output udot (1)
 *   out[0]  slide.udot [m/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    wreal *const system_matrix = w + 2;
    wreal *const system_right = w + 3;
    wreal *const system_scratch = w + 4;

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
    w[0] = slide_tau_part;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_slide = 1.0 / block_mass;
    w[1] = M_factor_D_inverse_slide;
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
    real (*const circuit_matrix)[2] = (real (*)[2])(work + 0);
    real *const circuit_right = work + 4;
    real *const circuit_scratch = work + 6;
    int status = CARDAN_OK;

    /* friction: G */
    /* force = -sign(v) (coulomb + (static - coulomb) exp(-(v/stribeck)^2)) - viscous v */
    /* G = d(rate) / du */
    const real friction = s[0];
    const real friction_eq_two = cardan_eq(friction, 2.0);
    const real friction_G_stick_slide = cardan_select(friction_eq_two, 1.0, 0.0);

    /* wall: G */
    /* G = d(rate) / du */
    const real wall = s[1];
    const real wall_G_stop_slide = cardan_select(cardan_eq(0.0, wall), 0.0, 1.0);

    /* slide: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real slide_u_tau = tau[0]; /* N */
    const real slide_u = u[0]; /* m/s */
    const wreal slide_tau_part = w[0];
    const real slide_tau = cardan_select(cardan_eq(0.0, friction), cardan_select(cardan_lt(0.0,
        slide_u), 1.0, cardan_select(cardan_lt(slide_u, 0.0), -1.0, 0.0)),
        cardan_select(friction_eq_two, 0.0, friction)) * slide_tau_part;
    const real slide_drive = slide_u_tau - slide_tau;

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_slide = w[1];
    const real free_udot_slide = slide_drive * M_factor_D_inverse_slide;
    const real friction_stick_response_slide = friction_G_stick_slide * M_factor_D_inverse_slide;
    const real wall_stop_response_slide = wall_G_stop_slide * M_factor_D_inverse_slide;
    const real circuit_friction_stick_friction_stick = friction_G_stick_slide *
        friction_stick_response_slide;
    circuit_matrix[0][0] = circuit_friction_stick_friction_stick;
    const real circuit_wall_stop_friction_stick = wall_G_stop_slide * friction_stick_response_slide;
    circuit_matrix[0][1] = circuit_wall_stop_friction_stick;
    circuit_matrix[1][0] = circuit_wall_stop_friction_stick;
    const real circuit_wall_stop_wall_stop = wall_G_stop_slide * wall_stop_response_slide;
    circuit_matrix[1][1] = circuit_wall_stop_wall_stop;
    const real free_gamma_friction_stick = -friction_G_stick_slide * free_udot_slide;
    circuit_right[0] = free_gamma_friction_stick;
    const real free_gamma_wall_stop = -wall_G_stop_slide * free_udot_slide;
    circuit_right[1] = free_gamma_wall_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* friction: multiplier stick */
    const real friction_multiplier_stick = circuit_right[0];

    /* wall: multiplier stop */
    const real wall_multiplier_stop = circuit_right[1];

    /* slide: udot */
    /* udot = free_udot + response multipliers */
    /* udot: slide.udot [m/s^2] */
    out[0] = free_udot_slide + friction_stick_response_slide * friction_multiplier_stick
        + wall_stop_response_slide * wall_multiplier_stop;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {1, 13, 7, 0, 0, 1, 0, 2, 0, 9, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0};
#endif
