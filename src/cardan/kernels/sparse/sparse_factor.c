/*
 * The factorization of sparse.h. Part of cardan.
 *
 * For every supernode, in order of elimination:
 *   1. take the size that its pivots are compared with; its panel was loaded with the entries of
 *      the matrix before the first supernode that is subtracted from it (see 5);
 *   2. if asked, count the signs of the eigenvalues of its diagonal block D;
 *   3. eliminate D by rows with pivoting inside the supernode; pivots of speeds below the rounding
 *      error are replaced by small ones and recorded (see sparse_free_column.c);
 *   4. solve for the part below: Lt = (upper factor of D)^-T Lt;
 *   5. subtract L U from the panels of later supernodes (right-looking).
 *
 * Where the pivot of a multiplier is only rounding error, constraints are redundant. Rounding is not to
 * decide which: all is factored again with a small negative number on the diagonal of all rows that
 * close loops. That is regular whatever their rank, and refinement (proximal iterations) makes up.
 * Source: J. Carpentier, R. Budhiraja, N. Mansard, Proximal and sparse resolution of constrained
 * dynamic equations, Robotics: Science and Systems, 2021.
 */
#include "sparse.h"
#include "sparse_dense.h"

/* value of plan->multiplier for a multiplier of a loop-closing constraint */
#define CLOSES 2

/* pivots below these fractions of their original size count as zero ... */
#define SPEED_NOISE 3e-14
#define MULTIPLIER_NOISE 1e-12
/* ... and are replaced by this fraction of it */
#define REPLACEMENT 1e-8
/* what rows that close loops give way where constraints are redundant, of their size: at least, and of
 * `hidden`, so that no multiplier grows by it */
#define COMPLIANCE 1e-8
#define HIDDEN 1e2
/* what a row that follows from others is left with, of what each of these gives way */
#define YIELDING 100
/* what comes beside a status: a multiplier has no pivot */
#define REDUNDANT (-1)
/* a row of the same kind (speed or multiplier) is taken as the pivot if its entry is at least this
 * fraction of the largest entry in rows of the other kind */
#define EARLY 1e-2
/* the diagonal entry is preferred if it is at least this fraction of the largest of its kind */
#define PREFER 0.1
/* the replaced pivot of a multiplier is at least this many times the rounding error in the pivot, so
 * that the multiplier comes out as nearly zero and carries no force */
#define BEYOND 1e4

/* Size up to which a pivot is only rounding error; compliance: of rows that close loops. */
static double noise_of(const cardan_sparse *plan, const cardan_sparse_factors *f, ptrdiff_t k,
                       double compliance)
{
    double noise = plan->multiplier[k] ? MULTIPLIER_NOISE : SPEED_NOISE;

    if (plan->multiplier[k] == CLOSES && compliance == 0)
        noise = fmax(noise, f->hidden);
    return noise * f->scale[k];
}

/* Let rows of a supernode that close loops give way, and record that. */
static void comply(const cardan_sparse *plan, const cardan_panel *panel, double compliance,
                   cardan_sparse_factors *f)
{
    for (ptrdiff_t k = 0; k < panel->n; k++) {
        const double scale = f->scale[panel->first + k];
        const double shift = -compliance * (scale > 0 ? scale : 1);
        if (plan->multiplier[panel->first + k] != CLOSES)
            continue;
        panel->d[k * panel->n + k] += shift;
        f->shift[f->weak] = shift;
        f->replaced[f->weak++] = (int32_t)(panel->first + k);
    }
}

/* Count the signs of the eigenvalues of D; what rows give way counts as zero. */
static void count(const cardan_sparse *plan, const cardan_panel *panel, double compliance,
                  cardan_sparse_factors *f)
{
    const ptrdiff_t first = panel->first, n = panel->n;
    double *noise = f->work, largest = 0;

    for (ptrdiff_t k = 0; k < n; k++)
        largest = plan->multiplier[first + k] ? fmax(largest, f->scale[first + k]) : largest;
    for (ptrdiff_t k = 0; k < n; k++)
        noise[k] = noise_of(plan, f, first + k, 0)
                   + (plan->multiplier[first + k] ? YIELDING * compliance * largest : 0);
    cardan_sparse_signs(n, panel->d, noise, f);
}

/* The row with the smallest entries: column k has no pivot left, and the other rows are still needed
 * as pivots of later columns. */
