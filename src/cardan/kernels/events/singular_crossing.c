/* Steps over places where branches of a motion meet.
 *
 * Part of cardan. Caller owns all memory.
 *
 * There the constraints lose rank: accelerations are not defined at the place itself, and beside it
 * whatever is off the constraints, be it rounding, is magnified by the inverse of the distance in
 * positions, by its square in speeds and by its cube in accelerations. But along a branch the motion
 * is smooth. So a step that begins and ends where the constraints hold well leads over the place by
 * collocation: the derivative is a polynomial through its values at Gauss points, none of them next
 * to the place, each taken on the constraints. No polynomial fits a motion that goes on along
 * another branch: it is continuous in its speeds, or the step is not taken.
 * Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * section II.7 (collocation, Gauss formulas).
 */
#include "dependent.h"
#include "events.h"
#include "explicit.h"
#include "gauss.h"
#include <math.h>

enum { FEWEST_POINTS = 6, MOST_SWEEPS = 40, LENGTHS = 3, MOST_LENGTHS = 8 };
static const real WINDOW = 0.25; /* radians or sizes: a step is at least as long, error permitting */
static const real NEAREST = 0.01; /* radians or sizes: nearer than that no step is tried */
static const real MIN_SPACING = 0.03;  /* of the step: how far Gauss points are from the place, at least */
static const real ENOUGH = 1e-2; /* of the tolerance: where sweeps end */
static const real ROUNDING = 1e-14; /* relative, times the inverse cube of the distance: at most */
static const real PATIENT = 1e-3; /* of that: what it usually is */
static const real FIXED_STEP_TOL = 1e-7; /* tolerance of a step over a place where steps are given */
static const real ACCEPTABLE = 10;    /* residuals and last coefficients, in units of the tolerance */

/* Numbers that are kept: derivatives at the points, those of the last sweep, the start. */
ptrdiff_t cardan_crossing_length(const cardan_run *run)
{
    return run->constraint_jacobian.function ? (2 * MOST_POINTS + 1) * run->n : 0;
}

/* to (n) = from + h sum of w f (count, n). */
static void add(const cardan_run *run, real h, const real *w, const real *f, ptrdiff_t count,
                const real *from, real *to)
{
    for (ptrdiff_t i = 0; i < run->n; i++) {
        real sum = 0;
        for (ptrdiff_t j = 0; j < count; j++)
            sum += w[j] * f[j * run->n + i];
        to[i] = from[i] + h * sum;
    }
}

/* f (n) at t, y (n), which is put onto the constraints. */
static int on_constraints(cardan_run *run, real t, real *y, real *f)
{
    int status;

    cardan_normalize(run, y);
    status = cardan_close(run, t, y, 0);
    return status == 0 ? cardan_derivative(run, t, y, f) : status;
}

/* First derivatives f (s, n): each by extrapolation of those before it. */
static int predict(cardan_run *run, const gauss *at, real *f, real *y)
{
    const ptrdiff_t n = run->n;
    real points[MOST_POINTS + 1], w[MOST_POINTS + 1], last = 0;
    /* slopes at the start and at points so far, where the last sweep will be */
    real *available = f + MOST_POINTS * n;
    int status = 0;

    points[0] = 0;
    for (ptrdiff_t i = 0; i < n; i++) {
        available[i] = run->f[i];
        y[i] = run->y[i];
    }
    for (ptrdiff_t k = 0; k < at->s && status == 0; k++) {
        integral(points, k < MOST_POINTS ? k + 1 : k, last, at->points[k], w);
        add(run, at->h, w, available, k + 1, y, y);
        last = points[k + 1] = at->points[k];
        status = on_constraints(run, run->t + last * at->h, y, f + k * n);
        for (ptrdiff_t i = 0; i < n && k + 1 < MOST_POINTS; i++)
            available[(k + 1) * n + i] = f[k * n + i];
    }
    return status;
}

