// The files of the designer: colour maps, and painted zones.
#pragma once

#include <functional>

#include "samples/view/designer/designer.h"

namespace view
{

using SaveText = std::function<void(const std::string &path, const std::string &text)>;

// A name with a slash is a path of its own, others are in the folder.
std::string path_in(const std::string &folder, const std::string &name);

// Replaces the design by a file's, which can be undone. Throws scenes::Failure; the design then stays.
void load_design(Designer &designer, clq_context *context, const std::string &path);

// Loads and saves as the designer wishes, and says in `message` what was done or why not. `save` writes all of a file
// or nothing, or throws scenes::Failure.
void keep_designs(Designer &designer, clq_context *context, const std::string &folder, const SaveText &save,
                  std::string &message);

using SavePicture =
    std::function<void(const std::string &path, const std::vector<uint8_t> &rgb, int width, int height)>;

// Saves the painted zones of the texture that is shown, if the designer wishes it: TEMPLATE-zones.png, each zone in a
// colour, and TEMPLATE-zones.txt, which names them, as options for `claque prepare`.
void keep_zones(Designer &designer, const std::string &folder, const SavePicture &save_picture, const SaveText &save,
                std::string &message);

}  // namespace view
