#include "lib/lod/decimation/zone_area_cost.h"

#include <algorithm>

#include "lib/lod/surface/quadric.h"
#include "lib/lod/surface/surface_samples.h"
#include "lib/lod/surface/visibility.h"

namespace claque::lod
{

namespace
{

// Beyond this error of an area fraction, a zone's cost grows with the third power, so that no zone reaches two points.
constexpr double steep = 0.01;

// Rays are cast again when so much of the triangles is left: what is seen of the others hardly changes.
constexpr double recast = 0.9;

constexpr size_t hole = size_t(-1);  // in place of a zone

// Of all faces together. A face that shows two zones counts for the zone of its centre where it has one sample only;
// with this many, levels of some hundred triangles keep their zones.
constexpr size_t samples = 16384;

// Barycentric coordinates of the centres of n x n triangles that a face is cut into.
std::vector<glm::vec3> points_of(size_t faces)
{
    int n = 1;
    while (n < 4 && faces * size_t((n + 1) * (n + 1)) <= samples) ++n;
    std::vector<glm::vec3> points;
    for (int a = 0; a < n; ++a)
        for (int b = 0; a + b < n; ++b) {
            const auto add = [&](float third) {
                const float x = (float(a) + third) / float(n), y = (float(b) + third) / float(n);
                points.emplace_back(x, y, 1 - x - y);
            };
            add(1 / 3.0f);
            if (a + b + 1 < n) add(2 / 3.0f);
        }
    return points;
}

}  // namespace

ZoneAreaCost::ZoneAreaCost(const WeldedSurface &surface, const model::Model &model, double weight)
    : surface_(surface),
      model_(model),
      weight_(weight),
      visibility_(surface.mesh.n_faces(), 0),
      zones_(surface.mesh.n_faces(), 0)
{
    area_ = measure_zones(source_fractions_);
    area_fractions_ = source_fractions_;
}

void ZoneAreaCost::measure() { measure_zones(area_fractions_); }

size_t ZoneAreaCost::zone_of(Mesh::FaceHandle face, glm::vec3 at) const
{
    const Corners &corners = surface_.mesh.property(surface_.corners, face);
    glm::vec2 uv(0);
    for (int k = 0; k < 3; ++k) uv += surface_.uv(corners.corner[size_t(k)]) * at[k];
    const model::Part &part = surface_.part(surface_.part_of(corners.corner[0]));
    return is_hole(model_, part, uv) ? hole : std::min<size_t>(zone_at(model_, part, uv), model_.zones.size());
}

double ZoneAreaCost::measure_zones(std::vector<double> &area_fractions)
{
    std::vector<VisibilityQuery> queries;
    std::vector<size_t> faces;
    for (const Mesh::FaceHandle face : surface_.mesh.all_faces()) {
        if (surface_.mesh.status(face).deleted()) continue;
        const Corners &corners = surface_.mesh.property(surface_.corners, face);
        VisibilityQuery query;
        for (size_t k = 0; k < 3; ++k) query.corners[k] = point(surface_.mesh, Mesh::VertexHandle(corners.at[k]));
        const model::Part &part = surface_.part(surface_.part_of(corners.corner[0]));
        query.two_sided = is_two_sided(model_, part), query.has_holes = has_holes(model_, part);
        queries.push_back(query);
        faces.push_back(static_cast<size_t>(face.idx()));
        zones_[faces.back()] = zone_of(face, glm::vec3(1 / 3.0f));
    }
    if (faces_at_cast_ == 0 || double(faces.size()) <= recast * double(faces_at_cast_)) {
        const std::vector<double> visibility = visibility_of(queries, VisibilityQuality::fast);
        for (size_t i = 0; i < faces.size(); ++i) visibility_[faces[i]] = visibility[i];
        faces_at_cast_ = faces.size();
    }
    area_fractions.assign(model_.zones.size() + 1, 0);
    double all = 0;
    const std::vector<glm::vec3> points = points_of(faces.size());
    for (size_t i = 0; i < faces.size(); ++i) {
        const auto &c = queries[i].corners;
        const double area = visibility_[faces[i]] * TriangleFrame(c[0], c[1], c[2]).area;
        const Mesh::FaceHandle face(static_cast<int>(faces[i]));
        size_t shown = 0;
        for (const glm::vec3 &at : points) {
            const size_t zone = zone_of(face, at);
            if (zone == hole) continue;
            ++shown, area_fractions[zone] += area / double(points.size());
        }
        all += shown == points.size() ? area : area * double(shown) / double(points.size());
    }
    for (double &share : area_fractions) share = all > 0 ? share / all : 0;
    return all;
}

void ZoneAreaCost::change(Mesh::FaceHandle face, double area)
{
    const size_t i = static_cast<size_t>(face.idx());
    if (zones_[i] != hole) changes_.emplace_back(zones_[i], visibility_[i] * area);
}

double ZoneAreaCost::slope(size_t zone) const
{
    const double off = area_fractions_[zone] - source_fractions_[zone];
    return off * (1 + off * off / (steep * steep));
}

double ZoneAreaCost::cost()
{
    double all = 0, sum = 0;
    for (const auto &[zone, area] : changes_) all += area, sum += area * slope(zone);
    // A change of the total area changes the fractions of all zones.
    for (size_t zone = 0; zone < area_fractions_.size(); ++zone) sum -= all * area_fractions_[zone] * slope(zone);
    changes_.clear();
    return weight_ * area_ * sum;
}

}  // namespace claque::lod
