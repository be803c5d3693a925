// The result of code that must not throw: updates and drawing. Allocates nothing and is cheap in the good case.
#pragma once

#include <claque/base.h>

#include <cstdarg>
#include <cstdio>

namespace claque::base
{

struct Status {
    clq_status code = CLQ_OK;
    char text[240] = {0};

    bool ok() const { return code == CLQ_OK; }

    static Status good() { return Status(); }
    static Status bad(clq_status code, const char *format, ...) __attribute__((format(printf, 2, 3)))
    {
        Status status;
        status.code = code;
        va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(status.text, sizeof status.text, format, arguments);
        va_end(arguments);
        return status;
    }
};

}  // namespace claque::base
