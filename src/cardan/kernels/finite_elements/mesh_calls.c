/* Functions of a whole mesh with the interface of generated ones; `w` is the mesh.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_calls.h"
#include "mesh_friction.h"
#include <math.h>
#include <string.h>

/* what redundant rows may leave: of what gaps of positions and speeds explain; whatever these are */
static const real EXPLAINED = 100, GOOD = 1e-10;
/* what rows that close loops give way at least, of their size */
static const real SLIGHT = 1e-12;
/* speeds [rad/s, m/s] of what is as good as at rest: beside slower ones the rounding of rates would
 * explain anything */
static const real SLOWEST = 1e-6;

int cardan_mesh_call_balance(const cardan_in *in, real *out, real *work)
{
    const cardan_state at = cardan_state_of(in);

    return cardan_mesh_balance(cardan_mesh_of(in), &at, out, work);
}

int cardan_mesh_call_qdot(const cardan_in *in, real *out, real *work)
{
    return cardan_mesh_rates(cardan_mesh_of(in), in->q, in->u, out, work);
}

int cardan_mesh_call_move(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);

    return cardan_mesh_move(mesh, in->q, in->du, out, out + mesh->nq, work);
}

int cardan_mesh_call_energy(const cardan_in *in, real *out, real *work)
{
    const cardan_state at = cardan_state_of(in);
    const int status = cardan_mesh_sum(cardan_mesh_of(in), &at, CARDAN_ENERGY, 2, out, work);

    out[2] = out[0] + out[1];
    return status;
}

int cardan_mesh_call_momentum(const cardan_in *in, real *out, real *work)
{
    const cardan_state at = cardan_state_of(in);

    return cardan_mesh_sum(cardan_mesh_of(in), &at, CARDAN_MOMENTUM, 6, out, work);
}

/* How much speeds miss of their constraints by rates (m), of the fastest, which is not at rest. */
static real missed(const cardan_mesh *mesh, const cardan_mesh_system *system, const real *u,
                   const real *rates)
{
    real most = 0, fastest = 0;

    for (ptrdiff_t k = 0; k < mesh->m; k++)
        most = fmax(most, fabs(system->rows[mesh->unknown[k]] * rates[k]));
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        fastest = fmax(fastest, fmax(u ? fabs(u[i]) : 0, SLOWEST) / system->units[i]);
    return most > 0 ? most / fastest : 0;
}

/* Whether rows of constraints are satisfied, but for what contradicts itself because of gaps: `most`. */
static int satisfied(const cardan_mesh_system *system, real most)
{
    return system->unfit <= GOOD || (!system->unsettled && system->unfit <= most);
}

/* Solve for accelerations with what redundant rows leave explained by gaps of the state: where it is
 * not, a row of its own passed for one of them, as next to singular positions. None is taken for
 * redundant because of gaps then, and rows give way as little as rounding lets them. */
static int solve(const cardan_mesh *mesh, const real *u, const real *rates,
                 cardan_mesh_system *system)
{
    int status = cardan_mesh_solve(mesh, system);
    real most;

    if (status == 0 && satisfied(system, GOOD))
        return 0;
    most = fmax(GOOD, EXPLAINED * fmax(system->sine, missed(mesh, system, u, rates)));
    if (status == 0 && satisfied(system, most))
        return 0;
    system->open = NULL;
    system->factors.compliance = SLIGHT;
    status = cardan_mesh_refactor(mesh, system);
    if (status == 0)
        status = cardan_mesh_solve(mesh, system);
    return status == 0 && !satisfied(system, most) ? CARDAN_UNSOLVED : status;
}

