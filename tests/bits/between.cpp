// claque_bits_between SETTING [SECTION...]: the same lines, with each call and each task under these settings.
#include "tests/support/between.h"

#include <cstdio>
#include <cstring>
#include <thread>

#include "tests/bits/bits.h"

namespace
{

using host_floats::Callback;
using host_floats::now;
using host_floats::Words;

// Every other job on a thread of its own, under the settings of which each job begins and ends.
void run(void *, uint32_t count, void (*job)(void *, uint32_t), void *job_data)
{
    const Words &hosts = between::hostile->words;
    const Callback here(hosts);
    const auto run_from = [&](uint32_t first) {
        const Words usual = now();
        for (uint32_t i = first; i < count; i += 2) {
            host_floats::set(hosts);
            const Words found = now();
            job(job_data, i);
            const Words left = now();
            host_floats::set(usual);
            ++(left == found ? host_floats::met : host_floats::met_others);
        }
    };
    std::thread other(run_from, 1u);
    run_from(0);
    other.join();
}

}  // namespace

int main(int argc, char **argv)
{
    for (const host_floats::Setting &setting : host_floats::settings())
        if (argc > 1 && std::strcmp(setting.name, argv[1]) == 0) between::hostile = &setting;
    if (!between::hostile) {
        std::fprintf(stderr, "claque_bits_between: no settings '%s' on this processor\n", argc > 1 ? argv[1] : "");
        return 1;
    }
    clq_context_def def = clq_context_def_init();
    def.tasks.run = run;
    const int failed = bits::print_sections(&def, argv + 2, argv + argc);
    std::fprintf(stderr, "%llu tasks and callbacks under '%s'\n",
                 static_cast<unsigned long long>(host_floats::met.load()), argv[1]);
    return failed || host_floats::met < 1000 || host_floats::met_others > 0;
}
