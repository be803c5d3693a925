// Compares pictures pixel by pixel: wrong pixels, holes, and pixels that may differ because depths tie.
#include <cstring>

#include "tests/gl/support/pictures.h"

namespace gltest
{

using claque::draw::DrawList;

Comparison compare(const Picture &plain, const Picture &coloured, const Picture &forwards, const Picture &backwards)
{
    Comparison result;
    for (size_t i = 0; i < plain.size(); i += 3) {
        const auto same = [i](const uint8_t *a, const Picture &b) { return std::memcmp(a, &b[i], 3) == 0; };
        const bool covered = !same(background, plain), tie = !same(&forwards[i], backwards);
        result.covered += covered;
        result.holes += covered && same(background, coloured);
        result.ties += covered && tie;
        result.wrong += !tie && !same(&plain[i], coloured);
    }
    return result;
}

Comparison zone_law(contexts::Offscreen &context, passes::Renderer &renderer, const PosedModel &posed,
                    const Camera &camera)
{
    const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
    const DrawList list = list_of(posed, camera, colours.data());
    return compare(draw_plain(context, posed, camera, colours.data()), draw(context, renderer, list),
                   draw_ids(context, posed, camera, Order::forwards),
                   draw_ids(context, posed, camera, Order::backwards));
}

}  // namespace gltest
