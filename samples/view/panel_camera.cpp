// The camera: the scene's, a free one, or one that follows a person; kept ones; a path of key frames.
#include <algorithm>

#include "samples/view/panels.h"

namespace view
{
namespace
{

void choose_view(Ui &ui, View &view, const World &world, bool picked)
{
    std::vector<std::string> items = {"overview", "close", "free"};
    if (picked) items.emplace_back("follow");
    if (world.has_path()) items.emplace_back("path");
    const std::string now = view.mode == CameraMode::free     ? "free"
                            : view.mode == CameraMode::follow ? "follow"
                            : view.shot == 2                  ? "path"
                            : view.shot == 1                  ? "close"
                                                              : "overview";
    int chosen = static_cast<int>(std::find(items.begin(), items.end(), now) - items.begin());
    if (!ui.choice("camera", chosen, items)) return;
    const std::string &name = items[static_cast<size_t>(chosen)];
    view.mode = name == "free" ? CameraMode::free : name == "follow" ? CameraMode::follow : CameraMode::scene;
    if (view.mode == CameraMode::scene) view.shot = name == "path" ? 2 : name == "close" ? 1 : 0;
}

void keep_and_recall(Ui &ui, Model &model)
{
    View &view = model.view;
    const std::vector<std::string> numbers = {"1", "2", "3", "4", "5"};
    int keep = -1, recall = -1;
    if (ui.choice("keep as", keep, numbers)) {
        view.kept[static_cast<size_t>(keep)] = view.free;
        model.message = "camera " + numbers[static_cast<size_t>(keep)] + " is kept";
    }
    std::vector<std::string> kept;
    for (size_t k = 0; k < numbers.size(); ++k)
        if (view.kept[k]) kept.push_back(numbers[k]);
    if (kept.empty() || !ui.choice("recall", recall, kept)) return;
    const std::string &number = kept[static_cast<size_t>(recall)];
    view.free = *view.kept[static_cast<size_t>(number[0] - '1')];
    view.mode = CameraMode::free;
}

void key_frames(Ui &ui, Model &model)
{
    View &view = model.view;
    if (ui.button("add key")) {
        const double time_s = model.clock.time_s;
        view.path.erase(std::remove_if(view.path.begin(), view.path.end(),
                                       [&](const View::Key &key) { return key.time_s == time_s; }),
                        view.path.end());
        view.path.push_back({time_s, view.free});
        std::sort(view.path.begin(), view.path.end(),
                  [](const View::Key &a, const View::Key &b) { return a.time_s < b.time_s; });
    }
    if (view.path.empty()) return;
    if (view.path.size() > 1 && ui.button("save path", true)) model.wishes.save_path = true;
    if (ui.button("forget keys", true)) view.path.clear();
    if (view.path.empty()) return;
    ui.faint(std::to_string(view.path.size()) + " keys, " + fixed(view.path.front().time_s, 2) + " to " +
             fixed(view.path.back().time_s, 2) + " s");
}

}  // namespace

void camera_panel(Ui &ui, Model &model, const World &world)
{
    View &view = model.view;
    choose_view(ui, view, world, model.picked.actor.index1 != 0);
    keep_and_recall(ui, model);
    float field = static_cast<float>(view.free.fov_rad * 57.29577951308232);
    if (ui.slider("field", field, 5, 120, "%.0f degrees")) {
        if (view.mode == CameraMode::scene) view.mode = CameraMode::free;
        view.free.fov_rad = static_cast<double>(field) / 57.29577951308232;
    }
    key_frames(ui, model);
    ui.text_field("saved as", model.saved_as);
    int tint = static_cast<int>(model.tint);
    if (ui.choice("colours", tint, {"own", "level", "rate", "age", "cache", "zones"})) {
        model.tint = static_cast<Tint>(tint);
        if (model.tint == Tint::nothing) model.wishes.anew = true;  // their own colours again
    }
    if (model.tint == Tint::level) ui.faint("green: the finest level, violet: the coarsest");
    if (model.tint == Tint::rate) ui.faint("green: 50 poses a second, violet: 4");
    if (model.tint == Tint::age) ui.faint("green: a pose of now, violet: of 0.25 s ago");
    if (model.tint == Tint::cache) {
        ui.faint("green: vertices from the cache, " + std::to_string(model.served[0]));
        ui.faint("yellow: skinned from a cached palette, " + std::to_string(model.served[1]));
        ui.faint("red: posed and skinned anew, " + std::to_string(model.served[2]));
    }
    if (model.tint == Tint::zones) ui.faint("green: triangles of one zone each, violet: half of them have several");
    ui.toggle("bounding spheres", model.spheres);
}

}  // namespace view
