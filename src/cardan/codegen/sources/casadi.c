/* Functions of the model as CasADi calls them: casadi_<function> and jac_casadi_<function>; where
 * second derivatives were asked for, adj1_casadi_<function>, a gradient, and jac_adj1_casadi_<function>.
 *
 * C of CasADi's external interface (C API of "external"). No state is kept, so that there is nothing
 * to count references of; memory is that which CasADi hands over.
 */
#include "functions.h"
#include "binding.h"

#ifdef _WIN32
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED
#endif

typedef long long casadi_int;

/* Results of one call of the model: entry k of block `result` is out[entries[k]], or 0 where this is
 * negative. */
typedef struct result {
    ptrdiff_t result, count;
    const int *entries;
} result;

/* Weights of the results, where a function takes them: entry k of argument `argument` is number
 * entries[k] of `size`. */
typedef struct weights {
    const int *entries;
    ptrdiff_t count, size, argument;
} weights;

/* One call of the model; without `function` its results were not exported. */
typedef struct part {
    const cardan_bound *function;
    const result *results;
    ptrdiff_t count;
    const weights *weights;
} part;

/* A function of CasADi. */
typedef struct external {
    const part *parts;
    ptrdiff_t part_count, in_count, out_count;
    const char *const *in_names, *const *out_names;
    const casadi_int *const *in_sparsity, *const *out_sparsity;
} external;

/* Whether somebody asks for a result of a part. */
static int is_requested(const part *p, double **res)
{
    for (ptrdiff_t k = 0; k < p->count; k++)
        if (res[p->results[k].result])
            return 1;
    return 0;
}

/* What was not exported is not a number: CasADi asks for it also where nobody uses it. */
static void fill_unknown(const part *p, double **res)
{
    for (ptrdiff_t k = 0; k < p->count; k++)
        for (ptrdiff_t i = 0; res[p->results[k].result] && i < p->results[k].count; i++)
            res[p->results[k].result][i] = nan("");
}

/* The weights as the model takes them: the argument behind all others. Returns what memory is left. */
static double *order_weights(const external *f, const weights *v, const double **arg, double *w)
{
    const double *seed = arg[v->argument];

    memset(w, 0, (size_t)v->size * sizeof *w);
    for (ptrdiff_t k = 0; seed && k < v->count; k++)
        w[v->entries[k]] = seed[k];
    arg[f->in_count] = w;
    return w + v->size;
}

static int run(const external *f, const double **arg, double **res, double *w)
{
    for (ptrdiff_t n = 0; n < f->part_count; n++) {
        const part *p = f->parts + n;
        double *out = w;
        if (!is_requested(p, res))
            continue;
        if (!p->function) {
            fill_unknown(p, res);
            continue;
        }
        w = out + p->function->out;
        if (p->weights)
            w = order_weights(f, p->weights, arg, w);
        cardan_bound_prepare(&cardan_scene, p->function, arg[p->function->argument_count], w);
        if (cardan_bound_call(&cardan_scene, p->function, arg, out, w))
            return 1;
        for (ptrdiff_t k = 0; k < p->count; k++) {
            const result *r = p->results + k;
            for (ptrdiff_t i = 0; res[r->result] && i < r->count; i++)
                res[r->result][i] = r->entries[i] < 0 ? 0.0 : out[r->entries[i]];
        }
        w = out;
    }
    return 0;
}

/* Numbers of memory that the longest part takes. */
static casadi_int memory_of(const external *f)
{
    size_t most = 1;

    for (ptrdiff_t n = 0; n < f->part_count; n++) {
        const cardan_bound *g = f->parts[n].function;
        const weights *v = f->parts[n].weights;
        size_t length = g ? (size_t)g->out + cardan_bound_memory(&cardan_scene, g) : 0;
        length += v ? (size_t)v->size : 0;
        most = most < length ? length : most;
    }
    return (casadi_int)most;
}

/* The interface of one function. Where CasADi is not told a value it gets a NaN, but where 0 means
 * that nothing acts. */
#define DEFINE(name, f, defaults)                                                                  \
    EXPORTED void name##_incref(void);                                                             \
    EXPORTED void name##_decref(void);                                                             \
    EXPORTED casadi_int name##_n_in(void);                                                         \
    EXPORTED casadi_int name##_n_out(void);                                                        \
    EXPORTED double name##_default_in(casadi_int k);                                               \
    EXPORTED const char *name##_name_in(casadi_int k);                                             \
    EXPORTED const char *name##_name_out(casadi_int k);                                            \
    EXPORTED const casadi_int *name##_sparsity_in(casadi_int k);                                   \
    EXPORTED const casadi_int *name##_sparsity_out(casadi_int k);                                  \
    EXPORTED int name##_work(casadi_int *args, casadi_int *results, casadi_int *iw, casadi_int *w); \
    EXPORTED int name(const double **arg, double **res, casadi_int *iw, double *w, int memory);    \
    void name##_incref(void) {}                                                                    \
    void name##_decref(void) {}                                                                    \
    casadi_int name##_n_in(void) { return f.in_count; }                                            \
    casadi_int name##_n_out(void) { return f.out_count; }                                          \
    double name##_default_in(casadi_int k)                                                         \
    {                                                                                              \
        return k >= 0 && k < (casadi_int)(sizeof defaults - 1) && defaults[k] == '?' ? nan("") : 0.0; \
    }                                                                                              \
    const char *name##_name_in(casadi_int k)                                                       \
    {                                                                                              \
        return k >= 0 && k < f.in_count ? f.in_names[k] : NULL;                                    \
    }                                                                                              \
    const char *name##_name_out(casadi_int k)                                                      \
    {                                                                                              \
        return k >= 0 && k < f.out_count ? f.out_names[k] : NULL;                                  \
    }                                                                                              \
    const casadi_int *name##_sparsity_in(casadi_int k)                                             \
    {                                                                                              \
        return k >= 0 && k < f.in_count ? f.in_sparsity[k] : NULL;                                 \
    }                                                                                              \
    const casadi_int *name##_sparsity_out(casadi_int k)                                            \
    {                                                                                              \
        return k >= 0 && k < f.out_count ? f.out_sparsity[k] : NULL;                               \
    }                                                                                              \
    int name##_work(casadi_int *args, casadi_int *results, casadi_int *iw, casadi_int *w)          \
    {                                                                                              \
        *args = f.in_count + 1;                                                                    \
        *results = f.out_count;                                                                    \
        *iw = 0;                                                                                   \
        *w = memory_of(&f);                                                                        \
        return 0;                                                                                  \
    }                                                                                              \
    int name(const double **arg, double **res, casadi_int *iw, double *w, int memory)              \
    {                                                                                              \
        (void)iw;                                                                                  \
        (void)memory;                                                                              \
        return run(&f, arg, res, w);                                                               \
    }
