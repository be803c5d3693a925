// claque prepare: a character read and split once, saved so that libclaque alone can load it.
#include "samples/cli/characters.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"

#include <memory>

namespace cli
{
namespace
{

struct PrepareArguments {
    std::string file, out;
    std::vector<std::string> hidden;
    ClipArguments clips;
};

void prepare(const PrepareArguments &a)
{
    expect_writable(a.out);
    scenes::Library library(1);
    const LoadedCharacter loaded = load_character(library, a.file, a.hidden, a.clips);
    std::string bytes;
    const auto append = [](void *user, const void *piece, size_t size_bytes) {
        static_cast<std::string *>(user)->append(static_cast<const char *>(piece), size_bytes);
        return 0;
    };
    scenes::check(clq_template_save(loaded.tmpl.get(), append, &bytes), a.file);
    write_whole(a.out, bytes);
}

}  // namespace

void add_prepare(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<PrepareArguments>();
    CLI::App *c = app.add_subcommand("prepare", "Read and split a character once; render takes the result as FILE");
    c->add_option("FILE", a->file, "glTF or GLB, or a built-in figure's name (citizen, patrician ...)")->required();
    c->add_option("--hide", a->hidden, "Leave out the node of this name and what hangs on it (may repeat)")
        ->expected(1)
        ->take_all();
    add_clip_options(*c, a->clips);
    c->add_option("--out,-o", a->out, "The prepared file (.clq); - is standard output")->required();
    c->callback([a, &chosen] { chosen = [a] { prepare(*a); }; });
}

}  // namespace cli
