// Individuals of one template, each by itself before a studio's backdrop, all in the same pose and from the same side,
// so that only their colours differ.
#pragma once

#include "samples/cli/characters.h"
#include "samples/contexts/offscreen.h"
#include "samples/scenes/gl.h"
#include "samples/scenes/light.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/sky.h"

#include <functional>
#include <memory>
#include <vector>

namespace cli
{

// How much room a character takes in the pose and the turn that it is shown in, in metres; Y up.
struct Extents {
    double scale = 1;  // of the character, so that its longest side is a person's height
    double first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
};

class Portraits
{
public:
    // Throws scenes::Failure where no context can be had. `loaded` has to outlive it.
    Portraits(scenes::Library &library, const LoadedCharacter &loaded, uint64_t seed);
    ~Portraits();
    Portraits(const Portraits &) = delete;
    Portraits &operator=(const Portraits &) = delete;

    // Width by height of what is seen, at best.
    double aspect() const;
    void resize(int width, int height);
    // Metres that a picture shows from its lower edge to its upper one, at best.
    double visible_m() const;
    // From now on at this level of detail, whatever the size. Level 0 until then.
    void show_level(uint32_t level) { level_ = level; }
    // From now on with so much more room round the person, for poses that reach farther than the one that was measured,
    // and seen from where people look along (x, z).
    void make_room(double beside_m, double above_m) { room_beside_m_ = beside_m, room_above_m_ = above_m; }
    void turn(double x, double z) { turn_x_ = x, turn_z_ = z; }
    const std::string &context_name() const { return offscreen_->name(); }

    // Three bytes a pixel, top row first, valid until the next. resize() comes first.
    const std::vector<uint8_t> &picture(uint32_t who);
    // At a moment after something has been commanded.
    using Command = std::function<void(clq_crowd *, clq_actor)>;
    const std::vector<uint8_t> &picture(uint32_t who, const Command &command, double time_s);

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
    double turn_x_ = 0.34, turn_z_ = 0.94;  // breast and a side are seen
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
