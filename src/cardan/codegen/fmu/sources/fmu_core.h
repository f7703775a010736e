/* The core of an FMU: an exported model as an instance with memory of its own, whatever version of
 * FMI asks.
 *
 * Part of cardan. fmi2.c and fmi3.c translate their calls into these; fmu_model.c of an FMU defines
 * what its variables are. Nothing is shared by instances but constants.
 */
#ifndef CARDAN_FMU_CORE_H
#define CARDAN_FMU_CORE_H

#include "simulate.h"
#include <float.h>
#include <math.h>

/* in the order of both versions */
typedef enum { FMU_OK, FMU_WARNING, FMU_DISCARD, FMU_ERROR, FMU_FATAL } fmu_status;

/* kinds of variables, in the order of their value references */
enum {
    FMU_TIME,
    FMU_STATE,     /* x = [q, u, z] */
    FMU_RATE,      /* its derivatives */
    FMU_PARAMETER, /* p */
    FMU_INPUT,     /* r */
    FMU_MODE,      /* s */
    FMU_OUTPUT,    /* outputs of the model */
    FMU_ENERGY,    /* kinetic, potential, total */
    FMU_INDICATOR, /* what falls through zero where an event happens */
    FMU_KINDS
};

/* states of an instance, as bits */
enum {
    FMU_INSTANTIATED = 1,
    FMU_INITIALIZING = 2,
    FMU_EVENT_MODE = 4,
    FMU_CONTINUOUS = 8,
    FMU_STEPPING = 16,
    FMU_TERMINATED = 32,
    FMU_ENTERED = FMU_EVENT_MODE | FMU_CONTINUOUS | FMU_STEPPING | FMU_TERMINATED,
    FMU_ANYTIME = 63
};

/* Functions of the model that give a kind of variable, and its derivatives: along the speeds, by u,
 * z, t and r, row by row one after the other; by the parameters. NULL: there is none. */
typedef struct fmu_slope {
    const char *function, *by_state, *by_parameters;
} fmu_slope;

/* What a multiple of a parameter may be. */
typedef struct fmu_limit {
    ptrdiff_t parameter;
    double scale, least, most; /* without bound: infinite */
    int open, below, nonzero;  /* 1: the least, the most value, 0 is refused */
} fmu_limit;

typedef struct fmu_model {
    const cardan_export *scene;
    const char *token;
    int exchange, simulates; /* 1: it serves model exchange, co-simulation */
    const char *const *names; /* by value reference */
    struct {
        unsigned first, count;
    } blocks[FMU_KINDS];
    fmu_slope slopes[FMU_KINDS];
    const char *const *beyond; /* (events) about a start where the event is negative; NULL: none */
    const ptrdiff_t *indicators; /* events behind the variables of that kind */
    const fmu_limit *limits;
    ptrdiff_t limit_count;
    double duration, tolerance; /* where none are asked for */
} fmu_model;

extern const fmu_model cardan_fmu;

typedef struct fmu_instance fmu_instance;

/* numbers of the polynomial of an input: where it begins and ends, four coefficients */
enum { FMU_POLYNOMIAL = 6 };

/* Where messages go: a version's own callback behind `sink`. */
typedef struct fmu_logger {
    void (*sink)(const fmu_instance *m, fmu_status status, const char *category, const char *text);
    void (*callback)(void);
    void *environment;
    int events; /* 1: events are told too */
} fmu_logger;

struct fmu_instance {
    const fmu_model *model;
    char *name;
    fmu_logger logger;
    int exchange; /* 1: model exchange, 0: co-simulation */
    void *memory; /* of the run and of the arrays here */
    cardan_laid_run at;
    double *jumps; /* times at which the model jumps, up to the horizon */
    double *view, *moved, *before;        /* (nx) */
    double *values[FMU_KINDS]; /* of rates, outputs, energies and indicators, as last computed */
    double *slopes[FMU_KINDS], *by_parameters[FMU_KINDS]; /* (rows, columns) */
    double *kinematics, *normal, *direction, *increment; /* N, the factor of N^T N; seeds */

    /* what an FMU state holds, with p, r, start and the state of the run */
    struct fmu_record {
        int phase, begun, start_is_set, terminated, failed;
        int stale_parameters, stale_inputs;
        int stop_defined, tolerance_defined;
        double tolerance, start, stop, horizon;
        ptrdiff_t jump_count;
        int polynomials; /* 1: inputs have derivatives */
    } is;
    double *p, *r, *start;
    double *armed_at; /* (events) when an indicator was first clear of zero; before that it is not */
    double *polynomials; /* (nr, FMU_POLYNOMIAL) of inputs that are polynomials of time */
    cardan_signal *signals; /* the same for the run */

