/*
 * transition of bay
 * speeds, internal and discrete states behind the events e
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 5, w 3
 * Operations per call: 27 = 9 select, 6 mul, 2 abs, 2 eq, 2 le, 2 sub, 1 add, 1 lt, 1 neg, 1 solve
 * Operations of prepare: 1 = 1 div
 *
 * Input u (2): generalized speeds
 *   u[0]  height.u [m/s]
 *   u[1]  twist.u [rad/s]
 *
 * Input s (1): discrete states
 *   s[0]  end
 *
 * Input p (55): parameters, read by prepare_ only
 *
 * Input e (2): events that happened, 1 or 0
 *   e[0]  end.upper
 *   e[1]  end.release
 *
 * Output u (2)
 *   out[0]  height.u [m/s]
 *   out[1]  twist.u [rad/s]
 *
 * Output z (0): empty
 *
 * Output s (1)
 *   out[2]  end
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_transition(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal top_inertia_zz = p[22]; /* kg m^2 */
    const wreal M_factor_D_inverse_twist = 1.0 / top_inertia_zz;
    w[2] = M_factor_D_inverse_twist;

    /* parameters as they are */
    w[0] = p[43]; /* end.restitution */
    w[1] = p[44]; /* end.settle [rad/s] */
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
    int status = CARDAN_OK;

    /* end: impulse */
    const real end_upper = e[0];
    const real end = s[0];
    const real end_eq_one = cardan_eq(1.0, end);
    const real end_upper_active = cardan_select(end_eq_one, 1.0, end_upper);

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const real twist_u = u[1]; /* rad/s */
    const wreal end_restitution = w[0];
    const wreal end_settle = w[1]; /* rad/s */
    const real missing_speed_end_upper = end_upper_active * (twist_u
        + cardan_select(end_eq_one, 0.0, cardan_select(cardan_lt(-twist_u, 0.0),
        cardan_select(cardan_le(twist_u, end_settle), 0.0, twist_u * end_restitution), -twist_u)));
    impact_right[0] = missing_speed_end_upper;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_twist = w[2];
    const real end_upper_minus_response_twist = end_upper_active * M_factor_D_inverse_twist;

    /* impact: speeds */
    /* speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask */
    const real impact_end_upper_end_upper = end_upper_active * end_upper_minus_response_twist;
    impact_matrix[0] = impact_end_upper_end_upper;
    /* impact_matrix lam = impact_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, impact_matrix, impact_right, impact_scratch);
    const real end_upper_impulse = impact_right[0];
    const real behind_twist = twist_u - end_upper_minus_response_twist * end_upper_impulse;
    out[1] = behind_twist; /* u: twist.u [rad/s] */

    /* end: change */
    const real end_release = e[1];
    const real end_change_at_rest = cardan_le(cardan_abs(behind_twist)
        - 1e-12 * cardan_abs(twist_u), 1e-12);
    /* s: end */
    out[2] = cardan_select(end_release, 0.0, cardan_select(end_upper,
        cardan_select(end_change_at_rest, 1.0, 0.0), cardan_select(cardan_eq(0.0, end), 0.0,
        cardan_select(end_change_at_rest, end, 0.0))));

    /* results that are numbers or inputs */
    out[0] = u[0]; /* u: height.u [m/s] */
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int transition_sizes[] = {3, 5, 3, 0, 0, 2, 0, 1, 0, 55, 0, 0, 0, 0, 0, 0, 0, 0, 2};
#endif
