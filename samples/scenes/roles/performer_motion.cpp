// What moves a performer as a whole: clips, fades, layers, the treadmill, flights, and what it carries.
#include <algorithm>
#include <cmath>

#include "samples/scenes/roles/performer.h"

namespace scenes::roles
{

clq_play Performer::play_of(const Clip &clip) const
{
    clq_play play = clq_play_init();
    play.clip = kit_.clip(clip.name);
    play.start_s = clip.start_s, play.speed = clip.speed, play.phase_s = clip.phase_s;
    return play;
}

Treadmill &Performer::treadmill_at(double speed_m_s)
{
    auto &made = treadmills_[static_cast<int>(std::lround(speed_m_s * 100))];
    if (!made) made = std::make_unique<Treadmill>(kit_.library(), crowd_, kit_.tmpl(), kit_.walk(), speed_m_s, home_);
    return *made;
}

void Performer::step_off(double time_s)
{
    if (!treadmill_) return;
    treadmill_ = nullptr;
    const clq_root_path_play none = clq_root_path_play_init();
    check(clq_actor_play_root_path(crowd_, actor_, &none));
    check(clq_actor_leave_track(crowd_, actor_, time_s));
    check(clq_crowd_set_transforms(crowd_, &actor_, &place_, 1));
    layers_.clear();  // they end with the track
}

void Performer::move(const Motion &motion, double time_s)
{
    if (!motion.treadmill_m_s) {
        const bool was_on = treadmill_ != nullptr;
        step_off(time_s);
        if (was_on) follows_own_ = false, fly(given_.flight);
        return play(motion);
    }
    Treadmill &treadmill = treadmill_at(*motion.treadmill_m_s);
    for (const Layer &layer : motion.layers) play_of(layer.clip), kit_.mask(layer.joint, layer.inverted);
    lap_ = treadmill.lap_at(time_s);
    drop_layers();
    treadmill.carry(actor_, lap_);
    treadmill_ = &treadmill;
    add_layers(motion.layers);
}

// All of it anew, so that the crowd is as if nothing else had been told before; but clips that come from the scene are
// left alone, and a fade more is just that.
void Performer::play(const Motion &motion)
{
    const Motion &was = given_.motion;
    const auto fade = [&](const Fade &one) {
        clq_fade_def def = clq_fade_def_init();
        def.play = play_of(one.to);
        def.at_s = one.at_s, def.length_s = one.length_s, def.curve = static_cast<clq_curve>(one.curve);
        check(clq_actor_fade_to(crowd_, actor_, &def));
    };
    if (follows_own_) {
        if (!motion.fades.empty() && (was.fades.empty() || !(motion.fades.back() == was.fades.back())))
            fade(motion.fades.back());
        drop_layers();
        return add_layers(motion.layers);
    }
    for (const Fade &one : motion.fades) play_of(one.to);
    for (const Layer &layer : motion.layers) play_of(layer.clip), kit_.mask(layer.joint, layer.inverted);
    const clq_play base = play_of(motion.base);
    check(clq_actor_play(crowd_, actor_, &base));
    drop_layers();
    for (const Fade &one : motion.fades) fade(one);
    add_layers(motion.layers);
}

// They end before they begin, so that no time shows them. Those that the crowd has discarded are over already.
void Performer::drop_layers()
{
    for (const clq_layer layer : layers_) clq_actor_end_layer(crowd_, actor_, layer, -1e12, 0);
    layers_.clear();
}

void Performer::add_layers(const std::vector<Layer> &layers)
{
    layers_.clear();
    for (const Layer &one : layers) {
        clq_layer_def def = clq_layer_def_init();
        def.kind = one.adds ? CLQ_LAYER_ADD : CLQ_LAYER_REPLACE;
        def.play = play_of(one.clip);
        def.weight = one.weight;
        def.mask = kit_.mask(one.joint, one.inverted);
        clq_layer made = {};
        check(clq_actor_add_layer(crowd_, actor_, &def, &made));
        layers_.push_back(made);
    }
}

void Performer::fly(const Flight &flight)
{
    if (treadmill_) throw Failure("nothing flies on a treadmill");
    clq_root_path_play play = clq_root_path_play_init();
    if (flight.flies()) play.path = path_of(flight);
    check(clq_actor_play_root_path(crowd_, actor_, &play));
}

// The corners are in the world; a root path is in the individual's own space, round its Reference Point.
clq_root_path Performer::path_of(const Flight &flight)
{
    if (flown_ != flight.corners) flights_.clear(), flown_ = flight.corners;
    const long speed_cm_s = std::max(1L, std::lround(100 * flight.speed_m_s));
    const auto known = flights_.find(speed_cm_s);
    if (known != flights_.end()) return known->second;
    const float *q = place_.orientation_xyzw;
    const double x = static_cast<double>(-q[0]), y = static_cast<double>(-q[1]), z = static_cast<double>(-q[2]),
                 w = static_cast<double>(q[3]);  // back into its own space
    std::vector<float> positions;
    double length_m = 0;
    const size_t count = flight.corners.size() / 3;
    for (size_t i = 0; i < count; ++i) {
        double v[3], on[3];
        for (size_t k = 0; k < 3; ++k) {
            v[k] = flight.corners[3 * i + k] - place_.position[k];
            on[k] = flight.corners[3 * ((i + 1) % count) + k] - flight.corners[3 * i + k];
        }
        length_m += std::sqrt(on[0] * on[0] + on[1] * on[1] + on[2] * on[2]);
        const double t[3] = {2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])};
        const double turned[3] = {v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
                                  v[2] + w * t[2] + x * t[1] - y * t[0]};
        for (const double one : turned)
            positions.push_back(static_cast<float>(one / static_cast<double>(place_.scale)));
    }
    clq_root_path_def def = clq_root_path_def_init();
    def.count = static_cast<uint32_t>(count), def.positions = positions.data();
    def.duration_s = static_cast<float>(std::max(0.1, 100 * length_m / static_cast<double>(speed_cm_s)));
    clq_root_path made = {};
    check(clq_crowd_add_root_path(crowd_, &def, &made));
    return flights_[speed_cm_s] = made;
}

void Performer::carry(const std::vector<Carried> &load)
{
    for (const Carried &one : load) {
        kit_.node(one.joint);
        if (!is_object(one.object)) throw Failure("there is no object '" + one.object + "' to carry");
    }
    for (const clq_attachment one : attached_) check(clq_actor_detach(crowd_, one));
    attached_.clear();
    for (const Carried &one : load) {
        clq_attachment_def def = clq_attachment_def_init();
        def.node = kit_.node(one.joint);
        def.radius = radius_of_object(one.object) / std::fabs(home_.scale > 0 || home_.scale < 0 ? home_.scale : 1.0f);
        clq_attachment made = {};
        check(clq_actor_attach(crowd_, actor_, &def, &made));
        attached_.push_back(made);
    }
}

}  // namespace scenes::roles
