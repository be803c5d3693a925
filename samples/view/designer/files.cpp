#include "samples/view/designer/files.h"

#include "samples/io/files.h"

namespace view
{

std::string path_in(const std::string &folder, const std::string &name)
{
    if (name.empty()) throw scenes::Failure("the field 'map file' is empty: it needs the name of a file");
    return name.find('/') == std::string::npos ? folder + "/" + name : name;
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
