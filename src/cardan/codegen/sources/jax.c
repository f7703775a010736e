/* Functions of the model as XLA calls them, and through it JAX: jax_<function>.
 *
 * Plain C on XLA's C API for foreign functions, whose header comes with jax: compile with -DCARDAN_JAX
 * and the folder that jax.ffi.include_dir() names; without these the file is empty. No state is kept.
 */
#include "functions.h"

#ifdef CARDAN_JAX
#include "binding.h"
#include "xla/ffi/api/c_api.h"
#include <stdio.h>
#include <stdlib.h>

#ifdef _WIN32
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED
#endif

enum { MOST_ARGUMENTS = 16, MOST_AXES = 32 };

static XLA_FFI_Error *failed(const XLA_FFI_CallFrame *frame, XLA_FFI_Error_Code code, const char *why)
{
    XLA_FFI_Error_Create_Args args = {0};

    args.struct_size = XLA_FFI_Error_Create_Args_STRUCT_SIZE;
    args.message = why;
    args.errc = code;
    return frame->api->XLA_FFI_Error_Create(&args);
}

/* A question for the version of the interface: answered, nothing is called. */
static int is_question(XLA_FFI_CallFrame *frame)
{
    XLA_FFI_Extension_Base *extension = frame->extension_start;

    if (!extension || extension->type != XLA_FFI_Extension_Metadata)
        return 0;
    XLA_FFI_Metadata *metadata = ((XLA_FFI_Metadata_Extension *)(void *)extension)->metadata;
    metadata->api_version.major_version = XLA_FFI_API_MAJOR;
    metadata->api_version.minor_version = XLA_FFI_API_MINOR;
    return 1;
}

/* An array of states: its numbers, and how far it is along every axis to the next of them, which is
 * nothing where the axis has one entry for all. */
typedef struct states {
    const double *data;
    ptrdiff_t step[MOST_AXES];
} states;

/* An argument whose axes before the last one go with those of the result; 0 where they do not. */
static int read_states(const XLA_FFI_Buffer *x, const XLA_FFI_Buffer *result, states *to)
{
    ptrdiff_t step = 1;

    if (x->dtype != XLA_FFI_DataType_F64 || x->rank != result->rank || x->rank < 1)
        return 0;
    step = (ptrdiff_t)x->dims[x->rank - 1];
    for (int64_t k = x->rank - 2; k >= 0; k--) {
        if (x->dims[k] != 1 && x->dims[k] != result->dims[k])
            return 0;
        to->step[k] = x->dims[k] == 1 ? 0 : step;
        step *= (ptrdiff_t)x->dims[k];
    }
    to->data = x->data;
    return 1;
}

/* All states one after the other; parameters are prepared where they are others than before. */
static void run(const cardan_bound *f, const XLA_FFI_Buffer *result, states *args, double *memory)
{
    const int axes = (int)result->rank - 1;
    const double *prepared = NULL, *values[MOST_ARGUMENTS];
    double *out = result->data;
    int64_t at[MOST_AXES] = {0}, count = 1;

    for (int k = 0; k < axes; k++)
        count *= result->dims[k];
    for (int64_t n = 0; n < count; n++) {
        for (ptrdiff_t i = 0; i <= f->argument_count; i++) {
            values[i] = args[i].data;
            for (int k = 0; k < axes; k++)
                values[i] += at[k] * args[i].step[k];
        }
        if (values[f->argument_count] != prepared) {
            prepared = values[f->argument_count];
            cardan_bound_prepare(&cardan_scene, f, prepared, memory);
        }
        /* where a linear system has no solution, the result is not a number */
        (void)cardan_bound_call(&cardan_scene, f, values, out, memory);
        out += f->out;
        for (int k = axes - 1; k >= 0 && ++at[k] == result->dims[k]; k--)
            at[k] = 0;
    }
}

static XLA_FFI_Error *call(XLA_FFI_CallFrame *frame, const cardan_bound *f)
{
    const XLA_FFI_Buffer *result;
    states args[MOST_ARGUMENTS];
    double *memory;

    if (is_question(frame))
        return NULL;
    if (frame->args.size != f->argument_count + 1 || frame->args.size > MOST_ARGUMENTS
        || frame->rets.size != 1)
        return failed(frame, XLA_FFI_Error_Code_INVALID_ARGUMENT, "numbers of arguments or results");
    result = frame->rets.rets[0];
    if (result->dtype != XLA_FFI_DataType_F64 || result->rank < 1 || result->rank > MOST_AXES)
        return failed(frame, XLA_FFI_Error_Code_INVALID_ARGUMENT, "a result must be float64");
    for (int64_t k = 0; k < frame->args.size; k++)
        if (!read_states(frame->args.args[k], result, args + k))
            return failed(frame, XLA_FFI_Error_Code_INVALID_ARGUMENT,
                          "arguments must be float64, with axes that broadcast");
    memory = malloc(cardan_bound_memory(&cardan_scene, f) * sizeof *memory);
    if (!memory)
        return failed(frame, XLA_FFI_Error_Code_RESOURCE_EXHAUSTED, "memory");
    run(f, result, args, memory);
    free(memory);
    return NULL;
}

#define DEFINE(name)                                                                               \
    EXPORTED XLA_FFI_Error *jax_##name(XLA_FFI_CallFrame *frame);                                  \
    XLA_FFI_Error *jax_##name(XLA_FFI_CallFrame *frame) { return call(frame, &name##_bound); }

