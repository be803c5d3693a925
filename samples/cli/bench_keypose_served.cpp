// S3 Figs. 11 and 12: the share of the multitude that is served from the key-pose stores, and the number of key-poses
// that are skinned for it. No picture is drawn, and individuals that are not served are not skinned.
#include "samples/cli/bench_keypose.h"
#include "samples/cli/progress.h"
#include "samples/scenes/random.h"

namespace cli
{
namespace
{

constexpr double step_s = 1 / 25.0, served_aspect = 4.0 / 3.0, path_s = 25, script_s = 30, turn_s = 5;

struct ServedMean {
    double sum = 0, count = 0;
    void add(double x) { sum += x, count += 1; }
    double take()
    {
        const double mean = count > 0 ? sum / count : 0;
        sum = count = 0;
        return mean;
    }
};

// The multitude with only its key-poses cached.
struct ServedField {
    ServedField(scenes::Library &library, uint32_t count, clq_key_pose_mode method, uint32_t max_kept, uint64_t seed)
    {
        scenes::CrowdOptions crowd_options;
        crowd_options.count = count;
        crowd_options.seed = seed;
        crowd_options.cache = CLQ_CACHE_NONE;
        crowd_options.cache_budget_bytes = 1;
        crowd_options.key_poses.bands[0].mode = method;
        crowd_options.key_poses.band_count = 1;
        crowd_options.key_poses.max_kept = max_kept;
        crowd_options.key_poses.rate_hz = static_cast<float>(rate_of_200_hz(library.builtin("decurion")));
        scene = scenes::make_scene("multitude", library, crowd_options, {});
        clq_view *made = nullptr;
        scenes::check(clq_view_create(scene->crowd(), &made));
        view.reset(made);
        actors = scene->actors();
    }
    clq_key_pose_stats update(const clq_camera &camera, double time_s)
    {
        clq_view *views[] = {view.get()};
        scenes::check(clq_view_set_camera(view.get(), &camera));
        scenes::check(clq_crowd_update(scene->crowd(), time_s, views, 1));
        clq_key_pose_stats stats = clq_key_pose_stats_init();
        scenes::check(clq_crowd_get_key_pose_stats(scene->crowd(), &stats));
        return stats;
    }
    std::unique_ptr<scenes::Scene> scene;
    scenes::Own<clq_view> view;
    std::vector<clq_actor> actors;
};

// S3 5: each individual picks one of the available clips at random: five at first, then one, and one more every 5 s.
void play(ServedField &field, uint64_t seed, uint32_t turn)
{
    const uint32_t open = turn == 0 ? 5 : std::min(turn, 5u);
    for (uint32_t person = 0; person < field.actors.size(); ++person) {
        clq_actor_info info = clq_actor_info_init();
        scenes::check(clq_actor_get_info(field.scene->crowd(), field.actors[person], &info));
        const uint64_t bits = scenes::random_bits(seed + turn, person, scenes::Purpose::act);
        clq_play play = {};
        play.clip = clq_template_find_clip(info.tmpl, multitude_clips()[bits % open].c_str());
        play.speed = 1;
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_template_get_clip(info.tmpl, play.clip, &clip));
        play.phase_s = static_cast<float>(scenes::random_unit(seed + turn, person, scenes::Purpose::phase) *
                                          static_cast<double>(clip.duration_s));
        scenes::check(clq_actor_play(field.scene->crowd(), field.actors[person], &play));
    }
}

const struct {
    const char *name;
    clq_key_pose_mode method;
} methods[] = {{"intermittent", CLQ_KEY_POSE_INTERMITTENT}, {"interpolated", CLQ_KEY_POSE_INTERPOLATED}};

}  // namespace

