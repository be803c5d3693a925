// What each zone of a character without zone keys is, as far as names, colours and the place on the body tell.
#pragma once

#include <vector>

#include "lib/asset/zone_looks.h"

namespace claque::asset
{

enum class Role : uint8_t {
    skin,
    figure,  // a texture of face or hands with other things in it, or of most of the character: it joins the skin
    head,    // most of it lies on the head, as of hair, eyes and caps, or it is grey and covers face or hands
    hair,
    lips,  // and nails
    kept,  // eyes, lashes, teeth, metal
    hard,  // leather, shoes, wood
    cloth  // everything else
};

// Human skin: the ten shades of the Monk Skin Tone scale lie at hues of 18 to 40 degrees, saturations of 0.07 to 0.48
// and brightnesses of 0.16 to 0.97. Human hair: from black over brown, red and blond to grey; dark hair of higher hues
// looks green.
constexpr model::HsbRange human_skin = {8, 48, 0.06f, 0.6f, 0.15f, 1}, human_hair = {0, 42, 0, 0.8f, 0.06f, 0.9f};

bool is_human_skin(const std::array<float, 3> &rgb);
bool is_human_hair(const std::array<float, 3> &rgb);

// A zone's colour on texels and vertices of a mean colour.
std::array<float, 3> seen_colour(const model::Zone &zone, const std::array<float, 3> &mean);

// One for each zone. The zone's name decides, which is its material's; else that of a mesh or node of which it is the
// only zone. Without a telling name, skin is known by its colour on hands, or on the head where no hand shows any.
std::vector<Role> roles_of(const model::Model &model, const std::vector<ZoneLook> &looks);

}  // namespace claque::asset
