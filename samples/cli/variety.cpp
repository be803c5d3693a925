// claque variety: one template in many colourings, beside the light and dark of its texture and the map of its zones
// (S1 3, Fig. 6).
#include <algorithm>
#include <cmath>
#include <memory>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/letters.h"
#include "samples/cli/picture_style.h"
#include "samples/cli/portraits.h"
#include "samples/cli/scene_arguments.h"
#include "samples/io/png.h"

namespace cli
{
namespace
{

constexpr int person_gap_px = 2;

struct VarietyArguments {
    std::string file, out, colours, colour_class;
    FileArguments of_file;
    uint32_t count = 12, texture = 0, set = 0;
    uint64_t seed = 1;
    int width = 1280, height = 800;
};

struct VarietySheet {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgb;
    std::vector<uint32_t> zones;
};

VarietySheet sheet_of(const clq_template *tmpl, uint32_t set, uint32_t texture, const std::string &file)
{
    VarietySheet s;
    clq_texels texels = clq_texels_init();
    scenes::check(clq_template_get_texture(tmpl, set, texture, &texels), file);
    s.width = texels.width_px, s.height = texels.height_px;
    s.zones.resize(static_cast<size_t>(s.width) * s.height);
    s.rgb.resize(3 * s.zones.size());
    texels.rgb = s.rgb.data(), texels.zones = s.zones.data(), texels.capacity = s.zones.size();
    scenes::check(clq_template_get_texture(tmpl, set, texture, &texels), file);
    return s;
}

// A dozen inks that are easily told apart, then hues apart by the golden angle.
Ink zone_ink(uint32_t zone)
{
    constexpr Ink first[] = {{238, 178, 140}, {92, 58, 34},   {60, 200, 230}, {214, 48, 92},
                             {242, 210, 60},  {150, 90, 30},  {128, 60, 180}, {60, 140, 60},
                             {64, 96, 200},   {250, 140, 20}, {120, 200, 80}, {130, 130, 140}};
    if (zone < std::size(first)) return first[zone];
    const double turn = 0.02 + 0.6180339887498949 * zone, hue = 6 * (turn - std::floor(turn));
    const double bright = zone % 2 == 0 ? 0.92 : 0.66;
    const auto channel = [&](double at) {
        const double away = std::abs(std::fmod(hue - at + 9, 6.0) - 3);
        return static_cast<uint8_t>(255 * bright * (0.2 + 0.8 * std::clamp(2 - away, 0.0, 1.0)) + 0.5);
    };
    return {channel(0), channel(2), channel(4)};
}

struct Box {
    int x, y, width, height;
};

// The texels that fall on a pixel, as [first, last).
struct TextRun {
    uint32_t first, last;
};
TextRun texels(int at, int pixels, uint32_t size)
{
    const uint64_t n = static_cast<uint64_t>(pixels), i = static_cast<uint64_t>(at);
    const uint32_t first = static_cast<uint32_t>(i * size / n);
    return {first, std::max(first + 1, static_cast<uint32_t>((i + 1) * size / n))};
}

void draw_light(Board &board, const VarietySheet &s, Box box)
{
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) {
            const TextRun across = texels(x, box.width, s.width), down = texels(y, box.height, s.height);
            uint32_t sum[3] = {0, 0, 0};
            for (uint32_t v = down.first; v < down.last; ++v)
                for (uint32_t u = across.first; u < across.last; ++u)
                    for (size_t k = 0; k < 3; ++k) sum[k] += s.rgb[3 * (static_cast<size_t>(v) * s.width + u) + k];
            const uint32_t n = (across.last - across.first) * (down.last - down.first);
            const auto mean = [&](int k) { return static_cast<uint8_t>((sum[k] + n / 2) / n); };
            board.dot(box.x + x, box.y + y, {mean(0), mean(1), mean(2)});
        }
}

void draw_zones(Board &board, const VarietySheet &s, Box box)
{
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) {
            const uint32_t u = texels(x, box.width, s.width).first, v = texels(y, box.height, s.height).first;
            const uint32_t zone = s.zones[static_cast<size_t>(v) * s.width + u];
            board.dot(box.x + x, box.y + y, zone == CLQ_NONE ? paper : zone_ink(zone));
        }
}

// The zones of this texture, in two columns if one is too short; the last line counts those that do not fit.
void draw_key(Board &board, const clq_template *tmpl, const VarietySheet &s, Box box)
{
    std::vector<uint32_t> shown(s.zones);
    std::sort(shown.begin(), shown.end());
    shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
    if (!shown.empty() && shown.back() == CLQ_NONE) shown.pop_back();
    const int scale = box.width >= 240 ? 2 : 1, line = (letter_height + 4) * scale,
              lines = std::max(0, box.height / line);
    const int columns = static_cast<int>(shown.size()) <= lines ? 1 : 2, wide = box.width / columns;
    const size_t room = static_cast<size_t>(columns * lines);
    const size_t fit = shown.size() <= room ? shown.size() : room > 0 ? room - 1 : 0;
    const auto corner = [&](size_t i) {
        const int down = static_cast<int>(i) / columns, across = static_cast<int>(i) % columns;
        return Box{box.x + across * wide, box.y + down * line, 0, 0};
    };
    for (size_t i = 0; i < fit; ++i) {
        clq_zone_info zone = clq_zone_info_init();
        scenes::check(clq_template_get_zone(tmpl, shown[i], &zone));
        const Box at = corner(i);
        board.fill(at.x, at.y, letter_height * scale, letter_height * scale, zone_ink(shown[i]));
        const int most = (wide - 10 * scale) / (letter_width * scale);
        board.write(at.x + 10 * scale, at.y, scale, std::string(zone.name).substr(0, static_cast<size_t>(most)), ink);
    }
    if (fit < shown.size() && room > 0)
        board.write(corner(fit).x, corner(fit).y, scale, "and " + std::to_string(shown.size() - fit) + " more", quiet);
}

