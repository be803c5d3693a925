// The individuals of a scene: their crowd, ids and transforms.
#pragma once

#include <optional>
#include <vector>

#include "samples/scenes/check.h"
#include "samples/scenes/library.h"
#include "samples/scenes/light.h"

namespace scenes
{

// Selects levels of detail (S1 6) for built-in people in scenes that can show them with and without.
enum class Lod { off, on };

// The options that all scenes share.
struct CrowdOptions {
    uint32_t count = 400;  // [1, 1 000 000]; 0, scenarios: the number in their description
    uint64_t seed = 1;
    clq_cache_mode cache = CLQ_CACHE_FULL;
    uint64_t cache_budget_bytes = 0;  // 0: claque's default
    clq_cull_mode cull = CLQ_CULL_ACTOR;
    clq_rigid_mode rigid_mode = CLQ_RIGID_VERTICES;
    clq_vertex_format vertex_format = CLQ_VERTEX_FLOAT;
    clq_key_poses key_poses = clq_key_poses_init();
    Lod lod = Lod::off;
    double hour = 0;                // of the day, for scenes whose light follows it; 0: the scene's own
    std::optional<Daylight> light;  // of the plaza; none: the scene's own
    bool exact_poses = false;       // all are posed in every frame, at the very time
    bool as_shown = false;          // what a time shows may be read and made when place() comes to it, not at first
    float lod_scale = 1;            // multiplies every distance that selects levels of detail; 0: all at their finest
};

class SceneCrowd
{
public:
    SceneCrowd(Library &library, const CrowdOptions &crowd_options);

    struct Part {
        clq_template *tmpl;
        clq_transform place;
        clq_play play;
    };
    // Adds an individual with colours of its own; its number is the count before.
    void enter(const Part &part);
    // The same with a seed and ranges of colours (one for each zone of its template) of its own.
    void enter(const Part &part, uint64_t seed, const std::vector<clq_hsb_range> &palette);
    // Starts another clip for number `person`.
    void play(size_t person, const clq_play &play);
    // Moves all individuals to `places()`.
    void move();

    clq_crowd *crowd() const { return crowd_.get(); }
    const std::vector<clq_actor> &actors() const { return actors_; }
    std::vector<clq_transform> &places() { return places_; }
    const std::vector<clq_transform> &places() const { return places_; }

private:
    clq_actor add(const Part &part, uint64_t seed);

    Own<clq_crowd> crowd_;
    std::vector<clq_actor> actors_;
    std::vector<clq_transform> places_;
};

// A transform on level ground, facing along (facing_x, facing_z), which need not be of length 1; characters face +z.
clq_transform stand(double x, double y, double z, double facing_x, double facing_z, float scale);

}  // namespace scenes
