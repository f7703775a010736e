/* Stages of the Radau IIA method over elements, as rates of the state: see stages.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * The matrix of the stages is never made. Systems with it are solved by iterations
 *
 *     x += P^-1 (b - (I - h A J) x),  P = I - h A J0
 *
 * with one J0 for all stages, that at the start of the step. By the eigenvalues of A, P is a real and a
 * complex system, and these are those of a step of the method itself: with c = 1 / s
 *
 *     s dq - du = a,  s du - du' = b  =>  [M + c C + c^2 K, G^T; G + c R, H] du = [c M b - c^2 K a; c G b]
 *
 * where changes of axes within the step are left out, which costs iterations and no accuracy.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#include "mesh_calls.h"
#include "radau_tables.h"
#include "steps.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST = 60, STAGES = 3 };
/* corrections of entries, of the largest one of their block, that count as rounding */
static const real ROUNDING = 64 * DBL_EPSILON;
/* what may be left where rounding keeps corrections from shrinking further */
static const real STUCK = 1e-6;

typedef struct rooms {
    const cardan_mesh *mesh;
    cardan_mesh doubled; /* the mesh with the plan of pairs */
    cardan_sparse pairs;
    real *h;             /* (1) of the step */
    real *powers[3];     /* see cardan_mesh_powers */
    real *tables;        /* of the plan of pairs */
    cardan_mesh_system alone, pair;
    real *solution;      /* (nu + m) accelerations and multipliers, then memory of their solution */
    real *padded;        /* (n) */
    real *product;       /* (4, n) */
    real *along;         /* (3, nu) changes along the speeds */
    real *speeds;        /* (3, nu) */
    real *rest;          /* (3, nx) what is left of an equation */
    real *applied;       /* (3, nx) */
} rooms;

static ptrdiff_t lay(const cardan_run *run, real *memory, rooms *at)
{
    const cardan_mesh *mesh = at->mesh = run->mesh;
    const ptrdiff_t n = mesh->plan->n;
    ptrdiff_t used = 0;

    at->h = cardan_reserve(memory, &used, 1);
    for (int power = 0; power < 3; power++)
        at->powers[power] = cardan_reserve(memory, &used, mesh->plan->values);
    at->tables = cardan_reserve(memory, &used, cardan_sparse_pair_length(mesh->plan));
    at->solution = cardan_reserve(memory, &used, mesh->nu + mesh->m + cardan_mesh_call_work(mesh));
    at->padded = cardan_reserve(memory, &used, n);
    at->product = cardan_reserve(memory, &used, 4 * n);
    at->along = cardan_reserve(memory, &used, 3 * mesh->nu);
    at->speeds = cardan_reserve(memory, &used, 3 * mesh->nu);
    at->rest = cardan_reserve(memory, &used, 3 * run->nx);
    at->applied = cardan_reserve(memory, &used, 3 * run->nx);
    /* the complex system is one of elements with pairs of unknowns */
    cardan_sparse_pair(mesh->plan, at->tables, &at->pairs);
    at->doubled = *mesh;
    at->doubled.plan = &at->pairs;
    at->doubled.nu = 2 * mesh->nu;
    used += cardan_mesh_lay(mesh, memory ? memory + used : NULL, &at->alone);
    used += cardan_mesh_lay(&at->doubled, memory ? memory + used : NULL, &at->pair);
    return used;
}

ptrdiff_t cardan_element_stages_length(const cardan_run *run)
{
    rooms at = {0};

    return lay(run, NULL, &at);
}

