// Colour maps as TOML files.
#include <claque/colour_files.h>

#include "lib/api/assets/assets_helpers.h"
#include "lib/api/boundary.h"
#include "lib/asset/colour_file.h"
#include "lib/asset/file.h"

using namespace claque;

namespace
{

constexpr uint64_t most_file_bytes = uint64_t(4) << 20;

void load(clq_context *context, std::string_view text, const std::string &name, clq_colour_map **out)
{
    asset::ColourFile file;
    asset::read_colours(text, name, file);
    api::pass_on(clq_colour_map_create(context, &file.def, out));
}

}  // namespace

extern "C" {

clq_status clq_colour_map_load(clq_context *context, const void *bytes, size_t size_bytes, const char *name,
                               clq_colour_map **out)
{
    return api::boundary("clq_colour_map_load", [&] {
        api::require(context && out && (bytes || size_bytes == 0), "context, bytes or out is NULL");
        load(context, {static_cast<const char *>(bytes), size_bytes}, name ? name : "the colour map", out);
    });
}

clq_status clq_colour_map_load_file(clq_context *context, const char *path, clq_colour_map **out)
{
    return api::boundary("clq_colour_map_load_file", [&] {
        api::require(context && path && out, "context, path or out is NULL");
        const std::vector<uint8_t> bytes = asset::read_file(path, most_file_bytes);
        load(context, {reinterpret_cast<const char *>(bytes.data()), bytes.size()}, path, out);
    });
}

clq_status clq_colour_map_save(const clq_colour_map *map, clq_write_function write, void *user)
{
    return api::boundary("clq_colour_map_save", [&] {
        api::require(map && write, "map or write is NULL");
        clq_colour_map_def def = clq_colour_map_def_init();
        api::pass_on(clq_colour_map_get_def(map, &def));
        const std::string text = asset::colours_text(def);
        if (!api::host_takes(write, user, text.data(), text.size()))
            base::fail(CLQ_IO, "the writer refused the %zu bytes of a colour map", text.size());
    });
}

}  // extern "C"
