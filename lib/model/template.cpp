#include "lib/model/template.h"

namespace claque::model
{

bool Template::has_rigid_parts_only() const
{
    for (const Level &level : levels) {
        if (!level.morph_ranges.empty() || (level.parts.empty() && level.source_count > 0)) return false;
        for (const LevelPart &part : level.parts)
            if (part.sphere_count != 1) return false;
        for (const InfluenceRun &run : level.runs)
            if (run.influences != 1) return false;
    }
    return true;
}

}  // namespace claque::model