Json key_poses_along_path(const BenchArguments &a, scenes::Library &library)
{
    Progress progress("claque bench");
    const uint32_t count = a.counts.front();
    const scenes::CameraPath path(*scenes::recorded_path("multitude"), "multitude/path.toml");
    Json report = chart_of_lines("Individuals served from the key-pose stores along the camera path", "seconds",
                                 "% of those in view");
    report["columns"] = {"stores", "served %", "least %", "wanted", "updated a frame"};
    size_t done = 0;
    for (const auto &way : methods)
        for (const uint32_t most : {50u, 100u, 150u, 200u}) {
            ServedField field(library, count, way.method, most, a.setup.seed);
            Json points = Json::array();
            ServedMean served, wanted, updated, lately;
            double least = 100;
            int frame = 0;
            for (double t = 0; t <= path_s + 1e-9; t = ++frame * step_s) {
                const clq_key_pose_stats stats = field.update(path.camera(t, served_aspect), t);
                const double share = stats.requested ? 100.0 * stats.served / stats.requested : 100;
                served.add(share), wanted.add(stats.wanted), lately.add(share);
                if (frame > 0) updated.add(stats.updated);
                least = std::min(least, share);
                if (frame % 10 == 5) points.push_back({t, lately.take()});
            }
            const std::string name = std::string(way.name) + ", " + std::to_string(most);
            report["series"].push_back({{"name", name},
                                        {"points", std::move(points)},
                                        {"colour", most / 50 - 1},
                                        {"dash", way.method == CLQ_KEY_POSE_INTERMITTENT ? "solid" : "dashed"},
                                        {"dots", "never"}});
            report["runs"].push_back({{"stores", name},
                                      {"served %", served.take()},
                                      {"least %", least},
                                      {"wanted", wanted.take()},
                                      {"updated a frame", updated.take()}});
            progress.step(++done, 8);
        }
    report["note"] = "S3 Fig. 11: " + std::to_string(count) +
                     " people of two templates, five clips of 200 key-poses in all, 25 updates a second; the number is "
                     "that of key-poses kept for each template and level";
    return report;
}

Json key_poses_by_script(const BenchArguments &a, scenes::Library &library)
{
    Progress progress("claque bench");
    constexpr uint32_t most = 100;
    const uint32_t count = a.counts.front();
    Json report =
        chart_of_lines("Key-poses kept as the number of clips grows", "seconds", "% served, key-poses a frame");
    report["columns"] = {"clips", "method", "served", "of", "wanted", "updated a frame"};
    for (const auto &way : methods) {
        ServedField field(library, count, way.method, most, a.setup.seed);
        const clq_camera camera = field.scene->camera(scenes::Shot::overview, served_aspect, 0);
        Json share = Json::array(), updates = Json::array();
        ServedMean served, asked, wanted, updated, share_lately, updated_lately;
        const int frames = static_cast<int>(script_s / step_s + 0.5), turn = static_cast<int>(turn_s / step_s + 0.5);
        for (int frame = 0; frame < frames; ++frame) {
            if (frame % turn == 0) play(field, a.setup.seed, static_cast<uint32_t>(frame / turn));
            const clq_key_pose_stats stats = field.update(camera, frame * step_s);
            served.add(stats.served), asked.add(stats.requested), wanted.add(stats.wanted);
            share_lately.add(100.0 * stats.served / std::max(stats.requested, 1u));
            if (frame % turn > 0) updated.add(stats.updated), updated_lately.add(stats.updated);
            if (frame % 10 == 5) {
                share.push_back({frame * step_s, share_lately.take()});
                updates.push_back({frame * step_s, updated_lately.take()});
            }
            if (frame % turn + 1 < turn) continue;
            const int number = frame / turn;
            report["runs"].push_back({{"clips", std::to_string(number == 0 ? 5 : std::min(number, 5)) + " from " +
                                                    std::to_string(5 * number) + " s"},
                                      {"method", way.name},
                                      {"served", served.take()},
                                      {"of", asked.take()},
                                      {"wanted", wanted.take()},
                                      {"updated a frame", updated.take()}});
        }
        const size_t colour = way.method == CLQ_KEY_POSE_INTERMITTENT ? 0 : 1;
        const std::string name = way.name;
        report["series"].push_back(
            {{"name", name + ", % served"}, {"points", share}, {"colour", colour}, {"dots", "never"}});
        report["series"].push_back({{"name", name + ", key-poses a frame"},
                                    {"points", updates},
                                    {"colour", colour},
                                    {"dash", "dashed"},
                                    {"dots", "never"}});
        progress.step(colour + 1, 2);
    }
    report["note"] = "S3 Fig. 12: " + std::to_string(count) +
                     " people, a fixed camera, 100 key-poses kept for each of two templates "
                     "and three levels; 5 clips, from 5 s on 1, every 5 s one more";
    return report;
}

}  // namespace cli
