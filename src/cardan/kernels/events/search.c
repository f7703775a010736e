/* Where in the last step events happen, and the step cut off there.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "events.h"
#include "explicit.h"
#include <float.h>
#include <math.h>

enum { MOST_TRIALS = 150 };

/* Value of event i at a time inside the last step. */
static int value_at(cardan_run *run, const cardan_board *at, ptrdiff_t i, real t, real *value)
{
    int status = cardan_run_at(run, t, at->y);

    if (status == 0)
        status = cardan_event_values(run, t, at->y, at->probe);
    *value = at->probe[i];
    return status;
}

/* What two times of the last step differ by at least. */
static real resolution(const cardan_run *run, real a, real b)
{
    return 2 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(run->t - run->t_old));
}

/* Where event i plus `shift`, positive at a and not so at b, falls through zero: a time where it
 * has, next to one where it has not.
 *
 * Secants that halve the value of an end which stays (Illinois), every fourth time the middle.
 */
static int locate(cardan_run *run, const cardan_board *at, ptrdiff_t i, real a, real b, real fa,
                  real fb, real shift)
{
    int status = 0, side = 0;

    for (int trial = 0; trial < MOST_TRIALS && status == 0; trial++) {
        real width = b - a, fine = resolution(run, a, b), part, t, f;

        if (fabs(width) <= fine)
            break;
        part = trial % 4 == 3 ? 0.5 : fa / (fa - fb);
        part = fabs(width) * (part >= 0 && part <= 1 ? part : 0.5);
        t = a + copysign(fmin(fmax(part, 0.5 * fine), fabs(width) - 0.5 * fine), width);
        if (t == a || t == b)
            break;
        status = value_at(run, at, i, t, &f);
        f += shift;
        if (f > 0) {
            a = t, fa = f;
            fb = side == 1 ? 0.5 * fb : fb;
            side = 1;
        } else {
            b = t, fb = f;
            fa = side == -1 ? 0.5 * fa : fa;
            side = -1;
        }
    }
    at->root[i] = b;
    return status;
}

/* Where a binding event falls that was about zero at a and is negative at b: it rose before, be it
 * ever so little, or went down at once.
 */
static int locate_sunk(cardan_run *run, const cardan_board *at, ptrdiff_t i, real a, real b,
                       real fa, real fb)
{
    const real low = cardan_event_threshold(at, i);
    real t = b, f;
    int status = 0;

    for (;;) {
        t = a + 0.5 * (t - a);
        if (fabs(t - a) <= resolution(run, a, t))
            break;
        status = value_at(run, at, i, t, &f);
        if (status != 0)
            return status;
        if (f > low) {
            cardan_arm(at, i, f);
            return locate(run, at, i, t, b, f, fb, 0);
        }
        if (f < -low)
            b = t, fb = f;
    }
    return locate(run, at, i, a, b, fmax(fa + low, 0), fb + low, low);
}

/* Express the dense output by a part of the step: theta = part phi. Both in the form of
 * cardan_interpolate, by way of powers.
 */
static void shorten(const cardan_run *run, real part)
{
    const ptrdiff_t d = run->dense_rows, n = run->n;
    real a[CARDAN_MOST_ROWS + 1];

    for (ptrdiff_t i = 0; i < n; i++) {
        real scale = part;

        for (ptrdiff_t k = 0; k <= d; k++)
            a[k] = 0;
        for (ptrdiff_t j = d - 1; j >= 0; j--) {
            a[0] += run->interpolant[j * n + i];
            for (ptrdiff_t k = d; k > 0; k--)
                a[k] = j % 2 == 0 ? a[k - 1] : a[k] - a[k - 1];
            a[0] = j % 2 == 0 ? 0 : a[0];
        }
        for (ptrdiff_t k = 1; k <= d; k++, scale *= part)
            a[k] *= scale;
        for (ptrdiff_t j = 0; j < d; j++) {
            real row = 0;
            if (j % 2 == 0) {
                /* divided by phi; what is left after the row vanishes at phi = 1 */
                for (ptrdiff_t k = 0; k < d; k++)
                    row += a[k] = a[k + 1];
                a[d] = 0;
            } else {
                /* divided by 1 - phi; what is left vanishes at phi = 0 */
                for (ptrdiff_t k = 1; k <= d; k++)
                    a[k] += a[k - 1];
                row = a[0];
            }
            a[0] -= row;
            run->interpolant[j * n + i] = row;
        }
    }
}

/* End the last step at an earlier time. */
static int cut(cardan_run *run, const cardan_board *at, real t)
{
    int status;

    if (t == run->t)
        return 0;
    status = cardan_run_at(run, t, at->y);
    if (status != 0)
        return status;
    shorten(run, (t - run->t_old) / (run->t - run->t_old));
    for (ptrdiff_t i = 0; i < run->n; i++)
        run->y[i] = at->y[i];
    /* what projection adds is in the chord */
    cardan_arrive(run, run->interpolant, run->trial);
    run->t = t;
    run->fresh = 0;
    return 0;
}

