/* Constrained least-squares step: satisfy hard equations, reduce soft ones in their null space.
 *
 * Part of cardan. Caller owns all memory.
 *
 * 1. LQ factorization of the hard rows A = L Qᵀ by Householder reflections with row pivoting. 2.
 * One-sided Jacobi rotations of the columns of L give A = U S Wᵀ Qᵀ with accurate singular values;
 *    values that are too small count as zero.
 * 3. Range-space step: the minimum-norm Newton step for the hard residuals, each direction damped
 * by
 *    the norm of the residuals. It stays bounded where the rank drops and converges quadratically.
 * 4. Null-space step: damped Gauss-Newton step for the soft rows R along the free directions.
 * Source: Z. Drmac, K. Veselic, SIAM J. Matrix Anal. Appl. 29 (2008), 1322-1342 (singular values);
 * J. Nocedal, S. Wright, Numerical Optimization, 2nd ed., chapters 10 and 18 (the step).
 */
#include "position.h"
#include "solve.h"
#include <float.h>
#include <math.h>

static const real ORTHOGONAL = CARDAN_ROUNDING(1e-15, 5e-7);
static const real DEPENDENT = CARDAN_ROUNDING(1e-16, 6e-8), SHARE = 0.1, LEAST_SCALE = 1e-12;
enum { MOST_SWEEPS = 30 };

/* arrays within the workspace */
typedef struct parts {
    ptrdiff_t r;      /* number of reflections, at most min(hard, nu) */
    real *reflected;  /* (hard + soft, nu): Householder vectors in the hard rows, then R Q */
    real *order;      /* (r) hard row of each reflection */
    real *factor;     /* (r) 2 / |v|^2 of each reflection */
    real *columns;    /* (r, hard) of L, then of U S */
    real *w;          /* (r, r) */
    real *values;     /* (r) singular values */
    real *y;          /* (nu) the step in the axes of Q */
    real *ahead;      /* (soft) linearized residuals after the range-space step */
    real *multiplier; /* (hard) multipliers; 1 for pending rows during the factorization */
    real *free;       /* (nu, soft) R along the free directions */
    real *normal;     /* (nu, nu) */
    real *right;      /* (nu) */
} parts;

static ptrdiff_t least_of(ptrdiff_t a, ptrdiff_t b)
{
    return a < b ? a : b;
}

/* Size of the workspace of a step. */
ptrdiff_t cardan_least_length(ptrdiff_t hard, ptrdiff_t soft, ptrdiff_t nu)
{
    const ptrdiff_t r = least_of(hard, nu);

    return (hard + soft) * nu + 3 * r + r * hard + r * r + soft + hard + nu * (soft + nu + 2);
}

static parts parts_of(const cardan_least *least)
{
    const ptrdiff_t nu = least->nu, r = least_of(least->hard, nu);
    real *next = least->memory;
    parts p = {.r = r, .reflected = next};

    next += (least->hard + least->soft) * nu;
    p.order = next;
    p.factor = next + r;
    p.values = next + 2 * r;
    p.columns = next + 3 * r;
    p.w = p.columns + r * least->hard;
    p.y = p.w + r * r;
    p.ahead = p.y + nu;
    p.multiplier = p.ahead + least->soft;
    p.free = p.multiplier + least->hard;
    p.normal = p.free + nu * least->soft;
    p.right = p.normal + nu * nu;
    return p;
}

/* Apply reflection k, which starts at entry k, to a vector. */
static void reflect(const parts *p, ptrdiff_t k, ptrdiff_t nu, real *x)
{
    const real *v = p->reflected + (ptrdiff_t)p->order[k] * nu;
    const real share = p->factor[k] * cardan_dot(v + k, x + k, nu - k);

    for (ptrdiff_t j = k; j < nu; j++)
        x[j] -= share * v[j];
}

/* Pending hard row with the largest norm from entry k on, -1 if all are zero; `length`: its norm. */
static ptrdiff_t longest(const cardan_least *least, const parts *p, ptrdiff_t k, real *length)
{
    ptrdiff_t best = -1;
    real largest = 0;

    for (ptrdiff_t i = 0; i < least->hard; i++) {
        const real *row = p->reflected + i * least->nu + k;
        real square = 0;
        /* rows already reduced are marked by a multiplier of 0 */
        if (p->multiplier[i] == 0)
            continue;
        square = cardan_dot(row, row, least->nu - k);
        if (square > largest) {
            largest = square;
            best = i;
        }
    }
    *length = sqrt(largest);
    return best;
}

/* A = L Qᵀ with row pivoting. Householder vectors overwrite the rows, L goes to `columns`; r
 * becomes the numerical rank. */
