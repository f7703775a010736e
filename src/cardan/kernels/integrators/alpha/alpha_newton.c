/* Newton iterations of a generalized-alpha step, and its initial values at the start of a segment.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     q' = q o exp(h u + h^2 ((1/2 - beta) a + beta a') - stabilization)
 *     u' = u + h ((1 - gamma) a + gamma a')
 *     (1 - am) a' + am a = (1 - af) udot' + af udot
 *     M udot' + c - f - Gᵀ lam' = 0, g = 0; for index 2 also G u' + g_t = 0
 *
 * Primes mark the end of the step; c are velocity-dependent inertia forces, f applied forces. A step
 * moves q by an increment along the speeds; T below is the derivative of that motion by the increment
 * (the tangent operator of the exponential map). Source: M. Arnold, O. Brüls, A. Cardona, Numer. Math. 129
 * (2015), sections 2 to 4; E. Hairer, G. Wanner, Solving Ordinary Differential Equations II,
 * section IV.8 (stopping criterion of the Newton iterations).
 */
#include "alpha.h"
#include <math.h>

enum { MOST_CORRECTIONS = 20, MOST_TANGENTS = 6 };
/* Newton steps for multipliers that make friction: each doubles the digits */
enum { LEVELING = 7 };
/* number of following steps that begin with a new matrix, after a matrix failed in the step it was
 * factored in or the next */
static const real HASTE = 8;
/* a new matrix is due if the convergence rate exceeds SLOW or more than FEW corrections are needed */
static const real SLOW = 0.3, FEW = 4;
/* mesh: cost of a new matrix, in corrections. Once an old one has cost as many beyond the fewest, a
 * new one is due: no rule spends less than half of what this one does. */
static const real PRICE = 4;
/* Newton tolerance: SHARE relative to the error tolerance; SOUGHT relative to coordinates for fixed
 * steps; at most MAX_TOL for a mesh with fixed steps, where every correction is expensive */
static const real SHARE = 0.005, SOUGHT = 1e-13, MAX_TOL = 1e-11;
/* exponent applied to the convergence rate of an earlier step */
static const real TRUST = 0.8;
/* corrections due to rounding of coordinates far from the origin, in units of that rounding */
static const real ROUNDED = 32;
/* rotation [rad] by which the directions of the stabilization may lag behind the constraints */
static const real LAG = 0.15;
/* steps of one size after which multipliers and stabilization are predicted from the last ones */
static const real STEADY = 2;
/* rotation in one step [rad] above which speeds and positions may need separate matrices */
static const real FAR = 0.25;
/* correction that may remain due to rounding, in units of the Newton tolerance */
static const real NOISE = 1e3;
/* relative change of h up to which the matrix is reused */
static const real ALIKE = 0.25;

/* Root mean square of an increment dx (nu), mapped to coordinate rates and divided by tolerances. */
real cardan_alpha_norm(cardan_run *run, const cardan_alpha *v, const real *dx, real rtol,
                       real atol, int *status)
{
    real sum = 0, largest = 0;
    cardan_in in;

    if (v->mesh)
        return cardan_alpha_sparse_norm(run, v, dx, rtol, atol);
    in = cardan_at(run, &run->t, run->trial);
    in.u = dx;
    *status = cardan_call_model(run, &run->qdot, &in, v->rates);
    for (ptrdiff_t i = 0; i < v->nq; i++) {
        const real size = fmax(v->amplitude[i], fabs(run->trial[i]));
        const real part = v->rates[i] == 0 ? 0 : v->rates[i] / (atol + rtol * size);
        sum += part * part;
        if (cardan_exceeds(part * part, largest)) {
            largest = part * part;
            run->culprit = i;
        }
    }
    return sqrt(sum / (real)(v->nq > 0 ? v->nq : 1));
}

/* The same relative to the largest coordinates so far, for fixed steps without tolerances. */
static real part_of_motion(cardan_run *run, const cardan_alpha *v, const real *dx, int *status)
{
    real largest = 0;

    for (ptrdiff_t i = 0; i < v->nq && !v->mesh; i++) {
        const real size = fabs(run->trial[i]);
        largest = size > largest ? size : largest;
        largest = v->amplitude[i] > largest ? v->amplitude[i] : largest;
    }
    return cardan_alpha_norm(run, v, dx, 1, 1e-3 * largest, status);
}

/* Tolerance of the Newton iterations: the fraction SHARE of the tolerance of a step, because their
 * error accumulates with one sign. For fixed steps on a mesh the error of a step
 * is estimated from the predicted accelerations. */
