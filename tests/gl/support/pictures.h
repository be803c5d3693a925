// Pictures of a character: a renderer's, and the plain and id pictures for comparison.
#pragma once

#include <vector>

#include "passes/renderer.h"
#include "tests/gl/support/host_gl.h"
#include "tests/gl/support/posed_model.h"

namespace gltest
{

namespace passes = claque::passes;

struct Camera {
    float projection[16];
    float model_view[16];
};

// Distance in radii of the character; angles rotate it. `aspect` is width / height.
Camera camera_on(const PosedModel &posed, float distance_radii, float turn_rad, float tilt_rad, float aspect);

using Picture = std::vector<uint8_t>;  // RGB, top row first

// A template's skinned vertices in a pose. Points to memory of others.
struct Individual {
    const model::Template *tmpl;
    const float *positions, *normals;
    const uint8_t *zone_rgb;
    float model_view[16];
    uint32_t texture_set = 0;
};
Individual individual_of(const PosedModel &posed, const Camera &camera, const uint8_t *zone_rgb);

claque::draw::DrawList list_of(const std::vector<Individual> &individuals, const float (&projection)[16]);
claque::draw::DrawList list_of(const PosedModel &posed, const Camera &camera, const uint8_t *zone_rgb = nullptr);

constexpr uint8_t background[3] = {16, 0, 8};  // RGB565 keeps it exactly; no zone colour is near
uint32_t covered(const Picture &picture);      // pixels that are not background

// Clears to `background` and draws. Adds a test failure if the renderer refuses, or if a list that is not empty covers
// less than a share of the picture: two pictures of nothing are equal.
Picture draw(contexts::Offscreen &context, passes::Renderer &renderer, const claque::draw::DrawList &list,
             double least_share = 0.01);

// GL as a plain program has it: viewport and background, then only depth, matrices and the character's arrays.
Picture begin_picture(contexts::Offscreen &context, const HostGl &host, const uint8_t *rgb);
void plain_state(const HostGl &host, const float (&projection)[16]);
void end_plain_state(const HostGl &host);

// Every triangle once, one draw per surface, unlit; the texture's RGB is the colour of each texel's zone.
Picture draw_plain(contexts::Offscreen &context, const std::vector<Individual> &individuals,
                   const float (&projection)[16]);
Picture draw_plain(contexts::Offscreen &context, const PosedModel &posed, const Camera &camera,
                   const uint8_t *zone_rgb);

// Every triangle in a flat colour of its own, in list order or reversed: where the two differ, depths tie.
// RGB565 could not distinguish more than 65 535 triangles.
enum class Order { forwards, backwards };
Picture draw_ids(contexts::Offscreen &context, const std::vector<Individual> &individuals,
                 const float (&projection)[16], Order order);
Picture draw_ids(contexts::Offscreen &context, const PosedModel &posed, const Camera &camera, Order order);

// What a picture has to show. Without ids no pixel may tie.
struct Wanted {
    Picture plain, forwards = {}, backwards = {};
};
Wanted wanted_of(contexts::Offscreen &context, const PosedModel &posed, const Camera &camera);  // in zone_colours()

struct Comparison {
    uint32_t covered = 0;  // pixels of the plain picture that are not background
    uint32_t ties = 0;     // of them, excluded: different triangles at one depth
    uint32_t wrong = 0;    // other pixels that differ from the plain picture
    uint32_t holes = 0;    // of all pixels: background where the plain picture has none
};
Comparison compare(const Wanted &wanted, const Picture &coloured);

// The law of zones over all pictures of a test. Adds failures where one is wrong, has holes or shows too little, and at
// its end where more depths tie than may.
class Verdict
{
public:
    ~Verdict();
    // At least this share of the picture has to be covered.
    Comparison hold(const Wanted &wanted, const Picture &coloured, double least_share);

    double most_ties_share = 0;  // of covered pixels

private:
    uint64_t covered_ = 0, ties_ = 0;
};

}  // namespace gltest
