/* Systems of equations with the matrices of a mesh.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_matrix.h"
#include <math.h>

/* backward error of a solution that is enough, and how often one is improved */
static const real ENOUGH = 1e-13, GOOD = 1e-8;
/* what rounding may leave of rows of constraints, of the motion, where they are redundant */
static const real CONSISTENT = 1e-10;
/* sine of the angle to others at which a row is one of its own however wide gaps are */
static const real SMALL_SINE = 1e-4;
/* what resists a free motion, of what resists others */
static const real FREE = 1e-6;
/* what a correction takes of a residual that redundant rows cannot fit, of it */
static const real REDUNDANT = 1e-2;
/* what equations of forces may miss beside that: its rounding over a replaced pivot */
static const real FORCES = 1e-6;
/* what resists a speed, of what resists most, for a unit of its own: below that it may be rounding, or
 * the forces of a short step at bodies without inertia, and beside them other bodies would vanish */
static const real LEAST = 1e-8;
/* corrections of a solution, and of one that is not good yet while it becomes better */
enum { IMPROVE = 4, AT_MOST = 20 };

ptrdiff_t cardan_mesh_lay(const cardan_mesh *mesh, real *block, cardan_mesh_system *system)
{
    const cardan_sparse *plan = mesh->plan;
    const ptrdiff_t n = plan->n;
    cardan_sparse_factors *factors = &system->factors;
    ptrdiff_t used = 0;

    system->right = cardan_reserve(block, &used, n);
    system->solution = cardan_reserve(block, &used, n);
    system->rows = cardan_reserve(block, &used, n);
    system->units = cardan_reserve(block, &used, n);
    system->a = cardan_reserve(block, &used, plan->values);
    factors->values = cardan_reserve(block, &used, plan->factors);
    factors->scale = cardan_reserve(block, &used, n);
    factors->shift = cardan_reserve(block, &used, n);
    factors->work = cardan_reserve(block, &used, cardan_sparse_work(plan));
    /* two of them in the room of a number */
    factors->pivot = (int32_t *)(void *)cardan_reserve(block, &used, n);
    factors->exchanged = block ? factors->pivot + n : NULL;
    factors->replaced = (int32_t *)(void *)cardan_reserve(block, &used, n);
    factors->rows = system->rows;
    factors->columns = system->units;
    factors->certainty = cardan_reserve(block, &used, CARDAN_SPARSE_CERTAINTY);
    /* whoever has factors from earlier says how many of their pivots were replaced */
    factors->count = factors->weak = 0;
    factors->hidden = factors->compliance = 0;
    system->work = cardan_reserve(block, &used, 3 * n + cardan_mesh_room(mesh));
    return used;
}

/* The largest number of a row of constraints, in units of the speeds; of one that no mode holds its
 * diagonal. */
static real most_of(const cardan_mesh *mesh, const cardan_mesh_system *system, ptrdiff_t block,
                    const real *row)
{
    const cardan_sparse *plan = mesh->plan;
    real most = 0;

    for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
        const int32_t column = plan->column[pair];
        for (ptrdiff_t j = plan->first[column]; j < plan->first[column + 1]; j++, row++)
            most = cardan_most(most, fabs(*row) * (j < mesh->nu ? system->units[j] : 1));
    }
    return most;
}

/* Units: the root of the inverse of what resists a speed; what nothing resists, or rounding, counts
 * like the least that does. Rows of constraints have a largest number of 1 then: were they counted in
 * units of the least too, rounding in a coordinate without mass would make zeros of them.
 */
