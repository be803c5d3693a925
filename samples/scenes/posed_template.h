// A template alone in a crowd of its own, in any pose of its clips. It shows the same whether the template was made
// from the file of a character or read from a prepared one.
#pragma once

#include <claque/claque.h>

#include <array>
#include <limits>
#include <vector>

#include "samples/scenes/library.h"

namespace scenes
{

// In model units.
struct PoseBox {
    std::array<double, 3> low, high;
    static PoseBox none()
    {
        constexpr double end = std::numeric_limits<double>::infinity();
        return {{end, end, end}, {-end, -end, -end}};
    }
    bool is_none() const { return low[0] > high[0]; }
    double size(size_t axis) const { return high[axis] - low[axis]; }
    void hold(const std::array<double, 3> &point);
    void hold(const PoseBox &other);
};

class PosedTemplate
{
public:
    // In the rest pose at first.
    PosedTemplate(Library &library, const clq_template *tmpl);

    // `clip`: CLQ_NONE: the rest pose. `time_s`: from the beginning of the clip.
    void pose(uint32_t clip, double time_s);
    std::array<double, 16> node(uint32_t node) const;
    // x, y and z of all vertices of the finest level, without the root path.
    std::vector<float> vertices();
    // The box of the shown vertices, on the root path; none() without vertices.
    PoseBox box();
    // The boxes of `poses` poses of a clip, at even times from its beginning to its end, and their union.
    std::vector<PoseBox> boxes_of_clip(uint32_t clip, uint32_t poses);
    PoseBox box_of_clip(uint32_t clip, uint32_t poses);

    const clq_template_info &info() const { return info_; }
    // The length of a clip.
    double length_s(uint32_t clip) const;

private:
    void show();

    const clq_template *tmpl_;
    clq_template_info info_ = clq_template_info_init();
    Own<clq_crowd> crowd_;
    clq_view *view_ = nullptr;  // ends with its crowd
    clq_actor actor_ = {};
    double away_ = 1;  // of the eye, on the z axis
    clq_drawn_actor drawn_ = clq_drawn_actor_init();
};

// The box of a character as it stands, for its scale, its ground and its place among others. `first_clip`: the first
// that is shown; `one_clip`: and no other.
PoseBox standing_box(PosedTemplate &posed, uint32_t first_clip, bool one_clip);

}  // namespace scenes
