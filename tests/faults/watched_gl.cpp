#include "tests/faults/watched_gl.h"

#include <cstring>
#include <optional>

#include "tests/api/failing_memory.h"
#include "tests/api/stub_gl.h"
#include "tests/faults/gl_effects.h"

namespace watched_gl
{
namespace
{

// False: this call has no effect.
bool enter()
{
    ++count;
    if (kind == Loss::context) return count < lost_at;
    return true;
}

// A call from claque meets the settings of the host.
class HostFloats
{
public:
    HostFloats()
    {
        if (between::hostile) meets_.emplace(between::hostile->words);
    }

private:
    std::optional<host_floats::Callback> meets_;
};

template <Id id, class Function>
struct Watched;
template <Id id, class Result, class... Arguments>
struct Watched<id, Result (*)(Arguments...)> {
    static Result (*under)(Arguments...);
    static Result call(Arguments... arguments)
    {
        const failing_memory::Unarmed unarmed;
        const HostFloats floats;
        if (!enter()) return Result();
        if constexpr (std::is_void_v<Result>) {
            if (under && id != Id::DrawElements) under(arguments...);
            effect(std::integral_constant<Id, id>(), arguments...);
        } else {
            effect(std::integral_constant<Id, id>(), arguments...);
            return under(arguments...);
        }
    }
};
template <Id id, class Result, class... Arguments>
Result (*Watched<id, Result (*)(Arguments...)>::under)(Arguments...) = nullptr;

template <Id id, class Function>
clq_gl_function watch(const char *name)
{
    Watched<id, Function>::under = reinterpret_cast<Function>(stub_gl::find(nullptr, name));
    return reinterpret_cast<clq_gl_function>(&Watched<id, Function>::call);
}

}  // namespace

clq_gl_function find(void *, const char *name)
{
    const failing_memory::Unarmed unarmed;
#define X(one) \
    if (std::strcmp(name, "gl" #one) == 0) return watch<Id::one, decltype(Gl11::one)::Pointer>(name);
    CALLS(X)
#undef X
    return nullptr;
}

void lose(Loss how, uint64_t n) { kind = how, lost_at = n, count = 0; }
uint64_t calls() { return count; }
void new_context()
{
    context = Context(), kind = Loss::none;
    stub_gl::new_context();
}

uint64_t picture()
{
    const uint64_t all = drawn.value;
    drawn = Hash();
    return all;
}

uint64_t state()
{
    Hash hash;
    hash.add(hash_of(context.settings)), hash.add(hash_of(context.client.settings));
    hash.add(context.mode), hash.add(context.bound);
    hash.add(context.pushed.size()), hash.add(context.pushed_client.size());
    for (const uint32_t mode : {gl::modelview, gl::projection, gl::texture})
        hash.add(top(mode)), hash.add(context.stacks[mode].size());
    for (const auto &[name, array] : context.client.arrays)
        if (array.on) hash.add(name);
    return hash.value;
}

uint64_t textures()
{
    Hash hash;
    for (const auto &[name, texture] : context.textures) {
        hash.add(name), hash.add(texture.width), hash.add(texture.texels);
        for (const auto &[parameter, value] : texture.parameters) hash.add(parameter), hash.add(value);
    }
    return hash.value;
}

size_t texture_count() { return context.textures.size(); }

}  // namespace watched_gl
