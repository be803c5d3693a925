#include "passes/renderer.h"

#include <algorithm>
#include <new>

#include "lib/base/error.h"
#include "passes/guard.h"
#include "passes/hook_frame.h"
#include "passes/list_drawer.h"

namespace claque::passes
{
namespace
{

uint32_t max_slots(const model::Template &tmpl)
{
    size_t maximum = 0;
    for (const model::Texture &texture : tmpl.textures) maximum = std::max(maximum, 2 * texture.keys.size());
    for (const model::Level &level : tmpl.levels)
        for (const uint16_t slot : level.slots) maximum = std::max<size_t>(maximum, slot + 1u);
    return static_cast<uint32_t>(maximum);
}

uint32_t max_colour_entries(const PreparedTemplate &prepared)
{
    size_t maximum = 0;
    for (const PreparedLevel &level : prepared.levels) maximum = std::max(maximum, level.flat.zones.size());
    return static_cast<uint32_t>(maximum);
}

uint32_t max_vertices(const model::Template &tmpl)
{
    uint32_t maximum = 0;
    for (const model::Level &level : tmpl.levels) maximum = std::max(maximum, level.vertex_count);
    return maximum;
}

uint32_t max_depth(const PreparedTemplate &prepared)
{
    uint32_t maximum = 0;
    for (const PreparedLevel &level : prepared.levels)
        for (const MatrixStep &step : level.steps) maximum = std::max(maximum, step.depth);
    return maximum;
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

Strategy Renderer::strategy_of(const model::Template &tmpl) const
{
    const PreparedTemplate *prepared = find(templates_, &tmpl);
    return prepared ? prepared->strategy : options_.strategy;
}

LuminanceStep Renderer::step_of(const model::Template &tmpl) const
{
    const PreparedTemplate *prepared = find(templates_, &tmpl);
    return prepared ? prepared->step : LuminanceStep();
}

float Renderer::close_distance_of(const model::Template &tmpl) const
{
    const PreparedTemplate *prepared = find(templates_, &tmpl);
    return prepared ? prepared->close_distance_m : 0;
}

base::Status Renderer::prepare(const model::Template &tmpl)
{
    if (!open_) return not_open();
    if (find(templates_, &tmpl)) return base::Status::good();
    base::Status status = preflight_.check_upload(gl_);
    if (!status.ok()) return still_current(gl_, status);
    const size_t before = templates_.size();
    try {
        status = add(tmpl);
    } catch (const std::bad_alloc &) {
        status = base::Status::bad(CLQ_OUT_OF_MEMORY, "template '%s': no memory to prepare it", tmpl.name.c_str());
    } catch (const base::Error &error) {
        status = base::Status::bad(error.status(), "template '%s': %s", tmpl.name.c_str(), error.what());
    }
    status = still_current(gl_, status);
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
    scratch_.reserve(options_.colours, max_vertices(tmpl), std::max(max_slots(tmpl), max_colour_entries(prepared)));
    scratch_.reserve_chain(max_depth(prepared));
    scratch_.shadow.reserve(max_vertices(tmpl));
    const auto batched = [](const PreparedLevel &level) { return level.batched; };
    if (std::any_of(prepared.levels.begin(), prepared.levels.end(), batched)) scratch_.reserve_batch(options_.colours);
    return upload_textures(gl_, prepared);
}

base::Status Renderer::check_item(const draw::Item &item, const PreparedTemplate &prepared) const
{
    if (item.level >= prepared.levels.size())
        return base::Status::bad(CLQ_ARGUMENT, "actor %u: level %u of template '%s', which has %zu",
                                 item.actor_index + 1, item.level, item.tmpl->name.c_str(), prepared.levels.size());
    if (!shows(item)) return base::Status::good();
    if (item.locals && !prepared.rigid)
        return base::Status::bad(CLQ_ARGUMENT,
                                 "actor %u: GL's matrix stack cannot place the template '%s', which is not made of "
                                 "rigid parts alone",
                                 item.actor_index + 1, item.tmpl->name.c_str());
    return base::Status::good();
}

base::Status Renderer::check_items(const draw::DrawList &list) const
{
    const PreparedTemplate *prepared = nullptr;
    for (const draw::Item &item : list.items) {
        if (item.shadow_only) continue;
        if (!prepared || prepared->source != item.tmpl) prepared = find(templates_, item.tmpl);
        if (!prepared)
            return base::Status::bad(CLQ_ARGUMENT, "the template '%s' has not been prepared for this renderer",
                                     item.tmpl ? item.tmpl->name.c_str() : "(none)");
        if (base::Status status = check_item(item, *prepared); !status.ok()) return status;
    }
    return base::Status::good();
}

StackEntries Renderer::stack_entries_for(const draw::DrawList &list) const
{
    StackEntries entries = stack_entries_of(options_.guard);
    const auto hooked = [](const draw::Item &item) { return item.hooks != nullptr; };
    if (std::any_of(list.items.begin(), list.items.end(), hooked)) {
        entries.attributes += hook_stack_entries.attributes;
        entries.client += hook_stack_entries.client;
    }
    return entries;
}

base::Status Renderer::draw(const draw::DrawList &list, DrawStats *out_stats)
{
    DrawStats stats;
    base::Status status = open_ ? check_items(list) : not_open();
    if (status.ok()) status = still_current(gl_, draw_checked(list, stats));
    stats.close_bytes = close_.held_bytes();
    if (out_stats) *out_stats = stats;
    return status;
}

base::Status Renderer::draw_checked(const draw::DrawList &list, DrawStats &stats)
{
    base::Status status = preflight_.check_draw(gl_, stack_entries_for(list));
    if (!status.ok() || !std::any_of(list.items.begin(), list.items.end(), shows)) return status;
    uint32_t left_out = 0;
    if (options_.close_bytes != 0) status = close_.make(gl_, preflight_, templates_, list, left_out, stats);
    if (!status.ok()) return status;
    status = ListDrawer(gl_, preflight_, options_, templates_, close_, scratch_, list, stats).draw();
    if (!status.ok() || left_out == 0) return status;
    return base::Status::bad(CLQ_OUT_OF_MEMORY,
                             "GL has no memory for %u textures of single individuals; they are drawn with those of "
                             "their templates",
                             left_out);
}

void Renderer::destroy()
{
    if (open_ && check_current(gl_).ok()) {
        close_.destroy(gl_);
        for (PreparedTemplate &prepared : templates_) delete_textures(gl_, prepared);
        holes_.destroy(gl_);
    }
    abandon();
}

void Renderer::abandon()
{
    templates_.clear();
    close_.forget();
    holes_.abandon();
    gl_ = Gl11();
    open_ = false;
}

}  // namespace claque::passes
