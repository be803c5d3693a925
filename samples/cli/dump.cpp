// claque dump: animated positions as numbers, so that other programs can check claque's skinning.
#include <cmath>
#include <memory>

#include "samples/cli/characters.h"
#include "samples/cli/clip_choice.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/io/npy.h"

namespace cli
{
namespace
{

struct DumpArguments {
    std::string file, clip, out;
    FileArguments of_file;
    ClipArguments clips;
    double time_s = 0;
};

uint32_t find_clip(const clq_asset *asset, const DumpArguments &a)
{
    if (a.clip.empty()) return CLQ_NONE;
    std::vector<std::string> names;
    for (uint32_t i = 0; i < info_of(asset).clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_asset_get_clip(asset, i, &clip));
        names.emplace_back(clip.name);
    }
    return clip_named(a.clip, names, a.file);
}

void dump(const DumpArguments &a)
{
    expect_writable(a.out);
    scenes::Library library(1);
    const scenes::Own<clq_asset> asset = load_asset(library, a.file, a.of_file, a.clips);
    const clq_asset_info info = info_of(asset.get());
    if (info.vertex_count == 0)
        throw scenes::Failure(a.file + " has no mesh, so there are no positions to write" +
                              (info.clip_count ? ": --clips " + a.file + " adds its clips to a character" : ""));
    const uint32_t clip = find_clip(asset.get(), a);
    std::vector<float> xyz(3 * static_cast<size_t>(info.vertex_count));
    scenes::check(clq_asset_get_positions(asset.get(), clip, static_cast<float>(a.time_s), xyz.data(), xyz.size()),
                  a.file);
    const std::string bytes = io::npy("<f4", {xyz.size() / 3, 3}, xyz);
    write_whole(a.out, bytes);
}

}  // namespace

void add_dump(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<DumpArguments>();
    CLI::App *c = app.add_subcommand(
        "dump",
        "Write animated world-space positions of all mesh primitives of the default scene: nodes depth first with "
        "children in listed order, primitives in order, vertices as in the file; float32 (n, 3), NumPy's .npy 1.0");
    c->add_option("FILE", a->file, "glTF or GLB, or the name of a built-in character (citizen, patrician ...)")
        ->required();
    add_placement_options(*c, a->of_file.placement);
    add_clip_options(*c, a->clips);
    CLI::Option *clip = c->add_option("--clip", a->clip,
                                      "Name or number of a clip; without it the rest pose and default morph weights");
    c->add_option("--time", a->time_s, "Time in seconds on the file's own key axis, clamped to the clip")
        ->check([](const std::string &text) {
            double value = 0;
            return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? std::string() : "must be finite";
        })
        ->needs(clip);
    c->add_option("--out,-o", a->out, "The .npy file; - is standard output")->required();
    c->callback([a, &chosen] { chosen = [a] { dump(*a); }; });
}

}  // namespace cli
