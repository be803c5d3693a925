// What a file says of its animations beside their keys: markers, and whose way is taken out.
#include <gtest/gtest.h>

#include "maker.h"

namespace claque::testing
{
namespace
{

// Two animations of one node, from 0.5 to 2 s and from 0 to 1 s.
Maker walker()
{
    Maker maker;
    maker.triangle();
    maker.json["nodes"][0]["name"] = "hips";
    const int places = maker.floats("VEC3", 2, {0, 1, 0, 0, 1, 2});
    for (const std::vector<float> &times : {std::vector<float>{0.5f, 2}, std::vector<float>{0, 1}}) {
        const int input = maker.floats("SCALAR", 2, times);
        maker.add("animations",
                  {{"samplers", Json::array({{{"input", input}, {"output", places}}})},
                   {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})}});
    }
    return maker;
}

Json &clip_extras(Maker &maker, int animation) { return maker.json["animations"][animation]["extras"]["claque"]; }

Json marker(const char *name, double time_s) { return {{"name", name}, {"time_s", time_s}}; }

model::Model load_all(const Maker &maker)
{
    const Bytes bytes = maker.glb();
    return asset::load_gltf(bytes.data(), bytes.size(), {});
}

TEST(ClipExtras, GiveMarkersInTheOrderOfClipsAndTimes)
{
    Maker maker = walker();
    clip_extras(maker, 0)["markers"] = Json::array({marker("right", 2), marker("left", 0.5), marker("middle", 1)});
    clip_extras(maker, 1)["markers"] = Json::array({marker("left", 0.25)});
    clip_extras(maker, 1)["a hint for others"] = true;
    const model::Rig rig = load_all(maker).rig;
    ASSERT_EQ(rig.markers.size(), 4u);
    const char *names[] = {"left", "middle", "right", "left"};
    const float times[] = {0.5f, 1, 2, 0.25f};
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_STREQ(rig.marker_names[i].c_str(), names[i]);
        EXPECT_EQ(rig.markers[i].time_s, times[i]);
        EXPECT_EQ(rig.markers[i].clip, i < 3 ? 0u : 1u);
    }
}

TEST(ClipExtras, NameTheNodeOfTheRootMotion)
{
    Maker maker = walker();
    EXPECT_TRUE(load_all(maker).root_motions.empty());
    clip_extras(maker, 1)["root_motion"] = "hips";
    const model::Model loaded = load_all(maker);
    ASSERT_EQ(loaded.root_motions.size(), 1u);
    EXPECT_EQ(loaded.root_motions[0].clip, 1u);
    EXPECT_EQ(loaded.root_motions[0].node, loaded.rig.find_node("hips"));
}

TEST(ClipExtras, OfOthersMayBeAnything)
{
    for (const Json &extras : {Json("text"), Json(7), Json::array({1}), Json({{"markers", 5}})}) {
        Maker maker = walker();
        maker.json["animations"][0]["extras"] = extras;
        EXPECT_EQ(outcome_of(maker.glb()).text, "") << extras;
    }
}

TEST(ClipExtras, ThatAreMalformedAreRefusedByTheirPlace)
{
    struct Case {
        Json claque;
        const char *place, *what;
    };
    const Case cases[] = {
        {7, "animations[0].extras.claque", ""},
        {{{"markers", "left"}}, "animations[0].extras.claque.markers", ""},
        {{{"markers", Json::array({5})}}, "animations[0].extras.claque.markers[0]", ""},
        {{{"markers", Json::array({{{"time_s", 1}}})}}, "animations[0].extras.claque.markers[0].name", ""},
        {{{"markers", Json::array({{{"name", "left"}}})}}, "animations[0].extras.claque.markers[0].time_s", ""},
        {{{"markers", Json::array({marker("", 1)})}}, "animations[0].extras.claque.markers[0].name", "empty"},
        {{{"markers", Json::array({marker("a", 1), marker("b", 2.1)})}},
         "animations[0].extras.claque.markers[1].time_s",
         "from 0.5 to 2 s"},
        {{{"markers", Json::array({marker("a", 0.4)})}}, "animations[0].extras.claque.markers[0].time_s", "0.4 s"},
        {{{"markers", Json::array({marker("a", 1e300)})}}, "animations[0].extras.claque.markers[0].time_s", ""},
        {{{"root_motion", 0}}, "animations[0].extras.claque.root_motion", ""},
        {{{"root_motion", "tail"}}, "animations[0].extras.claque.root_motion", "'tail'"},
    };
    for (const Case &c : cases) {
        Maker maker = walker();
        clip_extras(maker, 0) = c.claque;
        const Outcome outcome = outcome_of(maker.glb());
        EXPECT_EQ(outcome.status, CLQ_FORMAT) << c.claque;
        EXPECT_NE(outcome.text.find(c.place), std::string::npos) << outcome.text;
        EXPECT_NE(outcome.text.find(c.what), std::string::npos) << outcome.text;
    }
    Maker maker = walker();
    for (int i = 0; i < 4097; ++i) clip_extras(maker, 0)["markers"].push_back(marker("m", 1));
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_LIMIT);
}

}  // namespace
}  // namespace claque::testing
