// Switches of floating-point settings, as in lib/base/floats.h.
#pragma once

#include <claque/base.h>

namespace claque::stage
{

// Switches this thread to claque's own settings or to the host's, and back at its end.
template <bool own>
class Floats
{
public:
    Floats() : switched_(own ? clq_floats_enter() : clq_floats_leave()) {}
    ~Floats()
    {
        if (switched_) own ? clq_floats_leave() : clq_floats_enter();
    }
    Floats(const Floats &) = delete;
    Floats &operator=(const Floats &) = delete;

private:
    bool switched_;
};

template <class Body>
[[gnu::noinline]] void call_out_of_line(const Body &body)
{
    body();
}

template <class Body>
void with_own_floats(const Body &body)
{
    const Floats<true> own;
    call_out_of_line(body);
}

template <class Call>
void with_host_floats(const Call &call)
{
    const Floats<false> host;
    call_out_of_line(call);
}

}  // namespace claque::stage
