// claque prepare: reads and splits a character once and saves it so that libclaque alone can load it.
#include <memory>

#include "samples/cli/characters.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/scene_arguments.h"
#include "samples/cli/zone_arguments.h"

namespace cli
{
namespace
{

struct PrepareArguments {
    std::string file, out, lod = "off";
    uint32_t texture_px = 0;
    FileArguments of_file;
    ClipArguments clips;
    ZoneArguments zones;
};

void prepare(const PrepareArguments &a)
{
    expect_writable(a.out);
    scenes::Library library(core_count());
    if (is_prepared(a.file)) throw scenes::Failure(a.file + " is prepared already");
    const scenes::Own<clq_asset> asset = load_asset(library, a.file, a.of_file, a.clips);
    const ZoneMap zones = give_zones(library, asset.get(), a.zones);
    clq_template *made = nullptr;
    if (a.lod == "on") made = in_levels(library, a.file, a.of_file, a.clips, zones.given(), a.texture_px);
    if (!made) scenes::check(clq_asset_build(library.context(), asset.get(), a.texture_px, &made), a.file);
    const scenes::Own<clq_template> tmpl(made);
    std::string bytes;
    const auto append = [](void *user, const void *piece, size_t size_bytes) {
        static_cast<std::string *>(user)->append(static_cast<const char *>(piece), size_bytes);
        return 0;
    };
    scenes::check(clq_template_save(tmpl.get(), append, &bytes), a.file);
    write_whole(a.out, bytes);
}

}  // namespace

void add_prepare(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<PrepareArguments>();
    CLI::App *c = app.add_subcommand("prepare", "Read and split a character once; render takes the result as FILE");
    c->add_option("FILE", a->file, "glTF or GLB, or the name of a built-in character (citizen, patrician ...)")
        ->required();
    add_file_options(*c, a->of_file);
    add_clip_options(*c, a->clips);
    add_zone_options(*c, a->zones);
    c->add_option_function<std::string>(
         "--colours", [a](const std::string &name) { a->of_file.placement.colours = scenes::colours_of(name); },
         "wild: individuals wear most hues, not colours near the file's; own: the file's own")
        ->check(CLI::IsMember({"wild", "own"}));
    c->add_option("--lod", a->lod,
                  "Make levels of detail (on; without added clips they come from the cache folder the next time), or "
                  "keep those of the file alone (off)")
        ->check(CLI::IsMember({"off", "on"}))
        ->capture_default_str();
    c->add_option(
         "--texture-size", a->texture_px,
         "Largest width and height of an image in texels; larger images are reduced without mixing zones (0: 1024)")
        ->capture_default_str()
        ->check(CLI::Range(0, 16384));
    c->add_option("--out,-o", a->out, "The prepared file (.clq); - is standard output")->required();
    c->callback([a, &chosen] { chosen = [a] { prepare(*a); }; });
}

}  // namespace cli
