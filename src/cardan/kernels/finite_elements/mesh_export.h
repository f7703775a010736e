/* Elements of an exported model as constants, and their numbers at some parameters. Part of cardan. */
#ifndef CARDAN_MESH_EXPORT_H
#define CARDAN_MESH_EXPORT_H

#include "export.h"
#include "mesh_calls.h"

/* A function of the elements of a group. */
typedef struct cardan_element_function {
    ptrdiff_t group, form;
    cardan_function function;
    void (*prepare)(const wreal *p, wreal *w);
    ptrdiff_t nw, size; /* numbers that are prepared for an element, numbers of a result */
} cardan_element_function;

/* What the elements of a group are given: what follows from the parameters, then numbers. */
typedef struct cardan_element_data {
    cardan_function function; /* NULL: nothing follows */
    void (*prepare)(const wreal *p, wreal *w);
    ptrdiff_t size, nw;    /* numbers of results and prepared ones */
    ptrdiff_t each, alike; /* how many of the results an element has; 1: all have the same */
    const double *attributes;     /* (count, more) */
    ptrdiff_t more;
} cardan_element_data;

struct cardan_elements {
    const cardan_mesh *mesh; /* its groups are without what is prepared */
    const cardan_element_function *functions; /* group by group */
    ptrdiff_t function_count;
    const cardan_element_data *data; /* by group */
    ptrdiff_t data_room, nw; /* numbers that the data of a group take, that are prepared for all */
    const double *locked;      /* (nq + nu): not 0 where x stays while parameters move the rest */
};

extern const cardan_element_calls cardan_calls_of_elements;

/* The elements at parameters p; `numbers` has data_room + nw of them. Returns a status. */
int cardan_elements_prepare(const cardan_elements *elements, const double *p, cardan_mesh *mesh,
                            cardan_group *groups, real *numbers);
/* The matrix of a mesh by rows: the column of every value, where every row begins, the unknown that
 * every multiplier is. */
void cardan_mesh_pattern(const cardan_mesh *mesh, int32_t *columns, int32_t *starts,
                         ptrdiff_t *unknowns);

#endif
