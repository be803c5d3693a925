// Dresses the people of a crowd as a design says. Each change reaches all of them before the next update: a class that
// changed becomes a colour map (clq_colour_map_create), from which the colours of its people are sampled
// (clq_crowd_randomise_colours). The crowd, its templates and its places stay.
#pragma once

#include <functional>

#include "samples/scenes/scene.h"
#include "samples/view/designer/designer.h"

namespace view
{

class Dresser
{
public:
    // The crowd is another one: its people wear what its scene gave them.
    void forget();

    // `people`: all that are there. `called`: the name of the class of one of them, by its place among them; may be
    // empty. Returns the number of individuals whose colours changed; `why_not`: what did not fit, "" for nothing.
    size_t dress(clq_context *context, clq_crowd *crowd, const std::vector<clq_actor> &people,
                 const std::function<std::string(size_t)> &called, const Designer &designer, std::string &why_not);
    // Whether all people wear what their scene gave them, and should.
    bool idle(const Designer &designer) const;

private:
    struct Person {
        clq_actor actor = {};
        const clq_template *tmpl = nullptr;
        std::string tmpl_name, called;
        std::vector<float> own;  // colours, from the scene
        uint32_t own_set = 0, set = 0;
        SharedClass worn;
    };

    // Returns false if all of them are known.
    bool meet(const clq_crowd *crowd, const std::vector<clq_actor> &people,
              const std::function<std::string(size_t)> &called);
    size_t colour(clq_context *context, clq_crowd *crowd, const Design &design, std::string &why_not);
    void put_on_sets(clq_crowd *crowd, const Designer &designer);
    const clq_colour_map *map(clq_context *context, const SharedClass &one);

    std::vector<Person> people_;
    std::vector<std::pair<SharedClass, scenes::ColourMap>> maps_;  // of the last design's classes
    std::vector<SharedClass> last_;                                // of the design that they wear
    bool dressed_ = false;
};

}  // namespace view
