// Which individuals show a texture of their own: the nearest of the list, whatever was drawn before, and
// never more than the budget.
#include "tests/gl/support/close.h"
#include "tests/gl/support/hooked.h"
#include "tests/gl/support/spy.h"

namespace gltest
{
namespace
{

using claque::draw::DrawList;

constexpr uint64_t texture_bytes = 4 * ((128 * 128 * 4 - 1) / 3);  // with all mip levels

class CloseChoice : public GlTest
{
protected:
    static constexpr uint32_t crowd = 5;

    void SetUp() override
    {
        GlTest::SetUp();
        paint(*posed_.tmpl), paint(*small_.tmpl);
        for (uint32_t k = 0; k < 2 * crowd; ++k) {
            colours_.push_back(zone_colours(8));
            for (uint8_t &c : colours_.back()) c = static_cast<uint8_t>(c + 7 * k);
        }
    }

    static passes::RendererOptions room_for(uint64_t textures)
    {
        passes::RendererOptions options = close_options();
        options.close_bytes = textures * texture_bytes;
        return options;
    }

    // Side by side, at these distances, which only the choice looks at; with the colours from `first` on.
    DrawList row(const std::vector<float> &distances, uint32_t first = 0) const
    {
        const Camera camera = camera_on(posed_, 9, -0.3f, 0.2f, 4.0f / 3.0f);
        std::vector<Individual> people;
        for (uint32_t k = 0; k < distances.size(); ++k) {
            people.push_back(individual_of(posed_, camera, colours_[first + k].data()));
            people.back().model_view[12] += 2.0f * posed_.radius * (float(k) - 2);
        }
        DrawList list = list_of(people, camera.projection);
        for (size_t k = 0; k < distances.size(); ++k) list.items[k].eye_distance_m = distances[k];
        return list;
    }

    // A letter for each fifth of the picture's width: C where it differs from the strategy's picture, else s.
    std::string filtered(passes::Renderer &renderer, const DrawList &list)
    {
        const auto plain = make_renderer_of(posed_);
        EXPECT_TRUE(plain->prepare(*small_.tmpl).ok());
        const Picture a = draw(*context_, *plain, list), b = draw(*context_, renderer, list);
        std::string out(crowd, 's');
        for (size_t i = 0; i < a.size(); ++i)
            if (a[i] != b[i]) out[i / 3 % width * crowd / width] = 'C';
        return out;
    }

