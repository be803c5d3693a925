// Scenery in pieces: what stands apart has a bounding sphere and is drawn, or left out, by itself. All pieces of one
// material lie in one pair of vertex and index arrays, so that a picture of the whole takes few calls.
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

#include <array>
#include <cstddef>

namespace scenes::town
{

// In the order in which they are drawn: the ground first, what lies on it, what stands on it.
enum class SurfaceKind : uint8_t { land, furrows, paving, cobbles, water, shade, stone, facades, tiles, leaves };
constexpr size_t surface_kind_count = 10;

struct Sphere {
    Vec3 centre;
    float radius;
};

// Six planes that look inwards.
class Frustum
{
public:
    // Of the eye's picture; scale < 1: of the part in the middle of it, so much smaller either way.
    explicit Frustum(const Eye &eye, float scale = 1);
    bool meets(const Sphere &sphere) const;

private:
    std::array<std::array<float, 4>, 6> planes_;  // normal of length 1, and the distance of the origin
};

// Whether something shows from everywhere, or only from near or from far: fine things, and what stands in for them.
enum class Visibility : uint8_t { always, near, far };
constexpr float near_m = 115;  // to the surface of a piece's sphere

struct Span {
    SurfaceKind layer;
    Visibility seen;
    uint32_t first, count;  // indices of its layer
};

struct Piece {
    enum class Kind : uint8_t { ground, shade, house, landmark, tree, wood } kind;
    Sphere sphere;
    std::vector<Span> spans;
};

class Pieces
{
public:
    explicit Pieces(const std::array<float, surface_kind_count> &texture_metres);

    // Where to add what is being built; finish() makes one piece of all that came since the last.
    Geometry &on(SurfaceKind layer) { return layers_[static_cast<size_t>(layer)]; }
    const Geometry &on(SurfaceKind layer) const { return layers_[static_cast<size_t>(layer)]; }
    void finish(Piece::Kind kind);
    // Of what is added from now on, until the piece is finished.
    void from_now(Visibility seen);

    const std::vector<Piece> &all() const { return pieces_; }
    size_t triangles() const;
    // What is to be drawn: the indices of each layer.
    using Choice = std::array<std::vector<uint32_t>, surface_kind_count>;
    // Pieces that meet a frustum (null: all), as they are seen from a point. Returns how many triangles that is.
    size_t choose(const Frustum *cull, const double (&eye)[3], Choice &choice) const;
    // One call of GL.
    void draw(const Gl &gl, SurfaceKind layer, const Choice &choice) const;

private:
    std::vector<Geometry> layers_;
    std::array<uint32_t, surface_kind_count> done_ = {};
    std::vector<Piece> pieces_;
    std::vector<Span> open_;  // of the piece that is being built
    Visibility visibility_ = Visibility::always;
};

}  // namespace scenes::town
