// A layer over an arm of a person who walks on a track takes its share of the swing, as a thing that is carried does.
#include <array>

#include "tests/api/walkers.h"

using walkers::Walkers;

namespace
{

struct Swings {
    double left = 0, right = 0;  // metres, of a hand against its shoulder along the way
    std::array<double, 6> feet = {};
};

struct Arms : Walkers {
    // A layer of the standing clip over the left arm has this weight; 0: no layer.
    Swings of(float weight)
    {
        clq_crowd *crowd = this->crowd();
        const clq_actor actor = walker(crowd, track(1.3, 0));
        if (weight > 0) {
            const char *arm = "upper_arm_l";
            clq_mask_def mask = clq_mask_def_init();
            mask.tmpl = citizen_, mask.node_count = 1, mask.nodes = &arm;
            clq_layer_def def = clq_layer_def_init();
            def.play.clip = clq_template_find_clip(citizen_, "stand"), def.weight = weight;
            EXPECT_EQ(clq_crowd_add_mask(crowd, &mask, &def.mask), CLQ_OK) << clq_last_error();
            clq_layer layer = {0};
            EXPECT_EQ(clq_actor_add_layer(crowd, actor, &def, &layer), CLQ_OK) << clq_last_error();
        }
        Swings made;
        double least[2] = {9, 9}, most[2] = {-9, -9};
        for (double t = 1; t < 4; t += 0.02) {
            EXPECT_EQ(clq_crowd_update(crowd, t, nullptr, 0), CLQ_OK);
            for (int side = 0; side < 2; ++side) {
                const double at = along(crowd, actor, side ? "hand_r" : "hand_l", t) -
                                  along(crowd, actor, side ? "upper_arm_r" : "upper_arm_l", t);
                least[side] = std::min(least[side], at), most[side] = std::max(most[side], at);
            }
        }
        made.left = most[0] - least[0], made.right = most[1] - least[1];
        const auto left = place(crowd, actor, clq_template_find_node(citizen_, "foot_l"), 2.5);
        const auto right = place(crowd, actor, clq_template_find_node(citizen_, "foot_r"), 2.5);
        made.feet = {left[0], left[1], left[2], right[0], right[1], right[2]};
        return made;
    }

    double along(clq_crowd *crowd, clq_actor actor, const char *node, double time_s)
    {
        return place(crowd, actor, clq_template_find_node(citizen_, node), time_s)[0];
    }
};

}  // namespace

TEST_F(Arms, SwingByTheShareThatALayerLeavesThemAndNothingElseChanges)
{
    const Swings free = of(0), half = of(0.5f), still = of(1);
    EXPECT_GT(free.left, 0.2);
    EXPECT_NEAR(free.left, free.right, 0.05);
    EXPECT_NEAR(half.left / free.left, 0.5, 0.1);
    EXPECT_LT(still.left / free.left, 0.15);
    for (const Swings &other : {half, still}) {
        EXPECT_NEAR(other.right, free.right, 1e-5);
        for (size_t k = 0; k < free.feet.size(); ++k) EXPECT_NEAR(other.feet[k], free.feet[k], 1e-5);
    }
}
