// In place of claque stage, where Recast was not found.
#include "samples/cli/command.h"
#include "samples/scenes/check.h"

namespace cli
{

void add_stage(CLI::App &app, Work &chosen)
{
    CLI::App *c = app.add_subcommand("stage", "Run a scenario whose people decide (this claque was built without it)");
    c->allow_extras();
    c->callback([&chosen] {
        chosen = [] {
            throw scenes::Failure(
                "this claque was built without people who find their way, which needs Recast: install librecast-dev, "
                "and build it again");
        };
    });
}

}  // namespace cli
