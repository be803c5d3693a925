// Colour maps in the form for sampling (claque/colours.h, S2 5.2), and the colour ranges of one class for one template.
#pragma once

#include <claque/colours.h>

#include "lib/crowd/oklab_sampler.h"
#include "lib/model/template.h"

namespace claque::crowd
{

// Throws base::Error (CLQ_ARGUMENT) naming the first broken rule. Immutable.
class ColourMap
{
public:
    ColourMap(std::pmr::memory_resource *memory, const clq_colour_map_def &def);
    ColourMap(const ColourMap &) = delete;
    ColourMap &operator=(const ColourMap &) = delete;

    const clq_colour_map_def &def() const { return def_; }
    // The sampler of one palette entry; null: uniform in HSB.
    const OklabSampler *oklab_sampler(const clq_palette_entry *entry) const
    {
        const uint32_t table = table_of_[static_cast<size_t>(entry - palette_.data())];
        return table == model::none ? nullptr : &tables_[table];
    }

private:
    const char *keep(const char *text);

    clq_colour_map_def def_;
    std::pmr::vector<char> texts_;
    std::pmr::vector<clq_colour_class> classes_;
    std::pmr::vector<clq_zone_colours> zones_;
    std::pmr::vector<clq_palette_entry> palette_;
    std::pmr::vector<uint32_t> table_of_;  // one per palette entry
    std::pmr::vector<OklabSampler> tables_;
};

// A class of a map resolved for one template, zone by zone. The map and the template must outlive it.
class ColourRecipe
{
public:
    // Throws base::Error (CLQ_ARGUMENT): no such class, or a zone that the template lacks.
    ColourRecipe(std::pmr::memory_resource *memory, const ColourMap &map, uint32_t colour_class,
                 const model::Template &tmpl);
    ColourRecipe(ColourRecipe &&) = default;

    uint32_t zone_count() const { return static_cast<uint32_t>(zones_.size()); }
    void sample(uint32_t zone, uint64_t crowd_seed, uint64_t seed, double out_rgb[3]) const;

private:
    struct Zone {
        const clq_palette_entry *palette;
        uint32_t palette_count;
        bool of_map;           // else the template's own range
        uint32_t sample_zone;  // the zone whose random numbers it uses: itself, or the one it is linked to
        float variation;
    };
    uint32_t zone_named(const model::Template &tmpl, const char *name, const clq_colour_class &by) const;

    const ColourMap &map_;
    std::pmr::vector<clq_palette_entry> own_;  // the template's ranges
    std::pmr::vector<Zone> zones_;
};

}  // namespace claque::crowd
