// Calls of the host's callbacks, under the host's floating-point settings. An exception of a callback ends here and
// becomes a status.
#pragma once

#include <exception>

#include "lib/base/floats.h"
#include "lib/base/status.h"

namespace claque::base
{

// Runs `call`, which calls the callback that `name` describes. Returns CLQ_CALLBACK if it throws.
template <class Call>
Status call_host(const char *name, const Call &call) noexcept
{
    try {
        with_host_floats(call);
        return Status::good();
    } catch (const std::exception &error) {
        return Status::bad(CLQ_CALLBACK, "%s threw an exception: %.160s", name, error.what());
    } catch (...) {
        return Status::bad(CLQ_CALLBACK, "%s threw an exception that is no std::exception", name);
    }
}

// The callbacks of one update or draw. After the first exception no further one is called.
class HostCalls
{
public:
    bool ok() const { return thrown_.ok(); }
    const Status &status() const { return thrown_; }

    // False: the callback threw, or was not called. The number names what it was called for.
    template <class Call>
    bool run(const char *name, uint32_t actor1, const Call &call) noexcept
    {
        if (!ok()) return false;
        try {
            with_host_floats(call);
            return true;
        } catch (const std::exception &error) {
            thrown_ =
                Status::bad(CLQ_CALLBACK, "%s threw an exception at actor %u: %.160s", name, actor1, error.what());
        } catch (...) {
            thrown_ =
                Status::bad(CLQ_CALLBACK, "%s threw an exception at actor %u that is no std::exception", name, actor1);
        }
        return false;
    }

private:
    Status thrown_;
};

}  // namespace claque::base
