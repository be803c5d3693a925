#include "samples/view/designer/files.h"

#include <algorithm>
#include <cctype>
#include <sys/stat.h>
#include <unistd.h>

#include "samples/io/ending.h"
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

// Of a template, whose name a file may have given.
std::string as_name(std::string text)
{
    std::replace_if(
        text.begin(), text.end(),
        [](unsigned char letter) { return std::isalnum(letter) == 0 && letter != '.' && letter != '-'; }, '_');
    return text;
}

}  // namespace

std::string Folder::at(const std::string &name) const
{
    const std::string path = path_ + "/" + name;
    if (!is_all_) return path;
    // Files whose names begin with a dot are settings, and some of them are programs.
    if (name.empty() || name[0] == '.' || name.find('/') != std::string::npos)
        throw scenes::Failure("'" + name + "' is no name for a file of a served window: it needs letters, no slash, " +
                              "and no dot at its beginning");
    struct stat there = {};
    if (lstat(path.c_str(), &there) != 0) return path;
    if (!S_ISREG(there.st_mode)) throw scenes::Failure(name + " is no regular file");
    if (there.st_uid != geteuid()) throw scenes::Failure(name + " belongs to another user");
    return path;
}

std::string Folder::typed(const std::string &name) const
{
    if (name.empty()) throw scenes::Failure("the field 'map file' is empty: it needs the name of a file");
    if (is_all_ && io::ending_of(name) != ".toml")
        throw scenes::Failure(name + " does not end in .toml, as colour maps of a served window do");
    return !is_all_ && name.find('/') != std::string::npos ? name : at(name);
}

void keep_zones(Designer &designer, const Folder &folder, const SavePicture &save_picture, const SaveText &save,
                std::string &message)
{
    if (!designer.wishes.save_zones) return;
    designer.wishes.save_zones = false;
    try {
        const SharedMap map = painted_map(designer);
        if (!map) throw scenes::Failure("nothing is painted on this texture yet");
        std::vector<std::string> colours;
        const std::vector<uint8_t> rgb = picture_of(*map, colours);
        const std::string name = as_name(map->tmpl) + "-zones";
        save_picture(folder.at(name + ".png"), rgb, static_cast<int>(map->width()), static_cast<int>(map->height()));
        std::string options = "--zones " + name + ".png";
        std::string lost;
        for (size_t k = 0; k < colours.size(); ++k) {
            if (colours[k].empty()) lost += (lost.empty() ? "" : ", ") + map->names[k];
            if (colours[k].empty()) continue;
            options += " --zone " + quoted(colours[k] + "=" + map->names[k]);
            if (map->reduced) options += " --reduce " + quoted(map->names[k]);
        }
        save(folder.at(name + ".txt"), options + "\n");
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

void keep_designs(Designer &designer, clq_context *context, const Folder &folder, const SaveText &save,
                  std::string &message)
{
    const DesignerWishes wishes = designer.wishes;
    designer.wishes.load = designer.wishes.save = false;
    try {
        if (wishes.save) {
            save(folder.typed(designer.file), design_text(context, designer.design));
            message = designer.file + " is saved";
        }
        if (wishes.load) {
            load_design(designer, context, folder.typed(designer.file));
            message = designer.file + " is loaded";
        }
    } catch (const scenes::Failure &failure) {
        message = failure.what();
    }
}

}  // namespace view
