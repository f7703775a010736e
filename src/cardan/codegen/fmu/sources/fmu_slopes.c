/* Directional and adjoint derivatives of an FMU: exact, from derivatives that the model has.
 *
 * Part of cardan. The model differentiates along its speeds. A change dq of the coordinates as they
 * are stored is one along the speeds by the least squares of N du = dq, where qdot = N u + n: what a
 * quaternion changes along itself is no rotation.
 */
#include "fmu_core.h"
#include <math.h>

static ptrdiff_t columns_of(const fmu_instance *m)
{
    const cardan_export *scene = fmu_scene(m);

    return 2 * scene->nu + scene->nz + 1 + scene->nr;
}

/* N and the Cholesky factor of N^T N at the present state. */
static int factor(fmu_instance *m)
{
    const ptrdiff_t nq = fmu_scene(m)->nq, nu = fmu_scene(m)->nu;
    const double *N = m->kinematics;
    double *L = m->normal;
    int status;

    if (m->factored)
        return 0;
    status = fmu_call(m, m->model->slopes[FMU_STATE].by_state, fmu_unit_view(m), m->kinematics);
    for (ptrdiff_t i = 0; i < nu && status == 0; i++)
        for (ptrdiff_t j = 0; j <= i; j++) {
            double sum = 0;
            for (ptrdiff_t k = 0; k < nq; k++)
                sum += N[k * nu + i] * N[k * nu + j];
            for (ptrdiff_t k = 0; k < j; k++)
                sum -= L[i * nu + k] * L[j * nu + k];
            L[i * nu + j] = i == j ? sqrt(sum) : sum / L[j * nu + j];
        }
    m->factored = status == 0;
    return status;
}

/* x = (L L^T)^-1 x. */
static void solve(const double *L, ptrdiff_t n, double *x)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        for (ptrdiff_t k = 0; k < i; k++)
            x[i] -= L[i * n + k] * x[k];
        x[i] /= L[i * n + i];
    }
    for (ptrdiff_t i = n - 1; i >= 0; i--) {
        for (ptrdiff_t k = i + 1; k < n; k++)
            x[i] -= L[k * n + i] * x[k];
        x[i] /= L[i * n + i];
    }
}

/* Lengths of the quaternions: derivatives are those of the drifted state, the model is asked at unit
 * ones. Scales entries of q (nq) by them, to a power of 1 or -1. */
static void scale_quaternions(const fmu_instance *m, double *q, int inverse)
{
    const cardan_run *run = &m->at.run;

    for (ptrdiff_t i = 0; i < run->quaternion_count; i++) {
        const double length = fmu_length(run->y + run->quaternions[i]);
        for (ptrdiff_t j = 0; j < 4; j++)
            q[run->quaternions[i] + j] *= inverse ? 1 / length : length;
    }
}

/* The derivatives of a kind at the present state, unless they are there. */
static int differentiate(fmu_instance *m, int kind, int parameters)
{
    int *there = parameters ? m->by_parameters_now : m->differentiated, status = 0;
    const fmu_slope *slope = m->model->slopes + kind;

    if (!there[kind]) {
        /* per block one matrix behind the other */
        status = fmu_call(m, parameters ? slope->by_parameters : slope->by_state, fmu_unit_view(m),
                          parameters ? m->by_parameters[kind] : m->slopes[kind]);
        there[kind] = status == 0;
    }
    return status;
}

/* Widths of the matrices: along the speeds, u, z, t, r. */
static void widths_of(const fmu_instance *m, ptrdiff_t widths[5])
{
    const cardan_export *scene = fmu_scene(m);

    widths[0] = widths[1] = scene->nu, widths[2] = scene->nz, widths[3] = 1, widths[4] = scene->nr;
}

/* Row `row` of a kind times a direction; or where `seed` counts, that row added to the direction. */
static double along_row(const fmu_instance *m, int kind, ptrdiff_t row, double *direction, double seed,
                        int adjoint)
{
    const ptrdiff_t rows = fmu_count(m, kind);
    const double *matrix = m->slopes[kind];
    ptrdiff_t widths[5];
    double sum = 0;

    widths_of(m, widths);
    for (int block = 0; block < 5; block++) {
        const double *entries = matrix + row * widths[block];
        for (ptrdiff_t k = 0; k < widths[block]; k++) {
            if (adjoint)
                direction[k] += seed * entries[k];
            else
                sum += entries[k] * direction[k];
        }
        matrix += rows * widths[block];
        direction += widths[block];
    }
    return sum;
}

