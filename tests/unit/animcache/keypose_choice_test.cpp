// Compares the greedy choice with the best choice, found by trying every set (S3 4.2, Fig. 7).
#include "animcache/keypose_choice.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace claque::animcache
{

namespace
{

struct Crowd {
    uint32_t poses = 0;
    std::vector<KeyPoseBin> bins;
};

// S3's case: every individual needs two key-poses, sampled from a normal distribution.
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

uint32_t choose_key_poses(KeyPoseBin *bins, uint32_t bin_count, uint32_t capacity, const uint8_t *held,
                          std::vector<uint8_t> &chosen)
{
    KeyPoseChoice choice(std::pmr::get_default_resource(), static_cast<uint32_t>(chosen.size()), bin_count);
    return choice.choose(bins, bin_count, capacity, held, chosen.data());
}

uint32_t greedy(Crowd crowd, uint32_t capacity, uint32_t *used = nullptr)
{
    std::vector<uint8_t> chosen(crowd.poses, 0);
    const uint32_t count =
        choose_key_poses(crowd.bins.data(), static_cast<uint32_t>(crowd.bins.size()), capacity, nullptr, chosen);
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
    // S3 Fig. 5: seven key-poses, room for four. 0 to 0.2 and 0.4 to 0.6 are the fullest bins; the bin between is
    // served too.
    std::vector<KeyPoseBin> bins = {{0, 1, 4}, {1, 2, 3}, {2, 3, 4}, {3, 4, 2}, {4, 5, 1}};
    std::vector<uint8_t> chosen(7, 0);
    EXPECT_EQ(choose_key_poses(bins.data(), 5, 4, nullptr, chosen), 4u);
    EXPECT_EQ(chosen, (std::vector<uint8_t>{1, 1, 1, 1, 0, 0, 0}));
}

TEST(KeyPoseChoice, TakesASmallerBinWhereALargerOneFindsNoRoom)
{
    std::vector<KeyPoseBin> bins = {{0, 1, 9}, {2, 3, 5}, {1, 4, 2}, {5, 5, 1}};
    std::vector<uint8_t> chosen(6, 0);
    EXPECT_EQ(choose_key_poses(bins.data(), 4, 3, nullptr, chosen), 3u);
    EXPECT_EQ(chosen, (std::vector<uint8_t>{1, 1, 0, 0, 1, 0})) << "two left out, one place filled";
}

TEST(KeyPoseChoice, PrefersAmongEqualBinsWhatLiesThereAlready)
{
    std::vector<KeyPoseBin> bins = {{0, 1, 3}, {2, 3, 3}, {4, 5, 3}};
    const uint8_t held[6] = {0, 0, 1, 1, 0, 0};
    std::vector<uint8_t> chosen(6, 0);
    EXPECT_EQ(choose_key_poses(bins.data(), 3, 2, held, chosen), 2u);
    EXPECT_EQ(chosen, (std::vector<uint8_t>{0, 0, 1, 1, 0, 0}));
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

// Every individual needs one key-pose (S3 3): the most wanted ones are the best choice.
TEST(KeyPoseChoice, KeepsTheMostWantedWhereOneIsAllThatAnybodyNeeds)
{
    std::vector<KeyPoseBin> bins;
    for (uint32_t pose = 0; pose < 97; ++pose) bins.push_back({pose, pose, 1 + pose * 37 % 97});
    for (uint32_t capacity = 0; capacity <= 97; ++capacity) {
        std::vector<uint8_t> chosen(97, 0);
        EXPECT_EQ(choose_key_poses(bins.data(), 97, capacity, nullptr, chosen), capacity);
        for (const KeyPoseBin &bin : bins) EXPECT_EQ(chosen[bin.first] == 1, bin.count > 97 - capacity);
    }
}

// Along a clip every individual needs two neighbouring key-poses. Dynamic programming along the clip then finds the
// best choice (a table by the number kept so far and whether the last one is kept).
TEST(KeyPoseChoice, ServesNearlyAsManyAsTheBestAlongClips)
{
    const struct {
        uint32_t people, poses, capacity;
        double share;
    } cases[] = {{340, 1080, 256, 0.99}, {340, 600, 100, 0.99}, {5000, 201, 100, 0.96}, {1500, 200, 50, 0.9}};
    std::mt19937 random(3);
    for (const auto &c : cases) {
        uint64_t got = 0, possible = 0;
        for (int crowd = 0; crowd < 8; ++crowd) {
            std::vector<uint32_t> between(c.poses, 0);  // individuals between each key-pose and the next
            for (uint32_t person = 0; person < c.people; ++person)
                if (const uint32_t at = uint32_t(random() % (c.poses - 1)); at % 60 != 59) ++between[at];
            std::vector<KeyPoseBin> bins;
            for (uint32_t i = 0; i + 1 < c.poses; ++i)
                if (between[i]) bins.push_back({i, i + 1, between[i]});
            std::vector<uint8_t> chosen(c.poses, 0);
            choose_key_poses(bins.data(), uint32_t(bins.size()), c.capacity, nullptr, chosen);
            for (uint32_t i = 0; i + 1 < c.poses; ++i) got += chosen[i] && chosen[i + 1] ? between[i] : 0;
            std::vector<int64_t> without(c.capacity + 1, 0), with(c.capacity + 1, INT32_MIN);  // by how many are kept
            for (uint32_t i = 0; i < c.poses; ++i)
                for (uint32_t kept = c.capacity + 1; kept-- > 0;) {
                    const int64_t before = i > 0 ? int64_t(between[i - 1]) : 0;
                    const int64_t taken = kept == 0 ? INT32_MIN : std::max(without[kept - 1], with[kept - 1] + before);
                    without[kept] = std::max(without[kept], with[kept]);
                    with[kept] = taken;
                }
            possible += uint64_t(std::max(without[c.capacity], with[c.capacity]));
        }
        std::printf("%u people, %u key-poses, room for %u: %.3f of the best\n", c.people, c.poses, c.capacity,
                    double(got) / double(possible));
        EXPECT_LE(got, possible);
        EXPECT_GE(double(got), c.share * double(possible));
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
    EXPECT_GE(got, 0.97 * possible) << got << " of " << possible;
    RecordProperty("share_of_best_permille", int(1000 * got / possible));
}

}  // namespace claque::animcache
