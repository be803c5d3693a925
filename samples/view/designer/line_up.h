// People side by side in blocks, one block for each character, for designing what they wear. Their number can change
// while they stand there.
#pragma once

#include "samples/scenes/scene.h"

namespace view
{

// A scene whose number of people can change.
class Countable
{
public:
    virtual ~Countable() = default;
    // Throws scenes::Failure. Those that stay keep their ids, their colours and their clips.
    virtual void set_count(uint32_t count) = 0;
};

std::unique_ptr<scenes::Scene> make_line_up(scenes::Library &library, const scenes::CrowdOptions &crowd_options,
                                            const std::vector<scenes::Character> &characters);

// A built-in person as a line-up takes it, with levels of detail if they are on.
scenes::Character builtin_person(scenes::Library &library, const std::string &name, scenes::Lod lod);

}  // namespace view
