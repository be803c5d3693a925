#include "samples/view/designer/files.h"

#include "samples/io/files.h"

namespace view
{
namespace
{

// As a shell reads it.
std::string quoted(const std::string &text)
{
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

}  // namespace

std::string path_in(const std::string &folder, const std::string &name)
{
    if (name.empty()) throw scenes::Failure("the field 'map file' is empty: it needs the name of a file");
    return name.find('/') == std::string::npos ? folder + "/" + name : name;
}

void keep_zones(Designer &designer, const std::string &folder, const SavePicture &save_picture, const SaveText &save,
                std::string &message)
{
    if (!designer.wishes.save_zones) return;
    designer.wishes.save_zones = false;
    try {
        const SharedMap map = painted_map(designer);
        if (!map) throw scenes::Failure("nothing is painted on this texture yet");
        std::vector<std::string> colours;
        const std::vector<uint8_t> rgb = picture_of(*map, colours);
        const std::string name = map->tmpl + "-zones";
        save_picture(folder + "/" + name + ".png", rgb, static_cast<int>(map->width()),
                     static_cast<int>(map->height()));
        std::string options = "--zones " + name + ".png";
        std::string lost;
        for (size_t k = 0; k < colours.size(); ++k) {
            if (colours[k].empty()) lost += (lost.empty() ? "" : ", ") + map->names[k];
            if (colours[k].empty()) continue;
            options += " --zone " + quoted(colours[k] + "=" + map->names[k]);
            if (map->reduced) options += " --reduce " + quoted(map->names[k]);
        }
        save(folder + "/" + name + ".txt", options + "\n");
        message = name + ".png is saved, and " + name + ".txt with its options for claque prepare";
        if (!lost.empty()) message += "; too small to be read again: " + lost;
    } catch (const scenes::Failure &failure) {
        message = failure.what();
    }
}

void load_design(Designer &designer, clq_context *context, const std::string &path)
{
    std::string text;
    const std::string wrong = io::read_whole(path, text);
    if (!wrong.empty()) throw scenes::Failure(wrong);
    take_design(designer, read_design(context, text, path), "");
}

void keep_designs(Designer &designer, clq_context *context, const std::string &folder, const SaveText &save,
                  std::string &message)
{
    const DesignerWishes wishes = designer.wishes;
    designer.wishes.load = designer.wishes.save = false;
    try {
        if (wishes.save) {
            save(path_in(folder, designer.file), design_text(context, designer.design));
            message = designer.file + " is saved";
        }
        if (wishes.load) {
            load_design(designer, context, path_in(folder, designer.file));
            message = designer.file + " is loaded";
        }
    } catch (const scenes::Failure &failure) {
        message = failure.what();
    }
}

}  // namespace view