// The number of columns that draws people largest.
struct Grid {
    int columns = 1, rows = 1, width = 1, height = 1;
};
Grid grid_for(uint32_t count, const Box &box, double aspect)
{
    Grid best;
    double largest = 0;
    for (int columns = 1; columns <= static_cast<int>(count); ++columns) {
        const int rows = (static_cast<int>(count) + columns - 1) / columns;
        const Grid grid = {columns, rows, (box.width + person_gap_px) / columns - person_gap_px,
                           (box.height + person_gap_px) / rows - person_gap_px};
        const double size = std::min(static_cast<double>(grid.height), grid.width / aspect);
        if (size > largest) largest = size, best = grid;
    }
    return best;
}

void draw_people(Board &board, Portraits &portraits, uint32_t count, const Box &box, const Worn &worn)
{
    const Grid grid = grid_for(count, box, portraits.aspect());
    if (grid.width < 8 || grid.height < 8)
        throw scenes::Failure(std::to_string(count) + " people do not fit into a picture of " +
                              std::to_string(board.width()) + " x " + std::to_string(board.height()));
    portraits.resize(grid.width, grid.height);
    const auto dress = [&](clq_crowd *crowd, clq_actor actor) { worn.dress(crowd, actor); };
    for (uint32_t person = 0; person < count; ++person) {
        const int column = static_cast<int>(person) % grid.columns, row = static_cast<int>(person) / grid.columns;
        board.paste(box.x + column * (grid.width + person_gap_px), box.y + row * (grid.height + person_gap_px),
                    grid.width, grid.height, portraits.picture(person, dress, 0));
    }
}

void draw_variety(const VarietyArguments &a)
{
    expect_writable(a.out);
    if (a.of_file.placement.colours && !a.colour_class.empty())
        throw scenes::Failure("--class " + a.colour_class + " needs a map of colours: --colours " +
                              scenes::name_of(a.of_file.placement.colours) + " has no classes");
    scenes::Library library(core_count());
    const LoadedCharacter loaded = load_character(library, a.file, a.of_file);
    const clq_template *tmpl = loaded.tmpl.get();
    const Worn worn = worn_by(library, tmpl, a.colours, a.colour_class);
    const VarietySheet sheet = sheet_of(tmpl, a.set, a.texture, a.file);
    Board board(a.width, a.height, paper);
    const int side = std::min(a.width * 3 / 10, (a.height - 4 * margin_px) * 2 / 5);
    const int tall =
        std::max(1, static_cast<int>(static_cast<uint64_t>(side) * sheet.height / std::max(sheet.width, sheet.height)));
    const int wide =
        std::max(1, static_cast<int>(static_cast<uint64_t>(side) * sheet.width / std::max(sheet.width, sheet.height)));
    const Box light = {margin_px, margin_px, wide, tall}, zones = {margin_px, 2 * margin_px + tall, wide, tall};
    draw_light(board, sheet, light);
    draw_zones(board, sheet, zones);
    const int key_y = zones.y + tall + margin_px;
    draw_key(board, tmpl, sheet, {margin_px, key_y, side, a.height - margin_px - key_y});
    Portraits portraits(library, loaded, a.seed);
    const int left = 2 * margin_px + side;
    draw_people(board, portraits, a.count, {left, margin_px, a.width - margin_px - left, a.height - 2 * margin_px},
                worn);
    if (a.out == "-") return write_whole(a.out, board.rgb().data(), board.rgb().size());
    const std::string name = info_of(tmpl).name;
    const std::vector<unsigned char> file =
        io::png(board.rgb().data(), a.width, a.height,
                {{"Software", "claque " + version()},
                 {"Description", "Colourings of one template: " + (name.empty() ? a.file : name)},
                 {"Source", portraits.context_name()}});
    write_whole(a.out, file.data(), file.size());
}

}  // namespace

void add_variety(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<VarietyArguments>();
    CLI::App *c = app.add_subcommand("variety", "Draw one character in many colourings beside its texture and zones");
    c->add_option("FILE", a->file,
                  "glTF, GLB, prepared .clq, or the name of a built-in character (citizen, patrician ...)")
        ->required();
    c->add_option("--out,-o", a->out, "PNG file; - streams raw RGB, rows from the top")->required();
    c->add_option("--count", a->count, "Individuals")->capture_default_str()->check(CLI::Range(1, 400));
    c->add_option("--seed", a->seed, "Seed of the random colours")->capture_default_str();
    add_size_option(*c, a->width, a->height);
    CLI::Option *colours =
        add_colours_option(*c, a->colours, a->of_file.placement, "Map of colours (TOML) instead of the template's own");
    c->add_option("--class", a->colour_class, "Colour class of the map (default: the one for this template)")
        ->needs(colours);
    c->add_option("--texture", a->texture, "Index of the texture to show")->capture_default_str();
    c->add_option("--texture-set", a->set, "Index of the texture set; people pick theirs at random")
        ->capture_default_str();
    add_file_options(*c, a->of_file);
    c->callback([a, &chosen] { chosen = [a] { draw_variety(*a); }; });
}

}  // namespace cli