static void orthogonalize(const cardan_least *least, parts *p)
{
    const ptrdiff_t hard = least->hard, nu = least->nu;
    real first = 0, length;

    for (ptrdiff_t i = 0; i < hard * nu; i++)
        p->reflected[i] = least->jacobian[i];
    for (ptrdiff_t i = 0; i < hard; i++)
        p->multiplier[i] = 1;
    for (ptrdiff_t k = 0; k < p->r; k++) {
        const ptrdiff_t best = longest(least, p, k, &length);
        real *column = p->columns + k * hard, *v;
        /* stop at rounding level, relative to the longest row */
        first = fmax(first, length);
        if (best < 0 || !(length > DEPENDENT * first)) {
            p->r = k;
            return;
        }
        /* reflect the pivot row onto axis k, with the sign that avoids cancellation */
        v = p->reflected + best * nu;
        p->order[k] = (real)best;
        p->factor[k] = 1 / (length * (length + fabs(v[k])));
        for (ptrdiff_t i = 0; i < hard; i++)
            column[i] = 0;
        column[best] = v[k] > 0 ? -length : length;
        v[k] -= column[best];
        p->multiplier[best] = 0;
        for (ptrdiff_t i = 0; i < hard; i++)
            if (p->multiplier[i] != 0) {
                reflect(p, k, nu, p->reflected + i * nu);
                column[i] = p->reflected[i * nu + k];
            }
    }
}

static void rotate(real *a, real *b, ptrdiff_t n, real cosine, real sine)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        const real x = a[i], y = b[i];
        a[i] = cosine * x - sine * y;
        b[i] = sine * x + cosine * y;
    }
}

/* sqrt(1 + z^2), of which mathematical libraries differ in the last bit */
static real beside_one(real z)
{
    const real size = fabs(z);

    return size > 1 ? size * sqrt(1 + 1 / (size * size)) : sqrt(1 + size * size);
}

/* Jacobi rotation that makes two columns orthogonal. Returns 0 if they already are. */
static int make_orthogonal(const parts *p, ptrdiff_t hard, ptrdiff_t i, ptrdiff_t j)
{
    real *a = p->columns + i * hard, *b = p->columns + j * hard;
    const real aa = cardan_dot(a, a, hard), bb = cardan_dot(b, b, hard), ab = cardan_dot(a, b, hard);
    real zeta, tangent, cosine;

    if (!(fabs(ab) > ORTHOGONAL * sqrt(aa) * sqrt(bb)))
        return 0;
    zeta = (bb - aa) / (2 * ab);
    tangent = (zeta < 0 ? -1 : 1) / (fabs(zeta) + beside_one(zeta));
    cosine = 1 / beside_one(tangent);
    rotate(a, b, hard, cosine, cosine * tangent);
    rotate(p->w + i * p->r, p->w + j * p->r, p->r, cosine, cosine * tangent);
    return 1;
}

/* Singular values of L by cyclic one-sided Jacobi sweeps; columns become U S, w becomes W. */
static void decompose(const parts *p, ptrdiff_t hard)
{
    int changed = 1;

    for (ptrdiff_t i = 0; i < p->r * p->r; i++)
        p->w[i] = i % (p->r + 1) == 0;
    for (int sweep = 0; sweep < MOST_SWEEPS && changed; sweep++) {
        changed = 0;
        for (ptrdiff_t i = 0; i < p->r; i++)
            for (ptrdiff_t j = i + 1; j < p->r; j++)
                changed |= make_orthogonal(p, hard, i, j);
    }
    for (ptrdiff_t i = 0; i < p->r; i++)
        p->values[i] = sqrt(cardan_dot(p->columns + i * hard, p->columns + i * hard, hard));
}

/* Range-space step in the axes of Q. Returns the rank; negligible singular values become 0.
 *
 * Each direction is scaled by s / (s^2 + d^2) in place of 1 / s, with d = SHARE |hard residuals|. */
static ptrdiff_t across(const cardan_least *least, const parts *p)
{
    real top = 1, distance = SHARE * sqrt(cardan_dot(least->residuals, least->residuals, least->hard));
    ptrdiff_t rank = 0;

    for (ptrdiff_t i = 0; i < p->r; i++)
        top = fmax(top, p->values[i]);
    for (ptrdiff_t i = 0; i < least->nu; i++)
        p->y[i] = 0;
    for (ptrdiff_t i = 0; i < p->r; i++) {
        const real value = p->values[i] > least->rank * top ? p->values[i] : 0;
        real share;
        p->values[i] = value;
        if (value == 0)
            continue;
        rank++;
        share = cardan_dot(p->columns + i * least->hard, least->residuals, least->hard);
        share /= value * value + distance * distance;
        for (ptrdiff_t j = 0; j < p->r; j++)
            p->y[j] -= share * p->w[i * p->r + j];
    }
    return rank;
}

