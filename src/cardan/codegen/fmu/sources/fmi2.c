/* FMI 2.0 of an FMU: its calls as those of the core.
 *
 * Part of cardan. Standard: Modelica Association, Functional Mock-up Interface for Model Exchange and
 * Co-Simulation 2.0.4, 2022.
 */
#include "fmi2Functions.h"
#include "fmu_core.h"

static fmu_instance *core(fmi2Component c)
{
    return c;
}

/* The callbacks of the importer live as long as the instance does. */
static void report(const fmu_instance *m, fmu_status status, const char *category, const char *text)
{
    const fmi2CallbackLogger log = (fmi2CallbackLogger)m->logger.callback;

    if (log)
        log(m->logger.environment, m->name, (fmi2Status)status, category, "%s", text);
}

/* Return unless the state of the instance allows a call. */
#define ALLOW(call, phases)                                                                        \
    do {                                                                                           \
        if (fmu_allow(core(c), call, phases) != FMU_OK)                                            \
            return fmi2Error;                                                                      \
    } while (0)

/* Inquire, make, free */

const char *fmi2GetTypesPlatform(void)
{
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void)
{
    return fmi2Version;
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean loggingOn, size_t nCategories,
                               const fmi2String categories[])
{
    int events = nCategories == 0;

    ALLOW("fmi2SetDebugLogging", FMU_ANYTIME);
    for (size_t k = 0; k < nCategories; k++)
        events |= strcmp(categories[k], "logEvents") == 0 || strcmp(categories[k], "logAll") == 0;
    core(c)->logger.events = loggingOn && events;
    return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID,
                              fmi2String fmuResourceLocation, const fmi2CallbackFunctions *functions,
                              fmi2Boolean visible, fmi2Boolean loggingOn)
{
    const fmu_logger logger = {report, functions ? (void (*)(void))functions->logger : NULL,
                               functions ? functions->componentEnvironment : NULL, loggingOn};

    (void)fmuResourceLocation, (void)visible;
    return fmu_create(&cardan_fmu, fmuType == fmi2ModelExchange, instanceName, fmuGUID, logger);
}

void fmi2FreeInstance(fmi2Component c)
{
    fmu_free(core(c));
}

/* Modes */

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance,
                               fmi2Real startTime, fmi2Boolean stopTimeDefined, fmi2Real stopTime)
{
    ALLOW("fmi2SetupExperiment", FMU_INSTANTIATED);
    return (fmi2Status)fmu_setup(core(c), toleranceDefined, tolerance, startTime, stopTimeDefined, stopTime);
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    ALLOW("fmi2EnterInitializationMode", FMU_INSTANTIATED);
    return (fmi2Status)fmu_enter_initialization(core(c));
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    ALLOW("fmi2ExitInitializationMode", FMU_INITIALIZING);
    return (fmi2Status)fmu_exit_initialization(core(c));
}

fmi2Status fmi2Terminate(fmi2Component c)
{
    ALLOW("fmi2Terminate", FMU_EVENT_MODE | FMU_CONTINUOUS | FMU_STEPPING);
    core(c)->is.phase = FMU_TERMINATED;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component c)
{
    ALLOW("fmi2Reset", FMU_ANYTIME);
    return (fmi2Status)fmu_reset(core(c));
}

/* Values */

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[])
{
    ALLOW("fmi2GetReal", FMU_ANYTIME);
    return (fmi2Status)fmu_get(core(c), vr, nvr, value);
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Real value[])
{
    ALLOW("fmi2SetReal", FMU_ANYTIME & ~FMU_TERMINATED);
    return (fmi2Status)fmu_set(core(c), vr, nvr, value);
}

/* All variables are of the type Real. */
static fmi2Status other_type(fmi2Component c, const char *call, size_t count)
{
    ALLOW(call, FMU_ANYTIME);
    if (count == 0)
        return fmi2OK;
    return (fmi2Status)fmu_say(core(c), FMU_ERROR, "%s: all variables of this FMU are of the type Real.", call);
}