/* What the drift of a quaternion adds to the derivative of its rates: they grow with its length. */
static double drift(const fmu_instance *m, ptrdiff_t row, double *increment, double seed, int adjoint)
{
    const cardan_run *run = &m->at.run;
    double sum = 0;

    for (ptrdiff_t i = 0; i < run->quaternion_count; i++) {
        const ptrdiff_t at = run->quaternions[i];
        const double *q = run->y + at, square = fmu_length(q) * fmu_length(q);
        if (row < at || row >= at + 4)
            continue;
        for (ptrdiff_t j = 0; j < 4; j++) {
            const double entry = m->values[FMU_RATE][row] * q[j] / square;
            if (adjoint)
                increment[at + j] += seed * entry;
            else
                sum += entry * increment[at + j];
        }
    }
    return sum;
}

/* direction = that of an increment of x: along the speeds, u, z. */
static void turn_to_speeds(fmu_instance *m, const double *increment, double *direction)
{
    const cardan_export *scene = fmu_scene(m);
    const ptrdiff_t nq = scene->nq, nu = scene->nu;

    memcpy(m->moved, increment, (size_t)nq * sizeof(double));
    scale_quaternions(m, m->moved, 1);
    for (ptrdiff_t j = 0; j < nu; j++) {
        direction[j] = 0;
        for (ptrdiff_t k = 0; k < nq; k++)
            direction[j] += m->kinematics[k * nu + j] * m->moved[k];
    }
    solve(m->normal, nu, direction);
    memcpy(direction + nu, increment + nq, (size_t)(nu + scene->nz) * sizeof(double));
}

/* The transpose: add to the increment of x what a direction is worth. */
static void turn_from_speeds(fmu_instance *m, double *direction, double *increment)
{
    const cardan_export *scene = fmu_scene(m);
    const ptrdiff_t nq = scene->nq, nu = scene->nu;

    solve(m->normal, nu, direction);
    for (ptrdiff_t k = 0; k < nq; k++) {
        m->moved[k] = 0;
        for (ptrdiff_t j = 0; j < nu; j++)
            m->moved[k] += m->kinematics[k * nu + j] * direction[j];
    }
    scale_quaternions(m, m->moved, 1);
    for (ptrdiff_t k = 0; k < nq; k++)
        increment[k] += m->moved[k];
    for (ptrdiff_t k = 0; k < nu + scene->nz; k++)
        increment[nq + k] += direction[nu + k];
}

/* How much rates of quaternions are longer than the model says. */
static double stretch(const fmu_instance *m, int kind, ptrdiff_t row)
{
    const cardan_run *run = &m->at.run;

    for (ptrdiff_t i = 0; i < run->quaternion_count && kind == FMU_RATE; i++) {
        if (row >= run->quaternions[i] && row < run->quaternions[i] + 4)
            return fmu_length(run->y + run->quaternions[i]);
    }
    return 1;
}

/* What is asked for: kinds and places of the unknowns and the knowns, and whether they have derivatives. */
static fmu_status check(fmu_instance *m, const unsigned *unknowns, size_t unknown_count,
                        const unsigned *knowns, size_t by_count, int *parameters)
{
    ptrdiff_t place = 0;

    *parameters = 0;
    if (!m->model->slopes[FMU_STATE].by_state)
        return fmu_say(m, FMU_ERROR, "derivatives: this FMU was exported without them.");
    for (size_t k = 0; k < by_count; k++) {
        const int kind = fmu_kind_of(m->model, knowns[k], &place);
        if (kind != FMU_STATE && kind != FMU_INPUT && kind != FMU_TIME && kind != FMU_PARAMETER)
            return fmu_say(m, FMU_ERROR, "derivatives: value reference %u is not one to differentiate by: give "
                           "states, inputs, parameters or the time.", knowns[k]);
        *parameters |= kind == FMU_PARAMETER;
    }
    for (size_t k = 0; k < unknown_count; k++) {
        const int kind = fmu_kind_of(m->model, unknowns[k], &place);
        if (kind != FMU_STATE && kind != FMU_RATE && kind != FMU_OUTPUT && kind != FMU_ENERGY)
            return fmu_say(m, FMU_ERROR, "derivatives: value reference %u is not one to differentiate: give "
                           "states, their derivatives, outputs or energies.", unknowns[k]);
        if (*parameters && kind != FMU_STATE && !m->model->slopes[kind].by_parameters)
            return fmu_say(m, FMU_ERROR, "derivatives: this FMU has none by parameters.");
    }
    return FMU_OK;
}

