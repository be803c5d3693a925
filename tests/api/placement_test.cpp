// Facing and size of files: a file that is turned and scaled by options is the file with a node above its roots that
// does the same.
#include <claque/play.h>
#include <claque/prepare.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/api/loaded_asset.h"
#include "tests/support/gltf_maker.h"
#include "tests/support/walking_figure.h"
#include "tests/support/written_characters.h"

namespace
{

using namespace claque::testing;
using loaded::Own;

Bytes bytes_of(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A GLB with a node above the roots of its scene.
Bytes with_root(const Bytes &glb, float turn_deg, float scale)
{
    Maker maker;
    const auto word = [&](size_t at) {
        uint32_t value = 0;
        std::memcpy(&value, glb.data() + at, sizeof value);
        return size_t(value);
    };
    const size_t json_size = word(12);
    maker.json = Json::parse(glb.begin() + 20, glb.begin() + 20 + static_cast<std::ptrdiff_t>(json_size));
    maker.binary.assign(glb.begin() + 28 + static_cast<std::ptrdiff_t>(json_size), glb.end());
    Json &roots = maker.json["scenes"][0]["nodes"];
    const int root = maker.add("nodes", {{"name", "written root"},
                                         {"children", roots},
                                         {"rotation", turn({0, 1, 0}, turn_deg)},
                                         {"scale", {scale, scale, scale}}});
    roots = Json::array({root});
    return maker.glb();
}

class Placement : public loaded::Loading
{
protected:
    static clq_asset_options options_of(double turn_deg, double scale)
    {
        clq_asset_options options = clq_asset_options_init();
        options.turn_deg = turn_deg, options.scale = scale;
        return options;
    }
    static void expect_alike(const std::vector<float> &a, const std::vector<float> &b, double size)
    {
        ASSERT_EQ(a.size(), b.size());
        double worst = 0;
        for (size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::fabs(double(a[i]) - double(b[i])));
        EXPECT_LE(worst, 4e-6 * size);
    }
    static void expect_alike(const clq_asset *a, const clq_asset *b, double size)
    {
        expect_alike(positions(a, CLQ_NONE, 0), positions(b, CLQ_NONE, 0), size);
        for (uint32_t clip = 0; clip < info_of(a).clip_count; ++clip)
            for (const float time_s : {0.0f, 0.3f, 0.55f, 1.4f}) {
                SCOPED_TRACE("clip " + std::to_string(clip) + " at " + std::to_string(time_s));
                expect_alike(positions(a, clip, time_s), positions(b, clip, time_s), size);
            }
    }
    // Turned about y and scaled, in double precision.
    static std::vector<float> placed(const std::vector<float> &xyz, double turn_deg, double scale)
    {
        std::vector<float> out;
        const double c = std::cos(turn_deg * M_PI / 180) * scale, s = std::sin(turn_deg * M_PI / 180) * scale;
        for (size_t i = 0; i < xyz.size(); i += 3) {
            const double x = double(xyz[i]), y = double(xyz[i + 1]), z = double(xyz[i + 2]);
            for (const double value : {c * x + s * z, scale * y, c * z - s * x})
                out.push_back(static_cast<float>(value));
        }
        return out;
    }
};

TEST_F(Placement, ByOptionsIsThatOfANodeWrittenAboveTheRoots)
{
    for (const char *name : {"WrittenPerson.glb", "WrittenRigid.glb", "WrittenSkins.glb", "WrittenQuantised.glb"}) {
        SCOPED_TRACE(name);
        const Bytes glb = bytes_of(written::path_of(name, ""));
        for (const auto &[turn_deg, scale] : {std::pair(180.0f, 1.0f), {37.0f, 0.6f}, {-450.0f, 3.0f}, {0.0f, 0.01f}}) {
            SCOPED_TRACE(turn_deg);
            const Own<clq_asset> by_option = load(glb, options_of(double(turn_deg), double(scale)));
            ASSERT_TRUE(by_option) << said_;
            const Own<clq_asset> by_file = load(with_root(glb, turn_deg, scale));
            ASSERT_TRUE(by_file) << said_;
            expect_alike(by_option.get(), by_file.get(), 4 * double(scale));
            EXPECT_EQ(info_of(by_option.get()).node_count, info_of(by_file.get()).node_count);
        }
    }
}

TEST_F(Placement, OfMorphsAndOfClipsIsThatOfTheirPositions)
{
    for (const std::string &name : written::characters()) {
        SCOPED_TRACE(name);
        const std::string path = written::path_of(name, "");
        const Own<clq_asset> plain = load_file(path), turned = load_file(path, options_of(100, 2));
        for (uint32_t clip = 0; clip <= info_of(plain.get()).clip_count; ++clip) {
            const uint32_t which = clip < info_of(plain.get()).clip_count ? clip : CLQ_NONE;
            expect_alike(positions(turned.get(), which, 0.4f), placed(positions(plain.get(), which, 0.4f), 100, 2), 20);
        }
    }
}

TEST_F(Placement, OfWhatAHostBuildsMovesSpheresAndRootMotionToo)
{
    Maker maker;
    maker.triangle();
    maker.json["nodes"][0]["name"] = "goer";
    ClipMaker go(maker, "go");
    go.add(0, "translation", "LINEAR", {0, 1}, {0, 0, 0, 0, 0, 2});
    go.finish();
    maker.json["animations"][0]["extras"] = {{"claque", {{"root_motion", "goer"}}}};
    const auto way = [&](const clq_asset_options &options) {
        const Own<clq_asset> asset = load(maker.glb(), options);
        const Own<clq_template> tmpl = build(asset.get());
        double moved[3] = {0, 0, 0};
        EXPECT_EQ(clq_template_get_root_motion(tmpl.get(), 0, 0, 0.999, moved), CLQ_OK) << clq_last_error();
        return std::pair(moved[0] / 0.999, moved[1] / 0.999);
    };
    const auto [x, z] = way(options_of(0, 0));
    EXPECT_NEAR(x, 0, 1e-5);
    EXPECT_NEAR(z, 2, 1e-5);
    const auto [turned_x, turned_z] = way(options_of(90, 3));
    EXPECT_NEAR(turned_x, 6, 1e-5);
    EXPECT_NEAR(turned_z, 0, 1e-5);
}

TEST_F(Placement, GivesTheHeightOfTheRestPoseOrMultipliesIt)
{
    for (const std::string &name : written::characters()) {
        SCOPED_TRACE(name);
        const std::string path = written::path_of(name, "");
        clq_asset_options tall = clq_asset_options_init();
        tall.height_m = 1.83;
        EXPECT_NEAR(height_of(load_file(path, tall).get()), 1.83, 1e-5);
        const Own<clq_asset> plain = load_file(path), doubled = load_file(path, options_of(0, 2));
        EXPECT_NEAR(height_of(doubled.get()), 2 * height_of(plain.get()), 1e-5 * height_of(doubled.get()));
    }
}

TEST_F(Placement, ThatCannotBeIsRefusedWithTheRemedy)
{
    const Bytes figure = walking_figure();
    const auto said = [&](double turn_deg, double height_m, double scale) {
        clq_asset_options options = options_of(turn_deg, scale);
        options.height_m = height_m;
        EXPECT_FALSE(load(figure, options));
        return said_;
    };
    EXPECT_NE(said(NAN, 0, 0).find("turn_deg is nan: any finite angle is wanted"), std::string::npos) << said_;
    EXPECT_NE(said(HUGE_VAL, 0, 0).find("turn_deg is inf: any finite angle is wanted"), std::string::npos) << said_;
    EXPECT_NE(said(0, -1, 0).find("height_m is -1: more than 0 is wanted"), std::string::npos) << said_;
    EXPECT_NE(said(0, HUGE_VAL, 0).find("height_m is inf: more than 0"), std::string::npos) << said_;
    EXPECT_NE(said(0, NAN, 0).find("height_m is nan: more than 0"), std::string::npos) << said_;
    EXPECT_NE(said(0, 1e9, 0).find("height_m (--height) is 1e+09, "), std::string::npos) << said_;
    EXPECT_NE(said(0, 0, -2).find("scale is -2: 1e-06 to 1e+06 is wanted"), std::string::npos) << said_;
    EXPECT_NE(said(0, 0, NAN).find("scale is nan: "), std::string::npos) << said_;
    for (const double scale : {1 / 1e6, 1e6}) EXPECT_TRUE(load(figure, options_of(0, scale))) << said_;
    for (const double beyond : {std::nextafter(1 / 1e6, 0.0), std::nextafter(1e6, 1e9)})
        EXPECT_NE(said(0, 0, beyond).find(": 1e-06 to 1e+06 is wanted"), std::string::npos) << said_;
    EXPECT_NE(said(0, 1.8, 2).find("height_m is 1.8 and scale is 2: each gives the size"), std::string::npos) << said_;
    clq_asset_options tall = clq_asset_options_init();
    tall.height_m = 2;
    EXPECT_FALSE(load(bytes_of(written::path_of("WrittenClips.glb", "")), tall));
    EXPECT_NE(said_.find("has no height: scale (--scale) multiplies its size"), std::string::npos) << said_;
}

TEST_F(Placement, OfVrm0IsTurnedByItsSpecificationAndOfVrm1IsNot)
{
    const auto vrm = [](const char *extension) {
        Maker maker;
        maker.triangle();
        maker.json["extensionsUsed"] = {extension};
        maker.json["extensions"][extension] = {{"specVersion", "0.0"}};
        return maker.glb();
    };
    const std::vector<float> plain = positions(load(vrm("VRMC_vrm")).get(), CLQ_NONE, 0);
    EXPECT_EQ(plain, (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    expect_alike(positions(load(vrm("VRM")).get(), CLQ_NONE, 0), placed(plain, 180, 1), 1);
    expect_alike(positions(load(vrm("VRM"), options_of(180, 0)).get(), CLQ_NONE, 0), plain, 1);
}

// The table of bones names the same joints after the turn.
TEST_F(Placement, OfVrm0TakesClipsAsThatOfVrm1Does)
{
    static const char *const bones[] = {"hips",          "leftUpperLeg", "leftLowerLeg", "leftFoot", "rightUpperLeg",
                                        "rightLowerLeg", "rightFoot",    "spine",        "neck",     "head"};
    const auto vrm = [&](const char *extension, bool moves) {
        Maker maker;
        maker.triangle();
        const int mesh = int(maker.json["meshes"].size()) - 1;
        const size_t first = maker.json["nodes"].size();
        Json listed = Json::object(), list = Json::array();
        for (size_t i = 0; i < std::size(bones); ++i) {  // each hangs on the one before
            Json node = {{"name", moves ? "clip" : "joint"}, {"translation", {0, 0.2f, 0}}, {"mesh", mesh}};
            if (i + 1 < std::size(bones)) node["children"] = {first + i + 1};
            maker.add("nodes", node);
            listed[bones[i]] = {{"node", first + i}};
            list.push_back({{"bone", bones[i]}, {"node", first + i}});
        }
        maker.json["scenes"] = Json::array({{{"nodes", {first}}}});
        maker.json["extensionsUsed"] = {extension};
        maker.json["extensions"][extension]["humanoid"]["humanBones"] = std::string(extension) == "VRM" ? list : listed;
        if (moves) {
            ClipMaker clip(maker, "kick");
            clip.add(int(first) + 3, "rotation", "LINEAR", times_from(0, 0.5f, 2), turns({1, 0, 0}, {0, -60}));
            clip.finish();
        }
        return maker.glb();
    };
    const Own<clq_asset> clips = load(vrm("VRMC_vrm", true));
    const auto kicked = [&](const char *extension) {
        const Own<clq_asset> asset = load(vrm(extension, false));
        EXPECT_EQ(clq_asset_add_clips(context_.get(), asset.get(), clips.get(), nullptr, nullptr), CLQ_OK)
            << clq_last_error();
        return positions(asset.get(), 0, 0.5f);
    };
    const std::vector<float> plain = kicked("VRMC_vrm");
    EXPECT_GT(*std::max_element(plain.begin(), plain.end()), 1.2f);
    expect_alike(kicked("VRM"), placed(plain, 180, 1), 2);
}

TEST_F(Placement, OfTheCollectedVrm0ShowsItsFace)
{
    const std::string path = CLAQUE_ASSETS_DIR "/../cases/characters/vrm0_faces_minus_z.vrm";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const Own<clq_asset> shown = load_file(path), as_it_is = load_file(path, options_of(180, 0));
    expect_alike(positions(shown.get(), CLQ_NONE, 0), placed(positions(as_it_is.get(), CLQ_NONE, 0), 180, 1), 2);
    EXPECT_NE(positions(shown.get(), CLQ_NONE, 0), positions(as_it_is.get(), CLQ_NONE, 0));
}

// Clips that are added turn and grow with the character, whatever faces where.
TEST_F(Placement, OfACharacterIsThatOfItsAddedClips)
{
    const std::string person = written::path_of("WrittenPerson.glb", ""),
                      clips = written::path_of("WrittenClips.glb", "");
    for (const clq_retarget_mode mode : {CLQ_RETARGET_AUTOMATIC, CLQ_RETARGET_CHANNELS, CLQ_RETARGET_MOTION}) {
        SCOPED_TRACE(mode);
        clq_clips_def def = clq_clips_def_init();
        def.mode = mode;
        const auto with_clips = [&](const clq_asset_options &options, const clq_asset_options &of_clips) {
            Own<clq_asset> asset = load_file(person, options);
            const Own<clq_asset> source = load_file(clips, of_clips);
            clq_clips_report report = clq_clips_report_init();
            EXPECT_EQ(clq_asset_add_clips(context_.get(), asset.get(), source.get(), &def, &report), CLQ_OK)
                << clq_last_error();
            EXPECT_EQ(report.mode, mode == CLQ_RETARGET_AUTOMATIC ? CLQ_RETARGET_CHANNELS : mode);
            return asset;
        };
        const Own<clq_asset> plain = with_clips(options_of(0, 0), options_of(0, 0)),
                             turned = with_clips(options_of(180, 1.5), options_of(0, 0)),
                             both = with_clips(options_of(180, 1.5), options_of(70, 0.1));
        for (uint32_t clip = 0; clip < info_of(plain.get()).clip_count; ++clip) {
            const std::vector<float> wanted = placed(positions(plain.get(), clip, 0.35f), 180, 1.5);
            expect_alike(positions(turned.get(), clip, 0.35f), wanted, 4);
            expect_alike(positions(both.get(), clip, 0.35f), wanted, 4);
        }
    }
}

TEST_F(Placement, MakesAnotherPreparedTemplate)
{
    namespace fs = std::filesystem;
    const std::string folder = ::testing::TempDir() + "claque_placement",
                      path = written::path_of("WrittenRigid.glb", "");
    fs::remove_all(folder);
    const auto stored = [&](const clq_asset_options &options) {
        clq_prepare_def def = clq_prepare_def_init();
        def.path = path.c_str(), def.options = &options, def.folder = folder.c_str();
        clq_prepare_report report = clq_prepare_report_init();
        clq_template *made = nullptr;
        EXPECT_EQ(clq_template_prepare(context_.get(), &def, &made, &report), CLQ_OK) << clq_last_error();
        clq_template_destroy(made);
        return report.stored;
    };
    clq_asset_options tall = clq_asset_options_init();
    tall.height_m = 2;
    for (const clq_asset_options &options : {options_of(0, 0), options_of(180, 0), options_of(0, 2), tall}) {
        EXPECT_TRUE(stored(options));
        EXPECT_FALSE(stored(options)) << "it is there";
    }
    fs::remove_all(folder);
}

}  // namespace