static ptrdiff_t emptiest(ptrdiff_t k, const cardan_panel *panel)
{
    const ptrdiff_t n = panel->n, later = panel->later;
    ptrdiff_t smallest = k;
    double least = -1;

    for (ptrdiff_t i = k; i < n; i++) {
        double most = 0;
        for (ptrdiff_t j = k; j < n; j++)
            most = fmax(most, fabs(panel->d[i * n + j]));
        for (ptrdiff_t j = 0; j < later; j++)
            most = fmax(most, fabs(panel->u[i * later + j]));
        if (least < 0 || most < least)
            least = most, smallest = i;
    }
    return smallest;
}

/* The row of the pivot of column k, and the size to compare with the rounding error.
 *
 * Speed columns prefer speed rows and multiplier columns multiplier rows, unless the other kind has
 * a much larger entry. Within the kind the diagonal entry is preferred (`mate`).
 * The size matters for redundant constraints. If a constraint row makes an angle with sine s to the
 * rows before it, its pivot in a multiplier row shrinks by s^2, but in a speed row only by s. The
 * latter is squared, so that one threshold on s^2 serves both. is_multiplier: kind of each row.
 */
static ptrdiff_t pivot_of(const cardan_sparse *plan, const cardan_panel *panel, ptrdiff_t k,
                          const cardan_sparse_factors *f, double *size)
{
    const ptrdiff_t first = panel->first, n = panel->n;
    const double *column = panel->d + k;
    const int type = plan->multiplier[first + k] != 0;
    const double *is_multiplier = f->work;
    double most[2] = {-1, -1}, scale = f->scale[first + k];
    ptrdiff_t row[2] = {k, k};

    for (ptrdiff_t i = k; i < n; i++) {
        const double here = fabs(column[i * n]);
        const int kind = is_multiplier[i] != 0;
        if (here > most[kind])
            most[kind] = here, row[kind] = i;
    }
    *size = most[type];
    if (!(most[type] < EARLY * most[1 - type])) {
        const ptrdiff_t mate = f->exchanged[first + k];
        const double here = fabs(column[mate * n]);
        /* rows go with their columns unless one is much larger */
        return (is_multiplier[mate] != 0) == type && here >= PREFER * most[type] ? (*size = here, mate)
                                                                                 : row[type];
    }
    *size = type ? fmax(most[type], most[1 - type] * most[1 - type] / scale) : most[1 - type];
    return row[1 - type];
}

static void exchange(ptrdiff_t n, double *a, double *b)
{
    for (ptrdiff_t j = 0; j < n; j++) {
        const double swap = a[j];
        a[j] = b[j];
        b[j] = swap;
    }
}

/* Symmetric column choice among loop-closing multipliers: compare how much of each diagonal entry is
 * left of its original size. If column k has lost much more than another one, exchange the two. So
 * the rows that are most dependent come last and count as redundant; otherwise rows at a small angle
 * to each other would be kept and would magnify rounding errors. */
static void choose(const cardan_sparse *plan, const cardan_panel *panel, ptrdiff_t k,
                   cardan_sparse_factors *f)
{
    const ptrdiff_t first = panel->first, n = panel->n, later = panel->later;
    double *scale = f->scale + first, *d = panel->d;
    double most = fabs(d[k * n + k]) / (PREFER * scale[k]);
    const int32_t kind = plan->multiplier[first + k];
    ptrdiff_t best = k;

    for (ptrdiff_t j = k + 1; j < n && plan->multiplier[first + j] == kind; j++)
        if (fabs(d[j * n + j]) > most * scale[j])
            most = fabs(d[j * n + j]) / scale[j], best = j;
    if (best == k)
        return;
    f->exchanged[first + k] = (int32_t)best;
    for (ptrdiff_t i = 0; i < n; i++)
        exchange(1, d + i * n + k, d + i * n + best);
    exchange(later, panel->lt + k * later, panel->lt + best * later);
    exchange(1, scale + k, scale + best);
}

/* Original column, before the exchanges of `choose`, of the one that now has pivot k. */
static ptrdiff_t column_of(const cardan_panel *panel, ptrdiff_t k, const cardan_sparse_factors *f)
{
    for (ptrdiff_t j = k; j >= 0; j--) {
        const ptrdiff_t other = f->exchanged[panel->first + j];
        k = k == j ? other : k == other ? j : k;
    }
    return k;
}

