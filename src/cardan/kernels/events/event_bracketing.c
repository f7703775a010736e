/* Values of events inside the last step: where to look for two changes of sign.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Five samples at even distances see every event whose value stays negative for a quarter of a
 * step. One that dips below zero between them is seen by the polynomial through the five: where
 * that comes near zero the value itself is taken, and then at the lowest point of parabolas.
 */
#include "events.h"
#include <math.h>

enum { FINE = 32, MOST_LOOKS = 6 };
static const real NEAR = 0.1; /* of the range of the samples: as near to zero as to look closer */

/* The sample at theta, in its place among the others. */
static int sample(cardan_run *run, const cardan_board *at, real theta, ptrdiff_t *count)
{
    const ptrdiff_t m = at->m;
    real t = theta == 1 ? run->t : run->t_old + theta * (run->t - run->t_old);
    ptrdiff_t k = *count;
    int status = cardan_run_at(run, t, at->y);

    while (k > 0 && at->theta[k - 1] > theta) {
        at->theta[k] = at->theta[k - 1];
        for (ptrdiff_t i = 0; i < m; i++)
            at->values[k * m + i] = at->values[(k - 1) * m + i];
        k--;
    }
    at->theta[k] = theta;
    (*count)++;
    return status != 0 ? status : cardan_event_values(run, t, at->y, at->values + k * m);
}

/* The polynomial through the five first samples of event i at theta, by Newton's differences. */
static real fitted(const real *differences, real theta)
{
    real x = theta * (cardan_samples - 1), sum = differences[cardan_samples - 1];

    for (int k = cardan_samples - 2; k >= 0; k--)
        sum = differences[k] + (x - (real)k) / (real)(k + 1) * sum;
    return sum;
}

/* Where the polynomial through the samples of event i is lowest, if it comes near zero there while
 * all samples are positive; else a negative number.
 */
static real suspicion(const cardan_board *at, ptrdiff_t i)
{
    real d[cardan_samples], high = -INFINITY, low = INFINITY, lowest = INFINITY, where = -1;

    for (int k = 0; k < cardan_samples; k++) {
        d[k] = at->values[k * at->m + i];
        high = fmax(high, d[k]);
        low = fmin(low, d[k]);
    }
    if (low < 0 || high == low)
        return -1;
    for (int order = 1; order < cardan_samples; order++)
        for (int k = cardan_samples - 1; k >= order; k--)
            d[k] -= d[k - 1];
    for (int k = 1; k < FINE; k++) {
        real value = fitted(d, (real)k / (real)FINE);
        if (value < lowest) {
            lowest = value;
            where = (real)k / (real)FINE;
        }
    }
    return lowest < NEAR * (high - low) ? where : -1;
}

/* The next place to look at: the lowest point of the parabola around the lowest inner sample of
 * event i, or a negative number where that is known well enough.
 */
static real lower(const cardan_board *at, ptrdiff_t i, ptrdiff_t count)
{
    ptrdiff_t k = 1;
    real a, b, c, fa, fb, fc, top, base, where;

    for (ptrdiff_t j = 2; j + 1 < count; j++)
        if (at->values[j * at->m + i] < at->values[k * at->m + i])
            k = j;
    a = at->theta[k - 1], b = at->theta[k], c = at->theta[k + 1];
    fa = at->values[(k - 1) * at->m + i], fb = at->values[k * at->m + i];
    fc = at->values[(k + 1) * at->m + i];
    if (fb <= 0 || fb > fa || fb > fc)
        return -1;
    top = (b - a) * (b - a) * (fb - fc) - (b - c) * (b - c) * (fb - fa);
    base = (b - a) * (fb - fc) - (b - c) * (fb - fa);
    where = b - 0.5 * top / base;
    return where > a && where < c && fabs(where - b) > 1e-6 * (c - a) ? where : -1;
}

/* Values at the samples of the last step, `count` of them in the order of time. */
int cardan_samples_of(cardan_run *run, const cardan_board *at, ptrdiff_t *count)
{
    int status = 0;

    /* the first one is known */
    at->theta[0] = 0;
    for (ptrdiff_t i = 0; i < at->m; i++)
        at->values[i] = at->g[i];
    *count = 1;
    for (int k = 1; k < cardan_samples && status == 0; k++)
        status = sample(run, at, (real)k / (cardan_samples - 1), count);
    for (ptrdiff_t i = 0; i < at->m && status == 0; i++)
        at->root[i] = run->kinds[i] == CARDAN_TICK ? -1 : suspicion(at, i);
    for (ptrdiff_t i = 0; i < at->m && status == 0; i++) {
        real where = at->root[i];
        for (int k = 0; k < MOST_LOOKS && where > 0 && *count < cardan_most_samples; k++) {
            status = sample(run, at, where, count);
            where = status == 0 ? lower(at, i, *count) : -1;
        }
    }
    return status;
}
