/* The energy-momentum method for systems of elements: implicit, order 2, fixed step.
 *
 * Part of cardan. Caller owns all memory; k holds the derivative at the start of the last step.
 *
 * Total energy is kept whatever the step, and with it the momenta that the scene keeps: of the whole where
 * nothing holds it, about the axis of gravity, about a fixed point. Elements are those of every other
 * method: see conserving_forces.c. Masses are those of nodes, constant along their own axes; other
 * elements give their momenta themselves.
 * Multipliers are those of the middle of a step; at its end they go on as they did.
 * Source: J. C. Simo, K. K. Wong, Int. J. Numer. Meth. Eng. 31 (1991) 19-52; O. Gonzalez,
 * J. Nonlinear Sci. 6 (1996) 449-467; P. Betsch, Comput. Methods Appl. Mech. Eng. 194 (2005).
 */
#include "conserving.h"
#include "explicit.h"
#include "mesh_calls.h"
#include <math.h>

enum { SHORTEST = 64 /* parts of a step */ };

/* Point into the memory of a run. Returns how many numbers that takes. */
static ptrdiff_t lay(const cardan_run *run, cardan_conserving *v)
{
    const cardan_mesh *mesh = run->mesh;
    const ptrdiff_t nu = run->nu, m = run->rates;
    real *memory = run->method_memory;
    ptrdiff_t used = 0, widest = 0;

    v->mesh = mesh;
    v->nq = run->nq, v->nu = nu, v->mp = run->positions, v->m = m;
    v->elements = 0;
    v->coupled = 0;
    for (ptrdiff_t k = 0; k < mesh->group_count; k++) {
        v->elements += mesh->groups[k].count;
        v->coupled |= mesh->groups[k].forms[CARDAN_GENERALIZED_MOMENTA].call != NULL;
        if (widest < mesh->groups[k].nu)
            widest = mesh->groups[k].nu;
    }
    v->widest = 0;
    for (ptrdiff_t place = 0; place < mesh->places; place++)
        if (v->widest < mesh->u[place + 1] - mesh->u[place])
            v->widest = mesh->u[place + 1] - mesh->u[place];
    /* rows read them at the start of `memory` */
    v->lam_old = cardan_reserve(memory, &used, m);
    v->lam = cardan_reserve(memory, &used, m);
    v->now = cardan_reserve(memory, &used, CONSERVING_NOW);
    v->mass = cardan_reserve(memory, &used, v->widest * nu);
    v->pose = cardan_reserve(memory, &used, mesh->places);
    v->middle = cardan_reserve(memory, &used, m);
    v->rise = cardan_reserve(memory, &used, nu);
    v->open = cardan_reserve(memory, &used, v->mp);
    v->eta = cardan_reserve(memory, &used, nu);
    v->lam_new = cardan_reserve(memory, &used, m);
    v->half = cardan_reserve(memory, &used, v->nq);
    v->mean = cardan_reserve(memory, &used, nu);
    v->before = cardan_reserve(memory, &used, v->elements);
    v->after = cardan_reserve(memory, &used, v->elements);
    v->missing = cardan_reserve(memory, &used, nu);
    v->gaps = cardan_reserve(memory, &used, nu + v->mp + m);
    v->dx = cardan_reserve(memory, &used, nu);
    v->element = cardan_reserve(memory, &used, 2 * widest);
    v->start = cardan_reserve(memory, &used, nu + m);
    v->momenta = cardan_reserve(memory, &used, v->coupled ? nu : 0);
    v->momenta_new = cardan_reserve(memory, &used, v->coupled ? nu : 0);
    v->slopes = cardan_reserve(memory, &used, v->coupled ? nu : 0);
    v->speeds_half = cardan_reserve(memory, &used, v->coupled ? 2 * nu : 0);
    return used + cardan_mesh_lay(mesh, memory ? memory + used : memory, &v->system);
}

cardan_conserving cardan_conserving_at(const cardan_run *run)
{
    cardan_conserving v = {0};

    v.down = run->options;
    v.symmetry = run->options + 3;
    (void)lay(run, &v);
    v.last = v.now && v.now[CONSERVING_SINCE] > 0 ? run->t - run->t_old : 0;
    return v;
}

static ptrdiff_t length(const cardan_run *run)
{
    cardan_run measured = *run;
    cardan_conserving v = {0};

    measured.method_memory = NULL;
    return lay(&measured, &v);
}

static void store_gaps(const cardan_conserving *v)
{
    for (ptrdiff_t k = 0; k < v->mp; k++)
        v->open[k] = v->gaps[v->nu + k];
}

/* Accelerations and multipliers where a segment starts. */
static int restart(cardan_run *run, const cardan_conserving *v)
{
    const cardan_state at = {.t = run->t, .q = run->y, .u = run->y + v->nq,
                             .s = run->s, .r = run->r};
    int status = cardan_inputs_at(run, run->t, run->y);

    if (status == 0)
        status = cardan_mesh_accelerations(v->mesh, &at, NULL, v->start, run->work);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->rise[i] = v->start[i];
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_old[k] = v->lam[k] = v->middle[k] = v->start[v->nu + k];
    if (status == 0)
        status = cardan_conserving_gaps(run, v, run->t, run->y);
    store_gaps(v);
    if (status == 0)
        status = cardan_conserving_energy(run, v, &v->now[CONSERVING_ENERGY]);
    v->now[CONSERVING_UNMET] = 0;
    v->now[CONSERVING_MATRIX] = 0;
    v->now[CONSERVING_SINCE] = 0;
    return status;
}

