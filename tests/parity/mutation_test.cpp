// The comparison must be able to fail: the library's output for a crowd is compared with that for the same crowd with
// one error. Vertices alone must show the error, and pictures alone, because another renderer may have only one of
// them.
#include <algorithm>
#include <filesystem>
#include <unistd.h>

#include <gtest/gtest.h>

#include "samples/parity/compare.h"
#include "samples/parity/verdict.h"
#include "samples/parity/write/write.h"
#include "tests/api/small_template.h"
#include "tests/gl/support/absent.h"

namespace parity
{
namespace
{

namespace fs = std::filesystem;

constexpr double moment_s = 2;

class Mutation : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        if (!contexts::make_offscreen(contexts::Kind::any, 16, 16, contexts::PixelFormat::rgba8888, why_not))
            END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
        folder_ = fs::temp_directory_path() / ("claque-mutation-" + std::to_string(getpid()));
        options_.crowd_options.count = 12;
        options_.crowd_options.lod = scenes::Lod::on;
        options_.width = 480;
        options_.height = 360;
    }
    void TearDown() override
    {
        scene_renderer_.reset();
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    void make_scene_renderer() { scene_renderer_ = std::make_unique<scenes::SceneRenderer>(library_, options_); }
    Capture capture()
    {
        write_result(*scene_renderer_, {options_.scene, moment_s, options_.width, options_.height}, folder_.string());
        return read_capture(folder_.string());
    }
    clq_crowd *crowd() const { return scene_renderer_->scene().crowd(); }
    clq_actor_info info_of(clq_actor actor) const
    {
        clq_actor_info info = clq_actor_info_init();
        scenes::check(clq_actor_get_info(crowd(), actor, &info));
        return info;
    }
    // Of the pixels at which the id map shows the actor.
    static size_t pixels_of(const Capture &c, clq_actor actor)
    {
        return static_cast<size_t>(std::count(c.actor->values.begin(), c.actor->values.end(), actor.index1));
    }
    // The actor that fills most of the picture, so that every mutation is visible.
    clq_actor nearest(const Capture &c) const
    {
        const std::vector<clq_actor> all = scene_renderer_->scene().actors();
        return *std::max_element(all.begin(), all.end(),
                                 [&](clq_actor a, clq_actor b) { return pixels_of(c, a) < pixels_of(c, b); });
    }

    // The zone of the actor that most pixels show.
    static size_t widest_zone(const Capture &c, clq_actor actor)
    {
        std::vector<size_t> pixels(UINT16_MAX + 1);
        for (size_t i = 0; i < c.zone->values.size(); ++i)
            if (c.actor->values[i] == actor.index1) ++pixels[c.zone->values[i]];
        return static_cast<size_t>(std::max_element(pixels.begin() + 1, pixels.end()) - pixels.begin()) - 1;
    }

    static Capture vertices_of(Capture c)
    {
        c.colour.reset(), c.depth.reset(), c.actor.reset(), c.zone.reset();
        return c;
    }
    static Capture pictures_of(Capture c)
    {
        c.actors.reset(), c.positions.reset(), c.normals.reset();
        return c;
    }
    static Capture colours_of(Capture c)
    {
        c = pictures_of(std::move(c));
        c.depth.reset(), c.actor.reset(), c.zone.reset();
        return c;
    }
    // Exceeded limits of what both have; empty: these are kept.
    static std::string broken(const Capture &reference, const Capture &result, const char *tolerance = "gpu")
    {
        Verdict verdict = verdict_of(compare(reference, result, 67), tolerance_of(tolerance));
        verdict.lacking.clear();
        return reasons(verdict, 99);
    }
    static void expect_broken(const std::string &said, const char *measure)
    {
        EXPECT_NE(said.find(measure), std::string::npos) << "said: " << said;
    }

    fs::path folder_;
    scenes::Library library_{1};
    scenes::SceneOptions options_;
    std::unique_ptr<scenes::SceneRenderer> scene_renderer_;
};

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
        SmallTemplate strip;
        std::vector<float> weights(strip.parts[0].weights, strip.parts[0].weights + 20);
        if (dropped) weights[4] = 1, weights[5] = 0;  // row 1, which has 3 to 1
        strip.parts[0].weights = weights.data();
        clq_template *tmpl = nullptr;
        scenes::check(clq_template_build(library_.context(), &strip.def, &tmpl));
        const scenes::Own<clq_template> held(tmpl);
        options_.character.tmpl = tmpl;
        make_scene_renderer();
        captures.push_back(capture());
        scene_renderer_.reset();
    }
    ASSERT_GT(captures[0].actors->at(0).size_m, 1);
    expect_broken(broken(vertices_of(captures[0]), vertices_of(captures[1])), "positions.max_relative");
    EXPECT_NE(broken(pictures_of(captures[0]), pictures_of(captures[1])), "");
}

}  // namespace
}  // namespace parity
