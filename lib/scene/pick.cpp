#include "lib/scene/pick.h"

#include <glm/matrix.hpp>

#include "lib/scene/candidates.h"
#include "lib/scene/triangles.h"

namespace claque::scene
{

using model::none;

namespace
{

// The ray in the space of an item, with the same lengths along it: its direction there is not of length 1.
Ray ray_in(const draw::DrawList &list, const draw::Item &item, const Ray &world)
{
    const double *w = list.world_to_eye;
    const glm::dmat3 turn(w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7], w[8]);
    const float *m = item.model_view;
    const glm::dmat3 axes(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]);
    const glm::dmat3 back = glm::inverse(axes);
    const glm::dvec3 eye(list.eye[0], list.eye[1], list.eye[2]), origin(m[12], m[13], m[14]);
    return {back * (turn * (world.origin - eye) - origin), back * (turn * world.direction), world.length};
}

class Picker
{
public:
    Picker(const Asked &asked, const Picture &picture, const Ray &ray) : asked_(asked), picture_(picture), ray_(ray)
    {
        best_.distance = ray.length;
    }

    void test_item(uint32_t index)
    {
        const draw::Item &item = picture_.list.items[index];
        const uint32_t row = item.actor_index;
        if (item.shadow_only || row >= asked_.crowd.row_count()) return;
        if (asked_.crowd.actor(row).generation != item.generation) return;
        if (!asked_.scene.matches(asked_.crowd, row, asked_.filter)) return;
        if (asked_.effort) ++asked_.effort->tested;
        Ray own = ray_in(picture_.list, item, ray_);
        own.length = best_.distance;
        const draw::Vertices vertices =
            item.vertices.any() || !item.locals ? item.vertices : picture_.source.vertices_of(item);
        if (!vertices.any() && item.locals) throw std::bad_alloc();
        if (!vertices.any()) return;  // left out by the update
        const TriangleHit hit = first_triangle(item, vertices, own);
        const uint32_t best_row = best_.item == none ? none : picture_.list.items[best_.item].actor_index;
        if (!hit.found || (hit.distance == best_.distance && row >= best_row)) return;
        best_ = {index, hit.part, hit.zone, {}, {}, hit.distance};
        for (int k = 0; k < 3; ++k) best_.vertices[k] = hit.vertices[k], best_.barycentric[k] = hit.barycentric[k];
    }

    void test_row(uint32_t row)
    {
        const model::Array<draw::Item> &items = picture_.list.items;
        const uint32_t index = asked_.scene.item_of(picture_.view, row);
        if (index < items.size() && items[index].actor_index == row) test_item(index);
    }

    void test_list()
    {
        for (uint32_t i = 0; i < picture_.list.items.size(); ++i) test_item(i);
    }

    const double &limit() const { return best_.distance; }
    const Pick &best() const { return best_; }

private:
    const Asked &asked_;
    const Picture &picture_;
    const Ray &ray_;
    Pick best_;
};

}  // namespace

Pick pick(const Asked &asked, const Picture &picture, const Ray &ray)
{
    Picker picker(asked, picture, ray);
    const Margins margins(asked, ray.origin);
    const auto entry = [&](const Leaf &node) {
        if (asked.effort) ++asked.effort->nodes;
        const double at = entry_of(ray, node.box, margins.of_bodies(node) * 1.01);
        return at >= 0 ? at : std::nan("");  // which is beyond every limit
    };
    if (asked.scene.is_drawn())
        asked.scene.tree().for_each_by_distance(entry, picker.limit(), [&](uint32_t row) { picker.test_row(row); });
    else picker.test_list();
    return picker.best();
}

}  // namespace claque::scene
