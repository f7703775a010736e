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
/* least determinant of a tangent of a rotation: it is 0 at a whole turn */
static const real SINGULAR = 0.1;

/* Point at everything in the memory of a run. Returns how many numbers that takes. */
static ptrdiff_t lay(const cardan_run *run, cardan_radau_stages *v)
{
    const cardan_mesh *mesh = v->mesh = run->mesh;
    real *memory = cardan_radau_memory(run);
    const ptrdiff_t nu = v->nu = run->nu, nz = v->nz = run->nz, m = v->m = mesh->m;
    const ptrdiff_t width = v->width = nu + nz + m, n = mesh->plan->n;
    const ptrdiff_t most = cardan_mesh_most_states(mesh);
    ptrdiff_t used = 0;

    v->now = cardan_reserve(memory, &used, RADAU_NOW);
    v->lam = cardan_reserve(memory, &used, m);
    v->before = cardan_reserve(memory, &used, 3 * width);
    for (int power = 0; power < 3; power++)
        v->powers[power] = cardan_reserve(memory, &used, mesh->plan->values);
    v->change = cardan_reserve(memory, &used, nz);
    v->slopes = cardan_reserve(memory, &used, most * nz);
    v->tables = cardan_reserve(memory, &used, cardan_sparse_pair_length(mesh->plan));
    v->x = cardan_reserve(memory, &used, 3 * width);
    v->w = cardan_reserve(memory, &used, 3 * width);
    v->d = cardan_reserve(memory, &used, 3 * nu);
    v->shift = cardan_reserve(memory, &used, 3 * nu);
    v->rates = cardan_reserve(memory, &used, 3 * nu);
    v->states = cardan_reserve(memory, &used, 3 * run->nx);
    v->maps = cardan_reserve(memory, &used, 27 * mesh->places);
    v->residual = cardan_reserve(memory, &used, 3 * (nu + mesh->mp + m));
    v->gaps = cardan_reserve(memory, &used, 3 * mesh->mp);
    v->kinematic = cardan_reserve(memory, &used, 3 * nu);
    v->zdot = cardan_reserve(memory, &used, 3 * nz);
    v->udot = cardan_reserve(memory, &used, nu);
    v->padded = cardan_reserve(memory, &used, 2 * n);
    v->product = cardan_reserve(memory, &used, 2 * n);
    v->error = cardan_reserve(memory, &used, 2 * nu + nz);
    v->block = cardan_reserve(memory, &used, cardan_mesh_states_block(mesh));
    cardan_sparse_pair(mesh->plan, v->tables, &v->pairs);
    v->doubled = *mesh;
    v->doubled.plan = &v->pairs;
    v->doubled.nu = 2 * nu;
    used += cardan_mesh_lay(mesh, memory ? memory + used : memory, &v->alone);
    used += cardan_mesh_lay(&v->doubled, memory ? memory + used : memory, &v->pair);
    return used;
}

void cardan_radau_stages_at(const cardan_run *run, cardan_radau_stages *v)
{
    (void)lay(run, v);
    v->alone.open = v->pair.open = NULL;
    v->alone.factors.weak = (int32_t)v->now[RADAU_WEAK];
    v->pair.factors.weak = (int32_t)v->now[RADAU_WEAK_PAIR];
}

static ptrdiff_t length(const cardan_run *run)
{
    cardan_run measured = *run;
    cardan_radau_stages v;

    measured.method_memory = NULL;
    return lay(&measured, &v);
}

