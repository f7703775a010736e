/* Where the generalized-alpha method keeps what in `own` of the run. Part of cardan. */
#include "alpha.h"

/* Point into the memory of a run. Returns how many numbers that takes. */
static ptrdiff_t lay(const cardan_run *run, cardan_alpha *v)
{
    const ptrdiff_t nq = run->nq, nu = run->nu, mp = run->positions, m = run->rates;
    const ptrdiff_t size = nu + mp + m;
    real *own = run->own;
    ptrdiff_t used = 0;

    v->nq = nq, v->nu = nu, v->mp = mp, v->m = m, v->size = size;
    /* rows read them at the start of `own` */
    v->lam_old = cardan_reserve(own, &used, m);
    v->lam = cardan_reserve(own, &used, m);
    v->now = cardan_reserve(own, &used, ALPHA_NOW);
    v->a = cardan_reserve(own, &used, nu);
    v->udot = cardan_reserve(own, &used, nu);
    v->rise = cardan_reserve(own, &used, nu);
    v->amplitude = cardan_reserve(own, &used, nq);
    v->picked = cardan_reserve(own, &used, m);
    v->a_new = cardan_reserve(own, &used, nu);
    v->udot_new = cardan_reserve(own, &used, nu);
    v->lam_new = cardan_reserve(own, &used, m);
    v->shift = cardan_reserve(own, &used, nu);
    v->increment = cardan_reserve(own, &used, nu);
    v->residual = cardan_reserve(own, &used, nu + mp + m);
    v->rates = cardan_reserve(own, &used, nq);
    v->dx = cardan_reserve(own, &used, nu);
    v->mesh = run->mesh;
    if (v->mesh)
        return used + cardan_alpha_sparse_lay(v->mesh, own ? own + used : own, v);
    v->moved = cardan_reserve(own, &used, nq + nu * nu);
    v->tangent = cardan_reserve(own, &used, 3 * nu * nu + 2 * m * nu);
    v->weight = cardan_reserve(own, &used, nu);
    v->unit = cardan_reserve(own, &used, m);
    v->matrix = cardan_reserve(own, &used, size * size);
    v->order = cardan_reserve(own, &used, size);
    v->right = cardan_reserve(own, &used, size);
    v->room = cardan_reserve(own, &used, size * nu);
    v->probe = cardan_reserve(own, &used, nu + 2 * size + nq + nu * nu);
    return used;
}

/* The method with its coefficients.
 *
 * Without options: those of Chung and Hulbert for rho_inf = 0.8, stabilized index 2, modified
 * Newton steps, adaptive.
 */
static cardan_alpha method_of(const cardan_run *run)
{
    static const real usual[7] = {1.0 / 3, 4.0 / 9, 100.0 / 324, 11.0 / 18, 2, 0, 1};
    const real *options = run->options ? run->options : usual;
    cardan_alpha v = {0};

    v.am = options[0];
    v.af = options[1];
    v.beta = options[2];
    v.gamma = options[3];
    v.index = (ptrdiff_t)options[4];
    v.full = (ptrdiff_t)options[5];
    v.adaptive = (ptrdiff_t)options[6];
    return v;
}

/* The same over the memory of a run. */
cardan_alpha cardan_alpha_at(const cardan_run *run)
{
    cardan_alpha v = method_of(run);

    (void)lay(run, &v);
    return v;
}

ptrdiff_t cardan_alpha_length(const cardan_run *run)
{
    cardan_run measured = *run;
    cardan_alpha v = method_of(run);

    measured.own = NULL;
    return lay(&measured, &v);
}

/* Whether the exchanges of rows in memory are of rows that exist; meshes come from no file. */
int cardan_alpha_sound(const cardan_run *run)
{
    const cardan_alpha v = cardan_alpha_at(run);

    return !v.mesh && cardan_places_fit(v.order, v.size, 0, (real)(v.size - 1));
}
