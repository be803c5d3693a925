// Rules of samples: every key is read, and what is wrong is refused by file, line and column.
#include "samples/labels/variation/rules.h"

#include <gtest/gtest.h>

#include "samples/scenes/check.h"

namespace
{

using labels::Rules;

Rules read(const std::string &text)
{
    return labels::read_rules(
        text, "r.toml",
        {"maps/", [](const std::string &, std::string &) { return std::string(); },
         [](const std::string &path) { return path == "maps/there.toml" ? "" : path + " could not be opened"; }});
}

std::string refusal(const std::string &text)
{
    try {
        read(text);
    } catch (const scenes::Failure &failure) {
        return failure.what();
    }
    return "";
}

TEST(Rules, HaveEveryKey)
{
    const Rules rules = read(R"(time_s = [1, 9]
[people]
count = [10, 20]
classes = { a = 0.5, b = [0, 1] }
colours = ["there.toml"]
[camera]
height_m = [1, 2]
distance_m = 4
heading_deg = [10, 20]
pitch_deg = [-30, -10]
fov_deg = [40, 60]
faces_m = 0.7
[light]
hour = [7, 8]
sun = 0.5
sky = [1, 2]
[haze]
visibility_m = 100
[sensor]
read_noise = 1
shot_noise = [0, 2]
jpeg_quality = [30, 40]
)");
    EXPECT_EQ(rules.time_s->first, 1);
    EXPECT_EQ(rules.time_s->last, 9);
    EXPECT_EQ(rules.count->last, 20);
    ASSERT_EQ(rules.classes.size(), 2u);
    EXPECT_EQ(rules.classes[0].second.last, 0.5);
    EXPECT_EQ(rules.colours, std::vector<std::string>{"maps/there.toml"});
    EXPECT_EQ(rules.files, rules.colours);
    EXPECT_EQ(rules.camera->height_m.first, 1);
    EXPECT_EQ(rules.camera->distance_m.first, 4);
    EXPECT_EQ(rules.camera->distance_m.last, 4);
    EXPECT_EQ(rules.camera->heading_deg.last, 20);
    EXPECT_EQ(rules.camera->pitch_deg->first, -30);
    EXPECT_EQ(rules.camera->fov_deg.last, 60);
    EXPECT_EQ(rules.camera->faces_m, 0.7);
    EXPECT_EQ(rules.hour->first, 7);
    EXPECT_EQ(rules.sun->last, 0.5);
    EXPECT_EQ(rules.sky->last, 2);
    EXPECT_EQ(rules.visibility_m->first, 100);
    EXPECT_EQ(rules.read_noise->last, 1);
    EXPECT_EQ(rules.shot_noise->last, 2);
    EXPECT_EQ(rules.jpeg_quality->first, 30);
    EXPECT_EQ(rules.places.at("light.hour"), "r.toml:14:8");
}

TEST(Rules, ThatAreAbsentLeaveTheSceneAsItIs)
{
    const Rules rules = read("");
    EXPECT_FALSE(rules.time_s || rules.count || rules.camera || rules.hour || rules.sun || rules.sky ||
                 rules.visibility_m || rules.read_noise || rules.shot_noise || rules.jpeg_quality);
    EXPECT_TRUE(read("[camera]\n").camera.has_value());
}

TEST(Rules, ThatAreWrongAreRefusedAtTheirPlace)
{
    const std::vector<std::pair<const char *, const char *>> wrong = {
        {"time_s = [3, 1]", "r.toml:1:10: the file of rules has 'time_s' = [3, 1], whose last is below its first"},
        {"[light]\nhour = 4", "r.toml:2:8: [light] has 'hour' = 4, which is not within 5.5 to 18.5"},
        {"[light]\nhour = [6, 7, 8]", "r.toml:2:8: [light] has 'hour' of 3 numbers; it needs one, or [first, last]"},
        {"[light]\nhour = []", "r.toml:2:8: [light] has 'hour' of 0 numbers"},
        {"[light]\nhour = nan", "r.toml:2:8: [light] has 'hour' = nan, which is not finite"},
        {"[light]\nhour = \"noon\"", "r.toml:2:8: [light] has 'hour' = a string instead of a number"},
        {"[lights]\nhour = 6", "the file of rules has an unknown key 'lights': 'light' is near"},
        {"[camera]\nfov = 6", "[camera] has an unknown key 'fov'"},
        {"[people]\ncolours = [\"gone.toml\"]",
         "r.toml:2:11: [people] names a file in 'colours' that cannot be read: maps/gone.toml could not be opened"},
        {"[people]\nclasses = { a = 2 }", "[people.classes] has 'a' = 2, which is not within 0 to 1"},
        {"[people]\ncount = [1.2, 1.8]", "r.toml:2:9: [people] has 'count' that is no whole number"},
        {"[sensor]\njpeg_quality = 40.5", "[sensor] has 'jpeg_quality' that is no whole number"},
        {"[sensor]\njpeg_quality = 0", "[sensor] has 'jpeg_quality' = 0, which is not within 1 to 100"},
        {"time_s = = 1", "r.toml:1:10: not TOML"},
        {"camera = 3", "has 'camera' that is not a table"},
    };
    for (const auto &[text, sentence] : wrong)
        EXPECT_NE(refusal(text).find(sentence), std::string::npos) << text << "\n" << refusal(text);
}

}  // namespace
