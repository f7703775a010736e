/* How well constraints hold a motion, and where branches of it meet.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Rows of G count in units of their largest length so far, columns in sizes of the mechanism and
 * radians. Rows are orthogonalized one after the other, the longest that is left first; what is left
 * of the last row that holds at all is the hold: about the sine of its angle to the others. Where
 * branches meet it vanishes linearly, and what is left of its row turns round.
 * How many rows hold is remembered: a row is taken in where TAKEN of it is left, and stays in
 * however little that becomes, so that the rank does not flicker.
 * Source: G. H. Golub, C. F. Van Loan, Matrix Computations, section 5.4 (pivoted orthogonalization).
 */
#include "events.h"
#include <math.h>

static const real TAKEN = 1e-3;
static const real DOWNDATED = 1e-4; /* squares of lengths of rows, which begin at about 1 */
static const real BRANCHES_MEET = 0.1; /* of the best hold: less than that is left where branches meet */
static const real NEAR = 0.15;   /* of the best hold: looked further ahead */
static const real NEAR_SINGULAR = 0.02; /* of the best hold: states that are kept are projected */
static const real ROUNDING = CARDAN_ROUNDING(2e-16, 1e-7); /* of speeds, times the square of the hold */
static const real LOST = 1e-4;   /* of the best hold: branches meet here */
static const real AHEAD = 1.3;   /* steps that are looked ahead */
static const real STRIDE = 0.25; /* radians or sizes between two looks */
enum { HALVINGS = 10, MOST_LOOKS = 12 };

/* Numbers that are kept: three per row, entries of a row, a state, rows at two states. */
enum { LENGTHS, ORDER, SQUARES, ENTRIES, STATE, HERE, THERE };

ptrdiff_t cardan_rank_length(const cardan_run *run)
{
    return run->constraint_jacobian.function
               ? ENTRIES * run->rates + run->nu + run->n + 2 * run->rates * run->nu : 0;
}

static inline real *place(const cardan_run *run, int what)
{
    real *start = run->rank_memory + (what < ENTRIES ? what : ENTRIES) * run->rates;

    start += (what > ENTRIES ? run->nu : 0) + (what > STATE ? run->n : 0);
    return start + (what > HERE ? run->rates * run->nu : 0);
}

/* Whether the order that memory holds is one of rows. */
int cardan_rank_sound(const cardan_run *run)
{
    return !run->constraint_jacobian.function
           || cardan_places_fit(place(run, ORDER), run->rates, 0, (real)(run->rates - 1));
}

/* Row k in the order. */
static inline real *row_of(const cardan_run *run, int what, ptrdiff_t k)
{
    return place(run, what) + (ptrdiff_t)place(run, ORDER)[k] * run->nu;
}

/* The state at t + tau: on with the present slope, bent as the last step was. */
static const real *ahead(cardan_run *run, real tau)
{
    real *y = place(run, STATE), h = run->t - run->t_old;

    for (ptrdiff_t i = 0; i < run->n; i++) {
        real bend = h != 0 ? (run->f[i] - (run->y[i] - run->y_old[i]) / h) / h : 0;
        y[i] = run->y[i] + tau * (run->f[i] + tau * bend);
    }
    cardan_normalize(run, y);
    return y;
}

/* Rows of G at t, y, without units, with their squares; lengths count from states that are `taken`. */
static int jacobian(cardan_run *run, real t, const real *y, real *rows, int taken)
{
    real *lengths = place(run, LENGTHS), *squares = place(run, SQUARES);
    cardan_in in = cardan_at(run, &t, y);
    int status;

    cardan_signals_at(run, t);
    status = cardan_call_model(run, &run->constraint_jacobian, &in, rows);
    for (ptrdiff_t i = 0; i < run->rates && status == 0; i++) {
        real *row = rows + i * run->nu;
        for (ptrdiff_t j = 0; j < run->nu && run->columns; j++)
            row[j] *= run->columns[j];
        squares[i] = cardan_dot(row, row, run->nu);
        /* of elements most rows are used up by what joints carry */
        if (squares[i] == 0)
            continue;
        if (taken)
            lengths[i] = fmax(lengths[i], sqrt(squares[i]));
        if (!(lengths[i] > 0))
            continue;
        for (ptrdiff_t j = 0; j < run->nu; j++)
            row[j] /= lengths[i];
        squares[i] /= lengths[i] * lengths[i];
    }
    return status;
}

