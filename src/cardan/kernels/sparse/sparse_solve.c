/*
 * Solutions by the factors of sparse.h: forward substitution over the supernodes, then backward; for
 * the transposed matrix the other way round. Part of cardan.
 */
#include "sparse.h"
#include "sparse_dense.h"

/* unknowns of a node of space: supernodes along beams have as many */
enum { SIX = 6 };

static inline void exchange(ptrdiff_t k, ptrdiff_t other, double *y)
{
    const double swap = y[other];

    y[other] = y[k];
    y[k] = swap;
}

/* y (n) = P y for the exchanges of a supernode, forwards or backwards. Most rows stay where they are:
 * a branch that is foreseen does not wait for numbers to be stored. */
static inline void forwards(ptrdiff_t n, const int32_t *pivot, double *y)
{
    for (ptrdiff_t k = 0; k < n; k++)
        if (pivot[k] != k)
            exchange(k, pivot[k], y);
}

static inline void backwards(ptrdiff_t n, const int32_t *pivot, double *y)
{
    for (ptrdiff_t k = n - 1; k >= 0; k--)
        if (pivot[k] != k)
            exchange(k, pivot[k], y);
}

/* The triangular solves of a supernode of six in registers: every number waits for the one before it,
 * along a beam from its first node to its last, and memory would double that time. */
#define MINUS(i, k) y[i] -= d[(i) * SIX + (k)] * y[k]

static inline void lower_six(const double *d, double *block)
{
    double y[SIX];

    for (int i = 0; i < SIX; i++)
        y[i] = block[i];
    MINUS(1, 0), MINUS(2, 0), MINUS(3, 0), MINUS(4, 0), MINUS(5, 0);
    MINUS(2, 1), MINUS(3, 1), MINUS(4, 1), MINUS(5, 1);
    MINUS(3, 2), MINUS(4, 2), MINUS(5, 2);
    MINUS(4, 3), MINUS(5, 3);
    MINUS(5, 4);
    for (int i = 0; i < SIX; i++)
        block[i] = y[i];
}

/* The contribution of later unknowns is subtracted from the last one on: it is the first to be solved
 * for where the next supernode follows. */
static inline void upper_six(const cardan_panel *panel, const cardan_sparse_run *run,
                             const cardan_sparse_run *end, const double *solved, double *block)
{
    const double *d = panel->d;
    const ptrdiff_t later = panel->later;
    double y[SIX];

    for (int i = 0; i < SIX; i++)
        y[i] = block[i];
    for (; run < end; run++) {
        const double *column = panel->u + run->at, *x = solved + run->place;
        for (ptrdiff_t j = run->size - 1; j >= 0; j--) {
            y[0] -= column[j] * x[j];
            y[1] -= column[later + j] * x[j];
            y[2] -= column[2 * later + j] * x[j];
            y[3] -= column[3 * later + j] * x[j];
            y[4] -= column[4 * later + j] * x[j];
            y[5] -= column[5 * later + j] * x[j];
        }
    }
    y[5] *= d[5 * SIX + 5];
    MINUS(4, 5), MINUS(3, 5), MINUS(2, 5), MINUS(1, 5), MINUS(0, 5);
    y[4] *= d[4 * SIX + 4];
    MINUS(3, 4), MINUS(2, 4), MINUS(1, 4), MINUS(0, 4);
    y[3] *= d[3 * SIX + 3];
    MINUS(2, 3), MINUS(1, 3), MINUS(0, 3);
    y[2] *= d[2 * SIX + 2];
    MINUS(1, 2), MINUS(0, 2);
    y[1] *= d[SIX + 1];
    MINUS(0, 1);
    y[0] *= d[0];
    for (int i = 0; i < SIX; i++)
        block[i] = y[i];
}
#undef MINUS

static inline void lower(ptrdiff_t n, const double *d, double *block)
{
    for (ptrdiff_t k = 0; k < n; k++)
        for (ptrdiff_t i = k + 1; i < n; i++)
            block[i] -= d[i * n + k] * block[k];
}

static inline void upper(ptrdiff_t n, const double *d, double *block)
{
    for (ptrdiff_t k = n - 1; k >= 0; k--) {
        block[k] *= d[k * n + k];
        for (ptrdiff_t i = 0; i < k; i++)
            block[i] -= d[i * n + k] * block[k];
    }
}

/* Subtract the contribution of a solved supernode from the equations of later ones:
 * y -= (rows of x)^T own. */
static void scatter(const cardan_sparse *plan, ptrdiff_t s, const cardan_panel *panel, const double *x,
                    double *y)
{
    const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];

    for (const cardan_sparse_run *run = plan->run + plan->run_start[s]; run < end; run++)
        cardan_product(1, run->size, panel->n, y + panel->first, 1, x + run->at, panel->later,
                       y + run->place, 0);
}

/* Subtract the contribution of later unknowns from the equations of a supernode:
 * own -= (rows of x) y. */
static void gather(const cardan_sparse *plan, ptrdiff_t s, const cardan_panel *panel, const double *x,
                   double *y)
{
    const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];

    for (const cardan_sparse_run *run = plan->run + plan->run_start[s]; run < end; run++)
        for (ptrdiff_t k = 0; k < panel->n; k++)
            y[panel->first + k] -= cardan_dot(run->size, x + k * panel->later + run->at, y + run->place);
}

