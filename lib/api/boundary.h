// The C boundary: an exception becomes a status and this thread's last error; none passes through. The host's
// floating-point settings do not count inside.
#pragma once

#include <claque/base.h>

#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "lib/api/struct_size.h"
#include "lib/base/error.h"
#include "lib/base/floats.h"
#include "lib/base/host_call.h"
#include "lib/base/status.h"

namespace claque::api
{

// Runs the body of a public call. The body throws base::Error or std::bad_alloc, or returns normally for CLQ_OK.
template <class Body>
clq_status boundary(const char *function, const Body &body) noexcept
{
    char text[1024];
    try {
        base::with_own_floats(body);
        return CLQ_OK;
    } catch (const base::Error &error) {
        std::snprintf(text, sizeof text, "%s: %s", function, error.what());
        return clq_report(error.status(), text);
    } catch (const std::bad_alloc &) {
        std::snprintf(text, sizeof text, "%s: out of memory; nothing was changed", function);
        return clq_report(CLQ_OUT_OF_MEMORY, text);
    } catch (const std::length_error &) {
        std::snprintf(text, sizeof text, "%s: more than this machine can address; nothing was changed", function);
        return clq_report(CLQ_OUT_OF_MEMORY, text);
    } catch (const std::exception &error) {
        std::snprintf(text, sizeof text, "%s: %s", function, error.what());
        return clq_report(CLQ_LIMIT, text);
    } catch (...) {
        std::snprintf(text, sizeof text, "%s: an unknown exception was thrown", function);
        return clq_report(CLQ_LIMIT, text);
    }
}

inline void require(bool rule, const char *what)
{
    if (!rule) base::fail(CLQ_ARGUMENT, "%s", what);
}

inline void require(const base::Status &status)
{
    if (!status.ok()) base::fail(status.code, "%s", status.text);
}

// Gives bytes to a host's writer. False: it refused them. Allocates nothing.
inline bool host_takes(clq_write_function write, void *user, const void *bytes, size_t size_bytes)
{
    int refused = 0;
    require(base::call_host("the write function", [&] { refused = write(user, bytes, size_bytes); }));
    return refused == 0;
}

inline void require_array(const void *array, uint32_t count, const char *what)
{
    if (count && !array) base::fail(CLQ_ARGUMENT, "%s is NULL with a count of %u", what, count);
}

inline const char *name_of(const char *name) { return name ? name : ""; }

// The number in a host's enum: C allows any value, and reading an invalid one as an enum is undefined in C++.
template <class Enum>
unsigned number_of(const Enum &value)
{
    static_assert(sizeof(Enum) == sizeof(unsigned), "C hosts pass enums as int");
    unsigned number;
    std::memcpy(&number, &value, sizeof number);
    return number;
}

}  // namespace claque::api
