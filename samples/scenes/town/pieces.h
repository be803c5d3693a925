// Scenery in pieces: each separate object has a bounding sphere and is drawn, or left out, by itself. All pieces of
// one material share one pair of vertex and index arrays, so that the whole picture takes few calls.
#pragma once

#include <array>
#include <cstddef>

#include "samples/scenes/frustum.h"
#include "samples/scenes/geometry.h"

namespace scenes::town
{

// The ground first, then its coverings, then the objects on it.
enum class SurfaceKind : uint8_t { land, furrows, paving, cobbles, water, shade, stone, facades, tiles, leaves };
constexpr size_t surface_kind_count = 10;

// Distances at which a piece shows: always, or only near (fine detail), or only far (its replacement).
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

    // The geometry under construction; finish() makes one piece of everything added since the last one.
    Geometry &on(SurfaceKind layer) { return layers_[static_cast<size_t>(layer)]; }
    const Geometry &on(SurfaceKind layer) const { return layers_[static_cast<size_t>(layer)]; }
    void finish(Piece::Kind kind);
    // Applies to everything added from now on, until the piece is finished.
    void from_now(Visibility seen);

    const std::vector<Piece> &all() const { return pieces_; }
    size_t triangles() const;
    // The selection to draw: the indices of each layer.
    struct Choice {
        std::array<std::vector<uint32_t>, surface_kind_count> indices;
        std::vector<std::pair<double, uint32_t>> order;  // of the pieces, by distance
    };
    // Selects pieces that meet a frustum (null: all), as seen from a point. Returns the number of triangles.
    size_t choose(const Frustum *cull, const double (&eye)[3], Choice &choice) const;
    // One GL call.
    void draw(const Gl &gl, SurfaceKind layer, const Choice &choice) const;

private:
    std::vector<Geometry> layers_;
    std::array<uint32_t, surface_kind_count> done_ = {};
    std::vector<Piece> pieces_;
    std::vector<Span> open_;  // of the piece under construction
    Visibility visibility_ = Visibility::always;
};

}  // namespace scenes::town
