// What is seen depends on the model alone.
#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

class Pictures : public Staged
{
};

TEST_F(Pictures, OfTheSameScriptAreTheSameBits)
{
    const std::vector<std::string> steps = {"wait 0.4", "click person 3",  "drag view 0.3 0.3 0.4 0.35",
                                            "wheel 2",  "click \"Frame\"", "wait 0.2"};
    open({});
    play(steps);
    const std::vector<uint8_t> first = window();
    open({});
    play(steps);
    EXPECT_EQ(window(), first);
}

TEST_F(Pictures, OfAMomentAreTheSameWhenItIsScrubbedTo)
{
    view::Session &played = open({"plaza", 12, 480, 480});
    play({"wait 2", "click \"pause\"", "wait 0.1"});
    const std::vector<uint8_t> there = picture();
    const double at = played.model().clock.time_s;
    view::Session &scrubbed = open({"plaza", 12, 480, 480});
    scrubbed.model().clock.paused = true;
    scrubbed.model().clock.time_s = 50;
    play({"wait 0.1"});
    EXPECT_NE(picture(), there);
    scrubbed.model().clock.time_s = at;
    play({"wait 0.1"});
    EXPECT_EQ(picture(), there);
}

TEST_F(Pictures, AreTheSameWithEveryStrategyCacheAndNumberOfThreads)
{
    open({"plaza", 12, 480, 480});
    play({"wait 1", "click \"pause\"", "click \"Camera\"", "click \"Person\"", "click \"Frame\"", "wait 0.1"});
    const std::vector<uint8_t> usual = picture();
    for (const char *name : {"strategy: binned", "strategy: per zone", "caches: palettes", "caches: none",
                             "culling: last", "threads: 2", "strategy: fused"}) {
        play({std::string("click \"") + name + "\"", "wait 0.1"});
        EXPECT_EQ(picture(), usual) << name;
    }
    play({"click \"levels: early\"", "wait 0.1"});
    EXPECT_NE(picture(), usual);
}

TEST_F(Pictures, AreTintedAndGetTheirOwnColoursAgain)
{
    open({"plaza", 12, 480, 480});
    play({"click \"pause\"", "wait 0.1"});
    const std::vector<uint8_t> own = picture();
    for (const char *name : {"colours: level", "colours: rate", "colours: age"}) {
        play({std::string("click \"") + name + "\"", "wait 0.1"});
        EXPECT_NE(picture(), own) << name;
    }
    play({"click \"colours: own\"", "wait 0.1"});
    EXPECT_EQ(picture(), own);
}

// The guard is full, so the panels look the same whatever claque drew before them.
TEST_F(Pictures, HaveTheSamePanelsWhateverTheCrowdDrew)
{
    const auto bar = [this] {
        std::vector<uint8_t> rgb;
        surface().read(0, 480, 60, rgb);
        return rgb;
    };
    open({"plaza", 12, 480, 480});
    play({"click \"pause\"", "wait 0.1"});
    const std::vector<uint8_t> of_many = bar();
    open({"plaza", 1, 480, 480});
    play({"click \"pause\"", "wait 0.1"});
    EXPECT_EQ(bar(), of_many);
}

}  // namespace
