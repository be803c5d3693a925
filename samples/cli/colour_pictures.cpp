#include "samples/cli/colour_pictures.h"

#include <algorithm>
#include <functional>

#include "samples/cli/picture_style.h"
#include "samples/cli/portraits.h"
#include "samples/scenes/random.h"

namespace cli
{
namespace
{

constexpr int swatch_gap_px = 2, letter_scale = 2, swatch_label_px = (letter_height + 5) * letter_scale;

using Colouring = std::function<void(clq_crowd *, clq_actor, uint32_t person)>;

clq_colour_map_def def_of(const clq_colour_map *map)
{
    clq_colour_map_def def = clq_colour_map_def_init();
    scenes::check(clq_colour_map_get_def(map, &def));
    return def;
}

LoadedCharacter wearer_of(scenes::Library &library, const clq_colour_class &colours)
{
    if (!colours.tmpl || !*colours.tmpl)
        throw scenes::Failure(std::string("class '") + colours.name + "' names no template to show it on");
    return load_character(library, colours.tmpl);
}

// Picks every channel of every zone at random, which HSB ranges exist to prevent.
void colour_at_random(clq_crowd *crowd, clq_actor actor, uint64_t seed, uint32_t person)
{
    clq_actor_info info = clq_actor_info_init();
    clq_template_info tmpl = clq_template_info_init();
    scenes::check(clq_actor_get_info(crowd, actor, &info));
    scenes::check(clq_template_get_info(info.tmpl, &tmpl));
    std::vector<float> rgb(3 * static_cast<size_t>(tmpl.zone_count));
    for (size_t i = 0; i < rgb.size(); ++i)
        rgb[i] = static_cast<float>(scenes::random_unit(seed, rgb.size() * person + i, scenes::Purpose::tone));
    scenes::check(clq_actor_set_colours(crowd, actor, rgb.data(), tmpl.zone_count));
}

class Rows
{
public:
    Rows(int width, int height, int rows, int across)
        : board(width, height, paper),
          row_px_((height - 2 * margin_px) / rows),
          tile_width_((width - 2 * margin_px + swatch_gap_px) / across - swatch_gap_px),
          tile_height_(row_px_ - swatch_label_px - swatch_gap_px)
    {
        if (tile_width_ < 8 || tile_height_ < 8)
            throw scenes::Failure(std::to_string(across) + " people in " + std::to_string(rows) +
                                  " rows do not fit into a picture of " + std::to_string(width) + " x " +
                                  std::to_string(height));
    }

    void label(int row, const std::string &text)
    {
        board.write(margin_px, margin_px + row * row_px_ + 2 * letter_scale, letter_scale, text, ink);
    }
    void resize(Portraits &portraits) const { portraits.resize(tile_width_, tile_height_); }
    void paste(int row, int column, const std::vector<uint8_t> &rgb)
    {
        board.paste(margin_px + column * (tile_width_ + swatch_gap_px), margin_px + row * row_px_ + swatch_label_px,
                    tile_width_, tile_height_, rgb);
    }

    Board board;

private:
    int row_px_, tile_width_, tile_height_;
};

}  // namespace

ColourPicture classes_picture(scenes::Library &library, const clq_colour_map *map, uint32_t each, uint64_t seed,
                              int width, int height)
{
    const clq_colour_map_def def = def_of(map);
    Rows rows(width, height, static_cast<int>(def.class_count), static_cast<int>(each));
    std::string context;
    for (uint32_t c = 0; c < def.class_count; ++c) {
        const LoadedCharacter worn = wearer_of(library, def.classes[c]);
        Portraits portraits(library, worn, seed);
        rows.resize(portraits);
        rows.label(static_cast<int>(c), def.classes[c].name);
        for (uint32_t person = 0; person < each; ++person) {
            const auto dress = [&](clq_crowd *crowd, clq_actor actor) {
                scenes::check(clq_crowd_randomise_colours(crowd, map, c, &actor, 1));
            };
            rows.paste(static_cast<int>(c), static_cast<int>(person), portraits.picture(person, dress, 0));
        }
        context = portraits.context_name();
    }
    return {std::move(rows.board), context};
}

ColourPicture comparison_picture(scenes::Library &library, const clq_colour_map *map, uint32_t each, uint64_t seed,
                                 int width, int height)
{
    const clq_colour_map_def def = def_of(map);
    Rows rows(width, height, 2, static_cast<int>(each * def.class_count));
    rows.label(0, "(a) random RGB");
    rows.label(1, "(b) HSB ranges");
    std::string context;
    for (uint32_t c = 0; c < def.class_count; ++c) {
        const LoadedCharacter worn = wearer_of(library, def.classes[c]);
        Portraits portraits(library, worn, seed);
        rows.resize(portraits);
        for (uint32_t person = 0; person < each; ++person) {
            const int column = static_cast<int>(c * each + person);
            const auto at_random = [&](clq_crowd *crowd, clq_actor actor) {
                colour_at_random(crowd, actor, seed, c * each + person);
            };
            const auto dress = [&](clq_crowd *crowd, clq_actor actor) {
                scenes::check(clq_crowd_randomise_colours(crowd, map, c, &actor, 1));
            };
            rows.paste(0, column, portraits.picture(person, at_random, 0));
            rows.paste(1, column, portraits.picture(person, dress, 0));
        }
        context = portraits.context_name();
    }
    return {std::move(rows.board), context};
}

}  // namespace cli
