// In place of claque stage, and of claque bench with its walkers, where Recast was not found.
#include "samples/cli/bench.h"
#include "samples/cli/command.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

void refuse()
{
    throw scenes::Failure(
        "this claque was built without people who find their way, which needs Recast: install librecast-dev, and build "
        "it again");
}

}  // namespace

Json bench_halls(const BenchArguments &)
{
    refuse();
    return {};
}
void print_halls(const Json &) {}

void add_stage(CLI::App &app, Work &chosen)
{
    CLI::App *c = app.add_subcommand("stage", "Run a scenario whose people decide (this claque was built without it)");
    c->allow_extras();
    c->callback([&chosen] { chosen = refuse; });
}

}  // namespace cli