/* Replace a pivot that is only rounding error, in a row of D, by a small number of known sign, negative for
 * multipliers as in a regular saddle-point matrix, and record the change. */
static int replace(const cardan_sparse *plan, const cardan_panel *panel, ptrdiff_t column,
                   ptrdiff_t row, double size, cardan_sparse_factors *f)
{
    const ptrdiff_t k = panel->first + column;
    double *pivot = panel->d + row * panel->n + column, scale = f->scale[k], small, replacement;

    /* if D had only zeros there, take the size from the rest of the row */
    for (ptrdiff_t j = row * panel->later; scale == 0 && j < (row + 1) * panel->later; j++)
        scale = fmax(fabs(panel->u[j]), fabs(panel->lt[j]));
    /* a constraint that no motion changes: its equation is empty, and any multiplier does */
    if (scale == 0 && plan->multiplier[k])
        scale = 1;
    small = fmax(REPLACEMENT * scale, plan->multiplier[k] ? BEYOND * size : 0);
    replacement = plan->multiplier[k] || *pivot < 0 ? -small : small;
    if (!(scale - scale == 0) || scale == 0 || !(*pivot - *pivot == 0) || f->weak == plan->n) {
        f->singular = plan->order[k];
        return CARDAN_SINGULAR;
    }
    f->shift[f->weak] = replacement - *pivot;
    f->replaced[f->weak++] = (int32_t)(panel->first + column_of(panel, column, f));
    *pivot = replacement;
    return CARDAN_OK;
}

/* Factor D with row exchanges P: P D = L R with unit lower L, and U becomes L^-1 P U. L and R replace
 * D; its diagonal keeps the reciprocals of the pivots. compliance: of rows that close loops, 0 as long
 * as no multiplier has lost its pivot. */
static int eliminate(const cardan_sparse *plan, const cardan_panel *panel, double compliance,
                     cardan_sparse_factors *f)
{
    const ptrdiff_t n = panel->n, later = panel->later;
    double *is_multiplier = f->work;

    for (ptrdiff_t k = 0; k < n; k++)
        is_multiplier[k] = plan->multiplier[panel->first + k];
    for (ptrdiff_t k = 0; k < n; k++) {
        double *row = panel->d + k * n, *below = row + n, *u = panel->u + k * later, *u_below = u + later;
        const ptrdiff_t place = panel->first + k;
        double most, inverse;
        ptrdiff_t pivot;

        f->exchanged[place] = (int32_t)k;
        if (plan->multiplier[place] == CLOSES)
            choose(plan, panel, k, f);
        pivot = pivot_of(plan, panel, k, f, &most);
        if (!(most > noise_of(plan, f, place, compliance))) {
            if (plan->multiplier[place] && compliance == 0)
                return REDUNDANT;
            pivot = emptiest(k, panel);
            if (replace(plan, panel, k, pivot, most, f))
                return CARDAN_SINGULAR;
        }
        f->pivot[place] = (int32_t)pivot;
        if (pivot != k) {
            exchange(n, row, panel->d + pivot * n);
            exchange(later, u, panel->u + pivot * later);
            exchange(1, is_multiplier + k, is_multiplier + pivot);
        }
        inverse = 1 / row[k];
        row[k] = inverse;
        if (!(inverse - inverse == 0)) {
            f->singular = plan->order[place];
            return CARDAN_SINGULAR;
        }
        for (ptrdiff_t i = k + 1; i < n; i++, below += n, u_below += later) {
            const double factor = below[k] * inverse;
            below[k] = factor;
            cardan_minus(n - k - 1, factor, row + k + 1, below + k + 1);
            cardan_minus(later, factor, u, u_below);
        }
    }
    return CARDAN_OK;
}

/* Lt = R^-T Lt with the upper factor R of D */
static void turn(const cardan_panel *panel)
{
    const ptrdiff_t n = panel->n, later = panel->later;

    for (ptrdiff_t k = 0; k < n; k++) {
        const double *row = panel->d + k * n;
        double *lt = panel->lt + k * later;
        for (ptrdiff_t j = 0; j < later; j++)
            lt[j] *= row[k];
        for (ptrdiff_t i = k + 1; i < n; i++)
            cardan_minus(later, row[i], lt, panel->lt + i * later);
    }
}