/* The factors of P for a step of size h from y at t. */
static int prepare(const cardan_steps *steps, rooms *at, real t, real h, const real *y)
{
    const cardan_in in = cardan_step_in(steps, &t, y);
    const real c = h / ALONE, square = REAL * REAL + IMAG * IMAG;
    cardan_state state = cardan_state_of(&in);
    real *work = at->solution + at->mesh->nu + at->mesh->m;
    int status = cardan_mesh_accelerations(at->mesh, &state, NULL, at->solution, work);

    *at->h = h;
    state.udot = at->solution;
    state.lam = at->solution + at->mesh->nu;
    if (status == 0)
        status = cardan_mesh_powers(at->mesh, &state, at->powers, at->alone.work);
    if (status != 0)
        return CARDAN_MODEL;
    for (ptrdiff_t i = 0; i < at->mesh->plan->values; i++)
        at->alone.a[i] = at->powers[0][i] + c * (at->powers[1][i] + c * at->powers[2][i]);
    cardan_sparse_pair_fill(at->mesh->plan, at->tables);
    cardan_sparse_pair_combine(at->mesh->plan, (const real *const *)at->powers, h * REAL / square,
                               -h * IMAG / square, at->pair.a);
    if (cardan_mesh_refactor(at->mesh, &at->alone) != 0)
        return CARDAN_UNSOLVED;
    /* both count equations and unknowns alike, as in the method */
    for (ptrdiff_t i = 0; i < at->pairs.n; i++) {
        at->pair.rows[i] = at->alone.rows[i / 2];
        at->pair.units[i] = at->alone.units[i / 2];
    }
    at->pair.factors.hidden = at->alone.factors.hidden;
    return cardan_sparse_factor(&at->pairs, at->pair.a, &at->pair.factors) == 0 ? 0 : CARDAN_UNSOLVED;
}

/* Between changes of coordinates (nq) and along the speeds (nu) at q: N = d qdot / d u, its transposed,
 * and the inverses of both where speeds move. */
enum { FORWARD, BACKWARD, UNDO, UNDO_TRANSPOSED };
static void convert(const cardan_mesh *mesh, const real *q, int what, real *by_q, real *by_u)
{
    for (ptrdiff_t place = 0; place < mesh->places; place++) {
        const ptrdiff_t first = mesh->q[place], n = mesh->q[place + 1] - first;
        const ptrdiff_t at = mesh->u[place], nu = mesh->u[place + 1] - at, turned = n > nu;
        const real *p = q + first, factor = what == UNDO || what == UNDO_TRANSPOSED ? 2 : 0.5;
        real *x = by_q + first, *y = by_u + at;
        for (ptrdiff_t i = turned ? 3 : 0; i < nu; i++)
            if (what == FORWARD || what == UNDO_TRANSPOSED)
                x[i + turned] = y[i];
            else
                y[i] = x[i + turned];
        if (!turned)
            continue;
        /* a unit quaternion: its rates are half of its product with the angular velocity */
        if (what == FORWARD || what == UNDO_TRANSPOSED) {
            const real a = factor * y[0], b = factor * y[1], c = factor * y[2];
            x[0] = -p[1] * a - p[2] * b - p[3] * c;
            x[1] = p[0] * a - p[3] * b + p[2] * c;
            x[2] = p[3] * a + p[0] * b - p[1] * c;
            x[3] = -p[2] * a + p[1] * b + p[0] * c;
        } else {
            y[0] = factor * (-p[1] * x[0] + p[0] * x[1] + p[3] * x[2] - p[2] * x[3]);
            y[1] = factor * (-p[2] * x[0] - p[3] * x[1] + p[0] * x[2] + p[1] * x[3]);
            y[2] = factor * (-p[3] * x[0] + p[2] * x[1] - p[1] * x[2] + p[0] * x[3]);
        }
    }
}

/* product (n) of a matrix, or of its transposed, with speeds, or with n numbers. */
static const real *times(const rooms *at, int power, int transposed, const real *x, ptrdiff_t count,
                         int room)
{
    const ptrdiff_t n = at->mesh->plan->n;
    real *y = at->product + room * n;

    for (ptrdiff_t i = 0; i < n; i++)
        at->padded[i] = i < count ? x[i] : 0;
    if (transposed)
        cardan_sparse_multiply_transposed(at->mesh->plan, at->powers[power], at->padded, y);
    else
        cardan_sparse_multiply(at->mesh->plan, at->powers[power], at->padded, y);
    return y;
}

