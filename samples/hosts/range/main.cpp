// claque_host_range OUT.ply [SECONDS]: a spinning lidar among people that stand and walk on the spot, without any GL.
// The points have the actor and the zone that they lie on.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "samples/hosts/range/sensor.h"
#include "samples/scenes/library.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene_crowd.h"

namespace
{

using scenes::check;

scenes::Own<clq_crowd> people(scenes::Library &library)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.period_near_s = def.period_far_s = 0;
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library.context(), &def, &crowd));
    scenes::Own<clq_crowd> owner(crowd);
    const char *const names[] = {"citizen", "patrician", "decurion", "plebeian"};
    for (uint64_t i = 0; i < 200; ++i) {
        const double angle = scenes::random_between(1, i, scenes::Purpose::heading, 0, 6.2831853),
                     away = 3 + 32 * std::sqrt(scenes::random_unit(1, i, scenes::Purpose::radius));
        clq_actor_def actor_def = clq_actor_def_init();
        actor_def.tmpl = library.builtin(names[i % 4]);
        actor_def.seed = i;
        actor_def.transform =
            scenes::stand(away * std::cos(angle), 0, away * std::sin(angle), -std::cos(angle), -std::sin(angle), 1);
        actor_def.play.clip = clq_template_find_clip(actor_def.tmpl, i % 3 == 0 ? "walk" : "stand");
        actor_def.play.phase_s = static_cast<float>(i) * 0.13f;
        clq_actor made = {};
        check(clq_actor_create(crowd, &actor_def, &made));
    }
    return owner;
}

// A point for each return, in the world.
size_t write_ply(const std::string &path, const std::array<double, 3> &eye, const std::vector<range::Ray> &rays,
                 const std::vector<range::Return> &returns)
{
    size_t count = 0;
    for (const range::Return &one : returns) count += one.distance >= 0;
    const std::string beside = path + ".part";
    std::FILE *file = std::fopen(beside.c_str(), "wb");
    if (!file) throw scenes::Failure("cannot write " + beside);
    std::fprintf(file,
                 "ply\nformat ascii 1.0\nelement vertex %zu\nproperty double x\nproperty double y\nproperty double z\n"
                 "property uint actor\nproperty int zone\nend_header\n",
                 count);
    for (size_t i = 0; i < rays.size(); ++i) {
        const range::Return &one = returns[i];
        if (one.distance < 0) continue;
        const double d = static_cast<double>(one.distance);
        std::fprintf(file, "%.4f %.4f %.4f %u %d\n", eye[0] + d * static_cast<double>(rays[i].direction[0]),
                     eye[1] + d * static_cast<double>(rays[i].direction[1]),
                     eye[2] + d * static_cast<double>(rays[i].direction[2]), one.actor,
                     one.zone == CLQ_NONE ? -1 : static_cast<int>(one.zone));
    }
    const bool written = std::fclose(file) == 0;
    if (!written || std::rename(beside.c_str(), path.c_str()) != 0) throw scenes::Failure("cannot write " + path);
    return count;
}

void scan(const std::string &path, double time_s)
{
    scenes::Library library(1);
    const scenes::Own<clq_crowd> crowd = people(library);
    const std::array<double, 3> eye = {0, 1.8, 0};
    const range::Lidar lidar;
    std::vector<range::Look> looks;
    std::vector<clq_view *> views;
    for (const clq_camera &camera : range::cameras_round(eye, lidar)) {
        clq_view *view = nullptr;
        check(clq_view_create(crowd.get(), &view));
        check(clq_view_set_camera(view, &camera));
        views.push_back(view);
        looks.push_back({view, camera});
    }
    check(clq_crowd_update(crowd.get(), time_s, views.data(), static_cast<uint32_t>(views.size())));
    const range::RayScene scene(looks, 0);
    const std::vector<range::Ray> rays = rays_of(lidar);
    const std::vector<range::Return> returns = scene.cast(rays);
    size_t people_hit = 0;
    for (const range::Return &one : returns) people_hit += one.actor != 0;
    const size_t points = write_ply(path, eye, rays, returns);
    std::printf("%s: %zu points of %zu rays, %zu on people; %zu triangles\n", path.c_str(), points, rays.size(),
                people_hit, scene.triangle_count());
}

}  // namespace

int main(int argc, char **argv)
{
    if (argc < 2 || argc > 3) return std::fprintf(stderr, "claque_host_range OUT.ply [SECONDS]\n"), 2;
    try {
        scan(argv[1], argc > 2 ? std::atof(argv[2]) : 1.0);
    } catch (const scenes::Failure &failure) {
        return std::fprintf(stderr, "claque_host_range: %s\n", failure.what()), 1;
    }
    return 0;
}
