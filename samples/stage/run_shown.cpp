// The flow of a run that draws.
#include <cmath>

#include "samples/stage/door_leaves.h"
#include "samples/stage/run.h"

namespace staged
{

using namespace scenes;

void Run::deed(const Deed &one)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    deeds_.push_back(one);
}

void Run::appear(const Deed &one)
{
    const Person &person = people_.all()[one.what];
    if (navigation_) check(clq_actor_leave_track(crowd(), person.actor, one.at_s));
    const clq_transform place = stand(one.spot.position[0], one.spot.position[1], one.spot.position[2],
                                      std::sin(one.spot.heading_rad), std::cos(one.spot.heading_rad), person.scale);
    check(clq_crowd_set_transforms(crowd(), &person.actor, &place, 1));
}

// People appear before the first command, and vanish after the last one.
void Run::show(double time_s)
{
    shown_s_ = time_s;
    std::vector<Deed> due;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (; !deeds_.empty() && deeds_.front().at_s <= time_s; deeds_.pop_front()) due.push_back(deeds_.front());
    }
    for (const Deed &one : due)
        if (one.kind == Deed::Kind::appear) appear(one);
    clq_stage_applied applied = clq_stage_applied_init();
    check(clq_stage_apply(stage_.get(), crowd(), time_s, &applied));
    for (const Deed &one : due) {
        if (one.kind == Deed::Kind::vanish) people_.send_away(one.what);
        if (one.kind == Deed::Kind::open || one.kind == Deed::Kind::close)
            set_open(crowd(), one.what, one.kind == Deed::Kind::open);
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    counts_.commands += applied.commands, counts_.refused += applied.refused, counts_.late += applied.late;
}

void Run::look(double time_s, const std::function<void(double)> &reach)
{
    constexpr double aspect = 4.0 / 3;
    while (sights_ && sights_->next_s() <= time_s) {
        const double now_s = sights_->next_s();
        reach(now_s);
        if (now_s > shown_s_) show(now_s);
        sights_->look(path_->camera(now_s, aspect));
    }
}

void Run::send_all(const std::string &event, double value)
{
    clq_stage_event made = clq_stage_event_init();
    made.name = event.c_str(), made.value = value;
    made.at_s = std::max(shown_s_, begin_s) + heard_after_s(described_);
    check(clq_stage_send(stage_.get(), &made), "the event '" + event + "'");
}

RunCounts Run::counts() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return counts_;
}

std::vector<DoorCount> Run::doors() const
{
    std::vector<DoorCount> all;
    for (const auto &service : services_) service->tell(all);
    return all;
}

clq_stage_info Run::info() const
{
    clq_stage_info info = clq_stage_info_init();
    check(clq_stage_get_info(stage_.get(), &info));
    return info;
}

}  // namespace staged
