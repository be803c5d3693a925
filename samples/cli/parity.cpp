// claque parity: claque as the reference for other renderers (docs/parity.md).
#include "samples/cli/parity.h"

namespace cli
{

void add_parity(CLI::App &app, Work &chosen)
{
    CLI::App *c = app.add_subcommand("parity", "Compare another renderer's crowd with claque's");
    c->require_subcommand(1);
    add_parity_export(*c, chosen);
    add_parity_capture(*c, chosen);
    add_parity_compare(*c, chosen);
}

}  // namespace cli
