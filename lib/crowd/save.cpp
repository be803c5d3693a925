#include "lib/crowd/save.h"

#include <algorithm>

#include "lib/crowd/save_archive.h"
#include "lib/crowd/save_fields.h"

namespace claque::crowd
{

using model::none;

// Walks a crowd's columns; Restorer reads in the same order.
class Saver
{
public:
    Saver(const Crowd &crowd, Sink &sink) : crowd_(crowd), out_(sink) {}

    void write()
    {
        out_.value(crowd_.seed_);
        templates();
        behaviours();
        layers();
        groups();
        actors();
        attached();
        out_.flush();
    }

private:
    void templates()
    {
        out_.count(crowd_.templates_.size());
        for (const model::Template *tmpl : crowd_.templates_) {
            out_.array(tmpl->name, 1, [&](char c) { out_.value(c); });
            out_.value(structure_hash(*tmpl));
        }
    }

    uint32_t number_of(const model::Template *tmpl) const
    {
        uint32_t i = 0;
        while (i < crowd_.templates_.size() && crowd_.templates_[i] != tmpl) ++i;
        return i;
    }

    void behaviours()
    {
        const Behaviours &from = crowd_.behaviours_;
        out_.count(from.mechanism_count());
        for (uint32_t i = 0; i < from.mechanism_count(); ++i) {
            const Mechanism &m = from.mechanism(i);
            out_.value(static_cast<uint8_t>(m.kind.index()));
            out_.value(number_of(m.tmpl));
            walk_levels(out_, m);
            std::visit([&](const auto &kind) { walk_kind(out_, kind); }, m.kind);
        }
        out_.count(from.path_count());
        for (uint32_t i = 0; i < from.path_count(); ++i) walk_path(out_, from.path(i));
    }

    void layers()
    {
        const Layers &from = crowd_.layers_;
        out_.count(from.gait_count());
        for (uint32_t i = 0; i < from.gait_count(); ++i) {
            out_.value(number_of(from.gait(i).tmpl));
            walk_gait(out_, from.gait(i));
        }
        out_.count(from.mask_count());
        for (uint32_t i = 0; i < from.mask_count(); ++i) {
            out_.value(number_of(from.mask(i).tmpl));
            out_.array(*from.mask(i).weights, 4, [&](float weight) { out_.value(weight); });
        }
        out_.value(from.last_layer_id);
    }

    // `next` of a free row: none ends the chain.
    template <class Next>
    void free_chain(uint32_t first, const Next &next)
    {
        uint32_t n = 0;
        for (uint32_t i = first; i != none; i = next(i)) ++n;
        out_.count(n);
        for (uint32_t i = first; i != none; i = next(i)) out_.value(i);
    }

    void groups()
    {
        out_.count(crowd_.groups_.size());
        for (const Group &group : crowd_.groups_) {
            out_.value(group.generation);
            if (!(group.generation & 1)) continue;
            walk_transform(out_, group.transform);
            out_.flag(group.enabled);
        }
        free_chain(crowd_.first_free_group_, [&](uint32_t i) { return crowd_.groups_[i].members; });
    }

    void actors()
    {
        out_.count(crowd_.actors_.size());
        for (uint32_t row = 0; row < crowd_.row_count(); ++row) {
            out_.value(crowd_.actors_[row].generation);
            if (crowd_.alive(row)) actor(row);
        }
        free_chain(crowd_.first_free_, [&](uint32_t i) { return crowd_.actors_[i].tmpl; });
    }

    void actor(uint32_t row)
    {
        const Actor &actor = crowd_.actors_[row];
        out_.value(actor.tmpl), out_.value(actor.seed), out_.value(actor.texture_set);
        out_.value(crowd_.groups_of_[row]);
        walk_transform(out_, crowd_.transforms_[row]);
        walk_play(out_, crowd_.plays_[row]);
        out_.value(crowd_.extents_[row].priority);
        const Extra *extra = crowd_.extra_of(row);
        out_.value(extra ? extra->max_up : 0.0f), out_.value(extra ? extra->max_down : 0.0f);
        const uint8_t *rgb = crowd_.zone_rgb(row);
        out_.flag(rgb != nullptr);
        for (uint32_t i = 0; rgb && i < crowd_.colours_[actor.tmpl].stride(); ++i) out_.value(rgb[i]);
        behaviour(row);
        layer_state(row);
    }

    void layer_state(uint32_t row)
    {
        const Array<uint32_t> &watched = crowd_.watched_;
        out_.flag(std::binary_search(watched.begin(), watched.end(), row));
        const LayerState *from = crowd_.layers_.of(row);
        out_.flag(from != nullptr);
        if (!from) return;
        walk_source(out_, from->now);
        out_.value(static_cast<uint8_t>(from->fade_count)), out_.value(static_cast<uint8_t>(from->layer_count));
        for (uint32_t k = 0; k < from->fade_count; ++k) walk_fade(out_, from->fades[k]);
        for (uint32_t k = 0; k < from->layer_count; ++k) walk_layer(out_, from->layers[k]);
    }

    void behaviour(uint32_t row)
    {
        const Behaviours &from = crowd_.behaviours_;
        out_.flag(from.has_root_path_play(row));
        if (from.has_root_path_play(row)) walk_root_path_play(out_, from.root_path_play(row));
        uint8_t uses = 0;
        for (uint32_t i = from.first_attachment(row); i != none; i = from.attachment_at(i).next) ++uses;
        out_.value(uses);
        for (uint32_t i = from.first_attachment(row); i != none; i = from.attachment_at(i).next) {
            walk_mechanism_attachment(out_, from.attachment_at(i));
            const CommandHistory *history = from.command_history_of(from.attachment_at(i));
            out_.flag(history != nullptr);
            if (history) walk_command(out_, *history), walk_command(out_, history->before);
        }
    }

    void attached()
    {
        out_.count(crowd_.attached_.size());
        for (const Attachment &attached : crowd_.attached_) {
            out_.value(attached.generation);
            if (attached.generation & 1) walk_attached(out_, attached);
        }
        free_chain(crowd_.first_free_attached_, [&](uint32_t i) { return crowd_.attached_[i].next; });
    }

    const Crowd &crowd_;
    Writer out_;
};

void save_contents(const Crowd &crowd, Sink &sink) { Saver(crowd, sink).write(); }

void save(const Crowd &crowd, Sink &sink)
{
    HashingSink measure;
    save_contents(crowd, measure);
    Writer header(sink);
    for (const uint8_t byte : save_magic) header.value(byte);
    header.value(save_version), header.value(uint32_t(0)), header.value(measure.size), header.value(measure.hash);
    header.flush();
    save_contents(crowd, sink);
}

}  // namespace claque::crowd
