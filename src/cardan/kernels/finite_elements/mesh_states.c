/* Internal states of elements in implicit steps: slopes of their rates by the states of the same
 * element, by differences, and systems with them.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_states.h"
#include <math.h>

ptrdiff_t cardan_mesh_most_states(const cardan_mesh *mesh)
{
    ptrdiff_t most = 0;

    for (ptrdiff_t k = 0; k < mesh->group_count; k++)
        most = mesh->groups[k].z_states > most ? mesh->groups[k].z_states : most;
    return most;
}

ptrdiff_t cardan_mesh_states_block(const cardan_mesh *mesh)
{
    const ptrdiff_t n = 2 * cardan_mesh_most_states(mesh);

    return n * (n + 1);
}

/* Add `share` of its change to the j-th state of every element that has so many. Returns how many. */
static ptrdiff_t shift(const cardan_mesh *mesh, ptrdiff_t j, real share, const real *change, real *z)
{
    ptrdiff_t some = 0;

    for (ptrdiff_t k = 0; k < mesh->group_count; k++) {
        const cardan_group *g = mesh->groups + k;
        for (ptrdiff_t e = 0; e < g->count && j < g->z_states; e++, some++)
            z[g->z[e * g->nz + j]] += share * change[g->z[e * g->nz + j]];
    }
    return some;
}

int cardan_mesh_slopes(const cardan_mesh *mesh, const cardan_state *at, const real *zdot,
                       const real *change, real *z, real *slopes, real *room)
{
    cardan_state trial = *at;
    int status = 0;

    trial.z = z;
    for (ptrdiff_t j = 0; status == 0 && shift(mesh, j, 1, change, z) > 0; j++) {
        status = cardan_mesh_zdot(mesh, &trial, slopes + j * mesh->nz, room);
        (void)shift(mesh, j, -1, change, z);
        for (ptrdiff_t i = 0; i < mesh->nz; i++)
            slopes[j * mesh->nz + i] -= zdot[i];
    }
    return status;
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

void cardan_states_solve(cardan_element_states of, ptrdiff_t nz, real re, real im, const real *change,
                         const real *slopes, real *x, real *y, real *block)
{
    const ptrdiff_t count = of.count, n = y ? 2 * count : count;
    real *a = block, *b = block + n * n;

    for (ptrdiff_t i = 0; i < count; i++) {
        const ptrdiff_t row = cardan_state_index(&of, i);
        b[i] = x[row];
        if (y)
            b[count + i] = y[row];
        for (ptrdiff_t j = 0; j < count; j++) {
            const real slope = slopes[j * nz + row] / change[cardan_state_index(&of, j)];
            a[i * n + j] = (i == j) - re * slope;
            if (y) {
                a[(count + i) * n + count + j] = a[i * n + j];
                a[i * n + count + j] = im * slope;
                a[(count + i) * n + j] = -im * slope;
            }
        }
    }
    eliminate(n, a, b);
    for (ptrdiff_t i = 0; i < count; i++) {
        x[cardan_state_index(&of, i)] = b[i];
        if (y)
            y[cardan_state_index(&of, i)] = b[count + i];
    }
}

void cardan_mesh_states_solve(const cardan_mesh *mesh, real re, real im, const real *change,
                              const real *slopes, real *x, real *y, real *block)
{
    for (ptrdiff_t k = 0; k < mesh->group_count; k++)
        for (ptrdiff_t e = 0; e < mesh->groups[k].count; e++)
            cardan_states_solve(cardan_mesh_states_of(mesh->groups + k, e), mesh->nz, re, im, change,
                                slopes, x, y, block);
}
