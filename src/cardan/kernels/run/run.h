/* One run of an integrator: the record that init, step and interpolate work on.
 *
 * Part of cardan. The caller owns the record and every array it points to; nothing here allocates
 * or keeps state elsewhere, so that copying record and arrays is a checkpoint. Sizes are signed;
 * cardan_run_start looks at them once, and no product of them overflows after that.
 *
 * The integrated vector is y = [x, e], n = nx + sources long: the state x = [q, u, z], z what elements
 * keep themselves, and the energy e [J] that every source has given since the start. e is a quadrature: it takes no part in the error
 * control.
 *
 * Where loops are closed by constraints, every state that is kept is projected onto them first:
 * positions, then velocities. The projection takes part in the error control. Where branches of the
 * motion meet, one step leads over the place whatever the method: see constraint_rank.c and singular_crossing.c.
 */
#ifndef CARDAN_RUN_H
#define CARDAN_RUN_H

#include "cardan.h"
#include <math.h>
#include <stddef.h>

typedef struct cardan_run cardan_run;

/* A function of the model with its prepared parameters; `function` is NULL where there is none. */
typedef struct cardan_call {
    cardan_function function;
    const wreal *w;
} cardan_call;

/* Many products at one state of elements: what is solved and factored there stays in a room. */
typedef struct cardan_repeated {
    int (*enter)(const cardan_in *in, real *room);  /* `in` as the product reads it but for v */
    int (*pull)(real *room, const real *v, real *out);
    int (*push)(real *room, const real *v, real *out);
} cardan_repeated;

/* what an integrator says: not negative: the run may go on or is over; negative: it broke down */
enum {
    CARDAN_DONE = 0,
    CARDAN_MORE = 1,       /* the budget of steps is spent */
    CARDAN_FULL = 2,       /* no room for another row */
    CARDAN_STOPPED = 3,    /* somebody set `stop` */
    CARDAN_EVENT = 4,      /* an event ended the run */
    CARDAN_NOT_FINITE = -1,
    CARDAN_TOO_SMALL = -2, /* the step size fell below what t can resolve */
    CARDAN_MODEL = -3,     /* a generated function returned a status */
    CARDAN_INPUT = -4,     /* the callback of the inputs returned a status */
    CARDAN_SIZE = -5,      /* a size is negative, or no array can have it */
    CARDAN_CONSTRAINT_OPEN = -6,      /* no state near the step fulfills the constraints: see `open_row` */
    CARDAN_ROTATION_TOO_LARGE = -7,    /* a rotation in one step is larger than its chart */
    CARDAN_UNSOLVED = -8,  /* the equations of an implicit step were not solved */
    CARDAN_EVENT_LIMIT = -9,     /* events go on and on at one time */
    CARDAN_CHATTER = -10,  /* an event happens ever again within no time to speak of */
    CARDAN_ROTATION_UNRESOLVED = -11  /* a given step does not tell how coordinates of a rotation turn */
};

/* What happens where the value of an event falls through zero. An event of the first four kinds is
 * due as well where its value is negative without having fallen. */
enum {
    CARDAN_MODE = 0,   /* other discrete states */
    CARDAN_IMPACT = 1, /* other speeds */
    CARDAN_TICK = 2,   /* at known times, whatever its value: see cardan_tick */
    CARDAN_END = 3,    /* the run is over */
    CARDAN_MARK = 4,   /* nothing: it is noted */
    CARDAN_HALT = 5    /* the run is over, if the value falls */
};

/* An event at the times phase + k period. */
typedef struct cardan_tick {
    ptrdiff_t event;
    real period, phase;
    ptrdiff_t count; /* k of the next one */
    real next;       /* when that is */
} cardan_tick;
/* dense output: no more rows than that */
enum { CARDAN_MOST_ROWS = 16 };

