/* FMI 3.0 of an FMU: its calls as those of the core.
 *
 * Part of cardan. Standard: Modelica Association, Functional Mock-up Interface 3.0, 2022.
 */
#include "fmi3Functions.h"
#include "fmu_core.h"

static fmu_instance *core(fmi3Instance instance)
{
    return instance;
}

static void report(const fmu_instance *m, fmu_status status, const char *category, const char *text)
{
    const fmi3LogMessageCallback log = (fmi3LogMessageCallback)m->logger.callback;

    if (log)
        log(m->logger.environment, (fmi3Status)status, category, text);
}

/* Return unless the state of the instance allows a call. */
#define ALLOW(call, phases)                                                                        \
    do {                                                                                           \
        if (fmu_allow(core(instance), call, phases) != FMU_OK)                                     \
            return fmi3Error;                                                                      \
    } while (0)
/* Return an error unless two lengths are equal. */
#define SAME(call, a, b)                                                                           \
    do {                                                                                           \
        if ((a) != (b))                                                                            \
            return (fmi3Status)fmu_say(core(instance), FMU_ERROR, "%s: there are %llu values for %llu variables.", \
                                       call, (unsigned long long)(b), (unsigned long long)(a));    \
    } while (0)

/* Inquire, make, free */

const char *fmi3GetVersion(void)
{
    return fmi3Version;
}

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean loggingOn, size_t nCategories,
                               const fmi3String categories[])
{
    int events = nCategories == 0;

    ALLOW("fmi3SetDebugLogging", FMU_ANYTIME);
    for (size_t k = 0; k < nCategories; k++)
        events |= strcmp(categories[k], "logEvents") == 0;
    core(instance)->logger.events = loggingOn && events;
    return fmi3OK;
}

static fmi3Instance instantiate(int exchange, fmi3String name, fmi3String token, fmi3Boolean loggingOn,
                                fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    const fmu_logger logger = {report, (void (*)(void))log, environment, loggingOn};

    return fmu_create(&cardan_fmu, exchange, name, token, logger);
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String instanceName, fmi3String instantiationToken,
                                          fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
                                          fmi3InstanceEnvironment instanceEnvironment,
                                          fmi3LogMessageCallback logMessage)
{
    (void)resourcePath, (void)visible;
    return instantiate(1, instanceName, instantiationToken, loggingOn, instanceEnvironment, logMessage);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String instanceName, fmi3String instantiationToken,
                                         fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
                                         fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
                                         const fmi3ValueReference requiredIntermediateVariables[],
                                         size_t nRequiredIntermediateVariables,
                                         fmi3InstanceEnvironment instanceEnvironment,
                                         fmi3LogMessageCallback logMessage,
                                         fmi3IntermediateUpdateCallback intermediateUpdate)
{
    fmu_instance *m;

    (void)resourcePath, (void)visible, (void)earlyReturnAllowed;
    (void)requiredIntermediateVariables, (void)nRequiredIntermediateVariables, (void)intermediateUpdate;
    m = instantiate(0, instanceName, instantiationToken, loggingOn, instanceEnvironment, logMessage);
    if (m && eventModeUsed) {
        (void)fmu_say(m, FMU_ERROR, "fmi3InstantiateCoSimulation: there is no Event Mode (hasEventMode is false): "
                      "events happen within steps.");
        fmu_free(m);
        return NULL;
    }
    return m;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String instanceName, fmi3String instantiationToken,
                                               fmi3String resourcePath, fmi3Boolean visible,
                                               fmi3Boolean loggingOn,
                                               fmi3InstanceEnvironment instanceEnvironment,
                                               fmi3LogMessageCallback logMessage,
                                               fmi3ClockUpdateCallback clockUpdate,
                                               fmi3LockPreemptionCallback lockPreemption,
                                               fmi3UnlockPreemptionCallback unlockPreemption)
{
    (void)instanceName, (void)instantiationToken, (void)resourcePath, (void)visible, (void)loggingOn;
    (void)clockUpdate, (void)lockPreemption, (void)unlockPreemption;
    if (logMessage)
        logMessage(instanceEnvironment, fmi3Error, "logStatusError",
                   "fmi3InstantiateScheduledExecution: this FMU has no Scheduled Execution.");
    return NULL;
}

void fmi3FreeInstance(fmi3Instance instance)
{
    fmu_free(core(instance));
}

/* Modes */

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean toleranceDefined,
                                       fmi3Float64 tolerance, fmi3Float64 startTime,
                                       fmi3Boolean stopTimeDefined, fmi3Float64 stopTime)
{
    ALLOW("fmi3EnterInitializationMode", FMU_INSTANTIATED);
    if (fmu_setup(core(instance), toleranceDefined, tolerance, startTime, stopTimeDefined, stopTime) != FMU_OK)
        return fmi3Error;
    return (fmi3Status)fmu_enter_initialization(core(instance));
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance)
{
    ALLOW("fmi3ExitInitializationMode", FMU_INITIALIZING);
    return (fmi3Status)fmu_exit_initialization(core(instance));
}

