/* The iteration matrix of the generalized-alpha method, in units in which no step size shows.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Unknown are the correction of the increment, of the stabilization eta and of the multipliers.
 * Increments are counted in 1 / sqrt(M_ii), rows in the inverse of their length then, multipliers
 * in beta h^2: the matrix is [M 0 -Gᵀ; G -G Gᵀ 0; G 0 0] in these units, and terms of order h.
 * Source: C. L. Bottasso, O. A. Bauchau, A. Cardona, Time-step-size-independent conditioning and
 * sensitivity to perturbations in the numerical solution of index three differential algebraic
 * equations, SIAM J. Sci. Comput. 29 (2007); M. Arnold, O. Brüls, A. Cardona, Error analysis of
 * generalized-alpha Lie group time integration methods for constrained mechanical systems, Numer.
 * Math. 129 (2015), section 4 (the stabilized index 2 form).
 */
#include "alpha.h"
#include "linear.h"
#include <math.h>

/* Weights of the unknowns: a body without inertia counts like the lightest that has some. */
static void weigh(const cardan_alpha *v)
{
    const ptrdiff_t nu = v->nu;
    const real *mass = v->tangent + 2 * nu * nu, *G = v->tangent + 3 * nu * nu + v->m * nu;
    real lightest = INFINITY;

    for (ptrdiff_t i = 0; i < nu; i++)
        if (mass[i * nu + i] > 0)
            lightest = fmin(lightest, mass[i * nu + i]);
    for (ptrdiff_t i = 0; i < nu; i++) {
        const real own = mass[i * nu + i] > 0 ? mass[i * nu + i] : lightest;
        v->weight[i] = own < INFINITY ? 1 / sqrt(own) : 1;
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        real sum = 0;
        for (ptrdiff_t i = 0; i < nu; i++)
            sum += pow(G[k * nu + i] * v->weight[i], 2);
        v->unit[k] = sum > 0 ? 1 / sqrt(sum) : 1;
    }
}

/* Derivatives of the balance at t, y, udot, lam, and the units that follow from them. */
int cardan_alpha_tangent(cardan_run *run, const cardan_alpha *v, real t, const real *y,
                         const real *udot, const real *lam)
{
    cardan_in in;
    int status = cardan_inputs_at(run, t, y);

    if (status != 0)
        return status;
    in = cardan_at(run, &t, y);
    in.udot = udot;
    in.lam = lam;
    run->jacobians++;
    if (run->balance_tangent.function)
        status = cardan_call_model(run, &run->balance_tangent, &in, v->tangent);
    else
        status = cardan_alpha_differences(run, v, t, y, udot, lam);
    if (status == 0)
        weigh(v);
    return status;
}

/* out (nu) = row (nu) T; a rotation couples three speeds that stand side by side. */
static void turned(const cardan_alpha *v, const real *row, real *out)
{
    const ptrdiff_t nu = v->nu;
    const real *T = v->moved + v->nq;

    for (ptrdiff_t j = 0; j < nu; j++) {
        out[j] = 0;
        for (ptrdiff_t k = j < 2 ? 0 : j - 2; k < nu && k <= j + 2; k++)
            out[j] += row[k] * T[k * nu + j];
    }
}

/* Fill a row of the matrix: factor times row (nu), and its answer to the stabilization. */
static void put_row(const cardan_alpha *v, real *to, const real *row, real factor)
{
    for (ptrdiff_t j = 0; j < v->nu; j++)
        to[j] += factor * row[j] * v->weight[j];
}

static void put_stabilization(const cardan_alpha *v, real *to, const real *row, real factor)
{
    const ptrdiff_t nu = v->nu;
    const real *G = v->tangent + 3 * nu * nu + v->m * nu;

    for (ptrdiff_t e = 0; e < v->mp; e++) {
        real sum = 0;
        if (v->picked[e] == 0)
            continue;
        for (ptrdiff_t j = 0; j < nu; j++)
            sum += row[j] * v->weight[j] * v->weight[j] * G[e * nu + j];
        *to++ = -factor * v->unit[e] * sum;
    }
}

/* Unknowns of the stabilization; at h = 0 accelerations and multipliers are sought alone. */
static ptrdiff_t stabilizers(const cardan_alpha *v, real h)
{
    return v->index == 2 && h != 0 ? cardan_alpha_picked(v, v->mp) : 0;
}

/* Fill in the matrix of a step h, or that of accelerations and multipliers for h = 0.
 *
 * Returns how many unknowns there are.
 */
