// The one exception inside libclaque-stage. It ends at the C boundary.
#pragma once

#include <claque/base.h>

#include <exception>
#include <string>

namespace claque::stage
{

class Error : public std::exception
{
public:
    Error(clq_status status, std::string text) : status_(status), text_(std::move(text)) {}
    clq_status status() const noexcept { return status_; }
    const char *what() const noexcept override { return text_.c_str(); }

private:
    clq_status status_;
    std::string text_;
};

// printf-like: one sentence with names and numbers.
[[noreturn]] void fail(clq_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

std::string text_of(const char *format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace claque::stage