/* Tables of elements do not come from files. */
static int sound(const cardan_run *run)
{
    (void)run;
    return 0;
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

    sum = cardan_mesh_squares(run, v->mesh, extent, d, &most) / (tolerance * tolerance);
    if (most / (tolerance * tolerance) <= *largest)
        run->culprit = culprit;
    *largest = fmax(*largest, most / (tolerance * tolerance));
    most = *largest * rate * rate;
    sum += cardan_mesh_squares(run, v->mesh, extent, u, &most) / (rate * rate);
    *largest = most / (rate * rate);
    for (ptrdiff_t i = 0; i < v->nz; i++) {
        const real part = z[i] / cardan_scale(run, run->trial, run->nq + v->nu + i);
        sum += part * part;
        if (!(part * part <= *largest)) {
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

/* a (3, n) = B a with a matrix over the stages */
static void transform(const real B[3][3], ptrdiff_t n, real *a)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        const real x = a[i], y = a[n + i], z = a[2 * n + i];
        for (int s = 0; s < 3; s++)
            a[s * n + i] = B[s][0] * x + B[s][1] * y + B[s][2] * z;
    }
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
    transform(T_INVERSE, v.width, v.w);
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

/* T d' = u of a place that turns: d' of its rotation. Returns whether T can be inverted. */
static int unturned(const real *T, const real *u, real *rate)
{
    const real a = T[4] * T[8] - T[5] * T[7], b = T[5] * T[6] - T[3] * T[8],
               c = T[3] * T[7] - T[4] * T[6], det = T[0] * a + T[1] * b + T[2] * c;

    rate[0] = (a * u[0] + (T[2] * T[7] - T[1] * T[8]) * u[1] + (T[1] * T[5] - T[2] * T[4]) * u[2]) / det;
    rate[1] = (b * u[0] + (T[0] * T[8] - T[2] * T[6]) * u[1] + (T[2] * T[3] - T[0] * T[5]) * u[2]) / det;
    rate[2] = (c * u[0] + (T[1] * T[6] - T[0] * T[7]) * u[1] + (T[0] * T[4] - T[1] * T[3]) * u[2]) / det;
    return det > SINGULAR;
}

int cardan_radau_chart_rates(const cardan_mesh *mesh, const real *maps, const real *u, real *rates)
{
    int regular = 1;

    for (ptrdiff_t place = 0; place < mesh->places; place++) {
        const ptrdiff_t first = mesh->u[place], n = mesh->u[place + 1] - first;
        for (ptrdiff_t i = n >= 3 ? 3 : 0; i < n; i++)
            rates[first + i] = u[first + i];
        if (n >= 3)
            regular &= unturned(maps + 9 * place, u + first, rates + first);
    }
    return regular ? 0 : CARDAN_TOO_SMALL;
}

/* State of a stage for its present increments; the tangents of its rotations. */
int cardan_radau_place(cardan_run *run, const cardan_radau_stages *v, int stage)
{
    const real *x = v->x + stage * v->width;
    real *state = v->states + stage * run->nx;

    run->model_status = cardan_mesh_move(v->mesh, run->y, v->d + stage * v->nu, state,
                                         v->maps + 9 * stage * v->mesh->places, v->alone.work);
    for (ptrdiff_t i = 0; i < v->nu + v->nz; i++)
        state[run->nq + i] = run->y[run->nq + i] + x[i];
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* One iteration of the internal states of all stages. */
static int settle(cardan_run *run, const cardan_radau_stages *v, real h)
{
    const ptrdiff_t nz = v->nz, width = v->width;
    const real square = REAL * REAL + IMAG * IMAG, c = h / ALONE, re = h * REAL / square,
               im = -h * IMAG / square;
    real *f = v->zdot, *w = v->w + v->nu;

    for (int s = 0; s < 3; s++) {
        const real t = run->t + NODES[s] * h;
        int status = cardan_inputs_at(run, t, v->states + s * run->nx);
        const cardan_state at = cardan_radau_state(run, &t, v->states + s * run->nx, NULL);
        if (status != 0)
            return status;
        run->model_status = cardan_mesh_zdot(v->mesh, &at, f + s * nz, v->alone.work);
        if (run->model_status != 0)
            return CARDAN_MODEL;
    }
    transform(T_INVERSE, nz, f);
    for (ptrdiff_t i = 0; i < nz; i++) {
        const real x = f[nz + i], y = f[2 * nz + i];
        f[i] = c * f[i] - w[i];
        f[nz + i] = re * x - im * y - w[width + i];
        f[2 * nz + i] = re * y + im * x - w[2 * width + i];
    }
    cardan_mesh_states_solve(v->mesh, c, 0, v->change, v->slopes, f, NULL, v->block);
    cardan_mesh_states_solve(v->mesh, re, im, v->change, v->slopes, f + nz, f + 2 * nz, v->block);
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < nz; i++)
            w[s * width + i] += f[s * nz + i];
    transform(T, nz, f);
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < nz; i++) {
            v->x[s * width + v->nu + i] += f[s * nz + i];
            v->states[s * run->nx + run->nq + v->nu + i] += f[s * nz + i];
        }
    return 0;
}

/* What is missing in the equations of all stages, and what d misses of its own. */
static int residuals(cardan_run *run, const cardan_radau_stages *v, real h)
{
    const ptrdiff_t nu = v->nu, width = v->width, rows = nu + v->mesh->mp + v->m;
    const real *w = v->w;
    real *lam = v->padded;
    int status = 0;

    for (int s = 0; s < 3 && status == 0; s++) {
        const real t = run->t + NODES[s] * h, *state = v->states + s * run->nx;
        cardan_state at;

        for (ptrdiff_t i = 0; i < nu; i++) {
            const real one = w[width + i], two = w[2 * width + i];
            v->udot[i] = (T[s][0] * ALONE * w[i] + T[s][1] * (REAL * one - IMAG * two)
                          + T[s][2] * (REAL * two + IMAG * one)) / h;
        }
        for (ptrdiff_t k = 0; k < v->m; k++)
            lam[k] = v->lam[k] + v->x[s * width + nu + v->nz + k];
        status = cardan_inputs_at(run, t, state);
        if (status != 0)
            return status;
        at = cardan_radau_state(run, &t, state, lam);
        at.udot = v->udot;
        run->evaluations++;
        run->model_status =
            cardan_mesh_balance(v->mesh, &at, v->residual + s * rows, v->alone.work);
        if (run->model_status != 0)
            return CARDAN_MODEL;
        status = cardan_radau_chart_rates(v->mesh, v->maps + 9 * s * v->mesh->places,
                                          state + run->nq, v->rates + s * nu);
    }
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < nu; i++) {
            real sum = v->shift[s * nu + i] - v->d[s * nu + i];
            for (int j = 0; j < 3; j++)
                sum += h * A[s][j] * v->rates[j * nu + i];
            v->kinematic[s * nu + i] = sum;
        }
    return status;
}

