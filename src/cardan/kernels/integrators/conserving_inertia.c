/* Masses and momenta of elements in the energy-momentum method. Part of cardan. Caller owns all memory. */
#include "conserving.h"

/* The masses that an element gives to its places. */
static void add_mass(const cardan_conserving *v, const cardan_group *g, ptrdiff_t element,
                     const real *out, ptrdiff_t stride)
{
    const ptrdiff_t *place = g->place + element * g->places;
    ptrdiff_t first = 0;

    out += g->parts[CARDAN_M] * stride;
    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t to = v->mesh->u[place[k]], n = v->mesh->u[place[k] + 1] - to;
        for (ptrdiff_t i = 0; i < n; i++)
            for (ptrdiff_t j = 0; j < n; j++)
                v->mass[v->widest * (to + i) + j]
                    += out[((first + i) * g->nu + first + j) * stride];
        first += n;
    }
}

static void take_mass(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                      real *out, void *to)
{
    const int separate = g->parts[CARDAN_M] >= 0 && !g->forms[CARDAN_GENERALIZED_MOMENTA].call;

    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled && separate; lane++)
        add_mass(to, g, some->element[lane], out + lane, some->lanes);
}

/* Where momenta of elements go, and slopes unless these are NULL. */
typedef struct coupled_momenta {
    real *momenta, *slopes;
} coupled_momenta;

static void take_momenta(const cardan_mesh *mesh, const cardan_group *g,
                         const cardan_element_lanes *some, real *out, void *to)
{
    const coupled_momenta *both = to;

    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const ptrdiff_t *place = g->place + some->element[lane] * g->places;
        const real *from = out + lane;
        for (ptrdiff_t k = 0; k < g->places; k++)
            for (ptrdiff_t i = mesh->u[place[k]]; i < mesh->u[place[k] + 1]; i++) {
                if (both->momenta)
                    both->momenta[i] += *from;
                if (both->slopes)
                    both->slopes[i] += from[g->nu * some->lanes];
                from += some->lanes;
            }
    }
}

/* Momenta of elements whose inertia couples places: those at the start of a step, or at its end and
 * what acts besides as inertia changes. */
int cardan_conserving_coupled(const cardan_run *run, const cardan_conserving *v, int start)
{
    const real *q = run->y, *next = run->trial;
    cardan_state at = cardan_conserving_state(run, run->t, start ? q : next);
    coupled_momenta ends = {start ? v->momenta : v->momenta_new, NULL}, middle = {NULL, v->slopes};
    int status;

    if (!v->coupled)
        return 0;
    for (ptrdiff_t i = 0; i < v->nu; i++)
        ends.momenta[i] = v->slopes[i] = 0;
    at.u = at.udot = at.q + v->nq;
    status = cardan_mesh_each(v->mesh, &at, CARDAN_GENERALIZED_MOMENTA, take_momenta, &ends,
                              v->system.work);
    if (start || status != 0)
        return status;
    cardan_conserving_turn(v, q, q + v->nq, v->speeds_half);
    cardan_conserving_turn(v, next, next + v->nq, v->speeds_half + v->nu);
    at.q = v->half;
    at.u = v->speeds_half;
    at.udot = v->speeds_half + v->nu;
    return cardan_mesh_each(v->mesh, &at, CARDAN_GENERALIZED_MOMENTA, take_momenta, &middle,
                            v->system.work);
}

/* Rows or columns of translations (6, 6) of a matrix from axes of the ground to those of a body. */
static void to_body(const real *R, real *mass, ptrdiff_t along, ptrdiff_t across)
{
    for (ptrdiff_t k = 0; k < 6; k++) {
        real *x = mass + k * across, rotated[3];
        for (int i = 0; i < 3; i++)
            rotated[i] = R[i] * x[3 * along] + R[3 + i] * x[4 * along] + R[6 + i] * x[5 * along];
        for (int i = 0; i < 3; i++)
            x[(3 + i) * along] = rotated[i];
    }
}

/* Masses of all places along their own axes, where they are constant. */
int cardan_conserving_masses(const cardan_run *run, const cardan_conserving *v)
{
    const cardan_mesh *mesh = v->mesh;
    const cardan_state at = cardan_conserving_state(run, run->t, run->y);
    int status;

    cardan_conserving here = *v;
    for (ptrdiff_t i = 0; i < v->widest * v->nu; i++)
        v->mass[i] = 0;
    for (ptrdiff_t place = 0; place < mesh->places; place++)
        v->pose[place] = 0;
    status = cardan_mesh_each(mesh, &at, CARDAN_TANGENT, take_mass, &here, v->system.work);
    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t place = mesh->node[k];
        real R[9];
        cardan_rotation(run->y + mesh->q[place], R);
        to_body(R, v->mass + v->widest * mesh->u[place], 1, v->widest);
        to_body(R, v->mass + v->widest * mesh->u[place], v->widest, 1);
        v->pose[place] = 1;
    }
    return status;
}
