// Textures for plain pictures: every texel in its zone's colour, for each texture set.
#pragma once

#include <map>
#include <tuple>

#include "lib/model/template.h"
#include "tests/gl/support/host_gl.h"

namespace gltest
{

namespace model = claque::model;

// Uploads each once; the destructor deletes them all.
class Uploads
{
public:
    explicit Uploads(const HostGl &host) : host_(host) {}
    ~Uploads();
    Uploads(const Uploads &) = delete;
    Uploads &operator=(const Uploads &) = delete;

    // GL's name. Adds a test failure if a texel's alpha is no key.
    uint32_t of(const model::Texture &texture, uint32_t set, const uint8_t *zone_rgb);

private:
    const HostGl &host_;
    std::map<std::tuple<const model::Texture *, uint32_t, const uint8_t *>, uint32_t> names_;
};

}  // namespace gltest
