// claque convert: an old character format to GLB.
#include "samples/convert/convert.h"

#include <memory>

#include "samples/cli/characters.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/warnings.h"

namespace cli
{
namespace
{

struct ConvertArguments {
    std::string file, out, up;
    convert::Options options;
    convert::Limits limits;
    uint64_t memory_mib = 2048;
};

// What is written must be what claque reads.
void read_back(const std::string &path, const std::string &glb)
{
    clq_context *context = nullptr;
    scenes::check(clq_context_create(nullptr, &context));
    const scenes::Own<clq_context> owner(context);
    clq_asset *made = nullptr;
    scenes::check(clq_asset_load(context, glb.data(), glb.size(), nullptr, &made),
                  path + " became a GLB that claque refuses");
    const scenes::Own<clq_asset> asset(made);
}

void convert_old(ConvertArguments a)
{
    expect_writable(a.out);
    expect_readable(a.file);
    if (!a.options.picture.empty()) expect_readable(a.options.picture, convert::most_picture_bytes);
    a.options.up = a.up.empty() ? char(0) : a.up[0];
    a.limits.memory_bytes = a.memory_mib << 20;
    const convert::Converted made = convert::convert_file(a.file, a.options, a.limits);
    read_back(a.file, made.glb);
    for (const std::string &warning : made.warnings) print_warning(a.file + ": " + warning);
    write_whole(a.out, made.glb);
}

}  // namespace

void add_convert(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<ConvertArguments>();
    CLI::App *c = app.add_subcommand("convert",
                                     "Turn an old character format (Collada, FBX, MD5, X, 3DS, OBJ, Ogre XML "
                                     "and more, by Assimp) into GLB");
    c->add_option("FILE", a->file, "The file; those that it names are looked for beside it")->required();
    c->add_option("--out,-o", a->out, "The GLB; - is standard output")->required();
    c->add_option("--up", a->up, "The axis that is up (default: what the format says, else y)")
        ->check(CLI::IsMember({"x", "y", "z"}));
    CLI::Option *unit =
        c->add_option("--unit", a->options.unit_m, "Metres in a unit of FILE (default: what the format says, else 1)")
            ->check(CLI::Range(1e-6, 1e6));
    c->add_option("--height", a->options.height_m, "Metres that the rest pose is to be high, in place of --unit")
        ->check(CLI::Range(1e-3, 1e4))
        ->excludes(unit);
    c->add_option("--picture", a->options.picture, "The picture of materials that name none, or one that is missing");
    c->add_option("--memory", a->memory_mib, "Memory limit of Assimp in MiB")
        ->capture_default_str()
        ->check(CLI::Range(64, 65536));
    c->add_option("--seconds", a->limits.seconds, "Time limit of Assimp in seconds")
        ->capture_default_str()
        ->check(CLI::Range(1, 3600));
    c->callback([a, &chosen] {
        if (is_other_format(a->out))
            throw CLI::ValidationError("--out", "'" + a->out + "' would hold a GLB, so its name must end in .glb");
        chosen = [a] { convert_old(*a); };
    });
}

}  // namespace cli
