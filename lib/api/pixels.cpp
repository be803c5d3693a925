// What the pixels of a visibility picture show.
#include <claque/visibility.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "lib/api/boundary.h"
#include "lib/api/camera_def.h"
#include "lib/api/inspected.h"
#include "lib/math/eye_transform.h"
#include "lib/visibility/channels.h"
#include "lib/visibility/flow.h"

using namespace claque;

namespace
{

// A picture that was checked, with the vertices of the individuals in it.
class Checked
{
public:
    Checked(const clq_view *view, const clq_pixels &pixels)
        : view_(view),
          pixels_(pixels),
          memory_(&view->crowd->context->memory),
          numbers_(view->view.list, memory_),
          shown_(view->view.list.items.size(), 0, memory_),
          vertices_(view->view.list.items.size(), memory_),
          skinned_(memory_)
    {
        api::require(pixels.numbers != nullptr, "numbers is NULL");
        api::require(pixels.width_px > 0 && pixels.height_px > 0, "width_px or height_px is 0");
        api::require(pixels.first_number > 0, "first_number is 0, which stands for no triangle");
        find_shown();
        for (size_t i = 0; i < shown_.size(); ++i)
            if (shown_[i]) vertices_[i] = skinned_.emplace_back(view).vertices(view->view.list.items[i]);
    }

    visibility::Picture picture() const
    {
        return {pixels_, view_->view.list, numbers_, {vertices_.data(), static_cast<uint32_t>(vertices_.size())}};
    }
    bool shows(uint32_t item) const { return shown_[item] != 0; }

private:
    void find_shown()
    {
        const size_t count = size_t(pixels_.width_px) * pixels_.height_px;
        uint32_t last = 0;
        for (size_t pixel = 0; pixel < count; ++pixel) {
            const uint32_t number = pixels_.numbers[pixel];
            if (number == last || number < pixels_.first_number) continue;
            last = number;
            if (number - pixels_.first_number >= numbers_.count())
                base::fail(CLQ_ARGUMENT, "pixel %zu has number %u, but the draw list has %llu triangles from %u on",
                           pixel, number, static_cast<unsigned long long>(numbers_.count()), pixels_.first_number);
            shown_[numbers_.find(number - pixels_.first_number).item] = 1;
        }
    }

    const clq_view *view_;
    const clq_pixels &pixels_;
    std::pmr::memory_resource *memory_;
    visibility::Numbers numbers_;
    std::pmr::vector<uint8_t> shown_;  // by item
    std::pmr::vector<draw::Vertices> vertices_;
    std::pmr::deque<api::Inspected> skinned_;
};

// The individuals of a picture at another time.
class Others
{
public:
    Others(const clq_view *view, const Checked &checked, const frame::Camera &camera, double time_s)
        : moved_(view->view.list.items.size(), &view->crowd->context->memory),
          posed_(view->view.list.items.size(), &view->crowd->context->memory)
    {
        const clq_crowd *crowd = view->crowd;
        const glm::dmat3 turn = math::rotation_of(camera.rotation);
        crowd->context->jobs.try_each(static_cast<uint32_t>(moved_.size()), [&](uint32_t i) {
            const draw::Item &item = view->view.list.items[i];
            const uint32_t row = item.actor_index;
            if (!checked.shows(i) || row >= crowd->crowd.row_count() || !crowd->crowd.alive(row) ||
                crowd->crowd.actor(row).generation != item.generation || !is_present(crowd->crowd, row, time_s))
                return;
            if (&crowd->crowd.template_of(row) != item.tmpl) return;  // another one, of a crowd that was restored
            place(*crowd, item, turn, camera.eye, time_s, i);
        });
    }
    base::Span<const visibility::Moved> moved() const { return {moved_.data(), static_cast<uint32_t>(moved_.size())}; }

private:
    void place(const clq_crowd &crowd, const draw::Item &item, const glm::dmat3 &turn, const glm::dvec3 &eye,
               double time_s, uint32_t index)
    {
        const uint32_t row = item.actor_index;
        const model::Level &level = item.tmpl->levels[item.level];
        posed_[index].emplace(*item.tmpl, &crowd.context->memory);
        const behave::MechanismLevels levels =
            crowd.frame.visibility(crowd.crowd, row).visible
                ? crowd.frame.mechanism_levels(crowd.crowd, row, level)
                : behave::mechanism_levels(crowd.crowd, row, item.eye_distance_m, level);
        posed_[index]->pose(crowd.crowd, row, level, levels, time_s, item.eye_distance_m);
        const crowd::Transform root = frame::root_at(crowd.crowd, row, time_s);
        const math::EyeTransform at =
            math::eye_transform(turn, eye, root.position, root.orientation, double(root.scale));
        moved_[index] = {true, at.axes, at.origin, posed_[index]->skin(level)};
    }

    std::pmr::vector<visibility::Moved> moved_;
    std::pmr::vector<std::optional<frame::PosedAt>> posed_;
};

}  // namespace

extern "C" {

clq_status clq_view_get_pixels(const clq_view *view, const clq_pixels *pixels, const clq_pixel_channels *channels)
{
    return api::boundary("clq_view_get_pixels", [&] {
        api::require(view && pixels && channels, "view, pixels or channels is NULL");
        const clq_pixels given = api::read_def(pixels, clq_pixels_init, "clq_pixels_init");
        const clq_pixel_channels wanted = api::read_def(channels, clq_pixel_channels_init, "clq_pixel_channels_init");
        const api::Drawing drawing(view);
        const Checked checked(view, given);
        const double metres = double(view->crowd->frame.settings().caches.metres_per_unit);
        visibility::write_channels(checked.picture(), metres, view->crowd->context->jobs, wanted);
    });
}

clq_status clq_view_get_flow(const clq_view *view, const clq_pixels *pixels, const clq_flow_def *def, float *out_flow)
{
    return api::boundary("clq_view_get_flow", [&] {
        api::require(view && pixels && def && out_flow, "view, pixels, def or out_flow is NULL");
        const clq_pixels given = api::read_def(pixels, clq_pixels_init, "clq_pixels_init");
        const clq_flow_def wanted = api::read_def(def, clq_flow_def_init, "clq_flow_def_init");
        api::require(std::isfinite(wanted.time_s), "time_s is not finite");
        const frame::Camera camera = api::camera_of(wanted.camera);
        const api::Drawing drawing(view);
        const Checked checked(view, given);
        const Others others(view, checked, camera, wanted.time_s);
        visibility::write_flow(checked.picture(), others.moved(), camera.projection, view->crowd->context->jobs,
                               out_flow);
    });
}

}  // extern "C"
