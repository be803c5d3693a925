// An image with its smaller copies, as a GL 1.1 texture.
#pragma once

#include "samples/scenes/gl.h"

#include <cstdint>
#include <vector>

namespace scenes
{

struct Image {
    int side_px = 0;            // a power of two; images of scenery are square
    std::vector<uint8_t> rgba;  // [4 * side_px * side_px], the row at v = 0 first
};

// Belongs to the context that is current when it is made, and must be ended while that is current.
class Texture
{
public:
    enum class Filter { trilinear, nearest };  // nearest: of the nearest copy, a quarter of the time on software GL
    Texture(const Gl &gl, const Image &image, bool repeats, Filter filter = Filter::trilinear);
    ~Texture();
    Texture(const Texture &) = delete;
    Texture &operator=(const Texture &) = delete;

    void use() const;  // binds it and switches texturing on, with GL_MODULATE

private:
    const Gl &gl_;
    unsigned id_ = 0;
};

}  // namespace scenes
