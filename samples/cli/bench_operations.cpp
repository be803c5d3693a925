// claque bench --operations: the operations of S0's Table 1 as the library counts them frame by frame, for `claque
// cost --measured`. Actor mode is compared with S0's traditional processing, which has neither culling before
// behaviour nor levels of detail. At equal levels both must draw the same picture.
#include "samples/cli/bench.h"
#include "samples/cli/files.h"
#include "samples/cost/measured.h"

namespace cli
{
namespace
{

struct Run {
    cost::Counts counts = {};  // means of a frame
    cost::Shares shares = {0, 0};
    std::string picture;  // hash of the last frame; empty: not drawn
};

enum class LevelChoice { by_distance, finest };

cost::Counts counts_of(const clq_crowd_stats &s)
{
    // fCoh is the share of these that were rebuilt, so NO_01 is the number that would be rebuilt without coherence.
    return {static_cast<double>(s.matrices_needed), static_cast<double>(s.tested),
            static_cast<double>(s.roots_placed),    static_cast<double>(s.spheres_built),
            static_cast<double>(s.sphere_tests),    static_cast<double>(s.distances)};
}

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

Run run(scenes::Library &library, const BenchArguments &a, clq_cull_mode cull, LevelChoice levels)
{
    SceneArguments arguments = a.setup;
    arguments.count = a.counts.front();
    scenes::SceneOptions options = scene_options(arguments, LoadedCharacter());
    options.crowd_options.cull = cull;
    if (levels == LevelChoice::finest) options.crowd_options.lod_scale = 0;
    scenes::SceneRenderer scene_renderer(library, options);
    Run out;
    double needed = 0, built = 0, products = 0, tracked = 0;
    for (int frame = 0; frame <= a.frames; ++frame) {
        scene_renderer.update(2 + frame / 25.0);
        if (frame == 0) continue;  // frame 0 rebuilds everything
        const clq_crowd_stats stats = scene_renderer.crowd_stats();
        const cost::Counts counts = counts_of(stats);
        for (size_t i = 0; i < cost::operation_count; ++i) out.counts[i] += counts[i];
        needed += static_cast<double>(stats.matrices_needed);
        built += static_cast<double>(stats.matrices_built);
        products += static_cast<double>(stats.products);
        tracked += static_cast<double>(stats.products_tracked);
    }
    out.shares = {share(tracked, products), share(built, needed)};
    for (double &count : out.counts) count /= a.frames;
    if (levels == LevelChoice::finest) return out;
    scene_renderer.draw_frame();
    out.picture = hex(scenes::hash_of(scene_renderer.read()));
    return out;
}

}  // namespace

void write_operations(const BenchArguments &a)
{
    scenes::Library library(thread_count(a.setup));
    const Run actor = run(library, a, CLQ_CULL_ACTOR, LevelChoice::by_distance);
    std::string picture = actor.picture;
    const std::string person = std::to_string(a.counts.front()) + " actors";
    expect_same_picture(picture, run(library, a, CLQ_CULL_TRADITIONAL, LevelChoice::by_distance).picture,
                        person + " culled in mode traditional");
    cost::Measured measured;
    measured.actor = actor.counts;
    measured.shares = actor.shares;
    measured.traditional = run(library, a, CLQ_CULL_TRADITIONAL, LevelChoice::finest).counts;
    measured.note = "scene " + scene_of(a.setup) + ", " + person + ", means of " + std::to_string(a.frames) +
                    " frames at 25 a second, parts placed by " +
                    (a.setup.rigid_mode == "matrices" ? "OpenGL" : "claque") + "; traditional: all at its finest";
    write_whole(a.operations, json_of(measured));
}

}  // namespace cli
