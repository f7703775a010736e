/* Internal states of elements in a generalized-alpha step.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     z' = z + h ((1 - gamma) w + gamma w')
 *     (1 - am) w' + am w = (1 - af) zdot' + af zdot
 *
 * with coefficients of its own by the same spectral radius. For every state q', u' that Newton's
 * method looks at, z' is solved for element by element, with slopes by differences: its iteration
 * matrix does not know of them.
 * Source: K. E. Jansen, C. H. Whiting, G. M. Hulbert, Comput. Methods Appl. Mech. Eng. 190 (2000)
 * 305-319.
 */
#include "alpha.h"
#include <math.h>

enum { CORRECTIONS = 8, WIDEST = 8 };
static const real CHANGED = 1e-7; /* of a state, for differences */
static const real SOUGHT = 1e-14;

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

static int zdot_at(cardan_run *run, const cardan_alpha *v, real t, const real *z, real *zdot)
{
    const cardan_in in = cardan_at(run, &t, run->trial);
    const cardan_state at = {.t = *in.t, .q = in.q, .u = in.u, .z = z, .s = run->s, .r = run->r};

    run->model_status = cardan_mesh_zdot(v->mesh, &at, zdot, v->system.work);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* Solve a x = b (n) by elimination with pivots; a and b are overwritten. */
static void eliminate(ptrdiff_t n, real *a, real *b)
{
    for (ptrdiff_t k = 0; k < n; k++) {
        ptrdiff_t pivot = k;
        for (ptrdiff_t i = k + 1; i < n; i++)
            if (fabs(a[i * n + k]) > fabs(a[pivot * n + k]))
                pivot = i;
        for (ptrdiff_t j = 0; j < n && pivot != k; j++) {
            const real x = a[k * n + j];
            a[k * n + j] = a[pivot * n + j];
            a[pivot * n + j] = x;
        }
        const real x = b[k];
        b[k] = b[pivot];
        b[pivot] = x;
        for (ptrdiff_t i = k + 1; i < n; i++) {
            const real factor = a[i * n + k] / a[k * n + k];
            for (ptrdiff_t j = k; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
            b[i] -= factor * b[k];
        }
    }
    for (ptrdiff_t k = n - 1; k >= 0; k--) {
        for (ptrdiff_t j = k + 1; j < n; j++)
            b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
}

/* Corrections of the states of every element: (1 - c dzdot/dz) dz = missing. */
static void correct(const cardan_alpha *v, real c, const real *size, real *missing)
{
    const ptrdiff_t nz = v->mesh->nz;

    for (ptrdiff_t k = 0; k < v->mesh->group_count; k++) {
        const cardan_group *g = v->mesh->groups + k;
        const ptrdiff_t n = g->z_states < WIDEST ? g->z_states : WIDEST;
        for (ptrdiff_t e = 0; e < g->count; e++) {
            const ptrdiff_t *z = g->z + e * g->nz;
            real a[WIDEST * WIDEST], b[WIDEST];
            for (ptrdiff_t i = 0; i < n; i++) {
                b[i] = missing[z[i]];
                for (ptrdiff_t j = 0; j < n; j++)
                    a[i * n + j] = (i == j) - c * v->slopes[j * nz + z[i]] / size[z[j]];
            }
            eliminate(n, a, b);
            for (ptrdiff_t i = 0; i < n; i++)
                missing[z[i]] = b[i];
        }
    }
}

/* Changes of the rates where the j-th state of every element changes; by how much in `size`. */
static int differentiate(cardan_run *run, const cardan_alpha *v, real t, real *z, real *size)
{
    const ptrdiff_t nz = v->mesh->nz;
    int status = 0;

    for (ptrdiff_t i = 0; i < nz; i++)
        size[i] = CHANGED * fmax(1, fabs(z[i]));
    for (ptrdiff_t j = 0; j < WIDEST && status == 0; j++) {
        real *slope = v->slopes + j * nz;
        ptrdiff_t some = 0;
        for (int sign = 1; sign >= -1; sign -= 2)
            for (ptrdiff_t k = 0; k < v->mesh->group_count; k++) {
                const cardan_group *g = v->mesh->groups + k;
                for (ptrdiff_t e = 0; e < g->count && j < g->z_states; e++, some++)
                    z[g->z[e * g->nz + j]] += sign * size[g->z[e * g->nz + j]];
                if (sign > 0 && k + 1 == v->mesh->group_count && some > 0)
                    status = zdot_at(run, v, t, z, slope);
            }
        for (ptrdiff_t i = 0; i < nz && some > 0; i++)
            slope[i] -= v->zdot[i];
    }
    return status;
}

int cardan_alpha_internal(cardan_run *run, const cardan_alpha *v, real t)
{
    const coefficients m = first_order(v);
    const ptrdiff_t nz = v->mesh ? v->mesh->nz : 0, first = run->nq + run->nu;
    const real h = v->now[ALPHA_STEP], c = h * m.gamma * (1 - m.af) / (1 - m.am);
    const real *start = run->y + first, *rate = run->f + first;
    real *z = run->trial + first, *size = v->w_new, worst = 1;
    int status = 0;

    for (int k = 0; k < CORRECTIONS && nz > 0 && status == 0 && worst > SOUGHT; k++) {
        status = zdot_at(run, v, t, z, v->zdot);
        for (ptrdiff_t i = 0; i < nz; i++) {
            const real constant = (m.af * rate[i] - m.am * v->w[i]) / (1 - m.am);
            v->gap[i] = start[i] + h * ((1 - m.gamma) * v->w[i] + m.gamma * constant)
                        + c * v->zdot[i] - z[i];
        }
        if (status == 0 && k == 0)
            status = differentiate(run, v, t, z, size);
        correct(v, c, size, v->gap);
        worst = 0;
        for (ptrdiff_t i = 0; i < nz; i++) {
            worst = fmax(worst, fabs(v->gap[i]) / fmax(1, fabs(z[i])));
            z[i] += v->gap[i];
        }
        if (!(worst < INFINITY))
            return status != 0 ? status : CARDAN_UNSOLVED;
    }
    if (nz > 0 && status == 0)
        status = zdot_at(run, v, t, z, v->zdot);
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
