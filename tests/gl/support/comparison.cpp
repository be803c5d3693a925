// Compares pictures pixel by pixel: wrong pixels, holes, and pixels that may differ because depths tie.
#include <cstring>

#include <gtest/gtest.h>

#include "tests/gl/support/pictures.h"

namespace gltest
{

Wanted wanted_of(contexts::Offscreen &context, const PosedModel &posed, const Camera &camera)
{
    const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
    return {draw_plain(context, posed, camera, colours.data()), draw_ids(context, posed, camera, Order::forwards),
            draw_ids(context, posed, camera, Order::backwards)};
}

Comparison compare(const Wanted &wanted, const Picture &coloured)
{
    Comparison result;
    for (size_t i = 0; i < wanted.plain.size(); i += 3) {
        const auto same = [i](const uint8_t *a, const Picture &b) { return std::memcmp(a, &b[i], 3) == 0; };
        const bool covered = !same(background, wanted.plain);
        const bool tie = !wanted.forwards.empty() && !same(&wanted.forwards[i], wanted.backwards);
        result.covered += covered;
        result.holes += covered && same(background, coloured);
        result.ties += covered && tie;
        result.wrong += !tie && !same(&wanted.plain[i], coloured);
    }
    return result;
}

Comparison Verdict::hold(const Wanted &wanted, const Picture &coloured, double least_share)
{
    const Comparison c = compare(wanted, coloured);
    EXPECT_GE(c.covered, least_share * double(coloured.size() / 3)) << "the view shows too little";
    EXPECT_EQ(c.wrong, 0u) << "of " << c.covered << " pixels";
    EXPECT_EQ(c.holes, 0u) << "of " << c.covered << " pixels";
    covered_ += c.covered, ties_ += c.ties;
    return c;
}

Verdict::~Verdict()
{
    EXPECT_LE(double(ties_), most_ties_share * double(covered_)) << "pixels tie in depth, of " << covered_;
}

}  // namespace gltest
