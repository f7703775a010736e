/* Inputs that functions compute.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "input_functions.h"

int cardan_input_functions_at(void *context, real t, const real *x, real *r)
{
    cardan_input_functions *inputs = context;
    cardan_run *run = inputs->run;

    if (inputs->python && inputs->python(NULL, t, x, r) != 0)
        return CARDAN_INPUT;
    if (inputs->outputs.function) {
        cardan_in in = cardan_at(run, &t, x);
        in.r = r, in.w = inputs->outputs.w;
        run->model_status = inputs->outputs.function(&in, inputs->values, inputs->work);
        if (run->model_status != 0)
            return CARDAN_INPUT;
    }
    for (ptrdiff_t k = 0; k < inputs->count; k++) {
        const cardan_input_function *f = inputs->functions + k;
        for (ptrdiff_t i = 0; i < f->read_count; i++)
            inputs->reads[i] = inputs->values[f->reads[i]];
        for (ptrdiff_t i = 0; i < f->give_count; i++)
            inputs->gives[i] = r[f->gives[i]];
        inputs->status = f->function(t, x, inputs->reads, inputs->gives);
        if (inputs->status != 0) {
            inputs->failed = k;
            return CARDAN_INPUT;
        }
        for (ptrdiff_t i = 0; i < f->give_count; i++)
            r[f->gives[i]] = inputs->gives[i];
    }
    return 0;
}