/* (s - J0)^-1 s of a change along (nu), of speeds (nu), in place; s = 1 / c real. */
static void solve_alone(const rooms *at, real c, int transposed, real *along, real *speeds)
{
    const cardan_mesh *mesh = at->mesh;
    const ptrdiff_t nu = mesh->nu, n = mesh->plan->n, *unknown = mesh->unknown;
    real *right = at->alone.right, *found = at->alone.solution;
    const real *inert, *stiff;

    if (transposed) {
        for (ptrdiff_t i = 0; i < n; i++)
            right[i] = i < nu ? speeds[i] + c * along[i] : 0;
        cardan_sparse_solve_transposed(mesh->plan, &at->alone.factors, 1, right, found);
        inert = times(at, 0, 1, found, n, 0);
        stiff = times(at, 2, 1, found, nu, 1);
        for (ptrdiff_t i = 0; i < nu; i++) {
            speeds[i] = inert[i];
            along[i] -= c * stiff[i];
        }
        return;
    }
    inert = times(at, 0, 0, speeds, nu, 0);
    stiff = times(at, 2, 0, along, nu, 1);
    for (ptrdiff_t i = 0; i < nu; i++)
        right[i] = inert[i] - c * stiff[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        right[unknown[k]] = inert[unknown[k]];
    cardan_sparse_solve(mesh->plan, &at->alone.factors, 1, right, found);
    for (ptrdiff_t i = 0; i < nu; i++) {
        speeds[i] = found[i];
        along[i] += c * found[i];
    }
}

/* The same for c = re + i im; changes are pairs (2, nu) of real and imaginary parts. Transposed, it is
 * that of the conjugate of c: conjugates go in and come out. */
static void solve_pair(const rooms *at, real re, real im, int transposed, real *along, real *speeds)
{
    const cardan_mesh *mesh = at->mesh;
    const ptrdiff_t nu = mesh->nu, n = mesh->plan->n, *unknown = mesh->unknown;
    const real side = transposed ? -1 : 1;
    real *right = at->pair.right, *found = at->pair.solution;
    const real *inert, *also, *stiff, *more;

    for (ptrdiff_t i = 0; i < nu; i++) {
        along[nu + i] *= side;
        speeds[nu + i] *= side;
    }
    memset(right, 0, (size_t)(2 * n) * sizeof(real));
    if (transposed) {
        for (ptrdiff_t i = 0; i < nu; i++) {
            right[2 * i] = speeds[i] + re * along[i] - im * along[nu + i];
            /* pairs stand for numbers in equations as they are: the transposed of their matrix is that
             * of the conjugate */
            right[2 * i + 1] = -(speeds[nu + i] + re * along[nu + i] + im * along[i]);
        }
        cardan_sparse_solve_transposed(&at->pairs, &at->pair.factors, 1, right, found);
        for (ptrdiff_t i = 0; i < n; i++) {
            right[i] = found[2 * i];
            right[n + i] = -found[2 * i + 1];
        }
        inert = times(at, 0, 1, right, n, 0);
        also = times(at, 0, 1, right + n, n, 1);
        stiff = times(at, 2, 1, right, nu, 2);
        more = times(at, 2, 1, right + n, nu, 3);
        for (ptrdiff_t i = 0; i < nu; i++) {
            speeds[i] = inert[i];
            speeds[nu + i] = also[i];
            along[i] -= re * stiff[i] - im * more[i];
            along[nu + i] -= re * more[i] + im * stiff[i];
        }
    } else {
        inert = times(at, 0, 0, speeds, nu, 0);
        also = times(at, 0, 0, speeds + nu, nu, 1);
        stiff = times(at, 2, 0, along, nu, 2);
        more = times(at, 2, 0, along + nu, nu, 3);
        for (ptrdiff_t i = 0; i < nu; i++) {
            right[2 * i] = inert[i] - re * stiff[i] + im * more[i];
            right[2 * i + 1] = also[i] - re * more[i] - im * stiff[i];
        }
        for (ptrdiff_t k = 0; k < mesh->m; k++) {
            right[2 * unknown[k]] = inert[unknown[k]];
            right[2 * unknown[k] + 1] = also[unknown[k]];
        }
        cardan_sparse_solve(&at->pairs, &at->pair.factors, 1, right, found);
        for (ptrdiff_t i = 0; i < nu; i++) {
            const real x = found[2 * i], y = found[2 * i + 1];
            speeds[i] = x;
            speeds[nu + i] = y;
            along[i] += re * x - im * y;
            along[nu + i] += re * y + im * x;
        }
    }
    for (ptrdiff_t i = 0; i < nu; i++) {
        along[nu + i] *= side;
        speeds[nu + i] *= side;
    }
}

/* a (3, n) = B a, or B^T a, with a matrix over the stages; rows of a are `stride` apart. */
static void transform(const real B[3][3], int transposed, ptrdiff_t n, ptrdiff_t stride, real *a)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        const real x[3] = {a[i], a[stride + i], a[2 * stride + i]};
        for (int s = 0; s < 3; s++) {
            real sum = 0;
            for (int j = 0; j < 3; j++)
                sum += (transposed ? B[j][s] : B[s][j]) * x[j];
            a[s * stride + i] = sum;
        }
    }
}