/* An input given by pieces: ((c3 d + c2) d + c1) d + c0 with d = t - breaks[where]. */
typedef struct cardan_signal {
    ptrdiff_t input;          /* index in r */
    ptrdiff_t pieces;
    ptrdiff_t where;          /* piece of the present segment */
    const real *breaks;       /* (pieces + 1), ascending; two equal ones are a jump */
    const real *coefficients; /* (pieces, 4): c0 c1 c2 c3 */
} cardan_signal;

struct cardan_run {
    /* the method */
    int (*init)(cardan_run *run);
    int (*step)(cardan_run *run);
    int (*dense)(cardan_run *run);
    ptrdiff_t (*length)(const cardan_run *run); /* of its own memory */

    /* the model */
    cardan_call rhs;
    cardan_call power; /* of every source */
    /* those that some methods need, by their record in Python */
    cardan_call energy;       /* kinetic, potential, total */
    cardan_call rhs_jacobian; /* d rhs / d x (nx, nx), / d t (nx), / d r (nx, nr) */
    cardan_call balance;         /* M udot + h - f - Gᵀ lam (nu), g, G u + g_t */
    cardan_call balance_tangent; /* its derivatives along q, u, udot (nu, nu), of the rates along
                                    q, G (rates, nu) */
    cardan_call internal_rates;  /* zdot (nz) */
    cardan_call move;            /* q moved along the speeds (nq), tangent (nu, nu) */
    cardan_call qdot;
    const struct cardan_mesh *mesh; /* elements in tables, NULL: functions know the whole model */
    const real *options; /* numbers that the method was made with, by its record in Python */
    int (*inputs)(void *context, real t, const real *x, real *r); /* NULL if no input is a function */
    void *input_context; /* what `inputs` works on */
    cardan_signal *signals;
    const ptrdiff_t *quaternions; /* first entry of each in q */
    ptrdiff_t nq, nu, nz, nx, n, nr, ns; /* nx = nq + nu + nz */
    ptrdiff_t signal_count, quaternion_count;
    const ptrdiff_t *bounded; /* coordinates of rotations that are singular somewhere */
    ptrdiff_t bounded_count;
    ptrdiff_t sampled; /* 1: `inputs` is asked at the start of a segment, not at every stage */
    ptrdiff_t charted; /* 1: an explicit method takes quaternions by their increments: chart.c */

    /* constraints: each function writes the closed block, then the residuals of the given one */
    cardan_call close_position; /* q (nq), residuals (positions) */
    cardan_call close_velocity; /* u (nu), residuals (rates) */
    cardan_call constraint_jacobian; /* G (rates, nu) */
    const real *columns;        /* (nu) what speeds count in, NULL if all count in 1 */
    ptrdiff_t positions, rates;
    real size; /* of the mechanism [m], against which residuals count */

    /* events: (ne) values of the model, then (watched) of the user */
    cardan_call events;     /* (ne): what falls through zero */
    cardan_call transition; /* u, z, s after the events in `e` */
    int (*watch)(real t, const real *x, real *values); /* (watched), NULL without */
    const ptrdiff_t *kinds; /* (ne + watched) */
    cardan_tick *ticks;
    ptrdiff_t ne, watched, tick_count;

    /* memory */
    real *y;        /* (n) at t */
    real *y_old;    /* (n) at t_old, the start of the last step */
    real *trial;    /* (n) */
    real *k;        /* (stages, n) derivatives of the last step */
    real *f;        /* (n) derivative at t, y; valid while `fresh` */
    real *r;        /* (nr) inputs as last asked for */
    real *s;        /* (ns) discrete states, constant between events */
    real *interpolant;   /* (dense_rows, n) dense output of the last step; valid while `is_dense`; if
                       charted, of the increments of quaternions */
    const real *zeros; /* zeros for the blocks tau and wrench */
    real *work;     /* work of the functions of the model */
    real *closing;  /* cardan_closing_length(run) numbers, NULL without constraints */
    real *chart;    /* cardan_chart_length(run) numbers, NULL unless charted */
    real *rank_memory;  /* cardan_rank_length(run) numbers */
    real *crossing;  /* cardan_crossing_length(run) numbers */
    real *method_memory; /* memory of the method: cardan_<method>_length(run) numbers; the first are
                       lam (2, nlam) at t_old and t, if the method finds multipliers itself */
    real *e;        /* (ne + watched) 1: happens at t */
    real *board;    /* cardan_board_length(run) numbers: what is known of the events */
    real *ledger;   /* (positions + rates, 4): the largest residual before projection and when,
                       the largest after it and when; NULL without constraints */
    ptrdiff_t stages, dense_rows;

