/* Systems of equations with the matrices of a mesh.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_matrix.h"
#include <math.h>

/* backward error of a solution that is enough, and how often one is improved */
static const real ENOUGH = 1e-13;
/* what resists a speed, of what resists most: below that it is rounding */
static const real ROUNDING = 1e-14;
enum { IMPROVE = 4 };

static real *piece(real *block, ptrdiff_t *used, ptrdiff_t size)
{
    real *start = block ? block + *used : block;

    *used += size;
    return start;
}

ptrdiff_t cardan_mesh_lay(const cardan_mesh *mesh, real *block, cardan_mesh_system *system)
{
    const cardan_sparse *plan = mesh->plan;
    const ptrdiff_t n = plan->n;
    cardan_sparse_factors *factors = &system->factors;
    ptrdiff_t used = 0;

    system->right = piece(block, &used, n);
    system->found = piece(block, &used, n);
    system->rows = piece(block, &used, n);
    system->units = piece(block, &used, n);
    system->a = piece(block, &used, plan->values);
    factors->values = piece(block, &used, plan->factors);
    factors->scale = piece(block, &used, n);
    factors->shift = piece(block, &used, n);
    factors->work = piece(block, &used, cardan_sparse_work(plan));
    factors->pivot = (int32_t *)(void *)piece(block, &used, n);
    factors->replaced = (int32_t *)(void *)piece(block, &used, n);
    factors->rows = system->rows;
    factors->columns = system->units;
    system->work = piece(block, &used, 2 * n + cardan_mesh_room(mesh));
    return used;
}

/* Units: the root of the inverse of what resists a speed; rows in those of the least of it.
 *
 * What nothing resists, or rounding, counts like the least that does.
 */
static void weigh(const cardan_mesh *mesh, cardan_mesh_system *system)
{
    real largest = 0, least = INFINITY;

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        largest = fmax(largest, fabs(system->a[mesh->diagonal[i]]));
    for (ptrdiff_t i = 0; i < mesh->nu; i++) {
        const real own = fabs(system->a[mesh->diagonal[i]]);
        if (own > ROUNDING * largest)
            least = fmin(least, own);
    }
    if (!(least < INFINITY))
        least = 1;
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->rows[i] = system->units[i] =
            1 / sqrt(fmax(least, fabs(system->a[mesh->diagonal[i]])));
    for (ptrdiff_t k = mesh->nu; k < mesh->plan->n; k++)
        system->rows[k] = system->units[k] = sqrt(least);
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
    return cardan_sparse_factor(mesh->plan, system->a, &system->factors) == 0 ? 0
                                                                             : CARDAN_UNSOLVED;
}

int cardan_mesh_massless(const cardan_mesh *mesh, const cardan_mesh_system *system)
{
    const cardan_sparse_factors *factors = &system->factors;

    if (factors->weak == 0)
        return 0;
    return cardan_sparse_loose(mesh->plan, factors, system->found) < 0 ? 0 : CARDAN_SINGULAR;
}

int cardan_mesh_solve(const cardan_mesh *mesh, const cardan_mesh_system *system)
{
    const cardan_sparse *plan = mesh->plan;
    const cardan_sparse_factors *factors = &system->factors;

    cardan_sparse_solve(plan, factors, 1, system->right, system->found);
    if (factors->weak > 0)
        (void)cardan_sparse_refine(plan, factors, system->a, system->right, ENOUGH, IMPROVE,
                                   system->found, system->work);
    return cardan_not_finite(system->found, plan->n) >= 0 ? CARDAN_UNSOLVED : 0;
}
