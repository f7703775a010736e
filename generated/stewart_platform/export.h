/* An exported model as constants, and its numbers at some parameters.
 *
 * Part of cardan. model.c of an export defines such a constant, cardan_scene; the caller owns all
 * memory. Runs of it: simulate.h.
 */
#ifndef CARDAN_EXPORT_H
#define CARDAN_EXPORT_H

#include "cardan.h"
#include <stddef.h>

/* A function of the model; `prepare` is NULL where it reads the elements as its w. */
typedef struct cardan_exported_function {
    const char *name;
    cardan_function function;
    void (*prepare)(const wreal *p, wreal *w);
    ptrdiff_t out, work, w; /* lengths */
} cardan_exported_function;

/* An event. Where the discrete state `mode` has the value `first` before it, it is not an event but the
 * first decision about that mode; -1: it decides about none. */
typedef struct cardan_exported_event {
    const char *name;
    ptrdiff_t mode;
    double first;
} cardan_exported_event;

/* An event at the times phase + k period. */
typedef struct cardan_exported_tick {
    ptrdiff_t event;
    double period, phase;
} cardan_exported_tick;

/* A method of integration. */
typedef struct cardan_exported_method {
    const char *name;
    const struct cardan_method *method;
    double rtol, atol; /* where none are asked for */
    double step;       /* where none is asked for [s]; 0: as the tolerances ask for */
    ptrdiff_t charted; /* 1: it takes quaternions by their increments */
    /* of gradients: nodes, weights and matrix of its stages, NULL without; how those that depend on each
     * other are solved, NULL where none do */
    ptrdiff_t (*tableau)(real *nodes, real *weights, real *matrix);
    const struct cardan_coupled *coupled;
} cardan_exported_method;

/* A cost of motions: numbers of functions, -1: there is none. A product is weights times the derivative
 * along coordinates, u, z, s, r and p. */
typedef struct cardan_exported_cost {
    ptrdiff_t np; /* parameters */
    ptrdiff_t final, final_product, integrand, integrand_product;
    ptrdiff_t rates, close_position, close_velocity; /* products */
} cardan_exported_cost;

typedef struct cardan_elements cardan_elements;
typedef struct cardan_export cardan_export;

/* What models of elements in tables have of mesh_export.c; others go without that file. What is
 * prepared begins with the mesh. */
typedef struct cardan_element_calls {
    size_t (*size)(const cardan_elements *elements);
    int (*prepare)(const cardan_elements *elements, const double *p, void *prepared);
    size_t (*work)(const cardan_elements *elements);
    int (*start)(const cardan_export *model, const void *prepared, real t, const real *r, real *x,
                 real *work);
} cardan_element_calls;

struct cardan_export {
    const char *name;
    ptrdiff_t nq, nu, nz, ns, nr;
    ptrdiff_t zeros; /* length of the longest block that is zero where nobody gives it */
    /* values of the scene, where a run starts */
    const double *p, *q, *u, *z, *s, *r;
    const cardan_exported_function *functions; /* the first is the one that example.c shows */
    ptrdiff_t function_count;
    /* elements in tables, without what is prepared; NULL in joint coordinates */
    const struct cardan_mesh *mesh;
    const cardan_elements *elements;
    const cardan_element_calls *calls;
    /* what runs take, as run.h has it */
    const cardan_exported_method *methods;
    ptrdiff_t method_count;
    const ptrdiff_t *quaternions;
    ptrdiff_t quaternion_count;
    ptrdiff_t positions, rates;
    double size;
    const double *columns;
    const cardan_exported_event *events;
    const ptrdiff_t *kinds; /* of the events */
    ptrdiff_t event_count;
    const cardan_exported_tick *ticks;
    ptrdiff_t tick_count;
    const cardan_exported_cost *cost; /* NULL: no gradients were asked for */
};

/* Bytes of what is prepared for all functions; fill them in at parameters p. Returns a status. */
size_t cardan_prepared_size(const cardan_export *model);
int cardan_prepare(const cardan_export *model, const wreal *p, void *prepared);
/* What the function with a number takes as `w`. */
const wreal *cardan_prepared_w(const cardan_export *model, const void *prepared, ptrdiff_t k);
/* Numbers of work memory that every function takes. */
size_t cardan_work_length(const cardan_export *model);
/* x = [q, u, z] where the scene starts. Returns a status: CARDAN_CONSTRAINT_OPEN of run.h where elements can
 * not follow other parameters, times or inputs. */
int cardan_start_state(const cardan_export *model, const void *prepared, real t, const real *r,
                       real *x, real *work);

#endif