/* Largest entry of h (f - g) (s, n) over the state in units of the tolerance. */
static real change(const cardan_run *run, const gauss *at, const real *f, const real *g)
{
    real worst = 0;

    for (ptrdiff_t k = 0; k < at->s; k++)
        for (ptrdiff_t i = 0; i < run->nx; i++) {
            real scale = cardan_scale(run, run->y, i);
            real off = fabs(at->h * at->weights[k] * (f[k * run->n + i] - g[k * run->n + i])) / scale;
            worst = cardan_worst(worst, off);
        }
    return worst;
}

/* The error that is good enough, in units of the tolerance: 1, or what rounding makes of it; `share`
 * of that where the place may be tried from nearer. */
static real allowed(const cardan_run *run, const gauss *at, real share)
{
    const real distance = at->spacing * fabs(at->h) / cardan_span(run);

    return fmax(1, share * ROUNDING / (distance * distance * distance) / cardan_finest(run));
}

/* Solve for derivatives f (s, n) at the points: sweeps until they change no more. */
static int sweeps(cardan_run *run, const gauss *at, real *f, real *y)
{
    const ptrdiff_t n = run->n;
    real *old = f + MOST_POINTS * n, w[MOST_POINTS], last = INFINITY;
    int status = predict(run, at, f, y);

    for (int k = 0; k < MOST_SWEEPS && status == 0; k++) {
        real worst, correction = 0;
        for (ptrdiff_t i = 0; i < at->s * n; i++)
            old[i] = f[i];
        for (ptrdiff_t j = 0; j < at->s && status == 0; j++) {
            integral(at->points, at->s, 0, at->points[j], w);
            add(run, at->h, w, old, at->s, run->y, y);
            status = on_constraints(run, run->t + at->points[j] * at->h, y, f + j * n);
            correction = cardan_worst(correction, run->correction);
        }
        worst = status == 0 ? change(run, at, f, old) : 0;
        run->correction = correction;
        /* solved, or as far as rounding lets it */
        if (worst <= (run->on_grid ? 0 : ENOUGH) || (worst <= 10 * allowed(run, at, 1) && worst > 0.5 * last))
            return status;
        if (!(worst < INFINITY) || (k > 3 && worst > 2 * last))
            return CARDAN_CONSTRAINT_OPEN;
        last = worst;
    }
    return status == 0 ? CARDAN_CONSTRAINT_OPEN : status;
}

/* Error of the state, from how fast the coefficients of Legendre's polynomials fall. */
static real error_of(const cardan_run *run, const gauss *at, const real *f)
{
    real worst = 0, p[MOST_POINTS + 1];

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        real c[4] = {0}, scale = cardan_scale(run, run->trial, i), last, before;
        for (ptrdiff_t k = 0; k < at->s; k++) {
            legendre(2 * at->points[k] - 1, at->s, p);
            for (int j = 0; j < 4; j++)
                c[j] += at->weights[k] * p[at->s - 1 - j] * f[k * run->n + i];
        }
        /* the pair left out is to the last one as that to the one before */
        last = fabs(c[0]) + fabs(c[1]);
        before = fabs(c[2]) + fabs(c[3]);
        last *= fmin(1, last / fmax(before, 1e-300));
        worst = cardan_worst(worst, fabs(at->h) * last / scale);
    }
    return worst / (real)(2 * at->s);
}

/* Points of a step of length h over a place `tau` ahead; 0 where none keep apart from it. */
static int choose(real tau, real h, gauss *at)
{
    real best = 0;

    lay(at, MOST_POINTS);
    for (ptrdiff_t s = MOST_POINTS; s >= FEWEST_POINTS; s--) {
        gauss other = {0};
        real spacing = INFINITY;
        lay(&other, s);
        for (ptrdiff_t k = 0; k < s; k++)
            spacing = fmin(spacing, fabs(other.points[k] - tau / h));
        /* more points if that is not much nearer */
        if (spacing > 1.5 * best || (best < MIN_SPACING && spacing > best)) {
            best = spacing;
            *at = other;
        }
    }
    at->h = h;
    at->spacing = best;
    return best >= 0.5 * MIN_SPACING;
}

/* Parts of a step of length h: of the grid, or as its dense output and the longest step ask. */
static ptrdiff_t parts_of(const cardan_run *run, real h)
{
    const real fewest = run->dense_rows >= 6 ? 3 : 9;

    return (ptrdiff_t)(run->on_grid ? h / run->h + 0.5 : fmax(fewest, ceil(fabs(h) / run->max_step)));
}

