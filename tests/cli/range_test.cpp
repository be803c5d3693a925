// Frames of a part of a film: what other times show is not read or made, and pixels are those of the whole film.
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Words = std::vector<std::string>;
using nlohmann::json;

class PartsOfFilms : public Drawing
{
protected:
    static constexpr int people = 60;
    void SetUp() override
    {
        Drawing::SetUp();
        // One comes every two seconds and is there for twelve; they pass each other.
        std::ofstream table(path("long.csv"));
        table << "time,id,x,y\n";
        for (int i = 0; i < people; ++i)
            for (int k = 0; k <= 60; ++k) {
                const double along = (i % 2 ? 1 : -1) * (0.26 * k - 7.8);
                table << 2 * i + 0.2 * k << ",p" << i << ',' << along << ',' << 0.7 * (i % 5) << '\n';
            }
    }
    Words people_of_table(const Words &more) const
    {
        Words words = {"play", path("long.csv"), "--columns", "time,id,x,y", "--unit", "m"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    // The report of the frames.
    json drawn(Words words, const std::string &name, const char *frames) const
    {
        for (const std::string &word : {std::string("--size"), std::string("160x120"), std::string("--again"),
                                        std::string("--frames"), std::string(frames), std::string("--json"),
                                        path(name + ".json"), std::string("--out"), path(name + "-%04d.png")})
            words.push_back(word);
        const Outcome outcome = claque(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.code == 0 ? json::parse(file_text(path(name + ".json")))["frames"] : json();
    }
    // Frames with the same numbers have the same pixels and draw lists.
    static void expect_equal(const json &some, const json &all)
    {
        size_t found = 0;
        for (const json &one : some)
            for (const json &other : all) {
                if (one["frame"] != other["frame"]) continue;
                ++found;
                EXPECT_EQ(one["picture_hash"], other["picture_hash"]) << one["frame"];
                EXPECT_EQ(one["list_hash"], other["list_hash"]) << one["frame"];
            }
        EXPECT_EQ(found, some.size());
    }
};

TEST_F(PartsOfFilms, MakeTheTracksOfTheirTimes)
{
    // A record has all people from its beginning.
    const json all = drawn(people_of_table({"--record", path("all.clt")}), "all", "0:3250/125");
    const json film = drawn(people_of_table({}), "film", "0:3250/125");
    const json tenth = drawn(people_of_table({}), "tenth", "1500:1750/125");
    expect_equal(film, all);
    expect_equal(tenth, all);
    ASSERT_EQ(all.size(), 27u);
    for (const json &frame : all) EXPECT_EQ(frame["read"], json({{"what", "tracks"}, {"read", 60}, {"of", 60}}));
    EXPECT_LE(film[0]["read"]["read"], 2);
    EXPECT_EQ(film.back()["read"]["read"], 60);
    // Tracks between 59 and 71 s: a second more than the frames on either side.
    EXPECT_EQ(tenth.back()["read"]["read"], 12);
    // Backwards and far away in one film: frames are drawn as they are asked for.
    expect_equal(drawn(people_of_table({}), "back", "3000,1500,125"), all);
}

TEST_F(PartsOfFilms, FollowAPersonOfAnotherTime)
{
    const Words camera = {"--camera", "follow:p3"};
    Words recorded = camera;
    recorded.insert(recorded.end(), {"--record", path("all.clt")});
    const json all = drawn(people_of_table(recorded), "all", "0:2500/250");
    expect_equal(drawn(people_of_table(camera), "late", "2250:2500/250"), all);
}

// What is drawn while it is recorded does not matter.
TEST_F(PartsOfFilms, AreRecordedWithAllPeople)
{
    std::ofstream eye(path("eye.toml"));
    eye << "far_m = 900.0\n";
    for (const char *time_s : {"0.0", "90.0"})
        eye << "[[keys]]\ntime_s = " << time_s
            << "\neye = [0.0, 3.0, 12.0]\ntarget = [0.0, 1.0, 0.0]\nfov_deg = 40.0\nnear_m = 0.5\n";
    eye.close();
    const Words camera = {"--camera", "path", "--path", path("eye.toml")};
    const auto replayed = [&](const char *name, const char *frames) {
        drawn(people_of_table({"--record", path("run.clt")}), "live", frames);
        Words words = {"play", path("run.clt")};
        words.insert(words.end(), camera.begin(), camera.end());
        return drawn(words, name, "1600:1600");
    };
    const json played = replayed("first", "0:0"), other = replayed("all", "0:2000/250");
    ASSERT_EQ(played.size(), 1u);
    EXPECT_EQ(played[0]["list_hash"], other[0]["list_hash"]);
}

TEST_F(PartsOfFilms, ReadThePartsOfARecord)
{
#ifndef CLAQUE_STAGED
    GTEST_SKIP() << "this build has no stage: it lacks Recast";
#endif
    const Outcome made = claque({"stage", std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/evacuation.toml",
                                 "--seconds", "30", "--record", path("run.clt")});
    ASSERT_EQ(made.code, 0) << made.err;
    const Words played = {"play", path("run.clt")};
    const json film = drawn(played, "film", "0:740/37");
    const json tenth = drawn(played, "tenth", "370:444/37");
    expect_equal(tenth, film);
    // One that was cut off has no index, and is read at once.
    const std::string bytes = file_text(path("run.clt"));
    std::ofstream(path("cut.clt"), std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()) - 1);
    const json cut = drawn({"play", path("cut.clt")}, "cut", "370:444/37");
    expect_equal(cut, film);
    EXPECT_EQ(cut.back()["read"], json({{"what", "bytes"}, {"read", bytes.size() - 1}, {"of", bytes.size() - 1}}));
    EXPECT_EQ(tenth.back()["read"]["of"], bytes.size());
    EXPECT_LT(tenth.back()["read"]["read"], bytes.size() / 2);
    EXPECT_LT(tenth[0]["read"]["read"], tenth.back()["read"]["read"]);
    EXPECT_LT(tenth.back()["read"]["read"], film.back()["read"]["read"]);
}

}  // namespace
}  // namespace cli_test
