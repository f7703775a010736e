/* Friction that follows from reactions, solved for together with accelerations.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A friction D = c |F| changes all accelerations and multipliers, and with them every force F across
 * the line of a joint: F_i = F_i0 + sum_j F_ij D_j, linear in D. The columns follow from one solution
 * with the same factors for every friction; D by Newton steps from D = 0. Where sum_j c_i |F_ij| < 1
 * for all i it is the only solution.
 * Source: F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapter 5;
 * P. Painlevé, C. R. Acad. Sci. Paris 121 (1895) 112.
 */
#include "mesh_friction.h"
#include "linear.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

/* of Newton: each doubles the digits, the first has one */
enum { STEPS = 6 };

ptrdiff_t cardan_mesh_friction_lay(const cardan_mesh *mesh, real *block, cardan_mesh_friction *to)
{
    const ptrdiff_t k = mesh->frictions;
    ptrdiff_t used = 0;

    to->certainty = cardan_reserve(block, &used, k);
    to->value = cardan_reserve(block, &used, k);
    to->coefficient = cardan_reserve(block, &used, k);
    to->along = cardan_reserve(block, &used, k * mesh->nu);
    to->normal = cardan_reserve(block, &used, 3 * k * mesh->m);
    to->moved = cardan_reserve(block, &used, k * (mesh->nu + mesh->m));
    to->start = cardan_reserve(block, &used, 3 * k);
    to->share = cardan_reserve(block, &used, 3 * k * k);
    to->matrix = cardan_reserve(block, &used, k * k);
    to->step = cardan_reserve(block, &used, k);
    to->order = cardan_reserve(block, &used, k);
    return used;
}

static void take_friction(const cardan_mesh *mesh, const cardan_group *g,
                          const cardan_element_lanes *some, real *out, void *to)
{
    const cardan_mesh_friction *all = to;
    const ptrdiff_t lanes = some->lanes, k = g->frictions;
    ptrdiff_t first = 0;

    for (const cardan_group *other = mesh->groups; other != g; other++)
        first += other->count * other->frictions;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const ptrdiff_t *place = g->place + some->element[lane] * g->places;
        const ptrdiff_t *rows = g->rows + 2 * some->element[lane];
        const real *from = out + lane + k * lanes;

        for (ptrdiff_t j = 0; j < k; j++) {
            const ptrdiff_t number = first + some->element[lane] * k + j;
            all->coefficient[number] = out[j * lanes + lane];
            for (ptrdiff_t p = 0; p < g->places; p++)
                for (ptrdiff_t i = mesh->u[place[p]]; i < mesh->u[place[p] + 1]; i++, from += lanes)
                    all->along[number * mesh->nu + i] += *from;
        }
        for (ptrdiff_t j = 0; j < 3 * k; j++) {
            real *normal = all->normal + (3 * (first + some->element[lane] * k) + j) * mesh->m;
            for (ptrdiff_t i = 0; i < g->m; i++, from += lanes)
                normal[i < g->mp ? rows[0] + i : rows[1] + i - g->mp] = *from;
        }
    }
}

/* The forces across the lines of all joints (frictions, 3) by multipliers. */
static void normals(const cardan_mesh *mesh, const cardan_mesh_friction *all, const real *lam, real *to)
{
    for (ptrdiff_t i = 0; i < 3 * mesh->frictions; i++)
        to[i] = cardan_dot(all->normal + i * mesh->m, lam, mesh->m);
}

/* Accelerations and multipliers, and forces across lines, per unit of every friction. */
static int respond(const cardan_mesh *mesh, const cardan_mesh_friction *all, cardan_mesh_system *system)
{
    const ptrdiff_t n = mesh->nu + mesh->m;
    int status = 0;

    for (ptrdiff_t j = 0; j < mesh->frictions && status == 0; j++) {
        real *moved = all->moved + j * n;
        for (ptrdiff_t i = 0; i < mesh->nu; i++)
            system->right[i] = all->along[j * mesh->nu + i];
        for (ptrdiff_t k = 0; k < mesh->m; k++)
            system->right[mesh->unknown[k]] = 0;
        status = cardan_mesh_solve(mesh, system);
        for (ptrdiff_t i = 0; i < mesh->nu; i++)
            moved[i] = system->solution[i];
        for (ptrdiff_t k = 0; k < mesh->m; k++)
            moved[mesh->nu + k] = -system->solution[mesh->unknown[k]];
        normals(mesh, all, moved + mesh->nu, all->share + 3 * mesh->frictions * j);
    }
    return status;
}

/* Force across the line of joint i with all frictions, its direction into `along`; its size. */
static real across(const cardan_mesh *mesh, const cardan_mesh_friction *all, ptrdiff_t i, real *along)
{
    real size;

    for (ptrdiff_t x = 0; x < 3; x++) {
        along[x] = all->start[3 * i + x];
        for (ptrdiff_t j = 0; j < mesh->frictions; j++)
            along[x] += all->share[3 * (mesh->frictions * j + i) + x] * all->value[j];
    }
    size = sqrt(cardan_dot(along, along, 3));
    for (ptrdiff_t x = 0; x < 3; x++)
        along[x] = size > 0 ? along[x] / size : 0;
    return size;
}

