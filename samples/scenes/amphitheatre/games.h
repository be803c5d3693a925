// The hundred in the arena and in the boxes of honour: a procession (pompa) of pairs that walks round the arena,
// companies that greet the emperor, and the guests that sit with him and with the giver of the games.
#pragma once

#include "samples/scenes/amphitheatre/masonry.h"
#include "samples/scenes/amphitheatre/spectators.h"
#include "samples/scenes/shadows.h"

namespace scenes::amphitheatre
{

constexpr size_t walker_count = 56, greeter_count = 30, guest_count = 14;
constexpr size_t game_count = walker_count + greeter_count + guest_count;

// One walker of the procession at a time, on the sand. `walker`: [0, walker_count); two in a row are a pair.
clq_transform walking(const Plan &plan, size_t walker, double time_s, double metres_per_s, float scale);

class Games
{
public:
    Games(Figures &figures, SceneCrowd &crowd, const Plan &plan, const Exposure &exposure, uint64_t seed);

    // Moves the procession.
    void place(double time_s);
    void prepare(const Gl &gl) { shadows_.prepare(gl); }
    void draw_shadows(const Gl &gl) const { shadows_.draw(gl); }

private:
    void enter(const std::string &character, const clq_transform &place, const char *clip, double speed, size_t person);
    void walkers();
    void greeters();
    void guests();
    void add_lit(size_t first, size_t count, std::vector<clq_transform> &out) const;

    Figures &figures_;
    SceneCrowd &crowd_;
    const Plan &plan_;
    const Exposure &exposure_;
    uint64_t seed_;
    size_t first_;  // of the crowd's actors
    double metres_per_s_ = 1;
    Shadows shadows_;
    std::vector<clq_transform> lit_greeters_;  // they stand
    std::vector<clq_transform> moved_, lit_;   // of the last call of place()
};

// Stone seats for the guests, in the boxes.
void build_guest_seats(Masonry &masonry, const Plan &plan);

}  // namespace scenes::amphitheatre
