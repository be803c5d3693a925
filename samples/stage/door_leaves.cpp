#include "samples/stage/door_leaves.h"

#include <algorithm>

namespace staged
{

using namespace scenes;

namespace
{

constexpr Rgb wood = {0.42f, 0.29f, 0.18f};
constexpr double tall_m = 2.1;

clq_group group_of(size_t door) { return {static_cast<uint32_t>(door) + 1, 1}; }

Vec3 corner(const Outline &outline, size_t i, double y)
{
    const size_t k = 2 * (i % (outline.size() / 2));
    return {static_cast<float>(outline[k]), static_cast<float>(y), static_cast<float>(outline[k + 1])};
}

// Counter-clockwise seen from above, where +z is to the south.
bool runs_round(const Outline &outline)
{
    double twice = 0;
    for (size_t i = 0; i < outline.size(); i += 2) {
        const size_t next = (i + 2) % outline.size();
        twice += outline[i + 1] * outline[next] - outline[i] * outline[next + 1];
    }
    return twice > 0;
}

Outline turned_round(Outline outline)
{
    Outline back;
    for (size_t i = outline.size(); i > 0; i -= 2) back.insert(back.end(), {outline[i - 2], outline[i - 1]});
    return back;
}

}  // namespace

void add_doors(clq_crowd *crowd, const std::vector<ScenarioDoor> &doors)
{
    for (size_t i = 0; i < doors.size(); ++i) {
        clq_group made{};
        check(clq_group_create(crowd, nullptr, &made));
        if (made.index1 != group_of(i).index1 || made.generation != group_of(i).generation)
            throw Failure(doors[i].at + ": the crowd has groups before its doors");
        if (!doors[i].open) set_open(crowd, i, false);
    }
}

void set_open(clq_crowd *crowd, size_t door, bool open) { check(clq_group_set_enabled(crowd, group_of(door), open)); }

std::optional<bool> is_open(const clq_crowd *crowd, size_t door)
{
    clq_group_info info = clq_group_info_init();
    if (clq_group_get_info(crowd, group_of(door), &info) != CLQ_OK) return std::nullopt;
    return info.enabled;
}

DoorLeaves::DoorLeaves(const std::vector<ScenarioDoor> &doors)
{
    for (const ScenarioDoor &door : doors) {
        Geometry leaf;
        const Outline outline = runs_round(door.outline) ? door.outline : turned_round(door.outline);
        const double low = std::max(door.low_m, 0.0), high = std::min(door.high_m, low + tall_m);
        for (size_t i = 0; i < outline.size() / 2; ++i)
            leaf.quad({corner(outline, i, low), corner(outline, i + 1, low), corner(outline, i + 1, high),
                       corner(outline, i, high)},
                      wood);
        for (size_t i = 2; i < outline.size() / 2; ++i)
            leaf.quad({corner(outline, 0, high), corner(outline, i - 1, high), corner(outline, i, high),
                       corner(outline, i, high)},
                      wood);
        leaves_.push_back(std::move(leaf));
    }
}

void DoorLeaves::draw(const Gl &gl, const std::function<bool(size_t)> &is_open) const
{
    gl.Disable(scenes::gl::texture_2d);
    for (size_t i = 0; i < leaves_.size(); ++i)
        if (!is_open(i)) leaves_[i].draw(gl);
}

}  // namespace staged
