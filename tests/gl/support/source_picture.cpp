#include "tests/gl/support/source_picture.h"

#include <algorithm>
#include <cstring>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/pose/pose.h"

namespace gltest
{
namespace
{

constexpr gl::Enum mirrored_repeat = 0x8370, clamp_to_edge = 0x812F;  // of later GL: Mesa's own wrapping is the judge

// By name, so that the order of zones in the template does not matter.
const uint8_t *colour_of(const std::string &zone, const model::Template &tmpl, const uint8_t *zone_rgb)
{
    for (uint32_t i = 0; i < tmpl.zone_count(); ++i)
        if (std::string(tmpl.zone_names[i].begin(), tmpl.zone_names[i].end()) == zone) return zone_rgb + 3 * size_t(i);
    ADD_FAILURE() << "the template has no zone " << zone;
    return zone_rgb;
}

std::vector<uint8_t> painted(const ZoneTexels &texels, const model::Model &source, const model::Template &tmpl,
                             const uint8_t *zone_rgb)
{
    const std::vector<std::string> names = zone_names_of(source);
    std::map<uint16_t, const uint8_t *> colours;
    std::vector<uint8_t> rgba;
    for (const uint16_t zone : texels.zones) {
        const auto [found, is_new] = colours.emplace(zone, nullptr);
        if (is_new) found->second = colour_of(names[zone == hole ? 0 : zone], tmpl, zone_rgb);
        rgba.insert(rgba.end(), found->second, found->second + 3);
        rgba.push_back(zone == hole ? 0 : 255);
    }
    return rgba;
}

int32_t wrap_of(model::Wrap wrap, bool unfolded)
{
    return int32_t(wrap == model::Wrap::clamp                 ? clamp_to_edge
                   : wrap == model::Wrap::mirror && !unfolded ? mirrored_repeat
                                                              : gl::repeat);
}

uint32_t upload(const HostGl &host, const ZoneTexels &texels, const std::vector<uint8_t> &rgba,
                const model::Material &material)
{
    uint32_t name = 0;
    host.GenTextures(1, &name);
    host.BindTexture(gl::texture_2d, name);
    host.TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::wrap_s, wrap_of(material.wrap_s, texels.unfolded_s));
    host.TexParameteri(gl::texture_2d, gl::wrap_t, wrap_of(material.wrap_t, texels.unfolded_t));
    host.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(texels.width), int32_t(texels.height), 0, gl::rgba,
                    gl::unsigned_byte, rgba.data());
    return name;
}

using Place = std::array<uint32_t, 3>;  // the bits of a position, so that equal means equal

Place place_of(const float *p)
{
    Place place;
    const float numbers[3] = {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};  // no negative zero
    std::memcpy(place.data(), numbers, sizeof numbers);
    return place;
}

// What a vertex follows, with a weight.
std::vector<uint32_t> sorted(std::vector<uint32_t> joints)
{
    std::sort(joints.begin(), joints.end());
    return joints;
}

struct Known {
    uint32_t vertex;
    std::vector<uint32_t> joints;
    std::vector<Place> morphs;  // that move it, sorted
};
using KnownVertices = std::map<Place, std::vector<Known>>;

KnownVertices vertices_of(const model::Level &level)
{
    KnownVertices vertices;
    std::map<uint32_t, std::vector<Place>> morphs;
    for (const model::MorphDelta &delta : level.morph_deltas)
        if (place_of(delta.position) != Place()) morphs[delta.vertex].push_back(place_of(delta.position));
    for (auto &[vertex, places] : morphs) std::sort(places.begin(), places.end());
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t i = 0; i < run.count; ++i) {
            std::vector<uint32_t> joints;
            for (uint32_t k = 0; k < run.influences; ++k) {
                const size_t at = size_t(run.first_influence) + size_t(i) * run.influences + k;
                if (level.weights[at] != 0) joints.push_back(level.joints[at]);
            }
            const uint32_t vertex = run.first + i;
            vertices[place_of(level.positions.data() + 3 * size_t(vertex))].push_back(
                {vertex, sorted(std::move(joints)), morphs[vertex]});
        }
    return vertices;
}

// model::none: the template has no such vertex. Joints that stop at a level hand their vertices to others.
uint32_t vertex_of(const model::Part &part, size_t index, const KnownVertices &known)
{
    const auto found = known.find(place_of(&part.positions[index].x));
    if (found == known.end()) return model::none;
    std::vector<uint32_t> joints;
    for (size_t k = index * part.influence_count; k < (index + 1) * part.influence_count; ++k)
        if (part.weights[k] != 0) joints.push_back(part.joints[k]);
    joints = sorted(std::move(joints));
    std::vector<Place> morphs;
    for (const model::MorphTarget &target : part.morphs)
        if (!target.positions.empty() && place_of(&target.positions[index].x) != Place())
            morphs.push_back(place_of(&target.positions[index].x));
    std::sort(morphs.begin(), morphs.end());
    for (const Known &one : found->second)
        if (one.joints == joints && one.morphs == morphs) return one.vertex;
    for (const Known &one : found->second)
        if (one.joints == joints) return one.vertex;
    return found->second[0].vertex;
}

bool has_area(const model::Part &part, const std::array<uint32_t, 3> &t)
{
    const glm::dvec3 a = part.positions[t[0]], b = part.positions[t[1]], c = part.positions[t[2]];
    return glm::length(glm::cross(b - a, c - a)) > 0;
}

