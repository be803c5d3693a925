// Every reader of TOML files reads every input: colour maps, camera paths, scenarios, tolerances, joint maps,
// rules of samples, keypoints.
#include <cmath>

#include "lib/asset/colour_file.h"
#include "lib/base/error.h"
#include "samples/cli/joint_map.h"
#include "samples/labels/keypoints.h"
#include "samples/labels/variation/rules.h"
#include "samples/parity/tolerance.h"
#include "samples/scenes/camera_path.h"
#include "samples/scenes/check.h"
#include "samples/scenes/scenario/scenario.h"
#include "tests/fuzz/fuzzer.h"

namespace
{

// Written again, a map gives the same text.
void read_colours(const std::string &text)
{
    using namespace claque;
    try {
        asset::ColourFile file, again;
        asset::read_colours(text, "map.toml", file);
        const std::string written = asset::colours_text(file.def);
        asset::read_colours(written, "written.toml", again);
        EXPECT_EQ(asset::colours_text(again.def), written);
    } catch (const base::Error &error) {
        EXPECT_TRUE(error.status() == CLQ_FORMAT || error.status() == CLQ_LIMIT) << error.what();
        EXPECT_STRNE(error.what(), "");
    }
}

template <class Reader>
void read(const Reader &reader)
{
    try {
        reader();
    } catch (const scenes::Failure &error) {
        EXPECT_STRNE(error.what(), "");
    } catch (const parity::Unreadable &error) {
        EXPECT_STRNE(error.what(), "");
    }
}

void fly(const scenes::CameraPath &path)
{
    for (const double part : {-0.1, 0.0, 0.3, 0.99, 1.0, 2.0}) {
        const clq_camera camera = path.camera(path.start_s() + part * (path.end_s() - path.start_s()), 1.5);
        for (const double x : camera.eye) EXPECT_TRUE(std::isfinite(x));
    }
}

void sit(const scenes::Theatre &theatre)
{
    double seats = 0;
    for (size_t row = 0; row < theatre.rows.size(); ++row)
        for (const scenes::Wedge &wedge : scenes::wedges_of(theatre, row)) seats += wedge.last_deg - wedge.first_deg;
    EXPECT_TRUE(std::isfinite(seats));
    for (const scenes::Seat &seat : scenes::seats_of(theatre)) EXPECT_TRUE(std::isfinite(seat.x + seat.y + seat.z));
}

// Files that a scenario names are there, and its camera path is this text again.
void play(const std::string &text)
{
    const auto find = [](const std::string &) { return std::string(); };
    const auto again = [&](const std::string &, std::string &path) {
        path = text;
        return std::string();
    };
    const scenes::Scenario scenario = scenes::read_scenario(text, "scenario.toml", {"", again, find});
    EXPECT_FALSE(scenario.theatre && scenario.tracks);
    EXPECT_TRUE(scenario.theatre || scenario.tracks || scenario.stage);
    if (scenario.stage) {
        EXPECT_FALSE(scenario.stage->agents.empty());
        EXPECT_GT(scenario.stage->tick_s, 0);
    }
    EXPECT_FALSE(scenario.name.empty());
    if (scenario.theatre) sit(*scenario.theatre);
    if (scenario.path) fly(*scenario.path);
    for (const scenes::SocialClass &one : scenario.characters) EXPECT_TRUE(std::isfinite(one.share));
}

// Every span has a beginning and an end.
void choose(const std::string &text)
{
    const auto find = [](const std::string &) { return std::string(); };
    const auto none = [](const std::string &, std::string &) { return std::string(); };
    const labels::Rules rules = labels::read_rules(text, "rules.toml", {"", none, find});
    const auto expect_span = [](const labels::Span &span) {
        EXPECT_TRUE(std::isfinite(span.first) && std::isfinite(span.last) && span.first <= span.last);
    };
    for (const auto &span : {rules.time_s, rules.count, rules.hour, rules.sun, rules.sky, rules.visibility_m,
                             rules.read_noise, rules.shot_noise, rules.jpeg_quality})
        if (span) expect_span(*span);
    for (const auto &[name, share] : rules.classes) expect_span(share);
    if (rules.camera)
        for (const labels::Span &span : {rules.camera->height_m, rules.camera->distance_m, rules.camera->fov_deg})
            expect_span(span);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const std::string text(reinterpret_cast<const char *>(bytes), size);
    read_colours(text);
    read([&] { fly(scenes::CameraPath(text, "path.toml")); });
    read([&] { play(text); });
    read([&] { parity::tolerance_from(text, "tolerance.toml"); });
    read([&] { choose(text); });
    read([&] { EXPECT_FALSE(labels::read_keypoints(text, "keypoints.toml").names.empty()); });
    read([&] { cli::read_joint_map(text, "map.toml"); });
    return 0;
}