/* Try a step of length h over a place `tau` ahead; `error` becomes its error in tolerances. */
static int attempt(cardan_run *run, real tau, real h, real share, real *error)
{
    real *f = run->crossing, *y = f + 2 * MOST_POINTS * run->n;
    gauss at = {0};
    int status;

    *error = INFINITY;
    if (!choose(tau, h, &at))
        return CARDAN_CONSTRAINT_OPEN;
    status = sweeps(run, &at, f, y);
    if (status != 0)
        return status;
    *error = cardan_worst(0, run->correction);
    add(run, h, at.weights, f, at.s, run->y, run->trial);
    *error = cardan_worst(*error, error_of(run, &at, f)) / ACCEPTABLE;
    cardan_normalize(run, run->trial);
    if (!cardan_near_singular(run, run->t + h, run->trial, 1)) {
        status = cardan_close(run, run->t + h, run->trial, 0);
        *error = cardan_worst(*error, run->correction);
    }
    *error /= allowed(run, &at, share);
    if (status == 0 && *error <= 1) {
        run->pass_points = at.s;
        run->pass_start = run->t;
        run->pass_length = h;
        run->pass_part = 0;
        run->pass_parts = parts_of(run, h);
        for (ptrdiff_t i = 0; i < run->n; i++)
            y[i] = run->y[i];
    }
    return status;
}

/* State y (n) and derivative f (n) at a part theta of the step. */
static void on_step(const cardan_run *run, real theta, real *y, real *f)
{
    const real *slopes = run->crossing, *start = slopes + 2 * MOST_POINTS * run->n;
    real w[MOST_POINTS];
    gauss at = {0};

    lay(&at, run->pass_points);
    integral(at.points, at.s, 0, theta, w);
    add(run, run->pass_length, w, slopes, at.s, start, y);
    for (ptrdiff_t j = 0; j < at.s; j++) {
        w[j] = 1;
        for (ptrdiff_t k = 0; k < at.s; k++)
            w[j] *= k == j ? 1 : (theta - at.points[k]) / (at.points[j] - at.points[k]);
    }
    for (ptrdiff_t i = 0; i < run->n; i++) {
        f[i] = 0;
        for (ptrdiff_t j = 0; j < at.s; j++)
            f[i] += w[j] * slopes[j * run->n + i];
    }
}

/* Dense output of a part of the step: the polynomial of the method that agrees at its points. */
static void lay_dense(cardan_run *run, real from, real to)
{
    const ptrdiff_t n = run->n, rows = run->dense_rows;
    real *y = run->crossing + MOST_POINTS * n; /* of sweeps, which are over */
    real a[CARDAN_MOST_ROWS * CARDAN_MOST_ROWS], scratch[2 * CARDAN_MOST_ROWS];

    for (ptrdiff_t i = 0; i < rows; i++) {
        real theta = (real)(i + 1) / (real)rows, value = 1;
        on_step(run, from + theta * (to - from), y, y + n);
        cardan_normalize(run, y);
        cardan_rise(run, y, run->interpolant + i * n);
        for (ptrdiff_t j = 0; j < rows; j++)
            a[i * rows + j] = value *= j % 2 == 0 ? theta : 1 - theta;
    }
    cardan_rise(run, run->y, run->interpolant + (rows - 1) * n);
    (void)cardan_solve_basic((int)rows, (int)n, a, run->interpolant, scratch);
    run->is_dense = 1;
}

