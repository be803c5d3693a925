// The individuals of a scene: their crowd, their ids and where they are.
#pragma once

#include "samples/scenes/check.h"
#include "samples/scenes/library.h"

#include <vector>

namespace scenes
{

// Whether built-in people have levels of detail (S1 6) in scenes that show them with and without.
enum class Lod { off, on };

// What is asked of any scene.
struct CrowdOptions {
    uint32_t count = 400;  // [1, 1 000 000]; 0, odeon: as many as its description says
    uint64_t seed = 1;
    clq_cache_mode cache = CLQ_CACHE_FULL;
    uint64_t cache_budget_bytes = 0;  // 0: claque's own
    clq_cull_mode cull = CLQ_CULL_ACTOR;
    clq_rigid_mode rigid_mode = CLQ_RIGID_VERTICES;
    clq_vertex_format vertex_format = CLQ_VERTEX_FLOAT;
    clq_key_poses key_poses = clq_key_poses_init();
    Lod lod = Lod::off;
    float lod_scale = 1;       // times every distance that chooses levels of detail; 0: all at their finest
    std::string theatre_file;  // odeon: a description of the user's; empty: the one that comes with claque
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
    // The same with a seed and ranges of colours (one a zone of its template) of its own.
    void enter(const Part &part, uint64_t seed, const std::vector<clq_hsb_range> &palette);
    // Another clip for number `who`.
    void play(size_t who, const clq_play &play);
    // Sends everybody to `places()`.
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

// A place on level ground, looking along (facing_x, facing_z), which need not be of length 1; characters look along +z.
clq_transform stand(double x, double y, double z, double facing_x, double facing_z, float scale);

}  // namespace scenes