/* product (n) = a matrix times a vector of speeds */
static const real *times(const cardan_radau_stages *v, int power, const real *speeds, int room)
{
    const ptrdiff_t n = v->mesh->plan->n;
    real *x = v->padded, *y = v->product + room * n;

    for (ptrdiff_t i = 0; i < n; i++)
        x[i] = i < v->nu ? speeds[i] : 0;
    cardan_sparse_multiply(v->mesh->plan, v->powers[power], x, y);
    return y;
}

/* The real system for the transformed residual (nu + m) and what d misses (nu): updates of speeds and
 * multipliers in place of the residual. */
static int solve_alone(const cardan_radau_stages *v, real c, real *speeds, real *multipliers,
                       const real *missed)
{
    const ptrdiff_t *unknown = v->mesh->unknown;
    cardan_mesh_system system = v->alone;
    const real *stiff = times(v, 2, missed, 0), *turned = times(v, 1, missed, 1);
    int status;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        system.right[i] = -c * c * (speeds[i] + stiff[i]);
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = -c * (multipliers[k] + turned[unknown[k]]);
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        speeds[i] = system.solution[i] / c;
    for (ptrdiff_t k = 0; k < v->m; k++)
        multipliers[k] = -system.solution[unknown[k]] / (c * c);
    return status;
}

/* The same of the complex system, for real and imaginary parts one behind the other. */
static int solve_pair(const cardan_radau_stages *v, real re, real im, real *speeds, real *imaginary,
                      real *multipliers, real *imaginary_multipliers, const real *missed)
{
    const real re2 = re * re - im * im, im2 = 2 * re * im;
    const real size = re * re + im * im;
    const ptrdiff_t nu = v->nu, *unknown = v->mesh->unknown;
    cardan_mesh_system system = v->pair;
    const real *one = times(v, 2, missed, 0), *two = times(v, 2, missed + nu, 1);
    int status;

    for (ptrdiff_t i = 0; i < nu; i++) {
        const real x = speeds[i] + one[i], y = imaginary[i] + two[i];
        system.right[2 * i] = -re2 * x + im2 * y;
        system.right[2 * i + 1] = -re2 * y - im2 * x;
    }
    one = times(v, 1, missed, 0), two = times(v, 1, missed + nu, 1);
    for (ptrdiff_t k = 0; k < v->m; k++) {
        const ptrdiff_t j = unknown[k];
        const real x = multipliers[k] + one[j], y = imaginary_multipliers[k] + two[j];
        system.right[2 * j] = -re * x + im * y;
        system.right[2 * j + 1] = -re * y - im * x;
    }
    status = cardan_mesh_solve(&v->doubled, &system);
    for (ptrdiff_t i = 0; i < nu; i++) {
        const real x = system.solution[2 * i], y = system.solution[2 * i + 1];
        speeds[i] = (re * x + im * y) / size;
        imaginary[i] = (re * y - im * x) / size;
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        const ptrdiff_t j = unknown[k];
        const real x = system.solution[2 * j], y = system.solution[2 * j + 1];
        multipliers[k] = -(re2 * x + im2 * y) / (size * size);
        imaginary_multipliers[k] = -(re2 * y - im2 * x) / (size * size);
    }
    return status;
}

/* New increments d of a stage, `change` (nu) what that changes, and its shift, which takes the gap
 * of positions that will be left. */
static int close_stage(const cardan_radau_stages *v, int stage, real *change)
{
    const ptrdiff_t nu = v->nu, mp = v->mesh->mp, *unknown = v->mesh->unknown;
    const real *gaps = v->gaps + stage * mp;
    real *d = v->d + stage * nu, *shift = v->shift + stage * nu;
    cardan_mesh_system system = v->alone;
    int status = 0;

    if (mp > 0) {
        const real *closing = times(v, 0, change, 0);
        for (ptrdiff_t i = 0; i < nu; i++)
            system.right[i] = 0;
        for (ptrdiff_t k = 0; k < v->m; k++)
            system.right[unknown[k]] = k < mp ? -gaps[k] - closing[unknown[k]] : 0;
        status = cardan_mesh_solve(v->mesh, &system);
        for (ptrdiff_t i = 0; i < nu; i++) {
            shift[i] += system.solution[i];
            change[i] += system.solution[i];
        }
    }
    for (ptrdiff_t i = 0; i < nu; i++)
        d[i] += change[i];
    return status;
}

