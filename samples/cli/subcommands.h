// The subcommands of the claque command: one file for each. Each adds itself to the parser. The chosen one stores its
// work in `chosen`, which runs after parsing, so that usage errors and failures stay apart. The parser is only named
// here: its header takes seconds to compile.
#pragma once

#include <functional>

namespace CLI
{

class App;

}

namespace cli
{

using Work = std::function<void()>;  // throws scenes::Failure

void add_render(CLI::App &app, Work &chosen);
void add_sheet(CLI::App &app, Work &chosen);
void add_inspect(CLI::App &app, Work &chosen);
void add_dump(CLI::App &app, Work &chosen);
void add_split(CLI::App &app, Work &chosen);
void add_variety(CLI::App &app, Work &chosen);
void add_colours(CLI::App &app, Work &chosen);
void add_lods(CLI::App &app, Work &chosen);
void add_blend(CLI::App &app, Work &chosen);
void add_prepare(CLI::App &app, Work &chosen);
void add_convert(CLI::App &app, Work &chosen);
void add_bench(CLI::App &app, Work &chosen);
void add_plot(CLI::App &app, Work &chosen);
void add_cost(CLI::App &app, Work &chosen);
void add_parity(CLI::App &app, Work &chosen);
void add_tracks(CLI::App &app, Work &chosen);
void add_play(CLI::App &app, Work &chosen);
void add_stage(CLI::App &app, Work &chosen);
void add_frames(CLI::App &app, Work &chosen);
void add_labels(CLI::App &app, Work &chosen);
void add_view(CLI::App &app, Work &chosen);

}  // namespace cli
