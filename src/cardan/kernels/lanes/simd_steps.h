/* Trial steps of several runs side by side: what ensemble.c asks for and lanes do.
 *
 * Part of cardan. simd_steps.c and lane_<method>.c are built with -DCARDAN_LANES, as the function they
 * call; ensemble.c, which knows single runs only, is not. Here every number of a run is a vector of
 * one number per lane, entry k of an array stands at k * lanes. The caller owns all memory, aligned
 * for vectors. Lanes never meet: what one does has no influence on the others.
 */
#ifndef CARDAN_ABREAST_H
#define CARDAN_ABREAST_H

#include "cardan.h"
#include <stddef.h>

typedef struct cardan_simd cardan_simd;
typedef void (*cardan_any_function)(void);

struct cardan_simd {
    /* the model */
    cardan_any_function rhs; /* its lane build */
    double *w;               /* its prepared parameters: shared, or one set per lane */
    void *owner;
    void (*inputs)(void *owner); /* r at the times `at`, NULL where no input depends on time */
    void (*alone)(void *owner, const double *y, double *f); /* lane by lane; says who `failed` */
    const ptrdiff_t *quaternions;
    ptrdiff_t quaternion_count, n, nq, nu, nr;

    /* the method: derivatives and error of a trial; its dense output; the worst entry of the trials
     * whose culprit is SIMD_WORST */
    void (*trial_step)(cardan_simd *a);
    void (*dense)(cardan_simd *a);
    void (*worst)(cardan_simd *a);
    double rtol, atol, max_step;
    ptrdiff_t order, last_stage; /* of the error; derivative at the end of the step, -1 if none is */

    /* numbers per lane, of its run */
    double *t, *size, *until; /* present time, size that control asks for, where steps end */
    double *error_before;     /* of the last step, 1 before any */
    double *span;             /* of time, against which a step is too small beside t = 0 */
    ptrdiff_t *idle;          /* -1 where no run is under way, else 0 */
    ptrdiff_t *rejected;      /* how often the present step was */
    ptrdiff_t *steps, *rejections, *evaluations;

    /* numbers per lane, of the trial */
    double *h, *t_new;  /* from t to t_new */
    double *at;         /* times of the present call */
    double *error;      /* in units of the tolerance */
    double *culprit;    /* entry that is to blame if the run ends here, -1 if none is */
    ptrdiff_t *taken;   /* -1 where the trial becomes the next state, else 0 */
    ptrdiff_t *failed;  /* its status; 0: none */
    ptrdiff_t *ended;   /* status of the run, which ends at t; 0: it goes on */

    /* vectors per lane */
    double *y;      /* (n) at t */
    double *trial;  /* (n) state at t_new */
    double *next;   /* (n) derivative there */
    double *k;      /* (stages, n) derivatives of the step, the first one at t */
    double *interpolant; /* (dense_rows, n) */
    double *r, *s, *zeros, *work;
};

enum { SIMD_WORST = -2 /* culprit: the worst entry of the error, to be looked for */ };

/* f (n) at the times `at` and states y (n) of all lanes that have not failed. */
void cardan_simd_derivative(cardan_simd *a, const real *y, real *f);
/* The state at t_new where `taken`, and its derivative. What fails is taken no more. */
void cardan_simd_commit(cardan_simd *a);
/* A trial step of every lane, and what control makes of it; whether some run has `ended`. */
ptrdiff_t cardan_simd_try(cardan_simd *a);
/* Where `taken` the trial becomes the present state; whether some run came to where steps end. */
ptrdiff_t cardan_simd_move(cardan_simd *a);
/* For bindings: the size they must agree with. */

/* What the texts of methods say in lanes: the present step, a stage, the size against which errors
 * count (fmax takes the number where the other one is none). */
#define SIMD_TRIAL(a)                                                                              \
    const ptrdiff_t n = (a)->n;                                                                    \
    const real *y = (const real *)(a)->y;                                                          \
    const real t = *(const real *)(a)->t, h = *(const real *)(a)->h;                               \
    real *k = (real *)(a)->k, *trial = (real *)(a)->trial, *at = (real *)(a)->at;
#define SIMD_STAGE(s, sum)                                                                         \
    for (ptrdiff_t i = 0; i < n; i++) trial[i] = y[i] + h * (sum);                                 \
    *at = t + C[s] * h;                                                                            \
    cardan_simd_derivative(a, trial, k + (s) * n);
#define SIMD_SCALE(a, i)                                                                           \
    ((a)->atol + (a)->rtol * cardan_max(cardan_abs(((const real *)(a)->y)[i]),                     \
                                        cardan_abs(((const real *)(a)->trial)[i])))
/* Where it is asked for, the culprit is the entry whose `error` (an expression in i) is largest, or
 * the last one that is not a number. */
#define SIMD_CULPRIT(a, error)                                                                     \
    real worst = CARDAN_REAL(-1.0), culprit = worst, *const worst_entry = (real *)(a)->culprit;    \
    for (ptrdiff_t i = 0; i < n; i++) {                                                            \
        const real each = cardan_abs(error);                                                       \
        const cardan_mask worse                                                                    \
            = ~(cardan_mask)(each <= worst)                                                        \
              & ((cardan_mask)(worst == worst) | (cardan_mask)(each != each));                     \
        worst = CARDAN_CHOICE(worse, each, worst);                                                 \
        culprit = CARDAN_CHOICE(worse, CARDAN_REAL((double)i), culprit);                           \
    }                                                                                              \
    *worst_entry = CARDAN_CHOICE(*worst_entry == (double)SIMD_WORST, culprit, *worst_entry);

/* A method whose trial steps go side by side. Its file ends with one, cardan_<method>_lane_method. */
typedef struct cardan_lane_method {
    void (*trial_step)(cardan_simd *a);
    void (*dense)(cardan_simd *a);
    void (*worst)(cardan_simd *a);
} cardan_lane_method;

/* What an exported model has in lanes: model_lanes.c defines one, cardan_scene_lanes. */
typedef struct cardan_lane_choice {
    const char *name; /* of the method */
    const cardan_lane_method *method;
    ptrdiff_t order; /* of its error */
} cardan_lane_choice;
typedef struct cardan_lane_build {
    ptrdiff_t lanes;
    cardan_any_function rhs;
    ptrdiff_t (*attempt)(cardan_simd *a);
    ptrdiff_t (*move)(cardan_simd *a);
    const cardan_lane_choice *methods;
    ptrdiff_t method_count;
} cardan_lane_build;

#endif