ptrdiff_t cardan_alpha_assemble(const cardan_alpha *v, real h)
{
    const ptrdiff_t nu = v->nu, extra = stabilizers(v, h), n = nu + extra + cardan_alpha_picked(v, v->m);
    const real *K = v->tangent, *C = K + nu * nu, *M = C + nu * nu, *R = M + nu * nu;
    const real *G = R + v->m * nu, part = (1 - v->af) / (1 - v->am);
    const real damping = h * v->gamma * part, stiffness = h * h * v->beta * part;
    const real turning = h * v->beta / v->gamma;
    real *row = v->matrix, *along = v->room;
    ptrdiff_t column = nu + extra;

    for (ptrdiff_t i = 0; i < n * n; i++)
        v->matrix[i] = 0;
    for (ptrdiff_t i = 0; i < nu; i++, row += n) {
        put_row(v, row, M + i * nu, v->weight[i]);
        put_row(v, row, C + i * nu, damping * v->weight[i]);
        turned(v, K + i * nu, along);
        put_row(v, row, along, stiffness * v->weight[i]);
        if (extra > 0)
            put_stabilization(v, row + nu, along, stiffness * v->weight[i]);
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        if (v->picked[k] == 0)
            continue;
        for (ptrdiff_t i = 0; i < nu; i++)
            v->matrix[i * n + column] = -v->weight[i] * G[k * nu + i] * v->unit[k];
        column++;
    }
    for (ptrdiff_t k = 0; k < v->mp && h != 0; k++)
        if (v->picked[k] != 0) {
            turned(v, G + k * nu, along);
            put_row(v, row, along, v->unit[k]);
            if (extra > 0)
                put_stabilization(v, row + nu, along, v->unit[k]);
            row += n;
        }
    for (ptrdiff_t k = h == 0 || extra > 0 ? 0 : v->mp; k < v->m; k++)
        if (v->picked[k] != 0) {
            turned(v, R + k * nu, along);
            put_row(v, row, G + k * nu, v->unit[k]);
            put_row(v, row, along, turning * v->unit[k]);
            if (extra > 0)
                put_stabilization(v, row + nu, along, turning * v->unit[k]);
            row += n;
        }
    return n;
}

/* The matrix (n, n) of a step h from the present state, to look at. Returns n, 0 where it fails. */
ptrdiff_t cardan_alpha_matrix(cardan_run *run, real h, real *matrix)
{
    const cardan_alpha v = cardan_alpha_at(run);
    ptrdiff_t n;

    if (cardan_alpha_tangent(run, &v, run->t, run->y, v.udot, v.lam) != 0)
        return 0;
    n = cardan_alpha_assemble(&v, h);
    for (ptrdiff_t i = 0; i < n * n; i++)
        matrix[i] = v.matrix[i];
    v.now[ALPHA_MATRIX] = 0;
    return n;
}

/* Factor the matrix of a step h. Returns CARDAN_UNSOLVED where it is singular. */
static int factor(cardan_run *run, const cardan_alpha *v, real h)
{
    const ptrdiff_t n = cardan_alpha_assemble(v, h);

    run->factorizations++;
    v->now[ALPHA_MATRIX] = h;
    v->now[ALPHA_RATE] = 1;
    if (cardan_factor(n, v->matrix, v->order) == 0)
        return 0;
    v->now[ALPHA_MATRIX] = 0;
    return CARDAN_UNSOLVED;
}

/* A new matrix of a step h at t, y, udot, lam; h = 0: of accelerations and multipliers at the start.
 *
 * Returns 0, CARDAN_UNSOLVED, CARDAN_MODEL or CARDAN_INPUT.
 */
int cardan_alpha_renew(cardan_run *run, const cardan_alpha *v, real h, real t, const real *y,
                       const real *udot, const real *lam)
{
    int status;

    if (v->mesh)
        return cardan_alpha_sparse_renew(run, v, h, t, y, udot, lam);
    status = cardan_alpha_tangent(run, v, t, y, udot, lam);
    if (status == 0 && h == 0)
        cardan_alpha_pick(v);
    else if (status == 0)
        cardan_alpha_pick_again(v);
    return status != 0 ? status : factor(run, v, h);
}

/* Right-hand side of the system in its units. */
static ptrdiff_t right_of(const cardan_alpha *v, real h, real scale)
{
    const real *g = v->residual + v->nu, *rates = g + v->mp;
    const ptrdiff_t extra = stabilizers(v, h);
    real *right = v->right;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        *right++ = -scale * v->weight[i] * v->residual[i];
    for (ptrdiff_t k = 0; k < v->mp && h != 0; k++)
        if (v->picked[k] != 0)
            *right++ = -v->unit[k] * g[k];
    for (ptrdiff_t k = h == 0 || extra > 0 ? 0 : v->mp; k < v->m; k++)
        if (v->picked[k] != 0)
            *right++ = h == 0 ? 0 : -v->unit[k] * h * v->beta / v->gamma * rates[k];
    return right - v->right;
}

/* Correct accelerations, stabilization and multipliers of the trial by its residual.
 *
 * dx (nu) becomes the change of the increment; for h = 0 that of the accelerations.
 */
int cardan_alpha_correct(cardan_run *run, const cardan_alpha *v, real h, real *dx)
{
    const ptrdiff_t nu = v->nu, extra = stabilizers(v, h);
    const real *G = v->tangent + 3 * nu * nu + v->m * nu, *found = v->right + nu;
    const real scale = h == 0 ? 1 : h * h * v->beta * (1 - v->af) / (1 - v->am);
    ptrdiff_t n;

    if (v->mesh)
        return cardan_alpha_sparse_correct(run, v, h, dx);
    n = right_of(v, h, scale);
    cardan_substitute(n, v->matrix, v->order, v->right);
    for (ptrdiff_t i = 0; i < nu; i++) {
        dx[i] = v->weight[i] * v->right[i];
        if (h != 0)
            v->a_new[i] += dx[i] / (v->beta * h * h);
    }
    for (ptrdiff_t e = 0; e < v->mp && extra > 0; e++) {
        if (v->picked[e] == 0)
            continue;
        for (ptrdiff_t i = 0; i < nu; i++) {
            const real step = v->weight[i] * v->weight[i] * G[e * nu + i] * v->unit[e] * *found;
            v->shift[i] += step;
            dx[i] -= step;
        }
        found++;
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        if (v->picked[k] != 0)
            v->lam_new[k] += v->unit[k] * *found++ / scale;
    return 0;
}