    int computed[FMU_KINDS], differentiated[FMU_KINDS]; /* 1: values and slopes are those of now */
    int by_parameters_now[FMU_KINDS], factored;
    char text[640];
};

/* fmu_instance.c */
fmu_instance *fmu_create(const fmu_model *model, int exchange, const char *name, const char *token,
                         fmu_logger logger);
void fmu_free(fmu_instance *m);
fmu_status fmu_reset(fmu_instance *m);
fmu_status fmu_allow(fmu_instance *m, const char *call, int phases);
fmu_status fmu_setup(fmu_instance *m, int tolerance_defined, double tolerance, double start,
                     int stop_defined, double stop);
fmu_status fmu_enter_initialization(fmu_instance *m);
fmu_status fmu_exit_initialization(fmu_instance *m);
fmu_status fmu_settle(fmu_instance *m);
void fmu_lay_run(fmu_instance *m);
void fmu_forget(fmu_instance *m);
int fmu_find_jumps(fmu_instance *m, double from, double to);
void fmu_set_stops(fmu_instance *m, double end);

/* fmu_values.c */
fmu_status fmu_get(fmu_instance *m, const unsigned *references, size_t count, double *values);
fmu_status fmu_set(fmu_instance *m, const unsigned *references, size_t count, const double *values);
int fmu_kind_of(const fmu_model *model, unsigned reference, ptrdiff_t *place);
fmu_status fmu_compute(fmu_instance *m, int kind);
int fmu_call(fmu_instance *m, const char *function, const double *y, double *out);
const double *fmu_unit_view(fmu_instance *m);

/* fmu_slopes.c: sensitivity = J seed, or its transpose where `adjoint` */
fmu_status fmu_derivative(fmu_instance *m, const unsigned *unknowns, size_t unknown_count,
                          const unsigned *knowns, size_t by_count, const double *seed,
                          double *sensitivity, int adjoint);

/* fmu_events.c: model exchange */
typedef struct fmu_update {
    int values_changed, terminate, next_defined;
    double next;
} fmu_update;
fmu_status fmu_update_discrete(fmu_instance *m, fmu_update *update);
fmu_status fmu_set_time(fmu_instance *m, double t);
fmu_status fmu_set_states(fmu_instance *m, const double *x, size_t count);
fmu_status fmu_get_states(fmu_instance *m, double *x, size_t count);
fmu_status fmu_get_block(fmu_instance *m, int kind, double *values, size_t count);
fmu_status fmu_completed_step(fmu_instance *m, int *enter_event_mode);
int fmu_happen(fmu_instance *m);
void fmu_report_events(fmu_instance *m);

/* fmu_steps.c: co-simulation */
fmu_status fmu_set_input_derivatives(fmu_instance *m, const unsigned *references, size_t count,
                                     const int *orders, const double *values);
fmu_status fmu_do_step(fmu_instance *m, double t, double step);

/* fmu_state.c */
typedef struct fmu_saved fmu_saved;
fmu_status fmu_save(fmu_instance *m, fmu_saved **state);
fmu_status fmu_restore(fmu_instance *m, const fmu_saved *state);
void fmu_discard_state(fmu_saved **state);
fmu_status fmu_saved_size(fmu_instance *m, const fmu_saved *state, size_t *size);
fmu_status fmu_write_state(fmu_instance *m, const fmu_saved *state, void *bytes, size_t size);
fmu_status fmu_read_state(fmu_instance *m, const void *bytes, size_t size, fmu_saved **state);

/* fmu_messages.c */
fmu_status fmu_say(fmu_instance *m, fmu_status status, const char *format, ...);
fmu_status fmu_broke_down(fmu_instance *m, const char *call, int status);

static inline const cardan_export *fmu_scene(const fmu_instance *m)
{
    return m->model->scene;
}

static inline ptrdiff_t fmu_nx(const fmu_instance *m)
{
    return m->at.run.nx;
}

static inline ptrdiff_t fmu_count(const fmu_instance *m, int kind)
{
    return (ptrdiff_t)m->model->blocks[kind].count;
}

/* Length of a quaternion. */
static inline double fmu_length(const double *q)
{
    return sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

/* Whether a number is finite. */
static inline int fmu_finite(double x)
{
    return x - x == 0;
}

#endif
