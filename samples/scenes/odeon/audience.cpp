#include "samples/scenes/odeon/audience.h"

#include <algorithm>
#include <cmath>

namespace scenes
{
namespace
{

// Sideways from each seat to the nearest taken seat of the row in front; 9 if none is near.
double aside_of(const std::vector<Seat> &seats, const std::vector<bool> &taken, size_t seat)
{
    const Seat &own = seats[seat];
    double nearest = 9;
    for (size_t other = seat; other-- > 0 && seats[other].row + 1 >= own.row;) {
        if (!taken[other] || seats[other].row == own.row) continue;
        const double dx = seats[other].x - own.x, dz = seats[other].z - own.z;
        const double ahead = dx * own.facing_x + dz * own.facing_z;
        if (ahead < 1.2) nearest = std::min(nearest, std::abs(dx * own.facing_z - dz * own.facing_x));
    }
    return nearest;
}

// A little below the exact speed: rounding must not restart a clip at its end if the clip does not loop.
float rounded_down(double speed) { return std::nextafter(static_cast<float>(speed), 0.0f); }

}  // namespace

std::vector<Member> members_of(const Theatre &theatre, const std::vector<Seat> &seats,
                               const std::vector<Sitter> &sitters, uint64_t seed)
{
    std::vector<bool> taken(seats.size(), false);
    for (const Sitter &sitter : sitters) taken[sitter.seat] = true;
    std::vector<Member> members;
    for (const Sitter &sitter : sitters) {
        Member member;
        member.seed = seed;
        member.person = sitter.seat;
        member.x = seats[sitter.seat].x;
        member.z = seats[sitter.seat].z;
        member.aside_m = aside_of(seats, taken, sitter.seat);
        member.temperament = theatre.classes[sitter.social_class].temperament;
        members.push_back(member);
    }
    return members;
}

Audience::Audience(Library &library, const Theatre &theatre, const CrowdOptions &crowd_options)
    : seats_(seats_of(theatre)),
      sitters_(seat_people(theatre, seats_, crowd_options.count, crowd_options.seed)),
      members_(members_of(theatre, seats_, sitters_, crowd_options.seed)),
      scene_crowd_(library, crowd_options)
{
    std::vector<std::vector<clq_hsb_range>> palette;
    for (const SocialClass &one : theatre.classes) {
        figure_of_.push_back(figure(library, one.character, crowd_options.lod));
        palette.push_back(ranges_of(figures_[figure_of_.back()].tmpl, one));
    }
    for (size_t i = 0; i < sitters_.size(); ++i) {
        const Sitter &sitter = sitters_[i];
        const Figure &worn = figures_[figure_of_[sitter.social_class]];
        members_[i].duration_s = worn.duration_s;
        clq_play still = {};
        still.clip = worn.clips[0];
        still.speed = 1;
        scene_crowd_.enter({worn.tmpl, sitter.place, still}, sitter.seat, palette[sitter.social_class]);
    }
    playing_.resize(members_.size());
}

size_t Audience::figure(Library &library, const std::string &name, Lod lod)
{
    for (size_t i = 0; i < figures_.size(); ++i)
        if (figures_[i].name == name) return i;
    Figure made;
    made.name = name;
    clq_template *tmpl = made.tmpl = lod == Lod::on ? library.builtin(name, {}) : library.builtin(name);
    for (size_t a = 0; a < act_count; ++a) {
        const char *clip = clip_name(static_cast<Act>(a));
        made.clips[a] = clq_template_find_clip(tmpl, clip);
        clq_clip_info info = clq_clip_info_init();
        if (made.clips[a] != CLQ_NONE) check(clq_template_get_clip(tmpl, made.clips[a], &info));
        if (!(info.duration_s > 0))
            throw Failure("the built-in character '" + name + "' has no clip '" + clip + "' to play");
        made.duration_s[a] = static_cast<double>(info.duration_s);
    }
    figures_.push_back(std::move(made));
    return figures_.size() - 1;
}

void Audience::act(double time_s)
{
    for (size_t i = 0; i < members_.size(); ++i) {
        Playing &now = playing_[i];
        if (now.begin_s <= time_s && time_s < now.end_s) continue;
        now = playing_at(members_[i], time_s);
        clq_play play = {};
        play.clip = figures_[figure_of_[sitters_[i].social_class]].clips[static_cast<size_t>(now.act)];
        play.start_s = now.begin_s;
        play.speed = rounded_down(now.speed);
        scene_crowd_.play(i, play);
    }
}

std::vector<clq_template *> Audience::templates() const
{
    std::vector<clq_template *> all;
    for (const Figure &figure : figures_) all.push_back(figure.tmpl);
    return all;
}

}  // namespace scenes
