// claque frames: checks the frames of a film that several jobs drew.
#include <iostream>

#include "samples/cli/command.h"
#include "samples/cli/manifest.h"
#include "samples/cli/sequence.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

struct FramesArguments {
    std::string folder, frames;
    std::vector<int> wanted;
};

void check(const FramesArguments &a)
{
    const FilmReport report = check_film(a.folder, a.wanted);
    for (const std::string &sentence : report.sentences) std::cout << sentence << "\n";
    std::cout << report.whole << " frames are whole";
    if (!report.missing.empty())
        std::cout << ", " << report.missing.size() << " are missing\n" << array_words(report.missing);
    std::cout << "\n";
    std::cout.flush();
    if (!report.missing.empty() || !report.sentences.empty())
        throw scenes::Failure(a.folder + " is not one whole film: " + std::to_string(report.missing.size()) +
                              " frames are missing, and " + std::to_string(report.sentences.size()) +
                              " other things are wrong");
}

}  // namespace

void add_frames(CLI::App &app, Work &chosen)
{
    CLI::App *c = app.add_subcommand("frames", "Check the frames of a film that several jobs drew");
    c->require_subcommand(1);
    auto a = std::make_shared<FramesArguments>();
    CLI::App *checking = c->add_subcommand(
        "check",
        "Compare every frame with its SHA-256, and all jobs' builds, scenes, GLs, processors and drivers. The "
        "last line printed has the missing frames, as schedulers take the indices of an array");
    checking->add_option("DIR", a->folder, "The folder of the manifests that render --manifest wrote")->required();
    checking->add_option("--frames", a->frames, "The frames of the film (default: those that its jobs were asked for)")
        ->type_name("LIST");
    checking->callback([a, &chosen] {
        const std::string wrong = a->frames.empty() ? "" : read_frames(a->frames, a->wanted);
        if (!wrong.empty()) throw CLI::ValidationError("--frames", wrong);
        chosen = [a] { check(*a); };
    });
}

}  // namespace cli
