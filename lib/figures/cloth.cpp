#include "lib/figures/cloth.h"

#include <map>

#include "lib/figures/skeleton.h"

namespace claque::figures
{

Chain doubled(Mesh &mesh, Chain chain)
{
    std::map<uint32_t, uint32_t> twins;
    for (Corner &corner : chain) {
        const Point point = mesh.points[corner.point];
        const auto [at, fresh] = twins.try_emplace(corner.point, 0);
        if (fresh) at->second = mesh.add(point.position, point.region, point.side);
        corner.point = at->second;
    }
    return chain;
}

void add_sleeve(Mesh &mesh, Side side, Chain armhole, const std::vector<SleeveRow> &rows, int count, float inside_m)
{
    const glm::vec3 shoulder = skeleton().joint(Bone::upper_arm);
    Chain before = std::move(armhole);
    for (const SleeveRow &row : rows) {
        Chain next = ring_chain(add_ring(mesh, Region::sleeve, side, count, shoulder + arm_direction() * row.along,
                                         -arm_dorsal(), arm_thumbward(), row.girth),
                                -row.along);
        mesh.sew(on(side, Chart::sleeve), winding_of(side), before, next, Along::s);
        before = std::move(next);
    }
    const uint32_t inside = mesh.add(mirrored(shoulder + arm_direction() * inside_m, side), Region::sleeve, side);
    mesh.fan(on(side, Chart::sleeve_inside), winding_of(side), doubled(mesh, before), {inside, glm::vec2(-1, 0)});
}

}  // namespace claque::figures
