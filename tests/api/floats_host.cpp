#include "tests/api/floats_host.h"

#include <cmath>
#include <cstring>
#include <new>
#include <thread>

#include "tests/api/stub_gl.h"

namespace floats_host
{

namespace
{

NotingHost &host_of(void *user) { return *static_cast<NotingHost *>(user); }

void *allocate(void *user, size_t bytes, size_t alignment)
{
    return host_of(user).called("allocate",
                                [&] { return ::operator new(bytes, std::align_val_t(alignment), std::nothrow); });
}

void release(void *user, void *memory, size_t, size_t alignment)
{
    host_of(user).called("release", [&] { ::operator delete(memory, std::align_val_t(alignment)); });
}

void write_log(void *user, clq_log_level, const char *)
{
    host_of(user).called("log", [] {});
}

// Jobs run under the host's settings on both threads, and leave them as they were.
void run_tasks(void *user, uint32_t count, void (*job)(void *, uint32_t), void *job_data)
{
    NotingHost &host = host_of(user);
    host.called("tasks", [&] {
        const auto run_from = [&](uint32_t first) {
            for (uint32_t i = first; i < count; i += 2) host.call([&] { return job(job_data, i), CLQ_OK; });
        };
        std::thread other(run_from, 1u);
        run_from(0);
        other.join();
    });
}

NotingHost *gl_host = nullptr;
void (*draw_elements)(uint32_t, int32_t, uint32_t, const void *) = nullptr;
void (*load_matrix)(const float *) = nullptr;
const uint8_t *(*get_string)(uint32_t) = nullptr;

void draw_noted(uint32_t mode, int32_t count, uint32_t type, const void *indices)
{
    gl_host->called("glDrawElements", [&] { draw_elements(mode, count, type, indices); });
}
void load_noted(const float *columns)
{
    gl_host->called("glLoadMatrixf", [&] { load_matrix(columns); });
}
const uint8_t *get_noted(uint32_t name)
{
    return gl_host->called("glGetString", [&] { return get_string(name); });
}

template <class Function>
clq_gl_function noted(Function &real, Function noted, clq_gl_function found)
{
    real = reinterpret_cast<Function>(found);
    return reinterpret_cast<clq_gl_function>(noted);
}

}  // namespace

clq_context_def context_of(NotingHost &host)
{
    clq_context_def def = clq_context_def_init();
    def.allocator = {&host, allocate, release};
    def.log = {&host, write_log};
    def.tasks = {&host, run_tasks};
    return def;
}

double height(void *user, const double point[3])
{
    return host_of(user).called("height", [&] { return 0.2 * std::sin(point[0]); });
}

void move(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
{
    NotingHost &host = host_of(user);
    float value = 0;
    host.called("mechanism", [&] { value = static_cast<float>(0.1 + 0.1 * std::sin(call->time_s)); });
    clq_dof_write(writer, 2, value, 0.3f);  // under the host's settings
}

double now_s(void *user)
{
    static double time_s = 0;
    return host_of(user).called("clock", [] { return time_s += 1e-6; });
}

int write(void *user, const void *, size_t)
{
    return host_of(user).called("write", [] { return 0; });
}

clq_gl_function find(void *user, const char *name)
{
    gl_host = &host_of(user);
    return gl_host->called("get_proc_address", [&] {
        const clq_gl_function found = stub_gl::find(nullptr, name);
        if (std::strcmp(name, "glDrawElements") == 0) return noted(draw_elements, draw_noted, found);
        if (std::strcmp(name, "glLoadMatrixf") == 0) return noted(load_matrix, load_noted, found);
        if (std::strcmp(name, "glGetString") == 0) return noted(get_string, get_noted, found);
        return found;
    });
}

clq_actor_hooks hooks_of(NotingHost &host)
{
    clq_actor_hooks hooks = {};
    hooks.user = &host;
    hooks.before = [](void *user, clq_actor) { return host_of(user).called("before", [] { return false; }); };
    hooks.after = [](void *user, clq_actor) { host_of(user).called("after", [] {}); };
    return hooks;
}

}  // namespace floats_host
