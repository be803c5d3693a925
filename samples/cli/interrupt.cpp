#include "samples/cli/interrupt.h"

#include <csignal>

#include "samples/scenes/check.h"

namespace cli
{
namespace
{

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void claque_cli_note_signal(int number) { asked_to_stop = number; }

}  // namespace

void watch_signals()
{
    std::signal(SIGINT, claque_cli_note_signal);
    std::signal(SIGTERM, claque_cli_note_signal);
    std::signal(SIGPIPE, SIG_IGN);
}

void stop_if_asked()
{
    if (asked_to_stop) throw scenes::Failure("stopped by a signal; finished frames are kept");
}

}  // namespace cli
