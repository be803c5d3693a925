#include "samples/scenes/amphitheatre/orders.h"

#include <array>

namespace scenes::amphitheatre
{
namespace
{

using Dye = SocialClass::Dye;

// Hue in degrees; saturation and brightness from and to.
Dye dye(const char *zone, float hue_from, float hue_to, float s_from, float s_to, float b_from, float b_to)
{
    return {zone, {hue_from, hue_to, s_from, s_to, b_from, b_to}};
}

const Dye white_toga = dye("outer", 30, 55, 0.02f, 0.12f, 0.88f, 1.0f);
const Dye cream_toga = dye("outer", 25, 50, 0.06f, 0.24f, 0.76f, 0.96f);

SocialClass kind(const char *name, const char *character, double share, const Temperament &temperament,
                 std::vector<Dye> palette)
{
    SocialClass made;
    made.name = name;
    made.character = character;
    made.share = share;
    made.temperament = temperament;
    made.palette = std::move(palette);
    return made;
}

}  // namespace

const std::vector<SocialClass> &orders_of(Tier tier)
{
    static const std::array<std::vector<SocialClass>, tier_count> orders = {
        std::vector<SocialClass>{kind("senators", "decurion", 1, Temperament::grave,
                                      {white_toga, dye("tunic", 30, 50, 0.02f, 0.1f, 0.85f, 0.98f),
                                       dye("border", 300, 345, 0.6f, 0.85f, 0.32f, 0.5f)})},
        {kind("knights", "decurion", 0.7, Temperament::grave,
              {cream_toga, dye("tunic", 350, 45, 0.1f, 0.6f, 0.6f, 0.9f),
               dye("border", 330, 20, 0.5f, 0.85f, 0.4f, 0.6f)}),
         kind("knights", "citizen", 0.3, Temperament::gracious,
              {dye("tunic", 25, 50, 0.04f, 0.25f, 0.78f, 0.96f), dye("border", 330, 20, 0.5f, 0.85f, 0.4f, 0.6f)})},
        {kind("citizens", "citizen", 0.42, Temperament::hearty, {dye("tunic", 20, 55, 0.05f, 0.35f, 0.7f, 0.95f)}),
         kind("citizens", "decurion", 0.33, Temperament::hearty,
              {cream_toga, dye("tunic", 0, 360, 0.2f, 0.6f, 0.45f, 0.8f)}),
         kind("citizens", "plebeian", 0.25, Temperament::hearty, {dye("tunic", 350, 60, 0.25f, 0.7f, 0.5f, 0.85f)})},
        {kind("the poor", "plebeian", 0.65, Temperament::hearty,
              {dye("tunic", 5, 50, 0.2f, 0.55f, 0.3f, 0.6f), dye("outer", 0, 60, 0.15f, 0.5f, 0.25f, 0.55f)}),
         kind("the poor", "citizen", 0.35, Temperament::hearty, {dye("tunic", 350, 60, 0.15f, 0.5f, 0.4f, 0.75f)})},
        {kind("women", "patrician", 0.8, Temperament::gracious,
              {dye("tunic", 340, 70, 0.08f, 0.4f, 0.7f, 0.95f), dye("outer", 330, 75, 0.2f, 0.6f, 0.5f, 0.9f)}),
         kind("the poorest", "plebeian", 0.2, Temperament::hearty, {dye("tunic", 10, 45, 0.2f, 0.5f, 0.35f, 0.65f)})},
    };
    return orders[static_cast<size_t>(tier)];
}

const char *class_of(Tier tier) { return orders_of(tier).front().name.c_str(); }

}  // namespace scenes::amphitheatre
