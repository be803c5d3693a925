// Half an hour of an engineer, in seconds.
#include "samples/io/files.h"
#include "tests/view/staged.h"

namespace
{

using view_test::Staged;

class HalfHour : public Staged
{
};

TEST_F(HalfHour, OfAnEngineerWhoAsksWhyAFrameIsSlow)
{
    view::Session &s = open({"plaza", 20, 640, 480});
    const std::string path = std::string(CLAQUE_SOURCE_DIR) + "/samples/view/scripts/engineer.toml";
    std::string text;
    ASSERT_EQ(io::read_whole(path, text), "");
    view::Player player(view::read_script(text, "engineer.toml"), 640, 480);
    view::Input input;
    double spent_s = 0;
    uint32_t fully_skinned = 0;                // frames without caches, in which all in view are skinned
    uint64_t fewest = ~uint64_t{0}, most = 0;  // triangles
    while (player.next(input, s.ui(), s.world())) {
        s.frame(input);
        spent_s += input.elapsed_s;
        const view::FrameCost &cost = s.model().cost;
        fully_skinned += s.model().switches.cache == 2 && cost.crowd.skinned == cost.crowd.visible;
        if (cost.crowd.visible < 15) continue;
        fewest = std::min<uint64_t>(fewest, cost.drawn.triangles);
        most = std::max<uint64_t>(most, cost.drawn.triangles);
    }
    EXPECT_GE(spent_s, 1800);
    EXPECT_GE(fully_skinned, 15u);
    EXPECT_LT(fewest, most / 2) << "levels of detail that begin early";
    EXPECT_EQ(s.model().picked.actor.index1, 3u);
}

}  // namespace
