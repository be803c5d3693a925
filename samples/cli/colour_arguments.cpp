#include "samples/cli/colour_arguments.h"

#include <iostream>

namespace cli
{

CLI::Option *add_colours_option(CLI::App &command, std::string &file, bool &wild, const std::string &about)
{
    const auto take = [&file, &wild](const std::string &value) {
        wild = value == "wild";
        file = wild ? "" : value;
    };
    return command
        .add_option_function<std::string>(
            "--colours", take, about + "; wild: characters from files wear most hues, not colours near their files'")
        ->type_name("FILE|wild");
}

void add_colour_options(CLI::App &command, ColourArguments &arguments)
{
    CLI::Option *file = add_colours_option(
        command, arguments.file, arguments.wild,
        "Colours of people by class and zone (TOML, see `claque colours`) instead of the scene's own");
    command
        .add_flag("--reload", arguments.reload,
                  "Check the file of colours before every frame and apply it when it has changed; a broken file "
                  "changes nothing")
        ->needs(file);
}

SceneColours::SceneColours(scenes::Library &library, const ColourArguments &arguments, uint64_t seed)
    : reload_(arguments.reload), seed_(seed)
{
    if (arguments.wild && reload_)
        throw scenes::Failure("--reload needs a file of colours, which may change: --colours wild names none");
    if (!arguments.file.empty()) file_.emplace(library, arguments.file);
}

void SceneColours::apply_to(const scenes::SceneRenderer &scene_renderer)
{
    if (!file_ || (applied_ && !reload_)) return;
    try {
        file_->apply(scene_renderer.scene(), seed_);
        applied_ = true;
    } catch (const scenes::Failure &broken) {
        if (!applied_) throw;
        std::cerr << "claque: colours are unchanged: " << broken.what() << '\n';
    }
}

}  // namespace cli