/* R Q, the soft residuals after the range-space step, and the penalty weight of the hard rows from
 * their multipliers. */
static void look_ahead(cardan_least *least, const parts *p)
{
    const ptrdiff_t nu = least->nu, hard = least->hard;
    const real *soft = least->residuals + hard;
    real *rows = p->reflected + hard * nu, *slope = p->right;

    for (ptrdiff_t i = 0; i < least->soft * nu; i++)
        rows[i] = least->jacobian[hard * nu + i];
    for (ptrdiff_t j = 0; j < p->r; j++)
        slope[j] = 0;
    for (ptrdiff_t i = 0; i < least->soft; i++) {
        for (ptrdiff_t k = 0; k < p->r; k++)
            reflect(p, k, nu, rows + i * nu);
        p->ahead[i] = soft[i] + cardan_dot(rows + i * nu, p->y, p->r);
        for (ptrdiff_t j = 0; j < p->r; j++)
            slope[j] += rows[i * nu + j] * soft[i];
    }
    /* least-squares multipliers U S^-1 Wᵀ (R Q)ᵀ r of the hard rows */
    for (ptrdiff_t i = 0; i < hard; i++)
        p->multiplier[i] = 0;
    for (ptrdiff_t k = 0; k < p->r; k++) {
        const real value = p->values[k];
        const real share = value > 0 ? cardan_dot(p->w + k * p->r, slope, p->r) / (value * value) : 0;
        for (ptrdiff_t i = 0; i < hard; i++)
            p->multiplier[i] += share * p->columns[k * hard + i];
    }
    /* an exact penalty must exceed the largest multiplier */
    for (ptrdiff_t i = 0; i < hard; i++)
        least->price = fmax(least->price, 1 + fabs(p->multiplier[i]));
}

/* Soft rows along every free direction (count, soft): first directions with a zero singular value,
 * then the axes of Q beyond r. */
static void along_free(const cardan_least *least, const parts *p)
{
    const ptrdiff_t nu = least->nu, soft = least->soft;
    const real *rows = p->reflected + least->hard * nu;
    real *next = p->free;

    for (ptrdiff_t k = 0; k < p->r; k++)
        if (p->values[k] == 0)
            for (ptrdiff_t i = 0; i < soft; i++)
                *next++ = cardan_dot(rows + i * nu, p->w + k * p->r, p->r);
    for (ptrdiff_t j = p->r; j < nu; j++)
        for (ptrdiff_t i = 0; i < soft; i++)
            *next++ = rows[i * nu + j];
}

/* Null-space step: add the Levenberg-Marquardt step for the soft rows along the free directions. */
static void descend(const cardan_least *least, const parts *p)
{
    const ptrdiff_t count = least->freedoms, soft = least->soft;
    real largest = 0, scale;
    real *next = p->right;

    along_free(least, p);
    for (ptrdiff_t i = 0; i < count * soft; i++)
        largest = fmax(largest, fabs(p->free[i]));
    /* damping relative to the largest derivative; normal equations in the free directions */
    scale = least->damping * fmax(largest * largest, LEAST_SCALE);
    for (ptrdiff_t i = 0; i < count; i++) {
        const real *row = p->free + i * soft;
        for (ptrdiff_t j = 0; j <= i; j++)
            p->normal[i * count + j] = cardan_dot(row, p->free + j * soft, soft) + (i == j ? scale : 0);
        p->right[i] = cardan_dot(row, p->ahead, soft);
    }
    if (cardan_solve_spd((int)count, 1, p->normal, p->right, NULL) != CARDAN_OK)
        return;
    /* back to the axes of Q, in the order of along_free */
    for (ptrdiff_t k = 0; k < p->r; k++)
        if (p->values[k] == 0) {
            for (ptrdiff_t j = 0; j < p->r; j++)
                p->y[j] -= *next * p->w[k * p->r + j];
            next++;
        }
    for (ptrdiff_t j = p->r; j < least->nu; j++)
        p->y[j] -= *next++;
}

/* Compute the step (nu), the number of remaining freedoms and the penalty weight `price`. */
void cardan_least_step(cardan_least *least, real *step)
{
    parts p = parts_of(least);

    orthogonalize(least, &p);
    decompose(&p, least->hard);
    least->freedoms = least->nu - across(least, &p);
    least->price = 1;
    if (least->soft > 0) {
        look_ahead(least, &p);
        descend(least, &p);
    }
    for (ptrdiff_t k = p.r - 1; k >= 0; k--)
        reflect(&p, k, least->nu, p.y);
    for (ptrdiff_t j = 0; j < least->nu; j++)
        step[j] = p.y[j];
}