/* Compute what the derivatives of the unknowns are made of. */
static int ready(fmu_instance *m, const unsigned *unknowns, size_t count, int parameters)
{
    ptrdiff_t place = 0;
    int status = factor(m);

    for (size_t k = 0; k < count && status == 0; k++) {
        const int kind = fmu_kind_of(m->model, unknowns[k], &place);
        if (kind == FMU_STATE)
            continue;
        status = differentiate(m, kind, 0);
        if (status == 0 && parameters)
            status = differentiate(m, kind, 1);
    }
    return status;
}

/* Where the seed or the sensitivity of a known variable stands. */
static double *entry_of(fmu_instance *m, unsigned reference)
{
    const cardan_export *scene = fmu_scene(m);
    double *time = m->direction + 2 * scene->nu + scene->nz;
    ptrdiff_t place = 0;

    switch (fmu_kind_of(m->model, reference, &place)) {
    case FMU_STATE: return m->increment + place;
    case FMU_TIME: return time;
    case FMU_INPUT: return time + 1 + place;
    default: return m->increment + fmu_nx(m) + place;
    }
}

/* One unknown along the seeds; or, adjoint, its seed over the knowns. */
static double sensitivity_of(fmu_instance *m, unsigned reference, double seed, int parameters, int adjoint)
{
    const ptrdiff_t nx = fmu_nx(m), np = fmu_count(m, FMU_PARAMETER);
    ptrdiff_t place = 0;
    const int kind = fmu_kind_of(m->model, reference, &place);
    double sum;

    if (kind == FMU_STATE) {
        if (adjoint)
            m->increment[place] += seed;
        return m->increment[place];
    }
    seed *= stretch(m, kind, place);
    sum = along_row(m, kind, place, m->direction, seed, adjoint);
    for (ptrdiff_t k = 0; k < np && parameters; k++) {
        const double entry = m->by_parameters[kind][place * np + k];
        if (adjoint)
            m->increment[nx + k] += seed * entry;
        else
            sum += entry * m->increment[nx + k];
    }
    return sum;
}

fmu_status fmu_derivative(fmu_instance *m, const unsigned *unknowns, size_t unknown_count,
                          const unsigned *knowns, size_t by_count, const double *seed,
                          double *sensitivity, int adjoint)
{
    const size_t columns = (size_t)(columns_of(m) + fmu_count(m, FMU_PARAMETER));
    const size_t length = (size_t)(fmu_nx(m) + fmu_count(m, FMU_PARAMETER));
    int parameters, status;

    if (fmu_settle(m) != FMU_OK || check(m, unknowns, unknown_count, knowns, by_count, &parameters) != FMU_OK)
        return FMU_ERROR;
    if (fmu_compute(m, FMU_RATE) != FMU_OK)
        return FMU_DISCARD;
    status = ready(m, unknowns, unknown_count, parameters);
    if (status != 0)
        return fmu_broke_down(m, "derivatives", status);
    memset(m->direction, 0, columns * sizeof(double));
    memset(m->increment, 0, length * sizeof(double));
    if (!adjoint) {
        for (size_t k = 0; k < by_count; k++)
            *entry_of(m, knowns[k]) += seed[k];
        turn_to_speeds(m, m->increment, m->direction);
    }
    for (size_t k = 0; k < unknown_count; k++) {
        ptrdiff_t place = 0;
        const int rate = fmu_kind_of(m->model, unknowns[k], &place) == FMU_RATE;
        const double by_model = sensitivity_of(m, unknowns[k], adjoint ? seed[k] : 0, parameters, adjoint);
        const double factor_of = rate && !adjoint ? stretch(m, FMU_RATE, place) : 1;
        const double by_length = rate ? drift(m, place, m->increment, adjoint ? seed[k] : 0, adjoint) : 0;
        if (!adjoint)
            sensitivity[k] = factor_of * by_model + by_length;
    }
    if (adjoint) {
        turn_from_speeds(m, m->direction, m->increment);
        for (size_t k = 0; k < by_count; k++)
            sensitivity[k] = *entry_of(m, knowns[k]);
    }
    return FMU_OK;
}
