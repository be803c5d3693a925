// Bytes to a crowd's state. Every rule of crowd.h holds afterwards, whatever the bytes were: what can be set by a call is
// set by it, and what cannot (rows, generations, what is free) is checked here.
#include <cmath>

#include "lib/crowd/save_check.h"
#include "lib/crowd/save_fields.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

constexpr uint32_t last_generation = 0xfffffffeu;  // of a row that nobody gets any more
void check_generation(const char *what, uint32_t index, uint32_t generation)
{
    if (generation == 0xffffffffu)
        fail(CLQ_FORMAT, "a saved crowd's %s %u has a generation that none has", what, index);
}

}  // namespace

// Reads in the order in which Saver writes.
class Restorer
{
public:
    Restorer(Reader &in, Resolver &resolver, Crowd &out) : in_(in), resolver_(resolver), out_(out) {}

    void read()
    {
        in_.value(out_.seed_);
        templates();
        behaviours();
        try {
            read_layers(
                in_, [this](uint32_t index) { return template_at(index); }, out_.layers_);
            groups();
            actors();
            attached();
        } catch (const base::Error &error) {
            if (error.status() == CLQ_FORMAT) throw;
            fail(CLQ_FORMAT, "a saved crowd is no crowd: %s", error.what());  // a rule of the calls
        }
        for (uint32_t row = 0; row < out_.row_count(); ++row)
            if (out_.alive(row)) out_.measure(row);
        if (in_.left() != 0) fail(CLQ_FORMAT, "a saved crowd has %zu bytes too many", in_.left());
    }

private:
    std::pmr::memory_resource *memory() const { return out_.memory(); }

    void templates()
    {
        const uint32_t count = in_.count(12);
        std::pmr::string name(memory());
        out_.templates_.reserve(count);
        out_.colours_.reserve(count);
        for (uint32_t i = 0; i < count; ++i) {
            in_.array(name, 1, [&](char &c) { in_.value(c); });
            uint64_t structure = 0;
            in_.value(structure);
            const model::Template &tmpl = resolver_.find_template(name, structure);
            out_.templates_.push_back(&tmpl);
            out_.colours_.emplace_back(memory(), tmpl.zone_count());
        }
    }

    void behaviours()
    {
        const uint32_t mechanisms = in_.count(22);
        for (uint32_t i = 0; i < mechanisms; ++i) {
            uint8_t kind = 0;
            uint32_t tmpl = 0;
            in_.value(kind), in_.value(tmpl);
            Mechanism made;
            made.kind = kind_of(kind, memory());
            made.tmpl = template_at(tmpl);
            walk_levels(in_, made);
            std::visit([&](auto &of) { walk_kind(in_, of); }, made.kind);
            resolver_.add(out_.behaviours_, i, std::move(made));
        }
        const uint32_t paths = in_.count(25);
        for (uint32_t i = 0; i < paths; ++i) {
            RootPath path(memory());
            walk_path(in_, path);
            resolver_.add(out_.behaviours_, i, std::move(path));
        }
    }

    const model::Template *template_at(uint32_t index) const
    {
        if (index >= out_.templates_.size())
            fail(CLQ_FORMAT, "a saved crowd names template %u of %zu", index, out_.templates_.size());
        return out_.templates_[index];
    }

    // Rows that are free, in the order of their use; all that can be used again, each once. Returns the first.
    template <class Generation, class Next>
    uint32_t free_chain(const char *what, uint32_t rows, const Generation &generation, const Next &next)
    {
        constexpr uint32_t unlinked = none - 1;
        uint32_t free = 0;
        for (uint32_t i = 0; i < rows; ++i) {
            if (generation(i) & 1) continue;
            const bool usable = generation(i) != last_generation;
            free += usable;
            next(i) = usable ? unlinked : none;
        }
        const uint32_t count = in_.count(4);
        if (count != free) fail(CLQ_FORMAT, "a saved crowd lists %u free %ss of %u", count, what, free);
        uint32_t first = none, last = none;
        for (uint32_t k = 0; k < count; ++k) {
            uint32_t i = 0;
            in_.value(i);
            if (i >= rows || (generation(i) & 1) || next(i) != unlinked)
                fail(CLQ_FORMAT, "a saved crowd lists %s %u as free, which is not, or twice", what, i);
            (last == none ? first : next(last)) = i;
            next(i) = none;
            last = i;
        }
        return first;
    }

    void groups()
    {
        out_.groups_.resize(in_.count(4));
        for (uint32_t i = 0; i < out_.group_count(); ++i) {
            Group &group = out_.groups_[i];
            in_.value(group.generation);
            check_generation("group", i, group.generation);
            if (!(group.generation & 1)) continue;
            walk_transform(in_, group.transform);
            checked(group.transform);
            in_.flag(group.enabled);
        }
        out_.first_free_group_ = free_chain(
            "group", out_.group_count(), [&](uint32_t i) { return out_.groups_[i].generation; },
            [&](uint32_t i) -> uint32_t & { return out_.groups_[i].members; });
    }

    void actors()
    {
        const uint32_t count = in_.count(4);
        for (uint32_t row = 0; row < count; ++row) {
            out_.reserve_row();
            out_.take_row();
            uint32_t &generation = out_.actors_[row].generation;
            in_.value(generation);
            check_generation("actor", row, generation);
            if (out_.alive(row)) actor(row);
            else --out_.alive_;
        }
        out_.first_free_ = free_chain(
            "actor", count, [&](uint32_t i) { return out_.actors_[i].generation; },
            [&](uint32_t i) -> uint32_t & { return out_.actors_[i].tmpl; });
    }

