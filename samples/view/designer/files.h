// The files of the designer: colour maps, and painted zones.
#pragma once

#include <functional>

#include "samples/view/designer/designer.h"

namespace view
{

using SaveText = std::function<void(const std::string &path, const std::string &text)>;

// Where the window's files are.
class Folder
{
public:
    // `is_all`: a viewer over the network uses the window. No name leads out of the folder, to anything but a regular
    // file, or to a file of another user.
    Folder(std::string path, bool is_all = false) : path_(std::move(path)), is_all_(is_all) {}

    // Of a name that the window has made. Throws scenes::Failure.
    std::string at(const std::string &name) const;
    // Of a name that was typed: with a slash it is a path of its own, unless the folder is all there is.
    std::string typed(const std::string &name) const;

private:
    std::string path_;
    bool is_all_;
};

// Replaces the design by a file's, which can be undone. Throws scenes::Failure; the design then stays.
void load_design(Designer &designer, clq_context *context, const std::string &path);

// Loads and saves as the designer wishes, and says in `message` what was done or why not. `save` writes all of a file
// or nothing, or throws scenes::Failure.
void keep_designs(Designer &designer, clq_context *context, const Folder &folder, const SaveText &save,
                  std::string &message);

using SavePicture =
    std::function<void(const std::string &path, const std::vector<uint8_t> &rgb, int width, int height)>;

// Saves the painted zones of the texture that is shown, if the designer wishes it: TEMPLATE-zones.png, each zone in a
// colour, and TEMPLATE-zones.txt, which names them, as options for `claque prepare`.
void keep_zones(Designer &designer, const Folder &folder, const SavePicture &save_picture, const SaveText &save,
                std::string &message);

}  // namespace view
