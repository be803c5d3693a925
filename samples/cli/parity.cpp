// claque parity: claque as the reference of other renderers (docs/parity.md).
#include "samples/cli/parity.h"

namespace cli
{

void add_parity(CLI::App &app, Work &chosen)
{
    CLI::App *c = app.add_subcommand("parity", "Hold another renderer's crowd against claque's");
    c->require_subcommand(1);
    add_parity_export(*c, chosen);
    add_parity_capture(*c, chosen);
    add_parity_compare(*c, chosen);
}

}  // namespace cli
