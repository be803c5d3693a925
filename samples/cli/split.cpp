// claque split: clean and dirty triangles, as numbers and as a picture over the zone map.
#include <cstdio>
#include <memory>

#include "samples/cli/characters.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/scene_arguments.h"
#include "samples/io/png.h"

namespace cli
{
namespace
{

struct SplitArguments {
    std::string file, picture;
    FileArguments of_file;
    uint32_t texture = 0, scale = 2;
};

void write_picture(const clq_template *tmpl, const SplitArguments &a)
{
    clq_picture picture = clq_picture_init();
    scenes::check(clq_template_get_split_picture(tmpl, a.texture, a.scale, &picture), a.file);
    std::vector<uint8_t> rgb(3 * static_cast<size_t>(picture.width_px) * picture.height_px);
    picture.pixels = rgb.data(), picture.capacity_bytes = rgb.size();
    scenes::check(clq_template_get_split_picture(tmpl, a.texture, a.scale, &picture), a.file);
    const std::vector<unsigned char> file =
        io::png(rgb.data(), static_cast<int>(picture.width_px), static_cast<int>(picture.height_px),
                {{"Software", "claque " + version()}});
    write_whole(a.picture, file.data(), file.size());
}

void split(const SplitArguments &a)
{
    if (!a.picture.empty()) expect_writable(a.picture);
    scenes::Library library(core_count());
    const LoadedCharacter loaded = load_character(library, a.file, a.of_file);
    const clq_template_info info = info_of(loaded.tmpl.get());
    if (!a.picture.empty()) write_picture(loaded.tmpl.get(), a);
    if (a.picture == "-") return;
    const double share = info.triangle_count > 0 ? 100.0 * info.dirty_count / info.triangle_count : 0;
    std::printf("triangles   %u\nclean       %u\ndirty       %u (%.1f %%), %.2f zones each on average\n",
                info.triangle_count, info.clean_count, info.dirty_count, share,
                static_cast<double>(info.dirty_zone_mean));
    std::printf("fused       %u triangles, %u vertices for %u\ncoincident  %u\n", info.fused_triangle_count,
                info.fused_vertex_count, info.vertex_count, info.coincident_count);
    std::printf("zones       %u\n", info.zone_count);
    for (uint32_t i = 0; i < info.zone_count; ++i) {
        clq_zone_info zone = clq_zone_info_init();
        scenes::check(clq_template_get_zone(loaded.tmpl.get(), i, &zone));
        std::printf("  %-24s %u clean\n", zone.name, zone.clean_count);
    }
}

}  // namespace

void add_split(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<SplitArguments>();
    CLI::App *c = app.add_subcommand("split", "Report clean and dirty triangles, and draw them over the zone map");
    c->add_option("FILE", a->file,
                  "glTF, GLB, prepared .clq, or the name of a built-in character (citizen, patrician ...)")
        ->required();
    CLI::Option *picture =
        c->add_option("--picture", a->picture, "PNG of the triangles over the zones, with dirty ones marked");
    c->add_option("--texture", a->texture, "Index of the texture to draw")->capture_default_str()->needs(picture);
    c->add_option("--scale", a->scale, "Pixels a texel")
        ->check(CLI::Range(1, 16))
        ->capture_default_str()
        ->needs(picture);
    add_file_options(*c, a->of_file);
    c->callback([a, &chosen] { chosen = [a] { split(*a); }; });
}

}  // namespace cli
