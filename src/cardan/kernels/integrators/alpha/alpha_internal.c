/* Internal states in a generalized-alpha step.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     z' = z + h ((1 - gamma) w + gamma w')
 *     (1 - am) w' + am w = (1 - af) zdot' + af zdot
 *
 * with coefficients of its own by the same spectral radius. For every state q', u' that Newton's
 * method looks at, z' is solved for by Newton's method with slopes by differences: of elements in
 * tables one by one, else all together. The iteration matrix of the motion does not know of them. What
 * does not converge is a failed step.
 * Source: K. E. Jansen, C. H. Whiting, G. M. Hulbert, Comput. Methods Appl. Mech. Eng. 190 (2000)
 * 305-319.
 */
#include "alpha.h"
#include "mesh_states.h"
#include <math.h>

enum { MOST_CORRECTIONS = 50 };
/* parts of the terms that a state consists of. CHANGED: for differences. SOUGHT: what may be missing;
 * ROUNDING: below that it may stand still. SLOW: convergence rate from which on slopes are new */
static const real CHANGED = 1e-7, SOUGHT = 1e-14, ROUNDING = 1e-10, SLOW = 0.1;

typedef struct coefficients {
    real am, af, gamma;
} coefficients;

/* Spectral radius at infinite frequency of the method for speeds, and what follows from it. */
static coefficients first_order(const cardan_alpha *v)
{
    const real rho = v->am != 0 ? v->af / (1 - v->af) : (1 - v->af) / (1 + v->af);
    const real am = (3 * rho - 1) / (2 * (1 + rho)), af = rho / (1 + rho);
    const coefficients c = {am, af, 0.5 - am + af};

    return c;
}

/* The trial with its internal states. */
static cardan_state state_of(const cardan_run *run, const real *t)
{
    const cardan_in in = cardan_at(run, t, run->trial);
    const cardan_state at = {.t = *in.t, .q = in.q, .u = in.u, .z = in.z, .s = in.s, .r = in.r};

    return at;
}

