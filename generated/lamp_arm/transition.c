/*
 * transition of lamp_arm
 * speeds, internal and discrete states behind the events e
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 5, w 7
 * Operations per call: 43 = 15 mul, 9 select, 5 add, 3 sub, 2 abs, 2 eq, 2 le, 1 cos, 1 div, 1 lt,
 *     1 neg, 1 solve
 * Operations of prepare: 11 = 6 mul, 4 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input s (1): discrete states
 *   s[0]  stop
 *
 * Input p (15): parameters, read by prepare_ only
 *
 * Input e (2): events that happened, 1 or 0
 *   e[0]  stop.upper
 *   e[1]  stop.release
 *
 * Output u (2)
 *   out[0]  shoulder.u [rad/s]
 *   out[1]  elbow.u [rad/s]
 *
 * Output z (0): empty
 *
 * Output s (1)
 *   out[2]  stop
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_transition(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_mass = p[1]; /* kg */
    const wreal upper_com_z = p[2]; /* m */
    const wreal upper_inertia_yy = p[4]; /* kg m^2 */
    const wreal elbow_position_z = p[5]; /* m */
    const wreal lower_mass = p[6]; /* kg */
    const wreal upper_first_moment_z = upper_mass * upper_com_z;
    const wreal upper_origin_inertia_yy = upper_inertia_yy + upper_com_z * upper_first_moment_z;
    const wreal upper_base_inertia_yy = upper_origin_inertia_yy
        + elbow_position_z * lower_mass * elbow_position_z;

    /* lower: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal lower_com_z = p[7]; /* m */
    const wreal lower_inertia_yy = p[9]; /* kg m^2 */
    const wreal lower_first_moment_z = lower_mass * lower_com_z;
    const wreal lower_origin_inertia_yy = lower_inertia_yy + lower_com_z * lower_first_moment_z;
    w[1] = lower_first_moment_z;
    w[2] = lower_origin_inertia_yy;

    /* upper: inertia */
    const wreal lower_origin_inertia_yy_plus_upper_base_inertia_yy = lower_origin_inertia_yy
        + upper_base_inertia_yy;
    w[5] = lower_origin_inertia_yy_plus_upper_base_inertia_yy;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_elbow = 1.0 / lower_origin_inertia_yy;
    w[6] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[5]; /* elbow.position.z [m] */
    w[3] = p[13]; /* stop.restitution */
    w[4] = p[14]; /* stop.settle [rad/s] */
}

#include "lanes.h"

/* speeds, internal and discrete states behind the events e */
CARDAN_API int transition(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    const real *const e = in->e;
    real *const impact_matrix = work + 0;
    real *const impact_right = work + 1;
    real *const impact_scratch = work + 2;
    int status = CARDAN_OK;

    /* elbow: R */
    /* R = R_fixed R_joint(q) */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {elbow_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real elbow_cos = cosine[0];

    /* stop: impulse */
    const real stop_upper = e[0];
    const real stop = s[0];
    const real stop_eq_one = cardan_eq(1.0, stop);
    const real stop_upper_active = cardan_select(stop_eq_one, 1.0, stop_upper);

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const real elbow_u = u[1]; /* rad/s */
    const wreal stop_restitution = w[3];
    const wreal stop_settle = w[4]; /* rad/s */
    const real missing_speed_stop_upper = stop_upper_active * (elbow_u
        + cardan_select(stop_eq_one, 0.0, cardan_select(cardan_lt(-elbow_u, 0.0),
        cardan_select(cardan_le(elbow_u, stop_settle), 0.0, elbow_u * stop_restitution),
        -elbow_u)));
    impact_right[0] = missing_speed_stop_upper;

    /* shared by several: inertia */
    const wreal elbow_position_z = w[0]; /* m */
    const wreal lower_first_moment_z = w[1];
    const real elbow_position_z_times_upper_inertia_mean_moment_z = lower_first_moment_z * elbow_cos
        * elbow_position_z;

    /* upper: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal lower_origin_inertia_yy_plus_upper_base_inertia_yy = w[5];
    const real upper_composite_inertia_yy = 2.0 * elbow_position_z_times_upper_inertia_mean_moment_z
        + lower_origin_inertia_yy_plus_upper_base_inertia_yy;

    /* M */
    /* M = S . momentum */
    const wreal lower_origin_inertia_yy = w[2];
    const real M_elbow_shoulder = lower_origin_inertia_yy
        + elbow_position_z_times_upper_inertia_mean_moment_z;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_elbow = w[6];
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;
    const real stop_upper_response_shoulder = 1.0 / (upper_composite_inertia_yy
        - M_elbow_shoulder * M_factor_L_elbow_shoulder) * (stop_upper_active *
        M_factor_L_elbow_shoulder);
    const real stop_upper_minus_response_elbow = stop_upper_active * M_factor_D_inverse_elbow
        + M_factor_L_elbow_shoulder * stop_upper_response_shoulder;

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const real shoulder_u = u[0]; /* rad/s */
    const real impact_stop_upper_stop_upper = stop_upper_active * stop_upper_minus_response_elbow;
    impact_matrix[0] = impact_stop_upper_stop_upper;
    /* impact_matrix lam = impact_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, impact_matrix, impact_right, impact_scratch);
    const real stop_upper_impulse = impact_right[0];
    const real behind_elbow = elbow_u - stop_upper_minus_response_elbow * stop_upper_impulse;
    /* u: shoulder.u [rad/s] */
    out[0] = shoulder_u + stop_upper_response_shoulder * stop_upper_impulse;
    out[1] = behind_elbow; /* u: elbow.u [rad/s] */

    /* stop: change */
    const real stop_release = e[1];
    const real stop_change_at_rest = cardan_le(cardan_abs(behind_elbow)
        - 1e-12 * cardan_abs(elbow_u), 1e-12);
    /* s: stop */
    out[2] = cardan_select(stop_release, 0.0, cardan_select(stop_upper,
        cardan_select(stop_change_at_rest, 1.0, 0.0), cardan_select(cardan_eq(0.0, stop), 0.0,
        cardan_select(stop_change_at_rest, stop, 0.0))));
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int transition_sizes[] = {3, 5, 7, 0, 2, 2, 0, 1, 0, 15, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0};
#endif
