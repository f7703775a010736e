/* What a run has done with its energy, as far as its rows tell.
 *
 * Part of cardan. Caller owns all memory. What is not a number stays one in every result.
 */
#include "account.h"
#include <math.h>

static real larger(real a, real b)
{
    return a >= b || a != a ? a : b;
}

/* Difference between the largest and the least of (count) numbers, `stride` from one to the next. */
static real range(const real *x, ptrdiff_t count, ptrdiff_t stride)
{
    real high = x[0], low = -x[0];

    for (ptrdiff_t i = 1; i < count; i++) {
        high = larger(high, x[i * stride]);
        low = larger(low, -x[i * stride]);
    }
    return high + low;
}

/* How often (count) numbers turn back. */
static real turns(const real *x, ptrdiff_t count, ptrdiff_t stride)
{
    ptrdiff_t sum = 0;

    for (ptrdiff_t i = 1; i + 1 < count; i++) {
        const real here = x[i * stride];
        sum += (x[(i + 1) * stride] - here) * (here - x[(i - 1) * stride]) < 0;
    }
    return (real)sum;
}

static void look_at_speeds(cardan_account *a)
{
    real widest = 0;

    a->fastest = a->turns = 0;
    for (ptrdiff_t i = 0; i < a->count; i++)
        for (ptrdiff_t j = 0; j < a->nu; j++)
            a->fastest = larger(a->fastest, fabs(a->u[i * a->stride + j]));
    if (!a->every_step)
        return;
    for (ptrdiff_t j = 0; j < a->nu; j++)
        widest = larger(widest, range(a->u + j, a->count, a->stride));
    for (ptrdiff_t j = 0; j < a->nu; j++)
        if (range(a->u + j, a->count, a->stride) > a->least * widest)
            a->turns = larger(a->turns, turns(a->u + j, a->count, a->stride));
}

/* Fill in what comes out. */
void cardan_account_of(cardan_account *a)
{
    look_at_speeds(a);
    a->kinetic = a->potential = a->exchanged = a->missed = 0;
    for (ptrdiff_t k = 0; k < a->looked; k++) {
        const real *energy = a->energy + 3 * k;
        real missed = energy[2] - a->energy[2];
        for (ptrdiff_t j = 0; j < a->sources; j++)
            missed -= a->supplied[k * a->sources + j];
        a->kinetic = larger(a->kinetic, energy[0]);
        a->potential = larger(a->potential, fabs(energy[1]));
        a->missed = larger(a->missed, fabs(missed));
    }
    if (a->looked == 0)
        return;
    a->exchanged = range(a->energy + 1, a->looked, 3);
    for (ptrdiff_t j = 0; j < a->sources; j++)
        a->exchanged += range(a->supplied + j, a->looked, a->sources);
}
