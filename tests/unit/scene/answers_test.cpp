// A host's array gets the first answers in order, whatever the order in which they are found; and sets of bits.
#include "lib/scene/answers.h"

#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "lib/base/bitmap.h"

namespace claque::scene
{

namespace
{

struct Less {
    bool operator()(int a, int b) const { return a < b; }
};

}  // namespace

TEST(Answers, AreTheFirstInOrderWhateverTheRoom)
{
    std::mt19937 random(3);
    for (uint32_t capacity : {0u, 1u, 2u, 7u, 40u, 41u, 60u}) {
        std::vector<int> all(40), out(capacity, -1);
        for (int i = 0; i < 40; ++i) all[size_t(i)] = i;
        std::shuffle(all.begin(), all.end(), random);
        Answers<int, Less> answers(out.data(), capacity, Less());
        for (const int one : all) answers.add(one);
        EXPECT_EQ(answers.finish(), 40u);
        for (uint32_t i = 0; i < capacity; ++i) EXPECT_EQ(out[i], i < 40 ? int(i) : -1) << "room for " << capacity;
    }
}

TEST(Bitmap, IsASetInAscendingOrder)
{
    base::Bitmap bits(std::pmr::get_default_resource());
    std::set<uint32_t> wanted;
    std::mt19937 random(4);
    bits.reserve(100);
    for (uint32_t step = 0; step < 20000; ++step) {
        if (step == 4000) bits.reserve(9000);
        const uint32_t i = random() % (step < 4000 ? 100 : 9000);
        if (random() % 3) bits.insert(i), wanted.insert(i);
        else bits.erase(i), wanted.erase(i);
        if (step == 12000) bits.clear(), wanted.clear();
        ASSERT_EQ(bits.count(), wanted.size());
        ASSERT_EQ(bits.has(i), wanted.count(i) == 1);
    }
    std::vector<uint32_t> found;
    bits.for_each([&](uint32_t i) { found.push_back(i); });
    EXPECT_EQ(found, std::vector<uint32_t>(wanted.begin(), wanted.end()));
    EXPECT_FALSE(bits.has(1u << 30));
}

}  // namespace claque::scene
