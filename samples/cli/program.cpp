#include "samples/cli/program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <sys/resource.h>

#include <CLI/CLI.hpp>

#include "lib/base/near_names.h"
#include "samples/cli/help.h"
#include "samples/cli/number_options.h"
#include "samples/cli/terminal.h"
#include "samples/cli/warnings.h"
#include "samples/io/joined.h"
#include "samples/io/unfinished.h"
#include "samples/processes/machine_share.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

std::vector<const CLI::App *> subcommands_of(const CLI::App &app)
{
    return app.get_subcommands([](const CLI::App *one) { return !one->get_name().empty(); });
}

// What is wrong where a subcommand is wanted and there is none; "" if that is not what is wrong.
std::string no_subcommand(const CLI::App &app, int argc, char **argv)
{
    const CLI::App *at = &app;
    for (int word = 1;; ++word) {
        std::vector<std::string> known;
        const CLI::App *next = nullptr;
        for (const CLI::App *one : subcommands_of(*at)) {
            known.push_back(one->get_name());
            if (word < argc && one->get_name() == argv[word]) next = one;
        }
        if (known.empty() || (!next && word < argc && argv[word][0] == '-')) return "";
        if (!next && word < argc)
            return "'" + std::string(argv[word]) + "' is no subcommand of " + at->get_name() +
                   claque::base::names_near(argv[word], known);
        if (!next) return at->get_name() + " needs a subcommand; there are: " + io::joined(known);
        at = next;
    }
}

// The first long option that the command does not have, where another is near; else "".
std::string unknown_option(const CLI::App &app, int argc, char **argv)
{
    const CLI::App *at = &app;
    while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
    std::vector<std::string> known;
    for (const CLI::Option *option : at->get_options())
        for (const std::string &name : option->get_lnames()) known.push_back("--" + name);
    for (int word = 1; word < argc && std::string_view(argv[word]) != "--"; ++word) {
        const std::string text = argv[word], name = text.substr(0, text.find('='));
        if (name.size() < 3 || name.rfind("--", 0) != 0) continue;
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string near = claque::base::near_names(name, known);
        return near.empty() ? "" : "'" + name + "' is no option of " + at->get_name() + ": " + near;
    }
    return "";
}

void add_quiet(CLI::App &app)
{
    const auto below = app.get_subcommands([](const CLI::App *one) { return !one->get_name().empty(); });
    if (below.empty()) app.add_flag_callback("--quiet", silence_warnings, "Print no warnings");
    for (CLI::App *one : below) add_quiet(*one);
}

int fail(const std::string &sentence)
{
    std::cerr << "claque: " << sentence << (sentence.empty() || sentence.back() == '.' ? "\n" : ".\n");
    return 1;
}

// printf shares the buffer of std::cout, but not its state.
int said_all()
{
    std::cout.flush();
    return std::cout && !std::ferror(stdout) ? 0 : fail("standard output could not be written");
}

int parse(CLI::App &app, int argc, char **argv)
{
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::Success &help) {
        app.exit(help);
        return said_all() == 0 ? -1 : 1;
    } catch (const CLI::ParseError &error) {
        std::string none = no_subcommand(app, argc, argv);
        if (none.empty()) none = unknown_option(app, argc, argv);
        if (none.empty()) app.exit(error, std::cerr, std::cerr);
        else std::cerr << none << "\nRun with --help for more information.\n";
        return 2;
    }
}

// A stack that ends is a crash without a word. The most that was measured is between 80 and 96 kB (`stage` with the
// market); stacks of threads, Mesa's among them, are as large.
constexpr rlim_t least_stack_bytes = 256 * 1024;

// Bytes of a stack that is too small; else 0.
rlim_t small_stack()
{
    rlimit found = {};
    if (getrlimit(RLIMIT_STACK, &found) != 0 || found.rlim_cur == RLIM_INFINITY) return 0;
    return found.rlim_cur < least_stack_bytes ? found.rlim_cur : 0;
}

}  // namespace

int run_program(int argc, char **argv, std::initializer_list<Add> subcommands)
{
    if (const rlim_t bytes = small_stack()) {
        std::fprintf(stderr, "claque: a stack may have %llu kB, and %llu are wanted: ulimit -s 8192 allows more.\n",
                     static_cast<unsigned long long>(bytes / 1024),
                     static_cast<unsigned long long>(least_stack_bytes / 1024));
        return 1;
    }
    show_control_characters();
    CLI::App app("Crowds of individuals on fixed-function OpenGL 1.1, drawn offscreen.", "claque");
    const std::string version = "claque " + std::to_string(CLQ_VERSION_MAJOR) + "." +
                                std::to_string(CLQ_VERSION_MINOR) + "." + std::to_string(CLQ_VERSION_PATCH);
    app.set_version_flag("--version", version);
    app.require_subcommand(1);
    app.formatter(help_format());
    app.failure_message(CLI::FailureMessage::simple);
    // A scheduler's job is one of as many as there are cores.
    if (processes::is_scheduled()) processes::take_mesa_threads(1);
    Work chosen;
    for (const Add add : subcommands) add(app, chosen);
    add_quiet(app);
    expect_plain_numbers(app);

    try {
        const int parsed = parse(app, argc, argv);
        if (parsed != 0) return parsed < 0 ? 0 : parsed;
        io::watch_signals();
        print_warnings();
        chosen();
        return said_all();
    } catch (const CLI::ParseError &misuse) {
        app.exit(misuse, std::cerr, std::cerr);
        return 2;
    } catch (const scenes::Failure &failure) {
        return fail(failure.what());
    } catch (const std::bad_alloc &) {
        return fail("out of memory");
    } catch (const std::exception &unexpected) {
        return fail(unexpected.what());
    }
}

}  // namespace cli
