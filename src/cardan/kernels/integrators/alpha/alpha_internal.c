/* Internal states of elements in a generalized-alpha step.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     z' = z + h ((1 - gamma) w + gamma w')
 *     (1 - am) w' + am w = (1 - af) zdot' + af zdot
 *
 * with coefficients of its own by the same spectral radius. For every state q', u' that Newton's
 * method looks at, z' is solved for by Newton's method, element by element, with slopes by
 * differences: the iteration matrix of the motion does not know of them. What does not converge is a
 * failed step.
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

/* The trial with internal states z. */
static cardan_state state_of(const cardan_run *run, const real *t, const real *z)
{
    const cardan_in in = cardan_at(run, t, run->trial);
    const cardan_state at = {.t = *in.t, .q = in.q, .u = in.u, .z = z, .s = run->s, .r = run->r};

    return at;
}

static int zdot_at(cardan_run *run, const cardan_alpha *v, real t, const real *z, real *zdot)
{
    const cardan_state at = state_of(run, &t, z);

    run->model_status = cardan_mesh_zdot(v->mesh, &at, zdot, v->system.work);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* Slopes (most states of an element, nz): changes of the rates where the j-th state of every element
 * changes; `change` (nz): by how much. */
static int differentiate(cardan_run *run, const cardan_alpha *v, real t, real *z, real *change)
{
    const cardan_state at = state_of(run, &t, z);

    for (ptrdiff_t i = 0; i < v->mesh->nz; i++)
        change[i] = CHANGED * (v->terms[i] > 0 ? v->terms[i] : 1);
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

    for (ptrdiff_t i = 0; i < v->mesh->nz; i++) {
        const real explicit_rate = (m->af * rate[i] - m->am * v->w[i]) / (1 - m->am);
        const real added = h * ((1 - m->gamma) * v->w[i] + m->gamma * explicit_rate);
        v->gap[i] = start[i] + added + c * v->zdot[i] - z[i];
        v->terms[i] = fabs(start[i]) + fabs(added) + fabs(c * v->zdot[i]) + fabs(z[i]);
    }
}

/* Add to the terms of every state what the states of its element have in its rate: it may cancel. */
static void add_terms(const cardan_alpha *v, real c, const real *change, const real *z)
{
    const ptrdiff_t nz = v->mesh->nz;

    for (ptrdiff_t k = 0; k < v->mesh->group_count; k++) {
        const cardan_group *g = v->mesh->groups + k;
        for (ptrdiff_t e = 0; e < g->count; e++) {
            const ptrdiff_t *z_of = g->z + e * g->nz;
            for (ptrdiff_t i = 0; i < g->z_states; i++)
                for (ptrdiff_t j = 0; j < g->z_states; j++)
                    v->terms[z_of[i]] +=
                        fabs(c * v->slopes[j * nz + z_of[i]] / change[z_of[j]] * z[z_of[j]]);
        }
    }
}

/* The largest part of its terms that a state misses; the worst state. */
static real largest(const cardan_alpha *v, ptrdiff_t *worst)
{
    real most = 0;

    for (ptrdiff_t i = 0; i < v->mesh->nz; i++) {
        const real part = v->gap[i] == 0 ? 0 : fabs(v->gap[i]) / v->terms[i];
        if (!(part <= most)) {
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
        int status = zdot_at(run, v, t, z, v->zdot);
        if (status != 0)
            return status;
        miss(run, v, &m, h, z);
        if (renew)
            status = differentiate(run, v, t, z, change);
        if (status != 0)
            return status;
        add_terms(v, c, change, z);
        const real size = largest(v, &worst);
        /* nothing, or as little as rounding lets it become */
        if (size <= SOUGHT || (size <= ROUNDING && size > 0.5 * last))
            return 0;
        if (!(size < INFINITY))
            break;
        cardan_mesh_states_solve(v->mesh, c, 0, change, v->slopes, v->gap, NULL, v->block);
        for (ptrdiff_t i = 0; i < v->mesh->nz; i++)
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
    const ptrdiff_t nz = v->mesh ? v->mesh->nz : 0;
    const real *rate = run->f + run->nq + run->nu;
    const int status = nz > 0 ? solve(run, v, t, v->w_new) : 0;

    for (ptrdiff_t i = 0; i < nz; i++)
        v->w_new[i] = ((1 - m.af) * v->zdot[i] + m.af * rate[i] - m.am * v->w[i]) / (1 - m.am);
    return status;
}

void cardan_alpha_internal_restart(const cardan_run *run, const cardan_alpha *v, real share, int fresh)
{
    const ptrdiff_t nz = v->mesh ? v->mesh->nz : 0;
    const real *rate = run->f + run->nq + run->nu;

    for (ptrdiff_t i = 0; i < nz; i++)
        v->w[i] = fresh ? rate[i] : rate[i] + share * (v->w[i] - rate[i]);
}

real cardan_alpha_internal_error(const cardan_run *run, const cardan_alpha *v, real h)
{
    const ptrdiff_t nz = v->mesh ? v->mesh->nz : 0, first = run->nq + run->nu;
    real sum = 0;

    /* distance of the result from that of the trapezoidal rule, of the order of the error */
    for (ptrdiff_t i = 0; i < nz; i++) {
        const real other = run->y[first + i] + 0.5 * h * (run->f[first + i] + v->zdot[i]);
        const real size = fmax(fabs(run->y[first + i]), fabs(run->trial[first + i]));
        const real part = (run->trial[first + i] - other) / (run->atol + run->rtol * size);
        sum += part * part;
    }
    return nz > 0 ? sqrt(sum / (real)nz) : 0;
}
