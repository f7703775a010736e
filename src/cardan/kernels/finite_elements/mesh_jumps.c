/* Impulses at events of a mesh, through the whole of it.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Impulses P along velocities J u: M du = Jᵀ P + Gᵀ P', G du = 0, J (u + du) as the events ask, without
 * the rows that modes hold: elements say themselves what these bear. With the columns of X = A⁻¹ Jᵀ, A
 * of masses and constraints, J X P = -missing.
 * Source: F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapter 8.
 */
#include "mesh_jumps.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

/* how often impulses that would pull are left out before the rest is taken as it is */
enum { PASSES = 3 };
/* what is left of the response of an impulse beside others where it follows from them */
static const real DEPENDENT = 1e-10;
/* response of a velocity that constraints hold, of that of its speeds one by one: rounding */
static const real IMMOBILE = 1e-12;

ptrdiff_t cardan_mesh_jumps_lay(const cardan_mesh *mesh, real *block, cardan_mesh_jumps *to)
{
    const ptrdiff_t k = mesh->jumps;
    ptrdiff_t used = 0;

    to->rows = cardan_reserve(block, &used, CARDAN_JUMP_ROW * k);
    to->J = cardan_reserve(block, &used, k * mesh->nu);
    to->X = cardan_reserve(block, &used, k * mesh->nu);
    to->R = cardan_reserve(block, &used, k * k);
    to->left = cardan_reserve(block, &used, k * k);
    to->P = cardan_reserve(block, &used, k);
    to->right = cardan_reserve(block, &used, k);
    to->behind = cardan_reserve(block, &used, mesh->nu);
    to->responses = cardan_reserve(block, &used, mesh->responses);
    return used;
}

ptrdiff_t cardan_mesh_jump_room(const cardan_mesh *mesh)
{
    cardan_mesh_jumps none;

    return mesh->ne > 0 ? cardan_mesh_jumps_lay(mesh, NULL, &none) : 0;
}

ptrdiff_t cardan_mesh_first_number(const cardan_mesh *mesh, const cardan_group *g, size_t field)
{
    ptrdiff_t first = 0;

    for (const cardan_group *other = mesh->groups; other != g; other++)
        first += other->count * *(const ptrdiff_t *)(const void *)((const char *)other + field);
    return first;
}

static void take_jumps(const cardan_mesh *mesh, const cardan_group *g,
                       const cardan_element_lanes *some, real *out, void *to)
{
    const cardan_mesh_jumps *all = to;
    const ptrdiff_t lanes = some->lanes, first = CARDAN_FIRST(mesh, g, jumps);

    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        for (ptrdiff_t j = 0; j < g->jumps; j++) {
            const ptrdiff_t number = first + some->element[lane] * g->jumps + j;
            const ptrdiff_t *place = g->place + some->element[lane] * g->places;
            const real *gradient = out + (CARDAN_JUMP_ROW * g->jumps + j * g->nu) * lanes + lane;
            for (ptrdiff_t i = 0; i < CARDAN_JUMP_ROW; i++)
                all->rows[CARDAN_JUMP_ROW * number + i] = out[(CARDAN_JUMP_ROW * j + i) * lanes + lane];
            for (ptrdiff_t k = 0; k < g->places; k++)
                for (ptrdiff_t i = mesh->u[place[k]]; i < mesh->u[place[k] + 1]; i++) {
                    all->J[number * mesh->nu + i] += *gradient;
                    gradient += lanes;
                }
        }
}

/* Masses and constraints at a state, factored; `released`: modes hold nothing. */
static int factored(const cardan_mesh *mesh, const cardan_state *at, int released,
                    cardan_mesh_system *system, real *work)
{
    const cardan_assembly parts = {{0, 0, 1}, 0, 0, NULL, released};
    real *missing = work + cardan_mesh_lay(mesh, work, system);
    cardan_state still = *at;
    int assembled, status;

    /* impulses make no friction */
    still.lam = NULL;
    status = cardan_mesh_balance(mesh, &still, missing, system->work);
    system->open = missing + mesh->nu;
    return status != 0 ? status : cardan_mesh_factor(mesh, &still, &parts, system, &assembled);
}

