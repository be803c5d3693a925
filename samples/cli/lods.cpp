// claque lods: a character's levels of detail, side by side at equal size and at the size where each begins to serve,
// as in S1 Fig. 7, with their errors.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/letters.h"
#include "samples/cli/levels_table.h"
#include "samples/cli/picture_style.h"
#include "samples/cli/portraits.h"
#include "samples/cli/progress.h"
#include "samples/cli/scene_arguments.h"
#include "samples/cli/stopwatch.h"
#include "samples/io/png.h"

namespace cli
{
namespace
{

constexpr int column_gap_px = 4, line_px = (letter_height + 4);

struct LodsArguments {
    std::string file, out, colours;
    FileArguments of_file;
    std::vector<uint32_t> targets;
    uint32_t proxy_max_triangles = 250;
    double tolerance_px = 1;
    bool json = false, compare = false;
    int width = 1600, height = 560;
};

Levels make_levels(scenes::Library &library, clq_asset *asset, const LodsArguments &a, bool quadric_only = false)
{
    clq_levels_def def = clq_levels_def_init();
    def.targets = a.targets.data();
    def.target_count = static_cast<uint32_t>(a.targets.size());
    def.tolerance_px = static_cast<float>(a.tolerance_px);
    def.proxy_max_triangles = a.proxy_max_triangles;
    def.quadric_only = quadric_only;
    uint32_t count = 0;
    const Waiting waiting("making levels of detail of " + a.file);
    scenes::check(clq_asset_make_levels(library.context(), asset, &def, &count), a.file);
    Levels levels(count, clq_level_report_init());
    for (uint32_t i = 0; i < count; ++i) scenes::check(clq_asset_get_level_report(asset, i, &levels[i]), a.file);
    return levels;
}

std::string number(double value, const char *format)
{
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// Pixels a metre where a level begins, at 768 lines over 60 degrees.
double pixels_a_metre(double first_m) { return 768 / (2 * std::sqrt(1.0 / 3) * first_m); }

void draw(const LodsArguments &a, scenes::Library &library, const LoadedCharacter &loaded, const Levels &levels)
{
    Board board(a.width, a.height, paper);
    const int columns = static_cast<int>(levels.size());
    const int wide = (a.width - 2 * margin_px + column_gap_px) / columns - column_gap_px, tall = a.height * 3 / 5;
    if (wide < 24) throw scenes::Failure(std::to_string(columns) + " levels do not fit into a picture of this size");
    Portraits portraits(library, loaded, 1);
    const Worn worn = worn_by(library, loaded.tmpl.get(), a.colours, "");
    const auto dress = [&](clq_crowd *crowd, clq_actor actor) { worn.dress(crowd, actor); };
    for (int i = 0; i < columns; ++i) {
        const clq_level_report &level = levels[static_cast<size_t>(i)];
        const int x = margin_px + i * (wide + column_gap_px);
        portraits.show_level(static_cast<uint32_t>(i));
        portraits.resize(wide, tall);
        board.paste(x, margin_px, wide, tall, portraits.picture(0, dress, 0));
        int y = margin_px + tall + 6;
        board.write(x, y, 2, std::to_string(level.triangle_count), ink);
        y += 2 * line_px;
        board.write(x, y, 1, number(1000 * double(level.error_m), "%.1f") + " MM", quiet);
        y += line_px;
        board.write(x, y, 1, "FROM " + number(double(level.lod_min_m), "%.0f") + " M", quiet);
        if (level.lod_min_m <= 0) continue;
        const double scale = pixels_a_metre(double(level.lod_min_m));
        const int small_tall = static_cast<int>(std::lround(portraits.visible_m() * scale));
        const int small_wide = static_cast<int>(std::lround(portraits.visible_m() * portraits.aspect() * scale));
        if (small_wide < 1 || small_wide > wide || y + line_px + small_tall > a.height - 4) continue;
        portraits.resize(small_wide, small_tall);
        board.paste(x, y + line_px + 4, small_wide, small_tall, portraits.picture(0, dress, 0));
    }
    const std::vector<unsigned char> file = io::png(board.rgb().data(), a.width, a.height,
                                                    {{"Software", "claque " + version()},
                                                     {"Description", "Levels of detail of " + a.file},
                                                     {"Source", portraits.context_name()}});
    write_whole(a.out, file.data(), file.size());
}

// The same numbers of triangles by both methods.
void compare(const LodsArguments &a, scenes::Library &library)
{
    LevelsComparison comparison;
    const auto make = [&](const LodsArguments &how, bool quadric_only, double &took_s) {
        const scenes::Own<clq_asset> asset = load_asset(library, a.file, a.of_file);
        const Stopwatch watch;
        Levels levels = make_levels(library, asset.get(), how, quadric_only);
        took_s = watch.ms() / 1000;
        return levels;
    };
    comparison.ours = make(a, false, comparison.ours_s);
    LodsArguments reached = a;
    reached.targets.clear();
    for (size_t k = 1; k < comparison.ours.size(); ++k) reached.targets.push_back(comparison.ours[k].triangle_count);
    if (reached.targets.empty()) throw scenes::Failure(a.file + " has no levels to compare");
    comparison.quadric_only = make(reached, true, comparison.quadric_only_s);
    if (a.json) std::cout << json_of(comparison).dump(2) << '\n';
    else print(comparison);
}

void show(const LodsArguments &a)
{
    if (!a.out.empty()) expect_writable(a.out);
    if (!a.colours.empty()) expect_readable(a.colours, io::most_text_bytes);  // early, as levels take time
    scenes::Library library(core_count());
    if (is_prepared(a.file))
        throw scenes::Failure(a.file + " is prepared already; levels are made earlier, from its source");
    if (a.compare) return compare(a, library);
    LoadedCharacter loaded;
    loaded.asset = load_asset(library, a.file, a.of_file);
    const Levels levels = make_levels(library, loaded.asset.get(), a);
    if (a.json) std::cout << json_of(levels).dump(2) << '\n';
    else print(levels), print(levels, zone_areas(loaded.asset.get(), levels));
    if (a.out.empty()) return;
    clq_template *made = nullptr;
    scenes::check(clq_asset_build(library.context(), loaded.asset.get(), 0, &made), a.file);
    loaded.tmpl.reset(made);
    draw(a, library, loaded, levels);
}

}  // namespace

void add_lods(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<LodsArguments>();
    CLI::App *c = app.add_subcommand("lods", "Make a character's levels of detail, print their errors and draw them");
    c->add_option("FILE", a->file, "glTF, GLB, or the name of a built-in character (citizen, patrician ...)")
        ->required();
    c->add_option("--picture,--out,-o", a->out, "PNG: levels at equal size, and below at the size where they begin");
    c->add_option("--targets", a->targets, "Triangles of the levels, descending, separated by commas")->delimiter(',');
    c->add_option("--proxy-max-triangles", a->proxy_max_triangles,
                  "Levels of at most this many triangles are proxies, one mesh without seams; 0: no proxies")
        ->capture_default_str();
    c->add_option("--tolerance", a->tolerance_px, "Error in pixels that a level may have where it begins")
        ->check(CLI::Range(0.01, 100.0))
        ->capture_default_str();
    add_file_options(*c, a->of_file);
    add_colours_option(*c, a->colours, a->of_file.placement,
                       "Colours in the picture (TOML, see `claque colours`) instead of the template's own")
        ->needs("--picture");
    c->add_flag("--compare", a->compare, "Compare with levels made by OpenMesh's quadric alone: errors, zones, cracks")
        ->excludes("--picture");
    c->add_flag("--json", a->json, "Print JSON");
    add_size_option(*c, a->width, a->height);
    c->callback([a, &chosen] { chosen = [a] { show(*a); }; });
}

}  // namespace cli
