/*
 * forward_dynamics of sliding_door
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 13, w 6
 * Operations per call: 56 = 27 mul, 8 sub, 6 select, 4 add, 3 eq, 2 lt, 2 neg, 1 cos, 1 div,
 *     1 sin, 1 solve
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
 * Input tau (2): applied generalized forces
 *   tau[0]  rail.u.tau [N]
 *   tau[1]  hook.u.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  rail.udot [m/s^2]
 *   out[1]  hook.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    w[4] = door_base_mass;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_hook = 1.0 / lamp_origin_inertia_yy;
    w[5] = M_factor_D_inverse_hook;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[2] = p[13]; /* friction.coulomb [N] */
    w[3] = p[15]; /* friction.viscous [N*s/m] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
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

    /* friction: G */
    /* force = -sign(v) (coulomb + (static - coulomb) exp(-(v/stribeck)^2)) - viscous v */
    /* G = d(rate) / du */
    const real friction = s[0];
    const real rail_u = u[0]; /* m/s */
    const wreal friction_coulomb = w[2]; /* N */
    const real friction_eq_two = cardan_eq(friction, 2.0);
    const real friction_coulomb_times_friction_direction = friction_coulomb *
        cardan_select(cardan_eq(0.0, friction), cardan_select(cardan_lt(0.0, rail_u), 1.0,
        cardan_select(cardan_lt(rail_u, 0.0), -1.0, 0.0)), cardan_select(friction_eq_two, 0.0,
        friction));
    const real friction_G_stick_rail = cardan_select(friction_eq_two, 1.0, 0.0);

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
    const real rail_u_tau = tau[0]; /* N */
    const real hook_u = u[1]; /* rad/s */
    const wreal friction_viscous = w[3]; /* N*s/m */
    const real rail_drive = motor_force + rail_u_tau - rail_u * friction_viscous
        + hook_u * hook_u * lamp_first_moment_z * hook_sin
        - friction_coulomb_times_friction_direction;

    /* hook: drive */
    /* drive = tau + f - h */
    const real hook_u_tau = tau[1]; /* N*m */
    const real hook_drive = hook_u_tau - lamp_n_y;

    /* ends: G */
    /* G = d(rate) / du */
    const real ends = s[1];
    const real ends_G_stop_rail = cardan_select(cardan_eq(0.0, ends), 0.0, 1.0);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal door_base_mass = w[4];
    const wreal M_factor_D_inverse_hook = w[5];
    const real M_factor_L_hook_rail = M_hook_rail * M_factor_D_inverse_hook;
    const real M_factor_D_inverse_rail = 1.0 / (door_base_mass
        - M_hook_rail * M_factor_L_hook_rail);
    const real free_udot_rail = M_factor_D_inverse_rail * (rail_drive
        - hook_drive * M_factor_L_hook_rail);
    const real friction_stick_response_rail = friction_G_stick_rail * M_factor_D_inverse_rail;
    const real ends_stop_response_rail = ends_G_stop_rail * M_factor_D_inverse_rail;
    const real circuit_friction_stick_friction_stick = friction_G_stick_rail *
        friction_stick_response_rail;
    circuit_matrix[0][0] = circuit_friction_stick_friction_stick;
    const real circuit_ends_stop_friction_stick = ends_G_stop_rail * friction_stick_response_rail;
    circuit_matrix[0][1] = circuit_ends_stop_friction_stick;
    circuit_matrix[1][0] = circuit_ends_stop_friction_stick;
    const real circuit_ends_stop_ends_stop = ends_G_stop_rail * ends_stop_response_rail;
    circuit_matrix[1][1] = circuit_ends_stop_ends_stop;
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
    /* udot: rail.udot [m/s^2] */
    out[0] = free_udot_rail + friction_stick_response_rail * friction_multiplier_stick
        + ends_stop_response_rail * ends_multiplier_stop;

    /* hook: udot */
    /* udot = free_udot + response multipliers */
    /* udot: hook.udot [rad/s^2] */
    out[1] = hook_drive * M_factor_D_inverse_hook - M_factor_L_hook_rail * free_udot_rail
        - M_factor_L_hook_rail * friction_stick_response_rail * friction_multiplier_stick
        - M_factor_L_hook_rail * ends_stop_response_rail * ends_multiplier_stop;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 13, 6, 0, 2, 2, 0, 4, 0, 19, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
