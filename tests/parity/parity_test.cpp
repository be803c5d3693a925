// The GPU peer against the CPU path: vertices within 1e-4 of a character's size, colours within 2 of 255 on 99.9 % of
// the pixels that show a person.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <gtest/gtest.h>

#include "samples/parity/verdict.h"
#include "samples/parity/write/write.h"
#include "tests/gl/support/absent.h"
#include "tests/parity/result_out.h"
#include "tests/support/written_characters.h"

namespace parity_test
{
namespace
{

namespace fs = std::filesystem;

constexpr double pixels_per_degree = 67;  // of FLIP

class Parity : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        if (!contexts::make_offscreen(contexts::Kind::any, 16, 16, contexts::PixelFormat::rgba8888, why_not))
            END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
        folder_ = fs::temp_directory_path() / ("claque-parity-" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path(const char *name) const { return (folder_ / name).string(); }

    // Exports, captures, and has the peer draw it.
    void run(const scenes::SceneOptions &options, double time_s, const PeerOptions &peer_options = {})
    {
        const parity::CaptureTime capture_time = {options.scene, time_s, options.width, options.height};
        {
            scenes::SceneRenderer scene_renderer(library_, options);
            parity::write_scene(scene_renderer, capture_time, path("scene"));
            parity::write_result(scene_renderer, capture_time, path("reference"));
        }
        const SceneIn scene = read_scene(path("scene"));
        std::string why_not;
        const auto context = contexts::make_offscreen(contexts::Kind::any, scene.width, scene.height,
                                                      contexts::PixelFormat::rgba8888, why_not);
        Peer peer(*context, scene, peer_options);
        write_result(*context, peer, scene, path("scene"), path("result"));
    }

    parity::Verdict verdict() const
    {
        const parity::Capture reference = parity::read_capture(path("reference")),
                              result = parity::read_capture(path("result"));
        for (const parity::Capture *capture : {&reference, &result})
            EXPECT_TRUE(capture->positions && capture->normals && capture->colour && capture->depth && capture->actor &&
                        capture->zone)
                << capture->folder << " lacks arrays";
        return parity::verdict_of(parity::compare(reference, result, pixels_per_degree), parity::tolerance_of("gpu"));
    }

    // Of the pixels that show a person in either picture, how many are further apart than 2: the whole picture's share
    // would be kept by a crowd that covers little of it.
    double share_over_2()
    {
        const parity::Capture a = parity::read_capture(path("reference")), b = parity::read_capture(path("result"));
        size_t covered = 0, over = 0;
        for (size_t i = 0; i < a.actor->values.size(); ++i) {
            if (a.actor->values[i] == 0 && b.actor->values[i] == 0) continue;
            int apart = 0;
            for (size_t k = 3 * i; k < 3 * i + 3; ++k)
                apart = std::max(apart, std::abs(a.colour->rgb[k] - b.colour->rgb[k]));
            ++covered;
            over += apart > 2;
        }
        EXPECT_GT(covered, 100u);
        return static_cast<double>(over) / static_cast<double>(covered);
    }

    // Of the pixels that show a person in both, how many have another colour even if they were equally bright.
    double share_of_other_hues()
    {
        const parity::Capture a = parity::read_capture(path("reference")), b = parity::read_capture(path("result"));
        size_t shown = 0, other = 0;
        for (size_t i = 0; i < a.actor->values.size(); ++i) {
            if (a.actor->values[i] == 0 || b.actor->values[i] == 0) continue;
            double product = 0, square_a = 0, square_b = 0;
            for (size_t k = 3 * i; k < 3 * i + 3; ++k) {
                product += double(a.colour->rgb[k]) * b.colour->rgb[k];
                square_a += double(a.colour->rgb[k]) * a.colour->rgb[k];
                square_b += double(b.colour->rgb[k]) * b.colour->rgb[k];
            }
            ++shown;
            other += product < 0.99 * std::sqrt(square_a * square_b);  // as vectors, 8 degrees apart
        }
        EXPECT_GT(shown, 100u);
        return static_cast<double>(other) / static_cast<double>(shown);
    }

    void hold(const scenes::SceneOptions &options, double time_s, const PeerOptions &peer_options = {})
    {
        run(options, time_s, peer_options);
        const parity::Verdict found = verdict();
        EXPECT_TRUE(found.pass) << parity::reasons(found, 10);
        ASSERT_NE(found.find("positions.max_relative"), nullptr);
        EXPECT_LE(found.find("positions.max_relative")->value, 1e-4);
        EXPECT_LE(share_over_2(), 0.001);
    }

    scenes::SceneOptions options_of(const char *scene, uint32_t count) const
    {
        scenes::SceneOptions options;
        options.scene = scene;
        options.crowd_options.count = count;
        options.width = 320, options.height = 240;
        options.flat_triangles = 0;  // the peer lights smoothly
        return options;
    }

    fs::path folder_;
    scenes::Library library_{2};
};

TEST_F(Parity, HoldsInTheOdeon) { hold(options_of("odeon", 0), 2); }

TEST_F(Parity, HoldsInTheOdeonFromNear)
{
    scenes::SceneOptions options = options_of("odeon", 0);
    options.shot = scenes::Shot::close;
    options.crowd_options.lod = scenes::Lod::on;
    hold(options, 5);
}

TEST_F(Parity, HoldsForTenThousand) { hold(options_of("ten_thousand", 10000), 2); }

// As the library draws by default, in a larger picture. The peer lights smoothly, and each triangle of a flat level has
// one brightness: colours differ in that alone.
TEST_F(Parity, HoldsForTenThousandInFlatLevelsButForTheirBrightness)
{
    scenes::SceneOptions options = options_of("ten_thousand", 10000);
    options.flat_triangles = scenes::SceneOptions().flat_triangles;
    options.width = 480, options.height = 360;
    run(options, 2);
    for (const parity::Check &check : verdict().checks)
        EXPECT_TRUE(check.kept || check.measure.rfind("colour.", 0) == 0) << check.measure << " is " << check.value;
    EXPECT_GT(share_over_2(), 0.5) << "no flat level was drawn";
    EXPECT_LE(share_of_other_hues(), 0.001);
}

TEST_F(Parity, HoldsInHazeForRigidParts) { hold(options_of("town_sky", 300), 3); }

TEST_F(Parity, HoldsForActorsThatBehave) { hold(options_of("hundred_actors", 100), 3); }

// Dirty triangles are drawn once for each of their zones, so a zone that the scene does not name would be a gap.
// The coarse levels of the odeon's people have hardly any, so all are at their finest.
TEST_F(Parity, HoldsZoneByZone) { hold(options_of("odeon", 0), 2, {Limiting::zones}); }

TEST_F(Parity, FailsWhereLightIsLimitedAtPixels)
{
    run(options_of("odeon", 0), 2, {Limiting::pixels});
    const parity::Verdict found = verdict();
    EXPECT_FALSE(found.pass);
    EXPECT_NE(parity::reasons(found, 10).find("colour.over_2"), std::string::npos) << parity::reasons(found, 10);
    EXPECT_TRUE(found.find("zone_ids.at_borders")->kept);
}

// What is compared would show a crowd one tick late.
TEST_F(Parity, FailsOneTickLater)
{
    const scenes::SceneOptions options = options_of("plaza", 30);
    run(options, 2);
    scenes::SceneRenderer scene_renderer(library_, options);
    parity::write_result(scene_renderer, {options.scene, 2, options.width, options.height}, path("reference"));
    EXPECT_TRUE(verdict().pass);
    parity::write_result(scene_renderer, {options.scene, 2.04, options.width, options.height}, path("later"));
    fs::copy_file(path("later") + "/positions.npy", path("reference") + "/positions.npy",
                  fs::copy_options::overwrite_existing);
    fs::copy_file(path("later") + "/colour.npy", path("reference") + "/colour.npy",
                  fs::copy_options::overwrite_existing);
    const parity::Verdict late = verdict();
    EXPECT_GT(late.find("positions.max_relative")->value, 1e-3);
    EXPECT_GT(share_over_2(), 0.01);
}

class HumanoidParity : public Parity, public testing::WithParamInterface<std::string>
{
};

std::vector<std::string> humanoids()
{
    std::vector<std::string> files;
    const fs::path assets = CLAQUE_ASSETS_DIR;
    for (const char *kind : {"humanoids", "hipoly"})
        if (fs::is_directory(assets / kind))
            for (const fs::directory_entry &entry : fs::recursive_directory_iterator(assets / kind))
                if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
                    files.push_back(fs::relative(entry.path(), assets).generic_string());
    std::sort(files.begin(), files.end());
    if (files.empty()) files.push_back("");
    return files;
}

TEST_P(HumanoidParity, Holds)
{
    if (GetParam().empty()) GTEST_SKIP() << "no characters in " CLAQUE_ASSETS_DIR;
    const std::string file = written::path_of(GetParam(), CLAQUE_ASSETS_DIR);
    clq_asset *asset = nullptr;
    ASSERT_EQ(clq_asset_load_file(library_.context(), file.c_str(), nullptr, &asset), CLQ_OK) << clq_last_error();
    const scenes::Own<clq_asset> held_asset(asset);
    clq_template *tmpl = nullptr;
    ASSERT_EQ(clq_asset_build(library_.context(), asset, 0, &tmpl), CLQ_OK) << clq_last_error();
    const scenes::Own<clq_template> held(tmpl);
    scenes::SceneOptions options = options_of("parade", 3);
    options.character.tmpl = tmpl;
    options.width = 240, options.height = 180;
    hold(options, 1);
}

std::string name_of(const testing::TestParamInfo<std::string> &info)
{
    std::string name = info.param.empty() ? "none" : info.param;
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Files, HumanoidParity, testing::ValuesIn(humanoids()), name_of);
INSTANTIATE_TEST_SUITE_P(Written, HumanoidParity, testing::ValuesIn(written::characters()), name_of);

}  // namespace
}  // namespace parity_test
