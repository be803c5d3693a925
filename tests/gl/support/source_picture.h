// The picture of a model as its file gives it: its own triangles, UVs, images and zone keys, drawn plainly. Nothing of
// it comes from the splitter, so that it shows where the splitter is wrong about zones.
#pragma once

#include "tests/gl/support/pictures.h"
#include "tests/gl/support/source_zones.h"

namespace gltest
{

// What is drawn of a model at the first level of a template, which is the model split; in GL until it is destroyed.
class SourceLook
{
public:
    // Zones have the colours of the template's zones of their names.
    SourceLook(contexts::Offscreen &context, SourceImages &images, const model::Template &tmpl, const uint8_t *zone_rgb,
               uint32_t texture_set = 0);
    ~SourceLook();
    SourceLook(const SourceLook &) = delete;
    SourceLook &operator=(const SourceLook &) = delete;

    // In a pose of the template's: only the places of its vertices are taken from it, for vertices of the model at the
    // same place of the bind pose that follow the same joints. With the matrix loaded.
    void draw(const float *positions) const;

private:
    struct Piece {  // of one part
        uint32_t texture = 0;
        bool masked = false, double_sided = false;
        std::vector<glm::vec2> uvs;
        std::vector<uint32_t> vertices, corners;
    };
    HostGl host_;
    std::vector<Piece> pieces_;
};

struct Posed {
    const SourceLook *look;
    const float *positions;
    const float *model_view;  // [16]
};
Picture draw_source(contexts::Offscreen &context, const std::vector<Posed> &all, const float (&projection)[16]);

}  // namespace gltest
