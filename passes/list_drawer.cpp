#include "passes/list_drawer.h"

#include <algorithm>

#include "passes/guard.h"
#include "passes/hook_frame.h"
#include "passes/matrix_walk.h"
#include "passes/plain.h"
#include "passes/strategies.h"

namespace claque::passes
{

bool shows(const draw::Item &item)
{
    if (item.shadow_only) return false;
    const model::Level &level = item.tmpl->levels[item.level];
    return !level.surfaces.empty() && !level.indices.empty() && (item.parts & every_part_of(level)) != 0;
}

namespace
{

constexpr size_t ahead = 3;         // individuals; memory needs about the time of one for the next few
constexpr size_t max_bytes = 4096;  // of one array; finer levels have calls of their own and GL reads their arrays

// Inlined, because GCC removes calls of functions that only prefetch.
#define CLAQUE_PREFETCH __attribute__((always_inline)) inline void

CLAQUE_PREFETCH prefetch(const void *from, size_t bytes)
{
    constexpr size_t line = 64;
    const char *at = static_cast<const char *>(from);
    for (size_t i = 0; at && i < bytes && bytes <= max_bytes; i += line) __builtin_prefetch(at + i);
}

// Vertices lie anywhere in the cache's memory and are read once; without prefetching half of the time of a batch is
// waiting.
CLAQUE_PREFETCH prefetch_vertices(const draw::Item &item)
{
    const size_t count = item.tmpl->levels[item.level].vertex_count;
    prefetch(item.vertices.positions, 3 * sizeof(float) * count);
    prefetch(item.vertices.normals, 3 * sizeof(float) * count);
    prefetch(item.vertices.short_positions, 4 * sizeof(int16_t) * count);
    prefetch(item.vertices.byte_normals, 4 * count);
}

}  // namespace

ListDrawer::ListDrawer(const Gl11 &gl, const Preflight &preflight, const RendererOptions &options,
                       const Array<PreparedTemplate> &templates, const CloseTextures &close, Scratch &scratch,
                       const draw::DrawList &list, DrawStats &stats)
    : gl_(gl),
      preflight_(preflight),
      templates_(templates),
      close_(close),
      guard_(options.guard),
      multisample_(preflight.multisample(options.multisample)),
      scratch_(scratch),
      list_(list),
      stats_(stats),
      state_(gl, stats),
      canvas_(gl, options, state_, scratch, stats),
      batch_(gl, options, state_, scratch, stats),
      flush_triangles_(options.flush_triangles)
{
}

base::Status ListDrawer::draw()
{
    const StateGuard guard(gl_, guard_, multisample_);
    state_.begin(list_.projection, multisample_);
    const auto by_matrices = [](const draw::Item &item) { return item.locals != nullptr; };
    if (std::any_of(list_.items.begin(), list_.items.end(), by_matrices)) room_ = matrix_room(gl_);
    base::Status first;
    Individual individual;
    for (size_t i = 0; i < list_.items.size(); ++i) {
        if (i + ahead < list_.items.size()) prefetch_vertices(list_.items[i + ahead]);
        const draw::Item &item = list_.items[i];
        if (!shows(item)) continue;
        if (!make(i, individual)) {
            if (first.ok())
                first = base::Status::bad(CLQ_OUT_OF_MEMORY, "actor %u: no memory for its vertices at the update",
                                          item.actor_index + 1);
        } else if (!item.hooks) draw_individual(individual);
        else if (draw_between_hooks(individual, first) == Next::stop) break;
        if (flush_triangles_ != 0 && stats_.triangles - flushed_ >= flush_triangles_) flush_gl();
    }
    batch_.flush();
    state_.end();
    return first;
}

bool ListDrawer::make(size_t item_index, Individual &individual) const
{
    const draw::Item &item = list_.items[item_index];
    if (!individual.prepared || individual.prepared->source != item.tmpl)
        individual.prepared = find(templates_, item.tmpl);
    individual.item = &item;
    individual.ready = &individual.prepared->levels[item.level];
    individual.level = &individual.ready->drawn(item.tmpl->levels[item.level]);
    individual.zone_rgb = item.zone_rgb ? item.zone_rgb : individual.prepared->zone_rgb.data();
    individual.parts = item.parts & every_part_of(*individual.level);
    individual.own = nullptr;
    individual.close = close_.of(item_index);
    individual.one_colour = individual.prepared->strategy != Strategy::per_zone && !individual.ready->plain.empty() &&
                            individual.ready->filtered.empty() && one_colour(*individual.prepared, individual.zone_rgb);
    individual.vertices = item.vertices;
    if (item.locals) {
        individual.vertices = draw::Vertices();
        individual.vertices.positions = individual.ready->positions.data();
        individual.vertices.normals = individual.ready->normals.data();
    }
    return individual.vertices.any();
}

void ListDrawer::draw_individual(const Individual &individual)
{
    if (batch_.takes(individual)) return batch_.add(individual);
    batch_.flush();
    canvas_.bind_vertices(individual);
    if (individual.item->locals) MatrixWalk(gl_, canvas_, scratch_.chain, stats_, room_).draw(individual);
    else draw_parts(canvas_, individual);
}

void ListDrawer::flush_gl()
{
    batch_.flush();
    gl_.Flush();
    flushed_ = stats_.triangles;
}

ListDrawer::Next ListDrawer::draw_between_hooks(Individual &individual, base::Status &first)
{
    batch_.flush();
    HookFrame frame(gl_, preflight_, state_, multisample_, list_, *individual.item);
    const uint32_t room = room_;
    base::Status status = frame.before();
    if (status.ok() && frame.thrown().ok()) {
        individual.own = frame.texture();
        if (individual.item->locals && individual.item->hooks->before) room_ = matrix_room(gl_);
        draw_individual(individual);
    }
    room_ = room;
    if (first.ok()) first = status;
    status = frame.after();
    if (first.ok()) first = frame.thrown();
    if (first.ok()) first = status;
    return status.ok() ? Next::go_on : Next::stop;
}

}  // namespace claque::passes
