// Each rule of a piece of a track, on both sides of its bound.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

constexpr double rounding_s = 1e-6;  // by which a piece may be too short

std::vector<track::Point> walked(double from_s, double length_s)
{
    std::vector<track::Point> points = test::points_of(10, length_s, [](double t) { return glm::dvec2(0, 1.2 * t); });
    for (track::Point &point : points) point.time_s += from_s;
    return points;
}

class PieceRules : public testing::Test
{
protected:
    PieceRules()
    {
        settings_.end_s = 1;
        before_ = test::track_of(walked(0, 3), "citizen", settings_);
        border_s_ = track::end_of(*before_);
        settings_.previous = before_.get(), settings_.end_s = 2;
    }
    // The refusal; "" if it is made.
    static std::string said(const std::vector<track::Point> &points, const track::BuildSettings &settings,
                            const char *figure = "citizen")
    {
        try {
            test::track_of(points, figure, settings);
            return "";
        } catch (const base::Error &error) {
            EXPECT_EQ(error.status(), CLQ_ARGUMENT);
            return error.what();
        }
    }
    static void expect_said(const std::string &found, const char *words)
    {
        EXPECT_NE(found.find(words), std::string::npos) << found << "\nand not: " << words;
    }

    track::BuildSettings settings_;
    std::unique_ptr<track::Track> before_;
    double border_s_ = 0;
};

TEST_F(PieceRules, OfTheShortest)
{
    const char *const why = "it must be 0.1 s long at least";
    const auto ends_at = [&](double end_s) {
        track::BuildSettings settings = settings_;
        settings.end_s = end_s;
        return settings;
    };
    const double least = track::min_piece_s - rounding_s;
    const std::vector<track::Point> points = walked(0, 3);
    EXPECT_EQ(said(points, ends_at(border_s_ + least + 1e-9)), "");
    expect_said(said(points, ends_at(border_s_ + least - 1e-9)), why);
    // The points end before it does.
    EXPECT_EQ(said(walked(0, 1.1), ends_at(9)), "");
    expect_said(said(walked(0, 1), ends_at(9)), why);
    // The first piece begins with its points.
    settings_.previous = nullptr;
    EXPECT_EQ(said(walked(2, 3), ends_at(2 + least + 1e-9)), "");
    expect_said(said(walked(2, 3), ends_at(2 + least - 1e-9)), "from 2 s to ");
    EXPECT_EQ(said(walked(2, 0), {}), "") << "a track that is no piece may be a moment";
}

TEST_F(PieceRules, OfThePieceBefore)
{
    const std::vector<track::Point> points = walked(0, 3);
    EXPECT_EQ(said(points, settings_), "");
    expect_said(said(points, settings_, "patrician"), "has another locomotion than the piece before");
    const char *const scale = "a piece of a track has a scale of ";
    for (const double metres : {0.5, 1.0, 2.0})
        for (const double person : {0.5, 1.0, 2.0}) {
            track::BuildSettings settings = settings_;
            settings.metres_per_unit = metres, settings.scale = person;
            const std::string found = said(points, settings);
            if (metres == 1 && person == 1) EXPECT_EQ(found, "");
            else expect_said(found, scale);
        }
    // Of units that are no metres.
    track::BuildSettings settings = settings_;
    settings.previous = nullptr, settings.metres_per_unit = 0.5, settings.scale = 3, settings.end_s = 1;
    const auto before = test::track_of(points, "citizen", settings);
    settings.previous = before.get(), settings.end_s = 2;
    EXPECT_EQ(said(points, settings), "");
    settings.scale = 1.5;
    expect_said(said(points, settings), scale);
}

TEST_F(PieceRules, OfTheFirstPoint)
{
    std::vector<track::Point> points = walked(border_s_, 3);
    EXPECT_EQ(said(points, settings_), "");
    points[0].time_s = std::nextafter(border_s_, 9.0);
    expect_said(said(points, settings_), "the first point of a piece is at 1 s, but the piece before ends at 1 s");
}

}  // namespace