/* x (3, nx) becomes P^-1 x, or P^-T x, for a step from y. */
static void precondition(const cardan_steps *steps, const rooms *at, int transposed, real *x)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t nq = run->nq, nu = run->nu, nx = run->nx;
    const real h = *at->h, square = REAL * REAL + IMAG * IMAG;

    transform(transposed ? T : T_INVERSE, transposed, nx, nx, x);
    for (int s = 0; s < STAGES; s++) {
        convert(at->mesh, steps->states, transposed ? BACKWARD : UNDO, x + s * nx,
                at->along + s * nu);
        for (ptrdiff_t i = 0; i < nu; i++)
            at->speeds[s * nu + i] = x[s * nx + nq + i];
    }
    solve_alone(at, h / ALONE, transposed, at->along, at->speeds);
    solve_pair(at, h * REAL / square, -h * IMAG / square, transposed, at->along + nu, at->speeds + nu);
    for (int s = 0; s < STAGES; s++) {
        convert(at->mesh, steps->states, transposed ? UNDO_TRANSPOSED : FORWARD, x + s * nx,
                at->along + s * nu);
        for (ptrdiff_t i = 0; i < nu; i++)
            x[s * nx + nq + i] = at->speeds[s * nu + i];
    }
    transform(transposed ? T_INVERSE : T, transposed, nx, nx, x);
}

/* The largest correction (3, nx) of an entry, of the largest entry of its block in x. */
static real size_of(const cardan_run *run, const real *correction, const real *x)
{
    const ptrdiff_t nx = run->nx, ends[4] = {0, run->nq, run->nq + run->nu, nx};
    real largest = 0;

    for (int block = 0; block < 3; block++) {
        real most = 0, whole = 0;
        for (ptrdiff_t s = 0; s < STAGES; s++)
            for (ptrdiff_t i = s * nx + ends[block]; i < s * nx + ends[block + 1]; i++) {
                most = fmax(most, fabs(correction[i]));
                whole = fmax(whole, fabs(x[i]));
                if (!(correction[i] - correction[i] == 0))
                    return INFINITY;
            }
        largest = fmax(largest, whole > 0 ? most / whole : most);
    }
    return largest;
}

/* Whether corrections are over: 1, or CARDAN_UNSOLVED where they grow. */
static int settled(real size, real *last)
{
    const int done = size <= ROUNDING || (size <= STUCK && size > 0.5 * *last);

    if (!done && !(size < 4 * *last))
        return CARDAN_UNSOLVED;
    *last = size;
    return done;
}

/* First slopes from states at both ends: of speeds the mean, of coordinates those of the cubic polynomial
 * with their rates at the ends, as positions that leave gaps may have no accelerations. */
