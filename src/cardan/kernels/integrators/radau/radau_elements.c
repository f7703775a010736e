/* Stages of the Radau IIA method over elements with constraints: the stabilized index-2 form.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     q = q0 o exp(d),  T(d) d' = u + S^-1 Gᵀ mu,  g(q) = 0
 *     M u' + c - f - Gᵀ lam = 0,  G u + g_t = 0,  z' = zdot(q, u, z)
 *
 * d are increments along the speeds from the start of a step, T is the tangent of the rotations in
 * them, mu the multiplier of the positions (Gear, Gupta, Leimkuhler). Newton's iterations are those
 * of radau.c for u, z and lam: one real system and one complex one with c = h / ALONE and
 * h / (REAL + i IMAG),
 *
 *     [M + c C + c^2 K  Gᵀ] [c du      ]
 *     [G + c R          H ] [-c^2 dlam ]
 *
 * d follows from u by its own equation, stage by stage and node by node; what it misses of that
 * goes into the right-hand side. mu is found as a shift of d: the real matrix S takes the gap of
 * positions of a stage to it. Internal states take an iteration of their own before that of the
 * motion, element by element.
 * Neither lam nor mu is in the norm of an update or of an error.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., sections IV.8
 * and VII.4 to VII.7.
 */
#include "radau_elements.h"
#include "mesh_calls.h"
#include "mesh_states.h"
#include "radau_tables.h"
#include <float.h>
#include <math.h>

/* part of a state by which it is changed for slopes */
static const real CHANGED = 1e-7;

/* Point at everything in the memory of a run. Returns how many numbers that takes. */
static ptrdiff_t lay(const cardan_run *run, cardan_radau_stages *v)
{
    const cardan_mesh *mesh = v->mesh = run->mesh;
    real *memory = cardan_radau_memory(run);
    const ptrdiff_t nu = v->nu = run->nu, nz = v->nz = run->nz, m = v->m = mesh->m;
    const ptrdiff_t width = v->width = nu + nz + m, n = mesh->plan->n;
    const ptrdiff_t most = cardan_mesh_most_states(mesh);
    ptrdiff_t used = 0;

    /* what outlives a step */
    v->now = cardan_reserve(memory, &used, RADAU_NOW);
    v->lam = cardan_reserve(memory, &used, m);
    v->before = cardan_reserve(memory, &used, 3 * width);
    for (int power = 0; power < 3; power++)
        v->powers[power] = cardan_reserve(memory, &used, mesh->plan->values);
    v->change = cardan_reserve(memory, &used, nz);
    v->slopes = cardan_reserve(memory, &used, most * nz);
    v->tables = cardan_reserve(memory, &used, cardan_sparse_pair_length(mesh->plan));
    /* stages of a trial */
    v->x = cardan_reserve(memory, &used, 3 * width);
    v->w = cardan_reserve(memory, &used, 3 * width);
    v->d = cardan_reserve(memory, &used, 3 * nu);
    v->shift = cardan_reserve(memory, &used, 3 * nu);
    v->rates = cardan_reserve(memory, &used, 3 * nu);
    v->states = cardan_reserve(memory, &used, 3 * run->nx);
    v->maps = cardan_reserve(memory, &used, 27 * mesh->places);
    v->turns = cardan_reserve(memory, &used, 27 * mesh->places);
    v->residual = cardan_reserve(memory, &used, 3 * (nu + mesh->mp + m));
    v->gaps = cardan_reserve(memory, &used, 3 * mesh->mp);
    v->kinematic = cardan_reserve(memory, &used, 3 * nu);
    v->zdot = cardan_reserve(memory, &used, 3 * nz);
    v->udot = cardan_reserve(memory, &used, nu);
    v->padded = cardan_reserve(memory, &used, 2 * n);
    v->product = cardan_reserve(memory, &used, 2 * n);
    v->error = cardan_reserve(memory, &used, 2 * nu + nz);
    v->block = cardan_reserve(memory, &used, cardan_mesh_states_block(mesh));
    /* the complex system is one of elements with pairs of unknowns */
    cardan_sparse_pair(mesh->plan, v->tables, &v->pairs);
    v->doubled = *mesh;
    v->doubled.plan = &v->pairs;
    v->doubled.nu = 2 * nu;
    used += cardan_mesh_lay(mesh, memory ? memory + used : memory, &v->alone);
    used += cardan_mesh_lay(&v->doubled, memory ? memory + used : memory, &v->pair);
    return used;
}

