/* Position solver: closes kinematic loops exactly and meets targets as well as possible.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Each iteration computes a constrained Gauss-Newton step (least.c) for hard residuals, which must
 * vanish, and soft residuals, whose weighted sum of squares is minimized. The step is shortened
 * until the merit function  |soft|^2 / 2 + price |hard|  decreases; the price exceeds all
 * multipliers, so hard residuals always win (the norm of |hard| is the sum of magnitudes). The solver returns after a budget of iterations and
 * can be resumed, so that Ctrl-C works.
 * Source: J. Nocedal, S. Wright, Numerical Optimization, 2nd ed., chapter 18 (merit functions).
 */
#include "position.h"
#include <math.h>

/* residual to aim for; largest residual of a closed loop */
static const real SOUGHT = 1e-15, CLOSED = 1e-11;
/* a cosine of axes that is 0 but for rounding: they are exchanged, not kept */
static const real SIGN_TOL = 1e-6;
/* least and greatest length of a step, in radians or sizes of the mechanism */
static const real LEAST_STEP = 1e-13, LONGEST = 0.7;
static const real FIRST_DAMPING = 1e-3, LEAST_DAMPING = 1e-12, SHORTER = 0.3;
enum { MOST_STEPS = 80, MOST_TRIALS = 12 };

/* arrays within the workspace */
typedef struct parts {
    real *trial;     /* (nq) */
    real *residuals; /* (hard + soft) of the trial */
    real *step;      /* (nu) */
    real *speeds;    /* (nu) */
    real *results;   /* of a model function */
    real *rates;     /* (nq, nu) derivative of q along the step */
    real *least;
} parts;

/* Size of the largest function result, or of two coordinate vectors. */
static ptrdiff_t widest(const cardan_position *p)
{
    return cardan_larger_of(cardan_larger_of(p->positions, p->assembly_sign_count), 2 * p->nq);
}

/* Size of the workspace of a search. */
ptrdiff_t cardan_position_length(const cardan_position *p)
{
    return p->nq * (1 + p->nu) + p->hard + p->soft + 2 * p->nu + widest(p)
           + cardan_least_length(p->hard, p->soft, p->nu);
}

static parts parts_of(const cardan_position *p)
{
    parts m = {.trial = p->memory};

    m.residuals = m.trial + p->nq;
    m.step = m.residuals + p->hard + p->soft;
    m.speeds = m.step + p->nu;
    m.results = m.speeds + p->nu;
    m.rates = m.results + widest(p);
    m.least = m.rates + p->nq * p->nu;
    return m;
}

/* Call a model function. `along` is passed as u and as du: some functions take the one, some the other. */
static int call(const cardan_position *p, const cardan_call *function, const real *q,
                const real *along, real *out)
{
    const cardan_in in = {.t = &p->t, .q = q, .u = along, .z = p->z, .s = p->s, .r = p->r,
                          .w = function->w, .du = along};

    return function->function(&in, out, p->work);
}

/* Coordinates after a step along the speeds, with unit quaternions. */
static int advance(const cardan_position *p, const real *q, const real *step, real *moved)
{
    const parts m = parts_of(p);
    int status;

    for (ptrdiff_t i = 0; i < p->nu; i++)
        m.speeds[i] = step[i] * (p->columns ? p->columns[i] : 1);
    status = call(p, &p->integrate, q, m.speeds, moved);
    for (ptrdiff_t k = 0; k < p->quaternion_count; k++) {
        real *x = moved + p->quaternions[k];
        const real length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
        for (int i = 0; i < 4; i++)
            x[i] /= length;
    }
    return status;
}

/* Residuals (rows) of a target, times its weight if it is soft. */
static int target_residual(const cardan_position *p, const cardan_target *target, const real *q,
                           real *residual)
{
    int status = 0;

    if (!target->residual.function)
        for (ptrdiff_t i = 0; i < target->rows; i++)
            residual[i] = (q[target->entries[i]] - target->value[i]) / target->scale[i];
    else
        status = call(p, &target->residual, q, NULL, residual);
    for (ptrdiff_t i = 0; i < target->rows && target->weight >= 0; i++)
        residual[i] *= target->weight;
    return status;
}

