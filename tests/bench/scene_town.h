// A crowd with a scene, of one person to four square metres, that stands or walks along tracks; made once for each
// size.
#pragma once

#include <claque/assets.h>
#include <claque/claque.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace scene_bench
{

inline void check(clq_status status)
{
    if (status != CLQ_OK) std::fprintf(stderr, "%s\n", clq_last_error()), std::abort();
}

enum class Kind { standing, walking };

// People walk along straight ways of half a minute, fifty on each at different times.
inline std::vector<clq_track *> make_tracks(clq_template *citizen, clq_context *context, uint32_t count, double side)
{
    std::vector<clq_track *> out(count);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> real(0, side), turn(0, 6.28);
    clq_locomotion_def walk = clq_locomotion_def_init();
    walk.tmpl = citizen, walk.walk = clq_template_find_clip(citizen, "walk");
    clq_locomotion *locomotion = nullptr;
    check(clq_locomotion_create(context, &walk, &locomotion));
    for (clq_track *&track : out) {
        clq_track_point points[31];
        const double x = real(random), z = real(random), heading = turn(random);
        for (int i = 0; i <= 30; ++i)
            points[i] = {double(i), {x + 1.3 * i * std::sin(heading), 0, z + 1.3 * i * std::cos(heading)}, NAN};
        clq_track_def def = clq_track_def_init();
        def.points = points, def.point_count = 31;
        check(clq_track_create(locomotion, &def, &track));
    }
    return out;
}

class Town
{
public:
    Town(uint32_t count, Kind kind) : side_(2 * std::sqrt(double(count)))
    {
        check(clq_crowd_create(context(), nullptr, &crowd));
        std::mt19937 random(7);
        std::uniform_real_distribution<double> real(0, side_);
        std::vector<clq_track *> tracks;
        if (kind == Kind::walking) tracks = make_tracks(citizen(), context(), count / 50, side_);
        for (uint32_t i = 0; i < count; ++i) {
            clq_actor_def def = clq_actor_def_init();
            def.tmpl = citizen();
            def.transform.position[0] = real(random), def.transform.position[2] = real(random);
            def.seed = i;
            clq_actor made;
            check(clq_actor_create(crowd, &def, &made));
            if (kind == Kind::walking)
                check(clq_actor_follow_track(crowd, made, tracks[i % tracks.size()], -0.4 * (i / tracks.size())));
            actors.push_back(made), places.push_back(def.transform), keys.push_back(i);
        }
        check(clq_scene_create(crowd, &scene));
        check(clq_scene_set_categories(scene, actors.data() + count / 2, 100, 2));
        check(clq_scene_set_keys(scene, actors.data(), keys.data(), count));
        check(clq_view_create(crowd, &view));
        const double middle = side_ / 2;
        clq_look_at_def look = clq_look_at_def_init();
        look.eye[0] = look.target[0] = middle, look.eye[1] = look.target[1] = 1.7, look.eye[2] = middle;
        look.target[2] = middle - 1, look.fov_y_rad = 0.5f, look.z_far = 40;
        check(clq_camera_look_at(&look, &camera));
        check(clq_view_set_camera(view, &camera));
        check(clq_crowd_update(crowd, 0, &view, 1));
        hits.resize(count);
        for (uint32_t i = 0; i < count; ++i) {
            clq_scene_actor known = clq_scene_actor_init();
            check(clq_scene_get_actor(scene, actors[i], 0, &known));
            std::copy(known.position, known.position + 3, places[i].position);
        }
    }

    static clq_context *context()
    {
        static clq_context *const made = [] {
            clq_context *out = nullptr;
            check(clq_context_create(nullptr, &out));
            return out;
        }();
        return made;
    }
    static clq_template *citizen()
    {
        static clq_template *const made = [] {
            clq_template *out = nullptr;
            check(clq_template_builtin(context(), "citizen", &out));
            return out;
        }();
        return made;
    }
    const double *middle()
    {
        // Not always the same place, whose memory is at hand.
        next_ = (next_ + 7919) % actors.size();
        return places[next_].position;
    }

    clq_crowd *crowd = nullptr;
    clq_scene *scene = nullptr;
    clq_view *view = nullptr;
    clq_camera camera;
    std::vector<clq_actor> actors;
    std::vector<clq_transform> places;
    std::vector<double> keys;
    std::vector<clq_scene_hit> hits;

private:
    double side_;
    size_t next_ = 0;
};

inline Town &town(int64_t count, Kind kind = Kind::standing)
{
    static std::map<std::pair<int64_t, Kind>, std::unique_ptr<Town>> all;
    std::unique_ptr<Town> &one = all[{count, kind}];
    if (!one) one = std::make_unique<Town>(uint32_t(count), kind);
    return *one;
}

}  // namespace scene_bench