/* A count that may come from a file; 0 if it is none. */
static int32_t count_of(real x, ptrdiff_t most)
{
    return x >= 0 && x <= (real)most ? (int32_t)x : 0;
}

void cardan_radau_stages_at(const cardan_run *run, cardan_radau_stages *v)
{
    (void)lay(run, v);
    v->alone.open = v->pair.open = NULL;
    v->alone.factors.weak = count_of(v->now[RADAU_WEAK], v->mesh->plan->n);
    v->pair.factors.weak = count_of(v->now[RADAU_WEAK_PAIR], v->pairs.n);
}

static ptrdiff_t length(const cardan_run *run)
{
    cardan_run measured = *run;
    cardan_radau_stages v;

    measured.method_memory = NULL;
    return lay(&measured, &v);
}

/* Whether the stored factors name rows that exist. The plan of pairs is written anew: what stands in
 * memory may come from a file. */
static int sound(const cardan_run *run)
{
    cardan_radau_stages v;

    cardan_radau_stages_at(run, &v);
    cardan_sparse_pair_fill(v.mesh->plan, v.tables);
    return cardan_sparse_sound(v.mesh->plan, &v.alone.factors, v.now[RADAU_WEAK])
           && cardan_sparse_sound(&v.pairs, &v.pair.factors, v.now[RADAU_WEAK_PAIR]);
}

cardan_state cardan_radau_state(const cardan_run *run, const real *t, const real *x, const real *lam)
{
    const cardan_in in = cardan_at(run, t, x);
    const cardan_state at = {.t = *in.t, .q = in.q, .u = in.u, .z = in.z, .s = run->s, .r = run->r,
                             .lam = lam};

    return at;
}

/* Root mean squares: d against the reference length, u against the fastest speed so far, z against
 * its own size. */
real cardan_radau_squares(cardan_run *run, const cardan_radau_stages *v, const real *d, const real *u,
                          const real *z, real *largest)
{
    const real *extent = v->now + RADAU_EXTENT, tolerance = run->rtol + run->atol;
    const real rate = run->atol + run->rtol * v->now[RADAU_FASTEST];
    const ptrdiff_t culprit = run->culprit;
    real most = 0, sum;

    /* each in units of its tolerance; the largest of all is the culprit */
    sum = cardan_mesh_squares(run, v->mesh, extent, d, &most) / (tolerance * tolerance);
    if (!cardan_exceeds(most / (tolerance * tolerance), *largest))
        run->culprit = culprit;
    *largest = cardan_worst(*largest, most / (tolerance * tolerance));
    most = *largest * rate * rate;
    sum += cardan_mesh_squares(run, v->mesh, extent, u, &most) / (rate * rate);
    *largest = most / (rate * rate);
    for (ptrdiff_t i = 0; i < v->nz; i++) {
        const real part = z[i] / cardan_scale(run, run->trial, run->nq + v->nu + i);
        sum += part * part;
        if (cardan_exceeds(part * part, *largest)) {
            *largest = part * part;
            run->culprit = run->nq + v->nu + i;
        }
    }
    return sum;
}

