// An image with its mipmaps, as a GL 1.1 texture.
#pragma once

#include <cstdint>
#include <vector>

#include "samples/scenes/gl.h"

namespace scenes
{

struct Image {
    int side_px = 0;            // a power of two; images of scenery are square
    std::vector<uint8_t> rgba;  // [4 * side_px * side_px], the row at v = 0 first
};

// Belongs to the context that is current at construction, which must also be current at destruction.
class Texture
{
public:
    // bilinear and nearest: from the nearest mipmap. On software GL they take two thirds and half of the time.
    enum class Filter { trilinear, bilinear, nearest };
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
