// Calls of the host's actions, under the host's floating-point settings. What they throw ends here and goes to the log.
#pragma once

#include <claque/context.h>

#include <cstdio>
#include <exception>

#include "lib/stage/floats.h"

namespace claque::stage
{

template <class Call>
void call_host(clq_context *context, const char *action, const Call &call) noexcept
{
    char text[256];
    try {
        with_host_floats(call);
        return;
    } catch (const std::exception &error) {
        std::snprintf(text, sizeof text, "the action '%.80s' threw an exception: %.140s", action, error.what());
    } catch (...) {
        std::snprintf(text, sizeof text, "the action '%.80s' threw an exception that is no std::exception", action);
    }
    clq_context_log(context, CLQ_LOG_WARNING, text);
}

}  // namespace claque::stage
