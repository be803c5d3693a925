// Individuals of one template, each alone before a studio backdrop, all in the same pose and from the same side, so
// that only their colours differ.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "samples/cli/characters.h"
#include "samples/contexts/offscreen.h"
#include "samples/scenes/gl.h"
#include "samples/scenes/light.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/sky.h"

namespace cli
{

// The space that a character takes in its displayed pose and orientation, in metres; Y up.
struct Extents {
    double scale = 1;  // of the character, so that its longest side is a person's height
    double first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
};

class Portraits
{
public:
    // Throws scenes::Failure if no context is available. `loaded` must outlive this object.
    Portraits(scenes::Library &library, const LoadedCharacter &loaded, uint64_t seed);
    ~Portraits();
    Portraits(const Portraits &) = delete;
    Portraits &operator=(const Portraits &) = delete;

    // The preferred ratio of width to height.
    double aspect() const;
    void resize(int width, int height);
    // The preferred height of a picture, in metres.
    double visible_m() const;
    // Shows this level of detail from now on, whatever the size. Level 0 until then.
    void show_level(uint32_t level) { level_ = level; }
    // Adds space round the person from now on, for poses that reach farther than the measured one.
    void make_room(double beside_m, double above_m) { room_beside_m_ = beside_m, room_above_m_ = above_m; }
    // The person faces (x, z) from now on; the camera is on the side of +z.
    void turn(double x, double z) { turn_x_ = x, turn_z_ = z; }
    const std::string &context_name() const { return offscreen_->name(); }

    // Three bytes a pixel, top row first, valid until the next call. Call resize() first.
    const std::vector<uint8_t> &picture(uint32_t person);
    // At a time after a command.
    using Command = std::function<void(clq_crowd *, clq_actor)>;
    const std::vector<uint8_t> &picture(uint32_t person, const Command &command, double time_s);

private:
    clq_play pose() const;
    void measure();
    void build_surroundings();
    clq_camera camera() const;
    float lod_scale(const clq_camera &seen) const;

    scenes::Library &library_;
    const LoadedCharacter &loaded_;
    uint64_t seed_;
    uint32_t level_ = 0;
    double room_beside_m_ = 0, room_above_m_ = 0;
    double turn_x_ = 0.34, turn_z_ = 0.94;  // the front and one side are visible
    int width_ = 1, height_ = 1;
    Extents extents_;
    scenes::Sky sky_;
    scenes::Daylight light_;
    scenes::Geometry ground_;
    std::unique_ptr<contexts::Offscreen> offscreen_;
    scenes::Gl gl_;
    std::unique_ptr<scenes::Shadows> shadows_;
    scenes::Own<clq_renderer> renderer_;
    std::vector<uint8_t> rgb_;
};

}  // namespace cli