    /* time: a segment ends where an input has a corner; the last one ends the run */
    const real *stops; /* (stop_count), the last one is the end */
    ptrdiff_t stop_count, next_stop;
    real t, t_old, t_start;
    real segment; /* start of the present segment */
    real until;   /* where a step must end: the next stop or tick */
    /* first and last time inside it, from where what jumps at its ends is seen */
    real early, late;
    ptrdiff_t jumps;  /* 1: the model jumps at times */
    ptrdiff_t in_segment; /* steps since then; 0: what a method remembers of the past is void */
    ptrdiff_t begun; /* 1: but what it began at the present state, with `init` */

    /* step size control */
    real rtol, atol, max_step;
    real h; /* next step, signed */
    real moment; /* in which the state at the start does something: beside t = 0 what counts as time */
    real error_before; /* of the last step of an explicit method, in units of tolerance; 1 before any */
    real correction; /* what the projection of the last trial changed, in units of tolerance */
    ptrdiff_t fresh, is_dense, rejected;
    ptrdiff_t on_grid; /* 1: every step is h long */

    /* places where branches meet */
    real rank_margin, best_rank_margin;     /* how well constraints hold at the present state, and at best */
    real pass_start, pass_length; /* of the step that leads over one of them */
    ptrdiff_t constraint_rank, ranks;    /* constraints that hold; how often their number has changed */
    ptrdiff_t pass_points, pass_part, pass_parts;
    real *passes; /* (pass_capacity, 3) of such steps: start, length, points; NULL: not noted */
    ptrdiff_t pass_capacity, pass_count; /* count: of all, beyond the capacity too */

    /* rows that come out: t, y, r, s, lam */
    real *rows;    /* (capacity, 1 + n + nr + ns + nlam) */
    ptrdiff_t nlam; /* 0 unless the method finds multipliers itself */
    real *spreads; /* (capacity, dense_rows, n), NULL if only `times` are wanted */
    const struct cardan_method *later; /* NULL; else spreads: (capacity, source_rows + 1, n) */
    const real *times; /* (time_count) wanted times, NULL for a row at every step */
    ptrdiff_t time_count, next_time;
    ptrdiff_t capacity, count;
    ptrdiff_t row_open; /* 1: a row for the last step is due; 2: one for what an event changed */

    /* events that come out: t, e, then [x, s] before and after */
    real *log; /* (log_capacity, 1 + ne + watched + 2 (nx + ns)) */
    ptrdiff_t log_capacity, log_count;
    ptrdiff_t event_pending; /* 1: the events in `e` wait for their transition */
    ptrdiff_t at_once;  /* transitions at t so far */
    ptrdiff_t occurred; /* events so far */

    /* counters and answers */
    ptrdiff_t steps, rejections, evaluations;
    ptrdiff_t budget;      /* steps per call of cardan_run_drive */
    ptrdiff_t culprit;     /* entry of y that broke the run, -1 if none is to blame */
    ptrdiff_t model_status;
    ptrdiff_t open_row;    /* row of the ledger that was open last, -1 if none was */
    ptrdiff_t projections; /* calls of the functions that close */
    ptrdiff_t passed;      /* places where branches meet */
    ptrdiff_t looked, limited; /* steps that explicit methods looked at; those stability limited */
    ptrdiff_t jacobians, factorizations; /* of the implicit methods */
    volatile ptrdiff_t stop; /* set by anybody at any time */
};

