#include "samples/parity/write/id_pictures.h"

#include <claque/visibility.h>

#include <algorithm>

namespace parity
{

using scenes::check;

namespace
{

// Numbers, rows from the bottom up. Pictures of parity show fewer than 2^24 triangles.
std::vector<uint32_t> numbers_of(scenes::SceneRenderer &scene_renderer)
{
    uint64_t count = 0;
    check(clq_view_get_triangle_count(scene_renderer.view(), &count));
    if (count >= 1u << 24)
        throw scenes::Failure("the picture shows " + std::to_string(count) +
                              " triangles, and id pictures are for fewer than 2^24");
    const scenes::Gl &gl = scene_renderer.gl();
    gl.DepthMask(1);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(scenes::gl::color_buffer_bit | scenes::gl::depth_buffer_bit);
    check(clq_renderer_draw_visibility(scene_renderer.renderer(), scene_renderer.view(), nullptr, nullptr));
    std::vector<uint8_t> rgb;
    const contexts::Offscreen &context = scene_renderer.offscreen();
    context.read_rgb(rgb);
    std::vector<uint32_t> numbers;
    for (size_t row = static_cast<size_t>(context.height()); row-- > 0;)
        for (size_t i = 3 * row * static_cast<size_t>(context.width());
             i < 3 * (row + 1) * static_cast<size_t>(context.width()); i += 3)
            numbers.push_back(rgb[i] | static_cast<uint32_t>(rgb[i + 1]) << 8 |
                              static_cast<uint32_t>(rgb[i + 2]) << 16);
    return numbers;
}

template <class Value>
void turn_rows(std::vector<Value> &values, size_t width)
{
    for (size_t low = 0, high = values.size() / width; low + 1 < high; ++low)
        std::swap_ranges(values.begin() + static_cast<std::ptrdiff_t>(low * width),
                         values.begin() + static_cast<std::ptrdiff_t>((low + 1) * width),
                         values.begin() + static_cast<std::ptrdiff_t>(--high * width));
}

}  // namespace

IdPictures id_pictures(scenes::SceneRenderer &scene_renderer)
{
    const std::vector<uint32_t> numbers = numbers_of(scene_renderer);
    const contexts::Offscreen &context = scene_renderer.offscreen();
    clq_pixels pixels = clq_pixels_init();
    pixels.width_px = static_cast<uint32_t>(context.width()),
    pixels.height_px = static_cast<uint32_t>(context.height());
    pixels.numbers = numbers.data();
    IdPictures out;
    out.actor.resize(numbers.size());
    std::vector<uint32_t> zones(numbers.size());
    clq_pixel_channels channels = clq_pixel_channels_init();
    channels.actors = out.actor.data(), channels.zones = zones.data();
    check(clq_view_get_pixels(scene_renderer.view(), &pixels, &channels));
    for (const uint32_t zone : zones) out.zone.push_back(static_cast<uint16_t>(zone == CLQ_NONE ? 0 : zone + 1));
    turn_rows(out.actor, pixels.width_px);
    turn_rows(out.zone, pixels.width_px);
    return out;
}

}  // namespace parity
