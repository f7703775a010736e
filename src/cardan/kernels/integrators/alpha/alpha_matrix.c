/* Iteration matrix of the generalized-alpha method, scaled so that it stays bounded as h -> 0.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Unknowns are the corrections of the increment, of the stabilization eta and of the multipliers.
 * Increments are scaled by 1 / sqrt(M_ii), constraint rows by 1 / their norm in these scaled
 * speeds, multipliers by beta h^2 (1 - af) / (1 - am). In these units the matrix is
 * [M 0 -Gᵀ; G -G Gᵀ 0; G 0 0] plus terms of order h.
 * Source: C. L. Bottasso, O. A. Bauchau, A. Cardona, Time-step-size-independent conditioning and
 * sensitivity to perturbations in the numerical solution of index three differential algebraic
 * equations, SIAM J. Sci. Comput. 29 (2007); M. Arnold, O. Brüls, A. Cardona, Error analysis of
 * generalized-alpha Lie group time integration methods for constrained mechanical systems, Numer.
 * Math. 129 (2015), section 4 (the stabilized index 2 form).
 */
#include "alpha.h"
#include "linear.h"
#include <math.h>

/* Scales of unknowns and rows; a speed without inertia gets the smallest inertia that is not 0. */
static void weigh(const cardan_alpha *v)
{
    const ptrdiff_t nu = v->nu;
    const real *mass = v->tangent + 2 * nu * nu, *G = v->tangent + 3 * nu * nu + v->m * nu;
    real lightest = INFINITY;

    for (ptrdiff_t i = 0; i < nu; i++)
        if (mass[i * nu + i] > 0)
            lightest = fmin(lightest, mass[i * nu + i]);
    for (ptrdiff_t i = 0; i < nu; i++) {
        const real inertia = mass[i * nu + i] > 0 ? mass[i * nu + i] : lightest;
        v->weight[i] = inertia < INFINITY ? 1 / sqrt(inertia) : 1;
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        real sum = 0;
        for (ptrdiff_t i = 0; i < nu; i++)
            sum += pow(G[k * nu + i] * v->weight[i], 2);
        v->unit[k] = sum > 0 ? 1 / sqrt(sum) : 1;
    }
}

/* Derivatives of the balance at t, y, udot, lam, and the scales that follow from them. */
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

/* out (nu) = row (nu) T; T is banded because a rotation couples only three adjacent speeds. */
static void rotated_row(const cardan_alpha *v, const real *row, real *out)
{
    const ptrdiff_t nu = v->nu;
    const real *T = v->moved + v->nq;

    for (ptrdiff_t j = 0; j < nu; j++) {
        out[j] = 0;
        for (ptrdiff_t k = j < 2 ? 0 : j - 2; k < nu && k <= j + 2; k++)
            out[j] += row[k] * T[k * nu + j];
    }
}

/* Add factor times row (nu), scaled, to the increment columns of a matrix row. */
static void put_row(const cardan_alpha *v, real *to, const real *row, real factor)
{
    for (ptrdiff_t j = 0; j < v->nu; j++)
        to[j] += factor * row[j] * v->weight[j];
}

/* Fill the eta columns of a matrix row: eta changes the increment by -W^2 Gᵀ eta. */
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

/* Number of stabilization unknowns eta; at h = 0 only accelerations and multipliers are unknown. */
static ptrdiff_t stabilizers(const cardan_alpha *v, real h)
{
    return v->index == 2 && h != 0 ? cardan_alpha_picked(v, v->mp) : 0;
}

/* Fill the matrix of a step h; h = 0: the matrix for initial accelerations and multipliers.
 *
 * Returns the number of unknowns.
 */
