// Restores mechanisms, root paths and the attachments of actors.
#include <cmath>

#include "lib/crowd/descriptions.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/restore.h"
#include "lib/crowd/save_check.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

void read_command(Reader &in, Crowd &out, Id id, uint32_t number)
{
    const Mechanism &mechanism = out.behaviours().mechanism(number);
    if (!std::holds_alternative<Gaze>(mechanism.kind) && !std::holds_alternative<Expression>(mechanism.kind) &&
        !std::holds_alternative<Phrase>(mechanism.kind))
        fail(CLQ_FORMAT, "a saved crowd holds a command for mechanism %u, which takes none", number + 1);
    CommandHistory &history = command_history(out, id, number);
    walk_command(in, history), walk_command(in, history.before);
    check_command(mechanism, history, number);
    check_command(mechanism, history.before, number);
    if (std::isfinite(history.before.at_s) && !(history.before.at_s < history.at_s))
        fail(CLQ_FORMAT, "a saved crowd holds commands of mechanism %u out of order", number + 1);
}

}  // namespace

void read_mechanism(Reader &in, Resolver &resolver, Tables &out)
{
    uint8_t kind = 0;
    uint32_t tmpl = 0;
    in.value(kind), in.value(tmpl);
    Mechanism made;
    made.kind = kind_of(kind, out.actors.all.memory());
    made.tmpl = template_at(out, tmpl);
    walk_levels(in, made);
    std::visit([&](auto &of) { walk_kind(in, of); }, made.kind);
    resolver.add(out.behaviours, out.behaviours.mechanism_count(), std::move(made));
}

void read_path(Reader &in, Resolver &resolver, Tables &out)
{
    RootPath path(out.actors.all.memory());
    walk_path(in, path);
    resolver.add(out.behaviours, out.behaviours.path_count(), std::move(path));
}

void read_behaviours(Reader &in, Resolver &resolver, Tables &out)
{
    const uint32_t mechanisms = in.count(22);
    for (uint32_t i = 0; i < mechanisms; ++i) read_mechanism(in, resolver, out);
    const uint32_t paths = in.count(25);
    for (uint32_t i = 0; i < paths; ++i) read_path(in, resolver, out);
}

void read_uses(Reader &in, Crowd &out, uint32_t row)
{
    const Id id = out.id_of(row);
    bool moves = false;
    in.flag(moves);
    if (moves) {
        RootPathPlay root_play;
        walk_root_path_play(in, root_play);
        if (root_play.path == none) fail(CLQ_FORMAT, "a saved crowd's actor %u moves along no path", row);
        play_root_path(out, id, root_play);
    }
    uint8_t uses = 0;
    in.value(uses);
    MechanismAttachment attachment, before;
    for (uint32_t i = 0; i < uses; ++i, before = attachment) {
        walk_mechanism_attachment(in, attachment);
        if (out.behaviours().find_attachment(row, attachment.mechanism) != none)
            fail(CLQ_FORMAT, "a saved crowd's actor %u uses mechanism %u twice", row, attachment.mechanism + 1);
        attach_mechanism(out, id, attachment);
        if (i > 0 && attachment.priority < before.priority)
            fail(CLQ_FORMAT, "a saved crowd's actor %u uses mechanisms out of order", row);
        bool history = false;
        in.flag(history);
        if (history) read_command(in, out, id, attachment.mechanism);
    }
}

}  // namespace claque::crowd