// [palette] whether an entry mirrors at rest.
std::vector<bool> mirrors_of(const model::Rig &rig)
{
    claque::pose::Workspace workspace(rig);
    std::vector<bool> mirrors;
    for (const claque::math::Affine &m : workspace.pose(model::none, 0)) {
        const glm::dvec3 x(m.c[0], m.c[1], m.c[2]), y(m.c[3], m.c[4], m.c[5]), z(m.c[6], m.c[7], m.c[8]);
        mirrors.push_back(glm::dot(glm::cross(x, y), z) < 0);
    }
    return mirrors;
}

// A front face is the one that looks like it at rest, where what most of the triangle follows may mirror it.
std::array<uint32_t, 3> turned(const model::Part &part, const std::array<uint32_t, 3> &t,
                               const std::vector<bool> &mirrors)
{
    std::map<uint32_t, float> weights;
    for (const uint32_t v : t)
        for (size_t k = size_t(v) * part.influence_count; k < size_t(v + 1) * part.influence_count; ++k)
            weights[part.joints[k]] += part.weights[k];
    const auto most = std::max_element(weights.begin(), weights.end(),
                                       [](const auto &a, const auto &b) { return a.second < b.second; });
    const bool turns = most != weights.end() && mirrors[most->first];
    return {t[0], t[turns ? 2 : 1], t[turns ? 1 : 2]};
}

bool is_at(const model::Part &part, float distance_m)
{
    return model::is_drawn(part) && part.lod_min_m <= distance_m && distance_m < part.lod_max_m;
}

}  // namespace

SourceLook::SourceLook(contexts::Offscreen &context, SourceImages &images, const model::Template &tmpl,
                       const uint8_t *zone_rgb, uint32_t texture_set)
    : host_(context)
{
    const model::Model &source = images.source();
    const KnownVertices known = vertices_of(tmpl.levels[0]);
    const std::vector<bool> mirrors = mirrors_of(source.rig);
    for (const model::Part &part : source.parts) {
        if (!is_at(part, tmpl.levels[0].switch_distance_m)) continue;
        const model::Material &material = source.materials[part.material];
        const ZoneTexels &texels = images.of(part.material, texture_set);
        Piece piece;
        piece.texture = upload(host_, texels, painted(texels, source, tmpl, zone_rgb), material);
        piece.masked = std::count(texels.zones.begin(), texels.zones.end(), hole) > 0;
        piece.double_sided = material.double_sided;
        piece.uvs = part.uvs;
        piece.uvs.resize(part.positions.size(), glm::vec2(0));
        for (glm::vec2 &uv : piece.uvs) uv *= glm::vec2(texels.unfolded_s ? 0.5f : 1, texels.unfolded_t ? 0.5f : 1);
        for (size_t v = 0; v < part.positions.size(); ++v) piece.vertices.push_back(vertex_of(part, v, known));
        for (const std::array<uint32_t, 3> &t : model::triangles_of(part)) {
            const bool missing =
                std::any_of(t.begin(), t.end(), [&](uint32_t v) { return piece.vertices[v] == model::none; });
            const std::array<uint32_t, 3> corners = turned(part, t, mirrors);
            if (!missing) piece.corners.insert(piece.corners.end(), corners.begin(), corners.end());
            else EXPECT_FALSE(has_area(part, t)) << "a triangle of part " << part.name << " is not in the template";
        }
        for (uint32_t &vertex : piece.vertices) vertex = vertex == model::none ? 0 : vertex;
        pieces_.push_back(std::move(piece));
    }
    EXPECT_FALSE(pieces_.empty()) << "the model has nothing from " << tmpl.levels[0].switch_distance_m << " m on";
}

SourceLook::~SourceLook()
{
    for (const Piece &piece : pieces_) host_.DeleteTextures(1, &piece.texture);
}

void SourceLook::draw(const float *positions) const
{
    for (const Piece &piece : pieces_) {
        std::vector<float> places;
        for (const uint32_t vertex : piece.vertices)
            places.insert(places.end(), positions + 3 * size_t(vertex), positions + 3 * size_t(vertex) + 3);
        host_.BindTexture(gl::texture_2d, piece.texture);
        host_.Enable(gl::texture_2d);
        host_.TexEnvi(gl::texture_env, gl::texture_env_mode, int32_t(gl::modulate));
        piece.masked ? host_.Enable(gl::alpha_test) : host_.Disable(gl::alpha_test);
        host_.AlphaFunc(gl::gequal, 0.5f);
        host_.EnableClientState(gl::texture_coord_array);
        host_.TexCoordPointer(2, gl::real, 0, piece.uvs.data());
        host_.VertexPointer(3, gl::real, 0, places.data());
        host_.FrontFace(gl::ccw);
        host_.CullFace(gl::back);
        piece.double_sided ? host_.Disable(gl::cull_face) : host_.Enable(gl::cull_face);
        host_.Color4ub(255, 255, 255, 255);
        host_.DrawElements(gl::triangles, int32_t(piece.corners.size()), gl::unsigned_int, piece.corners.data());
    }
}

Picture draw_source(contexts::Offscreen &context, const std::vector<Posed> &all, const float (&projection)[16])
{
    const HostGl host(context);
    Picture picture = begin_picture(context, host, background);
    plain_state(host, projection);
    for (const Posed &one : all) {
        host.LoadMatrixf(one.model_view);
        one.look->draw(one.positions);
    }
    context.read_rgb(picture);
    end_plain_state(host);
    return picture;
}

}  // namespace gltest
