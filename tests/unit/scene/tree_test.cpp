// The tree of places stays balanced and right whatever happens to its leaves.
#include "lib/scene/tree.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

namespace claque::scene
{

namespace
{

Leaf leaf_at(std::mt19937 &random, double field)
{
    std::uniform_real_distribution<double> real(-field, field), little(0, 2);
    Leaf leaf;
    leaf.box = box_round({real(random), little(random), real(random)}, little(random) - 1 > 0 ? little(random) : 0);
    leaf.reach = float(little(random)), leaf.speed = float(little(random));
    return leaf;
}

// Height of the subtree; checks everything below.
int32_t height_of(const Tree &tree, uint32_t at, uint32_t parent, std::map<uint32_t, uint32_t> &found)
{
    const Tree::Node &node = tree.node(at);
    EXPECT_EQ(node.parent, parent);
    if (node.is_leaf()) {
        ++found[node.row()];
        EXPECT_EQ(node.height, 0);
        return 0;
    }
    int32_t heights[2];
    float reach = 0, speed = 0;
    for (int side = 0; side < 2; ++side) {
        const Tree::Node &child = tree.node(node.child[side]);
        EXPECT_TRUE(node.box.holds(child.box));
        reach = std::max(reach, child.reach), speed = std::max(speed, child.speed);
        heights[side] = height_of(tree, node.child[side], at, found);
    }
    EXPECT_EQ(node.reach, reach);
    EXPECT_EQ(node.speed, speed);
    EXPECT_LE(std::abs(heights[0] - heights[1]), 1);
    EXPECT_EQ(node.height, 1 + std::max(heights[0], heights[1]));
    return node.height;
}

class TreeTest : public ::testing::Test
{
protected:
    TreeTest() : tree_(std::pmr::get_default_resource()) { tree_.reserve(count); }

    void check()
    {
        std::map<uint32_t, uint32_t> found;
        if (!tree_.empty()) height_of(tree_, tree_.root(), model::none, found);
        ASSERT_EQ(found.size(), nodes_.size());
        for (const auto &[row, node] : nodes_) {
            ASSERT_EQ(found[row], 1u);
            ASSERT_EQ(tree_.node(node).row(), row) << "a leaf keeps its node";
        }
    }

    static constexpr uint32_t count = 300;
    Tree tree_;
    std::map<uint32_t, uint32_t> nodes_;  // by row
    std::mt19937 random_{5};
};

}  // namespace

TEST_F(TreeTest, HoldsItsLeavesAndStaysBalancedThroughAnyHistory)
{
    for (uint32_t step = 0; step < 6000 && !HasFailure(); ++step) {
        const uint32_t row = random_() % count;
        const Leaf leaf = leaf_at(random_, step % 2000 < 1000 ? 50 : 0.1);
        const auto known = nodes_.find(row);
        if (known == nodes_.end()) nodes_[row] = tree_.insert(row, leaf);
        else if (random_() % 4 == 0) tree_.erase(known->second), nodes_.erase(known);
        else tree_.move(known->second, leaf);
        if (step % 37 == 0) check();
    }
    check();
    tree_.clear(), nodes_.clear();
    EXPECT_TRUE(tree_.empty());
    for (uint32_t row = 0; row < count; ++row) nodes_[row] = tree_.insert(row, leaf_at(random_, 50));
    check();
}

TEST_F(TreeTest, IsBuiltOfLooseLeavesBalancedAndWithoutOverlaps)
{
    for (uint32_t round = 0; round < 20 && !HasFailure(); ++round) {
        tree_.dissolve();
        EXPECT_TRUE(tree_.empty());
        for (uint32_t step = 0; step < 200; ++step) {
            const uint32_t row = random_() % count;
            Leaf leaf = leaf_at(random_, 50);
            leaf.box = box_round({leaf.box.low[0], 0, leaf.box.low[2]}, 0);
            const auto known = nodes_.find(row);
            if (known == nodes_.end()) nodes_[row] = tree_.insert(row, leaf);
            else if (round % 5 == 4) tree_.erase(known->second), nodes_.erase(known);
            else tree_.move(known->second, leaf);
        }
        std::vector<uint32_t> leaves;
        for (const auto &[row, node] : nodes_) leaves.push_back(node);
        tree_.build(leaves.data(), uint32_t(leaves.size()));
        check();
        uint32_t entered = 0;  // by a point
        tree_.for_each(
            [&](const Tree::Node &node) {
                ++entered;
                return node.box.holds(box_round({1, 0, 2}, 0));
            },
            [](uint32_t) {});
        EXPECT_LE(entered, 2 * tree_.height() + 1);
    }
}

TEST_F(TreeTest, TakesLeavesInALineWithoutGrowingTall)
{
    Leaf leaf;
    for (uint32_t row = 0; row < count; ++row) {
        leaf.box = box_round({double(row), 0, 0}, 0);
        nodes_[row] = tree_.insert(row, leaf);
    }
    check();
    EXPECT_LE(tree_.height(), 12u);  // 1.44 log2(300)
}

TEST_F(TreeTest, BoxesAreRoundedOutwardsAtAnySize)
{
    for (const double x : {0.1, -0.1, 1e6 + 0.03, -1e6 - 0.03, 1e-300, -1e-300, 1e39, -1e39, 1e308, -1e308}) {
        const Box box = box_round({x, 0, 0}, 0);
        EXPECT_LE(double(box.low[0]), x);
        EXPECT_GE(double(box.high[0]), x);
    }
    EXPECT_EQ(box_round({1, 1, 1}, HUGE_VAL).high[2], HUGE_VALF);
    EXPECT_EQ(box_round({1, 1, 1}, HUGE_VAL).low[2], -HUGE_VALF);
}

}  // namespace claque::scene
