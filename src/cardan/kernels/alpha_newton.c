/* One step of the generalized-alpha method as a system of equations, and the start of a run.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     q' = q o exp(h u + h^2 ((1/2 - beta) a + beta a') - stabilization)
 *     u' = u + h ((1 - gamma) a + gamma a')
 *     (1 - am) a' + am a = (1 - af) udot' + af udot
 *     M udot' + h - f - Gᵀ lam' = 0, g = 0, of index 2: G u' + g_t = 0 too
 *
 * Source: M. Arnold, O. Brüls, A. Cardona, Numer. Math. 129 (2015), sections 2 to 4; E. Hairer,
 * G. Wanner, Solving Ordinary Differential Equations II, section IV.8 (when Newton steps suffice).
 */
#include "alpha.h"
#include <math.h>

enum { MOST_CORRECTIONS = 20, MOST_TANGENTS = 6 };
/* steps that begin with a new tangent once one did not serve two of them */
static const real HASTE = 8;
/* corrections that shrink by less ask for a new tangent, and so do those that need more than FEW */
static const real SLOW = 0.3, FEW = 4;
/* corrections of a step may be so large: of the error it may have; of coordinates, at a given step;
 * of those of a mesh, where every correction counts, at most */
static const real SHARE = 0.005, SOUGHT = 1e-13, LOOSE = 1e-11;
static const real TRUST = 0.8;
/* corrections that coordinates far from the origin show, in what they are rounded by */
static const real ROUNDED = 32;
/* a turn in one step, in radians, for which speeds and positions may need a matrix each */
static const real FAR = 0.25;
/* what rounding may leave, in units of that */
static const real NOISE = 1e3;
/* a step whose matrix serves another one: at most so much larger or smaller */
static const real ALIKE = 0.25;

/* Mean size of an increment dx (nu) in coordinates, against rtol and atol. */
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
        if (!(part * part <= largest)) {
            largest = part * part;
            run->culprit = i;
        }
    }
    return sqrt(sum / (real)(v->nq > 0 ? v->nq : 1));
}

/* The same in parts of what coordinates have been: at a given step, where nobody told tolerances. */
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

/* What Newton steps may leave of the increment: less than the error of a step by an order of h, as
 * it is of one sign. At a given step that error is what the accelerations foretell. */
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
    error = fmin(LOOSE, SHARE * error * cbrt(error));
    return fmax(fmax(SOUGHT, ROUNDED * cardan_alpha_rounding(run, v)), error);
}

/* The size of a correction in units of that. */
static real left_by(cardan_run *run, const cardan_alpha *v, const real *dx, real most, int *status)
{
    if (v->adaptive)
        return cardan_alpha_norm(run, v, dx, most * run->rtol, most * run->atol, status);
    return part_of_motion(run, v, dx, status) / most;
}

/* The state that a_new leads to, in `trial`; its T in `moved`. */
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
    in.du = v->increment;
    status = cardan_call_model(run, &run->move, &in, v->moved);
    for (ptrdiff_t i = 0; i < nq; i++)
        run->trial[i] = v->moved[i];
    return status;
}

/* Accelerations go on as they did; calm: such that coordinates go on by their speeds alone, for
 * steps beyond which fine meshes swing, as behind a jump of what acts on them. */
static int predict(cardan_run *run, const cardan_alpha *v, real h, int calm)
{
    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->a_new[i] = calm ? (1 - 0.5 / v->beta) * v->a[i] : v->a[i] + h * v->rise[i];
        v->shift[i] = 0;
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_new[k] = v->picked[k] != 0 ? v->lam[k] : 0;
    return place(run, v, h);
}

/* What is missing in the balance of a state. */
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

/* The same of the trial state. */
int cardan_alpha_balance(cardan_run *run, const cardan_alpha *v, real t)
{
    return balance(run, v, t, run->trial, v->udot_new, v->lam_new);
}

/* The gaps of its constraints alone. */
int cardan_alpha_gaps(cardan_run *run, const cardan_alpha *v, real t)
{
    const real *y = run->trial;
    const cardan_state at = {t, y, y + run->nq, v->udot_new, v->lam_new, y + run->nq + run->nu,
                             run->s, run->r, NULL, NULL};
    const int status = v->mesh ? cardan_inputs_at(run, t, y) : cardan_alpha_balance(run, v, t);

    if (status != 0 || !v->mesh)
        return status;
    run->model_status = cardan_mesh_gaps(v->mesh, &at, v->residual, v->system.work);
    return run->model_status != 0 ? CARDAN_MODEL : 0;
}

/* A new matrix at the trial state. */
static int renew(cardan_run *run, const cardan_alpha *v, real h, real t)
{
    return cardan_alpha_renew(run, v, h, t, run->trial, v->udot_new, v->lam_new);
}

/* Whether what the next corrections will be is little enough; rate: by which they shrink.
 *
 * Where they do not although the tangent is new, rounding is all there is.
 */
