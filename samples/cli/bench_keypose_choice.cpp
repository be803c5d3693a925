// S3 Fig. 7: 30 individuals sample two of 22 key-poses each from a normal distribution. Counts how many a cache of 7,
// 15, 22 or 30 key-poses can serve when it is filled greedily, optimally (every set tried), with the first n, or with
// n at random.
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

#include "samples/cli/bench_keypose.h"
#include "samples/scenes/random.h"

namespace cli
{
namespace
{

constexpr uint32_t character_count = 30, poses = 22, crowds = 40;
constexpr std::array<uint32_t, 4> sizes = {7, 15, 22, 30};
constexpr std::array<const char *, 5> ways = {"every set tried", "claque", "fullest bins (S3)", "the first n",
                                              "n at random"};

using Bins = std::vector<clq_key_pose_bin>;

uint32_t normal_pose(uint64_t crowd, uint64_t draw)
{
    for (uint64_t again = 0;; ++again) {
        const uint64_t person = (draw << 8) + again;
        const double u = scenes::random_unit(crowd, person, scenes::Purpose::place_x),
                     v = scenes::random_unit(crowd, person, scenes::Purpose::place_z);
        const double normal = std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * 3.14159265358979323846 * v);
        const double pose = std::floor(poses / 2.0 + normal * poses / 6.0);
        if (pose >= 0 && pose < poses) return static_cast<uint32_t>(pose);
    }
}

Bins draw(uint64_t crowd)
{
    Bins bins;
    for (uint32_t person = 0; person < character_count; ++person) {
        const uint32_t a = normal_pose(crowd, 1000 * person);
        uint32_t b = a;
        for (uint64_t k = 1; b == a; ++k) b = normal_pose(crowd, 1000 * person + k);
        const clq_key_pose_bin bin = {std::min(a, b), std::max(a, b), 1};
        bool found = false;
        for (clq_key_pose_bin &one : bins)
            if (one.first == bin.first && one.second == bin.second) ++one.count, found = true;
        if (!found) bins.push_back(bin);
    }
    return bins;
}

uint32_t served(const Bins &bins, uint32_t kept)
{
    uint32_t sum = 0;
    for (const clq_key_pose_bin &bin : bins)
        if (kept >> bin.first & kept >> bin.second & 1) sum += bin.count;
    return sum;
}

// Tries all sets of exactly `size` key-poses; smaller sets serve no more.
uint32_t best(const Bins &bins, uint32_t size)
{
    if (size >= poses) return character_count;
    uint32_t most = 0;
    for (uint32_t set = (1u << size) - 1; set < 1u << poses;) {
        most = std::max(most, served(bins, set));
        const uint32_t low = set & -set, up = set + low;
        set = up | ((set ^ up) / low) >> 2;
    }
    return most;
}

uint32_t greedy(const Bins &bins, uint32_t size)
{
    std::array<bool, poses> chosen = {};
    scenes::check(clq_key_poses_choose(bins.data(), static_cast<uint32_t>(bins.size()), size, chosen.data(), poses));
    uint32_t kept = 0;
    for (uint32_t pose = 0; pose < poses; ++pose) kept |= uint32_t(chosen[pose]) << pose;
    return served(bins, kept);
}

// S3 4.2: keeps the fullest bins first, until the cache is full.
uint32_t fullest_first(Bins bins, uint32_t size)
{
    std::stable_sort(bins.begin(), bins.end(),
                     [](const clq_key_pose_bin &a, const clq_key_pose_bin &b) { return a.count > b.count; });
    uint32_t kept = 0;
    for (const clq_key_pose_bin &bin : bins) {
        const uint32_t more = kept | 1u << bin.first | 1u << bin.second;
        if (std::bitset<poses>(more).count() > size) break;
        kept = more;
    }
    return served(bins, kept);
}

uint32_t random_set(uint64_t crowd, uint32_t size)
{
    uint32_t kept = 0, count = 0;
    for (uint64_t k = 0; count < std::min(size, poses); ++k) {
        const uint32_t bit = 1u << scenes::random_bits(crowd, k, scenes::Purpose::clip) % poses;
        count += !(kept & bit);
        kept |= bit;
    }
    return kept;
}

}  // namespace

Json key_pose_choice()
{
    Json report = chart_of_lines("Individuals served from a cache of key-poses", "key-poses kept, of 22",
                                 "individuals served, of 30");
    report["columns"] = {"key-poses kept", ways[0], ways[1], ways[2], ways[3], ways[4]};
    std::array<Json, ways.size()> points;
    for (const uint32_t size : sizes) {
        std::array<double, ways.size()> sums = {};
        for (uint64_t crowd = 1; crowd <= crowds; ++crowd) {
            const Bins bins = draw(crowd);
            sums[0] += best(bins, size);
            sums[1] += greedy(bins, size);
            sums[2] += fullest_first(bins, size);
            sums[3] += served(bins, size >= poses ? (1u << poses) - 1 : (1u << size) - 1);
            sums[4] += served(bins, random_set(crowd, size));
        }
        Json run = {{"key-poses kept", size}};
        for (size_t way = 0; way < ways.size(); ++way) {
            run[ways[way]] = sums[way] / crowds;
            points[way].push_back({size, sums[way] / crowds});
        }
        report["runs"].push_back(std::move(run));
    }
    for (size_t way = 0; way < ways.size(); ++way)
        report["series"].push_back({{"name", ways[way]}, {"points", points[way]}});
    report["note"] = "S3 Fig. 7: means of " + std::to_string(crowds) +
                     " crowds of 30 that sample two key-poses each from a normal distribution";
    return report;
}

}  // namespace cli
