/* Memory layout of the generalized-alpha method within `method_memory`. Part of cardan. */
#include "alpha.h"
#include "mesh_states.h"

/* Arrays of internal states: those of an element in tables are solved for together, else all. */
static void lay_states(const cardan_run *run, cardan_alpha *v, real *memory, ptrdiff_t *used)
{
    const ptrdiff_t nz = run->nz, most = v->mesh ? cardan_mesh_most_states(v->mesh) : nz;
    const ptrdiff_t block = v->mesh ? cardan_mesh_states_block(v->mesh) : cardan_states_block(nz);

    v->w = cardan_reserve(memory, used, nz);
    v->w_new = cardan_reserve(memory, used, nz);
    v->zdot = cardan_reserve(memory, used, nz);
    v->gap = cardan_reserve(memory, used, nz);
    v->terms = cardan_reserve(memory, used, nz);
    v->slopes = cardan_reserve(memory, used, most * nz);
    v->block = cardan_reserve(memory, used, block);
}

/* Point all arrays into the memory of a run. Returns how many numbers they need. */
static ptrdiff_t lay(const cardan_run *run, cardan_alpha *v)
{
    const ptrdiff_t nq = run->nq, nu = run->nu, mp = run->positions, m = run->rates;
    const ptrdiff_t size = nu + mp + m;
    real *memory = run->method_memory;
    ptrdiff_t used = 0;

    v->nq = nq, v->nu = nu, v->mp = mp, v->m = m, v->size = size;
    /* output rows read the multipliers at the start of `method_memory`, so they come first */
    v->lam_old = cardan_reserve(memory, &used, m);
    v->lam = cardan_reserve(memory, &used, m);
    v->now = cardan_reserve(memory, &used, ALPHA_NOW);
    /* history and trial step, for dense and sparse matrices alike */
    v->a = cardan_reserve(memory, &used, nu);
    v->udot = cardan_reserve(memory, &used, nu);
    v->rise = cardan_reserve(memory, &used, nu);
    v->amplitude = cardan_reserve(memory, &used, run->mesh ? 0 : nq);
    v->picked = cardan_reserve(memory, &used, m);
    v->a_new = cardan_reserve(memory, &used, nu);
    v->udot_new = cardan_reserve(memory, &used, nu);
    v->lam_new = cardan_reserve(memory, &used, m);
    v->shift = cardan_reserve(memory, &used, nu);
    v->closing = cardan_reserve(memory, &used, mp);
    v->increment = cardan_reserve(memory, &used, nu);
    v->residual = cardan_reserve(memory, &used, nu + mp + m);
    v->rates = cardan_reserve(memory, &used, nq);
    v->dx = cardan_reserve(memory, &used, nu);
    v->mesh = run->mesh;
    if (run->nz > 0)
        lay_states(run, v, memory, &used);
    /* a mesh has sparse systems in place of the dense matrices below */
    if (v->mesh)
        return used + cardan_alpha_sparse_lay(v->mesh, memory ? memory + used : memory, v);
    v->moved = cardan_reserve(memory, &used, nq + nu * nu);
    v->tangent = cardan_reserve(memory, &used, 3 * nu * nu + 2 * m * nu);
    v->weight = cardan_reserve(memory, &used, nu);
    v->unit = cardan_reserve(memory, &used, m);
    v->matrix = cardan_reserve(memory, &used, size * size);
    v->order = cardan_reserve(memory, &used, size);
    v->right = cardan_reserve(memory, &used, size);
    v->room = cardan_reserve(memory, &used, size * nu);
    v->probe = cardan_reserve(memory, &used, nu + 2 * size + nq + nu * nu);
    return used;
}

/* Coefficients and options of the method.
 *
 * Chung and Hulbert choose by the spectral radius rho at infinite frequency (default 0.8):
 * am = (2 rho - 1) / (rho + 1), af = rho / (rho + 1), gamma = 1/2 - am + af,
 * beta = (1 - am + af)^2 / 4. HHT has am = 0, Newmark am = af = 0.
 * Other defaults: stabilized index 2, modified Newton, adaptive.
 */
static void set_coefficients(const cardan_run *run, cardan_alpha *v)
{
    static const real usual[7] = {1.0 / 3, 4.0 / 9, 100.0 / 324, 11.0 / 18, 2, 0, 1};
    const real *options = run->options ? run->options : usual;

    v->am = options[0];
    v->af = options[1];
    v->beta = options[2];
    v->gamma = options[3];
    v->index = (ptrdiff_t)options[4];
    v->full = (ptrdiff_t)options[5];
    v->adaptive = (ptrdiff_t)options[6];
}

/* The method with its arrays in the memory of a run. */
cardan_alpha cardan_alpha_at(const cardan_run *run)
{
    cardan_alpha v = {0};

    set_coefficients(run, &v);
    (void)lay(run, &v);
    return v;
}

ptrdiff_t cardan_alpha_length(const cardan_run *run)
{
    cardan_run measured = *run;
    cardan_alpha v = {0};

    set_coefficients(run, &v);
    measured.method_memory = NULL;
    return lay(&measured, &v);
}

/* Whether the stored pivots are valid row indices (memory may come from a file). */
int cardan_alpha_sound(const cardan_run *run)
{
    const cardan_alpha v = cardan_alpha_at(run);

    return v.mesh ? cardan_alpha_sparse_sound(&v)
                  : cardan_places_fit(v.order, v.size, 0, (real)(v.size - 1));
}
