/* What stages over elements are solved with: see stages_elements.c.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "radau_tables.h"
#include "stages_elements.h"
#include <string.h>

enum { STAGES = 3 };

ptrdiff_t cardan_element_stages_lay(const cardan_run *run, real *memory, cardan_element_stages *at)
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
    at->before = cardan_reserve(memory, &used, 3 * mesh->nu);
    at->speeds = cardan_reserve(memory, &used, 3 * mesh->nu);
    at->moved = cardan_reserve(memory, &used, mesh->nq);
    at->missing = cardan_reserve(memory, &used, 3 * run->nx);
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

/* The factors of P for a step of size h, with the Jacobian at t, y. */
int cardan_element_stages_factor(const cardan_steps *steps, cardan_element_stages *at, real t, real h,
                                 const real *y)
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

/* Rates (4) of a unit quaternion p at twice an angular velocity w, in its axes. */
static void turn(const real *p, const real *w, real factor, real *rates)
{
    const real a = factor * w[0], b = factor * w[1], c = factor * w[2];

    rates[0] = -p[1] * a - p[2] * b - p[3] * c;
    rates[1] = p[0] * a - p[3] * b + p[2] * c;
    rates[2] = p[3] * a + p[0] * b - p[1] * c;
    rates[3] = -p[2] * a + p[1] * b + p[0] * c;
}

/* Changes of coordinates (nq) at q from those along the speeds (nu): N = d qdot / d u times `along`, or
 * where `inverse` the transposed of the inverse of N. */
static void outward(const cardan_mesh *mesh, const real *q, int inverse, const real *along, real *change)
{
    for (ptrdiff_t place = 0; place < mesh->places; place++) {
        const ptrdiff_t first = mesh->q[place], at = mesh->u[place], nu = mesh->u[place + 1] - at;
        const ptrdiff_t has_quaternion = mesh->q[place + 1] - first > nu;
        for (ptrdiff_t i = has_quaternion ? 3 : 0; i < nu; i++)
            change[first + i + has_quaternion] = along[at + i];
        if (has_quaternion)
            turn(q + first, along + at, inverse ? 2 : 0.5, change + first);
    }
}

/* The other way round: the transposed of N times `change`, or where `inverse` the inverse of N. */
static void inward(const cardan_mesh *mesh, const real *q, int inverse, const real *change, real *along)
{
    const real factor = inverse ? 2 : 0.5;

    for (ptrdiff_t place = 0; place < mesh->places; place++) {
        const ptrdiff_t first = mesh->q[place], at = mesh->u[place], nu = mesh->u[place + 1] - at;
        const ptrdiff_t has_quaternion = mesh->q[place + 1] - first > nu;
        const real *p = q + first, *x = change + first;
        for (ptrdiff_t i = has_quaternion ? 3 : 0; i < nu; i++)
            along[at + i] = x[i + has_quaternion];
        if (!has_quaternion)
            continue;
        along[at] = factor * (-p[1] * x[0] + p[0] * x[1] + p[3] * x[2] - p[2] * x[3]);
        along[at + 1] = factor * (-p[2] * x[0] - p[3] * x[1] + p[0] * x[2] + p[1] * x[3]);
        along[at + 2] = factor * (-p[3] * x[0] + p[2] * x[1] - p[1] * x[2] + p[0] * x[3]);
    }
}

void cardan_element_rates(const cardan_mesh *mesh, const real *q, const real *u, real *rates)
{
    outward(mesh, q, 0, u, rates);
}