static void guess(const cardan_steps *steps, const rooms *at, real h, const real *y, const real *next)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t nq = run->nq, nx = run->nx;
    real *first = at->rest, *last = at->rest + nx;

    convert(at->mesh, y, FORWARD, first, (real *)y + nq);
    convert(at->mesh, next, FORWARD, last, (real *)next + nq);
    for (ptrdiff_t s = 0; s < STAGES; s++)
        for (ptrdiff_t i = 0; i < nx; i++) {
            const real c = steps->nodes[s], mean = (next[i] - y[i]) / h;
            real *slope = steps->slopes + s * nx + i;
            *slope = mean;
            if (i < nq)
                *slope = (1 - c) * (1 - 3 * c) * first[i] + c * (3 * c - 2) * last[i] + 6 * c * (1 - c) * mean;
        }
}

int cardan_element_stages_solve(const cardan_steps *steps, ptrdiff_t k)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t width = cardan_row_width(run), nx = run->nx;
    const real *row = steps->rows + k * width, *y = row + 1, *next = row + width + 1;
    const real t = row[0], h = row[width] - t;
    real last = INFINITY;
    rooms at = {0};
    int status;

    (void)lay(run, steps->system, &at);
    status = prepare(steps, &at, t, h, y);
    guess(steps, &at, h, y, next);
    for (int n = 0; n < MOST && status == 0; n++) {
        cardan_stage_states(steps, h, y);
        for (ptrdiff_t s = 0; s < STAGES && status == 0; s++)
            status = cardan_rates_at(steps, t + steps->nodes[s] * h, steps->states + s * nx,
                                     at.rest + s * nx);
        if (status != 0)
            return status;
        for (ptrdiff_t i = 0; i < STAGES * nx; i++)
            at.rest[i] -= steps->slopes[i];
        precondition(steps, &at, 0, at.rest);
        for (ptrdiff_t i = 0; i < STAGES * nx; i++)
            steps->slopes[i] += at.rest[i];
        status = settled(size_of(run, at.rest, steps->slopes), &last);
    }
    if (status == 1)
        cardan_stage_states(steps, h, y);
    return status == 1 ? 0 : status == 0 ? CARDAN_UNSOLVED : status;
}

/* out (3, nx) = A x, or A^T x, over the stages, times a factor. */
static void combine(const cardan_steps *steps, int transposed, real factor, const real *x, real *out)
{
    const ptrdiff_t nx = steps->run->nx;

    for (ptrdiff_t i = 0; i < STAGES * nx; i++) {
        const ptrdiff_t s = i / nx;
        real sum = 0;
        for (ptrdiff_t j = 0; j < STAGES; j++)
            sum += steps->matrix[transposed ? j * STAGES + s : s * STAGES + j] * x[j * nx + i % nx];
        out[i] = factor * sum;
    }
}

int cardan_element_stages_refine(const cardan_steps *steps, int transposed, real *x,
                                 cardan_stage_product *product, const void *context)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t size = STAGES * run->nx;
    real *b = steps->open, last = INFINITY;
    rooms at = {0};
    int status = 0;

    (void)lay(run, steps->system, &at);
    memcpy(b, x, (size_t)size * sizeof(real));
    precondition(steps, &at, transposed, x);
    for (int n = 0; n < MOST && status == 0; n++) {
        /* the Jacobian of a stage is that of its own equation: it comes last, transposed first */
        if (!transposed)
            combine(steps, 0, *at.h, x, at.rest);
        if (product(context, transposed ? x : at.rest, at.applied) != 0)
            return CARDAN_MODEL;
        if (transposed) {
            combine(steps, 1, *at.h, at.applied, at.rest);
            memcpy(at.applied, at.rest, (size_t)size * sizeof(real));
        }
        for (ptrdiff_t i = 0; i < size; i++)
            at.rest[i] = b[i] - x[i] + at.applied[i];
        precondition(steps, &at, transposed, at.rest);
        for (ptrdiff_t i = 0; i < size; i++)
            x[i] += at.rest[i];
        status = settled(size_of(run, at.rest, x), &last);
    }
    return status == 1 ? 0 : status == 0 ? CARDAN_UNSOLVED : status;
}
