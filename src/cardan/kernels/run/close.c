/* Projection of a state onto the constraints that close its loops.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Positions by Gauss-Newton steps until their residuals vanish, quaternions normalized, then speeds
 * by one linear step. The steps themselves, in the metric of the mass matrix, are functions of the
 * model; what is decided here is when it is enough and what is too much.
 * Source: E. Eich-Soellner, C. Fuehrer, Numerical Methods in Multibody Dynamics, section 5.3
 * (coordinate projection).
 */
#include "run.h"
#include <float.h>
#include <math.h>

/* residuals relative to the size of the mechanism: what is sought, and what still counts as closed */
static const real SOUGHT = CARDAN_ROUNDING(1e-15, 1e-7), CLOSED = CARDAN_ROUNDING(1e-11, 2e-5);
/* what constraints may be open by at a given step, of the size of the mechanism; what they are
 * rounded by, in units of that */
static const real OPEN = 1e-4, ROUNDED = 1e3;
/* changes of a block, of its largest number and in units of rounding, that say nothing */
static const real NOISE = 16;
enum { MOST_STEPS = 8 };

/* q or u with the function that closes it */
typedef struct level {
    const cardan_call *call;
    real *block;     /* (size), changed in place */
    ptrdiff_t size;
    ptrdiff_t rows;  /* residuals */
    ptrdiff_t first; /* row of the ledger of the first one */
    real scale;      /* against which they count */
} level;

/* Numbers that cardan_close needs: a closed block with residuals, the state before, and a copy. */
ptrdiff_t cardan_closing_length(const cardan_run *run)
{
    if (run->positions + run->rates == 0)
        return 0;
    return cardan_larger_of(run->nq + run->positions, run->nu + run->rates) + run->nx + run->n;
}

/* Index of the largest residual, of the first that is not a number if there is one. */
static ptrdiff_t worst_of(const real *residuals, ptrdiff_t rows)
{
    ptrdiff_t worst = 0;

    for (ptrdiff_t i = 0; i < rows; i++) {
        if (!(residuals[i] - residuals[i] == 0))
            return i;
        if (fabs(residuals[i]) > fabs(residuals[worst]))
            worst = i;
    }
    return worst;
}

/* Enter a residual into the ledger where it is the largest yet. */
static void enter(real *entry, real residual, real t)
{
    if (fabs(residual) > entry[0]) {
        entry[0] = fabs(residual);
        entry[1] = t;
    }
}

/* How fast the scene moves at either end of a step: radians or sizes per second, at least 1, as
 * accounts of a run have it, but not by more than all of it within the step. */
static real pace(const cardan_run *run, real h)
{
    real fastest = 1;

    for (ptrdiff_t i = 0; i < run->nu; i++) {
        const real unit = run->columns ? run->columns[i] : 1;
        const real now = run->y[run->nq + i], then = run->trial[run->nq + i];
        fastest = fmax(fastest, fmax(fabs(now), fabs(then)) / unit);
    }
    return fmin(fastest, 1 / fabs(h));
}

/* Whether a trial closes its constraints, by the tolerance or, at a given step, a part of the size:
 * gaps of positions, then rates from `first` on. Of speeds no step size makes gaps small: they count
 * against how fast the scene moves. reach: size of the scene, at least 1. */
int cardan_gaps_close(const cardan_run *run, const real *gaps, ptrdiff_t first, real h, real reach,
                      int adaptive)
{
    real bound = adaptive ? run->atol + run->rtol * reach : OPEN * reach, far = reach;

    for (ptrdiff_t i = 0; i < run->nq; i++)
        far = cardan_most(far, fabs(run->trial[i]));
    bound += ROUNDED * DBL_EPSILON * far;
    for (ptrdiff_t k = 0; k < run->positions; k++)
        if (!(fabs(gaps[k]) <= bound))
            return 0;
    bound *= pace(run, h);
    for (ptrdiff_t k = first; k < run->rates; k++)
        if (!(fabs(gaps[run->positions + k]) <= bound))
            return 0;
    return 1;
}

/* Enter what a trial leaves of all constraints into the ledger, as before and after a projection. */
void cardan_note_gaps(cardan_run *run, const real *gaps, real t)
{
    for (ptrdiff_t k = 0; k < run->positions + run->rates; k++)
        for (int column = 0; column < 4; column += 2)
            enter(run->ledger + 4 * k + column, gaps[k], t);
}

/* Enter residuals into the ledger where they are the largest yet; column 0: before, 2: after. */
static void note(cardan_run *run, const level *at, real t, const real *residuals, int column)
{
    for (ptrdiff_t i = 0; i < at->rows; i++)
        enter(run->ledger + 4 * (at->first + i) + column, residuals[i], t);
}