/* D from D = c |F(D)|, and how certain each is. */
static int balance(const cardan_mesh *mesh, const cardan_mesh_friction *all)
{
    const ptrdiff_t k = mesh->frictions;

    memset(all->value, 0, (size_t)k * sizeof(real));
    for (int step = 0; step < STEPS; step++) {
        for (ptrdiff_t i = 0; i < k; i++) {
            const real c = all->coefficient[i];
            real along[3];

            all->step[i] = c * across(mesh, all, i, along) - all->value[i];
            for (ptrdiff_t j = 0; j < k; j++)
                all->matrix[i * k + j] = (i == j) - c * cardan_dot(along, all->share + 3 * (k * j + i), 3);
        }
        if (cardan_factor(k, all->matrix, all->order) != 0)
            return CARDAN_UNSOLVED;
        cardan_substitute(k, all->matrix, all->order, all->step);
        for (ptrdiff_t i = 0; i < k; i++)
            all->value[i] += all->step[i];
    }
    for (ptrdiff_t i = 0; i < k; i++) {
        all->certainty[i] = 1;
        for (ptrdiff_t j = 0; j < k; j++) {
            const real *share = all->share + 3 * (k * j + i);
            all->certainty[i] -= all->coefficient[i] * sqrt(cardan_dot(share, share, 3));
        }
    }
    return 0;
}

int cardan_mesh_with_friction(const cardan_mesh *mesh, const cardan_state *at,
                              cardan_mesh_system *system, const cardan_mesh_friction *all, real *out)
{
    const ptrdiff_t k = mesh->frictions, n = mesh->nu + mesh->m;
    int status;

    memset(all->along, 0, (size_t)(k * mesh->nu) * sizeof(real));
    memset(all->normal, 0, (size_t)(3 * k * mesh->m) * sizeof(real));
    status = cardan_mesh_each(mesh, at, CARDAN_REACTION_FRICTION, take_friction, (void *)(uintptr_t)all,
                              system->work);
    normals(mesh, all, out + mesh->nu, all->start);
    if (status == 0)
        status = respond(mesh, all, system);
    if (status == 0)
        status = balance(mesh, all);
    for (ptrdiff_t j = 0; j < k && status == 0; j++)
        for (ptrdiff_t i = 0; i < n; i++)
            out[i] += all->value[j] * all->moved[j * n + i];
    return status;
}

/* The matrix 1 - S, or its transposed, factored: S_ij = change of friction i by a unit of friction j. */
static int feedback(const cardan_mesh *mesh, const cardan_mesh_friction *all, int transposed)
{
    const ptrdiff_t k = mesh->frictions;

    for (ptrdiff_t i = 0; i < k; i++) {
        real along[3];
        (void)across(mesh, all, i, along);
        for (ptrdiff_t j = 0; j < k; j++)
            all->matrix[transposed ? j * k + i : i * k + j] =
                (i == j) - all->coefficient[i] * cardan_dot(along, all->share + 3 * (k * j + i), 3);
    }
    return cardan_factor(k, all->matrix, all->order) == 0 ? 0 : CARDAN_UNSOLVED;
}

/* Change of friction i by multipliers: normal_i (3, m) along the force across its line, times c. */
static real by_multiplier(const cardan_mesh *mesh, const cardan_mesh_friction *all, ptrdiff_t i,
                          const real *along, ptrdiff_t k)
{
    real sum = 0;

    for (ptrdiff_t x = 0; x < 3; x++)
        sum += along[x] * all->normal[(3 * i + x) * mesh->m + k];
    return all->coefficient[i] * sum;
}

/* (A - a v^T) y = right: first as if there were no friction, which changes by what that does. */
static int solve_with(const cardan_mesh *mesh, cardan_mesh_system *system, const cardan_mesh_friction *all)
{
    const ptrdiff_t n = mesh->nu + mesh->m;
    int status = feedback(mesh, all, 0);

    if (status == 0)
        status = cardan_mesh_solve(mesh, system);
    for (ptrdiff_t i = 0; i < mesh->frictions; i++) {
        real along[3];
        (void)across(mesh, all, i, along);
        all->step[i] = 0;
        for (ptrdiff_t k = 0; k < mesh->m; k++)
            all->step[i] -= by_multiplier(mesh, all, i, along, k) * system->solution[mesh->unknown[k]];
    }
    if (status != 0)
        return status;
    cardan_substitute(mesh->frictions, all->matrix, all->order, all->step);
    for (ptrdiff_t j = 0; j < mesh->frictions; j++) {
        const real *moved = all->moved + j * n;
        for (ptrdiff_t i = 0; i < mesh->nu; i++)
            system->solution[i] += all->step[j] * moved[i];
        for (ptrdiff_t k = 0; k < mesh->m; k++)
            system->solution[mesh->unknown[k]] -= all->step[j] * moved[mesh->nu + k];
    }
    return 0;
}

/* (A - v a^T) y = right: the sums a^T y of what friction pushes along, then the system with them. */
static int solve_transposed(const cardan_mesh *mesh, cardan_mesh_system *system,
                            const cardan_mesh_friction *all)
{
    int status = feedback(mesh, all, 1);

    if (status == 0)
        status = cardan_mesh_solve(mesh, system);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < mesh->frictions; i++)
        all->step[i] = cardan_dot(all->along + i * mesh->nu, system->solution, mesh->nu);
    cardan_substitute(mesh->frictions, all->matrix, all->order, all->step);
    for (ptrdiff_t i = 0; i < mesh->frictions; i++) {
        real along[3];
        (void)across(mesh, all, i, along);
        for (ptrdiff_t k = 0; k < mesh->m; k++)
            system->right[mesh->unknown[k]] -= all->step[i] * by_multiplier(mesh, all, i, along, k);
    }
    return cardan_mesh_solve(mesh, system);
}

int cardan_mesh_friction_solve(const cardan_mesh *mesh, cardan_mesh_system *system,
                               const cardan_mesh_friction *all, int transposed)
{
    return transposed ? solve_transposed(mesh, system, all) : solve_with(mesh, system, all);
}
