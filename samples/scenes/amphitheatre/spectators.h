// The people in the rows: one of them for each taken seat, with a character, colours, size, gaze, clip and phase of its
// own.
#pragma once

#include "samples/scenes/amphitheatre/acclaim.h"
#include "samples/scenes/amphitheatre/exposure.h"
#include "samples/scenes/amphitheatre/orders.h"
#include "samples/scenes/scene_crowd.h"

namespace scenes::amphitheatre
{

struct Sitter {
    size_t seat;  // of Plan::seats()
    Tier tier;
    size_t kind;  // of orders_of(tier)
    float scale;
    clq_transform place;
};

// Fills so many seats, in every tier the same share of them; the empty ones are picked at random. Each looks at a place
// of its own in the arena.
std::vector<Sitter> seat_people(const Plan &plan, uint32_t people, uint64_t seed);

// The built-in characters of a scene, in levels, with what their clips need.
class Figures
{
public:
    struct Figure {
        std::string name;
        clq_template *tmpl = nullptr;
        std::array<uint32_t, act_count> clips = {};
        std::array<double, act_count> duration_s = {};
    };
    Figures(Library &library, const std::vector<uint32_t> &levels) : library_(library), levels_(levels) {}
    size_t find(const std::string &name);  // made at the first request
    const Figure &operator[](size_t i) const { return figures_[i]; }
    std::vector<clq_template *> templates() const;

private:
    Library &library_;
    std::vector<uint32_t> levels_;
    std::vector<Figure> figures_;
};

class Spectators
{
public:
    Spectators(Figures &figures, SceneCrowd &crowd, const Plan &plan, const Exposure &exposure, uint32_t people,
               uint64_t seed);

    // Gives each spectator the clip that it plays at this time. Times may come in any order.
    void act(double time_s);
    size_t size() const { return spectators_.size(); }

private:
    const Figures &figures_;
    SceneCrowd &crowd_;
    std::vector<Spectator> spectators_;
    std::vector<size_t> figure_of_;
    std::vector<Playing> playing_;
};

}  // namespace scenes::amphitheatre