static void weigh(const cardan_mesh *mesh, cardan_mesh_system *system)
{
    real largest = 0, least = INFINITY, smallest = 1;

    /* the diagonal stands in the place of the units until these are known */
    for (ptrdiff_t i = 0; i < mesh->nu; i++) {
        system->units[i] = fabs(system->a[mesh->diagonal[i]]);
        largest = cardan_most(largest, system->units[i]);
    }
    for (ptrdiff_t i = 0; i < mesh->nu; i++) {
        const real entry = system->units[i];
        if (entry > LEAST * largest && entry < least)
            least = entry;
    }
    if (!(least < INFINITY))
        least = 1;
    for (ptrdiff_t i = 0; i < mesh->nu; i++) {
        const real entry = system->units[i];
        if (!(entry >= smallest * least))
            smallest = entry / least;
        system->rows[i] = system->units[i] = 1 / sqrt(cardan_most(least, entry));
    }
    if (system->factors.certainty)
        system->factors.certainty[CARDAN_SPARSE_DIAGONAL] = smallest * (1 - GOOD);
    for (ptrdiff_t block = mesh->places; block < mesh->plan->blocks; block++) {
        const real *row = system->a + mesh->plan->at[block];
        for (ptrdiff_t k = mesh->plan->first[block]; k < mesh->plan->first[block + 1]; k++) {
            const real most = most_of(mesh, system, block, row);
            system->rows[k] = system->units[k] = most > 0 ? 1 / most : sqrt(least);
            row += mesh->plan->stride[block];
        }
    }
}

int cardan_mesh_factor(const cardan_mesh *mesh, const cardan_state *at,
                       const cardan_assembly *parts, cardan_mesh_system *system, int *assembled)
{
    const int status = cardan_mesh_matrix(mesh, at, parts, system);

    *assembled = status == 0;
    return status != 0 ? status : cardan_mesh_refactor(mesh, system);
}

/* Factor the matrix as it stands. */
int cardan_mesh_refactor(const cardan_mesh *mesh, cardan_mesh_system *system)
{
    weigh(mesh, system);
    system->sine = system->open ? cardan_mesh_sine(mesh, system, system->open) : 0;
    system->factors.hidden = fmin(system->sine, SMALL_SINE) * fmin(system->sine, SMALL_SINE);
    return cardan_sparse_factor(mesh->plan, system->a, &system->factors) == 0 ? 0
                                                                             : CARDAN_UNSOLVED;
}

int cardan_mesh_massless(const cardan_mesh *mesh, const cardan_mesh_system *system)
{
    const cardan_sparse_factors *factors = &system->factors;

    real *x = system->solution, *y = system->work, moved = 0, resists = 0;

    if (factors->weak == 0 || cardan_sparse_free_column(mesh->plan, factors, x) < 0)
        return 0;
    /* beside it stand multipliers of redundant rows, of any size: the speeds alone must be free */
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        x[mesh->unknown[k]] = 0;
    cardan_sparse_multiply(mesh->plan, system->a, x, y);
    for (ptrdiff_t i = 0; i < mesh->plan->n; i++) {
        moved = fmax(moved, fabs(x[i] / system->units[i]));
        resists = fmax(resists, fabs(system->rows[i] * y[i]));
    }
    /* nothing of it moves where a row of constraints holds nothing at all */
    return moved > 0 && resists <= FREE * moved ? CARDAN_SINGULAR : 0;
}

/* x (n) by the factors of a matrix that has lost pivots, without what it maps to nothing.
 *
 * Redundant rows of an iteration matrix fit the right-hand side only to the order of the step. What
 * does not fit grows by the inverse of a replaced pivot, into multipliers that the matrix maps to
 * nothing: a second solution, of what it maps them to, is free of them. t: room (n).
 */
static void pass(const cardan_mesh *mesh, const cardan_mesh_system *system, const real *b, real *x,
                 real *t)
{
    cardan_sparse_solve(mesh->plan, &system->factors, 1, b, x);
    cardan_sparse_multiply(mesh->plan, system->a, x, t);
    cardan_sparse_solve(mesh->plan, &system->factors, 1, t, x);
}

/* Whether a correction d of x by its residual r (n), whose largest number is `error` of what it
 * consists of, takes nothing of it, and all that is left is in rows of constraints: redundant ones
 * that close loops and ask for something else, while speeds and multipliers are as good as they
 * get. t: room (n). */
