// A scene: people in surroundings, seen by a camera in daylight. The claque command, tests and benchmarks share
// scenes, so that a measurement, a stored picture and a test show the same thing. All of a scene is a function of its
// options and the time: any frame can be drawn by itself.
#pragma once

#include <claque/shadow.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "samples/scenes/eye.h"
#include "samples/scenes/gl.h"
#include "samples/scenes/mind.h"
#include "samples/scenes/scene_crowd.h"

namespace scenes
{

// `path`: along the scene's recorded camera path if it has one, else as overview.
enum class Shot { overview, close, path };

// A character from a file.
struct Character {
    clq_template *tmpl = nullptr;
    uint32_t first_clip = 0;  // a parade plays this one and those after it,
    bool one_clip = false;    // or this one alone, all in step from its beginning
};

// Of a file that is read as times are shown.
struct ReadPart {
    const char *unit;  // what is counted
    uint64_t read = 0, of = 0;
};

class Scene
{
public:
    virtual ~Scene() = default;

    virtual clq_crowd *crowd() const = 0;
    // All individuals, for overlays that show each one's state; a scene may have nothing to show.
    virtual std::vector<clq_actor> actors() const { return {}; }
    virtual std::vector<clq_template *> templates() const = 0;
    virtual clq_camera camera(Shot shot, double aspect, double time_s) const = 0;
    // Places of the scene that have names, and the camera at one of them.
    virtual std::vector<std::string> viewpoints() const { return {}; }
    virtual clq_camera camera_from(const std::string &, double aspect, double time_s) const
    {
        return camera(Shot::overview, aspect, time_s);
    }

    // Moves the individuals to their positions at this time; call it before clq_crowd_update.
    virtual void place(double time_s) = 0;

    // Loads textures into the current context, which must be current again when the scene is destroyed.
    virtual void prepare(const Gl &gl) = 0;
    // Sets the lights and the haze that people and their surroundings share. Call it in a cleared picture, before
    // either is drawn.
    virtual void set_light(const Gl &gl, const Eye &eye) const = 0;
    // Draws everything but the crowd, in the light that is set, and leaves it set.
    virtual void draw_environment(const Gl &gl, const Eye &eye) const = 0;
    // Whether surroundings hide more of the people than people hide of them. They are then drawn first.
    virtual bool hides_people() const { return false; }
    // What is drawn last, such as what people carry: it follows their poses.
    virtual void draw_things(const Gl &, const Eye &) const {}
    // From now on the scene leaves out the shadows that it paints itself, so that claque draws shadows or nothing
    // does. Returns the light of the shadows; returns false, with nothing changed, if the scene has no ground for
    // them.
    virtual bool take_shadows(clq_shadow_def &) { return false; }
    // What an individual that decides is at; none: it does not.
    virtual std::optional<Mind> mind_of(clq_actor) const { return {}; }
    // How much of its file the scene has read and made so far; none: it reads no file by range of times.
    virtual std::optional<ReadPart> read_part() const { return {}; }
    // A time at which the most people are there.
    virtual double busiest_s() const { return 0; }
    // Whether a tile of a picture (SceneRenderer::show_tile) may leave out people who are not in it. Not where other
    // things follow people's poses beyond their spheres, or where the scene acts on actors in view.
    virtual bool can_cull_by_tile() const { return true; }
    // From now on a scene that culls leaves out what does not meet a frustum of this fraction of the picture's.
    virtual void cull_by(double) {}
};

struct SceneEntry {
    const char *name;
    const char *about;
    std::unique_ptr<Scene> (*make)(Library &library, const CrowdOptions &crowd_options, const Character &character);
    uint32_t default_count;  // of individuals, if none is given
    bool actors = false;     // a scene of S0, which is measured in both cull modes
};

// All scenes.
const std::vector<SceneEntry> &scene_entries();

// Warns of a template without clips: its people stand alike. Twins are no fault of a file, but few crowds are of them.
void warn_of_likeness(Library &library, const clq_template *tmpl);

// Throws Failure with the list of names if no scene has this name. character.tmpl null: the built-in citizen.
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
std::unique_ptr<Scene> make_amphitheatre(Library &library, const CrowdOptions &crowd_options,
                                         const Character &character);
std::unique_ptr<Scene> make_everything(Library &library, const CrowdOptions &crowd_options, const Character &character);
std::unique_ptr<Scene> make_parade(Library &library, const CrowdOptions &crowd_options, const Character &character);

}  // namespace scenes
