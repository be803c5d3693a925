// Flat rectangles side by side that fill the picture and face the eye, and lights to see them by.
#pragma once

#include <cmath>

#include "tests/gl/support/fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{

using Rgb = std::array<uint8_t, 3>;

inline std::array<float, 3> unit_of(const Rgb &rgb)
{
    return {float(rgb[0]) / 255.0f, float(rgb[1]) / 255.0f, float(rgb[2]) / 255.0f};
}

struct Plate {
    Rgb colour;
    model::Lighting lighting;
};

inline model::Lighting unlit()
{
    model::Lighting lighting;
    lighting.unlit = true;
    return lighting;
}
inline model::Lighting emitting(const Rgb &rgb)
{
    model::Lighting lighting;
    lighting.emission = unit_of(rgb);
    return lighting;
}

// A character of such plates, from left to right; each has a material and a zone of its own. Clip space is its own.
inline model::Model model_of(const std::vector<Plate> &plates)
{
    model::Model made;
    made.name = "plates";
    made.rig.parents.push_back(model::none);
    made.rig.rest.emplace_back();
    made.rig.node_names.emplace_back("root");
    made.rig.palette.emplace_back();
    const float width = 2.0f / float(plates.size());
    for (uint32_t i = 0; i < plates.size(); ++i) {
        model::Zone zone;
        zone.name = "plate " + std::to_string(i);
        zone.colour = unit_of(plates[i].colour);
        made.zones.push_back(zone);
        model::Material material;
        std::copy(zone.colour.begin(), zone.colour.end(), material.base_colour.begin());
        material.lighting = plates[i].lighting;
        material.zone = i;
        made.materials.push_back(material);
        model::Part part;
        part.node = 0, part.material = i;
        const float left = -1 + width * float(i), right = left + width;
        part.positions = {{left, -1, 0}, {right, -1, 0}, {right, 1, 0}, {left, 1, 0}};
        part.normals.assign(4, glm::vec3(0, 0, 1));
        part.indices = {0, 1, 2, 0, 2, 3};
        part.joints.assign(4, 0), part.weights.assign(4, 1);
        made.parts.push_back(part);
    }
    return made;
}

class PlateTest : public GlTest
{
protected:
    static claque::draw::DrawList list_of_one(const PosedModel &posed)
    {
        constexpr float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        Individual one = {posed.tmpl.get(), posed.positions.data(), posed.normals.data(), nullptr, {}, 0};
        std::copy_n(identity, 16, one.model_view);
        return list_of({one}, identity);
    }
    Picture shown(const PosedModel &posed, const passes::RendererOptions &options = {},
                  passes::DrawStats *stats = nullptr)
    {
        const auto renderer = make_renderer_of(posed, options);
        const Picture picture = draw(*context_, *renderer, list_of_one(posed));
        if (stats) {
            EXPECT_TRUE(renderer->draw(list_of_one(posed), stats).ok());
        }
        renderer->destroy();
        return picture;
    }
    // The colour in the middle of plate i of `plates`.
    static Rgb at(const Picture &picture, size_t i, size_t plates)
    {
        const size_t x = size_t(width) * (2 * i + 1) / (2 * plates), at = 3 * (size_t(width) * (height / 2) + x);
        return {picture[at], picture[at + 1], picture[at + 2]};
    }

    enum class Lights { off, none, grey, bright };
    static constexpr Lights all_lights[] = {Lights::off, Lights::none, Lights::grey, Lights::bright};
    void set(Lights lights) const
    {
        const float ambient = lights == Lights::grey ? 0.4f : 0, scene[4] = {ambient, ambient, ambient, 1};
        const float direction[4] = {0, 0, 1, 0}, white[4] = {1, 1, 1, 1};
        host_->LightModelfv(0x0B53, scene);  // GL_LIGHT_MODEL_AMBIENT
        host_->Lightfv(0x4000, 0x1203, direction);
        host_->Lightfv(0x4000, 0x1201, white);
        lights == Lights::bright ? host_->Enable(0x4000) : host_->Disable(0x4000);
        lights == Lights::off ? host_->Disable(gl::lighting) : host_->Enable(gl::lighting);
    }
};

}  // namespace gltest