/* Speeds x (nu) by an impulse along a velocity. */
static int responds(const cardan_mesh *mesh, cardan_mesh_system *system, const real *velocity, real *x)
{
    int status;

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = velocity[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = 0;
    status = cardan_mesh_solve(mesh, system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        x[i] = system->solution[i];
    return status;
}

/* What elements asked for: responses with all that modes hold. */
static int respond(const cardan_mesh *mesh, const cardan_state *at, const cardan_mesh_jumps *all, real *work)
{
    cardan_mesh_system system = {0};
    real *to = all->responses;
    int status = mesh->responses > 0 ? factored(mesh, at, 0, &system, work) : 0;

    /* as many as the tables have room for, whatever functions ask for */
    for (ptrdiff_t j = 0; j < mesh->jumps && status == 0 && to < all->responses + mesh->responses; j++) {
        const real *velocity = all->J + j * mesh->nu;
        if ((int)all->rows[CARDAN_JUMP_ROW * j + CARDAN_JUMP_KIND] != CARDAN_RESPONSE)
            continue;
        status = responds(mesh, &system, velocity, all->behind);
        *to++ = cardan_dot(velocity, all->behind, mesh->nu);
    }
    return status;
}

void cardan_mesh_among_impulses(const cardan_mesh_jumps *all, ptrdiff_t n, real *right, real *x)
{
    real *a = all->left;

    for (ptrdiff_t i = 0; i < n; i++) {
        x[i] = 0;
        for (ptrdiff_t j = 0; j < n; j++)
            a[i * n + j] = all->R[i * n + j];
    }
    /* R is symmetric and not negative: by its pivots, the largest of what it was first */
    for (ptrdiff_t step = 0; step < n; step++) {
        ptrdiff_t pivot = -1;
        real best = DEPENDENT;
        for (ptrdiff_t i = 0; i < n; i++) {
            const real share = a[i * n + i] / all->R[i * n + i];
            if (all->rows[CARDAN_JUMP_ROW * i + CARDAN_JUMP_ACTIVE] != 0 && x[i] == 0 && share > best)
                best = share, pivot = i;
        }
        if (pivot < 0)
            break;
        x[pivot] = 1; /* it is one of them */
        for (ptrdiff_t i = 0; i < n; i++) {
            const real factor = i == pivot ? 0 : a[i * n + pivot] / a[pivot * n + pivot];
            for (ptrdiff_t j = 0; j < n && factor != 0; j++)
                a[i * n + j] -= factor * a[pivot * n + j];
            right[i] -= factor * right[pivot];
        }
    }
    for (ptrdiff_t i = 0; i < n; i++)
        x[i] = x[i] != 0 ? right[i] / a[i * n + i] : 0;
}

/* The impulses that give velocities what they miss. */
static void eliminate(const cardan_mesh_jumps *all, ptrdiff_t n)
{
    for (ptrdiff_t i = 0; i < n; i++)
        all->right[i] = -all->rows[CARDAN_JUMP_ROW * i + CARDAN_JUMP_MISSING];
    cardan_mesh_among_impulses(all, n, all->right, all->P);
}

/* Leave out impulses along velocities that constraints hold: nothing answers them. */
static void leave_immobile(const cardan_mesh *mesh, const cardan_mesh_system *system, const cardan_mesh_jumps *all)
{
    for (ptrdiff_t i = 0; i < mesh->jumps; i++) {
        real alone = 0;
        for (ptrdiff_t k = 0; k < mesh->nu; k++)
            alone += pow(all->J[i * mesh->nu + k] * system->units[k], 2);
        if (!(all->R[i * mesh->jumps + i] > IMMOBILE * alone))
            all->rows[CARDAN_JUMP_ROW * i + CARDAN_JUMP_ACTIVE] = 0;
    }
}

/* Leave out impulses that would pull where they can only push. */
static void leave_out(const cardan_mesh_jumps *all, ptrdiff_t n, ptrdiff_t unilateral)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        real *row = all->rows + CARDAN_JUMP_ROW * i, release = 0;
        const int kind = (int)row[CARDAN_JUMP_KIND];
        if (row[CARDAN_JUMP_ACTIVE] == 0 || (kind != CARDAN_UNILATERAL && kind != CARDAN_SLOW_RELEASE))
            continue;
        /* against the impulse that gives it that speed where nothing else holds it */
        if (kind == CARDAN_SLOW_RELEASE && unilateral > 1)
            release = row[CARDAN_JUMP_RELEASE] / all->R[i * n + i];
        if (!(-all->P[i] <= release))
            row[CARDAN_JUMP_ACTIVE] = 0;
    }
}

int cardan_mesh_any_impulse(const cardan_mesh *mesh, const cardan_mesh_jumps *all)
{
    int any = 0;

    for (ptrdiff_t i = 0; i < mesh->jumps; i++)
        any |= all->rows[CARDAN_JUMP_ROW * i + CARDAN_JUMP_ACTIVE] != 0;
    return any;
}

/* Speeds behind all impulses. */
static int jump(const cardan_mesh *mesh, const cardan_state *at, const cardan_mesh_jumps *all,
                cardan_mesh_system *released, real *work)
{
    const ptrdiff_t n = mesh->jumps;
    ptrdiff_t unilateral = 0;
    int status;

    for (ptrdiff_t i = 0; i < n; i++) {
        const int kind = (int)all->rows[CARDAN_JUMP_ROW * i + CARDAN_JUMP_KIND];
        unilateral += kind == CARDAN_UNILATERAL || kind == CARDAN_SLOW_RELEASE;
    }
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        all->behind[i] = at->u[i];
    if (!cardan_mesh_any_impulse(mesh, all))
        return 0;
    /* speeds by an impulse along every velocity, and how each answers the others */
    status = factored(mesh, at, 1, released, work);
    for (ptrdiff_t i = 0; i < n && status == 0; i++)
        status = responds(mesh, released, all->J + i * mesh->nu, all->X + i * mesh->nu);
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t j = 0; j < n; j++)
            all->R[i * n + j] = cardan_dot(all->J + i * mesh->nu, all->X + j * mesh->nu, mesh->nu);
    leave_immobile(mesh, released, all);
    /* as often as some would pull */
    for (ptrdiff_t attempt = 0; attempt == 0 || (attempt <= PASSES && attempt < unilateral); attempt++) {
        if (attempt > 0)
            leave_out(all, n, unilateral);
        eliminate(all, n);
    }
    for (ptrdiff_t j = 0; j < n; j++)
        for (ptrdiff_t i = 0; i < mesh->nu; i++)
            all->behind[i] += all->P[j] * all->X[j * mesh->nu + i];
    return status;
}

int cardan_mesh_jump(const cardan_mesh *mesh, const cardan_state *at, const cardan_mesh_jumps *all,
                     cardan_mesh_system *released, real *work)
{
    cardan_state before = *at;
    int status;

    before.behind = at->u;
    before.responses = all->responses;
    memset(all->rows, 0, (size_t)cardan_mesh_jump_room(mesh) * sizeof(real));
    status = cardan_mesh_each(mesh, &before, CARDAN_JUMPS, take_jumps, (void *)(uintptr_t)all, work);
    if (status == 0)
        status = respond(mesh, &before, all, work);
    return status == 0 ? jump(mesh, &before, all, released, work) : status;
}