static real time_of(const cardan_run *run, real theta)
{
    return theta == 1 ? run->t : run->t_old + theta * (run->t - run->t_old);
}

/* Find every event of the interval that ends at sample k. Returns a status, `any` whether any. */
static int find(cardan_run *run, const cardan_board *at, ptrdiff_t k, int *any)
{
    const real *before = at->values + (k - 1) * at->m, *after = before + at->m;
    const real a = time_of(run, at->theta[k - 1]), b = time_of(run, at->theta[k]);
    int status = 0;

    *any = 0;
    for (ptrdiff_t i = 0; i < at->m && status == 0; i++) {
        at->root[i] = NAN;
        if (run->kinds[i] == CARDAN_TICK)
            continue;
        cardan_arm(at, i, before[i]);
        if (at->armed[i] != 0 && after[i] <= 0)
            status = before[i] > 0 ? locate(run, at, i, a, b, before[i], after[i], 0)
                                   : (at->root[i] = a, 0);
        else if (at->armed[i] == 0 && cardan_is_binding(run, i)
                 && after[i] < -cardan_event_threshold(at, i))
            status = locate_sunk(run, at, i, a, b, before[i], after[i]);
        *any |= !isnan(at->root[i]);
    }
    return status;
}

/* The earliest event found, of marks or of the others; -1 if there is none. */
static ptrdiff_t earliest(const cardan_run *run, const cardan_board *at, int marks)
{
    const real sign = copysign(1, run->t - run->t_old);
    ptrdiff_t first = -1;

    for (ptrdiff_t i = 0; i < at->m; i++)
        if (!isnan(at->root[i]) && (run->kinds[i] == CARDAN_MARK) == marks
            && (first < 0 || (at->root[i] - at->root[first]) * sign < 0))
            first = i;
    return first;
}

/* Note the marks up to an event, or all of them. */
static int note_marks(cardan_run *run, const cardan_board *at, ptrdiff_t event)
{
    const real sign = copysign(1, run->t - run->t_old);
    ptrdiff_t mark;

    while ((mark = earliest(run, at, 1)) >= 0) {
        real t = at->root[mark];
        int status;

        if (event >= 0 && (t - at->root[event]) * sign > 0)
            break;
        status = cardan_run_at(run, t, at->y);
        if (status != 0)
            return status;
        run->e[mark] = 1;
        cardan_note(run, t, at->y);
        run->occurred++;
        run->e[mark] = at->armed[mark] = 0;
        at->root[mark] = NAN;
    }
    return 0;
}

/* End the step at an event; those of the same time happen with it. */
static int fire(cardan_run *run, const cardan_board *at, ptrdiff_t event, const real *before,
                real start)
{
    const real t = at->root[event], same = 8 * resolution(run, start, t);
    int status = cut(run, at, t);

    if (status == 0)
        status = cardan_event_values(run, t, run->y, at->g);
    for (ptrdiff_t i = 0; i < at->m && status == 0; i++) {
        real fall = before[i] - at->g[i];
        int simultaneous = !isnan(at->root[i]) && fabs(at->root[i] - t) <= same;
        /* rounding has it a little later */
        int late = at->armed[i] != 0 && fall > 0 && t != start
                   && at->g[i] <= fmax(cardan_event_threshold(at, i), fall / fabs(t - start) * same);

        if (run->kinds[i] != CARDAN_MARK && run->kinds[i] != CARDAN_TICK)
            run->e[i] = simultaneous || late;
    }
    run->event_pending = 1;
    return status;
}

/* What happened in the last step: marks are noted, it ends at the first other event. */
int cardan_events_seek(cardan_run *run)
{
    const cardan_board at = cardan_board_of(run);
    ptrdiff_t count = 0;
    int status;

    if (at.m == 0)
        return 0;
    status = cardan_samples_of(run, &at, &count);
    for (ptrdiff_t k = 1; k < count && status == 0; k++) {
        const real start = time_of(run, at.theta[k - 1]);
        ptrdiff_t event;
        int any;

        status = find(run, &at, k, &any);
        if (status != 0 || !any)
            continue;
        event = earliest(run, &at, 0);
        status = note_marks(run, &at, event);
        if (status == 0 && event >= 0)
            return fire(run, &at, event, at.values + (k - 1) * at.m, start);
    }
    for (ptrdiff_t i = 0; i < at.m && status == 0; i++) {
        at.g[i] = at.values[(count - 1) * at.m + i];
        cardan_arm(&at, i, at.g[i]);
    }
    return status;
}
