#include "tests/parity/gl20.h"

namespace parity_test
{

Gl20::Gl20(const contexts::Offscreen &context)
{
    const auto find = [&](const char *name, auto &function) {
        function = reinterpret_cast<std::decay_t<decltype(function)>>(context.get_proc_address()(context.user(), name));
        return function != nullptr;
    };
#define PARITY_FIND(type, name, arguments) \
    if (!find("gl" #name, name)) throw Failure("this OpenGL context lacks gl" #name);
    PARITY_GL20(PARITY_FIND)
#undef PARITY_FIND
#define PARITY_FIND(type, name, arguments) find("gl" #name, name);
    PARITY_GL30(PARITY_FIND)
#undef PARITY_FIND
    while (GetError() != 0) {}
}

void Gl20::expect_no_error(const char *doing) const
{
    const unsigned error = GetError();
    if (error != 0) throw Failure(std::string(doing) + ": OpenGL error " + std::to_string(error));
}

}  // namespace parity_test
