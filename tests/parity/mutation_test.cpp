// The comparison must be able to fail: the library's output for a crowd is compared with that for the same crowd with
// one error. Vertices alone must show the error, and pictures alone, because another renderer may have only one of
// them.
#include "tests/parity/mutation.h"

namespace parity
{
namespace
{

TEST_F(Mutation, NonePassesExactly)
{
    make_scene_renderer();
    const Capture a = capture(), b = capture();
    EXPECT_EQ(broken(a, b, "exact"), "");
    EXPECT_EQ(a.actors->size(), 12u);
    EXPECT_TRUE(compare(a, b, 67).not_compared.empty());
}

TEST_F(Mutation, OneActorMissingIsCaught)
{
    options_.scene = "parade";  // a scene whose individuals do not move
    make_scene_renderer();
    const Capture a = capture();
    scenes::check(clq_actor_destroy(crowd(), nearest(a)));
    const Capture b = capture();
    expect_broken(broken(vertices_of(a), vertices_of(b)), "actors.missing is 1");
    expect_broken(broken(pictures_of(a), pictures_of(b)), "actor_ids.outside");
    expect_broken(broken(a, colours_of(b)), "colour.worst_zone");
}

TEST_F(Mutation, OneLevelOfDetailSwappedIsCaught)
{
    options_.crowd_options.lod_scale = 3;
    make_scene_renderer();
    const Capture a = capture();
    const clq_actor person = nearest(a);
    const uint32_t level = info_of(person).level;
    scenes::check(clq_actor_set_priority(crowd(), person, 0.9f));
    const Capture b = capture();
    ASSERT_NE(info_of(person).level, level);
    expect_broken(broken(vertices_of(a), vertices_of(b)), "actors.changed is 1");
    expect_broken(broken(pictures_of(a), pictures_of(b)), "zone_ids.");
    EXPECT_NE(broken(a, colours_of(b)), "");
}

TEST_F(Mutation, AChangedZoneColourIsCaught)
{
    make_scene_renderer();
    const Capture a = capture();
    const clq_actor person = nearest(a);
    const clq_template *tmpl = info_of(person).tmpl;
    clq_template_info info = clq_template_info_init();
    scenes::check(clq_template_get_info(tmpl, &info));
    std::vector<float> colours(3 * size_t{info.zone_count}, 0.5f);
    scenes::check(clq_actor_set_colours(crowd(), person, colours.data(), info.zone_count));
    const Capture grey = capture();
    colours[3 * widest_zone(grey, person) + 1] = 0.56f;  // a little more green in one zone of one of twelve individuals
    scenes::check(clq_actor_set_colours(crowd(), person, colours.data(), info.zone_count));
    const Capture greener = capture();
    EXPECT_EQ(broken(vertices_of(grey), vertices_of(greener), "exact"), "");
    expect_broken(broken(grey, greener), "colour.worst_zone");
    expect_broken(broken(grey, colours_of(greener)), "colour.worst_zone");
}

TEST_F(Mutation, APoseOneTickOldIsCaught)
{
    make_scene_renderer();
    const Capture first = capture();
    const clq_actor person = nearest(first);
    clq_play play = info_of(person).play;
    play.clip = 1, play.speed = 1;
    scenes::check(clq_actor_play(crowd(), person, &play));
    const Capture a = capture();
    play.start_s += double(info_of(person).period_s);
    scenes::check(clq_actor_play(crowd(), person, &play));
    const Capture b = capture();
    expect_broken(broken(vertices_of(a), vertices_of(b)), "positions.max_relative");
    EXPECT_NE(broken(pictures_of(a), pictures_of(b)), "");
    EXPECT_NE(broken(a, colours_of(b)), "");
}

// Columns move to the right; the first is duplicated.
template <class Values>
void shift(Values &values, size_t width, size_t numbers)
{
    for (size_t row = 0; row < values.size(); row += width * numbers)
        std::copy_backward(values.begin() + static_cast<std::ptrdiff_t>(row),
                           values.begin() + static_cast<std::ptrdiff_t>(row + (width - 1) * numbers),
                           values.begin() + static_cast<std::ptrdiff_t>(row + width * numbers));
}

TEST_F(Mutation, AShiftByOnePixelIsCaught)
{
    make_scene_renderer();
    const Capture a = capture();
    Capture b = a;
    const size_t width = static_cast<size_t>(a.width);
    shift(b.colour->rgb, width, 3);
    expect_broken(broken(a, b), "colour.over_2");
    b = a;
    shift(b.depth->values, width, 1);
    expect_broken(broken(a, b), "depth.");
    b = a;
    shift(b.actor->values, width, 1);
    shift(b.zone->values, width, 1);
    expect_broken(broken(a, b), "actor_ids.at_silhouettes");
    b = a;
    shift(b.zone->values, width, 1);
    expect_broken(broken(a, b), "zone_ids.");
}

// A bending strip whose rows follow two joints, and the same with one influence of one vertex left out.
TEST_F(Mutation, AWeightDroppedIsCaught)
{
    options_.scene = "parade";
    options_.crowd_options.count = 1;
    std::vector<Capture> captures;
    for (const bool dropped : {false, true}) {
        std::vector<float> weights = weights_of_strip();
        if (dropped) weights[4] = 1, weights[5] = 0;  // row 1, which has 3 to 1
        captures.push_back(capture_of_strip(weights));
        scene_renderer_.reset();
    }
    ASSERT_GT(captures[0].actors->at(0).size_m, 1);
    expect_broken(broken(vertices_of(captures[0]), vertices_of(captures[1])), "positions.max_relative");
    EXPECT_NE(broken(pictures_of(captures[0]), pictures_of(captures[1])), "");
}

}  // namespace
}  // namespace parity