/* First row of a target: hard rows (constraints, then hard targets) come before soft ones. */
static ptrdiff_t place_of(const cardan_position *p, ptrdiff_t number)
{
    const int soft = p->targets[number].weight >= 0;
    ptrdiff_t place = soft ? p->hard : p->hard_count;

    for (ptrdiff_t k = 0; k < number; k++)
        if ((p->targets[k].weight >= 0) == soft)
            place += p->targets[k].rows;
    return place;
}

/* All residuals at coordinates q, constraints divided by their units. Returns a model status. */
static int residuals_at(const cardan_position *p, const real *q, real *residuals)
{
    real *open = parts_of(p).results;
    int status = 0;

    if (p->hard_count > 0)
        status = call(p, &p->constraints, q, NULL, open);
    for (ptrdiff_t i = 0; i < p->hard_count; i++) {
        const ptrdiff_t row = p->hard_rows ? p->hard_rows[i] : i;
        residuals[i] = open[row] / (p->rows ? p->rows[row] : 1);
    }
    for (ptrdiff_t k = 0; k < p->target_count; k++)
        status |= target_residual(p, p->targets + k, q, residuals + place_of(p, k));
    return status;
}

/* Derivative of q along the step (nq, nu), column by column since qdot is linear in u. */
static int kinematics(const cardan_position *p, real *rates)
{
    const parts m = parts_of(p);
    real *still = m.results, *moving = m.results + p->nq;
    int status;

    if (p->kinematics.function)
        return call(p, &p->kinematics, p->q, NULL, rates);
    for (ptrdiff_t j = 0; j < p->nu; j++)
        m.speeds[j] = 0;
    status = call(p, &p->qdot, p->q, m.speeds, still);
    for (ptrdiff_t j = 0; j < p->nu; j++) {
        m.speeds[j] = p->columns ? p->columns[j] : 1;
        status |= call(p, &p->qdot, p->q, m.speeds, moving);
        m.speeds[j] = 0;
        for (ptrdiff_t i = 0; i < p->nq; i++)
            rates[i * p->nu + j] = moving[i] - still[i];
    }
    return status;
}

/* Jacobian (rows, nu) of the residuals of a target. */
static int target_jacobian(const cardan_position *p, const cardan_target *target,
                           const real *rates, real *jacobian)
{
    const ptrdiff_t nu = p->nu;
    int status = 0;

    if (!target->jacobian.function)
        for (ptrdiff_t i = 0; i < target->rows; i++)
            for (ptrdiff_t j = 0; j < nu; j++)
                jacobian[i * nu + j] = rates[target->entries[i] * nu + j] / target->scale[i];
    else
        status = call(p, &target->jacobian, p->q, NULL, jacobian);
    for (ptrdiff_t i = 0; i < target->rows * nu && target->weight >= 0; i++)
        jacobian[i] *= target->weight;
    return status;
}

/* All residuals at q. Returns a model status. */
int cardan_position_residuals(cardan_position *p)
{
    return residuals_at(p, p->q, p->residuals);
}

/* Jacobian of all residuals along steps at q. Returns a model status. */
int cardan_position_jacobian(cardan_position *p)
{
    const ptrdiff_t nu = p->nu;
    real *rates = parts_of(p).rates;
    int status = 0, moved = 0;

    /* compact the selected constraint rows in place: row i <= hard_rows[i], so none is overwritten
     * before it is read */
    if (p->hard_count > 0)
        status = call(p, &p->constraint_jacobian, p->q, NULL, p->jacobian);
    for (ptrdiff_t i = 0; i < p->hard_count; i++) {
        const ptrdiff_t row = p->hard_rows ? p->hard_rows[i] : i;
        const real unit = p->rows ? p->rows[row] : 1;
        for (ptrdiff_t j = 0; j < nu; j++)
            p->jacobian[i * nu + j] = p->jacobian[row * nu + j]
                                      * (p->columns ? p->columns[j] : 1) / unit;
    }
    for (ptrdiff_t k = 0; k < p->target_count; k++) {
        const cardan_target *target = p->targets + k;
        if (!target->jacobian.function && !moved) {
            status |= kinematics(p, rates);
            moved = 1;
        }
        status |= target_jacobian(p, target, rates, p->jacobian + place_of(p, k) * nu);
    }
    return status;
}

/* Largest absolute entry; infinite if one is not finite. */
static real size_of(const real *residuals, ptrdiff_t n)
{
    real largest = 0;

    for (ptrdiff_t i = 0; i < n; i++) {
        if (!(residuals[i] - residuals[i] == 0))
            return INFINITY;
        largest = fmax(largest, fabs(residuals[i]));
    }
    return largest;
}

