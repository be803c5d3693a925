// Measured counts of a run: reading, writing and refusals.
#include "samples/cost/measured.h"

#include <gtest/gtest.h>

#include "samples/scenes/check.h"

namespace cost
{
namespace
{

constexpr const char *by_hand = R"({"note": "by hand", "NO_01": 1180.5, "NO_02": 100, "NO_03": 80, "NO_04a": 790,
    "NO_04b": 231, "NO_05": 60, "fTrack": 0.12, "fCoh": 0.97, "scene": "passed over"})";

TEST(Measured, EveryCountIsReadIntoItsField)
{
    const Measured m = measured_of(by_hand, "counts.json");
    EXPECT_EQ(m.actor, (Counts{1180.5, 100, 80, 790, 231, 60}));
    EXPECT_EQ(m.shares.track, 0.12);
    EXPECT_EQ(m.shares.coherence, 0.97);
    EXPECT_EQ(m.note, "by hand");
    EXPECT_FALSE(m.traditional.has_value());
}

TEST(Measured, WhatIsWrittenIsReadAgain)
{
    Measured m = measured_of(by_hand, "counts.json");
    m.traditional = Counts{4000, 100, 100, 8200, 240, 4100};
    const Measured again = measured_of(json_of(m), "again");
    EXPECT_EQ(again.actor, m.actor);
    EXPECT_EQ(again.traditional, m.traditional);
    EXPECT_EQ(again.shares.track, m.shares.track);
    EXPECT_EQ(again.shares.coherence, m.shares.coherence);
    EXPECT_EQ(again.note, m.note);
}

TEST(Measured, WhatIsWrongIsSaid)
{
    const auto with = [](const std::string &from, const std::string &to) {
        std::string text = by_hand;
        return text.replace(text.find(from), from.size(), to);
    };
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"nothing", "it is not JSON"},
        {std::string(300000, '[') + std::string(300000, ']'), "it is nested more than 64 deep"},
        {"[1]", "it is not an object"},
        {with("\"NO_03\": 80,", ""), "it lacks 'NO_03'"},
        {with(": 80", ": -1"), "'NO_03' is -1, not a number from 0 to 1e12"},
        {with(": 80", ": \"many\""), "'NO_03' is \"many\", not a number"},
        {with(": 80", ": 1e400"), "it is not JSON"},
        {with("0.12", "1.5"), "'fTrack' is 1.5, not a number from 0 to 1"},
        {with("\"note\": \"by hand\",", ""), "it has no 'note'"},
        {with("\"scene\": \"passed over\"", "\"traditional\": 4"), "'traditional' is not an object"},
        {with("\"scene\": \"passed over\"", "\"traditional\": {}"),
         "under 'traditional', is not a report of counts: it "
         "lacks 'NO_01'"},
        {R"({"NO_01": 0, "NO_02": 0, "NO_03": 0, "NO_04a": 1, "NO_04b": 1, "NO_05": 1})", "no actor moved"},
    };
    for (const auto &[text, said] : wrong) {
        try {
            measured_of(text, "counts.json");
            ADD_FAILURE() << "taken: " << text;
        } catch (const scenes::Failure &failure) {
            EXPECT_NE(std::string(failure.what()).find(said), std::string::npos) << failure.what() << "\n" << said;
            EXPECT_EQ(std::string(failure.what()).rfind("counts.json", 0), 0u) << failure.what();
        }
    }
}

}  // namespace
}  // namespace cost