/* Updates of speeds and multipliers of all stages, in place of their residuals. */
static int solve(const cardan_radau_stages *v, real h)
{
    const ptrdiff_t nu = v->nu, mp = v->mesh->mp, rows = nu + mp + v->m;
    const real square = REAL * REAL + IMAG * IMAG;
    real *b = v->residual;
    int status;

    transform(T_INVERSE, rows, b);
    transform(T_INVERSE, nu, v->kinematic);
    status = solve_alone(v, h / ALONE, b, b + nu + mp, v->kinematic);
    if (status == 0)
        status = solve_pair(v, h * REAL / square, -h * IMAG / square, b + rows, b + 2 * rows,
                            b + rows + nu + mp, b + 2 * rows + nu + mp, v->kinematic + nu);
    /* without convergence there are shorter steps */
    return status == 0 ? 0 : CARDAN_TOO_SMALL;
}

/* New increments of all stages by their new speeds, and what that changes. */
static int move(const cardan_radau_stages *v, real h, const real *speeds, ptrdiff_t stride)
{
    const ptrdiff_t nu = v->nu;
    int status = 0;

    for (int s = 0; s < 3 && status == 0; s++)
        status = cardan_radau_chart_rates(v->mesh, v->maps + 9 * s * v->mesh->places,
                                          speeds + s * stride, v->rates + s * nu);
    for (int s = 0; s < 3 && status == 0; s++) {
        real *change = v->kinematic + s * nu;
        for (ptrdiff_t i = 0; i < nu; i++) {
            real sum = v->shift[s * nu + i] - v->d[s * nu + i];
            for (int j = 0; j < 3; j++)
                sum += h * A[s][j] * v->rates[j * nu + i];
            change[i] = sum;
        }
        status = close_stage(v, s, change);
    }
    return status == 0 ? 0 : CARDAN_TOO_SMALL;
}

/* One simplified Newton iteration; `size` receives the norm of the update. */
static int iterate(cardan_run *run, real h, real *size)
{
    const ptrdiff_t nq = run->nq, nu = run->nu, nz = run->nz;
    cardan_radau_stages v;
    real largest = 0, sum = 0;
    int status = 0;

    cardan_radau_stages_at(run, &v);
    const ptrdiff_t mp = v.mesh->mp, rows = nu + mp + v.m;
    real *b = v.residual;
    for (int s = 0; s < 3 && status == 0; s++)
        status = cardan_radau_place(run, &v, s);
    if (status == 0 && nz > 0)
        status = settle(run, &v, h);
    if (status == 0)
        status = residuals(run, &v, h);
    for (int s = 0; s < 3 && status == 0; s++)
        for (ptrdiff_t k = 0; k < mp; k++)
            v.gaps[s * mp + k] = b[s * rows + nu + k];
    if (status == 0)
        status = solve(&v, h);
    if (status != 0)
        return status;
    for (int s = 0; s < 3; s++) {
        for (ptrdiff_t i = 0; i < nu; i++)
            v.w[s * v.width + i] += b[s * rows + i];
        for (ptrdiff_t k = 0; k < v.m; k++)
            v.w[s * v.width + nu + nz + k] += b[s * rows + nu + mp + k];
    }
    transform(T, rows, b);
    for (int s = 0; s < 3; s++) {
        real *x = v.x + s * v.width, *state = v.states + s * run->nx + nq;
        for (ptrdiff_t i = 0; i < nu; i++) {
            x[i] += b[s * rows + i];
            state[i] += b[s * rows + i];
        }
        for (ptrdiff_t k = 0; k < v.m; k++)
            x[nu + nz + k] += b[s * rows + nu + mp + k];
    }
    status = move(&v, h, v.states + nq, run->nx);
    for (int s = 0; s < 3; s++)
        sum += cardan_radau_squares(run, &v, v.kinematic + s * nu, b + s * rows, v.zdot + s * nz,
                                    &largest);
    *size = sqrt(sum / (real)cardan_larger_of(3 * (2 * nu + nz), 1));
    return status;
}

const cardan_radau_form cardan_radau_elements = {
    length,  sound,   begin, jacobian, factor, predict, rounding, iterate, cardan_radau_elements_end,
    cardan_radau_elements_error, cardan_radau_elements_remember, 0.05};
