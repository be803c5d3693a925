#include "passes/renderer.h"

#include "lib/base/error.h"
#include "passes/guard.h"
#include "passes/strategies.h"

#include <algorithm>
#include <new>

namespace claque::passes
{
namespace
{

void draw_individual(Canvas &canvas, const Individual &who)
{
    canvas.place(who);
    switch (who.prepared->strategy) {
        case Strategy::fused:
            return draw_fused(canvas, who);
        case Strategy::binned:
            return draw_binned(canvas, who);
        case Strategy::per_zone:
            return draw_per_zone(canvas, who);
    }
}

uint32_t most_slots(const model::Template &tmpl)
{
    size_t most = 0;
    for (const model::Texture &texture : tmpl.textures) most = std::max(most, 2 * texture.keys.size());
    for (const model::Level &level : tmpl.levels)
        for (const uint16_t slot : level.slots) most = std::max<size_t>(most, slot + 1u);
    return static_cast<uint32_t>(most);
}

uint32_t most_vertices(const model::Template &tmpl)
{
    uint32_t most = 0;
    for (const model::Level &level : tmpl.levels) most = std::max(most, level.vertex_count);
    return most;
}

base::Status not_open()
{
    return base::Status::bad(CLQ_GL_MISSING, "the renderer has no GL functions: it is not open");
}

}  // namespace

base::Status Renderer::open(GetProcAddress get_proc_address, void *user)
{
    if (options_.key_test == KeyTest::equal && options_.strategy != Strategy::per_zone)
        return base::Status::bad(CLQ_ARGUMENT, "the GL_EQUAL key test works with the per-zone strategy only");
    base::Status status = load(gl_, get_proc_address, user);
    if (status.ok()) status = preflight_.learn(gl_);
    open_ = status.ok();
    return status;
}

const PreparedTemplate *Renderer::find(const model::Template *tmpl) const
{
    for (const PreparedTemplate &prepared : templates_)
        if (prepared.source == tmpl) return &prepared;
    return nullptr;
}

Strategy Renderer::strategy_of(const model::Template &tmpl) const
{
    const PreparedTemplate *prepared = find(&tmpl);
    return prepared ? prepared->strategy : options_.strategy;
}

base::Status Renderer::prepare(const model::Template &tmpl)
{
    if (!open_) return not_open();
    if (find(&tmpl)) return base::Status::good();
    base::Status status = preflight_.check_upload(gl_);
    if (!status.ok()) return status;
    const size_t before = templates_.size();
    try {
        status = add(tmpl);
    } catch (const std::bad_alloc &) {
        status = base::Status::bad(CLQ_OUT_OF_MEMORY, "template '%s': no memory to prepare it", tmpl.name.c_str());
    } catch (const base::Error &error) {
        status = base::Status::bad(error.status(), "template '%s': %s", tmpl.name.c_str(), error.what());
    }
    if (!status.ok())
        while (templates_.size() > before) templates_.pop_back();
    return status;
}

// Everything that can fail comes before the first GL object.
base::Status Renderer::add(const model::Template &tmpl)
{
    int alpha_bits = 8;
    base::Status status = probe_textures(gl_, tmpl, alpha_bits);
    if (!status.ok()) return status;
    PreparedTemplate &prepared = templates_.emplace_back(memory_);
    status = prepare_without_gl(prepared, tmpl, options_, alpha_bits);
    if (!status.ok()) return status;
    scratch_.reserve(options_.colours, most_vertices(tmpl), most_slots(tmpl));
    upload_textures(gl_, prepared);
    return status;
}

base::Status Renderer::check_items(const draw::DrawList &list) const
{
    const PreparedTemplate *prepared = nullptr;
    for (const draw::Item &item : list.items) {
        if (!prepared || prepared->source != item.tmpl) prepared = find(item.tmpl);
        if (!prepared)
            return base::Status::bad(CLQ_ARGUMENT, "the template '%s' has not been prepared for this renderer",
                                     item.tmpl ? item.tmpl->name.c_str() : "(none)");
        if (item.level >= prepared->levels.size())
            return base::Status::bad(CLQ_ARGUMENT, "actor %u: level %u of template '%s', which has %zu",
                                     item.actor_index, item.level, item.tmpl->name.c_str(), prepared->levels.size());
        if ((!item.vertices.positions || !item.vertices.normals) && !list.server)
            return base::Status::bad(CLQ_ARGUMENT, "actor %u has no vertices and the list no vertex server",
                                     item.actor_index);
    }
    return base::Status::good();
}

base::Status Renderer::draw(const draw::DrawList &list, DrawStats *out_stats)
{
    DrawStats stats;
    base::Status status = open_ ? check_items(list) : not_open();
    if (status.ok()) status = preflight_.check_draw(gl_, options_.guard);
    if (status.ok() && !list.items.empty()) status = draw_items(list, stats);
    if (out_stats) *out_stats = stats;
    return status;
}

base::Status Renderer::draw_items(const draw::DrawList &list, DrawStats &stats)
{
    const StateGuard guard(gl_, options_.guard);
    GlState state(gl_, stats);
    state.begin(list.projection, preflight_.has_multisample());
    Canvas canvas(gl_, options_, state, scratch_, stats);
    base::Status status;
    Individual who;
    for (const draw::Item &item : list.items) {
        if (!who.prepared || who.prepared->source != item.tmpl) who.prepared = find(item.tmpl);
        who.item = &item;
        who.level = &item.tmpl->levels[item.level];
        who.ready = &who.prepared->levels[item.level];
        who.zone_rgb = item.zone_rgb ? item.zone_rgb : who.prepared->zone_rgb.data();
        who.vertices = item.vertices;
        if (!who.vertices.positions || !who.vertices.normals) who.vertices = list.server->serve(item);
        if (who.vertices.positions && who.vertices.normals) draw_individual(canvas, who);
        else if (status.ok())
            status =
                base::Status::bad(CLQ_OUT_OF_MEMORY, "actor %u: no room to skin it at draw time", item.actor_index);
    }
    return status;
}

void Renderer::destroy()
{
    if (open_ && check_current(gl_).ok())
        for (PreparedTemplate &prepared : templates_) delete_textures(gl_, prepared);
    abandon();
}

void Renderer::abandon()
{
    templates_.clear();
    gl_ = Gl11();
    open_ = false;
}

}  // namespace claque::passes