#define OTHER_TYPE(type)                                                                           \
    fmi2Status fmi2Get##type(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2##type value[]) \
    {                                                                                              \
        (void)vr, (void)value;                                                                     \
        return other_type(c, "fmi2Get" #type, nvr);                                                \
    }                                                                                              \
    fmi2Status fmi2Set##type(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,           \
                             const fmi2##type value[])                                             \
    {                                                                                              \
        (void)vr, (void)value;                                                                     \
        return other_type(c, "fmi2Set" #type, nvr);                                                \
    }

OTHER_TYPE(Integer)
OTHER_TYPE(Boolean)
OTHER_TYPE(String)

/* States of the FMU */

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    ALLOW("fmi2GetFMUstate", FMU_ANYTIME);
    return (fmi2Status)fmu_save(core(c), (fmu_saved **)FMUstate);
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate FMUstate)
{
    ALLOW("fmi2SetFMUstate", FMU_ANYTIME);
    return (fmi2Status)fmu_restore(core(c), FMUstate);
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    ALLOW("fmi2FreeFMUstate", FMU_ANYTIME);
    if (FMUstate)
        fmu_discard_state((fmu_saved **)FMUstate);
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate FMUstate, size_t *size)
{
    ALLOW("fmi2SerializedFMUstateSize", FMU_ANYTIME);
    return (fmi2Status)fmu_saved_size(core(c), FMUstate, size);
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate FMUstate, fmi2Byte serializedState[], size_t size)
{
    ALLOW("fmi2SerializeFMUstate", FMU_ANYTIME);
    return (fmi2Status)fmu_write_state(core(c), FMUstate, serializedState, size);
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte serializedState[], size_t size,
                                   fmi2FMUstate *FMUstate)
{
    ALLOW("fmi2DeSerializeFMUstate", FMU_ANYTIME);
    return (fmi2Status)fmu_read_state(core(c), serializedState, size, (fmu_saved **)FMUstate);
}

/* Derivatives */

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference vUnknown_ref[],
                                        size_t nUnknown, const fmi2ValueReference vKnown_ref[], size_t nKnown,
                                        const fmi2Real dvKnown[], fmi2Real dvUnknown[])
{
    ALLOW("fmi2GetDirectionalDerivative", FMU_INITIALIZING | FMU_ENTERED);
    return (fmi2Status)fmu_derivative(core(c), vUnknown_ref, nUnknown, vKnown_ref, nKnown, dvKnown, dvUnknown, 0);
}

/* Model exchange */

fmi2Status fmi2EnterEventMode(fmi2Component c)
{
    ALLOW("fmi2EnterEventMode", FMU_CONTINUOUS | FMU_EVENT_MODE);
    core(c)->is.phase = FMU_EVENT_MODE;
    return fmi2OK;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c)
{
    ALLOW("fmi2EnterContinuousTimeMode", FMU_EVENT_MODE);
    if (fmu_settle(core(c)) != FMU_OK)
        return fmi2Error;
    core(c)->is.phase = FMU_CONTINUOUS;
    return fmi2OK;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *fmi2eventInfo)
{
    fmu_update update;
    fmu_status status;

    ALLOW("fmi2NewDiscreteStates", FMU_EVENT_MODE);
    status = fmu_update_discrete(core(c), &update);
    *fmi2eventInfo = (fmi2EventInfo){
        .terminateSimulation = update.terminate,
        .valuesOfContinuousStatesChanged = update.values_changed,
        .nextEventTimeDefined = update.next_defined,
        .nextEventTime = update.next,
    };
    return (fmi2Status)status;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi2Boolean *enterEventMode, fmi2Boolean *terminateSimulation)
{
    (void)noSetFMUStatePriorToCurrentPoint;
    ALLOW("fmi2CompletedIntegratorStep", FMU_CONTINUOUS);
    *terminateSimulation = fmi2False;
    return (fmi2Status)fmu_completed_step(core(c), enterEventMode);
}

fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time)
{
    ALLOW("fmi2SetTime", FMU_CONTINUOUS | FMU_EVENT_MODE);
    return (fmi2Status)fmu_set_time(core(c), time);
}

fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t nx)
{
    ALLOW("fmi2SetContinuousStates", FMU_CONTINUOUS);
    return (fmi2Status)fmu_set_states(core(c), x, nx);
}

fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t nx)
{
    ALLOW("fmi2GetContinuousStates", FMU_INITIALIZING | FMU_ENTERED);
    return (fmi2Status)fmu_get_states(core(c), x, nx);
}

fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real derivatives[], size_t nx)
{
    ALLOW("fmi2GetDerivatives", FMU_INITIALIZING | FMU_ENTERED);
    return (fmi2Status)fmu_get_block(core(c), FMU_RATE, derivatives, nx);
}

fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real eventIndicators[], size_t ni)
{
    ALLOW("fmi2GetEventIndicators", FMU_INITIALIZING | FMU_ENTERED);
    return (fmi2Status)fmu_get_block(core(c), FMU_INDICATOR, eventIndicators, ni);
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x_nominal[], size_t nx)
{
    ALLOW("fmi2GetNominalsOfContinuousStates", FMU_ANYTIME);
    for (size_t k = 0; k < nx; k++)
        x_nominal[k] = 1;
    return fmi2OK;
}

/* Co-simulation */

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                       const fmi2Integer order[], const fmi2Real value[])
{
    ALLOW("fmi2SetRealInputDerivatives", FMU_INSTANTIATED | FMU_INITIALIZING | FMU_STEPPING);
    return (fmi2Status)fmu_set_input_derivatives(core(c), vr, nvr, order, value);
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                        const fmi2Integer order[], fmi2Real value[])
{
    (void)vr, (void)order, (void)value;
    ALLOW("fmi2GetRealOutputDerivatives", FMU_ANYTIME);
    if (nvr == 0)
        return fmi2OK;
    return (fmi2Status)fmu_say(core(c), FMU_ERROR, "fmi2GetRealOutputDerivatives: this FMU has none "
                               "(maxOutputDerivativeOrder is 0).");
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real currentCommunicationPoint, fmi2Real communicationStepSize,
                      fmi2Boolean noSetFMUStatePriorToCurrentPoint)
{
    fmu_status status;

    (void)noSetFMUStatePriorToCurrentPoint;
    ALLOW("fmi2DoStep", FMU_STEPPING);
    status = fmu_do_step(core(c), currentCommunicationPoint, communicationStepSize);
    /* a motion that ends within the step: fmi2GetBooleanStatus says so */
    if (status == FMU_OK && core(c)->is.terminated)
        return (fmi2Status)fmu_say(core(c), FMU_DISCARD, "fmi2DoStep: the motion ended at t = %.9g s.",
                                   core(c)->at.run.t);
    return (fmi2Status)status;
}

fmi2Status fmi2CancelStep(fmi2Component c)
{
    ALLOW("fmi2CancelStep: steps are done when they return; it", 0);
    return fmi2OK;
}

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind s, fmi2Status *value)
{
    (void)s, (void)value;
    ALLOW("fmi2GetStatus", FMU_ANYTIME);
    return fmi2Discard;
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind s, fmi2Real *value)
{
    ALLOW("fmi2GetRealStatus", FMU_ANYTIME);
    if (s != fmi2LastSuccessfulTime)
        return fmi2Discard;
    *value = core(c)->at.run.t;
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind s, fmi2Integer *value)
{
    (void)s, (void)value;
    ALLOW("fmi2GetIntegerStatus", FMU_ANYTIME);
    return fmi2Discard;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind s, fmi2Boolean *value)
{
    ALLOW("fmi2GetBooleanStatus", FMU_ANYTIME);
    if (s != fmi2Terminated)
        return fmi2Discard;
    *value = core(c)->is.terminated ? fmi2True : fmi2False;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind s, fmi2String *value)
{
    (void)s, (void)value;
    ALLOW("fmi2GetStringStatus", FMU_ANYTIME);
    return fmi2Discard;
}
