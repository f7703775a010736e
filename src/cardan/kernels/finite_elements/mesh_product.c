/* Products with derivatives of the functions of a mesh: see mesh_product.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_pull.h"
#include <string.h>

void cardan_mesh_product_starts(const cardan_mesh_product *product, ptrdiff_t *starts)
{
    const cardan_mesh *mesh = product->mesh;
    const ptrdiff_t sizes[] = {1,        mesh->nu, mesh->nq,    mesh->nu, mesh->nz,
                               mesh->ns, mesh->nr, product->np, mesh->nu, mesh->nu};
    ptrdiff_t start = 0;

    for (int k = 0; k < 10; start += sizes[k++])
        starts[k] = start;
}

ptrdiff_t cardan_mesh_product_work(const cardan_mesh_product *product)
{
    cardan_place here;

    return cardan_mesh_lay_place(product, NULL, &here);
}

/* The outputs at a state, which a formula reads. */
static int enter_outputs(const cardan_in *in, real *work, cardan_place *here)
{
    cardan_in of_mesh = *in;

    of_mesh.w = (const wreal *)(const void *)here->mesh;
    return here->mesh->outputs > 0 ? cardan_mesh_call_outputs(&of_mesh, here->direct, work) : 0;
}

int cardan_mesh_enter(const cardan_in *in, real *work, cardan_place *here)
{
    const cardan_mesh_product *product = (const cardan_mesh_product *)(const void *)in->w;
    const cardan_mesh *mesh = product->mesh;
    const ptrdiff_t function = product->function;
    real *solution = work + cardan_mesh_call_work(mesh), *missing;
    int status = 0;

    memset(here, 0, sizeof *here);
    here->product = product;
    here->mesh = mesh;
    here->at = cardan_state_of(in);
    (void)cardan_mesh_lay_place(product, work, here);
    /* before anything is factored in the same memory */
    if (function == CARDAN_OF_EXPRESSION)
        status = enter_outputs(in, work, here);
    if (status != 0)
        return status;
    if (product->solved) {
        status = cardan_mesh_solve_motion(mesh, &here->at, in->tau, solution, work, &here->system);
        here->at.udot = solution;
        here->at.lam = solution + mesh->nu;
    }
    if (function == CARDAN_OF_EVENTS || function == CARDAN_OF_TRANSITION)
        status = cardan_mesh_enter_event(in, solution, work, here);
    if (mesh->frictions > 0)
        (void)cardan_mesh_friction_lay(mesh, cardan_mesh_certainty(mesh, work), &here->friction);
    /* projections are differentiated at their factors, as if all gaps were closed */
    if (function == CARDAN_OF_CLOSE_POSITION || function == CARDAN_OF_CLOSE_VELOCITY) {
        missing = work + cardan_mesh_lay(mesh, work, &here->system);
        status = cardan_mesh_balance(mesh, &here->at, missing, here->system.work);
        here->system.open = missing + mesh->nu;
        if (status == 0)
            status = cardan_mesh_closing_factor(mesh, &here->at, NULL, 1, &here->system);
    }
    return status;
}

/* The gradient of the k-th result. */
static int row(cardan_place *here, ptrdiff_t k)
{
    for (ptrdiff_t i = 0; i < here->product->results; i++)
        here->unit[i] = i == k;
    return cardan_mesh_pull(here, here->unit);
}

int cardan_mesh_call_expression(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh_product *product = (const cardan_mesh_product *)(const void *)in->w;
    cardan_place here = {0};
    cardan_in formula;
    int status;

    here.product = product;
    here.mesh = product->mesh;
    here.at = cardan_state_of(in);
    (void)cardan_mesh_lay_place(product, work, &here);
    status = enter_outputs(in, work, &here);
    formula = cardan_formula_in(&here, product->formula);
    return status != 0 ? status : product->formula->call(&formula, out, here.room);
}

/* The product with weights v at a state. */
static int pull(cardan_place *here, const real *v, real *out)
{
    const int status = cardan_mesh_pull(here, v);

    for (ptrdiff_t i = 0; i < here->product->columns; i++)
        out[i] = here->by.t[here->product->column[i]];
    return status;
}

int cardan_mesh_call_vjp(const cardan_in *in, real *out, real *work)
{
    cardan_place here;
    const int status = cardan_mesh_enter(in, work, &here);

    return status != 0 ? status : pull(&here, in->v, out);
}

int cardan_mesh_call_jvp(const cardan_in *in, real *out, real *work)
{
    cardan_place here;
    const int status = cardan_mesh_enter(in, work, &here);

    return status != 0 ? status : cardan_mesh_push(&here, in->v, out);
}

/* numbers that a place takes at the start of its room; behind them are the inputs, then the work */
enum { PLACE = (sizeof(cardan_place) + sizeof(real) - 1) / sizeof(real) };

ptrdiff_t cardan_mesh_room_length(const cardan_mesh_product *product)
{
    return PLACE + product->mesh->nr + cardan_mesh_product_work(product);
}

static int enter_room(const cardan_in *in, real *room)
{
    const cardan_mesh_product *product = (const cardan_mesh_product *)(const void *)in->w;
    cardan_in with_room = *in;

    /* the caller goes on to other times, with inputs in the same place */
    if (product->mesh->nr > 0)
        memcpy(room + PLACE, in->r, (size_t)product->mesh->nr * sizeof(real));
    with_room.r = room + PLACE;
    return cardan_mesh_enter(&with_room, room + PLACE + product->mesh->nr, (cardan_place *)(void *)room);
}

static int pull_again(real *room, const real *v, real *out)
{
    return pull((cardan_place *)(void *)room, v, out);
}

static int push_again(real *room, const real *v, real *out)
{
    return cardan_mesh_push((cardan_place *)(void *)room, v, out);
}

const cardan_repeated cardan_mesh_repeated = {enter_room, pull_again, push_again};

int cardan_mesh_call_derivative(const cardan_in *in, real *out, real *work)
{
    cardan_place here;
    int status = cardan_mesh_enter(in, work, &here);
    const cardan_mesh_product *product = here.product;

    for (ptrdiff_t k = 0; k < product->results && status == 0; k++) {
        status = row(&here, k);
        for (ptrdiff_t n = 0; n < product->parts; n++) {
            const ptrdiff_t first = product->part[n], size = product->part[n + 1] - first;
            real *to = out + product->results * first + k * size;
            for (ptrdiff_t i = 0; i < size; i++)
                to[i] = here.by.t[product->column[first + i]];
        }
    }
    return status;
}

int cardan_mesh_call_columns(const cardan_in *in, real *out, real *work)
{
    cardan_place here;
    int status = cardan_mesh_enter(in, work, &here);
    const cardan_mesh_product *product = here.product;
    real *direction = here.column, *change = direction + product->columns;

    for (ptrdiff_t n = 0; n < product->parts; n++) {
        const ptrdiff_t first = product->part[n], size = product->part[n + 1] - first;
        for (ptrdiff_t i = 0; i < size && status == 0; i++) {
            for (ptrdiff_t k = 0; k < product->columns; k++)
                direction[k] = k == first + i;
            status = cardan_mesh_push(&here, direction, change);
            for (ptrdiff_t k = 0; k < product->results; k++)
                out[product->results * first + k * size + i] = change[k];
        }
    }
    return status;
}