/* Square of the length of a row. */
static real square(const cardan_run *run, int what, ptrdiff_t k)
{
    const real *row = row_of(run, what, k);

    return cardan_dot(row, row, run->nu);
}

/* Put the longest of the rows from k on at place k of the order. */
static void choose(const cardan_run *run, ptrdiff_t k)
{
    real *order = place(run, ORDER), *squares = place(run, SQUARES), longest = -1;
    const real swapped = order[k];
    ptrdiff_t best = k;

    for (ptrdiff_t i = k; i < run->rates; i++)
        if (squares[(ptrdiff_t)order[i]] > longest) {
            longest = squares[(ptrdiff_t)order[i]];
            best = i;
        }
    order[k] = order[best];
    order[best] = swapped;
}

/* Entries of a row that are not zero: rows of joints reach a few speeds alone. Returns how many. */
static ptrdiff_t list_entries(const cardan_run *run, const real *row)
{
    real *entries = place(run, ENTRIES);
    ptrdiff_t count = 0;

    for (ptrdiff_t j = 0; j < run->nu; j++)
        if (row[j] != 0)
            entries[count++] = (real)j;
    return count;
}

/* Take from rows after place k of the order what that row, of a square length, has. */
static void take_out(const cardan_run *run, int what, ptrdiff_t k, real length)
{
    const real *row = row_of(run, what, k), *entries = place(run, ENTRIES);
    const ptrdiff_t count = list_entries(run, row);

    for (ptrdiff_t i = k + 1; i < run->rates; i++) {
        real *other = row_of(run, what, i), share = 0;
        real *left = place(run, SQUARES) + (ptrdiff_t)place(run, ORDER)[i];

        if (*left == 0)
            continue;
        for (ptrdiff_t e = 0; e < count; e++)
            share += row[(ptrdiff_t)entries[e]] * other[(ptrdiff_t)entries[e]];
        if (share == 0)
            continue;
        share /= length;
        for (ptrdiff_t e = 0; e < count; e++)
            other[(ptrdiff_t)entries[e]] -= share * row[(ptrdiff_t)entries[e]];
        /* what is left is measured anew where the difference would be rounding */
        *left -= share * share * length;
        if (!(*left > DOWNDATED))
            *left = square(run, what, i);
    }
}

/* Take from every row what those before it in the order have; `anew`: the order is chosen too.
 *
 * Returns the hold. `taken`: rows that hold are taken in; off the constraints all of them may.
 */
static real orthogonalize(cardan_run *run, int what, int anew, int taken)
{
    real rank_margin = 0;

    for (ptrdiff_t k = 0; k < run->rates; k++) {
        real length;

        if (anew)
            choose(run, k);
        length = square(run, what, k);
        if (taken && k >= run->constraint_rank && length > TAKEN * TAKEN) {
            run->constraint_rank = k + 1;
            run->ranks++;
        }
        if (k >= run->constraint_rank)
            break;
        rank_margin = sqrt(length);
        if (length > 0)
            take_out(run, what, k, length);
    }
    return rank_margin;
}

/* The hold at t + tau, with rows in the best order there: the reference for `branch_reversed`. */
static real rank_margin_at(cardan_run *run, real tau)
{
    const real *y = tau == 0 ? run->y : ahead(run, tau);

    if (jacobian(run, run->t + tau, y, place(run, HERE), tau == 0) != 0)
        return NAN;
    return orthogonalize(run, HERE, 1, tau == 0);
}

/* Whether what is left of a row has turned round between the reference and t + tau. */
static int branch_reversed(cardan_run *run, real tau)
{
    if (jacobian(run, run->t + tau, ahead(run, tau), place(run, THERE), 0) != 0)
        return 0;
    orthogonalize(run, THERE, 0, 0);
    for (ptrdiff_t k = 0; k < run->constraint_rank; k++)
        if (cardan_dot(row_of(run, HERE, k), row_of(run, THERE, k), run->nu) < 0)
            return 1;
    return 0;
}

/* Whether branches meet so near to t, y that a projection would bring in more than it mends.
 *
 * Rounding is magnified in speeds by the inverse square of the hold. `projected`: the run goes on from
 * the state, which has to be closed as long as that makes sense.
 */
