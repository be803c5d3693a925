// The errors of key-poses (S3 3, 4): vertices of the nearest one, and of two blended, against the exact pose, over the
// multitude's clips, in millimetres and in pixels of a picture of 768 lines over 60 degrees.
#include <algorithm>
#include <cmath>

#include "samples/cli/bench_keypose.h"

namespace cli
{
namespace
{

constexpr double steps_s = 120;  // poses compared for each second of a clip
constexpr double pixels_a_radian = 384 / 0.57735026918962576;

struct Error {
    double most_m = 0, squares = 0, count = 0;
    void add(const std::vector<float> &exact, const std::vector<float> &a, const std::vector<float> &b, double blend)
    {
        double worst = 0;
        for (size_t i = 0; i < exact.size(); i += 3) {
            double square = 0;
            for (size_t k = i; k < i + 3; ++k) {
                const double d = double(a[k]) + (double(b[k]) - double(a[k])) * blend - double(exact[k]);
                square += d * d;
            }
            squares += square;
            worst = std::max(worst, square);
        }
        count += static_cast<double>(exact.size()) / 3;
        most_m = std::max(most_m, std::sqrt(worst));
    }
    double mean_mm() const { return 1000 * std::sqrt(squares / count); }
};

struct Errors {
    Error nearest, blended;
};

class Figure
{
public:
    Figure(scenes::Library &library, const char *name) : name_(name)
    {
        clq_asset *made = nullptr;
        scenes::check(clq_asset_builtin(library.context(), name, &made));
        asset_.reset(made);
        clq_asset_info info = clq_asset_info_init();
        scenes::check(clq_asset_get_info(made, &info));
        floats_ = 3 * size_t(info.vertex_count);
        tmpl_ = library.builtin(name);
    }
    Errors measure(double rate_hz) const
    {
        Errors errors;
        for (const std::string &name : multitude_clips()) {
            const uint32_t clip = clq_template_find_clip(tmpl_, name.c_str());
            clq_clip_info info = clq_clip_info_init();
            scenes::check(clq_template_get_clip(tmpl_, clip, &info));
            const double length = static_cast<double>(info.duration_s);
            const int intervals = static_cast<int>(std::max(1.0, std::round(length * rate_hz)));
            std::vector<float> a = at(clip, info, 0), b;
            for (int k = 0; k < intervals; ++k) {
                b = at(clip, info, length * (k + 1) / intervals);
                const int steps = std::max(2, static_cast<int>(length / intervals * steps_s));
                for (int s = 0; s < steps; ++s) {
                    const double blend = (s + 0.5) / steps;
                    const std::vector<float> exact = at(clip, info, length * (k + blend) / intervals);
                    errors.nearest.add(exact, a, b, blend < 0.5 ? 0 : 1);
                    errors.blended.add(exact, a, b, blend);
                }
                a.swap(b);
            }
        }
        return errors;
    }
    const std::string &name() const { return name_; }

private:
    std::vector<float> at(uint32_t clip, const clq_clip_info &info, double within_s) const
    {
        std::vector<float> positions(floats_);
        scenes::check(clq_asset_get_positions(asset_.get(), clip, static_cast<float>(double(info.start_s) + within_s),
                                              positions.data(), positions.size()));
        return positions;
    }

    std::string name_;
    scenes::Own<clq_asset> asset_;
    clq_template *tmpl_ = nullptr;
    size_t floats_ = 0;
};

double pixels(double metres, double distance_m) { return metres / distance_m * pixels_a_radian; }

}  // namespace

Json key_pose_error(scenes::Library &library)
{
    Json report = chart_of_lines("Errors of key-poses", "key-poses a second", "millimetres");
    report["y"] = {{"title", "millimetres, the worst vertex at any time"}, {"scale", "log"}};
    report["columns"] = {"character and mode", "hz",         "mean mm",    "max mm",
                         "max px at 10 m",     "px at 20 m", "px at 50 m", "mean px at 20 m"};
    for (const char *name : {"decurion", "patrician"}) {
        const Figure figure(library, name);
        Json series[2] = {Json::array(), Json::array()};
        for (const double rate : {7.5, 15.0, 30.0}) {
            const Errors errors = figure.measure(rate);
            const Error *both[2] = {&errors.nearest, &errors.blended};
            for (int way = 0; way < 2; ++way) {
                const Error &e = *both[way];
                report["runs"].push_back(
                    {{"character and mode", std::string(name) + (way == 0 ? ", intermittent" : ", interpolated")},
                     {"hz", rate},
                     {"mean mm", e.mean_mm()},
                     {"max mm", 1000 * e.most_m},
                     {"max px at 10 m", pixels(e.most_m, 10)},
                     {"px at 20 m", pixels(e.most_m, 20)},
                     {"px at 50 m", pixels(e.most_m, 50)},
                     {"mean px at 20 m", pixels(e.mean_mm() / 1000, 20)}});
                series[way].push_back({rate, 1000 * e.most_m});
            }
        }
        for (int way = 0; way < 2; ++way)
            report["series"].push_back(
                {{"name", figure.name() + (way == 0 ? ", intermittent" : ", interpolated")}, {"points", series[way]}});
    }
    report["note"] = "positions of all vertices over the multitude's five clips, " +
                     std::to_string(static_cast<int>(steps_s)) + " poses a second, against the exact pose";
    return report;
}

}  // namespace cli
