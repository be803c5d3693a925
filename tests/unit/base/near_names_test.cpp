// What is said of a name that is not there.
#include "lib/base/near_names.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "lib/base/near_files.h"

namespace claque::testing
{
namespace
{

using Names = std::vector<std::string_view>;

void expect_said(const char *wanted, const Names &names, const std::string &tail)
{
    EXPECT_EQ(base::names_near(wanted, names), tail) << wanted;
}

TEST(NearNames, AreThoseOfASlipOrAPartTheNearestFirst)
{
    const Names clips = {"Idle", "Walk_Back", "Walk", "Run", "Wave"};
    expect_said("Wlak", clips, ": 'Walk' and 'Walk_Back' are near");
    expect_said("walk", clips, ": 'Walk' and 'Walk_Back' are near");
    expect_said("Idel", clips, ": 'Idle' is near");
    const Names nodes = {"mixamorig:Hips", "mixamorig:Head", "mixamorig:HeadTop_End", "mixamorig:Neck", "Head", "Head"};
    expect_said("mixamorigHead", nodes, ": 'mixamorig:Head', 'mixamorig:HeadTop_End' and 'Head' are near");
    expect_said("head", nodes, ": 'Head', 'mixamorig:Head' and 'mixamorig:HeadTop_End' are near");
    expect_said("Character_Run_01", clips, ": 'Run' is near");
    expect_said("Walk", {"sit_talk", "walk_slow", "walk"}, ": 'walk' and 'walk_slow' are near");
}

TEST(NearNames, AreReplacedByAllWhereNoneIsNear)
{
    expect_said("zebra", {"stand", "walk"}, "; there are: stand, walk");
    expect_said("x", {"box", "y"}, "; there are: box, y");
    expect_said("zebra", {}, "; there are none");
    expect_said("", {"", "a"}, "; there are: a");
    const std::vector<std::string> many(30, "stand");
    EXPECT_NE(base::names_near("zebra", many).find(" and 6 more"), std::string::npos);
    EXPECT_EQ(base::near_names("zebra", many), "");
}

TEST(NearNames, OfAFileAreThoseBesideIt)
{
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "claque_near_files";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (const char *name : {"Soldier.glb", "Knight.glb", "Soldier.png", "e.glb"}) std::ofstream(folder / name) << name;
    EXPECT_EQ(base::near_files(folder / "Soldie.glb"), ": 'Soldier.glb' is near");
    EXPECT_EQ(base::near_files(folder / "walk.bvh"), "");
    EXPECT_EQ(base::near_files(folder / "none" / "Soldier.glb"), "");
    std::filesystem::remove_all(folder);
}

TEST(NearNames, OfAnyLengthAndNumberTakeLimitedTime)
{
    const std::string long_name(1 << 20, 'a');
    const std::vector<std::string> many(20000, std::string(100, 'b'));
    EXPECT_NE(base::names_near(long_name, many).find("more"), std::string::npos);
}

}  // namespace
}  // namespace claque::testing
