/* One step of the energy-momentum method as a system of equations.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     (Ad* PI)' - Ad* PI + h (f + corrections) = 0,   g' = 0
 *
 * for the increment and the multipliers, with the forces of conserving_forces.c and the momenta of
 * conserving_motion.c. Only at a solution are the invariants kept: corrections go on until rounding
 * is all there is. The matrix is h^2 / 4 K + h / 2 C + M with G half way, which is nearly that of the
 * equations; it serves as long as corrections shrink well.
 */
#include "conserving.h"
#include <math.h>

enum { MOST_CORRECTIONS = 40, FEW_TANGENTS = 4, MOST_TANGENTS = 12 };
/* corrections that shrink by less ask for a new matrix */
static const real SLOW = 0.1;
/* corrections that grow so much lead nowhere */
static const real WILD = 4;
/* corrections that end a step: against the increment; where they shrink no more, these may be left */
static const real SOUGHT = 1e-16, LEFT = 1e-12, SMALLEST = 1e-12;
/* where they shrink no more with an old matrix, these are rounding */
static const real ROUNDED = 1e-14;
/* corrections of multipliers that end a step, against them and the rates of momenta */
static const real SETTLED = 1e-10;
/* corrections with a matrix of this step after which multipliers are as good as rounding lets them be */
enum { ENOUGH = 3 };
/* a step whose matrix serves another one */
static const real ALIKE = 1e-6;

/* A new matrix at the present half of the step. */
static int renew(cardan_run *run, const cardan_conserving *v, real h, real t)
{
    const cardan_state at = {.t = t, .q = v->half, .u = v->mean, .udot = v->rise, .lam = v->lam_new,
                             .s = run->s, .r = run->r};
    const cardan_assembly parts = {{0.25 * h * h, 0.5 * h, 1}, 0, 0, NULL, 0};
    cardan_mesh_system system = v->system;
    int assembled, status;

    run->jacobians++;
    run->factorizations++;
    status = cardan_mesh_factor(v->mesh, &at, &parts, &system, &assembled);
    v->now[CONSERVING_MATRIX] = status == 0 ? h : 0;
    v->now[CONSERVING_WEAK] = (real)system.factors.weak;
    if (assembled)
        return status;
    run->model_status = status;
    return CARDAN_MODEL;
}

/* What is missing in the balance of a step, and g at its end. */
static int residual(cardan_run *run, const cardan_conserving *v, real h, real t_new)
{
    int status = cardan_conserving_move(run, v, h);

    if (status == 0)
        status = cardan_conserving_potentials(run, v, t_new, run->trial, v->after);
    if (status == 0)
        status = cardan_conserving_gaps(run, v, t_new, run->trial);
    if (status == 0)
        status = cardan_conserving_forces(run, v, t_new - 0.5 * h);
    if (status == 0)
        status = cardan_conserving_coupled(run, v, 0);
    if (status == 0)
        cardan_conserving_momenta(run, v, h);
    run->evaluations++;
    run->model_status = status;
    return status == 0 ? 0 : CARDAN_MODEL;
}

/* Correct increment and multipliers; the correction into dx, the size of that of multipliers. */
static int correct(const cardan_conserving *v, real h, real *forces)
{
    const real scale = 0.5 * h * h;
    real sum = 0;
    const ptrdiff_t *unknown = v->mesh->unknown;
    cardan_mesh_system system = v->system;
    int status;

    system.factors.weak = (int32_t)v->now[CONSERVING_WEAK];
    for (ptrdiff_t i = 0; i < v->nu; i++)
        system.right[i] = -scale * v->missing[i];
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = -v->gaps[v->nu + k];
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->dx[i] = system.solution[i];
        v->eta[i] += v->dx[i];
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        const real change = system.solution[unknown[k]] / scale;
        v->lam_new[k] -= change;
        sum += change * change;
    }
    *forces = sqrt(sum);
    return status;
}

static real length_of(const real *x, ptrdiff_t n)
{
    real sum = 0;

    for (ptrdiff_t i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sqrt(sum);
}

/* Speeds go on as they did, or as their mean did over the last step where that is all there is. */
static void predict(const cardan_run *run, const cardan_conserving *v, real h, int steady)
{
    const real *u = run->y + v->nq;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->eta[i] = h * (u[i] + (steady ? -0.5 * v->last : 0.5 * h) * v->rise[i]);
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_new[k] = v->middle[k];
}

/* Whether multipliers are found. Increments do not tell: about a point where a body is held, forces
 * on that point move nothing, and with the matrix of a body that has turned since, their corrections
 * shrink slowly or grow. Work of such forces on gaps that are rounding is what energy would drift by. */
static int settled(const cardan_conserving *v, real forces)
{
    return forces <= SETTLED * (length_of(v->lam_new, v->m) + v->now[CONSERVING_RATES]);
}

/* Correct what was predicted until rounding is all there is; most: new matrices, at most. */
static int correct_all(cardan_run *run, const cardan_conserving *v, real h, real t_new, int most)
{
    const int fit = fabs(v->now[CONSERVING_MATRIX] / h - 1) < ALIKE && most == FEW_TANGENTS;
    real last = INFINITY, before = INFINITY, size, increment, left, forces;
    int status = residual(run, v, h, t_new), tangents = 0, since = fit ? -MOST_CORRECTIONS : 0;

    if (status == 0 && !fit)
        status = renew(run, v, h, t_new - 0.5 * h);
    for (int k = 0; k < MOST_CORRECTIONS && status == 0; k++) {
        int converged, old;
        status = correct(v, h, &forces);
        since++;
        size = length_of(v->dx, v->nu);
        increment = length_of(v->eta, v->nu);
        left = LEFT * increment + SMALLEST;
        if (status == 0)
            status = residual(run, v, h, t_new);
        if (status != 0 || !(size < INFINITY) || (size > WILD * last && tangents == most))
            break;
        converged = since >= ENOUGH || settled(v, forces);
        /* with an old matrix they shrink slowly long before rounding is all there is */
        old = tangents == 0 && size > ROUNDED * increment;
        if (converged && (size <= SOUGHT * increment || (size > 0.5 * last && size <= left && !old)))
            return 0;
        if (tangents < most && (((size > left || old) && size > SLOW * last)
                                || (!converged && forces > SLOW * before))) {
            status = renew(run, v, h, t_new - 0.5 * h);
            tangents++;
            since = 0;
        }
        last = size;
        before = forces;
    }
    return status != 0 ? status : CARDAN_UNSOLVED;
}

/* The increment and the multipliers of a step h to t_new; its end in `trial`.
 *
 * Returns 0, CARDAN_UNSOLVED or CARDAN_MODEL.
 */
int cardan_conserving_solve(cardan_run *run, const cardan_conserving *v, real h, real t_new)
{
    real energy = 0;
    int status = cardan_conserving_potentials(run, v, run->t, run->y, v->before);

    if (status == 0)
        status = cardan_conserving_energy(run, v, &energy);
    if (status == 0)
        status = cardan_conserving_coupled(run, v, 1);
    if (status != 0)
        return CARDAN_MODEL;
    v->now[CONSERVING_EXCESS] = energy - v->now[CONSERVING_ENERGY];
    predict(run, v, h, 0);
    status = correct_all(run, v, h, t_new, FEW_TANGENTS);
    if (status == 0)
        return 0;
    /* with the matrix of every iteration */
    predict(run, v, h, 1);
    return correct_all(run, v, h, t_new, MOST_TANGENTS);
}