/* Start of a segment: multipliers, reference length, the plan of pairs. */
static int begin(cardan_run *run)
{
    cardan_radau_stages v;
    cardan_state at;
    const real *y = run->y;
    int status = cardan_inputs_at(run, run->t, y);

    cardan_radau_stages_at(run, &v);
    cardan_mesh_extent(run, v.mesh, v.now + RADAU_EXTENT, run->steps == 0);
    cardan_sparse_pair_fill(v.mesh->plan, v.tables);
    if (status != 0 || v.m == 0)
        return status;
    at = cardan_radau_state(run, &run->t, y, NULL);
    run->model_status = cardan_mesh_accelerations(v.mesh, &at, NULL, v.residual, run->work);
    for (ptrdiff_t k = 0; k < v.m; k++)
        v.lam[k] = v.residual[v.nu + k];
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* The matrices at the present state, and the slopes of internal states. */
static int jacobian(cardan_run *run, real h)
{
    const ptrdiff_t nq = run->nq, nz = run->nz;
    cardan_radau_stages v;
    cardan_state at;
    int status = cardan_inputs_at(run, run->t, run->y);

    cardan_radau_stages_at(run, &v);
    run->jacobians++;
    at = cardan_radau_state(run, &run->t, run->y, v.lam);
    at.udot = run->f + nq;
    if (status != 0)
        return status;
    run->model_status = cardan_mesh_powers(v.mesh, &at, v.powers, v.alone.work);
    /* changes of internal states that differences see beside rounding */
    for (ptrdiff_t i = 0; i < nz; i++) {
        const real z = run->y[nq + v.nu + i], rate = run->f[nq + v.nu + i];
        const real size = fmax(fabs(z), fabs(h * rate));
        v.change[i] = CHANGED * (size > 0 ? size : 1);
        v.states[i] = z;
    }
    if (run->model_status == 0 && nz > 0)
        run->model_status = cardan_mesh_slopes(v.mesh, &at, run->f + nq + v.nu, v.change, v.states,
                                               v.slopes, v.alone.work);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* The real and the complex matrix of a step h, in units of the first. */
static int factor(cardan_run *run, real h)
{
    const real c = h / ALONE, square = REAL * REAL + IMAG * IMAG;
    cardan_radau_stages v;
    int status;

    cardan_radau_stages_at(run, &v);
    for (ptrdiff_t i = 0; i < v.mesh->plan->values; i++)
        v.alone.a[i] = v.powers[0][i] + c * (v.powers[1][i] + c * v.powers[2][i]);
    cardan_sparse_pair_combine(v.mesh->plan, (const real *const *)v.powers, h * REAL / square,
                               -h * IMAG / square, v.pair.a);
    status = cardan_mesh_refactor(v.mesh, &v.alone);
    v.now[RADAU_WEAK] = (real)v.alone.factors.weak;
    /* both count equations and unknowns alike: of numbers near the imaginary axis the real part tells
     * no size */
    for (ptrdiff_t i = 0; i < v.pairs.n; i++) {
        v.pair.rows[i] = v.alone.rows[i / 2];
        v.pair.units[i] = v.alone.units[i / 2];
    }
    v.pair.factors.hidden = v.alone.factors.hidden;
    if (status == 0 && cardan_sparse_factor(&v.pairs, v.pair.a, &v.pair.factors) != 0)
        status = CARDAN_TOO_SMALL;
    v.now[RADAU_WEAK_PAIR] = (real)v.pair.factors.weak;
    return status == 0 ? 0 : CARDAN_TOO_SMALL;
}

/* Starting values: the polynomials of the last step; without them all stays as it is. */
static int predict(cardan_run *run, real h, real ratio)
{
    const real *u = run->y + run->nq;
    cardan_radau_stages v;
    real largest = 0, *fastest;

    cardan_radau_stages_at(run, &v);
    fastest = v.now + RADAU_FASTEST;
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < v.width; i++) {
            real *x = v.x + s * v.width + i;
            *x = ratio != 0 ? cardan_radau_beyond(v.before, v.width, i, NODES[s] * ratio) : 0;
            v.w[s * v.width + i] = *x;
        }
    cardan_radau_transform(T_INVERSE, v.width, v.w);
    /* increments as if rotations were small: the first iteration knows what that misses */
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < v.nu; i++) {
            real sum = 0;
            for (int j = 0; j < 3; j++)
                sum += A[s][j] * (u[i] + v.x[j * v.width + i]);
            v.d[s * v.nu + i] = h * sum;
            v.shift[s * v.nu + i] = 0;
        }
    /* against what an error of speeds counts */
    if (run->steps == 0)
        *fastest = 0;
    (void)cardan_mesh_squares(run, v.mesh, v.now + RADAU_EXTENT, u, &largest);
    *fastest = fmax(*fastest, sqrt(largest));
    largest = 0;
    (void)cardan_mesh_squares(run, v.mesh, v.now + RADAU_EXTENT, run->f + run->nq, &largest);
    *fastest = fmax(*fastest, fabs(h) * sqrt(largest));
    run->culprit = -1;
    return 0;
}

/* Rounding of positions, and of speeds that lead from one to another within the step. */
static real rounding(cardan_run *run, real h)
{
    cardan_radau_stages v;
    real coarse, rate;

    cardan_radau_stages_at(run, &v);
    coarse = fmax(DBL_EPSILON, cardan_mesh_rounding(run, v.mesh, v.now + RADAU_EXTENT));
    rate = run->atol + run->rtol * v.now[RADAU_FASTEST];
    return 10 * coarse * (1 / (run->rtol + run->atol) + 1 / (fabs(h) * rate));
}

const cardan_radau_form cardan_radau_elements = {
    length,  sound,   begin, jacobian, factor, predict, rounding, cardan_radau_elements_iterate, cardan_radau_elements_end,
    cardan_radau_elements_error, cardan_radau_elements_remember, 0.05, 1};
