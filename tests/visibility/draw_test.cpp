// Visibility pictures as drawings: numbers, state, refusals.
#include <set>

#include "tests/visibility/people.h"

namespace
{

using namespace visibility_test;
using scenes::check;

class VisibilityPicture : public People
{
protected:
    clq_status drawn(const clq_visibility_def &def)
    {
        return clq_renderer_draw_visibility(renderer_.get(), view_, &def, nullptr);
    }
};

TEST_F(VisibilityPicture, CountsFromItsFirstNumberAndHasTheUpperBitsInAnother)
{
    place(3, 4);
    update(1);
    const std::vector<uint32_t> plain = draw();
    uint64_t count = 0;
    check(clq_view_get_triangle_count(view_, &count));
    clq_visibility_def def = clq_visibility_def_init();
    def.first_number = 0xfffff0;  // the numbers of most triangles need more than 24 bits
    const std::vector<uint32_t> lower = draw(def);
    def.upper_bits = true;
    const std::vector<uint32_t> upper = draw(def);
    size_t beyond = 0;
    for (size_t i = 0; i < plain.size(); ++i) {
        ASSERT_LE(plain[i], count);
        if (plain[i] == 0) continue;
        ASSERT_EQ((lower[i] | upper[i] << 24) - 0xfffff0, plain[i] - 1);
        beyond += upper[i] != 0;
    }
    EXPECT_GT(beyond, 100u);
}

TEST_F(VisibilityPicture, OfOneIndividualAloneIsItsSilhouetteAndKeepsItsNumbers)
{
    place(5, 5);
    update(1);
    const std::vector<uint32_t> all = draw();
    const Channels found = channels();
    clq_view_stats stats = clq_view_stats_init();
    check(clq_view_get_stats(view_, &stats));
    size_t hidden = 0;
    for (uint32_t one = 0; one < stats.visible; ++one) {
        std::vector<uint8_t> drawn(stats.visible, 0);
        drawn[one] = 1;
        clq_visibility_def def = clq_visibility_def_init();
        def.drawn = drawn.data();
        const std::vector<uint32_t> alone = draw(def);
        for (size_t i = 0; i < all.size(); ++i) {
            if (found.individuals[i] == one) ASSERT_EQ(alone[i], all[i]);
            hidden += alone[i] != 0 && found.individuals[i] != one;
        }
    }
    EXPECT_GT(hidden, 0u);
}

TEST_F(VisibilityPicture, RefusesWhatHasNoNumbers)
{
    place(5, 3);
    update(1);
    clq_visibility_def def = clq_visibility_def_init();
    def.first_number = 0;
    EXPECT_EQ(drawn(def), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("first_number is 0"), std::string::npos) << clq_last_error();
    def.first_number = 0xffffffff;
    EXPECT_EQ(drawn(def), CLQ_LIMIT);
    EXPECT_NE(std::string(clq_last_error()).find("numbers have 32 bits"), std::string::npos) << clq_last_error();
    def = clq_visibility_def_init();
    ++def.struct_bytes;
    EXPECT_EQ(drawn(def), CLQ_STRUCT_SIZE);
    draw();
    numbers_[17] = 0x7fffffff;
    const clq_pixels wrong = pixels();
    std::vector<uint32_t> actors(numbers_.size(), 77);
    clq_pixel_channels channels = clq_pixel_channels_init();
    channels.actors = actors.data();
    EXPECT_EQ(clq_view_get_pixels(view_, &wrong, &channels), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("pixel 17 has number 2147483647"), std::string::npos)
        << clq_last_error();
    EXPECT_EQ(std::set<uint32_t>(actors.begin(), actors.end()), std::set<uint32_t>{77});
}

TEST_F(VisibilityPicture, RefusesATargetWithoutEightBitsOfColour)
{
    std::string why_not;
    const auto coarse =
        contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgb565, why_not);
    if (!coarse) END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = coarse->get_proc_address(), def.user = coarse->user();
    clq_renderer *made = nullptr;
    check(clq_renderer_create(library_.context(), &def, &made));
    const scenes::Own<clq_renderer> renderer(made);
    place(5, 1);
    clq_drawn_actor one = clq_drawn_actor_init();
    update(1);
    check(clq_view_get_drawn_actor(view_, 0, &one));
    check(clq_renderer_prepare(made, const_cast<clq_template *>(one.tmpl)));
    EXPECT_EQ(clq_renderer_draw_visibility(made, view_, nullptr, nullptr), CLQ_GL_STATE);
    EXPECT_NE(std::string(clq_last_error()).find("numbers need 8 of each"), std::string::npos) << clq_last_error();
}

}  // namespace
