#include "samples/scenes/town/town.h"

#include "samples/scenes/stone.h"
#include "samples/scenes/town/ground.h"
#include "samples/scenes/town/pictures.h"

namespace scenes::town
{
namespace
{

constexpr std::array<float, surface_kind_count> texture_metres = {
    land_metres, furrows_metres, flagstone_metres, cobbles_metres, water_metres, 1, plaster_metres,
    3,           tiles_metres,   leaves_metres};
// What stands hides the ground, so it comes first; shadows are blended over the ground.
constexpr std::array<SurfaceKind, surface_kind_count> drawing_order = {
    SurfaceKind::tiles,   SurfaceKind::facades, SurfaceKind::stone, SurfaceKind::leaves,  SurfaceKind::paving,
    SurfaceKind::cobbles, SurfaceKind::land,    SurfaceKind::water, SurfaceKind::furrows, SurfaceKind::shade};
constexpr float haze_per_m = 0.00030f;

void throw_shadow(SunShadows &shadows, const House &h, const Terrain &terrain)
{
    const double floor = floor_of(h, terrain), eaves = floor + h.eaves_height(), ridge = floor + h.ridge_height();
    const double a = h.width_m / 2, o = h.depth_m / 2, e = House::eaves_m;
    const Site site = h.site();
    std::vector<Vec3> points;
    for (const double s : {-1.0, 1.0})
        for (const double t : {-1.0, 1.0}) {
            points.push_back(site.at(s * a, floor, t * o));
            points.push_back(site.at(s * (a + e), eaves - h.pitch * e, t * (o + e)));
        }
    const bool across = h.roof == House::Roof::gable_to_street || (h.roof == House::Roof::hip && h.depth_m > h.width_m);
    const double length = across ? o : a, span = across ? a : o;
    const double half = h.roof == House::Roof::hip ? std::max(0.3, length - span) : length + e;
    for (const double s : {-half, half}) points.push_back(across ? site.at(0, ridge, s) : site.at(s, ridge, 0));
    shadows.cast(points, floor);
}

}  // namespace

Town::Town(uint64_t seed, Trade trade)
    : seed_(seed),
      trade_(trade),
      plan_(seed),
      terrain_(plan_, seed),
      houses_(place_houses(plan_, seed)),
      trees_(place_trees(plan_, houses_, seed)),
      pieces_(texture_metres),
      sky_(seed)
{
    SunShadows shadows(pieces_, terrain_, light().to_sun);
    cover_ground(pieces_, plan_, terrain_, seed);
    grow_woods(pieces_, plan_, terrain_, seed);
    for (const House &house : houses_) {
        build_house(pieces_, house, terrain_, seed);
        throw_shadow(shadows, house, terrain_);
    }
    build_landmarks(pieces_, shadows, plan_, terrain_, seed, trade);
    plant_hedges(pieces_, plan_, terrain_, houses_, seed);
    for (const Tree &tree : trees_) grow_tree(pieces_, shadows, tree, terrain_, seed);
}

Daylight Town::light()
{
    return {{-0.56f, 0.66f, 0.50f}, {0.78f, 0.73f, 0.62f}, {0.40f, 0.42f, 0.47f}, {0.13f, 0.12f, 0.10f}};
}

Image Town::picture(SurfaceKind layer) const
{
    switch (layer) {
        case SurfaceKind::land:
            return land(seed_);
        case SurfaceKind::furrows:
            return furrows(seed_);
        case SurfaceKind::paving:
            return flagstones(seed_);
        case SurfaceKind::cobbles:
            return cobbles(seed_);
        case SurfaceKind::water:
            return water(seed_);
        case SurfaceKind::shade:
            return {};
        case SurfaceKind::stone:
            return plaster(seed_);
        case SurfaceKind::facades:
            return facades(seed_);
        case SurfaceKind::tiles:
            return tiles(seed_);
        case SurfaceKind::leaves:
            return leaves(seed_);
    }
    return {};
}

void Town::prepare(const Gl &gl)
{
    for (size_t i = 0; i < surface_kind_count; ++i) {
        const SurfaceKind layer = static_cast<SurfaceKind>(i);
        if (layer == SurfaceKind::shade) continue;
        pictures_[i] =
            std::make_unique<Texture>(gl, picture(layer), layer != SurfaceKind::facades,
                                      Texture::Filter::bilinear);  // two mipmaps show little on grass and tiles
    }
    sky_.prepare(gl);
}

void Town::set_light(const Gl &g, const Eye &eye)
{
    set_lights(g, light(), eye);
    const float haze[4] = {Clouds::haze.r, Clouds::haze.g, Clouds::haze.b, 1};
    g.Fogfv(gl::fog_color, haze);
    g.Fogi(gl::fog_mode, gl::exp);
    g.Fogf(gl::fog_density, haze_per_m);
    g.Enable(gl::fog);
}

size_t Town::draw(const Gl &g, const Eye &eye, const Frustum *cull) const
{
    g.Enable(gl::cull_face);
    const size_t sent = pieces_.choose(cull, eye.position, chosen_);
    for (const SurfaceKind layer : drawing_order) {
        const size_t i = static_cast<size_t>(layer);
        if (layer == SurfaceKind::shade) {
            g.Disable(gl::texture_2d);
            g.Disable(gl::lighting);
            g.Enable(gl::blend);
            g.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
            g.DepthMask(0);
            g.PolygonOffset(-1, -2);
            g.Enable(gl::polygon_offset_fill);
        } else if (pictures_[i]) pictures_[i]->use();
        pieces_.draw(g, layer, chosen_);
        if (layer != SurfaceKind::shade) continue;
        g.Disable(gl::polygon_offset_fill);
        g.DepthMask(1);
        g.Disable(gl::blend);
        g.Enable(gl::lighting);
    }
    sky_.draw(g, eye);
    g.Enable(gl::fog);
    g.Disable(gl::texture_2d);
    return sent;
}

}  // namespace scenes::town
