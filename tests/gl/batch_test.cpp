// Individuals of few triangles share calls: who does, what is shown, and that neighbours of another kind stay apart.
#include "lib/figures/figure.h"
#include "lib/lod/far.h"
#include "tests/gl/support/hooked.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

// The citizen in about 120 triangles, each of one zone.
Figure far_figure()
{
    model::Model model = claque::figures::citizen();
    std::vector<const model::Part *> parts;
    for (const model::Part &part : model.parts) parts.push_back(&part);
    claque::lod::FarWish wish;
    wish.targets = {120};
    claque::lod::FarLevels far = claque::lod::make_far(model, parts, wish);
    claque::lod::enter(far, model);
    model.parts = far.parts;
    return split_figure(model);
}

class Batches : public GlTest
{
protected:
    static constexpr uint32_t across = 8, crowd = 40;

    void SetUp() override
    {
        GlTest::SetUp();
        static const Figure made = far_figure();
        figure_ = &made;
        for (uint32_t who = 0; who < crowd; ++who)
            colours_.push_back(zone_colours(static_cast<uint32_t>(made.tmpl->zone_count())));
        for (uint32_t who = 0; who < crowd; ++who)
            for (size_t i = 0; i < colours_[who].size(); ++i)
                colours_[who][i] = static_cast<uint8_t>(colours_[who][i] + 5 * who);
    }

    // Rows of people, each turned and coloured otherwise.
    DrawList many() const
    {
        const Camera camera = camera_on(*figure_, 9, -0.3f, 0.2f, 4.0f / 3.0f);
        std::vector<Individual> people;
        for (uint32_t who = 0; who < crowd; ++who) {
            Individual one = individual_of(*figure_, camera, colours_[who].data());
            one.model_view[12] += 1.1f * figure_->radius * (float(who % across) - 3.5f);
            one.model_view[13] += 1.3f * figure_->radius * (float(who / across) - 2);
            people.push_back(one);
        }
        return list_of(people, camera.projection);
    }
    static passes::RendererOptions apart()
    {
        passes::RendererOptions options;
        options.batch_triangles = 0;
        return options;
    }
    Picture shown(const DrawList &list, const passes::RendererOptions &options, passes::DrawStats *stats = nullptr)
    {
        const auto renderer = make_renderer_of(*figure_, options);
        const Picture picture = draw(*context_, *renderer, list);
        if (stats) {
            EXPECT_TRUE(renderer->draw(list, stats).ok());
        }
        return picture;
    }
    static uint32_t different(const Picture &a, const Picture &b, int beyond)
    {
        uint32_t count = 0;
        for (size_t i = 0; i + 2 < a.size(); i += 3) {
            int most = 0;
            for (size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a[i + c]) - int(b[i + c])));
            count += most > beyond;
        }
        return count;
    }
    static uint32_t covered(const Picture &picture)
    {
        uint32_t count = 0;
        for (size_t i = 0; i + 2 < picture.size(); i += 3)
            count += !std::equal(background, background + 3, picture.begin() + std::ptrdiff_t(i));
        return count;
    }

    const Figure *figure_ = nullptr;
    std::vector<std::vector<uint8_t>> colours_;
};

TEST_F(Batches, TakeManyIndividualsInOneCall)
{
    passes::DrawStats together, one_by_one;
    shown(many(), {}, &together);
    shown(many(), apart(), &one_by_one);
    const uint32_t vertices = figure_->tmpl->levels[0].vertex_count;
    const uint32_t a_call = passes::Scratch::batch_vertices / vertices;
    ASSERT_GT(a_call, 3u);
    EXPECT_EQ(together.draws, (crowd + a_call - 1) / a_call);
    EXPECT_EQ(one_by_one.draws, crowd);
    EXPECT_EQ(together.individuals, one_by_one.individuals);
    EXPECT_EQ(together.triangles, one_by_one.triangles);
    EXPECT_EQ(together.vertices, one_by_one.vertices);
}

// Rounding on the way to the eye moves an edge over a pixel's middle now and then.
TEST_F(Batches, ShowWhatSingleCallsShow)
{
    const Picture together = shown(many(), {}), one_by_one = shown(many(), apart());
    ASSERT_GT(covered(one_by_one), 5000u);
    EXPECT_LE(different(together, one_by_one, 0) * 1000, covered(one_by_one));
    DrawList moved = many();
    moved.items[crowd - 1].model_view[12] += 0.05f * figure_->radius;
    EXPECT_GT(different(shown(moved, {}), one_by_one, 0) * 1000, covered(one_by_one));
}

TEST_F(Batches, AreTheSameForAllStrategiesAndFormatsOfColours)
{
    const Picture expected = shown(many(), {});
    for (const passes::Strategy strategy : all_strategies)
        for (const passes::ColourFormat colours : {passes::ColourFormat::ubyte, passes::ColourFormat::real}) {
            passes::RendererOptions options = options_of(strategy);
            options.colours = colours;
            EXPECT_TRUE(shown(many(), options) == expected) << int(strategy) << " " << int(colours);
        }
}

// Lit from the side, in odd scales and mirrored: normals go the way that GL's would.
TEST_F(Batches, LightTheirIndividualsAsGlWould)
{
    const float from_side[4] = {1, 0.4f, 0.2f, 0};
    host_->Enable(0x0B50);  // GL_LIGHTING
    host_->Enable(0x4000);
    host_->Lightfv(0x4000, 0x1203, from_side);
    DrawList list = many();
    for (uint32_t who = 0; who < crowd; ++who) {
        float *m = list.items[who].model_view;
        for (int r = 0; r < 3; ++r) m[r] *= 0.8f, m[4 + r] *= 1.3f, m[8 + r] *= who % 3 == 0 ? -1.0f : 1.0f;
        list.items[who].mirrored = who % 3 == 0;
    }
    const Picture together = shown(list, {}), one_by_one = shown(list, apart());
    EXPECT_GT(different(one_by_one, shown(many(), apart()), 40), 1000u);
    EXPECT_LE(different(together, one_by_one, 1) * 500, covered(one_by_one));
}

TEST_F(Batches, AreDrawnBeforeTheHooksOfWhoComesNext)
{
    std::vector<uint32_t> seen;
    DrawList list = many();
    Picture before;
    const auto read =
        host_->ask<void (*)(int32_t, int32_t, int32_t, int32_t, gl::Enum, gl::Enum, void *)>("glReadPixels");
    const auto look = [&] {
        before.resize(size_t(3) * width * height);
        read(0, 0, width, height, 0x1907, gl::unsigned_byte, before.data());  // GL_RGB
        seen.push_back(covered(before));
        return 0;
    };
    const Callbacks both(look, look);
    list.items[20].hooks = &both.hooks;
    passes::DrawStats stats;
    shown(list, {}, &stats);
    ASSERT_GE(seen.size(), 2u);
    EXPECT_GT(seen[0], 1000u);    // those before it
    EXPECT_GT(seen[1], seen[0]);  // and then it, alone
    EXPECT_EQ(stats.individuals, crowd);
}

TEST_F(Batches, LeaveWhoHasMoreTrianglesToASingleCall)
{
    passes::RendererOptions few;
    few.batch_triangles = 60;
    passes::DrawStats stats;
    shown(many(), few, &stats);
    EXPECT_EQ(stats.draws, crowd);
}

}  // namespace
}  // namespace gltest