/* The next part of the step that leads over a place. */
static int part(cardan_run *run)
{
    const real from = (real)run->pass_part / (real)run->pass_parts;
    const real to = (real)++run->pass_part / (real)run->pass_parts;
    const int last = run->pass_part == run->pass_parts;
    const real stop = run->until;
    real t = run->pass_start + to * run->pass_length;
    int status = 0, near_singular;

    if (last && fabs(stop - t) < 1e-9 * fabs(run->pass_length))
        t = stop;
    on_step(run, to, run->trial, run->y_old);
    cardan_normalize(run, run->trial);
    /* beside the place the polynomial is better than what a projection makes of it */
    near_singular = cardan_near_singular(run, t, run->trial, last);
    if (!near_singular && cardan_close(run, t, run->trial, 1) != 0)
        on_step(run, to, run->trial, run->y_old);
    else if (!near_singular && last)
        status = cardan_derivative(run, t, run->trial, run->y_old);
    if (status == 0)
        cardan_record_row(run, t);
    if (status == 0)
        lay_dense(run, from, to);
    /* methods begin anew where the step ends */
    if (last) {
        run->pass_parts = run->in_segment = run->begun = 0;
        run->segment = run->t;
    }
    return status;
}

/* How long a step over a place `tau` ahead should be. */
static real span(const cardan_run *run, real tau)
{
    const real left = run->until - run->t, window = WINDOW * cardan_span(run);
    real h = fmax(2 * fabs(tau), fabs(tau) + 0.5 * window);

    if (run->on_grid)
        h = fabs(run->h) * ceil(h / fabs(run->h));
    return copysign(fmin(h, fabs(left)), left);
}

/* The part of the way to a place after which a step over it may have an error of 1. */
static real nearer(real error)
{
    const real power = -1.0 / (real)MOST_POINTS;

    return error < INFINITY ? fmin(0.5, fmax(0.1, 1 - 0.9 * pow(error, power))) : 0.5;
}

/* Note the step over a place that begins, for those who differentiate it. */
static void note(cardan_run *run)
{
    if (!run->passes)
        return;
    if (run->pass_count < run->pass_capacity) {
        real *row = run->passes + 3 * run->pass_count;
        row[0] = run->pass_start;
        row[1] = run->pass_length;
        row[2] = (real)run->pass_points;
    }
    run->pass_count++;
}

/* One step of the method, or one over a place where branches meet. */
int cardan_step(cardan_run *run)
{
    real tau, h, left, error = INFINITY, longest = run->max_step;
    const int fixed = run->rtol == 0 && run->atol == 1;
    int status, near, nearest, lengths = LENGTHS;

    if (!run->constraint_jacobian.function)
        return run->step(run);
    if (run->pass_parts > 0)
        return part(run);
    status = cardan_refresh(run);
    if (status != 0)
        return status;
    if (!cardan_branches_meet(run, &tau))
        return run->step(run);
    left = run->until - run->t;
    h = span(run, tau);
    /* as long as steps of the method usually are, or as short as that makes sense */
    near = fabs(tau) <= fmax(fabs(run->h), 0.5 * WINDOW * cardan_span(run));
    nearest = fabs(tau) < fmin(NEAREST * cardan_span(run), fabs(left));
    /* shorter again as long as it leads over the place, or once if it ends before */
    for (int k = 0; k < lengths && near && (fabs(h) > 1.2 * fabs(tau) || h == left); k++) {
        /* a given step leaves the tolerance at 1: a step over a place keeps its own */
        if (fixed) {
            run->rtol = FIXED_STEP_TOL;
            run->atol = FIXED_STEP_TOL;
        }
        status = attempt(run, tau, h, nearest || k < LENGTHS ? 1 : PATIENT, &error);
        if (fixed) {
            run->rtol = 0;
            run->atol = 1;
        }
        if (status == CARDAN_INPUT)
            return status;
        if (status == 0 && error <= 1) {
            run->passed += fabs(tau) < fabs(h);
            note(run);
            return part(run);
        }
        /* sweeps over what vibrates settle in short steps alone */
        if (status == CARDAN_CONSTRAINT_OPEN && lengths < MOST_LENGTHS)
            lengths++;
        h = run->on_grid ? run->h * floor(0.6 * h / run->h) : 0.6 * h;
    }
    if (nearest) {
        run->open_row = run->positions + cardan_weakest(run);
        run->correction = INFINITY;
        return CARDAN_CONSTRAINT_OPEN;
    }
    /* nearer to it first */
    run->max_step = fmin(longest, fabs(tau) * nearer(error));
    status = run->step(run);
    run->max_step = longest;
    return status;
}
