// The greedy choice against the best choice of all, found by trying every set (S3 4.2, Fig. 7).
#include "animcache/keypose_choice.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace claque::animcache
{

namespace
{

struct Crowd {
    uint32_t poses = 0;
    std::vector<KeyPoseBin> bins;
};

// S3's case: everybody draws two of the key-poses with normal distribution.
Crowd draw(uint32_t seed, uint32_t people, uint32_t poses)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(poses / 2.0, poses / 6.0);
    Crowd crowd;
    crowd.poses = poses;
    const auto one = [&] {
        for (;;)
            if (const double x = normal(random); x >= 0 && x < poses) return static_cast<uint32_t>(x);
    };
    for (uint32_t i = 0; i < people; ++i) {
        uint32_t a = one(), b = one();
        while (b == a) b = one();
        if (b < a) std::swap(a, b);
        bool found = false;
        for (KeyPoseBin &bin : crowd.bins)
            if (bin.first == a && bin.second == b) ++bin.count, found = true;
        if (!found) crowd.bins.push_back({a, b, 1});
    }
    return crowd;
}

uint32_t served(const Crowd &crowd, uint32_t kept)
{
    uint32_t sum = 0;
    for (const KeyPoseBin &bin : crowd.bins)
        if (kept >> bin.first & 1 && kept >> bin.second & 1) sum += bin.count;
    return sum;
}

uint32_t greedy(Crowd crowd, uint32_t capacity, uint32_t *used = nullptr)
{
    std::vector<uint8_t> chosen(crowd.poses, 0);
    const uint32_t count =
        choose_key_poses(crowd.bins.data(), static_cast<uint32_t>(crowd.bins.size()), capacity, nullptr, chosen.data());
    if (used) *used = count;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < crowd.poses; ++i) kept |= uint32_t(chosen[i]) << i;
    return served(crowd, kept);
}

uint32_t best(const Crowd &crowd, uint32_t capacity)
{
    uint32_t most = 0;
    for (uint32_t kept = 0; kept < 1u << crowd.poses; ++kept)
        if (uint32_t(__builtin_popcount(kept)) <= capacity) most = std::max(most, served(crowd, kept));
    return most;
}

}  // namespace

TEST(KeyPoseChoice, KeepsTheFullestBinsOfThePapersExample)
{
    // S3 Fig. 5: seven key-poses, room for four; 0 to 0.2 and 0.4 to 0.6 are the fullest, the bin between is served too.
    std::vector<KeyPoseBin> bins = {{0, 1, 4}, {1, 2, 3}, {2, 3, 4}, {3, 4, 2}, {4, 5, 1}};
    std::vector<uint8_t> chosen(7, 0);
    EXPECT_EQ(choose_key_poses(bins.data(), 5, 4, nullptr, chosen.data()), 4u);
    EXPECT_EQ(chosen, (std::vector<uint8_t>{1, 1, 1, 1, 0, 0, 0}));
}

TEST(KeyPoseChoice, TakesASmallerBinWhereALargerOneFindsNoRoom)
{
    std::vector<KeyPoseBin> bins = {{0, 1, 9}, {2, 3, 5}, {1, 4, 2}, {5, 5, 1}};
    std::vector<uint8_t> chosen(6, 0);
    EXPECT_EQ(choose_key_poses(bins.data(), 4, 3, nullptr, chosen.data()), 3u);
    EXPECT_EQ(chosen, (std::vector<uint8_t>{1, 1, 0, 0, 1, 0})) << "two left out, one place filled";
}

TEST(KeyPoseChoice, PrefersAmongEqualBinsWhatLiesThereAlready)
{
    std::vector<KeyPoseBin> bins = {{0, 1, 3}, {2, 3, 3}, {4, 4, 3}};
    const uint8_t held[5] = {0, 0, 1, 1, 0};
    std::vector<uint8_t> chosen(5, 0);
    EXPECT_EQ(choose_key_poses(bins.data(), 3, 2, held, chosen.data()), 2u);
    EXPECT_EQ(chosen, (std::vector<uint8_t>{0, 0, 1, 1, 0}));
}

TEST(KeyPoseChoice, NeverTakesMoreThanThereIsRoomFor)
{
    for (uint32_t seed = 0; seed < 50; ++seed)
        for (uint32_t capacity = 0; capacity <= 12; ++capacity) {
            uint32_t used = 0;
            greedy(draw(seed, 20, 12), capacity, &used);
            EXPECT_LE(used, capacity);
        }
}

TEST(KeyPoseChoice, ServesNearlyAsManyAsTheBestOfAllChoices)
{
    uint32_t got = 0, possible = 0;
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const Crowd crowd = draw(seed, 30, 14);
        for (const uint32_t capacity : {5u, 9u}) {
            const uint32_t mine = greedy(crowd, capacity), most = best(crowd, capacity);
            EXPECT_LE(mine, most) << "no choice serves more than the best one";
            got += mine, possible += most;
        }
        EXPECT_EQ(greedy(crowd, 14), 30u) << "with room for all, all are served";
    }
    EXPECT_GE(got, 0.85 * possible) << got << " of " << possible;
    RecordProperty("share_of_best_permille", int(1000 * got / possible));
}

}  // namespace claque::animcache
