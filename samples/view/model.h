// All that the view shows and that a person can change, apart from how it is drawn. Panels read and change it; the
// world (world.h) follows it.
#pragma once

#include <claque/claque.h>

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "samples/view/designer/designer.h"
#include "samples/view/free_camera.h"
#include "samples/view/ground/ground_model.h"

namespace view
{

// Changing the strategy or the textures changes the next frame; changing anything else makes the world anew.
struct Switches {
    int strategy = 0;        // of clq_draw_strategy
    int close_textures = 0;  // 1: people near the eye have textures of their own
    int cache = 0;           // of clq_cache_mode; 3: key-poses for all
    int cull = 0;            // of clq_cull_mode
    int format = 0;          // of clq_vertex_format
    int levels = 0;          // people without levels of detail; with them; with them at a third of the distance
    int threads = 1;
};

enum class Tint { nothing, level, rate, age, cache, zones };

// Where the vertices of an individual came from in a frame.
enum class Served { vertices, palette, nothing, count };

struct Picked {
    clq_actor actor = {};
    uint32_t zone = CLQ_NONE;
};

// Of one frame. Times are in milliseconds; negative: not measured. What GL takes for each part is measured while the
// panel Frame is open.
struct FrameCost {
    double at_s = 0;  // of the person's time, not of the scene's
    double place_ms = -1, update_ms = -1, surroundings_ms = -1, crowd_ms = -1;
    double interface_ms = -1, interface_gl_ms = -1;  // of the panels: outside GL and in it
    clq_draw_stats drawn = {};
    clq_view_stats seen = {};
    clq_crowd_stats crowd = {};
    clq_update_times steps = {};  // of the update
};

// A switch that the person used.
struct Switched {
    double at_s;
    std::string words;
};

struct Clock {
    double time_s = 0, first_s = 0, last_s = 60;
    float speed = 1;
    bool paused = false;
};

enum class CameraMode { scene, free, follow };

struct View {
    CameraMode mode = CameraMode::scene;
    int shot = 0;  // of the scene, by scenes::Shot
    FreeCamera free;
    std::array<std::optional<FreeCamera>, 9> kept;  // by number - 1
    struct Key {
        double time_s;
        FreeCamera camera;
    };
    std::vector<Key> path;
};

// What is to be done once, in the next frame.
struct Wishes {
    bool picture = false, save_path = false, frame_selection = false, anew = false;
    std::optional<std::array<float, 2>> pick;  // a point of the picture, -1 to 1
};

struct Sections {
    bool camera = true, person = true, character = false, designer = false, frame = false;
};

struct Model {
    std::string message;  // about the last thing that was done
    Clock clock;
    View view;
    Switches switches;
    Tint tint = Tint::nothing;
    std::array<uint32_t, static_cast<size_t>(Served::count)> served = {};  // in the last frame, with Tint::cache
    bool spheres = false, panel = true;
    bool film = false;              // one is being made
    std::string saved_as = "view";  // the beginning of the names of pictures and paths
    Picked picked;
    uint64_t picks = 0;  // clicks in the picture that picked or let go
    float fade_s = 0.3f;
    int curve = 1;  // of clq_curve
    Sections open;
    Designer designer;
    Ground ground;  // the testing ground
    FrameCost cost;
    double real_s = 0;              // of the person's time, since the beginning
    std::deque<FrameCost> history;  // of the last ten seconds
    std::deque<Switched> switched;  // in them
    Wishes wishes;
};

constexpr double history_s = 10;

// What people cost in a frame, apart from their surroundings and the panels.
inline double people_ms(const FrameCost &cost)
{
    return cost.crowd_ms < 0 ? -1 : cost.place_ms + cost.update_ms + cost.crowd_ms;
}

}  // namespace view
