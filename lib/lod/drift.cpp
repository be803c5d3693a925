#include "lib/lod/drift.h"

#include <algorithm>

#include "lib/lod/quadric.h"
#include "lib/lod/samples.h"
#include "lib/lod/seen.h"

namespace claque::lod
{

namespace
{

// Of a share: off by more, what a zone costs grows with the third power, so that none comes to two points.
constexpr double steep = 0.006;

}  // namespace

ZoneDrift::ZoneDrift(const Surface &surface, const model::Model &model, double weight, const base::Jobs &jobs)
    : surface_(surface),
      model_(model),
      jobs_(jobs),
      weight_(weight),
      seen_(surface.mesh.n_faces(), 0),
      zones_(surface.mesh.n_faces(), 0)
{
    area_ = look(wanted_);
    shares_ = wanted_;
}

void ZoneDrift::measure() { look(shares_); }

size_t ZoneDrift::zone_of(Mesh::FaceHandle face) const
{
    const Corners &corners = surface_.mesh.property(surface_.corners, face);
    glm::vec2 uv(0);
    for (const uint32_t corner : corners.corner) uv += surface_.uv(corner) / 3.0f;
    const model::Part &part = surface_.part(surface_.part_of(corners.corner[0]));
    return std::min<size_t>(zone_at(model_, part, uv), model_.zones.size());
}

double ZoneDrift::look(std::vector<double> &shares)
{
    std::vector<Side> sides;
    std::vector<size_t> faces;
    for (const Mesh::FaceHandle face : surface_.mesh.all_faces()) {
        if (surface_.mesh.status(face).deleted()) continue;
        const Corners &corners = surface_.mesh.property(surface_.corners, face);
        Side side;
        for (size_t k = 0; k < 3; ++k) side.corners[k] = point(surface_.mesh, Mesh::VertexHandle(corners.at[k]));
        side.both = is_two_sided(model_, surface_.part(surface_.part_of(corners.corner[0])));
        sides.push_back(side);
        faces.push_back(static_cast<size_t>(face.idx()));
        zones_[faces.back()] = zone_of(face);
    }
    const std::vector<double> seen = seen_of(sides, Care::haste, jobs_);
    shares.assign(model_.zones.size() + 1, 0);
    double all = 0;
    for (size_t i = 0; i < faces.size(); ++i) {
        const auto &c = sides[i].corners;
        const double area = seen[i] * TriangleFrame(c[0], c[1], c[2]).area;
        seen_[faces[i]] = seen[i];
        shares[zones_[faces[i]]] += area, all += area;
    }
    for (double &share : shares) share = all > 0 ? share / all : 0;
    return all;
}

void ZoneDrift::change(Mesh::FaceHandle face, double area)
{
    const size_t i = static_cast<size_t>(face.idx());
    changes_.emplace_back(zones_[i], seen_[i] * area);
}

double ZoneDrift::slope(size_t zone) const
{
    const double off = shares_[zone] - wanted_[zone];
    return off * (1 + off * off / (steep * steep));
}

double ZoneDrift::cost()
{
    double all = 0, sum = 0;
    for (const auto &[zone, area] : changes_) all += area, sum += area * slope(zone);
    // Shares of all zones change when the whole does.
    for (size_t zone = 0; zone < shares_.size(); ++zone) sum -= all * shares_[zone] * slope(zone);
    changes_.clear();
    return weight_ * area_ * sum;
}

}  // namespace claque::lod