static real leaves(cardan_run *run, const cardan_alpha *v, real h, int *status)
{
    const real constant = v->beta + (v->am - v->af) / 2 - 1.0 / 6;
    real error;

    if (v->adaptive)
        return SHARE * cbrt(run->rtol + run->atol);
    if (!v->mesh)
        return SOUGHT;
    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->dx[i] = h * h * constant * (v->a_new[i] - v->a[i]);
    error = part_of_motion(run, v, v->dx, status);
    error = fmin(MAX_TOL, SHARE * error * cbrt(error));
    return fmax(fmax(SOUGHT, ROUNDED * cardan_alpha_rounding(run, v)), error);
}

/* Size of a correction in units of the Newton tolerance `most`. */
static real left_by(cardan_run *run, const cardan_alpha *v, const real *dx, real most, int *status)
{
    if (v->adaptive)
        return cardan_alpha_norm(run, v, dx, most * run->rtol, most * run->atol, status);
    return part_of_motion(run, v, dx, status) / most;
}

/* State at the end of the step for the present a_new, written to `trial`; without a mesh its T in `moved`. */
static int place(cardan_run *run, const cardan_alpha *v, real h)
{
    const ptrdiff_t nq = v->nq;
    const real *u = run->y + nq;
    real *next = run->trial + nq;
    cardan_in in = cardan_at(run, &run->t, run->y);
    int status;

    for (ptrdiff_t i = 0; i < v->nu; i++) {
        const real a = v->a[i], b = v->a_new[i];
        v->increment[i] = h * (u[i] + h * ((0.5 - v->beta) * a + v->beta * b)) - v->shift[i];
        next[i] = u[i] + h * ((1 - v->gamma) * a + v->gamma * b);
        v->udot_new[i] = ((1 - v->am) * b + v->am * a - v->af * v->udot[i]) / (1 - v->af);
    }
    if (v->mesh)
        return cardan_alpha_sparse_place(run, v, run->trial, NULL);
    in.du = v->increment;
    status = cardan_call_model(run, &run->move, &in, v->moved);
    for (ptrdiff_t i = 0; i < nq; i++)
        run->trial[i] = v->moved[i];
    return status;
}

/* Predictor: extrapolate a linearly, between steps of one size lam too, and stabilize as in the step
 * before. calm: choose a' such that the increment is h u, which is safer for steps longer than the
 * oscillations of a fine mesh, as after a jump of the forces. */
static int predict(cardan_run *run, const cardan_alpha *v, real h, int calm)
{
    const int steady = !calm && v->now[ALPHA_STEPS_SINCE_CHANGE] >= STEADY;
    int status = 0;

    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->a_new[i] = calm ? (1 - 0.5 / v->beta) * v->a[i] : v->a[i] + h * v->rise[i];
        v->shift[i] = 0;
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        const real change = steady ? v->lam[k] - v->lam_old[k] : 0;
        v->lam_new[k] = v->picked[k] != 0 ? v->lam[k] + change : 0;
    }
    for (ptrdiff_t k = 0; k < v->mp; k++)
        v->closing[k] = steady ? v->closing[k] : 0;
    if (steady && v->mp > 0 && v->now[ALPHA_MATRIX] != 0)
        status = cardan_alpha_shift(v);
    for (ptrdiff_t i = run->nq + run->nu; i < run->nx; i++)
        run->trial[i] = run->y[i];
    return status != 0 ? status : place(run, v, h);
}

/* Residual of the balance and the constraints at a state. */
static int balance(cardan_run *run, const cardan_alpha *v, real t, const real *y,
                   const real *udot, const real *lam)
{
    cardan_in in;
    int status = cardan_inputs_at(run, t, y);

    if (status != 0)
        return status;
    in = cardan_at(run, &t, y);
    in.udot = udot;
    in.lam = lam;
    run->evaluations++;
    return cardan_call_model(run, &run->balance, &in, v->residual);
}

/* Residual at the trial state. */
int cardan_alpha_balance(cardan_run *run, const cardan_alpha *v, real t)
{
    if (run->nz > 0) {
        int status = cardan_inputs_at(run, t, run->trial);
        status = status != 0 ? status : cardan_alpha_internal(run, v, t);
        if (status != 0)
            return status;
    }
    return balance(run, v, t, run->trial, v->udot_new, v->lam_new);
}

