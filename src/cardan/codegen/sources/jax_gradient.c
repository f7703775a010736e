/* Costs of motions with their gradients as XLA calls them. Arguments: a row of options (OPTIONS), x, r
 * and p of every motion; results: the cost, then its gradient by x, r and p. */
enum { METHOD, START, END, STEP, RTOL, ATOL, OPTIONS, TEXT = 512 };
enum { FIRST_STEPS = 1000, MORE = 8, MOST_TRIES = 6 };

/* One motion; not 0: there is no gradient, and the text says why. */
static int sweep_motion(const double *const values[4], double *out, char *text)
{
    const cardan_export *model = &cardan_scene;
    const double *options = values[0];
    const ptrdiff_t nx = model->nq + model->nu + model->nz, nr = model->nr, np = model->cost->np;
    cardan_gradient of = {.most_steps = FIRST_STEPS};
    int status = CARDAN_FULL;

    of.run = (cardan_simulation){.method = model->methods[(ptrdiff_t)options[METHOD]].name,
                                 .start = options[START], .end = options[END], .step = options[STEP],
                                 .rtol = options[RTOL], .atol = options[ATOL],
                                 .x = values[1], .r = values[2], .p = values[3]};
    /* how many steps there will be is not known */
    for (int n = 0; n < MOST_TRIES && status == CARDAN_FULL; n++, of.most_steps *= MORE) {
        void *memory = malloc(cardan_gradient_size(model, &of));
        status = memory ? cardan_gradient_of(model, &of, memory) : CARDAN_SIZE;
        if (status == 0) {
            *out++ = of.cost;
            memcpy(out, of.by_x, (size_t)nx * sizeof *out);
            memcpy(out + nx, of.by_r, (size_t)nr * sizeof *out);
            memcpy(out + nx + nr, of.by_p, (size_t)np * sizeof *out);
        }
        free(memory);
    }
    if (status != 0)
        snprintf(text, TEXT, "no gradient, status %d at t = %.6g s: %s%s%s", status, of.run.t,
                 of.event ? of.event : "", of.event ? ": " : "",
                 of.refused ? of.refused : "run.h says what that is");
    return status;
}

EXPORTED XLA_FFI_Error *jax_motion_gradient(XLA_FFI_CallFrame *frame);
XLA_FFI_Error *jax_motion_gradient(XLA_FFI_CallFrame *frame)
{
    const XLA_FFI_Buffer *result;
    states args[4];
    int64_t at[MOST_AXES] = {0}, count = 1;
    double *out;
    char text[TEXT];
    int axes;

    if (is_question(frame))
        return NULL;
    if (frame->args.size != 4 || frame->rets.size != 1)
        return failed(frame, XLA_FFI_Error_Code_INVALID_ARGUMENT, "numbers of arguments or results");
    result = frame->rets.rets[0];
    if (result->dtype != XLA_FFI_DataType_F64 || result->rank < 1 || result->rank > MOST_AXES)
        return failed(frame, XLA_FFI_Error_Code_INVALID_ARGUMENT, "a result must be float64");
    for (int k = 0; k < 4; k++)
        if (!read_states(frame->args.args[k], result, args + k))
            return failed(frame, XLA_FFI_Error_Code_INVALID_ARGUMENT,
                          "arguments must be float64, with axes that broadcast");
    axes = (int)result->rank - 1;
    for (int k = 0; k < axes; k++)
        count *= result->dims[k];
    out = result->data;
    for (int64_t n = 0; n < count; n++, out += result->dims[axes]) {
        const double *values[4];
        for (int i = 0; i < 4; i++) {
            values[i] = args[i].data;
            for (int k = 0; k < axes; k++)
                values[i] += at[k] * args[i].step[k];
        }
        if (sweep_motion(values, out, text) != 0)
            return failed(frame, XLA_FFI_Error_Code_FAILED_PRECONDITION, text);
        for (int k = axes - 1; k >= 0 && ++at[k] == result->dims[k]; k--)
            at[k] = 0;
    }
    return NULL;
}
