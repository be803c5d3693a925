// The C boundary of libclaque-stage: an exception becomes a status and this thread's last error.
#pragma once

#include <claque/base.h>

#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "lib/stage/error.h"
#include "lib/stage/floats.h"

namespace claque::stage
{

template <class Body>
clq_status boundary(const char *function, const Body &body) noexcept
{
    char text[1024];
    try {
        with_own_floats(body);
        return CLQ_OK;
    } catch (const Error &error) {
        std::snprintf(text, sizeof text, "%s: %s", function, error.what());
        return clq_report(error.status(), text);
    } catch (const std::bad_alloc &) {
        std::snprintf(text, sizeof text, "%s: out of memory", function);
        return clq_report(CLQ_OUT_OF_MEMORY, text);
    } catch (const std::length_error &) {
        std::snprintf(text, sizeof text, "%s: more than this machine can address", function);
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
    if (!rule) fail(CLQ_ARGUMENT, "%s", what);
}

template <class Struct>
void require_size(const Struct &host, const char *init)
{
    if (host.struct_bytes == sizeof(Struct)) return;
    fail(CLQ_STRUCT_SIZE, "struct_bytes is %u, which no header up to %d.%d.%d gives; %s gives %zu", host.struct_bytes,
         CLQ_VERSION_MAJOR, CLQ_VERSION_MINOR, CLQ_VERSION_PATCH, init, sizeof(Struct));
}

// The sizes of a struct in earlier released headers, as in lib/api/struct_size.h.
template <class Struct>
struct EarlierSizes {
    static constexpr uint32_t sizes[] = {0};
};

// Copies the host's struct: members that a shorter one lacks get defaults. NULL: all defaults.
template <class Def>
Def read_def(const Def *host, Def (*init)(), const char *init_name)
{
    Def def = init();
    if (!host) return def;
    bool is_known = false;
    for (const uint32_t size : EarlierSizes<Def>::sizes) is_known = is_known || (size && host->struct_bytes == size);
    if (!is_known) require_size(*host, init_name);
    std::memcpy(&def, host, host->struct_bytes);
    def.struct_bytes = static_cast<uint32_t>(sizeof def);
    return def;
}

inline const char *name_of(const char *name) { return name ? name : ""; }

}  // namespace claque::stage
