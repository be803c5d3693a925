#include "samples/cli/agreement.h"

#include <algorithm>

#include "samples/cli/bench.h"

namespace cli
{
namespace
{

// More than one differing pixel in this many cannot be explained by depth ties.
constexpr size_t pixels_a_tie = 50000;

size_t different_pixels(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b)
{
    size_t differ = 0;
    for (size_t i = 0; i + 2 < a.size(); i += 3) differ += a[i] != b[i] || a[i + 1] != b[i + 1] || a[i + 2] != b[i + 2];
    return differ;
}

}  // namespace

void Agreement::begin(const std::string &what)
{
    what_ = what;
    reference_.clear();
    hashes_.clear();
}

void Agreement::check(const std::vector<uint8_t> &rgb, const std::string &cache, const std::string &strategy)
{
    const std::string hash = hex(scenes::hash_of(rgb)), with = " with cache " + cache + " and strategy " + strategy;
    if (reference_.empty()) {
        reference_ = rgb;
        first_ = hash;
    }
    expect_same_picture(hashes_[strategy], hash, what_ + with);
    if (hash == first_) return;
    const size_t differ = different_pixels(rgb, reference_);
    if (differ * pixels_a_tie > rgb.size() / 3)
        throw scenes::Failure("the picture of " + what_ + with + " differs in " + std::to_string(differ) +
                              " pixels, so the times are not comparable");
    max_ties_ = std::max(max_ties_, differ);
}

}  // namespace cli