/* udot (nu) and lam (m) with M udot = f - h + tau + Gᵀ lam, G udot = gamma; tau may be NULL. */
int cardan_mesh_solve_motion(const cardan_mesh *mesh, const cardan_state *requested, const real *tau,
                             real *out, real *work, cardan_mesh_system *system)
{
    const cardan_assembly parts = {{0, 0, 1}, 0, 0, NULL, 0};
    real *missing = work + cardan_mesh_lay(mesh, work, system);
    real *gamma = missing + mesh->nu + mesh->mp + mesh->m;
    cardan_state at = *requested;
    cardan_mesh_friction friction;
    int assembled, status;

    at.udot = at.lam = NULL;
    system->open = missing + mesh->nu;
    status = cardan_mesh_balance(mesh, &at, missing, system->work);
    if (status == 0)
        status = cardan_mesh_gamma(mesh, &at, gamma, system->work);
    if (status == 0)
        status = cardan_mesh_factor(mesh, &at, &parts, system, &assembled);
    /* an unknown that is in no equation has no mass either */
    if (status == 0)
        status = cardan_mesh_massless(mesh, system);
    else if (status == CARDAN_UNSOLVED)
        status = CARDAN_SINGULAR;
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = (tau ? tau[i] : 0) - missing[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = gamma[k];
    status = solve(mesh, at.u, missing + mesh->nu + mesh->mp, system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        out[i] = system->solution[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        out[mesh->nu + k] = -system->solution[mesh->unknown[k]];
    if (status != 0 || mesh->frictions == 0)
        return status;
    (void)cardan_mesh_friction_lay(mesh, cardan_mesh_certainty(mesh, work), &friction);
    return cardan_mesh_with_friction(mesh, &at, system, &friction, out);
}

int cardan_mesh_accelerations(const cardan_mesh *mesh, const cardan_state *requested, const real *tau,
                              real *out, real *work)
{
    cardan_mesh_system system = {0};

    return cardan_mesh_solve_motion(mesh, requested, tau, out, work, &system);
}

real *cardan_mesh_certainty(const cardan_mesh *mesh, real *work)
{
    cardan_mesh_friction none;

    return work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m - cardan_mesh_jump_room(mesh)
           - cardan_mesh_friction_lay(mesh, NULL, &none);
}

int cardan_mesh_call_forward_dynamics(const cardan_in *in, real *out, real *work)
{
    const cardan_state at = cardan_state_of(in);

    return cardan_mesh_accelerations(cardan_mesh_of(in), &at, in->tau, out, work);
}

/* What the entries of a result of the scene are added to. */
typedef struct sums {
    int form;
    real *out;
} sums;

static void add(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                real *out, void *to)
{
    const sums *total = to;
    const ptrdiff_t size = g->forms[total->form].size;
    const ptrdiff_t *which = total->form == CARDAN_POWER ? g->powers : g->outputs;

    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        for (ptrdiff_t i = 0; i < size; i++)
            total->out[which[some->element[lane] * size + i]] += out[i * some->lanes + lane];
}

/* Results of elements as entries (count) of the scene's. */
static int summed(const cardan_mesh *mesh, const cardan_state *at, int form, ptrdiff_t count,
                  real *out, real *work)
{
    sums total = {form, out};

    for (ptrdiff_t i = 0; i < count; i++)
        out[i] = 0;
    return cardan_mesh_each(mesh, at, form, add, &total, work);
}

/* Accelerations and driving forces are those under the forces of the scene. */
int cardan_mesh_call_outputs(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    real *solution = work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m;
    cardan_state at = cardan_state_of(in);
    int status = 0;

    if (mesh->solved) {
        at.udot = at.lam = NULL;
        status = cardan_mesh_accelerations(mesh, &at, NULL, solution, work);
        at.udot = solution;
        at.lam = solution + mesh->nu;
    }
    return status != 0 ? status : summed(mesh, &at, CARDAN_OUTPUTS, mesh->outputs, out, work);
}

/* Of every source (powers); driven joints give that of their multipliers or, in trees, of the forces
 * along them at the accelerations: both are solved for. */
int cardan_mesh_call_power(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    real *solution = work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m;
    cardan_state at = cardan_state_of(in);
    int status = 0;

    at.udot = at.lam = NULL;
    if (mesh->driven) {
        status = cardan_mesh_accelerations(mesh, &at, NULL, solution, work);
        at.udot = solution;
        at.lam = solution + mesh->nu;
    }
    return status != 0 ? status : summed(mesh, &at, CARDAN_POWER, mesh->powers, out, work);
}

int cardan_mesh_call_rhs(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    const cardan_state at = cardan_state_of(in);
    /* behind what is worked with */
    real *solution = work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m;
    int status = cardan_mesh_rates(mesh, in->q, in->u, out, work);

    if (status == 0)
        status = cardan_mesh_accelerations(mesh, &at, in->tau, solution, work);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        out[mesh->nq + i] = solution[i];
    if (status == 0 && mesh->nz > 0)
        status = cardan_mesh_zdot(mesh, &at, out + mesh->nq + mesh->nu, work);
    return status;
}

/* The values (plan->values) of shares[0] K + shares[1] C + shares[2] M with its constraints. */
int cardan_mesh_values(const cardan_mesh *mesh, const cardan_state *at, const real *shares,
                       real *a, real *work)
{
    const cardan_assembly parts = {{shares[0], shares[1], shares[2]}, 0, 0, NULL, 0};
    cardan_mesh_system system = {0};

    (void)cardan_mesh_lay(mesh, work, &system);
    system.a = a;
    return cardan_mesh_matrix(mesh, at, &parts, &system);
}

int cardan_mesh_call_mass_matrix(const cardan_in *in, real *out, real *work)
{
    const cardan_state at = cardan_state_of(in);
    const real shares[3] = {0, 0, 1}; /* of K, C and M */

    return cardan_mesh_values(cardan_mesh_of(in), &at, shares, out, work);
}

/* G (m, nu) out of the rows of the sparse matrix. */
static void rows_of_matrix(const cardan_mesh *mesh, const cardan_mesh_system *system, real *out)
{
    const cardan_sparse *plan = mesh->plan;
    real *number = system->right;

    memset(out, 0, (size_t)(mesh->m * mesh->nu) * sizeof(real));
    /* the constraint of an equation, counted from 1; 0: one of forces */
    memset(number, 0, (size_t)plan->n * sizeof(real));
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        number[mesh->unknown[k]] = (real)(k + 1);
    for (ptrdiff_t block = 0; block < plan->blocks; block++) {
        const real *entries = system->a + plan->at[block];
        for (ptrdiff_t i = plan->first[block]; i < plan->first[block + 1]; i++)
            for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
                const ptrdiff_t from = plan->first[plan->column[pair]];
                const ptrdiff_t n = plan->first[plan->column[pair] + 1] - from;
                if (number[i] > 0 && from < mesh->nu)
                    memcpy(out + ((ptrdiff_t)number[i] - 1) * mesh->nu + from, entries,
                           (size_t)n * sizeof(real));
                entries += n;
            }
    }
}

/* How fast loops open per speed (m, nu): rows of constraints less what the tree determines, which are
 * zero, for the rank that these have together. */
int cardan_mesh_call_constraint_jacobian(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    const cardan_state at = cardan_state_of(in);
    const cardan_assembly parts = {{0, 0, 1}, 0, 0, NULL, 0};
    cardan_mesh_system system = {0};
    int status;

    (void)cardan_mesh_lay(mesh, work, &system);
    status = cardan_mesh_matrix(mesh, &at, &parts, &system);
    rows_of_matrix(mesh, &system, out);
    if (status == 0 && cardan_mesh_loops(mesh, &system, out) != CARDAN_OK)
        rows_of_matrix(mesh, &system, out);
    return status;
}

/* Numbers of work memory that each of these needs, at most. */
ptrdiff_t cardan_mesh_call_work(const cardan_mesh *mesh)
{
    cardan_mesh_system system;
    cardan_mesh_friction friction;
    ptrdiff_t most = mesh->work;

    /* q and T of a place */
    for (ptrdiff_t k = 0; k < mesh->mover_count; k++) {
        const cardan_movers *movers = &mesh->movers[k];
        if (most < mesh->work + movers->nq + movers->nu * movers->nu)
            most = mesh->work + movers->nq + movers->nu * movers->nu;
    }
    return most + cardan_mesh_lay(mesh, NULL, &system) + 2 * mesh->nu + mesh->mp + 3 * mesh->m
           + cardan_mesh_friction_lay(mesh, NULL, &friction) + cardan_mesh_jump_room(mesh);
}
