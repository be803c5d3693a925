#include "lib/model/clip_annotations.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/model/rig.h"

namespace claque::model
{

using base::fail;

namespace
{

void check_marker(const Rig &rig, size_t i)
{
    const Marker &marker = rig.markers[i];
    const char *name = rig.marker_names[i].c_str();
    if (marker.clip >= rig.clips.size())
        fail(CLQ_ARGUMENT, "marker %zu '%s' is of clip %u, which does not exist: there are %zu", i, name, marker.clip,
             rig.clips.size());
    const Clip &clip = rig.clips[marker.clip];
    if (!(marker.time_s >= clip.start_s && marker.time_s <= clip.start_s + clip.duration_s))
        fail(CLQ_ARGUMENT, "marker %zu '%s' is at %g s of clip '%s', which goes from %g to %g s", i, name,
             static_cast<double>(marker.time_s), rig.clip_names[marker.clip].c_str(), static_cast<double>(clip.start_s),
             static_cast<double>(clip.start_s + clip.duration_s));
    if (i == 0) return;
    const Marker &before = rig.markers[i - 1];
    if (before.clip > marker.clip || (before.clip == marker.clip && before.time_s > marker.time_s))
        fail(CLQ_ARGUMENT, "marker %zu '%s' comes after a later one", i, name);
}

}  // namespace

void check_annotations(const Rig &rig)
{
    if (rig.markers.size() != rig.marker_names.size())
        fail(CLQ_ARGUMENT, "%zu markers have %zu names", rig.markers.size(), rig.marker_names.size());
    for (size_t i = 0; i < rig.markers.size(); ++i) check_marker(rig, i);
    const size_t samples = rig.root_samples.size() / 3;
    for (size_t i = 0; i < rig.root_curves.size(); ++i) {
        const RootCurve &curve = rig.root_curves[i];
        if (curve.clip >= rig.clips.size())
            fail(CLQ_ARGUMENT, "root motion %zu is of clip %u, which does not exist: there are %zu", i, curve.clip,
                 rig.clips.size());
        if (i > 0 && rig.root_curves[i - 1].clip >= curve.clip)
            fail(CLQ_ARGUMENT, "root motion %zu is not behind that of an earlier clip", i);
        if (curve.sample_count < 2 || curve.first_sample > samples || curve.sample_count > samples - curve.first_sample)
            fail(CLQ_ARGUMENT, "root motion %zu takes samples %u to %u, two or more of which must exist: there are %zu",
                 i, curve.first_sample, curve.first_sample + curve.sample_count, samples);
    }
    for (const float x : rig.root_samples)
        if (!std::isfinite(x)) fail(CLQ_ARGUMENT, "a sample of a root's motion is not finite");
}

}  // namespace claque::model
