#include "lib/stage/error.h"

#include <cstdarg>
#include <cstdio>

namespace claque::stage
{

namespace
{

std::string format_text(const char *format, va_list arguments)
{
    char buffer[1024];
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    return buffer;
}

}  // namespace

void fail(clq_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    std::string text;
    try {
        text = format_text(format, arguments);
    } catch (...) {
        va_end(arguments);
        throw;
    }
    va_end(arguments);
    throw Error(status, std::move(text));
}

std::string text_of(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    std::string text;
    try {
        text = format_text(format, arguments);
    } catch (...) {
        va_end(arguments);
        throw;
    }
    va_end(arguments);
    return text;
}

}  // namespace claque::stage