/* Residuals of the constraints at the trial state (without a mesh the entire residual). */
int cardan_alpha_gaps(cardan_run *run, const cardan_alpha *v, real t)
{
    const real *y = run->trial;
    const cardan_state at = {.t = t, .q = y, .u = y + run->nq, .udot = v->udot_new,
                             .lam = v->lam_new, .z = y + run->nq + run->nu, .s = run->s,
                             .r = run->r};
    const int status = v->mesh ? cardan_inputs_at(run, t, y) : cardan_alpha_balance(run, v, t);

    if (status != 0 || !v->mesh)
        return status;
    run->model_status = cardan_mesh_gaps(v->mesh, &at, v->residual, v->system.work);
    return run->model_status != 0 ? CARDAN_MODEL : 0;
}

/* New matrix at the trial state; what the stabilization closed so far it closes along the new axes. */
static int renew(cardan_run *run, const cardan_alpha *v, real h, real t)
{
    int status = cardan_alpha_renew(run, v, h, t, run->trial, v->udot_new, v->lam_new);

    v->now[ALPHA_AGE] = v->now[ALPHA_ROTATION] = 0;
    v->now[ALPHA_FEWEST] = v->now[ALPHA_EXTRA] = 0;
    if (status != 0 || v->mp == 0)
        return status;
    status = cardan_alpha_shift(v);
    return status != 0 ? status : place(run, v, h);
}

/* Stopping criterion: the sum of all later corrections, norm rate / (1 - rate), is at most 1.
 *
 * If corrections stagnate although the matrix is new, only rounding is left.
 */
static int enough(real norm, real rate, real last, int is_new)
{
    if (norm == 0 || (rate < 1 && norm * rate <= 1 - rate))
        return 1;
    return is_new && norm <= NOISE && norm > 0.5 * last;
}

/* One Newton correction of the trial; dx receives the change of the increment. */
static int correct(cardan_run *run, const cardan_alpha *v, real h, real t)
{
    int status = cardan_alpha_balance(run, v, t);

    if (status == 0)
        status = cardan_alpha_correct(run, v, h, v->dx);
    if (status == 0)
        status = place(run, v, h);
    if (status != 0 || v->now[ALPHA_SPLIT_LEVELS] == 0)
        return status;
    status = cardan_alpha_sparse_settle(run, v, h, t, v->dx);
    return status != 0 ? status : place(run, v, h);
}

/* Count the corrections of a step without a new matrix. */
static void count(const cardan_alpha *v, int corrections)
{
    const real fewest = v->now[ALPHA_FEWEST];

    v->now[ALPHA_FEWEST] = fewest > 0 ? fmin(fewest, corrections) : corrections;
    v->now[ALPHA_EXTRA] += corrections - v->now[ALPHA_FEWEST];
}

/* Solve for accelerations and multipliers of a step h to t_new; its end is in `trial`.
 *
 * Full Newton factors a new matrix for every correction. Modified Newton reuses one matrix across
 * corrections and steps while convergence is fast and h changes by less than 25 %.
 *
 * Returns 0, CARDAN_UNSOLVED, CARDAN_MODEL or CARDAN_INPUT.
 */
