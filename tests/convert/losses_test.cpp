// What is found in files that Assimp is known to read in part, or to misplace.
#include "samples/convert/losses.h"

#include <cstring>

#include <gtest/gtest.h>

namespace convert_test
{
namespace
{

std::string word(uint32_t number)
{
    std::string out;
    for (int k = 0; k < 4; ++k) out += static_cast<char>(number >> 8 * k & 255);
    return out;
}

std::string iqm(uint32_t joints, uint32_t clips)
{
    std::string out = "INTERQUAKEMODEL";
    out.resize(124, '\0');
    out.replace(68, 4, word(joints)), out.replace(84, 4, word(clips));
    return out;
}

// A property of a node in binary FBX: its name and three texts, then numbers of a type.
std::string binary(const std::string &name, const std::vector<double> &numbers, bool whole = false)
{
    std::string out = "P";
    for (const std::string &text : {name, std::string("type"), std::string(), std::string("A")})
        out += "S" + word(static_cast<uint32_t>(text.size())) + text;
    for (const double number : numbers) {
        char bytes[8];
        std::memcpy(bytes, &number, 8);
        out += whole ? "I" + word(static_cast<uint32_t>(number)) : "D" + std::string(bytes, 8);
    }
    return out;
}

std::string text(const std::string &name, const std::string &numbers)
{
    return "P: \"" + name + "\", \"" + name + "\", \"\", \"A\"," + numbers + "\n";
}

// The file of these properties, behind others that are templates.
std::vector<std::string> found(const std::string &templates, const std::string &properties, bool is_binary)
{
    return convert::losses_in(is_binary ? "Kaydara FBX Binary  " + templates + "\x07Objects" + properties
                                        : "; FBX 7.4.0\nFBXHeaderExtension:  {\n" + templates + "\nObjects:  {\n" +
                                              properties);
}

TEST(Losses, OfIqmAreItsSkeletonAndItsClips)
{
    const std::vector<std::string> all = convert::losses_in(iqm(54, 2));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NE(all[0].find("54 joints and its 2 clips are lost"), std::string::npos) << all[0];
    EXPECT_TRUE(convert::losses_in(iqm(0, 0)).empty());
    EXPECT_TRUE(convert::losses_in("INTERQUAKEMODEL").empty());
}

TEST(Losses, OfFbxAreGeometricTransforms)
{
    const std::string none = binary("GeometricTranslation", {0, 0, 0}) + binary("GeometricScaling", {1, 1, 0.9999999}),
                      moved = binary("GeometricTranslation", {0, -10, 0}),
                      sized = binary("GeometricScaling", {1, 2, 1});
    EXPECT_TRUE(found(moved, none, true).empty()) << "templates are no nodes";
    for (const std::string &one : {moved, sized, binary("GeometricRotation", {0, 0, 90})}) {
        const std::vector<std::string> all = found(none, none + one, true);
        ASSERT_EQ(all.size(), 1u);
        EXPECT_NE(all[0].find("geometric transforms (1)"), std::string::npos) << all[0];
    }
    EXPECT_EQ(found("", text("GeometricTranslation", "0,-10,0"), false).size(), 1u);
    EXPECT_TRUE(found("", text("GeometricTranslation", "0,0,0") + text("GeometricScaling", "1,1,1"), false).empty());
}

TEST(Losses, OfFbxAreScalesInheritedByAnotherRule)
{
    const std::string uneven = binary("Lcl Scaling", {1, 2, 1}), even = binary("Lcl Scaling", {100, 100.000001, 100});
    const auto rule = [](int number) { return binary("InheritType", {double(number)}, true); };
    const std::vector<std::string> all = found(rule(0), uneven + rule(0) + rule(0) + rule(1), true);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NE(all[0].find("2 nodes inherit scales by the rule RrSs"), std::string::npos) << all[0];
    EXPECT_TRUE(found("", even + rule(0), true).empty()) << "both rules then give one result";
    EXPECT_TRUE(found("", uneven + rule(1), true).empty());
    EXPECT_EQ(found("", even + rule(2), true).size(), 1u);
    EXPECT_EQ(found("", text("InheritType", "0") + text("Lcl Scaling", "1,2,1"), false).size(), 1u);
    EXPECT_TRUE(found("", text("InheritType", "0") + text("Lcl Scaling", "1,1,1"), false).empty());
}

TEST(Losses, OfBytesThatEndAnywhereAreNoneThatCrash)
{
    const std::string file = "Kaydara FBX Binary  \x07Objects" + binary("GeometricTranslation", {0, -10, 0}) +
                             binary("InheritType", {0}, true);
    for (size_t size = 0; size < file.size(); ++size) (void)convert::losses_in(file.substr(0, size));
    std::string wild = file;
    wild.replace(wild.find("type") - 4, 4, "\xff\xff\xff\xff");
    EXPECT_TRUE(convert::losses_in(wild).empty());
}

}  // namespace
}  // namespace convert_test
