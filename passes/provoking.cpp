#include "passes/provoking.h"

#include <algorithm>
#include <map>
#include <set>

#include <glm/geometric.hpp>

namespace claque::passes
{
namespace
{

constexpr float min_cosine = 0.5f;  // between the normals of triangles that are lit as one

// Greedy choice of vertices: each time the vertex at which most triangles can end together. Vertices that are sent
// anyway, because no triangle ends there yet, come first.
class Choice
{
public:
    explicit Choice(const std::vector<FlatTriangle> &triangles)
        : triangles_(triangles), is_open_(triangles.size(), true)
    {
    }

    std::vector<Provoking> run()
    {
        for (Provoking best = find_best(); !best.triangles.empty(); best = find_best()) {
            for (const uint32_t t : best.triangles) is_open_[t] = false;
            taken_.insert(best.vertex);
            made_.push_back(std::move(best));
        }
        return std::move(made_);
    }

private:
    Provoking find_best() const
    {
        std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> open;  // by welded vertex and colour entry
        for (uint32_t t = 0; t < triangles_.size(); ++t)
            if (is_open_[t])
                for (const uint32_t vertex : triangles_[t].vertices)
                    open[{vertex, triangles_[t].colour_entry}].push_back(t);
        Provoking best;
        for (const auto &[where, candidates] : open) {
            std::vector<uint32_t> together = most_alike(candidates);
            const bool is_free = !taken_.count(where.first), best_free = !taken_.count(best.vertex);
            if (!best.triangles.empty() &&
                (is_free != best_free ? best_free : together.size() <= best.triangles.size()))
                continue;
            best = {where.first, where.second, std::move(together)};
        }
        return best;
    }

    // The largest set of candidates that face about as one of them does.
    std::vector<uint32_t> most_alike(const std::vector<uint32_t> &candidates) const
    {
        std::vector<uint32_t> largest;
        for (const uint32_t one : candidates) {
            std::vector<uint32_t> alike;
            for (const uint32_t other : candidates)
                if (other == one || glm::dot(triangles_[one].normal, triangles_[other].normal) >= min_cosine)
                    alike.push_back(other);
            if (alike.size() > largest.size()) largest = std::move(alike);
        }
        return largest;
    }

    const std::vector<FlatTriangle> &triangles_;
    std::vector<bool> is_open_;
    std::set<uint32_t> taken_;  // welded vertices at which some triangle ends
    std::vector<Provoking> made_;
};

}  // namespace

std::vector<Provoking> provoking_vertices(const std::vector<FlatTriangle> &triangles)
{
    return Choice(triangles).run();
}

}  // namespace claque::passes