    void actor(uint32_t row)
    {
        Actor &actor = out_.actors_[row];
        uint32_t group = none;
        Transform transform;
        Play play;
        float priority = 0, up = 0, down = 0;
        uint32_t texture_set = 0;
        in_.value(actor.tmpl), in_.value(actor.seed), in_.value(texture_set), in_.value(group);
        template_at(actor.tmpl);
        walk_transform(in_, transform), walk_play(in_, play);
        in_.value(priority), in_.value(up), in_.value(down);
        const Id id = out_.id_of(row);
        out_.set_transforms(&id, &transform, 1);
        out_.play(id, play);
        out_.set_priority(id, priority);
        if (texture_set == random_texture_set) fail(CLQ_FORMAT, "a saved crowd's actor %u has no texture set", row);
        out_.set_texture_set(id, texture_set);
        if (up != 0 || down != 0) out_.follow_ground(id, up, down);
        if (group != none) {
            if (group >= out_.group_count() || !(out_.groups_[group].generation & 1))
                fail(CLQ_FORMAT, "a saved crowd's actor %u is in group %u, which there is not", row, group);
            out_.groups_of_[row] = group;
            ++out_.groups_[group].members;
        }
        colours(row);
        behaviour(row);
        layer_state(row);
    }

    void layer_state(uint32_t row)
    {
        bool watched = false;
        in_.flag(watched);
        if (watched) out_.watch(out_.id_of(row), true);
        LayerState read;
        if (!read_layer_state(in_, row, read)) return;
        const Play &play = out_.play_of(row), &now = read.now.play;
        if (now.clip != play.clip || now.start_s != play.start_s || now.speed != play.speed ||
            now.phase_s != play.phase_s)
            fail(CLQ_FORMAT, "a saved crowd's actor %u fades to what it does not play", row);
        out_.restore_layer_state(row, read);
    }

    void colours(uint32_t row)
    {
        bool own = false;
        in_.flag(own);
        if (!own) return;
        const ColourTable &table = out_.colours_[out_.actors_[row].tmpl];
        if (table.stride() == 0) fail(CLQ_FORMAT, "a saved crowd's actor %u has colours of no zone", row);
        uint8_t *rgb = table.row(out_.colour_slot(row));
        for (uint32_t i = 0; i < table.stride(); ++i) in_.value(rgb[i]);
    }

    void behaviour(uint32_t row)
    {
        const Id id = out_.id_of(row);
        bool moves = false;
        in_.flag(moves);
        if (moves) {
            RootPathPlay root_play;
            walk_root_path_play(in_, root_play);
            if (root_play.path == none) fail(CLQ_FORMAT, "a saved crowd's actor %u moves along no path", row);
            out_.play_root_path(id, root_play);
        }
        uint8_t uses = 0;
        in_.value(uses);
        MechanismAttachment attachment, before;
        for (uint32_t i = 0; i < uses; ++i, before = attachment) {
            walk_mechanism_attachment(in_, attachment);
            for (uint32_t k = out_.behaviours_.first_attachment(row); k != none;
                 k = out_.behaviours_.attachment_at(k).next)
                if (out_.behaviours_.attachment_at(k).mechanism == attachment.mechanism)
                    fail(CLQ_FORMAT, "a saved crowd's actor %u uses mechanism %u twice", row, attachment.mechanism + 1);
            out_.attach_mechanism(id, attachment);
            if (i > 0 && attachment.priority < before.priority)
                fail(CLQ_FORMAT, "a saved crowd's actor %u uses mechanisms out of order", row);
            bool history = false;
            in_.flag(history);
            if (history) command_history(id, attachment.mechanism);
        }
    }

    void command_history(Id id, uint32_t number)
    {
        const Mechanism &mechanism = out_.behaviours_.mechanism(number);
        if (!std::holds_alternative<Gaze>(mechanism.kind) && !std::holds_alternative<Expression>(mechanism.kind) &&
            !std::holds_alternative<Phrase>(mechanism.kind))
            fail(CLQ_FORMAT, "a saved crowd holds a command for mechanism %u, which takes none", number + 1);
        CommandHistory &history = out_.command_history(id, number);
        walk_command(in_, history), walk_command(in_, history.before);
        check_command(mechanism, history, number);
        check_command(mechanism, history.before, number);
        if (std::isfinite(history.before.at_s) && !(history.before.at_s < history.at_s))
            fail(CLQ_FORMAT, "a saved crowd holds commands of mechanism %u out of order", number + 1);
    }

    void attached()
    {
        const uint32_t count = in_.count(4);
        for (uint32_t i = 0; i < count; ++i) {
            uint32_t generation = 0;
            in_.value(generation);
            check_generation("attached object", i, generation);
            Attachment read;
            if (generation & 1) walk_attached(in_, read);
            if ((generation & 1) && (read.row >= out_.row_count() || !out_.alive(read.row)))
                fail(CLQ_FORMAT, "a saved crowd's attached object %u is of actor %u, which there is not", i, read.row);
            if (generation & 1) {
                out_.attach(out_.id_of(read.row), read.node, read.sphere);
            } else {
                out_.attached_.emplace_back();
            }
            out_.attached_[i].generation = generation;
        }
        out_.first_free_attached_ = free_chain(
            "attached object", count, [&](uint32_t i) { return out_.attached_[i].generation; },
            [&](uint32_t i) -> uint32_t & { return out_.attached_[i].next; });
    }

    Reader &in_;
    Resolver &resolver_;
    Crowd &out_;
};

void restore(const uint8_t *bytes, size_t size, Resolver &resolver, Crowd &out)
{
    Reader in = contents_of(bytes, size);
    Restorer(in, resolver, out).read();
}

}  // namespace claque::crowd