ptrdiff_t cardan_alpha_assemble(const cardan_alpha *v, real h)
{
    const ptrdiff_t nu = v->nu, extra = stabilizers(v, h), n = nu + extra + cardan_alpha_picked(v, v->m);
    const real *K = v->tangent, *C = K + nu * nu, *M = C + nu * nu, *R = M + nu * nu;
    const real *G = R + v->m * nu, part = (1 - v->af) / (1 - v->am);
    const real damping = h * v->gamma * part, stiffness = h * h * v->beta * part;
    const real rate_factor = h * v->beta / v->gamma;
    real *row = v->matrix, *along = v->room;
    ptrdiff_t column = nu + extra;

    for (ptrdiff_t i = 0; i < n * n; i++)
        v->matrix[i] = 0;
    /* balance rows: M + h gamma p C + h^2 beta p K T with p = (1 - af) / (1 - am) */
    for (ptrdiff_t i = 0; i < nu; i++, row += n) {
        put_row(v, row, M + i * nu, v->weight[i]);
        put_row(v, row, C + i * nu, damping * v->weight[i]);
        rotated_row(v, K + i * nu, along);
        put_row(v, row, along, stiffness * v->weight[i]);
        if (extra > 0)
            put_stabilization(v, row + nu, along, stiffness * v->weight[i]);
    }
    /* multiplier columns: -Gᵀ of the independent constraints */
    for (ptrdiff_t k = 0; k < v->m; k++) {
        if (v->picked[k] == 0)
            continue;
        for (ptrdiff_t i = 0; i < nu; i++)
            v->matrix[i * n + column] = -v->weight[i] * G[k * nu + i] * v->unit[k];
        column++;
    }
    /* position rows g = 0 */
    for (ptrdiff_t k = 0; k < v->mp && h != 0; k++)
        if (v->picked[k] != 0) {
            rotated_row(v, G + k * nu, along);
            put_row(v, row, along, v->unit[k]);
            if (extra > 0)
                put_stabilization(v, row + nu, along, v->unit[k]);
            row += n;
        }
    /* velocity rows G u' + g_t = 0 times h beta / gamma: of all constraints for index 2, of
     * velocity-level constraints only for index 3 */
    for (ptrdiff_t k = h == 0 || extra > 0 ? 0 : v->mp; k < v->m; k++)
        if (v->picked[k] != 0) {
            rotated_row(v, R + k * nu, along);
            put_row(v, row, G + k * nu, v->unit[k]);
            put_row(v, row, along, rate_factor * v->unit[k]);
            if (extra > 0)
                put_stabilization(v, row + nu, along, rate_factor * v->unit[k]);
            row += n;
        }
    return n;
}

/* The matrix (n, n) of a step h at the present state, for inspection. Returns n, or 0 on failure. */
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

/* Factor the matrix of a step h. Returns CARDAN_UNSOLVED if it is singular. */
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

/* New matrix of a step h at t, y, udot, lam; h = 0: for initial accelerations and multipliers.
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
    /* select independent constraints at the start of a segment, exchange rows later */
    if (status == 0 && h == 0)
        cardan_alpha_pick(v);
    else if (status == 0)
        cardan_alpha_pick_again(v);
    return status != 0 ? status : factor(run, v, h);
}

/* Right-hand side of the scaled system. Returns its length. */
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

/* Shift increments by W^2 Gᵀ times `part` of the stabilization of row e; dx, if given, follows. */
static void shift_by(const cardan_alpha *v, ptrdiff_t e, real part, real *dx)
{
    const ptrdiff_t nu = v->nu;
    const real *along = v->tangent + 3 * nu * nu + (v->m + e) * nu;

    for (ptrdiff_t i = 0; i < nu; i++) {
        const real step = v->weight[i] * v->weight[i] * along[i] * v->unit[e] * part;
        v->shift[i] += step;
        if (dx)
            dx[i] -= step;
    }
}

/* The shift that `closing` stands for, along the axes of the last matrix: with a shift of its own it
 * would lag behind constraints that turn, and drift along the free directions. */
int cardan_alpha_shift(const cardan_alpha *v)
{
    if (v->mesh)
        return cardan_alpha_sparse_shift(v);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->shift[i] = 0;
    for (ptrdiff_t e = 0; e < v->mp && v->index == 2; e++)
        if (v->picked[e] != 0)
            shift_by(v, e, v->closing[e], NULL);
        else
            v->closing[e] = 0;
    return 0;
}

/* Newton correction: solve for the residual of the trial, update a', shift and multipliers.
 *
 * dx (nu) receives the change of the increment; for h = 0 that of the accelerations.
 */
int cardan_alpha_correct(cardan_run *run, const cardan_alpha *v, real h, real *dx)
{
    const ptrdiff_t nu = v->nu, extra = stabilizers(v, h);
    const real *solution = v->right + nu;
    const real scale = h == 0 ? 1 : h * h * v->beta * (1 - v->af) / (1 - v->am);
    ptrdiff_t n;

    if (v->mesh)
        return cardan_alpha_sparse_correct(run, v, h, dx);
    n = right_of(v, h, scale);
    cardan_substitute(n, v->matrix, v->order, v->right);
    /* the increment contains beta h^2 a' */
    for (ptrdiff_t i = 0; i < nu; i++) {
        dx[i] = v->weight[i] * v->right[i];
        if (h != 0)
            v->a_new[i] += dx[i] / (v->beta * h * h);
    }
    /* stabilization: subtracted from the increment */
    for (ptrdiff_t e = 0; e < v->mp && extra > 0; e++) {
        if (v->picked[e] == 0)
            continue;
        v->closing[e] += *solution;
        shift_by(v, e, *solution++, dx);
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        if (v->picked[k] != 0)
            v->lam_new[k] += v->unit[k] * *solution++ / scale;
    return 0;
}