static int init(cardan_run *run)
{
    const cardan_conserving v = cardan_conserving_at(run);
    int status = cardan_fixed_init(run);

    if (status == 0)
        status = cardan_conserving_masses(run, &v);
    return status != 0 ? status : restart(run, &v);
}

/* Whether the trial closes its positions, whatever corrections said; no equation binds speeds. */
static int closed(const cardan_run *run, const cardan_conserving *v, real h)
{
    return cardan_gaps_close(run, v->gaps + v->nu, v->m, h, fmax(1, run->size), 0);
}

/* Multipliers at the end of a step from those in the middle of it and of the one before. */
static void store_multipliers(const cardan_conserving *v)
{
    const real part = v->now[CONSERVING_SINCE] > 0 ? 0.5 : 1;

    for (ptrdiff_t k = 0; k < v->m; k++) {
        v->lam_old[k] = v->lam[k];
        v->lam[k] = v->lam_new[k] + part * (v->lam_new[k] - v->middle[k]);
        v->middle[k] = v->lam_new[k];
    }
}

/* Make the trial the present state. */
static int commit(cardan_run *run, const cardan_conserving *v, real h, real t)
{
    const ptrdiff_t nq = v->nq;
    cardan_in in;
    int status;

    cardan_normalize(run, run->trial);
    in = cardan_at(run, &t, run->trial);
    status = cardan_call_model(run, &run->qdot, &in, run->k);
    if (status != 0)
        return status;
    run->culprit = cardan_not_finite(run->trial, run->nx);
    if (run->culprit >= 0)
        return CARDAN_NOT_FINITE;
    for (ptrdiff_t i = 0; i < v->nu; i++)
        run->k[nq + i] = v->rise[i] = (run->trial[nq + i] - run->y[nq + i]) / h;
    for (ptrdiff_t i = run->nx; i < run->n; i++) {
        run->trial[i] = run->y[i];
        run->k[i] = 0;
    }
    if (!cardan_follows(run, t, run->trial, run->k))
        return CARDAN_ROTATION_UNRESOLVED;
    if (v->m > 0)
        cardan_note_gaps(run, v->gaps + v->nu, t);
    store_gaps(v);
    store_multipliers(v);
    for (ptrdiff_t i = 0; i < run->n; i++) {
        const real before = run->f[i];
        run->f[i] = run->k[i];
        run->k[i] = before;
        run->y_old[i] = run->y[i];
        run->y[i] = run->trial[i];
    }
    run->t_old = run->t;
    run->t = t;
    run->fresh = 1;
    run->is_dense = 0;
    run->steps++;
    run->in_segment++;
    v->now[CONSERVING_SINCE]++;
    return 0;
}

/* One step from t, y; half of it, a quarter, ... where the equations have no solution near by. */
static int step(cardan_run *run)
{
    const real interval = cardan_grid(run) - run->t;
    int status = cardan_refresh(run);

    run->culprit = -1;
    for (int part = 1; part <= SHORTEST && status == 0; part *= 2) {
        const cardan_conserving v = cardan_conserving_at(run);
        const real t_new = part == 1 ? cardan_grid(run) : run->t + interval / part;
        if (run->in_segment == 0 && part == 1)
            status = restart(run, &v);
        if (status == 0)
            status = cardan_conserving_solve(run, &v, t_new - run->t, t_new);
        if (status == 0 && !closed(run, &v, t_new - run->t))
            status = CARDAN_UNSOLVED;
        if (status == 0)
            return commit(run, &v, t_new - run->t, t_new);
        run->rejections++;
        status = status == CARDAN_UNSOLVED && part < SHORTEST ? 0 : status;
    }
    return status;
}

/* Cubic through coordinates and their rates at both ends of the last step; speeds go straight. */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n, nq = run->nq;
    const real h = run->t - run->t_old;

    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = run->y[i] - run->y_old[i];
        run->interpolant[i] = rise;
        run->interpolant[n + i] = i < nq ? h * run->k[i] - rise : 0;
        run->interpolant[2 * n + i] = i < nq ? 2 * rise - h * (run->k[i] + run->f[i]) : 0;
    }
    run->is_dense = 1;
    return 0;
}

/* Whether stored factors name rows that exist, and poses are those of the nodes (memory may come from a
 * file). */
static int sound(const cardan_run *run)
{
    const cardan_conserving v = cardan_conserving_at(run);
    ptrdiff_t poses = 0;
    int nodes = 1;

    for (ptrdiff_t place = 0; place < v.mesh->places; place++)
        poses += v.pose[place] != 0;
    for (ptrdiff_t k = 0; k < v.mesh->nodes; k++)
        nodes = nodes && v.pose[v.mesh->node[k]] != 0;
    return nodes && poses == v.mesh->nodes
           && cardan_sparse_sound(v.mesh->plan, &v.system.factors, v.now[CONSERVING_WEAK]);
}

const cardan_method cardan_conserving_method
    = {init, step, dense, length, sound, 1, 3, NULL, 0};
