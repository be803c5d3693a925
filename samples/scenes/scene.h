// A scene: people in a place, seen by a camera in daylight. Shared by the claque command, tests and benchmarks, so that
// a figure, a stored picture and a test show the same thing. Everything in it is a function of its casting and the
// time: any frame can be made by itself.
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/gl.h"
#include "samples/scenes/scene_crowd.h"

#include <claque/shadow.h>

#include <memory>
#include <string>
#include <vector>

namespace scenes
{

// `path`: along the scene's recorded camera path, where it has one; else as overview.
enum class Shot { overview, close, path };

// A character that came from a file. Without a box (prepared files carry none) scenes go by the template's sphere.
struct Character {
    clq_template *tmpl = nullptr;
    bool has_box = false;
    float box_min[3] = {0, 0, 0}, box_max[3] = {0, 0, 0};
    uint32_t first_clip = 0;  // a parade plays this one and what follows it
};

class Scene
{
public:
    virtual ~Scene() = default;

    virtual clq_crowd *crowd() const = 0;
    // Everybody in it, for pictures that show what is known of each; a scene may have nothing to show.
    virtual std::vector<clq_actor> actors() const { return {}; }
    virtual std::vector<clq_template *> templates() const = 0;
    virtual clq_camera camera(Shot shot, double aspect, double time_s) const = 0;

    // Puts those who move where they are at this time; before clq_crowd_update.
    virtual void place(double time_s) = 0;

    // Brings textures to the current context, which must be current again when the scene ends.
    virtual void prepare(const Gl &gl) = 0;
    // Draws all but the crowd into a cleared picture, and leaves the lights on for it.
    virtual void draw_environment(const Gl &gl, const Eye &eye) const = 0;
    // Shadows of people are claque's to draw from now on, or nobody's: those that the scene paints itself are left out. Says
    // what light they fall in; false where the scene has no ground for them, and then nothing has changed.
    virtual bool take_shadows(clq_shadow_def &) { return false; }
    // From now on it leaves out what a pyramid of this share of the picture's does not meet, where it culls at all.
    virtual void cull_by(double) {}
};

struct SceneEntry {
    const char *name;
    const char *about;
    std::unique_ptr<Scene> (*make)(Library &library, const CrowdOptions &crowd_options, const Character &character);
    uint32_t default_count;  // of individuals, where nobody asks for a number
    bool actors = false;     // a scene of S0, which is measured in both cull modes
};

// Every scene there is.
const std::vector<SceneEntry> &scene_entries();

// Throws Failure, naming what there is, where none has this name. character.tmpl null: the built-in citizen.
std::unique_ptr<Scene> make_scene(const std::string &name, Library &library, const CrowdOptions &crowd_options,
                                  const Character &character);

std::unique_ptr<Scene> make_plaza(Library &library, const CrowdOptions &crowd_options, const Character &character);
std::unique_ptr<Scene> make_odeon(Library &library, const CrowdOptions &crowd_options, const Character &character);
std::unique_ptr<Scene> make_vehicle(Library &library, const CrowdOptions &crowd_options, const Character &character);
std::unique_ptr<Scene> make_town_sky(Library &library, const CrowdOptions &crowd_options, const Character &character);
std::unique_ptr<Scene> make_hundred_actors(Library &library, const CrowdOptions &crowd_options,
                                           const Character &character);
std::unique_ptr<Scene> make_multitude(Library &library, const CrowdOptions &crowd_options, const Character &character);
std::unique_ptr<Scene> make_ten_thousand(Library &library, const CrowdOptions &crowd_options,
                                         const Character &character);
std::unique_ptr<Scene> make_parade(Library &library, const CrowdOptions &crowd_options, const Character &character);

}  // namespace scenes