static void copy(real *to, const real *from, ptrdiff_t size)
{
    for (ptrdiff_t i = 0; i < size; i++)
        to[i] = from[i];
}

/* Newton steps of one level until its residuals vanish or no longer fall.
 *
 * Returns 0, CARDAN_CONSTRAINT_OPEN where they are not small by then, or CARDAN_MODEL.
 */
static int newton(cardan_run *run, cardan_in *in, const level *at, real *y, int noted)
{
    real *closed = run->closing, *residuals = closed + at->size;
    real last = INFINITY;

    for (int k = 0; k <= MOST_STEPS; k++) {
        ptrdiff_t row;
        real worst;

        run->projections++;
        if (cardan_call_model(run, at->call, in, closed) != 0)
            return CARDAN_MODEL;
        row = worst_of(residuals, at->rows);
        worst = fabs(residuals[row]) / at->scale;
        if (k == 0 && noted)
            note(run, at, *in->t, residuals, 0);
        if (run->open_row < 0)
            run->open_row = at->first + row;
        /* solved, rounding only, or not converging */
        if (!(worst > SOUGHT && worst <= 0.5 * last) || k == MOST_STEPS) {
            if (worst <= CLOSED) {
                if (noted)
                    note(run, at, *in->t, residuals, 2);
                return 0;
            }
            /* a first step from far away may go up before it goes down */
            if (!(worst < INFINITY) || k > 1) {
                run->open_row = at->first + row;
                return CARDAN_CONSTRAINT_OPEN;
            }
        }
        last = worst;
        copy(at->block, closed, at->size);
        cardan_normalize(run, y);
    }
    return CARDAN_CONSTRAINT_OPEN;
}

/* Project one level of y; adds the square of what changes, in units of the tolerance or of rounding,
 * to `sum`: beside a tight tolerance numbers that pass 0 would change by more, however short a step. */
static int close_level(cardan_run *run, cardan_in *in, const level *at, real *y, int noted,
                       real *sum)
{
    const ptrdiff_t start = at->block - y;
    const real *guess = run->closing + cardan_closing_length(run) - run->n - run->nx + start;
    int status = newton(run, in, at, y, noted);
    real far = 0;

    for (ptrdiff_t i = 0; i < at->size; i++)
        far = fmax(far, fabs(guess[i]));
    for (ptrdiff_t i = 0; i < at->size; i++) {
        real scale = fmax(cardan_scale(run, y, start + i), NOISE * DBL_EPSILON * far);
        real step = (at->block[i] - guess[i]) / scale;
        *sum += step * step;
    }
    return status;
}

/* Project y (n) at t onto the constraints.
 *
 * `correction` becomes what that changes: the root mean square over the state, in units of the
 * tolerance. With `noted` the residuals go into the ledger. Returns 0, CARDAN_CONSTRAINT_OPEN, CARDAN_MODEL.
 */
int cardan_close(cardan_run *run, real t, real *y, int noted)
{
    const ptrdiff_t nq = run->nq, nu = run->nu;
    real *guess = run->closing + cardan_closing_length(run) - run->n - run->nx;
    real fastest = 1, sum = 0;
    cardan_in in;
    int status = 0;

    run->correction = 0;
    run->open_row = -1;
    if (run->positions + run->rates == 0)
        return 0;
    (void)cardan_inputs_at(run, t, y);
    in = cardan_at(run, &t, y);
    copy(guess, y, run->nx);
    if (run->positions > 0) {
        const level at = {&run->close_position, y, nq, run->positions, 0, run->size};
        status = close_level(run, &in, &at, y, noted, &sum);
    }
    for (ptrdiff_t i = 0; i < nu; i++)
        fastest = fmax(fastest, fabs(y[nq + i]));
    if (status == 0) {
        const level at = {&run->close_velocity, y + nq, nu, run->rates, run->positions,
                          run->size * fastest};
        status = close_level(run, &in, &at, y, noted, &sum);
    }
    run->correction = sqrt(sum / (real)run->nx);
    return status;
}

/* Project states x (count, nx), each at its time t, with its inputs r and discrete states s. Where
 * positions do not close a state stays what it was; rates that contradict each other, as rounded
 * lengths make them, leave speeds as near as they come. */
void cardan_close_states(cardan_run *run, ptrdiff_t count, const real *t, real *x, const real *r,
                         const real *s)
{
    const real *guess = run->closing + cardan_closing_length(run) - run->n - run->nx;

    for (ptrdiff_t i = 0; i < count && run->stop == 0; i++, x += run->nx) {
        copy(run->r, r + i * run->nr, run->nr);
        copy(run->s, s + i * run->ns, run->ns);
        const int status = cardan_close(run, t[i], x, 0);
        if (status == CARDAN_MODEL || (status != 0 && run->open_row < run->positions))
            copy(x, guess, run->nx);
    }
}