int cardan_near_singular(cardan_run *run, real t, const real *y, int projected)
{
    const real rough = sqrt(ROUNDING / cardan_finest(run));
    real rank_margin;

    if (jacobian(run, t, y, place(run, HERE), 0) != 0)
        return 1;
    rank_margin = orthogonalize(run, HERE, 1, 0);
    return !(rank_margin > fmin(rough, projected ? NEAR_SINGULAR * run->best_rank_margin : 1));
}

/* How fast the state moves now or at t + tau: radians or sizes per second. */
static real pace(const cardan_run *run, real tau)
{
    real fastest = 0;

    for (ptrdiff_t j = 0; j < run->nu; j++) {
        real now = run->y[run->nq + j], then = now + tau * run->f[run->nq + j];
        real unit = run->columns ? run->columns[j] : 1;
        fastest = fmax(fastest, fmax(fabs(now), fabs(then)) / unit);
    }
    return fastest;
}

/* Where between t + from and t + to a row turns round; the reference is that of `from`. */
static real bisect(cardan_run *run, real from, real to)
{
    for (int k = 0; k < HALVINGS; k++) {
        real middle = 0.5 * (from + to);
        if (branch_reversed(run, middle))
            to = middle;
        else
            from = middle;
    }
    return 0.5 * (from + to);
}

/* The hold before the first step: rows that hold a little later count too. */
void cardan_first_rank(cardan_run *run)
{
    real h = fmin(0.1 * STRIDE / fmax(pace(run, 0), 1e-300), fabs(run->until - run->t));
    real *y = place(run, STATE);

    for (ptrdiff_t k = 0; k < run->rates; k++)
        place(run, ORDER)[k] = (real)k;
    run->constraint_rank = 0;
    run->rank_margin = rank_margin_at(run, 0);
    h = copysign(h, run->until - run->t);
    (void)ahead(run, h);
    if (cardan_close(run, run->t + h, y, 0) == 0 && jacobian(run, run->t + h, y, place(run, HERE), 1) == 0)
        run->best_rank_margin = orthogonalize(run, HERE, 1, 1);
    run->rank_margin = rank_margin_at(run, 0);
    run->best_rank_margin = fmax(run->best_rank_margin, run->rank_margin);
    run->ranks = 0;
}

/* Look for a place where branches meet, about as far ahead as a step or two lead.
 *
 * Returns 1 with `tau`, the time until then, or 0.
 */
int cardan_branches_meet(cardan_run *run, real *tau)
{
    const real left = run->until - run->t;
    const real reach = AHEAD * fmin(fabs(run->h), fabs(left)), v = pace(run, copysign(reach, left));
    real from = 0, falling = 0, before, rank_margin, last;

    if (v == 0)
        return 0;
    /* as long as it cannot be lost it is not looked for */
    before = run->rank_margin;
    run->rank_margin = last = rank_margin_at(run, 0);
    run->best_rank_margin = fmax(run->best_rank_margin, last);
    *tau = 0;
    if (last < LOST * run->best_rank_margin)
        return 1;
    if (run->t != run->t_old)
        falling = (last - before) / fabs(run->t - run->t_old);
    if (last + falling * reach - 0.5 * run->best_rank_margin * v * v * reach * reach > NEAR * run->best_rank_margin)
        return 0;
    for (int k = 0; k < MOST_LOOKS; k++) {
        real to = from + copysign(STRIDE / v, left);
        if (fabs(to) > reach && run->rank_margin > NEAR * run->best_rank_margin) {
            if (fabs(from) >= reach)
                return 0;
            to = copysign(reach, left);
        }
        if (branch_reversed(run, to)) {
            *tau = bisect(run, from, to);
            if (rank_margin_at(run, *tau) < BRANCHES_MEET * run->best_rank_margin)
                return 1;
        }
        rank_margin = rank_margin_at(run, to);
        /* from near by on the way out */
        if (fabs(to) >= reach && !(rank_margin < last))
            return 0;
        from = to;
        last = rank_margin;
    }
    return 0;
}

/* The time [s] in which the state moves by a radian or size. */
real cardan_span(const cardan_run *run)
{
    return 1 / pace(run, 0);
}

/* The constraint that is lost where branches meet. */
ptrdiff_t cardan_weakest(const cardan_run *run)
{
    return run->constraint_rank > 0 ? (ptrdiff_t)place(run, ORDER)[run->constraint_rank - 1] : 0;
}
