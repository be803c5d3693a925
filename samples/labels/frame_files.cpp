#include "samples/labels/frame_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "samples/io/npy.h"
#include "samples/io/png.h"
#include "samples/labels/npz.h"
#include "samples/labels/sheet.h"
#include "samples/scenes/check.h"

namespace labels
{
namespace
{

std::string text_of(const std::vector<unsigned char> &bytes) { return std::string(bytes.begin(), bytes.end()); }

std::vector<size_t> shape_of(const Sample &sample, size_t per_pixel)
{
    std::vector<size_t> shape = {static_cast<size_t>(sample.height), static_cast<size_t>(sample.width)};
    if (per_pixel > 1) shape.push_back(per_pixel);
    return shape;
}

// red + 256 green + 65536 blue, as COCO's panoptic pictures.
std::string panoptic(const Sample &sample)
{
    std::vector<uint8_t> rgb;
    for (const uint32_t actor : sample.actor)
        rgb.insert(rgb.end(),
                   {static_cast<uint8_t>(actor), static_cast<uint8_t>(actor >> 8), static_cast<uint8_t>(actor >> 16)});
    return text_of(io::quick_png(rgb, sample.width, sample.height, 3));
}

// KITTI's flow: 64ths of a pixel about 2^15, and whether there is any.
std::string kitti_flow(const Sample &sample, const std::vector<float> &flow)
{
    std::vector<uint16_t> values;
    for (size_t i = 0; i < flow.size(); i += 2) {
        const double u = std::round(64 * static_cast<double>(flow[i]) + 32768),
                     v = std::round(64 * static_cast<double>(flow[i + 1]) + 32768);
        const bool valid = u >= 0 && u <= 65535 && v >= 0 && v <= 65535;
        values.insert(values.end(), {static_cast<uint16_t>(valid ? u : 0), static_cast<uint16_t>(valid ? v : 0),
                                     static_cast<uint16_t>(valid ? 1 : 0)});
    }
    return text_of(io::quick_png(values, sample.width, sample.height, 3));
}

// Middlebury's flow; unknown: above 10^9.
std::string flo(const Sample &sample, const std::vector<float> &flow)
{
    std::string out = "PIEH";
    const int32_t size[2] = {sample.width, sample.height};
    out.append(reinterpret_cast<const char *>(size), sizeof size);
    std::vector<float> values = flow;
    for (float &value : values)
        if (std::isnan(value)) value = 1e10f;
    return out.append(reinterpret_cast<const char *>(values.data()), sizeof(float) * values.size());
}

// KITTI's depth: 256ths of a metre, 0 where there is none. 65535 stands for all that is farther.
std::string depth(const Sample &sample)
{
    std::vector<uint16_t> values;
    for (const float d : sample.depth_m)
        values.push_back(
            std::isnan(d) ? 0
                          : static_cast<uint16_t>(std::clamp(std::round(256 * static_cast<double>(d)), 1.0, 65535.0)));
    return text_of(io::quick_png(values, sample.width, sample.height, 1));
}

std::string normals(const Sample &sample)
{
    std::vector<uint8_t> values;
    for (const float n : sample.normal)
        values.push_back(std::isnan(n) ? 0 : static_cast<uint8_t>(std::lround(127.5 * (static_cast<double>(n) + 1))));
    return text_of(io::quick_png(values, sample.width, sample.height, 3));
}

// People per pixel: a Gaussian round each head that is in the picture, whose sum is 1 also at the border.
std::vector<float> density(const Sample &sample)
{
    constexpr double sigma_px = 4;
    constexpr int reach = 12;
    std::vector<float> out(sample.actor.size(), 0);
    for (const Person &person : sample.people) {
        if (person.head.seen != Seen::visible && person.head.seen != Seen::hidden) continue;
        const int x0 = static_cast<int>(person.head.px[0]), y0 = static_cast<int>(person.head.px[1]);
        const auto each = [&](const auto &visit) {
            for (int y = std::max(0, y0 - reach); y <= std::min(sample.height - 1, y0 + reach); ++y)
                for (int x = std::max(0, x0 - reach); x <= std::min(sample.width - 1, x0 + reach); ++x) {
                    const double dx = x + 0.5 - person.head.px[0], dy = y + 0.5 - person.head.px[1];
                    visit(static_cast<size_t>(y) * static_cast<size_t>(sample.width) + static_cast<size_t>(x),
                          std::exp(-(dx * dx + dy * dy) / (2 * sigma_px * sigma_px)));
                }
        };
        double sum = 0;
        each([&](size_t, double weight) { sum += weight; });
        each([&](size_t at, double weight) { out[at] += static_cast<float>(weight / sum); });
    }
    return out;
}

std::string archive(const Sample &sample)
{
    std::vector<std::pair<std::string, std::string>> arrays;
    const auto add = [&](const char *name, const char *type, const auto &values, size_t per_pixel) {
        if (!values.empty()) arrays.emplace_back(name, io::npy(type, shape_of(sample, per_pixel), values));
    };
    add("rgb", "|u1", sample.rgb, 3), add("actor", "<u4", sample.actor, 1), add("zone", "<u2", sample.zone, 1);
    add("part", "<u2", sample.part, 1), add("depth_m", "<f4", sample.depth_m, 1);
    add("normal", "<f4", sample.normal, 3), add("position", "<f8", sample.position, 3);
    add("flow_forward", "<f4", sample.forward, 2), add("flow_backward", "<f4", sample.backward, 2);
    return npz(arrays);
}

}  // namespace

std::string number_of(int frame)
{
    char text[16];
    std::snprintf(text, sizeof text, "%06d", frame);
    return text;
}

std::vector<FrameFile> frame_files(const Sample &sample, const std::set<std::string> &formats)
{
    std::vector<FrameFile> out;
    const std::string number = number_of(sample.frame);
    const auto add = [&](const char *format, const std::string &path, const auto &make) {
        if (formats.count(format) != 0) out.push_back({path, make()});
    };
    if (!sample.rgb.empty())
        out.push_back(
            {"images/" + number + ".png", text_of(io::quick_png(sample.rgb, sample.width, sample.height, 3))});
    add("panoptic", "panoptic/" + number + ".png", [&] { return panoptic(sample); });
    add("kitti-flow", "flow_forward/" + number + ".png", [&] { return kitti_flow(sample, sample.forward); });
    add("kitti-flow", "flow_backward/" + number + ".png", [&] { return kitti_flow(sample, sample.backward); });
    add("flo", "flow_forward/" + number + ".flo", [&] { return flo(sample, sample.forward); });
    add("flo", "flow_backward/" + number + ".flo", [&] { return flo(sample, sample.backward); });
    add("depth", "depth/" + number + ".png", [&] { return depth(sample); });
    add("depth", "depth/" + number + ".npy", [&] { return io::npy("<f4", shape_of(sample, 1), sample.depth_m); });
    add("normals", "normals/" + number + ".png", [&] { return normals(sample); });
    add("heads", "density/" + number + ".npy", [&] { return io::npy("<f4", shape_of(sample, 1), density(sample)); });
    add("npz", "arrays/" + number + ".npz", [&] { return archive(sample); });
    add("sheet", "sheets/" + number + ".png", [&] { return text_of(sheet(sample)); });
    return out;
}

}  // namespace labels
