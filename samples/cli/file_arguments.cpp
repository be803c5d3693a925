#include "samples/cli/file_arguments.h"

#include "samples/scenes/check.h"

namespace cli
{

void add_file_options(CLI::App &command, FileArguments &a)
{
    add_hide_option(command, a.placement);
    add_placement_options(command, a.placement);
}

void add_hide_option(CLI::App &command, scenes::Placement &placement)
{
    command
        .add_option("--hide", placement.hidden,
                    "Leave out the node of this name and its descendants, in the characters of files (may repeat)")
        ->expected(1)
        ->take_all();
}

void add_placement_options(CLI::App &command, scenes::Placement &placement)
{
    command.add_option("--turn", placement.turn_deg,
                       "Turn the characters of files about y, in degrees: 180 for one that shows its back");
    CLI::Option *height = command
                              .add_option("--height", placement.height_m,
                                          "Height of the characters of files at rest in metres (default: the file's)")
                              ->check(CLI::Range(1e-3, 1e4));
    if (command.get_option_no_throw("--scale") == nullptr)
        command.add_option("--scale", placement.scale, "Multiply the size of the characters of files")
            ->check(CLI::Range(1e-6, 1e6))
            ->excludes(height);
    command
        .add_option_function<std::string>(
            "--blend",
            [&placement](const std::string &text) {
                placement.blend = text == "opaque" ? CLQ_BLEND_OPAQUE : CLQ_BLEND_MASK;
            },
            "Draw materials of files that blend where their alpha is 0.5 and more (mask, the default), or all of them "
            "(opaque)")
        ->check(CLI::IsMember({"mask", "opaque"}));
}

void expect_files(const std::vector<scenes::SocialClass> &characters, const scenes::Placement &placement)
{
    for (const scenes::SocialClass &one : characters)
        if (scenes::is_file(one.character)) return;
    if (placement.any())
        throw scenes::Failure(
            "--turn, --height, --scale, --blend and --hide are for characters of files, and none is shown");
}

void expect_unplaced(const FileArguments &arguments, const std::string &why)
{
    if (arguments.placement.any())
        throw scenes::Failure(why + "; --turn, --height, --scale, --blend and --hide are for files");
}

}  // namespace cli
