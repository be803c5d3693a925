// Time: pause, steps, speed, and any moment by a slider.
#include <cmath>

#include "samples/view/panels.h"

namespace view
{

std::string status(const Model &model, size_t letters)
{
    if (!model.message.empty()) return model.message;
    std::string hands = "click: pick";
    for (const char *more :
         {"drag: turn", "wheel: zoom", "shift: pan", "F: frame", "tab: panels", "WASD: walk", "space: pause"}) {
        const std::string longer = hands + ", " + more;
        if (longer.size() > letters) break;
        hands = longer;
    }
    return hands;
}

void time_bar(Ui &ui, Model &model, size_t letters)
{
    constexpr double step_s = 0.04;
    Clock &clock = model.clock;
    ui.toggle("pause", clock.paused);
    if (ui.button("back", true)) clock.paused = true, clock.time_s -= step_s;
    if (ui.button("step", true)) clock.paused = true, clock.time_s += step_s;
    if (ui.button("picture", true)) model.wishes.picture = true;
    ui.toggle("film", model.film, true);
    ui.toggle("panels", model.panel, true);
    ui.rest_of_line(6);
    ui.slider("speed", clock.speed, 0.05f, 8, "%.2f x", true);
    // The slider reaches as far as the scene does; a scene without an end is given another minute when it is over.
    while (clock.time_s > clock.last_s) clock.last_s += 60;
    float at = static_cast<float>(clock.time_s);
    if (ui.slider("time", at, static_cast<float>(clock.first_s), static_cast<float>(clock.last_s), "%.2f s"))
        clock.time_s = static_cast<double>(at);
    ui.faint(status(model, letters));
}

}  // namespace view
