#include "passes/list_drawer.h"

#include "passes/guard.h"
#include "passes/hook_frame.h"
#include "passes/matrix_walk.h"
#include "passes/strategies.h"

#include <algorithm>

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

constexpr size_t ahead = 3;          // individuals: what one takes is about what memory needs for the next few
constexpr size_t most_bytes = 4096;  // of one array: those of finer levels GL reads itself, in a call of their own

// Inlined, as GCC takes functions that do nothing else for functions that do nothing.
#define CLAQUE_FETCH __attribute__((always_inline)) inline void

CLAQUE_FETCH fetch(const void *from, size_t bytes)
{
    constexpr size_t line = 64;
    const char *at = static_cast<const char *>(from);
    for (size_t i = 0; at && i < bytes && bytes <= most_bytes; i += line) __builtin_prefetch(at + i);
}

// Vertices lie wherever the cache had room, and are read once: without this, half of the time of a batch is waiting.
CLAQUE_FETCH fetch_vertices(const draw::Item &item)
{
    const size_t count = item.tmpl->levels[item.level].vertex_count;
    fetch(item.vertices.positions, 3 * sizeof(float) * count);
    fetch(item.vertices.normals, 3 * sizeof(float) * count);
    fetch(item.vertices.short_positions, 4 * sizeof(int16_t) * count);
    fetch(item.vertices.byte_normals, 4 * count);
}

}  // namespace

ListDrawer::ListDrawer(const Gl11 &gl, const Preflight &preflight, const RendererOptions &options,
                       const Array<PreparedTemplate> &templates, Scratch &scratch, const draw::DrawList &list,
                       DrawStats &stats)
    : gl_(gl),
      preflight_(preflight),
      templates_(templates),
      guard_(options.guard),
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
    const StateGuard guard(gl_, guard_);
    state_.begin(list_.projection, preflight_.has_multisample());
    const auto by_matrices = [](const draw::Item &item) { return item.locals != nullptr; };
    if (std::any_of(list_.items.begin(), list_.items.end(), by_matrices)) room_ = matrix_room(gl_);
    base::Status first;
    Individual who;
    for (size_t i = 0; i < list_.items.size(); ++i) {
        if (i + ahead < list_.items.size()) fetch_vertices(list_.items[i + ahead]);
        const draw::Item &item = list_.items[i];
        if (!shows(item)) continue;
        if (!make(item, who)) {
            if (first.ok())
                first =
                    base::Status::bad(CLQ_OUT_OF_MEMORY, "actor %u: no room to skin it at draw time", item.actor_index);
        } else if (!item.hooks) draw_individual(who);
        else if (draw_between_hooks(who, first) == Next::stop) break;
        if (flush_triangles_ != 0 && stats_.triangles - flushed_ >= flush_triangles_) let_gl_begin();
    }
    batch_.flush();
    state_.end_flat();
    return first;
}

bool ListDrawer::make(const draw::Item &item, Individual &who) const
{
    if (!who.prepared || who.prepared->source != item.tmpl) who.prepared = find(templates_, item.tmpl);
    who.item = &item;
    who.ready = &who.prepared->levels[item.level];
    who.level = &who.ready->drawn(item.tmpl->levels[item.level]);
    who.zone_rgb = item.zone_rgb ? item.zone_rgb : who.prepared->zone_rgb.data();
    who.parts = item.parts & every_part_of(*who.level);
    who.own = nullptr;
    who.vertices = item.vertices;
    if (item.locals) {
        who.vertices = draw::Vertices();
        who.vertices.positions = who.ready->positions.data();
        who.vertices.normals = who.ready->normals.data();
    } else if (!who.vertices.any()) {
        who.vertices = list_.server->serve(item);
    }
    return who.vertices.any();
}

void ListDrawer::draw_individual(const Individual &who)
{
    if (batch_.takes(who)) return batch_.add(who);
    batch_.flush();
    canvas_.place(who);
    if (who.item->locals) MatrixWalk(gl_, canvas_, scratch_.chain, stats_, room_).draw(who);
    else draw_parts(canvas_, who);
}

void ListDrawer::let_gl_begin()
{
    batch_.flush();
    gl_.Flush();
    flushed_ = stats_.triangles;
}

ListDrawer::Next ListDrawer::draw_between_hooks(Individual &who, base::Status &first)
{
    batch_.flush();
    HookFrame frame(gl_, preflight_, state_, list_, *who.item);
    const uint32_t room = room_;
    base::Status status = frame.before();
    if (status.ok()) {
        who.own = frame.texture();
        if (who.item->locals && who.item->hooks->before) room_ = matrix_room(gl_);
        draw_individual(who);
    }
    room_ = room;
    if (first.ok()) first = status;
    status = frame.after();
    if (first.ok()) first = status;
    return status.ok() ? Next::go_on : Next::stop;
}

}  // namespace claque::passes
