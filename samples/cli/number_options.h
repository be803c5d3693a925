// What numbers of options may look like.
#pragma once

namespace CLI
{

class App;

}

namespace cli
{

// Numbers of every option, also of subcommands: decimal, of at most 64 bits, finite. The parser itself takes the
// largest number for one that is larger, 8 for 010, and NaN within any range.
void expect_plain_numbers(CLI::App &app);

}  // namespace cli
