#include "samples/scenes/town/flyers.h"

#include <cmath>

#include "samples/scenes/random.h"

namespace scenes::town
{

namespace
{

constexpr double sky_radius_m = 270, lowest_m = 20, highest_m = 120;
constexpr int way_count = 16;  // shared; each actor follows one with a clock, size and heading of its own
constexpr double flying_m_per_s = 9;
constexpr double tau = 2 * 3.14159265358979323846;

// The distance at which the template's nodes stop (S0 5.2); beyond it a mechanism has nothing to write.
constexpr float face_stops_m = 35, neck_stops_m = 160;

clq_transform somewhere(uint64_t seed, uint32_t number, const std::array<double, 3> &middle)
{
    const double away = sky_radius_m * std::sqrt(random_unit(seed, number, Purpose::radius));
    const double angle = tau * random_unit(seed, number, Purpose::place_x),
                 heading = tau * random_unit(seed, number, Purpose::heading);
    const double height =
        lowest_m + (highest_m - lowest_m) * std::pow(random_unit(seed, number, Purpose::place_z), 1.6);
    return stand(middle[0] + away * std::sin(angle), middle[1] + height, middle[2] + away * std::cos(angle),
                 std::sin(heading), std::cos(heading),
                 static_cast<float>(random_between(seed, number, Purpose::size, 0.9, 1.1)));
}

}  // namespace

Flyers::Flyers(Library &library, const CrowdOptions &crowd_options, const std::array<double, 3> &middle)
    : seed_(crowd_options.seed), scene_crowd_(library, crowd_options), template_(library.builtin("herald"))
{
    for (uint32_t number = 0; number < crowd_options.count; ++number) enter(number, middle);
}

uint32_t Flyers::dof(const char *name) const
{
    const uint32_t found = clq_template_find_dof(template_, name);
    if (found == CLQ_NONE) throw Failure(std::string("the flyer has no degree of freedom '") + name + "'");
    return found;
}

// Closed loops of five to nine turning points; some wide, some like an eight, none horizontal.
void Flyers::describe_paths()
{
    for (uint64_t way = 0; way < way_count; ++way) {
        const int points = 5 + static_cast<int>(random_bits(seed_, way, Purpose::tries) % 5);
        const double radius = random_between(seed_, way, Purpose::gap, 14, 34);
        const bool eight = way % 3 == 2;
        std::vector<float> positions;
        double length = 0;
        for (int k = 0; k < points; ++k) {
            const uint64_t which = way * 16 + static_cast<uint64_t>(k);
            const double angle = tau * k / points,
                         r = radius * random_between(seed_, which, Purpose::radius, 0.75, 1.25);
            positions.push_back(static_cast<float>(r * std::sin(angle) * (eight ? 1.4 * std::cos(angle) : 1)));
            positions.push_back(static_cast<float>(random_between(seed_, which, Purpose::grain, -4, 4)));
            positions.push_back(static_cast<float>(r * std::cos(angle)));
        }
        for (int k = 0; k < points; ++k) {
            double square = 0;
            for (int i = 0; i < 3; ++i) {
                const double d = static_cast<double>(positions[static_cast<size_t>(3 * ((k + 1) % points) + i)]) -
                                 static_cast<double>(positions[static_cast<size_t>(3 * k + i)]);
                square += d * d;
            }
            length += std::sqrt(square);
        }
        clq_root_path_def def = clq_root_path_def_init();
        def.count = static_cast<uint32_t>(points);
        def.positions = positions.data();
        def.duration_s = static_cast<float>(length / flying_m_per_s);
        def.bank = 0.7f;
        def.max_bank_rad = 0.8f;
        clq_root_path made = {};
        check(clq_crowd_add_root_path(scene_crowd_.crowd(), &def, &made));
        paths_.push_back(made);
    }
}

void Flyers::describe_mechanisms()
{
    const auto add = [this](const clq_mechanism_def &def) {
        clq_mechanism made = {};
        check(clq_crowd_add_mechanism(scene_crowd_.crowd(), &def, &made));
        mechanisms_.push_back(made);
    };
    clq_mechanism_def gaze = clq_mechanism_def_init();
    gaze.kind = CLQ_MECHANISM_GAZE, gaze.tmpl = template_;
    gaze.level_m[0] = face_stops_m, gaze.level_m[1] = 90, gaze.off_m = neck_stops_m;
    gaze.gaze.eye_yaw[0] = dof("eye_left_yaw"), gaze.gaze.eye_yaw[1] = dof("eye_right_yaw");
    gaze.gaze.eye_pitch[0] = dof("eye_left_pitch"), gaze.gaze.eye_pitch[1] = dof("eye_right_pitch");
    gaze.gaze.neck_yaw = dof("neck_yaw"), gaze.gaze.neck_pitch = dof("neck_pitch");
    gaze.gaze.spine_yaw = dof("spine_yaw"), gaze.gaze.spine_pitch = dof("spine_pitch");
    gaze.gaze.eyes[1] = 0.75f;
    gaze.gaze.wander_s = 3.5f, gaze.gaze.wander_yaw_rad = 1.1f, gaze.gaze.wander_pitch_rad = 0.35f;
    add(gaze);

    const clq_dof_value raised[] = {{dof("brow"), 0.012f}, {dof("head_roll"), 0.12f}};
    const clq_dof_value frown[] = {{dof("brow"), -0.006f}, {dof("head_roll"), -0.10f}};
    const clq_dof_value wonder[] = {{dof("brow"), 0.008f}, {dof("head_roll"), 0.25f}, {dof("jaw"), 0.06f}};
    const clq_dof_pose faces[] = {{0, nullptr}, {2, raised}, {2, frown}, {3, wonder}};
    clq_mechanism_def expression = clq_mechanism_def_init();
    expression.kind = CLQ_MECHANISM_EXPRESSION, expression.tmpl = template_;
    expression.level_m[0] = 15, expression.off_m = neck_stops_m;
    expression.expression.pose_count = 4, expression.expression.poses = faces;
    add(expression);

    const clq_dof_value shut[] = {{dof("lids"), 1}};
    clq_mechanism_def blink = clq_mechanism_def_init();
    blink.kind = CLQ_MECHANISM_BLINK, blink.tmpl = template_;
    blink.level_m[0] = 15, blink.off_m = face_stops_m;
    blink.blink.closed = {1, shut};
    add(blink);

    // "Io Saturnalia": the mouth alone.
    const clq_dof_value wide[] = {{dof("jaw"), 0.32f}}, round[] = {{dof("jaw"), 0.2f}},
                        narrow[] = {{dof("jaw"), 0.09f}};
    const clq_dof_pose mouths[] = {{1, wide}, {1, round}, {1, narrow}};
    const clq_phrase_key keys[] = {{0, 2},     {0.12f, 1}, {0.5f, CLQ_NONE}, {0.62f, 0},      {0.85f, 1},
                                   {1.05f, 0}, {1.3f, 2},  {1.42f, 0},       {1.8f, CLQ_NONE}};
    clq_mechanism_def phrase = clq_mechanism_def_init();
    phrase.kind = CLQ_MECHANISM_PHRASE, phrase.tmpl = template_;
    phrase.level_m[0] = 15, phrase.off_m = face_stops_m;
    phrase.phrase.pose_count = 3, phrase.phrase.poses = mouths;
    phrase.phrase.key_count = 9, phrase.phrase.keys = keys;
    phrase.phrase.length_s = 2, phrase.phrase.pause_s = 5;
    add(phrase);

    const uint32_t clips[] = {clq_template_find_clip(template_, "fly"), clq_template_find_clip(template_, "fly"),
                              clq_template_find_clip(template_, "glide")};
    clq_mechanism_def idle = clq_mechanism_def_init();
    idle.kind = CLQ_MECHANISM_IDLE, idle.tmpl = template_;
    idle.idle.clip_count = 3, idle.idle.clips = clips;
    idle.idle.slot_s = 4;
    add(idle);
}

void Flyers::enter(uint32_t number, const std::array<double, 3> &middle)
{
    clq_play play = {};
    play.clip = clq_template_find_clip(template_, "fly");
    play.speed = 1;
    scene_crowd_.enter({template_, somewhere(seed_, number, middle), play});
    // Mechanisms need a template that the crowd has: the first actor brings it.
    if (number == 0) describe_paths(), describe_mechanisms();
    const clq_actor actor = scene_crowd_.actors().back();
    clq_root_path_play motion = {};
    motion.path = paths_[random_bits(seed_, number, Purpose::lane) % paths_.size()];
    motion.speed = static_cast<float>(random_between(seed_, number, Purpose::speed, 0.8, 1.2));
    motion.phase_s = static_cast<float>(30 * random_unit(seed_, number, Purpose::phase));
    check(clq_actor_play_root_path(scene_crowd_.crowd(), actor, &motion));
    for (size_t k = 0; k < mechanisms_.size(); ++k) {
        clq_mechanism_attachment use = {};
        use.mechanism = mechanisms_[k];
        use.priority = static_cast<float>(k);
        use.phase_s = static_cast<float>(40 * random_unit(seed_, number * 8 + k, Purpose::act));
        check(clq_actor_attach_mechanism(scene_crowd_.crowd(), actor, &use));
    }
}

}  // namespace scenes::town