static int fits(const cardan_mesh *mesh, const cardan_mesh_system *system, const real *r,
                const real *d, real error, real *t)
{
    real left = 0, taken = 0, forces = 0;

    for (int32_t w = 0; w < system->factors.weak; w++)
        if (mesh->plan->multiplier[system->factors.replaced[w]] == 1)
            return 0;
    /* of numbers that are none no maximum would tell */
    if (cardan_not_finite(d, mesh->plan->n) >= 0)
        return 0;
    cardan_sparse_multiply(mesh->plan, system->a, d, t);
    for (ptrdiff_t i = 0; i < mesh->plan->n; i++) {
        left = cardan_worst(left, fabs(system->rows[i] * r[i]));
        taken = fmax(taken, fabs(system->rows[i] * t[i]));
        if (i < mesh->nu)
            forces = fmax(forces, fabs(system->rows[i] * r[i]));
    }
    return taken <= REDUNDANT * left && forces * error <= FORCES * left;
}

/* What rows of constraints miss in r (n), of the motion x, of what the right-hand side asks for and of
 * the motion that its forces alone would cause: beside the forces themselves it may look like rounding. */
static real left_of_rows(const cardan_mesh *mesh, const cardan_mesh_system *system, const real *x,
                         const real *r)
{
    real left = 0, required = 0, moved = 0;

    for (ptrdiff_t i = 0; i < mesh->plan->n; i++) {
        required = fmax(required, fabs(system->rows[i] * system->right[i]));
        if (i < mesh->nu)
            moved = fmax(moved, fabs(x[i] / system->units[i]));
        else
            left = cardan_worst(left, fabs(system->rows[i] * r[i]));
    }
    return left > 0 ? left / fmax(moved + required, CARDAN_LEAST) : 0;
}

/* Solve where pivots were lost, and improve that until rounding, or what cannot fit, is all there is.
 * Rows that close loops gave way in the factors: each correction makes up for most of that. */
static int solve_weak(const cardan_mesh *mesh, cardan_mesh_system *system)
{
    const ptrdiff_t n = mesh->plan->n;
    real *x = system->solution, *r = system->work, *d = r + n, *t = d + n;
    real before = INFINITY, error = INFINITY;

    pass(mesh, system, system->right, x, t);
    /* what is judged is what is given: the last correction is measured too */
    for (int step = 0; step <= AT_MOST; step++) {
        const real last = error;
        real most;
        error = cardan_sparse_residual(mesh->plan, &system->factors, system->a, system->right, x, r);
        if (!(error < INFINITY))
            return CARDAN_UNSOLVED;
        system->unfit = left_of_rows(mesh, system, x, r);
        most = fmax(error, system->unfit);
        if (most <= ENOUGH)
            break;
        pass(mesh, system, r, d, t);
        if (fits(mesh, system, r, d, error, t))
            return 0;
        /* what redundant rows miss may rise while all else becomes better */
        if ((step >= IMPROVE || !(most < before)) && !(error > GOOD && error < last))
            break;
        if (step == AT_MOST)
            break;
        before = most;
        for (ptrdiff_t i = 0; i < n; i++)
            x[i] += d[i];
    }
    system->unsettled = system->unfit > CONSISTENT;
    return error <= GOOD && cardan_not_finite(x, n) < 0 ? 0 : CARDAN_UNSOLVED;
}

int cardan_mesh_solve(const cardan_mesh *mesh, cardan_mesh_system *system)
{
    const cardan_sparse *plan = mesh->plan;
    const cardan_sparse_factors *factors = &system->factors;
    real *x = system->solution, *room = system->work, error;

    system->unfit = 0;
    system->unsettled = 0;
    if (factors->weak > 0)
        return solve_weak(mesh, system);
    /* pivots are looked for inside of a supernode alone: where factors have grown, no bound tells */
    if (!factors->certainty)
        cardan_sparse_solve(plan, factors, 1, system->right, x);
    else if (cardan_sparse_solve_certain(plan, factors, system->right, x) <= GOOD)
        return 0;
    error = cardan_sparse_residual(plan, factors, system->a, system->right, x, room);
    if (error > GOOD && error < INFINITY)
        error = cardan_sparse_refine(plan, factors, system->a, system->right, GOOD, IMPROVE, x, room);
    return error <= GOOD ? 0 : CARDAN_UNSOLVED;
}
