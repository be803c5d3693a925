// The one exception of start-up code. It is caught in lib/api, or in a job that turns it into a Status.
#pragma once

#include <claque/base.h>

#include <exception>
#include <string>

namespace claque::base
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

// printf-like: one sentence with names and numbers, no full stop needed at the end.
// A 64-bit number in the type that %llu takes.
inline unsigned long long big(uint64_t n) { return n; }

[[noreturn]] void fail(clq_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

std::string text_of(const char *format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace claque::base
