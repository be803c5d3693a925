// Runs all mechanisms of one actor in ascending order of priority.
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

double change(const Call &call, double t_s, double length_s) noexcept
{
    const double share = ease(t_s, length_s);
    return call.level == 0 ? share : share >= 0.5 ? 1 : 0;
}

void run(const crowd::Crowd &crowd, uint32_t row, const EvaluationContext &context, base::Span<float> dofs,
         Counts &counts) noexcept
{
    const model::Rig &rig = crowd.template_of(row).rig;
    for (uint32_t i = 0; i < dofs.count; ++i) dofs[i] = rig.dofs[i].rest;
    const crowd::Behaviours &behaviours = crowd.behaviours();
    Writer writer{&rig, context.level, dofs, &counts};
    uint32_t slot = 0;
    for (uint32_t i = behaviours.first_attachment(row); i != model::none;
         i = behaviours.attachment_at(i).next, ++slot) {
        const uint32_t level = mechanism_level(context.levels, slot);
        const Call call{crowd, row, behaviours.attachment_at(i), level, context};
        const crowd::MechanismKind &kind = call.mechanism().kind;
        const crowd::HostMechanism *host = std::get_if<crowd::HostMechanism>(&kind);
        if (level == off || (!context.wanted && !(host && host->memory))) continue;
        ++counts.calls[kind.index()];
        if (host) run(*host, call, writer);
        if (const auto *gaze = std::get_if<crowd::Gaze>(&kind)) run(*gaze, call, writer);
        if (const auto *expression = std::get_if<crowd::Expression>(&kind)) run(*expression, call, writer);
        if (const auto *blink = std::get_if<crowd::Blink>(&kind)) run(*blink, call, writer);
        if (const auto *phrase = std::get_if<crowd::Phrase>(&kind)) run(*phrase, call, writer);
    }
}

Plays plays_at(const crowd::Crowd &crowd, uint32_t row, double time_s, MechanismLevels levels) noexcept
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    const crowd::MechanismAttachment *last = nullptr;
    const crowd::Idle *idle = nullptr;
    uint32_t slot = 0;
    for (uint32_t i = behaviours.first_attachment(row); i != model::none;
         i = behaviours.attachment_at(i).next, ++slot) {
        const crowd::MechanismAttachment &attachment = behaviours.attachment_at(i);
        const auto *found = std::get_if<crowd::Idle>(&behaviours.mechanism(attachment.mechanism).kind);
        if (found && mechanism_level(levels, slot) != off) last = &attachment, idle = found;
    }
    if (idle) return idle_plays(*idle, crowd, row, *last, time_s);
    Plays own;
    own.now = crowd.play_of(row);
    return own;
}

}  // namespace claque::behave
