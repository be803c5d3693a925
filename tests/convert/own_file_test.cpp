// A character written here, so that the law runs without the collection of old files.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/cli/run.h"
#include "tests/convert/old_files.h"

namespace convert_test
{
namespace
{

// A bar of two joints; the upper one bends. One vertex lies off its axis, and goes by its weights. Assimp needs the
// empty lines.
constexpr const char *mesh = R"(MD5Version 10
commandline ""
numJoints 2
numMeshes 1

joints {
	"lower" -1 ( 0 0 0 ) ( 0 0 0 )
	"upper" 0 ( 0 0 4 ) ( 0 0 0 )
}

mesh {
	shader "bar"

	numverts 6
	vert 0 ( 0 0 ) 0 1
	vert 1 ( 1 0 ) 1 1
	vert 2 ( 0 0.5 ) 2 2
	vert 3 ( 1 0.5 ) 4 2
	vert 4 ( 0 1 ) 6 1
	vert 5 ( 1 1 ) 7 1

	numtris 4
	tri 0 0 1 2
	tri 1 1 3 2
	tri 2 2 3 4
	tri 3 3 5 4

	numweights 8
	weight 0 0 1 ( -1 0 0 )
	weight 1 0 1 ( 1 0 0 )
	weight 2 0 0.5 ( -1 0 4 )
	weight 3 1 0.5 ( -1 0 0 )
	weight 4 0 0.25 ( 1 0.5 4 )
	weight 5 1 0.75 ( 1 0.5 0 )
	weight 6 1 1 ( -1 0 4 )
	weight 7 1 1 ( 1 0 4 )
}
)";

constexpr const char *clip = R"(MD5Version 10
commandline ""
numFrames 3
numJoints 2
frameRate 10
numAnimatedComponents 1

hierarchy {
	"lower" -1 0 0
	"upper" 0 8 0
}

bounds {
	( -5 -5 0 ) ( 5 5 8 )
	( -5 -5 0 ) ( 5 5 8 )
	( -5 -5 0 ) ( 5 5 8 )
}

baseframe {
	( 0 0 0 ) ( 0 0 0 )
	( 0 0 4 ) ( 0 0 0 )
}

frame 0 {
	0
}

frame 1 {
	0.5
}

frame 2 {
	0.25
}
)";

struct OwnFile : cli_test::Command {
    std::string write(const char *animation)
    {
        std::ofstream(path("bar.md5mesh")) << mesh;
        if (animation) std::ofstream(path("bar.md5anim")) << animation;
        return path("bar.md5mesh");
    }
};

TEST_F(OwnFile, MovesAsItDoesInAssimpsScene)
{
    Both both(write(clip));
    EXPECT_EQ(both.info().clip_count, 1u);
    EXPECT_EQ(both.info().max_influences, 2u);
    EXPECT_EQ(both.info().triangle_count, 4u);
    EXPECT_EQ(expect_same_poses(both, "bar.md5mesh"), 6u);
}

TEST_F(OwnFile, StandsUprightAndBendsByTheAnglesOfItsFile)
{
    const auto context = new_context();
    const auto asset = read_glb(context.get(), convert::convert_file(write(clip), {}, {}).glb);
    clq_asset_info info = clq_asset_info_init();
    scenes::check(clq_asset_get_info(asset.get(), &info));
    EXPECT_NEAR(info.box_min[1], 0, 1e-5f);
    EXPECT_NEAR(info.box_max[1], 8, 1e-5f) << "z of MD5 is up";
    std::vector<float> xyz(3 * size_t(info.vertex_count));
    clq_clip_info middle = clq_clip_info_init();
    scenes::check(clq_asset_get_clip(asset.get(), 0, &middle));
    const float time_s = middle.start_s + middle.duration_s / 2;  // the second of three frames
    scenes::check(clq_asset_get_positions(asset.get(), 0, time_s, xyz.data(), xyz.size()));
    // The quaternion's x is 0.5: 60 degrees about x. The tip stands 4 cos 60 above the upper joint, at a height of 4.
    float top = 0;
    for (size_t i = 1; i < xyz.size(); i += 3) top = std::max(top, xyz[i]);
    EXPECT_NEAR(top, 6, 1e-4f);
}

TEST_F(OwnFile, IsConvertedByTheCommandAsAWhole)
{
    const std::string file = write(clip), out = path("bar.glb");
    const cli_test::Outcome done = cli_test::claque({"convert", file, "--out", out, "--height", "2"});
    EXPECT_EQ(done.code, 0) << done.err;
    const cli_test::Outcome seen = cli_test::claque({"inspect", "--json", out});
    EXPECT_EQ(seen.code, 0) << seen.err;
    EXPECT_NE(seen.out.find("\"triangles\": 4"), std::string::npos) << seen.out;
}

}  // namespace
}  // namespace convert_test