static int enough(real norm, real rate, real last, int is_new)
{
    if (norm == 0 || (rate < 1 && norm * rate <= 1 - rate))
        return 1;
    return is_new && norm <= NOISE && norm > 0.5 * last;
}

/* Correct the trial by what is missing there; the change of the increment into dx. */
static int correct(cardan_run *run, const cardan_alpha *v, real h, real t)
{
    int status = cardan_alpha_balance(run, v, t);

    if (status == 0)
        status = cardan_alpha_correct(run, v, h, v->dx);
    if (status == 0)
        status = place(run, v, h);
    if (status != 0 || v->now[ALPHA_APART] == 0)
        return status;
    status = cardan_alpha_sparse_settle(run, v, h, t, v->dx);
    return status != 0 ? status : place(run, v, h);
}

/* The accelerations and multipliers of a step h to t_new; its end in `trial`.
 *
 * Full: with a new matrix at every correction. Modified: one serves corrections and steps for as
 * long as they shrink well with it and steps are about as long.
 *
 * Returns 0, CARDAN_UNSOLVED, CARDAN_MODEL or CARDAN_INPUT.
 */
int cardan_alpha_solve(cardan_run *run, const cardan_alpha *v, real h, real t_new)
{
    const real other = v->now[ALPHA_MATRIX] / h - 1;
    const int shares = v->mesh && v->index == 2 && v->mp > 0;
    real last = INFINITY;
    int tangents = 0, stale = 0, status = predict(run, v, h, 0);
    const real most = status == 0 ? leaves(run, v, h, &status) : 0;

    if (!(fabs(other) < ALIKE)) {
        v->now[ALPHA_APART] = 0;
        stale = 1;
    }
    /* corrections of forces along axes that have turned since shrink by that angle, which increments
     * do not tell of about a point where a body is held: nothing moves there */
    if (v->mesh && v->m > 0) {
        v->now[ALPHA_TURNED] += cardan_alpha_sparse_turn(run, v, h);
        stale |= v->now[ALPHA_TURNED] > SLOW;
    }
    /* it would not serve this step either: no correction is tried with it */
    if (v->now[ALPHA_HASTE] > 0) {
        v->now[ALPHA_HASTE]--;
        stale = 1;
    }
    if (v->full && shares)
        v->now[ALPHA_APART] = 1;
    for (int k = 0; k < MOST_CORRECTIONS && status == 0; k++) {
        real norm, rate;

        if (stale || v->full) {
            status = renew(run, v, h, t_new);
            v->now[ALPHA_AGE] = v->now[ALPHA_TURNED] = 0;
            stale = 0;
            tangents++;
        }
        status = status != 0 ? status : correct(run, v, h, t_new);
        norm = status == 0 ? left_by(run, v, v->dx, most, &status) : 0;
        if (status != 0)
            return status;
        /* what was measured in an earlier step is trusted less every time, if at all */
        rate = v->adaptive || v->mesh ? pow(v->now[ALPHA_RATE], TRUST) : norm <= 1 ? 0.5 : 1;
        if (last < INFINITY)
            rate = norm / last;
        if (enough(norm, rate, last, tangents > 0)) {
            v->now[ALPHA_RATE] = fmin(SLOW, fmax(rate, 1e-3));
            return 0;
        }
        if (!(norm < INFINITY) || (last < INFINITY && !(rate < SLOW && norm * pow(rate, FEW) < 1))) {
            /* what a new matrix does not mend either: speeds and positions share it */
            if (tangents > 0 && shares && cardan_alpha_sparse_turn(run, v, h) > FAR)
                v->now[ALPHA_APART] = 1;
            if (tangents >= MOST_TANGENTS && !v->full)
                break;
            if (tangents == 0 && v->now[ALPHA_AGE] <= 1)
                v->now[ALPHA_HASTE] = HASTE;
            /* away from the solution: from the beginning, with the tangent there */
            if (!(rate < 1))
                status = predict(run, v, h, 1);
            stale = 1;
            norm = v->full && rate < 1 ? norm : INFINITY;
        }
        last = norm;
    }
    return status != 0 ? status : CARDAN_UNSOLVED;
}

/* udot (nu) a little later than t along the motion; `a_new` is room. */
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
        run->trial[i] = run->y[i];
    if (status == 0)
        status = cardan_derivative(run, run->t + dt, run->trial, run->k);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        udot[i] = run->k[nq + i];
    return status;
}

/* Accelerations and multipliers at t where a segment starts; the next step is h long.
 *
 * a stands for t + (am - af) h: without that the first steps are of lower order. Its slope is
 * taken over a small part of the step, and ahead, as inputs before t belong to another segment.
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
    if (v->m > 0) {
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
    v->now[ALPHA_APART] = v->now[ALPHA_HASTE] = 0;
    v->now[ALPHA_STEP] = h;
    status = later(run, v, part, slope);
    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->rise[i] = (slope[i] - v->udot[i]) / part;
        v->a[i] = v->udot[i] + (v->am - v->af) * h * v->rise[i];
    }
    return status;
}
