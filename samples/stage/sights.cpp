#include "samples/stage/sights.h"

#include <algorithm>

namespace staged
{

using namespace scenes;

Sights::Sights(const People &people, double lead_s) : people_(people), lead_s_(lead_s), in_view_(people.all().size())
{
    check(clq_scene_create(people.crowd(), &scene_));
    for (size_t i = 0; i < people.all().size(); ++i) {
        const uint32_t index1 = people.all()[i].actor.index1;
        if (person_of_.size() <= index1) person_of_.resize(index1 + 1, UINT32_MAX);
        person_of_[index1] = static_cast<uint32_t>(i);
    }
    hits_.resize(std::max<size_t>(1, clq_crowd_get_actor_count(people.crowd())));
}

void Sights::look(const clq_camera &camera)
{
    uint32_t count = 0;
    check(clq_scene_find_in_frustum(scene_, next_s(), &camera, nullptr, hits_.data(),
                                    static_cast<uint32_t>(hits_.size()), &count));
    count = std::min(count, static_cast<uint32_t>(hits_.size()));
    Sight seen{next_s() + lead_s_, {}};
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t index1 = hits_[i].actor.index1;
        if (index1 < person_of_.size() && person_of_[index1] != UINT32_MAX) seen.people.push_back(person_of_[index1]);
    }
    std::sort(seen.people.begin(), seen.people.end());
    ++looks_;
    const std::lock_guard<std::mutex> lock(mutex_);
    sights_.push_back(std::move(seen));
}

void Sights::tell(clq_stage *stage, const std::vector<clq_agent> &agents, double end_s)
{
    for (;;) {
        Sight seen;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (sights_.empty() || sights_.front().heard_s >= end_s) return;
            seen = std::move(sights_.front());
            sights_.pop_front();
        }
        std::vector<clq_agent> changed;
        std::vector<uint8_t> now;
        for (uint32_t i = 0; i < agents.size(); ++i) {
            const bool is_seen = std::binary_search(seen.people.begin(), seen.people.end(), i);
            if (agents[i].index1 == 0 || in_view_[i] == is_seen) continue;
            in_view_[i] = is_seen;
            changed.push_back(agents[i]), now.push_back(is_seen);
        }
        if (changed.empty()) continue;
        static_assert(sizeof(bool) == 1);
        check(clq_stage_tell_view(stage, changed.data(), reinterpret_cast<const bool *>(now.data()),
                                  static_cast<uint32_t>(changed.size()), seen.heard_s));
    }
}

void Sights::put(BytesOut &out) const
{
    out.put(looks_);
    for (const bool seen : in_view_) out.put<uint8_t>(seen);
    const std::lock_guard<std::mutex> lock(mutex_);
    out.put<uint64_t>(sights_.size());
    for (const Sight &one : sights_) {
        out.put(one.heard_s);
        out.put<uint64_t>(one.people.size());
        for (const uint32_t person : one.people) out.put(person);
    }
}

void Sights::take(BytesIn &in)
{
    constexpr uint64_t most_sights = 1000;  // of the longest lead
    looks_ = in.take<uint64_t>();
    for (size_t i = 0; i < in_view_.size(); ++i) in_view_[i] = in.take<uint8_t>() != 0;
    const std::lock_guard<std::mutex> lock(mutex_);
    sights_.resize(in.count(most_sights));
    for (Sight &one : sights_) {
        one.heard_s = in.take<double>();
        one.people.resize(in.count(in_view_.size()));
        for (uint32_t &person : one.people) person = in.take<uint32_t>();
    }
}

}  // namespace staged