/* Subtract L U from the panels of later unknowns. */
static void hand_on(const cardan_sparse *plan, ptrdiff_t s, const cardan_panel *panel,
                    cardan_sparse_factors *f)
{
    const ptrdiff_t n = panel->n, later = panel->later;
    const double *u = panel->u, *lt = panel->lt;
    const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];
    const int32_t *target = plan->target + plan->target_start[s];

    for (const cardan_sparse_run *i = plan->run + plan->run_start[s]; i < end; i++)
        for (const cardan_sparse_run *j = plan->run + plan->run_start[s]; j < end; j++) {
            const int transposed = i->owner > j->owner;
            const ptrdiff_t owner = transposed ? j->owner : i->owner;
            /* of D within a supernode, of U or Lt between two */
            const ptrdiff_t stride = i->owner == j->owner ? plan->start[owner + 1] - plan->start[owner]
                                                          : plan->later[owner];
            double *to = f->values + *target++;
            /* the size of a diagonal entry before subtraction shows how much cancels */
            if (i == j)
                for (ptrdiff_t k = 0; k < i->size; k++) {
                    const double size = fabs(to[k * stride + k]);
                    double *scale = f->scale + i->place + k;
                    *scale = size > *scale ? size : *scale;
                }
            if (transposed)
                cardan_product(j->size, i->size, n, u + j->at, later, lt + i->at, later, to, stride);
            else
                cardan_product(i->size, j->size, n, lt + i->at, later, u + j->at, later, to, stride);
        }
}

/* Note how large rows that close loops are where they meet the unknowns of a supernode: what is left
 * of one at its own pivot may be the rounding of numbers that canceled on the way there. */
static void note_closing(const cardan_sparse *plan, ptrdiff_t s, const cardan_panel *panel,
                         cardan_sparse_factors *f)
{
    const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];

    for (const cardan_sparse_run *i = plan->run + plan->run_start[s]; i < end; i++)
        for (ptrdiff_t j = 0; j < i->size; j++) {
            const double *column = panel->u + i->at + j;
            double *scale = f->scale + i->place + j;
            for (ptrdiff_t k = 0; k < panel->n && plan->multiplier[i->place + j] == CLOSES; k++)
                *scale = fmax(*scale, fabs(column[k * panel->later]));
        }
}

ptrdiff_t cardan_sparse_work(const cardan_sparse *plan)
{
    return plan->n + plan->widest * plan->widest + 2 * plan->supernodes;
}

static int factor(const cardan_sparse *plan, const double *a, double compliance,
                  cardan_sparse_factors *f)
{
    double *sums = f->work + plan->n + plan->widest * plan->widest;

    f->weak = f->positive = f->negative = 0;
    f->singular = -1;
    if (f->certainty)
        f->certainty[CARDAN_SPARSE_LEFT] = 0;
    memset(sums, 0, 2 * (size_t)plan->supernodes * sizeof(double));
    for (ptrdiff_t s = 0; s < plan->supernodes; s++) {
        const cardan_panel panel = cardan_panel_of(plan, s, f->values);

        for (ptrdiff_t i = plan->open_start[s]; i < plan->open_start[s + 1]; i++)
            cardan_sparse_fill(plan, plan->open[i], a, f);
        /* original size of each pivot: the largest entry in its column of D, at least the size noted
         * when earlier supernodes were subtracted */
        for (ptrdiff_t i = 0; i < panel.n; i++)
            cardan_larger(panel.n, panel.d + i * panel.n, f->scale + panel.first);
        note_closing(plan, s, &panel, f);
        if (compliance > 0)
            comply(plan, &panel, compliance, f);
        if (f->count)
            count(plan, &panel, compliance, f);
        const int status = eliminate(plan, &panel, compliance, f);
        if (status != CARDAN_OK)
            return status;
        turn(&panel);
        if (f->certainty)
            cardan_sparse_bound(plan, s, &panel, sums, f->certainty + CARDAN_SPARSE_LEFT);
        hand_on(plan, s, &panel, f);
    }
    return CARDAN_OK;
}

int cardan_sparse_factor(const cardan_sparse *plan, const double *a, cardan_sparse_factors *f)
{
    const uint64_t mode = cardan_flush();
    int status;

    status = factor(plan, a, 0, f);
    if (status == REDUNDANT)
        status = factor(
            plan, a, f->compliance > 0 ? f->compliance : fmax(COMPLIANCE, HIDDEN * f->hidden), f);
    cardan_restore(mode);
    return status;
}
