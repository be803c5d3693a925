// Several processes draw the pictures that one draws (samples/hosts/tiles).
#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "samples/hosts/tiles/tiled_picture.h"
#include "tests/gl/support/absent.h"

namespace
{

constexpr int width = 192, height = 108;

std::vector<uint8_t> film(int processes)
{
    tiles::TiledPicture picture(width, height, processes);
    std::vector<uint8_t> all;
    for (int k = 0; k < 3; ++k) {
        const uint8_t *rgb = picture.show(k * 0.7);
        all.insert(all.end(), rgb, rgb + 3 * width * height);
    }
    return all;
}

TEST(Tiles, OfSeveralProcessesAreThePictureOfOne)
{
    std::vector<uint8_t> alone;
    try {
        alone = film(1);
    } catch (const std::runtime_error &failure) {
        END_WITHOUT_CONTEXT(contexts::Kind::any, failure.what());
    }
    EXPECT_TRUE(std::any_of(alone.begin(), alone.end(), [](uint8_t byte) { return byte > 100; }));
    for (const int processes : {2, 3, 5}) EXPECT_TRUE(film(processes) == alone) << processes;
}

TEST(Crew, IsNotStartedBesideThreads)
{
    std::atomic<bool> ends{false};
    std::thread other([&] {
        while (!ends) std::this_thread::yield();
    });
    const auto start = [](uint32_t) -> processes::Answering { return [](const std::string &) { return ""; }; };
    EXPECT_THROW(processes::Crew(1, start), std::runtime_error);
    ends = true;
    other.join();
}

TEST(Crew, ThrowsWhatAWorkerThrows)
{
    const auto start = [](uint32_t worker) -> processes::Answering {
        return [worker](const std::string &task) -> std::string {
            if (task == "fail") throw std::runtime_error("worker " + std::to_string(worker) + " has a reason");
            return task + task;
        };
    };
    processes::Crew crew(2, start);
    crew.send(1, "ab");
    EXPECT_EQ(crew.wait().text, "abab");
    crew.send(1, "fail");
    try {
        crew.wait();
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error &failure) {
        EXPECT_STREQ(failure.what(), "worker 1 has a reason");
    }
}

// A picture whose columns cost what `of` says.
std::vector<double> costs_of(const processes::TileBorders &borders, double (*of)(int column))
{
    std::vector<double> costs;
    for (const processes::Tile &tile : borders.tiles()) {
        costs.push_back(0);
        for (int x = tile.x0; x < tile.x1; ++x) costs.back() += of(x);
    }
    return costs;
}

TEST(TileBorders, FollowTheCostUntilAllTilesCostTheSame)
{
    processes::TileBorders borders(1000, 4);
    const auto cost = [](int x) { return x < 300 ? 9.0 : x < 350 ? 40.0 : 1.0; };
    for (int k = 0; k < 12; ++k) borders.follow(costs_of(borders, cost));
    const std::vector<double> costs = costs_of(borders, cost);
    const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
    EXPECT_LT(*most, 1.1 * *least);
}

TEST(TileBorders, CoverThePictureAndLeaveEachTileAColumn)
{
    for (const int count : {1, 2, 7, 30, 200}) {
        processes::TileBorders borders(30, count);
        for (int k = 0; k < 20; ++k) {
            int next = 0;
            for (const processes::Tile &tile : borders.tiles()) {
                ASSERT_EQ(tile.x0, next);
                ASSERT_GT(tile.x1, tile.x0);
                next = tile.x1;
            }
            ASSERT_EQ(next, 30);
            std::vector<double> costs(borders.tiles().size(), 0);
            costs[static_cast<size_t>(k) % costs.size()] = k % 3 == 0 ? 1e9 : 1;
            if (k % 5 == 4) costs.assign(costs.size(), 0);
            borders.follow(costs);
        }
    }
}

}  // namespace