/* y becomes the solution for the plain matrix, in order of elimination. */
static void substitute(const cardan_sparse *plan, const cardan_sparse_factors *f, double *y)
{
    for (ptrdiff_t s = 0; s < plan->supernodes; s++) {
        const cardan_panel panel = cardan_panel_of(plan, s, f->values);
        double *block = y + panel.first;

        forwards(panel.n, f->pivot + panel.first, block);
        if (panel.n == SIX)
            lower_six(panel.d, block);
        else
            lower(panel.n, panel.d, block);
        scatter(plan, s, &panel, panel.lt, y);
    }
    for (ptrdiff_t s = plan->supernodes - 1; s >= 0; s--) {
        const cardan_panel panel = cardan_panel_of(plan, s, f->values);
        double *block = y + panel.first;

        if (panel.n == SIX) {
            upper_six(&panel, plan->run + plan->run_start[s], plan->run + plan->run_start[s + 1], y,
                      block);
        } else {
            gather(plan, s, &panel, panel.u, y);
            upper(panel.n, panel.d, block);
        }
        backwards(panel.n, f->exchanged + panel.first, block);
    }
}

/* y becomes the solution for the transposed matrix. */
static void substitute_transposed(const cardan_sparse *plan, const cardan_sparse_factors *f, double *y)
{
    for (ptrdiff_t s = 0; s < plan->supernodes; s++) {
        const cardan_panel panel = cardan_panel_of(plan, s, f->values);
        const ptrdiff_t n = panel.n;
        double *block = y + panel.first;

        forwards(n, f->exchanged + panel.first, block);
        for (ptrdiff_t k = 0; k < n; k++) {
            block[k] *= panel.d[k * n + k];
            cardan_minus(n - k - 1, block[k], panel.d + k * n + k + 1, block + k + 1);
        }
        scatter(plan, s, &panel, panel.u, y);
    }
    for (ptrdiff_t s = plan->supernodes - 1; s >= 0; s--) {
        const cardan_panel panel = cardan_panel_of(plan, s, f->values);
        double *block = y + panel.first;

        gather(plan, s, &panel, panel.lt, y);
        for (ptrdiff_t k = panel.n - 1; k >= 0; k--)
            cardan_minus(k, block[k], panel.d + k * panel.n, block);
        backwards(panel.n, f->pivot + panel.first, block);
    }
}

/* work = the right-hand side in order of elimination, scaled. Returns its largest number. */
static double enter(const cardan_sparse *plan, const cardan_sparse_factors *f, const double *b)
{
    double most = 0;

    for (ptrdiff_t k = 0; k < plan->n; k++) {
        const int32_t i = plan->order[k];
        const double y = f->rows ? f->rows[i] * b[i] : b[i];
        f->work[k] = y;
        most = fabs(y) > most ? fabs(y) : most;
    }
    return most;
}

/* x = the solution in units and in order of the unknowns. */
static void leave(const cardan_sparse *plan, const cardan_sparse_factors *f, double *x)
{
    for (ptrdiff_t k = 0; k < plan->n; k++) {
        const int32_t i = plan->order[k];
        x[i] = f->columns ? f->columns[i] * f->work[k] : f->work[k];
    }
}

void cardan_sparse_solve(const cardan_sparse *plan, const cardan_sparse_factors *f, ptrdiff_t count,
                         const double *b, double *x)
{
    const uint64_t mode = cardan_flush();

    for (ptrdiff_t c = 0; c < count; c++, b += plan->n, x += plan->n) {
        (void)enter(plan, f, b);
        substitute(plan, f, f->work);
        leave(plan, f, x);
    }
    cardan_restore(mode);
}

double cardan_sparse_solve_certain(const cardan_sparse *plan, const cardan_sparse_factors *f,
                                   const double *b, double *x)
{
    const uint64_t mode = cardan_flush();
    const double right = enter(plan, f, b);
    double speeds = 0, multipliers = 0, finite = 0, most;

    substitute(plan, f, f->work);
    for (ptrdiff_t k = 0; k < plan->n; k++) {
        const double size = fabs(f->work[k]), speed = plan->multiplier[k] ? 0 : size;
        speeds = speed > speeds ? speed : speeds;
        multipliers = size > multipliers ? size : multipliers;
        /* no maximum tells of what is not a number */
        finite += 0 * size;
    }
    leave(plan, f, x);
    cardan_restore(mode);
    if (!(finite == 0))
        return INFINITY;
    most = fmax(speeds, multipliers);
    /* the sum of sizes of a row is its right-hand side and its diagonal at least */
    return most > 0 ? f->certainty[CARDAN_SPARSE_LEFT] * most
                          / fmax(fmax(right, f->certainty[CARDAN_SPARSE_DIAGONAL] * speeds), CARDAN_LEAST)
                    : 0;
}

void cardan_sparse_solve_transposed(const cardan_sparse *plan, const cardan_sparse_factors *f,
                                ptrdiff_t count, const double *b, double *x)
{
    const uint64_t mode = cardan_flush();

    for (ptrdiff_t c = 0; c < count; c++, b += plan->n, x += plan->n) {
        for (ptrdiff_t k = 0; k < plan->n; k++) {
            const int32_t i = plan->order[k];
            f->work[k] = f->columns ? f->columns[i] * b[i] : b[i];
        }
        substitute_transposed(plan, f, f->work);
        for (ptrdiff_t k = 0; k < plan->n; k++) {
            const int32_t i = plan->order[k];
            x[i] = f->rows ? f->rows[i] * f->work[k] : f->work[k];
        }
    }
    cardan_restore(mode);
}

void cardan_sparse_substitute(const cardan_sparse *plan, const cardan_sparse_factors *f, int transposed,
                              double *y)
{
    if (transposed)
        substitute_transposed(plan, f, y);
    else
        substitute(plan, f, y);
}
