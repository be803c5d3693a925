// Included before all else where each call of the C API runs under settings that the host may have: its arguments are
// computed outside, and the call must leave the settings and flags as they were. Callbacks of such programs compute
// within host_floats::Callback.
#pragma once

#include <claque/agents.h>
#include <claque/assets.h>
#include <claque/claque.h>
#include <claque/colour_files.h>
#include <claque/levels.h>
#include <claque/navigation.h>
#include <claque/prepare.h>
#include <claque/stage.h>
#include <claque/trajectories.h>
#include <claque/zones.h>

#include "tests/support/host_floats.h"

namespace between
{

extern const host_floats::Setting *hostile;  // null: calls run as they are

// Ends the program if `call` has changed the settings.
class Entered
{
public:
    explicit Entered(const char *call);
    ~Entered();

private:
    const char *call_;
    host_floats::Words before_, found_;
};

template <class Result, class... Arguments>
struct Function {
    Result (*function)(Arguments...);
    const char *name;

    Result operator()(Arguments... arguments) const
    {
        if (!hostile) return function(arguments...);
        const Entered entered(name);
        return function(arguments...);
    }
};

template <class Result, class... Arguments>
Function<Result, Arguments...> call_of(Result (*function)(Arguments...), const char *name)
{
    return {function, name};
}

}  // namespace between

#include "between_calls.h"
