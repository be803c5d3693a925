#include "lib/lod/proxies/marching_tetrahedra.h"

#include <map>

namespace claque::lod
{

namespace
{

// Cube corners are numbered by bits: x, y, z. Six tetrahedra surround the diagonal from 0 to 7. Every side is cut from
// its lowest corner to its highest, so neighbouring cubes cut their common side alike.
constexpr std::array<std::array<uint32_t, 4>, 6> tetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class MarchingTetrahedra
{
public:
    explicit MarchingTetrahedra(const Voxels &voxels) : voxels_(voxels) {}

    ClosedMesh run()
    {
        const glm::uvec3 size = voxels_.size();
        for (uint32_t z = 0; z + 1 < size.z; ++z)
            for (uint32_t y = 0; y + 1 < size.y; ++y)
                for (uint32_t x = 0; x + 1 < size.x; ++x)
                    for (const auto &t : tetrahedra) cut({x, y, z}, t);
        return std::move(out_);
    }

private:
    struct Corner {
        uint64_t id = 0;
        glm::dvec3 at = glm::dvec3(0);
    };

    void cut(glm::uvec3 cube, const std::array<uint32_t, 4> &tetrahedron)
    {
        std::array<Corner, 4> in, out;
        uint32_t ins = 0, outs = 0;
        for (const uint32_t bits : tetrahedron) {
            const glm::uvec3 p = cube + glm::uvec3(bits & 1, bits >> 1 & 1, bits >> 2 & 1);
            const Corner corner = {(uint64_t(p.z) << 42) | (uint64_t(p.y) << 21) | p.x, voxels_.middle(p.x, p.y, p.z)};
            if (voxels_.filled(p.x, p.y, p.z)) in[ins++] = corner;
            else out[outs++] = corner;
        }
        if (ins == 1) add(vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[0], out[2]), in[0].at);
        if (ins == 3) add(vertex(in[0], out[0]), vertex(in[1], out[0]), vertex(in[2], out[0]), in[0].at);
        if (ins == 2) {
            const uint32_t a = vertex(in[0], out[0]), b = vertex(in[0], out[1]), c = vertex(in[1], out[1]),
                           d = vertex(in[1], out[0]);
            add(a, b, c, in[0].at);
            add(a, c, d, in[1].at);
        }
    }

    uint32_t vertex(const Corner &filled, const Corner &empty)
    {
        const auto [at, fresh] =
            known_.try_emplace({filled.id, empty.id}, static_cast<uint32_t>(out_.positions.size()));
        if (fresh) out_.positions.push_back(0.5 * (filled.at + empty.at));
        return at->second;
    }

    void add(uint32_t a, uint32_t b, uint32_t c, glm::dvec3 filled)
    {
        const glm::dvec3 p = out_.positions[a], ab = out_.positions[b] - p, ac = out_.positions[c] - p;
        const glm::dvec3 normal(ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x);
        const glm::dvec3 in = filled - p;
        const bool outward = normal.x * in.x + normal.y * in.y + normal.z * in.z < 0;
        out_.triangles.push_back(outward ? std::array{a, b, c} : std::array{a, c, b});
    }

    const Voxels &voxels_;
    ClosedMesh out_;
    std::map<std::pair<uint64_t, uint64_t>, uint32_t> known_;
};

}  // namespace

ClosedMesh extract_closed_mesh(const Voxels &voxels) { return MarchingTetrahedra(voxels).run(); }

}  // namespace claque::lod