int cardan_alpha_solve(cardan_run *run, const cardan_alpha *v, real h, real t_new)
{
    const real other = v->now[ALPHA_MATRIX] / h - 1;
    const int shares = v->mesh && v->index == 2 && v->mp > 0;
    real last = INFINITY;
    int tangents = 0, stale = 0, afresh = 0, status = predict(run, v, h, 0);
    const real most = status == 0 ? leaves(run, v, h, &status) : 0;

    /* no matrix yet, or one of a very different step size */
    if (!(fabs(other) < ALIKE)) {
        v->now[ALPHA_SPLIT_LEVELS] = 0;
        stale = 1;
    }
    /* Reactions along axes that have turned since factoring converge at a rate of that angle. The
     * corrections do not show this near a point fixed in space, where nothing moves. */
    if (v->mesh && v->m > 0) {
        v->now[ALPHA_ROTATION] += cardan_alpha_sparse_turn(run, v, h);
        stale |= v->now[ALPHA_ROTATION] > (shares ? LAG : SLOW);
    }
    stale |= v->mesh && v->now[ALPHA_EXTRA] > PRICE;
    /* the matrix failed recently: start with a new one right away */
    if (v->now[ALPHA_RENEW] > 0) {
        v->now[ALPHA_RENEW]--;
        stale = 1;
    }
    if (v->full && shares)
        v->now[ALPHA_SPLIT_LEVELS] = 1;
    for (int k = 0; k < MOST_CORRECTIONS && status == 0; k++) {
        real norm, rate;

        if (stale || v->full) {
            status = renew(run, v, h, t_new);
            stale = 0;
            tangents++;
        }
        status = status != 0 ? status : correct(run, v, h, t_new);
        norm = status == 0 ? left_by(run, v, v->dx, most, &status) : 0;
        if (status != 0)
            return status;
        /* far from the solution the constraints are others, and redundant ones may seem independent */
        if (afresh && v->mp > 0) {
            afresh = 0, stale = 1;
            continue;
        }
        /* first correction: the rate of an earlier step, discounted; then the measured rate */
        rate = v->adaptive || v->mesh ? pow(v->now[ALPHA_RATE], TRUST) : norm <= 1 ? 0.5 : 1;
        if (last < INFINITY)
            rate = norm / last;
        if (enough(norm, rate, last, tangents > 0)) {
            v->now[ALPHA_RATE] = fmin(SLOW, fmax(rate, 1e-3));
            if (tangents == 0)
                count(v, k + 1);
            return 0;
        }
        /* slow: more than FEW further corrections would be needed, so renew the matrix */
        if (!(norm < INFINITY) || (last < INFINITY && !(rate < SLOW && norm * pow(rate, FEW) < 1))) {
            /* a new matrix did not help: use separate matrices for positions and speeds */
            if (tangents > 0 && shares && cardan_alpha_sparse_turn(run, v, h) > FAR)
                v->now[ALPHA_SPLIT_LEVELS] = 1;
            if (tangents >= MOST_TANGENTS && !v->full)
                break;
            if (tangents == 0 && v->now[ALPHA_AGE] <= 1)
                v->now[ALPHA_RENEW] = HASTE;
            /* diverging: start over from constant velocities, with a matrix factored at that state */
            afresh = !(rate < 1);
            if (afresh)
                status = predict(run, v, h, 1);
            stale = 1;
            norm = v->full && rate < 1 ? norm : INFINITY;
        }
        last = norm;
    }
    return status != 0 ? status : CARDAN_UNSOLVED;
}

/* udot (nu) at t + dt along the motion; overwrites a, a_new and the trial. */
static int later(cardan_run *run, const cardan_alpha *v, real dt, real *udot)
{
    const ptrdiff_t nq = v->nq;
    int status;

    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->a[i] = v->a_new[i] = v->udot[i];
        v->shift[i] = 0;
    }
    status = place(run, v, dt);
    cardan_normalize(run, run->trial);
    for (ptrdiff_t i = nq + v->nu; i < run->n; i++)
        run->trial[i] = run->y[i] + (i < run->nx ? dt * run->f[i] : 0);
    if (status == 0)
        status = cardan_derivative(run, run->t + dt, run->trial, run->k);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        udot[i] = run->k[nq + i];
    return status;
}

/* Initial accelerations and multipliers at the start of a segment; the next step has size h.
 *
 * a is initialized at t + (am - af) h, without which the first steps lose an order. Its slope comes
 * from a forward difference over h / 64, since inputs before t belong to another segment.
 */
int cardan_alpha_restart(cardan_run *run, const cardan_alpha *v, real h)
{
    const real part = h / 64;
    real *slope = v->increment;
    int status;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->udot[i] = run->f[v->nq + i];
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam[k] = v->lam_new[k] = 0;
    /* multipliers: a linear solve with the matrix for h = 0, several where friction follows from them */
    for (int step = 0; v->m > 0 && step < (v->mesh && v->mesh->frictions > 0 ? LEVELING : 1); step++) {
        status = cardan_alpha_renew(run, v, 0, run->t, run->y, v->udot, v->lam);
        if (status == 0)
            status = balance(run, v, run->t, run->y, v->udot, v->lam);
        if (status == 0)
            status = cardan_alpha_correct(run, v, 0, v->dx);
        if (status != 0)
            return status;
        for (ptrdiff_t k = 0; k < v->m; k++)
            v->lam_old[k] = v->lam[k] = v->lam_new[k];
    }
    v->now[ALPHA_MATRIX] = 0;
    v->now[ALPHA_SPLIT_LEVELS] = v->now[ALPHA_RENEW] = v->now[ALPHA_STEPS_SINCE_CHANGE] = 0;
    v->now[ALPHA_STEP] = h;
    cardan_alpha_internal_restart(run, v, 1, 1);
    status = later(run, v, part, slope);
    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->rise[i] = (slope[i] - v->udot[i]) / part;
        v->a[i] = v->udot[i] + (v->am - v->af) * h * v->rise[i];
    }
    return status;
}