static real square(const real *x, ptrdiff_t n)
{
    real sum = 0;

    for (ptrdiff_t i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sum;
}

static real merit(const cardan_position *p, const real *residuals, real price)
{
    return 0.5 * square(residuals + p->hard, p->soft) + price * sqrt(square(residuals, p->hard));
}

/* Backtracking line search: shorten the step until the merit decreases. Returns whether it does. */
static int take(cardan_position *p, real price, real longest)
{
    const parts m = parts_of(p);
    const real before = merit(p, p->residuals, price);
    real share = longest > LONGEST ? LONGEST / longest : 1;

    /* never farther than LONGEST, so that the solution stays near the start */
    for (int trial = 0; trial < MOST_TRIALS; trial++) {
        for (ptrdiff_t j = 0; j < p->nu; j++)
            m.step[j] *= share;
        if (advance(p, p->q, m.step, m.trial) == 0
            && residuals_at(p, m.trial, m.residuals) == 0
            && merit(p, m.residuals, price) < before) {
            for (ptrdiff_t i = 0; i < p->nq; i++)
                p->q[i] = m.trial[i];
            for (ptrdiff_t i = 0; i < p->hard + p->soft; i++)
                p->residuals[i] = m.residuals[i];
            /* full step accepted: reduce the damping of the soft step; shortened: increase it */
            p->damping = trial == 0 && share == 1 ? fmax(LEAST_DAMPING, 0.2 * p->damping)
                                                  : 2 * p->damping;
            return 1;
        }
        share = SHORTER;
    }
    return 0;
}

/* Start a search at q after normalizing its quaternions. Returns a model status. */
int cardan_position_begin(cardan_position *p)
{
    const parts m = parts_of(p);
    int status;

    p->iteration = 0;
    p->damping = FIRST_DAMPING;
    p->freedoms = p->nu;
    p->wrong_sign = -1;
    for (ptrdiff_t j = 0; j < p->nu; j++)
        m.step[j] = 0;
    status = advance(p, p->q, m.step, m.trial);
    for (ptrdiff_t i = 0; i < p->nq; i++)
        p->q[i] = m.trial[i];
    return status | residuals_at(p, p->q, p->residuals);
}

/* Report the result: largest hard residual, cost, and the first axis with the wrong sign. */
static int ended(cardan_position *p)
{
    real *values = parts_of(p).results;

    p->open = size_of(p->residuals, p->hard);
    p->cost = square(p->residuals + p->hard, p->soft);
    if (p->assembly_sign_count > 0 && p->open <= fmax(CLOSED, p->residual_noise)
        && call(p, &p->assembly_signs, p->q, NULL, values) == 0)
        for (ptrdiff_t i = p->assembly_sign_count - 1; i >= 0; i--)
            if (values[i] <= SIGN_TOL)
                p->wrong_sign = i;
    return CARDAN_DONE;
}

/* Continue a search for at most `budget` iterations. Returns CARDAN_DONE if it has converged or cannot
 * proceed (the record says how far it got), otherwise CARDAN_MORE. */
int cardan_position_solve(cardan_position *p, ptrdiff_t budget)
{
    const parts m = parts_of(p);

    for (; p->iteration < MOST_STEPS; p->iteration++) {
        cardan_least least = {.hard = p->hard, .soft = p->soft, .nu = p->nu,
                              .jacobian = p->jacobian, .residuals = p->residuals,
                              .rank = p->rank, .damping = p->damping, .memory = m.least};
        real longest;

        if (budget-- <= 0)
            return CARDAN_MORE;
        /* linearize; stop where the model or a number fails */
        if (cardan_position_jacobian(p) != 0
            || size_of(p->jacobian, (p->hard + p->soft) * p->nu) == INFINITY
            || size_of(p->residuals, p->hard + p->soft) == INFINITY)
            break;
        cardan_least_step(&least, m.step);
        p->freedoms = least.freedoms;
        longest = size_of(m.step, p->nu);
        if (size_of(p->residuals, p->hard) <= SOUGHT && longest <= LEAST_STEP)
            break;
        /* twice the penalty weight makes the step a descent direction of the merit */
        if (!take(p, 2 * least.price, longest))
            break;
    }
    return ended(p);
}
