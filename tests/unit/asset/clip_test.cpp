// Animations, in files of one triangle whose node moves.
#include <gtest/gtest.h>

#include "maker.h"

namespace claque::testing
{
namespace
{

// One channel of node 0.
Maker moved(const char *path, const char *interpolation, const std::vector<float> &times, const char *type,
            size_t count, const std::vector<float> &values)
{
    Maker maker;
    maker.triangle();
    const int input = maker.floats("SCALAR", times.size(), times), output = maker.floats(type, count, values);
    maker.add("animations",
              {{"samplers", Json::array({{{"input", input}, {"output", output}, {"interpolation", interpolation}}})},
               {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}})}});
    return maker;
}

TEST(Clip, StartsAtItsFirstKeyAndLastsToItsLast)
{
    const model::Rig rig = load(moved("translation", "LINEAR", {0.5f, 2}, "VEC3", 2, {1, 2, 3, 4, 5, 6}).glb()).rig;
    ASSERT_EQ(rig.clips.size(), 1u);
    EXPECT_FLOAT_EQ(rig.clips[0].start_s, 0.5f);
    EXPECT_FLOAT_EQ(rig.clips[0].duration_s, 1.5f);
    EXPECT_STREQ(rig.clip_names[0].c_str(), "clip 0");
    EXPECT_EQ(rig.channels.at(0).interpolation, model::Interpolation::linear);
    EXPECT_EQ(rig.values[rig.channels[0].first_value + 4], 5);
}

TEST(Clip, OfOneKeyHasNoLength)
{
    const model::Rig rig = load(moved("scale", "STEP", {3}, "VEC3", 1, {2, 2, 2}).glb()).rig;
    EXPECT_EQ(rig.clips.at(0).duration_s, 0);
    EXPECT_EQ(rig.clips[0].start_s, 3);
    EXPECT_EQ(rig.channels[0].interpolation, model::Interpolation::step);
}

TEST(Clip, CubicSplinesKeepTheirTangentsAndHaveUnitRotations)
{
    std::vector<float> values(24, 0.25f);
    values[4 + 3] = 1.01f, values[4] = values[5] = values[6] = 0;
    values[16 + 3] = 0.99f, values[16] = values[17] = values[18] = 0;
    const model::Rig rig = load(moved("rotation", "CUBICSPLINE", {0, 1}, "VEC4", 6, values).glb()).rig;
    const float *kept = &rig.values[rig.channels.at(0).first_value];
    EXPECT_FLOAT_EQ(kept[7], 1);
    EXPECT_FLOAT_EQ(kept[19], 1);
    EXPECT_FLOAT_EQ(kept[0], 0.25f);
    EXPECT_FLOAT_EQ(kept[23], 0.25f);
}

TEST(Clip, NormalisedRotationsAreRead)
{
    Maker maker = moved("rotation", "LINEAR", {0}, "VEC4", 1, {0, 0, 0, 1});
    const int output = maker.accessor(i16, "VEC4", 1, std::vector<int16_t>{0, 32767, 0, 0});
    maker.json["accessors"][output]["normalized"] = true;
    maker.json["animations"][0]["samplers"][0]["output"] = output;
    const model::Rig rig = load(maker.glb()).rig;
    EXPECT_FLOAT_EQ(rig.values[rig.channels.at(0).first_value + 1], 1);
}

TEST(Clip, MorphWeightsNameTheirSet)
{
    Maker maker = moved("weights", "LINEAR", {0, 1}, "SCALAR", 4, {0, 1, 0.5f, 0.25f});
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT) << "there are no targets to weigh";
    maker.primitive()["targets"] = Json::array({{{"POSITION", 0}}, {{"POSITION", 0}}});
    const model::Rig rig = load(maker.glb()).rig;
    EXPECT_EQ(rig.channels.at(0).target, model::ChannelTarget::morph_weights);
    EXPECT_EQ(rig.channels[0].node, 0u);
    EXPECT_EQ(rig.channels[0].component_count, 2);
}

TEST(Clip, OfTwoKeysAtOneTimeTheFirstCounts)
{
    const model::Model model =
        load(moved("translation", "LINEAR", {0, 1, 1, 2}, "VEC3", 4, {0, 0, 0, 1, 1, 1, 9, 9, 9, 2, 2, 2}).glb());
    const model::Rig &rig = model.rig;
    ASSERT_EQ(rig.channels.at(0).key_count, 3u);
    EXPECT_EQ(rig.times[rig.channels[0].first_time + 2], 2);
    EXPECT_EQ(rig.values[rig.channels[0].first_value + 6], 2);
    EXPECT_EQ(model.warnings.size(), 1u);
}

TEST(Clip, TimesThatGoBackOrStartBeforeZeroAreRefused)
{
    const std::vector<float> values = {0, 0, 0, 1, 1, 1};
    EXPECT_EQ(outcome_of(moved("translation", "LINEAR", {1, 0.5f}, "VEC3", 2, values).glb()).status, CLQ_FORMAT);
    EXPECT_EQ(outcome_of(moved("translation", "LINEAR", {-1, 0}, "VEC3", 2, values).glb()).status, CLQ_FORMAT);
}

TEST(Clip, ChannelsOfAFileShareTimesAndValues)
{
    Maker maker = moved("translation", "LINEAR", {0, 1}, "VEC3", 2, {1, 2, 3, 4, 5, 6});
    Json animation = maker.json["animations"][0];
    animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}});
    maker.json["animations"] = std::vector<Json>(10, animation);
    const model::Rig rig = load(maker.glb()).rig;
    EXPECT_EQ(rig.channels.size(), 20u);
    EXPECT_EQ(rig.times.size(), 2u);
    EXPECT_EQ(rig.values.size(), 12u) << "once as translations, once as scales";
}

TEST(Clip, OfNodesOutsideTheSceneIsKeptWithoutThem)
{
    Maker maker = moved("translation", "LINEAR", {0, 1}, "VEC3", 2, {1, 2, 3, 4, 5, 6});
    maker.add("nodes", {{"name", "elsewhere"}});
    maker.json["animations"][0]["channels"][0]["target"]["node"] = 1;
    const model::Rig rig = load(maker.glb()).rig;
    EXPECT_EQ(rig.clips.size(), 1u);
    EXPECT_EQ(rig.channels.size(), 0u);
}

}  // namespace
}  // namespace claque::testing
