// claque colours: maps from which the colours of people are sampled (S2 5): written from existing ones, and shown.
#include <deque>
#include <memory>

#include "samples/cli/characters.h"
#include "samples/cli/colour_pictures.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/scene_arguments.h"
#include "samples/io/png.h"
#include "samples/scenes/scenario/scenario.h"

namespace cli
{
namespace
{

struct MapArguments {
    std::string from, scenario, mechanisms, colours, out;
    FileArguments of_file;
    uint32_t each = 0;
    uint64_t seed = 1;
    int width = 1280, height = 800;
};

// A map under construction; `def` points into the other members.
struct Making {
    std::deque<std::vector<clq_zone_colours>> zones;
    std::deque<clq_palette_entry> dyes;
    std::vector<clq_colour_class> classes;

    // Adds every zone of the template with its own range.
    std::vector<clq_zone_colours> &add(const char *name, const clq_template *tmpl)
    {
        const clq_template_info info = info_of(tmpl);
        std::vector<clq_zone_colours> &all = zones.emplace_back();
        for (uint32_t i = 0; i < info.zone_count; ++i) {
            clq_zone_info zone = clq_zone_info_init();
            scenes::check(clq_template_get_zone(tmpl, i, &zone));
            dyes.push_back({zone.range, 1});
            all.push_back({zone.name, 1, &dyes.back(), CLQ_COLOUR_SPACE_HSB, nullptr, 0});
        }
        classes.push_back({name, info.name, info.zone_count, all.data()});
        return all;
    }
};

scenes::ColourMap made(scenes::Library &library, const Making &making)
{
    clq_colour_map_def def = clq_colour_map_def_init();
    def.class_count = static_cast<uint32_t>(making.classes.size());
    def.classes = making.classes.data();
    clq_colour_map *map = nullptr;
    scenes::check(clq_colour_map_create(library.context(), &def, &map));
    return scenes::ColourMap(map);
}

// The classes of a scenario: each zone has the palette of its description, or else the character's own range.
scenes::ColourMap map_of_scenario(scenes::Library &library, const scenes::Scenario &scenario)
{
    Making making;
    std::deque<LoadedCharacter> loaded;
    for (const scenes::SocialClass &one : scenario.characters) {
        loaded.push_back(load_character(library, one.character, {one.placement}));
        const clq_template *tmpl = loaded.back().tmpl.get();
        const std::vector<clq_hsb_range> ranges = ranges_of(tmpl, one);
        std::vector<clq_zone_colours> &zones = making.add(one.name.c_str(), tmpl);
        for (const scenes::SocialClass::Dye &dye : one.palette) {
            const uint32_t zone = clq_template_find_zone(tmpl, dye.zone.c_str());
            making.dyes.push_back({ranges[zone], 1});
            zones[zone].palette = &making.dyes.back();
        }
    }
    return made(library, making);
}

bool ends_in_toml(const std::string &name) { return name.size() > 5 && name.compare(name.size() - 5, 5, ".toml") == 0; }

scenes::ColourMap map_from(scenes::Library &library, const std::string &from, const FileArguments &of_file = {})
{
    if (from == "odeon" || from == "roman-classes" || ends_in_toml(from))
        expect_unplaced(of_file, from + " is no character");
    if (from == "odeon") return map_of_scenario(library, scenes::odeon_scenario());
    if (from == "roman-classes") return scenes::read_colours(library, scenes::roman_classes(), "roman-classes.toml");
    if (ends_in_toml(from)) return scenes::read_colours(library, text_of(from), from);
    const LoadedCharacter loaded = load_character(library, from, of_file);
    const char *name = info_of(loaded.tmpl.get()).name;
    Making making;
    making.add(*name ? name : "people", loaded.tmpl.get());
    return made(library, making);
}

void save(const MapArguments &a)
{
    if (a.out != "-") expect_writable(a.out);
    scenes::Library library(1);
    const scenes::ColourMap map = a.scenario.empty()
                                      ? map_from(library, a.from, a.of_file)
                                      : map_of_scenario(library, scenes::load_scenario(a.scenario, a.mechanisms));
    std::string text;
    const auto take = [](void *to, const void *bytes, size_t count) {
        static_cast<std::string *>(to)->append(static_cast<const char *>(bytes), count);
        return 0;
    };
    scenes::check(clq_colour_map_save(map.get(), take, &text));
    write_whole(a.out, text);
}

using Draw = ColourPicture (*)(scenes::Library &, const clq_colour_map *, uint32_t, uint64_t, int, int);

void draw(const MapArguments &a, Draw picture, const std::string &about)
{
    expect_writable(a.out);
    scenes::Library library(1);
    const scenes::ColourMap map = map_from(library, a.colours.empty() ? "roman-classes" : a.colours);
    const ColourPicture drawn = picture(library, map.get(), a.each, a.seed, a.width, a.height);
    if (a.out == "-") return write_whole(a.out, drawn.board.rgb().data(), drawn.board.rgb().size());
    const std::vector<unsigned char> file =
        io::png(drawn.board.rgb().data(), a.width, a.height,
                {{"Software", "claque " + version()}, {"Description", about}, {"Source", drawn.context}});
    write_whole(a.out, file.data(), file.size());
}

void add_picture(CLI::App &colours, Work &chosen, const char *name, const std::string &about, Draw picture,
                 uint32_t each)
{
    auto a = std::make_shared<MapArguments>();
    a->each = each;
    CLI::App *c = colours.add_subcommand(name, about);
    c->add_option("--colours", a->colours,
                  "Map to show (TOML), odeon, or a built-in character (default roman-classes)");
    c->add_option("--count", a->each, "Individuals of each class")->capture_default_str()->check(CLI::Range(1, 64));
    c->add_option("--seed", a->seed, "Seed of the random colours")->capture_default_str();
    add_size_option(*c, a->width, a->height);
    c->add_option("--out,-o", a->out, "PNG file; - streams raw RGB, rows from the top")->required();
    c->callback([a, &chosen, picture, about] { chosen = [a, picture, about] { draw(*a, picture, about); }; });
}

}  // namespace

void add_colours(CLI::App &app, Work &chosen)
{
    CLI::App *colours = app.add_subcommand(
        "colours", "Write and show colour maps: HSB ranges from which people's colours are sampled (S2 5)");
    colours->require_subcommand(1);
    auto a = std::make_shared<MapArguments>();
    CLI::App *c = colours->add_subcommand("save", "Write a map as TOML, to be edited and used with --colours");
    c->add_option("FROM", a->from,
                  "odeon, roman-classes, a map (TOML, written in its normal form), or a character: its own ranges");
    c->add_option("--scenario", a->scenario, "The classes of a scenario (TOML) instead of FROM")->type_name("FILE");
    add_mechanisms_option(*c, a->mechanisms);
    add_file_options(*c, a->of_file);
    c->add_option("--out,-o", a->out, "TOML file; - is standard output")->required();
    c->callback([a, &chosen] {
        if (!a->scenario.empty()) expect_unplaced(a->of_file, a->scenario + " has keys of its own for this");
        if (a->from.empty() == a->scenario.empty())
            throw CLI::ValidationError("FROM", "or --scenario is needed, and not both");
        chosen = [a] { save(*a); };
    });
    add_picture(*colours, chosen, "classes", "Draw the social classes of a map side by side (S2 5.3)", classes_picture,
                12);
    add_picture(*colours, chosen, "compare", "Draw people in random RGB, and the same people in HSB ranges (S2 Fig. 6)",
                comparison_picture, 4);
}

}  // namespace cli
