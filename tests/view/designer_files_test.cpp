// Colour maps that the designer loads and saves, and its script of S2's case study.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "samples/io/files.h"
#include "samples/view/designer/files.h"
#include "samples/view/view.h"
#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

std::string text_of_file(const std::string &path)
{
    std::string text;
    EXPECT_EQ(io::read_whole(path, text), "");
    return text;
}

const std::string roman = CLAQUE_SOURCE_DIR "/samples/maps/roman-classes.toml";

class DesignerFiles : public Staged
{
protected:
    void SetUp() override
    {
        Staged::SetUp();
        folder_ = testing::TempDir() + "claque-designer-" + std::to_string(getpid());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void open_people()
    {
        Stage stage;
        stage.line_up = {"decurion", "patrician", "plebeian"};
        stage.width = 640, stage.height = 600;
        open(stage);
        seen = [this] { view::keep_designs(designer(), context(), folder_, save_, session().model().message); };
        play({"click \"pause\"", "click \"Camera\"", "click \"Person\"", "click \"Designer\""});
    }
    view::Designer &designer() { return session().model().designer; }
    clq_context *context() { return session().world().context(); }

    std::string folder_;
    view::SaveText save_ = [](const std::string &path, const std::string &text) {
        std::ofstream(path, std::ios::binary) << text;
    };
};

TEST_F(DesignerFiles, AreTheSameBytesAfterLoadingAndSaving)
{
    open_people();
    std::filesystem::copy_file(roman, folder_ + "/roman.toml");
    play({"type \"map file\" \"roman.toml\"", "click \"load map\"", "type \"map file\" \"a.toml\"",
          "click \"save map\"", "click \"zone: hair\"", "drag \"hue arc\" 0.1 0.2", "click \"load map\"",
          "type \"map file\" \"b.toml\"", "click \"save map\""});
    EXPECT_EQ(designer().design.classes.size(), 3u);
    EXPECT_FALSE(text_of_file(folder_ + "/a.toml").empty());
    EXPECT_EQ(text_of_file(folder_ + "/a.toml"), text_of_file(folder_ + "/b.toml"));
}

TEST_F(DesignerFiles, HaveTheValuesThatTheDesignHas)
{
    open_people();
    play({"click \"zone: tunic\"", "drag \"hue arc\" 0.93 0.16", "drag \"shade box\" 0.4 0.3 0.8 0.5",
          "click \"add entry\"", "type \"weight\" \"3\"", "type \"one colour\" \"#66023c\"", "click \"zone: outer\"",
          "click \"linked to: tunic\"", "type \"variation\" \"0.15\"", "click \"zone: hair\"",
          "click \"spread: oklab\"", "click \"save map\""});
    const view::Design &design = designer().design;
    const std::string path = folder_ + "/colours.toml";
    ASSERT_TRUE(view::read_design(context(), text_of_file(path), path) == design);
    const view::ColourClass &colours = *design.classes.at(0);
    EXPECT_EQ(colours.find("tunic")->palette.at(1).weight, 3);
    EXPECT_EQ(colours.find("outer")->linked_to, "tunic");
    EXPECT_EQ(colours.find("outer")->variation, 0.15f);
    EXPECT_EQ(colours.find("hair")->space, CLQ_COLOUR_SPACE_OKLAB);
}

TEST_F(DesignerFiles, ThatAreBrokenOrMissingLeaveTheDesignAsItIs)
{
    open_people();
    std::ofstream(folder_ + "/broken.toml") << "[[classes]]\nname = \"a\"\n[classes.zones]\nskin = { hue = [1, 2] }\n";
    play({"click \"zone: tunic\"", "drag \"hue arc\" 0.3 0.6"});
    const view::Design before = designer().design;
    play(
        {"type \"map file\" \"broken.toml\"", "click \"load map\"", "see \"broken.toml, line 4, column 8: it lacks\""});
    EXPECT_TRUE(designer().design == before);
    play({"type \"map file\" \"missing.toml\"", "click \"load map\"", "see \"missing.toml could not be opened\""});
    EXPECT_TRUE(designer().design == before);
}

TEST_F(DesignerFiles, ThatCannotBeWrittenAreSaidAndNothingIsLost)
{
    open_people();
    play({"click \"save map\"", "see \"there is no colour class to save yet\"", "click \"zone: tunic\"",
          "drag \"hue arc\" 0.3 0.6"});
    const view::Design before = designer().design;
    save_ = [](const std::string &path, const std::string &) { throw scenes::Failure(path + " could not be written"); };
    play({"click \"save map\"", "see \"colours.toml could not be written\""});
    EXPECT_TRUE(designer().design == before);
    EXPECT_EQ(designer().history.done(), 1u);
}

void sort(view::Design &design)
{
    for (view::SharedClass &one : design.classes) {
        view::ColourClass sorted = *one;
        std::sort(sorted.zones.begin(), sorted.zones.end(),
                  [](const view::ZoneColours &a, const view::ZoneColours &b) { return a.zone < b.zone; });
        one = std::make_shared<const view::ColourClass>(sorted);
    }
    std::sort(design.classes.begin(), design.classes.end(),
              [](const view::SharedClass &a, const view::SharedClass &b) { return a->name < b->name; });
}

void expect_same_values(view::Design made, view::Design wanted)
{
    sort(made), sort(wanted);
    ASSERT_EQ(made.classes.size(), wanted.classes.size());
    for (size_t c = 0; c < made.classes.size(); ++c) {
        const view::ColourClass &a = *made.classes[c], &b = *wanted.classes[c];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.tmpl, b.tmpl);
        ASSERT_EQ(a.zones.size(), b.zones.size()) << b.name;
        for (size_t z = 0; z < a.zones.size(); ++z) {
            EXPECT_EQ(a.zones[z].zone, b.zones[z].zone) << b.name;
            EXPECT_TRUE(a.zones[z] == b.zones[z]) << b.name << ", " << b.zones[z].zone;
        }
    }
    EXPECT_TRUE(made == wanted);
}

TEST_F(DesignerFiles, OfTheScriptThatBeginsWithNothingAreTheCaseStudyOfRomanSociety)
{
    std::string saved, path;
    double time_s = 0;
    view::Request request;
    request.open = [](scenes::Library &) {
        view::Opened opened;
        opened.options.make = view_test::line_up_of({"decurion", "patrician", "plebeian"});
        opened.options.crowd_options.count = 3;
        return opened;
    };
    request.width = 480, request.height = 480;
    request.script_file = "designer.toml";
    request.script = text_of_file(CLAQUE_SOURCE_DIR "/samples/view/scripts/designer.toml");
    request.folder = std::string("made");
    request.save_picture = [](const std::string &, const std::vector<uint8_t> &, int, int) {};
    request.save_text = [&](const std::string &to, const std::string &text) { path = to, saved = text; };
    request.progress = [](const std::string &) {};
    request.conclude = [&](const std::string &sentence) {
        const size_t frames = sentence.find(" steps, ");
        time_s = std::stod(sentence.substr(frames + 8));
    };
    view::run(request);
    EXPECT_EQ(path, "made/roman.toml");
    EXPECT_GE(time_s, 1800) << "frames of a second each";
    open_people();
    expect_same_values(view::read_design(context(), saved, path),
                       view::read_design(context(), text_of_file(roman), roman));
}

}  // namespace