/* Fill in what every call reads at t, y (n), but for its parameters. */
static inline cardan_in cardan_at(const cardan_run *run, const real *t, const real *y)
{
    cardan_in in = {0};

    in.t = t;
    if (run->jumps) {
        const real way = run->late - run->early;
        if ((*t - run->early) * way < 0)
            in.t = &run->early;
        else if ((run->late - *t) * way < 0)
            in.t = &run->late;
    }
    in.q = y;
    in.u = y + run->nq;
    in.z = y + run->nq + run->nu;
    in.s = run->s;
    in.r = run->r;
    in.tau = in.wrench = run->zeros;
    return in;
}

/* Call a function of the model; a status it returns stays in `model_status`. */
static inline int cardan_call_model(cardan_run *run, const cardan_call *call, cardan_in *in,
                                    real *out)
{
    in->w = call->w;
    run->model_status = call->function(in, out, run->work);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* Whether numbers that serve as places lie in least ... most; memory may come from a file. */
static inline int cardan_places_fit(const real *x, ptrdiff_t count, real least, real most)
{
    for (ptrdiff_t i = 0; i < count; i++)
        if (!(x[i] >= least && x[i] <= most))
            return 0;
    return 1;
}

/* The next part of a block; a NULL block is only measured. */
static inline real *cardan_reserve(real *block, ptrdiff_t *used, ptrdiff_t size)
{
    real *start = block ? block + *used : NULL;

    *used += size;
    return start;
}

static inline real cardan_dot(const real *a, const real *b, ptrdiff_t n)
{
    real sum = 0;

    for (ptrdiff_t i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Take from a change (4) of a quaternion q, or a gradient by it, its part along q; returns it in q. */
static inline real cardan_take_along(const real *q, real *change)
{
    const real along = cardan_dot(q, change, 4) / cardan_dot(q, q, 4);

    for (int i = 0; i < 4; i++)
        change[i] -= along * q[i];
    return along;
}

static inline ptrdiff_t cardan_larger_of(ptrdiff_t a, ptrdiff_t b)
{
    return a > b ? a : b;
}

/* run.c */
int cardan_run_start(cardan_run *run);
int cardan_run_drive(cardan_run *run);
int cardan_run_at(cardan_run *run, real t, real *y);
int cardan_write_rows(cardan_run *run);
ptrdiff_t cardan_row_width(const cardan_run *run);
int cardan_inputs_at(cardan_run *run, real t, const real *x);
void cardan_interpolate(ptrdiff_t rows, ptrdiff_t n, real theta, const real *y_old,
                        const real *interpolant, real *y);

/* memory.c */
size_t cardan_run_length(const cardan_run *run, size_t tail, size_t work);
void cardan_run_place(cardan_run *run, real *memory, size_t tail, size_t work);
void cardan_run_lay(cardan_run *run, real *memory, size_t tail, size_t work);

/* what the methods build on: derivative.c, close.c and control.c */
int cardan_evaluate(cardan_run *run, real t, const real *y, real *xdot, real *power);
int cardan_derivative(cardan_run *run, real t, const real *y, real *f);
int cardan_refresh(cardan_run *run);
int cardan_segment(cardan_run *run);
void cardan_head_for_stop(cardan_run *run);
void cardan_restart(cardan_run *run);
void cardan_signals_at(cardan_run *run, real t);
void cardan_record_row(cardan_run *run, real t);
int cardan_commit(cardan_run *run, real t, const real *y);
int cardan_commit_derivative(cardan_run *run, real t, const real *y, int stage);
int cardan_follows(cardan_run *run, real t, const real *next, const real *slope);
void cardan_normalize(const cardan_run *run, real *y);
ptrdiff_t cardan_not_finite(const real *y, ptrdiff_t n);
ptrdiff_t cardan_closing_length(const cardan_run *run);
int cardan_close(cardan_run *run, real t, real *y, int noted);
void cardan_close_states(cardan_run *run, ptrdiff_t count, const real *t, real *x, const real *r,
                         const real *s);
int cardan_gaps_close(const cardan_run *run, const real *gaps, ptrdiff_t first, real h, real reach,
                      int adaptive);
void cardan_note_gaps(cardan_run *run, const real *gaps, real t);
ptrdiff_t cardan_chart_length(const cardan_run *run);
void cardan_leave_inside(const cardan_run *run, real theta, real *y);
void cardan_first_moment(cardan_run *run);
real cardan_least_span(const cardan_run *run);
int cardan_first_step(cardan_run *run, int order);
int cardan_trial_step(cardan_run *run, real *h, real *t_new);
void cardan_accept_step(cardan_run *run, real h, real error, int order);
void cardan_accept_explicit_step(cardan_run *run, real h, real error, int order);
int cardan_reject_step(cardan_run *run, real h, real error, int order, int status);
void cardan_first_rank(cardan_run *run);
int cardan_rank_sound(const cardan_run *run);
int cardan_branches_meet(cardan_run *run, real *tau);
ptrdiff_t cardan_weakest(const cardan_run *run);
real cardan_span(const cardan_run *run);
int cardan_step(cardan_run *run);
int cardan_near_singular(cardan_run *run, real t, const real *y, int kept);
real cardan_finest(const cardan_run *run);

/* The larger of two, the first where the second is not a number; without the call that fmax is. */
static inline real cardan_most(real most, real x)
{
    return x > most ? x : most;
}

/* Whether x is larger than the largest so far. What is not a number is larger than all that are, and
 * no number is larger than it: `!(x <= worst)` would let the next one take its place. */
static inline int cardan_exceeds(real x, real worst)
{
    return x > worst || x != x;
}

/* The larger of two, not a number where one of them is not: of errors, which fmax would drop. */
static inline real cardan_worst(real worst, real x)
{
    return cardan_exceeds(x, worst) ? x : worst;
}

/* Size against which an error of entry i counts. */
static inline real cardan_scale(const cardan_run *run, const real *y, ptrdiff_t i)
{
    return run->atol + run->rtol * fmax(fabs(run->y[i]), fabs(y[i]));
}


/* A method. Its file ends with one, called cardan_<method>_method. */
typedef struct cardan_method {
    int (*init)(cardan_run *run);  /* the first step, at the start of the run */
    int (*step)(cardan_run *run);  /* one accepted step */
    int (*dense)(cardan_run *run); /* the dense output over it */
    ptrdiff_t (*length)(const cardan_run *run); /* of its own memory */
    int (*sound)(const cardan_run *run); /* whether places held there exist; NULL: it holds none */
    ptrdiff_t stages, dense_rows; /* derivatives it keeps, rows of its dense output */
    /* those that its dense output reads besides that at the end; NULL: it evaluates none */
    const ptrdiff_t *sources; ptrdiff_t source_rows;
} cardan_method;

ptrdiff_t cardan_no_memory(const cardan_run *run);

/* Give a run its method. */
static inline void cardan_take_method(cardan_run *run, const cardan_method *method)
{
    run->init = method->init, run->step = method->step;
    run->dense = method->dense, run->length = method->length;
    run->stages = method->stages, run->dense_rows = method->dense_rows;
}

/* The same by its name: CARDAN_METHOD(&run, dop853). */
#define CARDAN_METHOD(run, name)                                                                   \
    do {                                                                                           \
        extern const cardan_method cardan_##name##_method;                                         \
        cardan_take_method(run, &cardan_##name##_method);                                          \
    } while (0)

#endif
