#pragma once

#include <claque/crowd.h>

#include <string>

namespace api_test
{

// Values by their bytes; of structs with padding, which has any bytes, their fields.
class SeenBytes
{
public:
    template <class... Value>
    void add(const Value &...value)
    {
        (all.append(reinterpret_cast<const char *>(&value), sizeof value), ...);
    }
    void add(const clq_transform &t) { add(t.position, t.orientation_xyzw, t.scale); }
    void add(const clq_actor_info &info)
    {
        add(info.tmpl, info.group.index1, info.group.generation, info.seed, info.visible, info.period_s, info.tick_s,
            info.eye_distance_m, info.level, info.priority, info.refpoint_radius, info.sklsroot_radius,
            info.texture_set);
        add(info.play.clip, info.play.start_s, info.play.speed, info.play.phase_s);
        add(info.transform);
        add(info.root);
    }

    std::string all;
};

}  // namespace api_test
