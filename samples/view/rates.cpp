#include "samples/view/rates.h"

#include <algorithm>
#include <numeric>

#include <nlohmann/json.hpp>

namespace view
{
namespace
{

// null where nothing was measured.
nlohmann::json quantile(std::vector<double> values, double share)
{
    values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return value < 0; }), values.end());
    if (values.empty()) return nullptr;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

void Rates::add(double frame_s, const Model &model)
{
    frame_ms_.push_back(frame_s * 1000);
    update_ms_.push_back(model.cost.place_ms + model.cost.update_ms);
    surroundings_ms_.push_back(model.cost.surroundings_ms);
    crowd_ms_.push_back(model.cost.crowd_ms);
    interface_ms_.push_back(model.cost.interface_ms);
    interface_gl_ms_.push_back(model.cost.interface_gl_ms);
}

std::string Rates::json(const std::string &gl, int processes, uint32_t ended) const
{
    const double all_ms = std::accumulate(frame_ms_.begin(), frame_ms_.end(), 0.0);
    nlohmann::ordered_json out;
    out["gl"] = gl;
    out["processes"] = processes;
    out["ended_processes"] = ended;
    out["frames"] = frame_ms_.size();
    out["frames_per_s"] = all_ms > 0 ? 1000 * static_cast<double>(frame_ms_.size()) / all_ms : 0;
    out["frame_ms"] = {{"median", quantile(frame_ms_, 0.5)}, {"most_of_95_percent", quantile(frame_ms_, 0.95)}};
    out["median_ms"] = {{"update", quantile(update_ms_, 0.5)},
                        {"surroundings", quantile(surroundings_ms_, 0.5)},
                        {"crowd", quantile(crowd_ms_, 0.5)},
                        {"panels", quantile(interface_ms_, 0.5)},
                        {"panels_in_gl", quantile(interface_gl_ms_, 0.5)}};
    return out.dump(2) + "\n";
}

}  // namespace view