    const PosedModel posed_ = small_posed();
    const PosedModel small_ = make_posed(sheet(9, 0.2f), torture_map(32, 8, 3));
    std::vector<std::vector<uint8_t>> colours_;
};

TEST_F(CloseChoice, TakesTheNearestUpToTheBudget)
{
    const auto renderer = make_renderer_of(posed_, room_for(3));
    passes::DrawStats stats;
    const DrawList list = row({5, 1, 4, 2, 3});
    EXPECT_EQ(filtered(*renderer, list), "sCsCC");
    ASSERT_TRUE(renderer->draw(list, &stats).ok());
    EXPECT_EQ(stats.close_individuals, 3u);
    EXPECT_EQ(stats.close_made, 0u) << "they are kept";
    EXPECT_EQ(stats.close_bytes, 3 * texture_bytes);
    EXPECT_EQ(filtered(*renderer, row({1, 2, 3, 4, 5})), "CCCss");
}

TEST_F(CloseChoice, EndsAtTheFirstThatDoesNotFit)
{
    const auto renderer = make_renderer_of(posed_, room_for(1));
    ASSERT_TRUE(renderer->prepare(*small_.tmpl).ok());
    DrawList list = row({1, 2, 3, 4, 5});
    for (const size_t k : {0u, 2u}) {
        list.items[k].tmpl = small_.tmpl.get();
        list.items[k].vertices.positions = small_.positions.data();
        list.items[k].vertices.normals = small_.normals.data();
    }
    EXPECT_EQ(filtered(*renderer, list), "Cssss") << "the third would fit, but the second is nearer";
}

TEST_F(CloseChoice, IsThatOfTheListWhateverWasDrawnBefore)
{
    const auto fresh = make_renderer_of(posed_, room_for(2)), used = make_renderer_of(posed_, room_for(2));
    for (uint32_t k = 0; k < crowd; ++k) draw(*context_, *used, row({float(5 - k), 1, float(k), 3, 2}, k));
    EXPECT_EQ(draw(*context_, *used, row({4, 5, 1, 3, 2}, 1)), draw(*context_, *fresh, row({4, 5, 1, 3, 2}, 1)));
}

TEST_F(CloseChoice, ShowsNewColoursAtOnce)
{
    const auto fresh = make_renderer_of(posed_, close_options()), used = make_renderer_of(posed_, close_options());
    const DrawList list = row({1, 2, 3, 4, 5});
    const Picture before = draw(*context_, *used, list);
    for (uint8_t &c : colours_[2]) c = static_cast<uint8_t>(c / 2);  // where the list points
    EXPECT_NE(draw(*context_, *used, list), before);
    EXPECT_EQ(draw(*context_, *used, list), draw(*context_, *fresh, list));
}

TEST_F(CloseChoice, HoldsOneTextureForAllThatShowTheSame)
{
    const auto renderer = make_renderer_of(posed_, room_for(1));
    DrawList list = row({1, 2, 3, 4, 5});
    for (auto &item : list.items) item.zone_rgb = colours_[0].data();
    passes::DrawStats stats;
    ASSERT_TRUE(renderer->draw(list, &stats).ok());
    EXPECT_EQ(stats.close_individuals, crowd);
    EXPECT_EQ(stats.close_made, 1u);
}

TEST_F(CloseChoice, NeverHoldsMoreThanTheBudget)
{
    Spy spy(*context_);
    passes::Renderer renderer(std::pmr::get_default_resource(), room_for(3));
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    ASSERT_TRUE(renderer.prepare(*posed_.tmpl).ok());
    int held = 0, most = 0;
    spy.watch = [&](const std::string &name, const std::vector<double> &) {
        if (name == "glGenTextures") most = std::max(most, ++held);
        if (name == "glDeleteTextures") --held;
    };
    for (uint32_t k = 0; k < 4 * crowd; ++k) {
        passes::DrawStats stats;
        ASSERT_TRUE(renderer.draw(row({float(k % 5), 1, float(k % 3), 3, 2}, k % crowd), &stats).ok());
        EXPECT_EQ(stats.close_bytes, uint64_t(held) * texture_bytes);
    }
    EXPECT_EQ(most, 3);
    spy.watch = nullptr;
    renderer.destroy();
}

TEST_F(CloseChoice, MakesNoMoreInADrawThanALiveHostAllowsAndEndsWithTheSamePicture)
{
    passes::RendererOptions live = room_for(4);
    live.close_per_draw = 1;
    const auto renderer = make_renderer_of(posed_, live), at_once = make_renderer_of(posed_, room_for(4));
    const DrawList list = row({5, 1, 4, 2, 3});
    for (const char *now : {"sCsss", "sCsCs", "sCsCC", "sCCCC", "sCCCC"}) EXPECT_EQ(filtered(*renderer, list), now);
    EXPECT_EQ(draw(*context_, *renderer, list), draw(*context_, *at_once, list));
}

TEST_F(CloseChoice, LeavesOutIndividualsTooFarAwayAndThoseWithHooks)
{
    passes::RendererOptions options = close_options();
    options.close_distance_m = 3;
    const auto renderer = make_renderer_of(posed_, options);
    DrawList list = row({1, 3, 2, 4, 2.9f});
    EXPECT_EQ(filtered(*renderer, list), "CsCsC");
    const Callbacks nothing([] { return 0; }, [] {});
    list.items[2].hooks = &nothing.hooks;
    EXPECT_EQ(filtered(*renderer, list), "CsssC");
    list.distance_scale = 0.5f;  // a picture of twice the lines
    EXPECT_EQ(filtered(*renderer, list), "CCsCC");
}

}  // namespace
}  // namespace gltest
