/* Tangent of the generalized-alpha method by central differences, for models without a derived one.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Coordinates are perturbed along the speeds, as steps move them. The balance is linear in udot,
 * and the rates of constraints are linear in u.
 */
#include "alpha.h"
#include <float.h>
#include <math.h>

enum { ALONG_Q, ALONG_U, ALONG_UDOT };

/* Balance, g and rates of a state perturbed by `by` along speed j. */
static int moved_balance(cardan_run *run, const cardan_alpha *v, cardan_in in, int what, ptrdiff_t j,
                         real by, real *out)
{
    real *other = v->probe, *place = other + v->nu + 2 * v->size;
    const real *from = what == ALONG_UDOT ? in.udot : in.u;
    int status = 0;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        other[i] = what == ALONG_Q ? 0 : from[i];
    other[j] += by;
    if (what == ALONG_Q) {
        in.du = other;
        status = cardan_call_model(run, &run->move, &in, place);
        in.q = place;
    } else if (what == ALONG_U)
        in.u = other;
    else
        in.udot = other;
    return status != 0 ? status : cardan_call_model(run, &run->balance, &in, out);
}

/* Size of the perturbation, relative to the change in a step and to the size of the motion. */
static real nudge(const cardan_run *run, const cardan_alpha *v, const real *speeds, int what,
                  ptrdiff_t j)
{
    const real least = run->rtol > 0 ? run->atol / run->rtol : 0;
    real size = what == ALONG_Q ? fabs(run->h * speeds[j]) : fabs(speeds[j]);

    if (what == ALONG_Q && v->nq == v->nu)
        size = fmax(size, v->amplitude[j]);
    size = fmax(size, least);
    return pow(DBL_EPSILON, 1.0 / 3) * (size > 0 ? size : 1);
}

/* K, C, M (nu, nu) each, then R and G (m, nu) each, written to `tangent`. */
int cardan_alpha_differences(cardan_run *run, const cardan_alpha *v, real t, const real *y,
                             const real *udot, const real *lam)
{
    const ptrdiff_t nu = v->nu, m = v->m, rates = nu + v->mp;
    real *up = v->probe + nu, *down = up + v->size;
    cardan_in in = cardan_at(run, &t, y);
    int status = 0;

    in.udot = udot;
    in.lam = lam;
    for (int what = ALONG_Q; what <= ALONG_UDOT; what++)
        for (ptrdiff_t j = 0; j < nu && status == 0; j++) {
            const real by = nudge(run, v, what == ALONG_UDOT ? udot : y + v->nq, what, j);
            real *matrix = v->tangent + what * nu * nu;

            run->evaluations += 2;
            status = moved_balance(run, v, in, what, j, by, up);
            if (status == 0)
                status = moved_balance(run, v, in, what, j, -by, down);
            for (ptrdiff_t i = 0; i < nu; i++)
                matrix[i * nu + j] = (up[i] - down[i]) / (2 * by);
            for (ptrdiff_t k = 0; k < m && what != ALONG_UDOT; k++)
                v->tangent[3 * nu * nu + (what * m + k) * nu + j] =
                    (up[rates + k] - down[rates + k]) / (2 * by);
        }
    return status;
}
