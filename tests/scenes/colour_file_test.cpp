// A colour file that changes while a scene uses it: a valid one is applied, an invalid one changes nothing and is
// reported once.
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <gtest/gtest.h>

#include "samples/scenes/colours.h"

namespace
{

using namespace scenes;

std::string people(const std::string &tunic)
{
    return "[[classes]]\nname = \"people\"\ntemplate = \"citizen\"\n[classes.zones]\ntunic = { " + tunic + " }\n";
}

const std::string red = people("colour = \"#c01010\""),
                  blue = people("hue = [220, 230], saturation = [0.8, 1], brightness = [0.5, 1]");

class SceneColours : public testing::Test
{
protected:
    SceneColours() : library_(1), path_(testing::TempDir() + "colours" + std::to_string(getpid()) + ".toml")
    {
        CrowdOptions crowd_options;
        crowd_options.count = 12;
        scene_ = make_scene("plaza", library_, crowd_options, {});
        before_ = tunics();
    }
    ~SceneColours() override { std::filesystem::remove(path_); }

    void write(const std::string &text) const { std::ofstream(path_, std::ios::binary) << text; }
    std::vector<float> tunics() const
    {
        std::vector<float> all;
        for (const clq_actor actor : scene_->actors()) {
            clq_actor_info info = clq_actor_info_init();
            clq_template_info tmpl = clq_template_info_init();
            check(clq_actor_get_info(scene_->crowd(), actor, &info));
            check(clq_template_get_info(info.tmpl, &tmpl));
            std::vector<float> rgb(3 * static_cast<size_t>(tmpl.zone_count));
            check(clq_actor_get_colours(scene_->crowd(), actor, rgb.data(), tmpl.zone_count));
            const size_t zone = clq_template_find_zone(info.tmpl, "tunic");
            all.insert(all.end(), rgb.begin() + static_cast<std::ptrdiff_t>(3 * zone),
                       rgb.begin() + static_cast<std::ptrdiff_t>(3 * zone + 3));
        }
        return all;
    }
    // The message of applying it, or empty; `taken_up_`: whether there was anything new.
    std::string apply(ColourFile &file)
    {
        try {
            taken_up_ = file.apply(*scene_, 1);
            return {};
        } catch (const Failure &failure) {
            return failure.what();
        }
    }

    Library library_;
    std::string path_;
    std::unique_ptr<Scene> scene_;
    std::vector<float> before_;
    bool taken_up_ = false;
};

TEST_F(SceneColours, ColoursAreReloadedWhenTheirFileChanges)
{
    ColourFile file(library_, path_);
    write(red);
    EXPECT_EQ(apply(file), "");
    EXPECT_TRUE(taken_up_);
    const std::vector<float> in_red = tunics();
    ASSERT_EQ(in_red.size(), 36u);
    for (size_t i = 0; i < in_red.size(); ++i) EXPECT_EQ(in_red[i], (i % 3 == 0 ? 192.0f : 16.0f) / 255.0f);
    EXPECT_EQ(apply(file), "");
    EXPECT_FALSE(taken_up_) << "nothing is new";
    write(blue);
    EXPECT_EQ(apply(file), "");
    EXPECT_TRUE(taken_up_);
    EXPECT_NE(tunics(), in_red);
    write(red);
    EXPECT_EQ(apply(file), "");
    EXPECT_EQ(tunics(), in_red) << "and back, byte for byte";
}

TEST_F(SceneColours, ColoursStayWhenTheirFileBreaksWithOneWarning)
{
    ColourFile file(library_, path_);
    write(blue);
    ASSERT_EQ(apply(file), "");
    const std::vector<float> in_blue = tunics();
    ASSERT_NE(in_blue, before_);
    for (const auto &[broken, says] :
         {std::pair<std::string, std::string>(people("hue = [0, 500], saturation = [0, 1], brightness = [0, 1]"),
                                              "line 5, column 17"),
          {people("hue = [0, 5"), "line 5"},
          {people("colour = \"#fff\""), "line 5, column 20"},
          {red + "wings = { colour = \"#102030\" }\n", "'wings'"},
          {"[[classes]]\nname = \"crows\"\n", "no individual in the scene"}}) {
        write(broken);
        const std::string said = apply(file);
        EXPECT_NE(said.find(says), std::string::npos) << says << " in: " << said;
        EXPECT_EQ(apply(file), "") << "said already";
        EXPECT_FALSE(taken_up_);
        EXPECT_EQ(tunics(), in_blue);
    }
    write("");
    EXPECT_EQ(apply(file), "") << "being written, perhaps";
    std::filesystem::remove(path_);
    EXPECT_EQ(apply(file), "") << "being replaced, perhaps";
    EXPECT_EQ(tunics(), in_blue);
    write(red);
    EXPECT_EQ(apply(file), "");
    EXPECT_TRUE(taken_up_);
    EXPECT_NE(tunics(), in_blue);
}

TEST_F(SceneColours, AMissingFileIsAFailure)
{
    ColourFile file(library_, path_ + ".not");
    EXPECT_NE(apply(file).find(path_ + ".not could not be opened: No such file"), std::string::npos);
    EXPECT_EQ(tunics(), before_);
}

}  // namespace
