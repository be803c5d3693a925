// A scenario that changes while it runs is taken over at the time that is shown, or refused while the old one goes on.
#include "samples/stage/takeover.h"

#include <fstream>
#include <iterator>
#include <unistd.h>

#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;
namespace fs = std::filesystem;

class TakeoverOfAFile : public testing::Test
{
protected:
    TakeoverOfAFile() : folder_(fs::path(testing::TempDir()) / ("claque-takeover-" + std::to_string(::getpid())))
    {
        const std::string from = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/";
        fs::create_directories(folder_);
        fs::copy(from + "evacuation", folder_ / "evacuation");
        std::ifstream file(from + "evacuation.toml");
        text_.assign(std::istreambuf_iterator<char>(file), {});
        put("count = 160", "count = 4"), put("count = 140", "count = 5");
        write("evacuation.toml", text_, 1);
    }
    ~TakeoverOfAFile() override { fs::remove_all(folder_); }

    std::string path() const { return (folder_ / "evacuation.toml").string(); }
    void put(const std::string &was, const std::string &is)
    {
        const size_t at = text_.find(was);
        ASSERT_NE(at, std::string::npos) << was;
        text_.replace(at, was.size(), is);
    }
    // Each writing has a time of its own, however fast the test is.
    void write(const std::string &name, const std::string &text, int minutes) const
    {
        std::ofstream(folder_ / name) << text;
        fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() + std::chrono::minutes(minutes));
    }

    fs::path folder_;
    std::string text_;
};

TEST_F(TakeoverOfAFile, BringsTheNewRunToTheTimeThatIsShown)
{
    Library library(1);
    const Scenario first = load_scenario(path());
    staged::Takeover takeover(library, {}, path(), first, {}, [&] {
        Scenario read = load_scenario(path());
        read.characters[0].placement.turn_deg = 5;  // as a command may say beside the file
        return read;
    });
    takeover.look(14);
    takeover.wait();
    EXPECT_EQ(takeover.take(), nullptr) << "nothing has changed";
    put("count = 4", "count = 7");
    write("evacuation.toml", text_, 2);
    takeover.look(14);
    takeover.wait();
    const auto made = takeover.take();
    ASSERT_NE(made, nullptr);
    EXPECT_EQ(made->scene->run().people().all().size(), 12u);
    EXPECT_EQ(made->scene->run().shown_s(), 14);
    EXPECT_EQ(made->scenario.stage->agents[0].count, 7u);
    EXPECT_EQ(made->scenario.characters[0].placement.turn_deg, 5);
    // As if the file had been so from the beginning.
    staged::StageOptions options;
    CrowdOptions crowd_options;
    const auto fresh = staged::make_staged(library, crowd_options, load_scenario(path()), options);
    fresh->place(14), fresh->rest();
    EXPECT_EQ(fresh->run().info().hash, made->scene->run().info().hash);
    takeover.look(15);
    takeover.wait();
    EXPECT_EQ(takeover.take(), nullptr);
}

TEST_F(TakeoverOfAFile, IsRefusedWithItsErrorAndWaitsForTheNextChange)
{
    Library library(1);
    staged::Takeover takeover(library, {}, path(), load_scenario(path()), {}, [&] { return load_scenario(path()); });
    const std::string good = text_;
    put("\"west\", \"east\"]", "\"westt\", \"east\"]");
    write("evacuation.toml", text_, 2);
    takeover.look(3);
    takeover.wait();
    EXPECT_EQ(takeover.take(), nullptr);
    const std::string refusal = takeover.refusal();
    EXPECT_NE(refusal.find("evacuation.toml:"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("'westt'"), std::string::npos) << refusal;
    EXPECT_EQ(takeover.refusal(), "") << "said once";
    takeover.look(4);
    takeover.wait();
    EXPECT_EQ(takeover.take(), nullptr) << "the same file is not tried again";
    EXPECT_EQ(takeover.refusal(), "");
    // A machine counts as well.
    write("evacuation.toml", good, 3);
    std::ifstream machine(folder_ / "evacuation/visitor.toml");
    write("evacuation/visitor.toml", std::string(std::istreambuf_iterator<char>(machine), {}) + "# changed\n", 4);
    takeover.look(5);
    takeover.wait();
    EXPECT_NE(takeover.take(), nullptr);
}

}  // namespace
}  // namespace staged_test