/* Rates (nz) of the internal states of the trial. */
static int zdot_at(cardan_run *run, const cardan_alpha *v, real t, real *zdot)
{
    const cardan_state at = state_of(run, &t);
    cardan_in in;

    if (!v->mesh) {
        in = cardan_at(run, &t, run->trial);
        return cardan_call_model(run, &run->internal_rates, &in, zdot);
    }
    run->model_status = cardan_mesh_zdot(v->mesh, &at, zdot, v->system.work);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* Slopes of a model that is no mesh, (nz, nz): changes of the rates where the j-th state changes. */
static int slopes_of_all(cardan_run *run, const cardan_alpha *v, real t, real *z, const real *change)
{
    const ptrdiff_t nz = run->nz;
    int status = 0;

    for (ptrdiff_t j = 0; j < nz && status == 0; j++) {
        const real before = z[j];
        z[j] += change[j];
        status = zdot_at(run, v, t, v->slopes + j * nz);
        z[j] = before;
        for (ptrdiff_t i = 0; i < nz; i++)
            v->slopes[j * nz + i] -= v->zdot[i];
    }
    return status;
}

/* Slopes (most states of an element, nz): changes of the rates where the j-th state of every element
 * changes; `change` (nz): by how much. */
static int differentiate(cardan_run *run, const cardan_alpha *v, real t, real *z, real *change)
{
    const cardan_state at = state_of(run, &t);

    for (ptrdiff_t i = 0; i < run->nz; i++)
        change[i] = CHANGED * (v->terms[i] > 0 ? v->terms[i] : 1);
    if (!v->mesh)
        return slopes_of_all(run, v, t, z, change);
    run->model_status =
        cardan_mesh_slopes(v->mesh, &at, v->zdot, change, z, v->slopes, v->system.work);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* What z (nz) misses of the rule of a step, into `gap`; the size of the terms it consists of. */
static void miss(const cardan_run *run, const cardan_alpha *v, const coefficients *m, real h,
                 const real *z)
{
    const ptrdiff_t first = run->nq + run->nu;
    const real c = h * m->gamma * (1 - m->af) / (1 - m->am);
    const real *start = run->y + first, *rate = run->f + first;

    for (ptrdiff_t i = 0; i < run->nz; i++) {
        const real explicit_rate = (m->af * rate[i] - m->am * v->w[i]) / (1 - m->am);
        const real added = h * ((1 - m->gamma) * v->w[i] + m->gamma * explicit_rate);
        v->gap[i] = start[i] + added + c * v->zdot[i] - z[i];
        v->terms[i] = fabs(start[i]) + fabs(added) + fabs(c * v->zdot[i]) + fabs(z[i]);
    }
}

/* Add to the terms of the states of an element what its states have in their rates: it may cancel. */
static void add_terms(const cardan_alpha *v, cardan_element_states of, ptrdiff_t nz, real c,
                      const real *change, const real *z)
{
    for (ptrdiff_t i = 0; i < of.count; i++)
        for (ptrdiff_t j = 0; j < of.count; j++) {
            const ptrdiff_t row = cardan_state_index(&of, i), column = cardan_state_index(&of, j);
            v->terms[row] += fabs(c * v->slopes[j * nz + row] / change[column] * z[column]);
        }
}

/* The same of all elements. */
static void add_all_terms(const cardan_run *run, const cardan_alpha *v, real c, const real *change,
                          const real *z)
{
    const cardan_element_states all = {run->nz, NULL};

    if (!v->mesh)
        add_terms(v, all, run->nz, c, change, z);
    for (ptrdiff_t k = 0; v->mesh && k < v->mesh->group_count; k++)
        for (ptrdiff_t e = 0; e < v->mesh->groups[k].count; e++)
            add_terms(v, cardan_mesh_states_of(v->mesh->groups + k, e), run->nz, c, change, z);
}

/* (1 - c slopes / change) gap = gap. */
static void solve_gap(const cardan_run *run, const cardan_alpha *v, real c, const real *change)
{
    const cardan_element_states all = {run->nz, NULL};

    if (v->mesh)
        cardan_mesh_states_solve(v->mesh, c, 0, change, v->slopes, v->gap, NULL, v->block);
    else
        cardan_states_solve(all, run->nz, c, 0, change, v->slopes, v->gap, NULL, v->block);
}

/* The largest part of its terms that a state misses; the worst state. */
static real largest(const cardan_run *run, const cardan_alpha *v, ptrdiff_t *worst)
{
    real most = 0;

    for (ptrdiff_t i = 0; i < run->nz; i++) {
        const real part = v->gap[i] == 0 ? 0 : fabs(v->gap[i]) / v->terms[i];
        if (cardan_exceeds(part, most)) {
            most = part;
            *worst = i;
        }
        if (!(part < INFINITY))
            break;
    }
    return most;
}

/* Solve for z' of the trial, `zdot` their rates; `change`: room (nz). */
static int solve(cardan_run *run, const cardan_alpha *v, real t, real *change)
{
    const coefficients m = first_order(v);
    const ptrdiff_t first = run->nq + run->nu;
    const real h = v->now[ALPHA_STEP], c = h * m.gamma * (1 - m.af) / (1 - m.am);
    real *z = run->trial + first, last = INFINITY;
    ptrdiff_t worst = 0;
    int renew = 1;

    for (int k = 0; k <= MOST_CORRECTIONS; k++) {
        int status = zdot_at(run, v, t, v->zdot);
        if (status != 0)
            return status;
        miss(run, v, &m, h, z);
        if (renew)
            status = differentiate(run, v, t, z, change);
        if (status != 0)
            return status;
        add_all_terms(run, v, c, change, z);
        const real size = largest(run, v, &worst);
        /* nothing, or as little as rounding lets it become */
        if (size <= SOUGHT || (size <= ROUNDING && size > 0.5 * last))
            return 0;
        if (!(size < INFINITY))
            break;
        solve_gap(run, v, c, change);
        for (ptrdiff_t i = 0; i < run->nz; i++)
            z[i] += v->gap[i];
        renew = size > SLOW * last;
        last = size;
    }
    run->culprit = first + worst;
    return CARDAN_UNSOLVED;
}

int cardan_alpha_internal(cardan_run *run, const cardan_alpha *v, real t)
{
    const coefficients m = first_order(v);
    const real *rate = run->f + run->nq + run->nu;
    const int status = solve(run, v, t, v->w_new);

    for (ptrdiff_t i = 0; i < run->nz; i++)
        v->w_new[i] = ((1 - m.af) * v->zdot[i] + m.af * rate[i] - m.am * v->w[i]) / (1 - m.am);
    return status;
}

void cardan_alpha_internal_restart(const cardan_run *run, const cardan_alpha *v, real share, int fresh)
{
    const real *rate = run->f + run->nq + run->nu;

    for (ptrdiff_t i = 0; i < run->nz; i++)
        v->w[i] = fresh ? rate[i] : rate[i] + share * (v->w[i] - rate[i]);
}

real cardan_alpha_internal_error(const cardan_run *run, const cardan_alpha *v, real h)
{
    const ptrdiff_t nz = run->nz, first = run->nq + run->nu;
    real sum = 0;

    /* distance of the result from that of the trapezoidal rule, of the order of the error */
    for (ptrdiff_t i = 0; i < nz; i++) {
        const real other = run->y[first + i] + 0.5 * h * (run->f[first + i] + v->zdot[i]);
        const real size = fmax(fabs(run->y[first + i]), fabs(run->trial[first + i]));
        const real part = (run->trial[first + i] - other) / (run->atol + run->rtol * size);
        sum += part * part;
    }
    return sqrt(sum / (real)nz);
}