/* product (n) of a matrix, or of its transposed, with speeds, or with n numbers. */
static const real *times(const cardan_element_stages *at, int power, int transposed, const real *x, ptrdiff_t count,
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
static void solve_alone(const cardan_element_stages *at, real c, int transposed, real *along, real *speeds)
{
    const cardan_mesh *mesh = at->mesh;
    const ptrdiff_t nu = mesh->nu, n = mesh->plan->n, *unknown = mesh->unknown;
    real *right = at->alone.right, *solution = at->alone.solution;
    const real *inert, *stiff;

    /* the steps of the other case in the opposite order */
    if (transposed) {
        for (ptrdiff_t i = 0; i < n; i++)
            right[i] = i < nu ? speeds[i] + c * along[i] : 0;
        cardan_sparse_solve_transposed(mesh->plan, &at->alone.factors, 1, right, solution);
        inert = times(at, 0, 1, solution, n, 0);
        stiff = times(at, 2, 1, solution, nu, 1);
        for (ptrdiff_t i = 0; i < nu; i++) {
            speeds[i] = inert[i];
            along[i] -= c * stiff[i];
        }
        return;
    }
    /* M b - c K a, and G b for the constraints */
    inert = times(at, 0, 0, speeds, nu, 0);
    stiff = times(at, 2, 0, along, nu, 1);
    for (ptrdiff_t i = 0; i < nu; i++)
        right[i] = inert[i] - c * stiff[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        right[unknown[k]] = inert[unknown[k]];
    cardan_sparse_solve(mesh->plan, &at->alone.factors, 1, right, solution);
    for (ptrdiff_t i = 0; i < nu; i++) {
        speeds[i] = solution[i];
        along[i] += c * solution[i];
    }
}

/* The same for c = re + i im; changes are pairs (2, nu) of real and imaginary parts. Transposed, it is
 * that of the conjugate of c: conjugates go in and come out. */
static void solve_pair(const cardan_element_stages *at, real re, real im, int transposed, real *along, real *speeds)
{
    const cardan_mesh *mesh = at->mesh;
    const ptrdiff_t nu = mesh->nu, n = mesh->plan->n, *unknown = mesh->unknown;
    const real side = transposed ? -1 : 1;
    real *right = at->pair.right, *solution = at->pair.solution;
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
        cardan_sparse_solve_transposed(&at->pairs, &at->pair.factors, 1, right, solution);
        for (ptrdiff_t i = 0; i < n; i++) {
            right[i] = solution[2 * i];
            right[n + i] = -solution[2 * i + 1];
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
        cardan_sparse_solve(&at->pairs, &at->pair.factors, 1, right, solution);
        for (ptrdiff_t i = 0; i < nu; i++) {
            const real x = solution[2 * i], y = solution[2 * i + 1];
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

/* x (3, nx) becomes P^-1 x, or P^-T x: as axes are at the stage in the middle. */
void cardan_element_stages_precondition(const cardan_steps *steps, const cardan_element_stages *at,
                                        int transposed, real *x)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t nq = run->nq, nu = run->nu, nx = run->nx;
    const real h = *at->h, square = REAL * REAL + IMAG * IMAG;

    transform(transposed ? T : T_INVERSE, transposed, nx, nx, x);
    /* internal states follow no others here: for them P is 1 */
    for (int s = 0; s < STAGES; s++) {
        inward(at->mesh, steps->states + nx, !transposed, x + s * nx, at->along + s * nu);
        for (ptrdiff_t i = 0; i < nu; i++)
            at->speeds[s * nu + i] = x[s * nx + nq + i];
    }
    memcpy(at->before, at->along, (size_t)(STAGES * nu) * sizeof(real));
    solve_alone(at, h / ALONE, transposed, at->along, at->speeds);
    solve_pair(at, h * REAL / square, -h * IMAG / square, transposed, at->along + nu, at->speeds + nu);
    for (int s = 0; s < STAGES; s++) {
        /* what speeds do not move, such as lengths of quaternions, stays */
        for (ptrdiff_t i = s * nu; i < (s + 1) * nu; i++)
            at->along[i] -= at->before[i];
        outward(at->mesh, steps->states + nx, transposed, at->along + s * nu, at->moved);
        for (ptrdiff_t i = 0; i < nq; i++)
            x[s * nx + i] += at->moved[i];
        for (ptrdiff_t i = 0; i < nu; i++)
            x[s * nx + nq + i] = at->speeds[s * nu + i];
    }
    transform(transposed ? T_INVERSE : T, transposed, nx, nx, x);
}
