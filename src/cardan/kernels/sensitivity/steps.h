/* Steps of a Runge-Kutta method that a run has taken, computed again.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_STEPS_H
#define CARDAN_STEPS_H

#include "run.h"

/* How the stages of a step depend on each other. */
enum {
    CARDAN_EXPLICIT, /* each on those before it */
    CARDAN_COUPLED,  /* all on all, solved as a linear system: stages.c */
    CARDAN_PASS      /* the same over a place where branches meet, by sweeps: passes.c */
};
enum { CARDAN_MOST_STAGES = 16 };

typedef struct cardan_steps {
    cardan_run *run; /* that took the steps: its functions, signals and sizes */
    ptrdiff_t stages;
    ptrdiff_t kind;
    const struct cardan_coupled *coupled; /* cardan_coupled_stages, NULL of explicit methods */
    cardan_call jacobian; /* d rhs / d x (nx, nx), d t, d r, of coupled stages */
    const real *nodes;   /* (stages) */
    const real *weights; /* (stages) */
    const real *matrix;  /* (stages, stages), of explicit methods below the diagonal */
    const real *rows;    /* (count): t, y, r, s at the ends of steps, as the run wrote them */
    ptrdiff_t count;
    ptrdiff_t failed;    /* row of the step that could not be done, -1 */
    real *states;        /* (CARDAN_MOST_STAGES, nx) at which the stages were taken */
    real *slopes;        /* (CARDAN_MOST_STAGES, nx) */
    real *open;          /* (CARDAN_MOST_STAGES, nx) of a pass: states before they were projected */
    real *end;           /* (nx) state at the end, before projections */
    real *place;         /* (nx) the same at the positions behind them */
    real *lengths;       /* (CARDAN_MOST_STAGES, quaternions) of what coupled stages scale to 1 */
    real *system;        /* cardan_stages_length numbers, of coupled stages */
    real *jacobians;     /* (stages, nx, nx) of a sweep forward over elements, else NULL */
    const struct cardan_repeated *repeated; /* cardan_mesh_repeated, NULL: products are calls each */
    real *factored;      /* (CARDAN_MOST_STAGES, factored_length) of these, of a state each */
    ptrdiff_t factored_length;
    real *work;          /* of the functions */
} cardan_steps;

int cardan_step_again(cardan_steps *steps, ptrdiff_t k);
cardan_in cardan_step_in(const cardan_steps *steps, const real *t, const real *x);
int cardan_rates_at(const cardan_steps *steps, real t, const real *x, real *rates);

/* stages.c: the linear system of the stages of an implicit method, I - h A J; stages_elements.c: the same
 * over elements. A product: every stage's Jacobian, or its transposed, times its part of x (stages, nx). */
typedef int cardan_stage_product(const void *context, const real *x, real *out);
/* Programs that take explicit steps alone go without these files. */
typedef struct cardan_coupled {
    ptrdiff_t (*length)(const cardan_run *run, ptrdiff_t stages);
    int (*solve)(const cardan_steps *steps, ptrdiff_t k);
    int (*backward)(const cardan_steps *steps, real *weights, cardan_stage_product *product,
                    const void *context);
} cardan_coupled;
ptrdiff_t cardan_stages_length(const cardan_run *run, ptrdiff_t stages);
int cardan_stages_forward(const cardan_steps *steps, real *change, cardan_stage_product *product,
                          const void *context);
void cardan_stage_states(const cardan_steps *steps, real h, const real *y);
void cardan_stage_lengths(const cardan_steps *steps, ptrdiff_t stage, real *change);
ptrdiff_t cardan_element_stages_length(const cardan_run *run);
int cardan_element_stages_solve(const cardan_steps *steps, ptrdiff_t k);
int cardan_element_stages_refine(const cardan_steps *steps, int transposed, real *x,
                                 cardan_stage_product *product, const void *context);

/* passes.c: steps over places where branches meet */
typedef struct cardan_pass {
    cardan_steps steps;  /* with the tables of the step */
    ptrdiff_t from, to;  /* its rows */
    real nodes[CARDAN_MOST_STAGES], weights[CARDAN_MOST_STAGES];
    real matrix[CARDAN_MOST_STAGES * CARDAN_MOST_STAGES];
} cardan_pass;
ptrdiff_t cardan_pass_of(const cardan_steps *steps, ptrdiff_t k);
int cardan_pass_again(const cardan_steps *steps, ptrdiff_t pass, ptrdiff_t k, cardan_pass *again);
void cardan_pass_part(const cardan_pass *pass, ptrdiff_t row, real *weights);
void cardan_enter_step(cardan_run *run, const real *row, const real *next);
void cardan_end_step(const cardan_steps *steps, const real *y, real h, const real *behind);
int cardan_swept_enough(real change, real size, real *last);

/* The change (4) of a quaternion behind its scaling to length 1, or the gradient by what it was
 * before: both are the same. q: either of them; length: what it was. */
static inline void cardan_unit_change(const real *q, real length, real *change)
{
    (void)cardan_take_along(q, change);
    for (int j = 0; j < 4; j++)
        change[j] /= length;
}

/* Nodes (stages), weights (stages) and matrix (stages, stages) of methods; return their stages. */
ptrdiff_t cardan_rk4_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_rk45_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_dop853_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_radau_tableau(real *nodes, real *weights, real *matrix);

#endif
