#include "samples/labels/collections.h"

#include <cmath>
#include <cstdio>

#include "samples/labels/frame_files.h"

namespace labels
{
namespace
{

// The visible joints have 2, hidden ones 1, all others 0, 0, 0.
Json coco_keypoints_of(const Json &person, int &count)
{
    Json out = Json::array();
    count = 0;
    for (const Json &point : person["keypoints"]) {
        const bool shown = point["seen"] == "visible", hidden = point["seen"] == "hidden";
        if (shown || hidden) ++count;
        out.push_back(shown || hidden ? point["px"][0] : Json(0));
        out.push_back(shown || hidden ? point["px"][1] : Json(0));
        out.push_back(shown ? 2 : hidden ? 1 : 0);
    }
    return out;
}

Json category(const KeypointSet &keypoints)
{
    Json out = {{"id", 1}, {"name", "person"}, {"supercategory", "person"}, {"keypoints", keypoints.names}};
    out["skeleton"] = Json::array();
    for (const std::array<int, 2> &edge : keypoints.edges) out["skeleton"].push_back({edge[0] + 1, edge[1] + 1});
    return out;
}

Json image_json(const Json &frame)
{
    return {{"id", frame["frame"]},
            {"file_name", number_of(frame["frame"].get<int>()) + ".png"},
            {"width", frame["width"]},
            {"height", frame["height"]}};
}

Json coco(const std::vector<Json> &frames, const KeypointSet &keypoints)
{
    Json images = Json::array(), annotations = Json::array();
    int next = 1;
    for (const Json &frame : frames) {
        images.push_back(image_json(frame));
        for (const Json &person : frame["people"]) {
            if (person["visible_px"] == 0) continue;
            int count = 0;
            Json one = {{"id", next++}, {"image_id", frame["frame"]}, {"category_id", 1}, {"iscrowd", 0}};
            one["area"] = person["visible_px"], one["bbox"] = person["visible_box"];
            one["segmentation"] = {{"size", {frame["height"], frame["width"]}}, {"counts", person["mask"]}};
            one["keypoints"] = coco_keypoints_of(person, count), one["num_keypoints"] = count;
            one["track_id"] = person["id"], one["amodal_bbox"] = person["whole_box"];
            annotations.push_back(one);
        }
    }
    return {{"info", {{"description", "labels by claque"}}},
            {"images", images},
            {"annotations", annotations},
            {"categories", {category(keypoints)}}};
}

Json panoptic(const std::vector<Json> &frames)
{
    Json images = Json::array(), annotations = Json::array();
    for (const Json &frame : frames) {
        images.push_back(image_json(frame));
        Json segments = Json::array();
        for (const Json &person : frame["people"])
            if (person["visible_px"] != 0)
                segments.push_back({{"id", person["id"]},
                                    {"category_id", 1},
                                    {"area", person["visible_px"]},
                                    {"bbox", person["visible_box"]},
                                    {"iscrowd", 0}});
        annotations.push_back({{"image_id", frame["frame"]},
                               {"file_name", number_of(frame["frame"].get<int>()) + ".png"},
                               {"segments_info", segments}});
    }
    return {{"images", images},
            {"annotations", annotations},
            {"categories", {{{"id", 1}, {"name", "person"}, {"supercategory", "person"}, {"isthing", 1}}}}};
}

// Frames and pixels count from 1. The box is that of the whole person, the last number the visible share of it.
std::string mot(const std::vector<Json> &frames)
{
    std::string out;
    int number = 0;
    for (const Json &frame : frames) {
        ++number;
        for (const Json &person : frame["people"]) {
            const double whole = person["silhouette_px"].get<double>(), shown = person["visible_px"].get<double>();
            if (whole == 0) continue;
            const Json &box = person["whole_box"];
            char line[200];
            std::snprintf(line, sizeof line, "%d,%u,%.2f,%.2f,%.2f,%.2f,1,1,%.5f\n", number,
                          person["id"].get<unsigned>(), box[0].get<double>() + 1, box[1].get<double>() + 1,
                          box[2].get<double>(), box[3].get<double>(), shown / whole);
            out += line;
        }
    }
    return out;
}

// Of each picture: the members named, of its people.
Json of_people(const std::vector<Json> &frames, const std::vector<std::string> &members)
{
    Json out = Json::array();
    for (const Json &frame : frames) {
        Json people = Json::array();
        for (const Json &person : frame["people"]) {
            Json one;
            for (const std::string &member : members) one[member] = person[member];
            people.push_back(one);
        }
        out.push_back({{"frame", frame["frame"]}, {"time_s", frame["time_s"]}, {"people", people}});
    }
    return out;
}

Json cameras(const std::vector<Json> &frames)
{
    Json out = Json::array();
    for (const Json &frame : frames)
        out.push_back({{"frame", frame["frame"]},
                       {"time_s", frame["time_s"]},
                       {"width", frame["width"]},
                       {"height", frame["height"]},
                       {"camera", frame["camera"]}});
    return out;
}

}  // namespace

std::vector<FrameFile> collections(const std::vector<Json> &frames, const std::set<std::string> &formats,
                                   const KeypointSet &keypoints)
{
    std::vector<FrameFile> out = {{"cameras.json", cameras(frames).dump(1) + "\n"}};
    if (formats.count("coco") != 0) out.push_back({"coco.json", coco(frames, keypoints).dump() + "\n"});
    if (formats.count("panoptic") != 0) out.push_back({"panoptic.json", panoptic(frames).dump() + "\n"});
    if (formats.count("mot") != 0) out.push_back({"mot/gt/gt.txt", mot(frames)});
    if (formats.count("boxes3d") != 0)
        out.push_back({"boxes3d.json", of_people(frames, {"id", "character", "box3d"}).dump(1) + "\n"});
    if (formats.count("heads") != 0) out.push_back({"heads.json", of_people(frames, {"id", "head"}).dump(1) + "\n"});
    return out;
}

}  // namespace labels
