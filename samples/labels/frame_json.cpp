#include "samples/labels/frame_json.h"

#include <cmath>

#include "samples/labels/frame_files.h"
#include "samples/labels/rle.h"

namespace labels
{
namespace
{

Json box_json(const Box &box) { return {box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0}; }

Json keypoint_json(const Keypoint &point)
{
    static const char *const words[] = {"absent", "outside", "hidden", "visible"};
    Json out;
    out["seen"] = words[static_cast<int>(point.seen)];
    if (point.seen != Seen::absent) out["px"] = point.px, out["world"] = point.world;
    return out;
}

// The pinhole of a perspective in pixels; rotation_xyzw takes the world to the eye, which looks along -z with y up.
Json camera_json(const Sample &sample)
{
    const float *p = sample.camera.projection;
    Json out;
    out["fx"] = static_cast<double>(p[0]) * sample.width / 2, out["fy"] = static_cast<double>(p[5]) * sample.height / 2;
    out["cx"] = (1 - static_cast<double>(p[8])) * sample.width / 2;
    out["cy"] = (1 + static_cast<double>(p[9])) * sample.height / 2;
    out["eye"] = {sample.camera.eye[0], sample.camera.eye[1], sample.camera.eye[2]};
    const float *q = sample.camera.rotation_xyzw;
    out["rotation_xyzw"] = {q[0], q[1], q[2], q[3]};
    out["projection"] = std::vector<float>(p, p + 16);
    return out;
}

}  // namespace

Json frame_json(const Sample &sample)
{
    Json out;
    out["frame"] = sample.frame, out["time_s"] = sample.time_s;
    out["width"] = sample.width, out["height"] = sample.height;
    out["camera"] = camera_json(sample);
    out["people"] = Json::array();
    for (const Person &person : sample.people) {
        Json one;
        one["id"] = person.actor, one["character"] = person.character;
        one["visible_px"] = person.visible_px, one["silhouette_px"] = person.whole_px;
        one["visible_box"] = box_json(person.visible), one["whole_box"] = box_json(person.whole);
        if (person.visible_px > 0)
            one["mask"] = letters_of(runs_of(sample.actor, person.actor, sample.width, sample.height, person.visible));
        one["keypoints"] = Json::array();
        for (const Keypoint &point : person.keypoints) one["keypoints"].push_back(keypoint_json(point));
        one["head"] = keypoint_json(person.head);
        one["box3d"] = {{"centre", person.centre}, {"size_m", person.size_m}, {"rotation_xyzw", person.rotation_xyzw}};
        out["people"].push_back(one);
    }
    return out;
}

}  // namespace labels
