// claque sheet: the sections of a camera path in one picture, each at its middle (S1 7).
#include <algorithm>
#include <memory>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/progress.h"
#include "samples/cli/scene_arguments.h"
#include "samples/io/png.h"

namespace cli
{
namespace
{

constexpr int tile_gap_px = 6;
constexpr uint8_t gap_grey = 24;

struct SheetArguments {
    SceneArguments setup;
    bool reload = false;
    std::string out, json;
};

// Tiles in rows, with as many columns as rows or one more, and even lines between them.
class Sheet
{
public:
    Sheet(size_t tiles, int width, int height) : tile_width_(width), tile_height_(height)
    {
        while (static_cast<size_t>(across_) * static_cast<size_t>(across_) < tiles) ++across_;
        const int down = static_cast<int>((tiles + static_cast<size_t>(across_) - 1) / static_cast<size_t>(across_));
        width_ = across_ * (width + tile_gap_px) - tile_gap_px;
        height_ = down * (height + tile_gap_px) - tile_gap_px;
        rgb_.assign(3 * static_cast<size_t>(width_) * static_cast<size_t>(height_), gap_grey);
    }

    void lay(size_t tile, const std::vector<uint8_t> &rgb)
    {
        const int number = static_cast<int>(tile);
        const int left = number % across_ * (tile_width_ + tile_gap_px),
                  top = number / across_ * (tile_height_ + tile_gap_px);
        const std::ptrdiff_t row = 3 * static_cast<std::ptrdiff_t>(tile_width_);
        for (int y = 0; y < tile_height_; ++y)
            std::copy_n(rgb.begin() + y * row, row,
                        rgb_.begin() + 3 * (static_cast<std::ptrdiff_t>(top + y) * width_ + left));
    }

    int width() const { return width_; }
    int height() const { return height_; }
    const std::vector<uint8_t> &rgb() const { return rgb_; }

private:
    int tile_width_, tile_height_, across_ = 1, width_ = 0, height_ = 0;
    std::vector<uint8_t> rgb_;
};

void write(const Sheet &sheet, const std::string &path, const io::Words &words)
{
    if (path == "-") return write_whole(path, sheet.rgb().data(), sheet.rgb().size());
    const std::vector<unsigned char> file = io::png(sheet.rgb().data(), sheet.width(), sheet.height(), words);
    write_whole(path, file.data(), file.size());
}

void draw_sheet(const SheetArguments &a)
{
    Progress progress("claque sheet");
    expect_writable(a.out);
    if (!a.json.empty()) expect_writable(a.json);
    progress.phase("preparing");
    scenes::Library library(thread_count(a.setup));
    const LoadedCharacter none;
    const scenes::SceneOptions options = scene_options(a.setup, none);
    const std::vector<scenes::PathSection> &sections = options.path->sections();
    if (sections.empty()) throw scenes::Failure(a.setup.path + ": the camera path has no sections to show");
    scenes::SceneRenderer scene_renderer(library, options);
    SceneColours wardrobe(library, a.setup.colours, a.reload, options.crowd_options.seed);
    Sheet sheet(sections.size(), options.width, options.height);
    Json report = {{"claque", version()},
                   {"scene", options.scene},
                   {"count", scene_renderer.crowd_stats().actor_count},
                   {"size_px", {sheet.width(), sheet.height()}},
                   {"tile_px", {options.width, options.height}},
                   {"context", scene_renderer.context_name()}};
    report["tiles"] = Json::array();
    for (size_t i = 0; i < sections.size(); ++i) {
        wardrobe.apply_to(scene_renderer);
        const double time_s = (sections[i].start_s + sections[i].end_s) / 2;
        const std::vector<uint8_t> &picture = scene_renderer.picture(time_s);
        sheet.lay(i, picture);
        report["tiles"].push_back({{"section", sections[i].name},
                                   {"time_s", time_s},
                                   {"in_view", scene_renderer.view_stats().visible},
                                   {"picture_hash", hex(scenes::hash_of(picture))}});
        progress.step(i + 1, sections.size());
    }
    write(sheet, a.out,
          {{"Software", "claque " + version()},
           {"Description", options.scene + ": the sections of its camera path"},
           {"Source", scene_renderer.context_name()}});
    if (!a.json.empty()) write_whole(a.json, report.dump(2) + "\n");
    progress.conclude(a.out + ": " + std::to_string(sections.size()) + " sections");
}

}  // namespace

void add_sheet(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<SheetArguments>();
    CLI::App *c = app.add_subcommand("sheet", "Draw the sections of a camera path side by side, each at its middle");
    a->setup.scene = "odeon";
    CLI::Option *scene =
        c->add_option("--scene", a->setup.scene, "The scene")->capture_default_str()->check(scene_names());
    add_scenario_option(*c, a->setup)->excludes(scene);
    c->add_option("--count", a->setup.count, "Individuals (default: the scene's own number)")
        ->check(CLI::Range(1, 1000000));
    a->setup.width = 640;
    a->setup.height = 480;
    add_scene_options(*c, a->setup);
    add_reload_option(*c, a->reload);
    c->add_option("--out,-o", a->out, "PNG file; - streams raw RGB, rows from the top")->required();
    c->add_option("--json", a->json, "Write what each tile shows as JSON; - is standard output");
    c->callback([a, &chosen] {
        if (a->setup.camera.empty()) a->setup.camera = "path";
        if (a->setup.camera != "path")
            throw CLI::ValidationError("--camera", "must be path: a sheet follows the camera path");
        read_scenario(a->setup);
        check_scene_usage(a->setup);
        if (a->out == "-" && a->json == "-")
            throw CLI::ValidationError("--json", "standard output is used by the picture already");
        chosen = [a] { draw_sheet(*a); };
    });
}

}  // namespace cli
