#include "lib/figures/figure.h"

#include "lib/figures/assemble.h"
#include "lib/figures/parts.h"

namespace claque::figures
{

namespace
{

void add_citizen(Mesh &mesh)
{
    add_head(mesh);
    add_tunic(mesh);
    for (const Side side : {Side::left, Side::right}) {
        add_arm(mesh, side);
        add_leg(mesh, side);
    }
}

}  // namespace

model::Model citizen()
{
    Figure figure;
    figure.name = "citizen";
    figure.add_pieces = add_citizen;
    figure.painter = paint_citizen;
    for (int z = 0; z < zone_count; ++z) figure.zones.push_back(zone_of(static_cast<Zone>(z)));
    figure.clips = {
        {"stand", 180, stand_at}, {"walk", 33, walk_at}, {"applaud", 72, applaud_at}, {"cheer", 60, cheer_at}};
    return assemble(figure);
}

}  // namespace claque::figures
