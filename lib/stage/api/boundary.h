// The C boundary of libclaque-stage: an exception becomes a status and this thread's last error.
#pragma once

#include <claque/base.h>

#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "lib/stage/error.h"

namespace claque::stage
{

template <class Body>
clq_status boundary(const char *function, const Body &body) noexcept
{
    char text[1024];
    try {
        body();
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

inline const char *name_of(const char *name) { return name ? name : ""; }

}  // namespace claque::stage