fmi3Status fmi3EnterEventMode(fmi3Instance instance)
{
    ALLOW("fmi3EnterEventMode", FMU_CONTINUOUS | FMU_EVENT_MODE);
    core(instance)->is.phase = FMU_EVENT_MODE;
    return fmi3OK;
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance)
{
    ALLOW("fmi3EnterContinuousTimeMode", FMU_EVENT_MODE);
    if (fmu_settle(core(instance)) != FMU_OK)
        return fmi3Error;
    core(instance)->is.phase = FMU_CONTINUOUS;
    return fmi3OK;
}

fmi3Status fmi3EnterStepMode(fmi3Instance instance)
{
    ALLOW("fmi3EnterStepMode", 0);
    return fmi3OK;
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance)
{
    ALLOW("fmi3EnterConfigurationMode: there are no structural parameters; it", 0);
    return fmi3OK;
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance)
{
    ALLOW("fmi3ExitConfigurationMode", 0);
    return fmi3OK;
}

fmi3Status fmi3Terminate(fmi3Instance instance)
{
    ALLOW("fmi3Terminate", FMU_EVENT_MODE | FMU_CONTINUOUS | FMU_STEPPING);
    core(instance)->is.phase = FMU_TERMINATED;
    return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance instance)
{
    ALLOW("fmi3Reset", FMU_ANYTIME);
    return (fmi3Status)fmu_reset(core(instance));
}

/* Values */

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                          size_t nValueReferences, fmi3Float64 values[], size_t nValues)
{
    ALLOW("fmi3GetFloat64", FMU_ANYTIME);
    SAME("fmi3GetFloat64", nValueReferences, nValues);
    return (fmi3Status)fmu_get(core(instance), valueReferences, nValueReferences, values);
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                          size_t nValueReferences, const fmi3Float64 values[], size_t nValues)
{
    ALLOW("fmi3SetFloat64", FMU_ANYTIME & ~FMU_TERMINATED);
    SAME("fmi3SetFloat64", nValueReferences, nValues);
    return (fmi3Status)fmu_set(core(instance), valueReferences, nValueReferences, values);
}

/* All variables are of the type Float64. */
static fmi3Status other_type(fmi3Instance instance, const char *call, size_t count)
{
    ALLOW(call, FMU_ANYTIME);
    if (count == 0)
        return fmi3OK;
    return (fmi3Status)fmu_say(core(instance), FMU_ERROR, "%s: all variables of this FMU are of the type Float64.", call);
}

#define OTHER_TYPE(type)                                                                           \
    fmi3Status fmi3Get##type(fmi3Instance instance, const fmi3ValueReference valueReferences[],    \
                             size_t nValueReferences, fmi3##type values[], size_t nValues)         \
    {                                                                                              \
        (void)valueReferences, (void)values, (void)nValues;                                        \
        return other_type(instance, "fmi3Get" #type, nValueReferences);                            \
    }                                                                                              \
    fmi3Status fmi3Set##type(fmi3Instance instance, const fmi3ValueReference valueReferences[],    \
                             size_t nValueReferences, const fmi3##type values[], size_t nValues)   \
    {                                                                                              \
        (void)valueReferences, (void)values, (void)nValues;                                        \
        return other_type(instance, "fmi3Set" #type, nValueReferences);                            \
    }

OTHER_TYPE(Float32)
OTHER_TYPE(Int8)
OTHER_TYPE(UInt8)
OTHER_TYPE(Int16)
OTHER_TYPE(UInt16)
OTHER_TYPE(Int32)
OTHER_TYPE(UInt32)
OTHER_TYPE(Int64)
OTHER_TYPE(UInt64)
OTHER_TYPE(Boolean)
OTHER_TYPE(String)

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                         size_t nValueReferences, size_t valueSizes[], fmi3Binary values[], size_t nValues)
{
    (void)valueReferences, (void)valueSizes, (void)values, (void)nValues;
    return other_type(instance, "fmi3GetBinary", nValueReferences);
}

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                         size_t nValueReferences, const size_t valueSizes[], const fmi3Binary values[],
                         size_t nValues)
{
    (void)valueReferences, (void)valueSizes, (void)values, (void)nValues;
    return other_type(instance, "fmi3SetBinary", nValueReferences);
}

fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                        size_t nValueReferences, fmi3Clock values[])
{
    (void)valueReferences, (void)values;
    return other_type(instance, "fmi3GetClock", nValueReferences);
}

fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                        size_t nValueReferences, const fmi3Clock values[])
{
    (void)valueReferences, (void)values;
    return other_type(instance, "fmi3SetClock", nValueReferences);
}
