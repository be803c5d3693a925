// Facing and size of a character that was loaded: a node above the roots of its file, and a look at where it faces.
#pragma once

#include <claque/assets.h>

#include "lib/model/model.h"

namespace claque::api
{

// The box of the rest pose, without hidden parts; min > max without vertices.
struct Box {
    float min[3] = {3.4e38f, 3.4e38f, 3.4e38f}, max[3] = {-3.4e38f, -3.4e38f, -3.4e38f};
};
Box rest_box(const model::Model &model);

// Throws base::Error (ARGUMENT) for turn_deg, height_m and scale that break their rules.
void check_placement(const clq_asset_options &options);

// Puts a node above all others where the file, by its own turn, or the options ask for another facing or size; true if
// there is one now, as node 0. Warns of a character that then faces elsewhere than +z, and of a person of another size
// than people have where none is asked for. Throws base::Error (ARGUMENT).
bool place(model::Model &model, double own_turn_deg, const clq_asset_options &options);

// A rig as its file has it, for as long as this lives: clips are bound and converted there, so that they turn and grow
// with the character.
class AsInFile
{
public:
    AsInFile(model::Rig &rig, bool placed) : rig_(rig), placed_(placed)
    {
        if (placed_) std::swap(rig_.rest[0], own_);
    }
    ~AsInFile()
    {
        if (placed_) std::swap(rig_.rest[0], own_);
    }
    AsInFile(const AsInFile &) = delete;
    AsInFile &operator=(const AsInFile &) = delete;

private:
    model::Rig &rig_;
    const bool placed_;
    math::Trs own_;  // while the rig has the identity
};

}  // namespace claque::api
