#include "lib/lod/far.h"

#include "lib/lod/far_image.h"
#include "lib/lod/shell.h"

namespace claque::lod
{

FarLevels make_far(const model::Model &model, const std::vector<const model::Part *> &source, const FarWish &wish)
{
    ShellWish shell;
    shell.targets = wish.targets;
    shell.influence = wish.influence, shell.zone = wish.zone;
    return painted(model, source, shells_of(model, source, shell));
}

}  // namespace claque::lod
