// The arrays of a draw list in the library's own memory.
#include "tests/api/drawn_actor_fixture.h"

namespace
{

class DrawnArrays : public api_test::DrawnActor
{
protected:
    // Everything that the calls copy of an individual of the small template.
    struct Copies {
        std::vector<float> positions, normals, palette;
        std::vector<uint8_t> colours;
    };
    Copies copies(uint32_t index)
    {
        Copies out{std::vector<float>(30), std::vector<float>(30), std::vector<float>(24), std::vector<uint8_t>(6)};
        EXPECT_EQ(clq_view_get_vertices(view_, index, out.positions.data(), out.normals.data(), 10), CLQ_OK);
        EXPECT_EQ(clq_view_get_palette(view_, index, out.palette.data(), 2), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_view_get_colours(view_, index, out.colours.data(), 2), CLQ_OK);
        return out;
    }
    clq_drawn_arrays arrays(uint32_t index)
    {
        clq_drawn_arrays out = clq_drawn_arrays_init();
        EXPECT_EQ(clq_view_get_arrays(view_, index, &out), CLQ_OK) << clq_last_error();
        return out;
    }
    static void expect_held(const Copies &copied, const clq_drawn_arrays &held)
    {
        ASSERT_TRUE(held.positions && held.normals && held.palette);
        EXPECT_EQ(held.packed_positions, nullptr);
        EXPECT_EQ(held.packed_normals, nullptr);
        EXPECT_EQ(held.morph_weights, nullptr);
        EXPECT_EQ(copied.positions, std::vector<float>(held.positions, held.positions + 30));
        EXPECT_EQ(copied.normals, std::vector<float>(held.normals, held.normals + 30));
        EXPECT_EQ(copied.palette, std::vector<float>(held.palette, held.palette + 24));
        if (held.colours) {
            EXPECT_EQ(copied.colours, std::vector<uint8_t>(held.colours, held.colours + 6));
        }
    }
};

TEST_F(DrawnArrays, HoldWhatTheCallsCopy)
{
    for (const clq_cache_mode cache : {CLQ_CACHE_FULL, CLQ_CACHE_ANIMATION, CLQ_CACHE_NONE}) {
        SCOPED_TRACE(cache);
        clq_crowd_def def = clq_crowd_def_init();
        def.cache = cache;
        fill(def);
        for (uint32_t i = 0; i < 3; ++i) {
            const clq_drawn_arrays held = arrays(i);
            expect_held(copies(i), held);
            EXPECT_EQ(held.colours != nullptr, i == 1) << "the others have their template's colours";
            EXPECT_EQ(held.positions, arrays(i).positions) << "no copy";
        }
        EXPECT_NE(arrays(0).positions, arrays(1).positions);
    }
}

TEST_F(DrawnArrays, StayUntilTheNextUpdateWhateverTheHostSets)
{
    fill(clq_crowd_def_init());
    const Copies copied = copies(1);
    const clq_drawn_arrays held = arrays(1);
    const clq_actor second = {2, 1};
    const float red[6] = {1, 0, 0, 1, 0, 0};
    ASSERT_EQ(clq_actor_set_colours(crowd_, second, red, 2), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_actor_destroy(crowd_, second), CLQ_OK) << clq_last_error();
    clq_actor_def actor = clq_actor_def_init();
    actor.tmpl = tmpl_;
    for (int i = 0; i < 500; ++i) {
        clq_actor made;
        ASSERT_EQ(clq_actor_create(crowd_, &actor, &made), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_actor_randomise_colours(crowd_, made, nullptr, 0), CLQ_OK);
    }
    clq_view *another = nullptr;
    ASSERT_EQ(clq_view_create(crowd_, &another), CLQ_OK);
    expect_held(copied, held);
    EXPECT_EQ(arrays(1).positions, held.positions);
    EXPECT_EQ(arrays(1).colours, held.colours);
}

TEST_F(DrawnArrays, ThatArePackedUnpackToTheVertices)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.vertex_format = CLQ_VERTEX_PACKED;
    fill(def);
    for (uint32_t i = 0; i < 3; ++i) {
        const Copies copied = copies(i);
        const clq_drawn_arrays held = arrays(i);
        EXPECT_EQ(held.positions, nullptr);
        EXPECT_EQ(held.normals, nullptr);
        ASSERT_TRUE(held.packed_positions && held.packed_normals);
        for (size_t v = 0; v < 10; ++v)
            for (size_t k = 0; k < 3; ++k) {
                const float n = held.packed_positions[4 * v + k];
                EXPECT_EQ(held.packed_offset[k] + held.packed_step * n, copied.positions[3 * v + k]);
                EXPECT_EQ(static_cast<float>(held.packed_normals[4 * v + k]) / 127.0f, copied.normals[3 * v + k]);
            }
    }
}

}  // namespace
