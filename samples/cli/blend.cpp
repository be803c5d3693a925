// claque blend: strips of pictures of one person that changes from one clip to another, layers a clip over another, or
// blends two gaits (S2 3.3).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "samples/cli/blend_rows.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/letters.h"
#include "samples/cli/picture_style.h"
#include "samples/cli/scene_arguments.h"
#include "samples/io/png.h"

namespace cli
{
namespace
{

constexpr int row_gap_px = 2, row_label_px = (letter_height + 4) * 2;

struct BlendArguments {
    std::string file, out;
    FileArguments of_file;
    ClipArguments clips;
    BlendOptions options;
    int width = 1600, height = 1500;
};

// What a row shows at a time, as a list of its blended clips.
std::string shown_at(scenes::Library &library, clq_template *tmpl, const BlendRow &row, double time_s)
{
    scenes::CrowdOptions crowd_options;
    crowd_options.count = 1;
    scenes::SceneCrowd cast(library, crowd_options);
    cast.enter({tmpl, scenes::stand(0, 0, 0, 0, 1, 1), {CLQ_NONE, 0, 0, 0}});
    row.command(cast.crowd(), cast.actors()[0]);
    clq_active_clip shown[CLQ_ACTIVE_CLIP_MAX];
    uint32_t count = 0;
    scenes::check(clq_actor_get_active_clips(cast.crowd(), cast.actors()[0], time_s, shown, &count));
    std::string text;
    for (uint32_t i = 0; i < count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_template_get_clip(tmpl, shown[i].clip, &clip));
        char part[160];
        std::snprintf(part, sizeof part, "%s%s %.2f s x %.2f", i > 0 ? ", " : "", clip.name, shown[i].clip_time_s,
                      double(shown[i].weight));
        text += part + std::string(shown[i].kind == CLQ_LAYER_ADD ? " added" : "");
    }
    return text;
}

void print_row(scenes::Library &library, clq_template *tmpl, size_t number, const BlendRow &row)
{
    std::printf("row %zu: %s: %s\n", number, row.label.c_str(), row.about.c_str());
    std::printf("  no node is faster than %.2f m/s\n", fastest_node(library, tmpl, row));
    for (const double time_s : row.times_s)
        std::printf("  at %.3f s: %s\n", time_s, shown_at(library, tmpl, row, time_s).c_str());
}

void draw_rows(Board &board, Portraits &portraits, const std::vector<BlendRow> &rows, const BlendArguments &a)
{
    const int count = static_cast<int>(rows.size()), columns = static_cast<int>(a.options.phases);
    const int wide = (a.width - 2 * margin_px + row_gap_px) / columns - row_gap_px;
    const int tall = (a.height - 2 * margin_px) / count - row_label_px;
    if (wide < 8 || tall < 8)
        throw scenes::Failure(std::to_string(count) + " rows of " + std::to_string(columns) +
                              " pictures do not fit into one of " + std::to_string(a.width) + " x " +
                              std::to_string(a.height));
    portraits.resize(wide, tall);
    for (int i = 0; i < count; ++i) {
        const BlendRow &row = rows[static_cast<size_t>(i)];
        const int y = margin_px + i * (tall + row_label_px);
        board.write(margin_px, y, 1, row.label, ink);
        board.write(margin_px + 10 * letter_width, y, 1, row.about, quiet);
        if (row.from_the_side) portraits.turn(0.98, 0.2);
        else portraits.turn(0.34, 0.94);
        for (int k = 0; k < columns; ++k) {
            board.paste(margin_px + k * (wide + row_gap_px), y + letter_height + 4, wide, tall,
                        portraits.picture(0, row.command, row.times_s[static_cast<size_t>(k)]));
        }
    }
}

void blend(const BlendArguments &a)
{
    expect_writable(a.out);
    scenes::Library library(1);
    const LoadedCharacter loaded = load_character(library, a.file, a.of_file, a.clips);
    clq_template *tmpl = loaded.tmpl.get();
    const std::vector<BlendRow> rows = blend_rows(tmpl, a.options);
    Board board(a.width, a.height, paper);
    Portraits portraits(library, loaded, 1);
    portraits.make_room(0.05, 0.12);
    draw_rows(board, portraits, rows, a);
    if (a.out == "-") return write_whole(a.out, board.rgb().data(), board.rgb().size());
    const std::vector<unsigned char> file = io::png(board.rgb().data(), a.width, a.height,
                                                    {{"Software", "claque " + version()},
                                                     {"Description", "Blends of clips of " + a.file},
                                                     {"Source", portraits.context_name()}});
    write_whole(a.out, file.data(), file.size());
    for (size_t i = 0; i < rows.size(); ++i) print_row(library, tmpl, i + 1, rows[i]);
}

}  // namespace

void add_blend(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<BlendArguments>();
    CLI::App *c = app.add_subcommand(
        "blend", "Draw strips of one person: a fade by each curve, layers over a part of the body, two gaits in step");
    c->add_option("FILE", a->file,
                  "glTF, GLB, prepared .clq, or the name of a built-in character (citizen, patrician ...)")
        ->required();
    c->add_option("--out,-o", a->out, "PNG file; - streams raw RGB, rows from the top")->required();
    c->add_option("--fade", a->options.fade,
                  "The clips of the first three rows, separated by a comma (default stand_wave,sit_cheer)")
        ->delimiter(',')
        ->expected(2)
        ->type_name("FROM,TO");
    c->add_option("--length", a->options.length_s, "Length of the fade in seconds")
        ->check(CLI::Range(0.0, 60.0))
        ->capture_default_str();
    c->add_option("--over", a->options.over, "The clip below the layers")->capture_default_str();
    c->add_option("--layer", a->options.layer, "The clip that replaces it, from a node on")->capture_default_str();
    c->add_option("--additive", a->options.added, "The clip that is added to it, from a node on")
        ->capture_default_str();
    c->add_option("--node", a->options.node, "The node where both layers begin")->capture_default_str();
    c->add_option("--gaits", a->options.gaits, "The clips of the last row, separated by a comma (default walk,jog)")
        ->delimiter(',')
        ->expected(2)
        ->type_name("A,B");
    c->add_option("--phases", a->options.phases, "Pictures in a row")->check(CLI::Range(2, 100))->capture_default_str();
    add_placement_options(*c, a->of_file.placement);
    add_clip_options(*c, a->clips);
    add_size_option(*c, a->width, a->height);
    c->callback([a, &chosen] { chosen = [a] { blend(*a); }; });
}

}  // namespace cli
