// claque-pictures: the subcommands of claque that draw pictures, for `make run`, which builds nothing else.
#include "samples/cli/program.h"

int main(int argc, char **argv)
{
    return cli::run_program(argc, argv, {cli::add_render, cli::add_sheet, cli::add_variety});
}
