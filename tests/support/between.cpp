#include "tests/support/between.h"

#include <cstdio>
#include <cstdlib>

namespace between
{

const host_floats::Setting *hostile = nullptr;

Entered::Entered(const char *call) : call_(call), before_(host_floats::now())
{
    host_floats::set(hostile->words);
    found_ = host_floats::now();
}

Entered::~Entered()
{
    const host_floats::Words left = host_floats::now();
    host_floats::set(before_);
    if (left == found_) return;
    std::fprintf(stderr, "%s has left other floating-point settings: %llx %llx, not %llx %llx\n", call_,
                 static_cast<unsigned long long>(left.control), static_cast<unsigned long long>(left.raised),
                 static_cast<unsigned long long>(found_.control), static_cast<unsigned long long>(found_.raised));
    std::abort();
}

}  // namespace between
