/*
 * elements.h: the model as a whole, of the sizes in functions.h.
 */
#ifndef CARDAN_ELEMENTS_H
#define CARDAN_ELEMENTS_H

#include "mesh_export.h"

/* The elements with their numbers. It points into itself: prepare another, copy none.
 *
 *     static cardan_model model;
 *     int status = prepare_model(cardan_default_p, &model);
 *     real *work = malloc(model_work_size(&model) * sizeof(real));
 *     cardan_in in = {.t = &t, .q = q, .u = u, .w = model_w(&model)};
 *     status = energy(&in, out, work);
 */
typedef struct cardan_model {
    cardan_mesh mesh;
    cardan_group groups[cardan_ngroups + (cardan_ngroups == 0)];
    real numbers[cardan_nnumbers + 1]; /* data of a group; what is prepared for all */
} cardan_model;

/* the numbers of all elements at parameters p (cardan_np); returns a status */
CARDAN_API int prepare_model(const double *p, cardan_model *model);
/* what the functions below take as `w` */
CARDAN_API const wreal *model_w(const cardan_model *model);
/* how many numbers of work memory each of them takes */
CARDAN_API size_t model_work_size(const cardan_model *model);
/* x = [q, u, z] where simulate() starts; at other parameters, times or inputs nodes follow the joints
 * of the tree. Returns a status: CARDAN_CONSTRAINT_OPEN where joints or beams would have to move too: take
 * x = model.with_parameters(...).initial() of cardan there */
CARDAN_API int start_model(const cardan_model *model, real t, const real *r, real *x, real *work);
/* the sparse matrix by rows: the column of every value (cardan_nvalues), where every row begins
 * (cardan_nunknowns + 1), the unknown that every multiplier is (cardan_nlam); the first unknowns
 * are the speeds */
CARDAN_API void model_pattern(int32_t *columns, int32_t *starts, ptrdiff_t *unknowns);

#endif
