#include "lib/asset/gltf_image.h"

#include "lib/asset/image.h"
#include "lib/asset/uri.h"

namespace claque::asset
{

using base::fail;

namespace
{

std::string name_of(const JsonView &view)
{
    std::string name = view["name"].text_or("");
    return name.empty() ? view.path() : name;
}

model::Image decode(File &file, const JsonView &view, const uint8_t *bytes, uint64_t size)
{
    ImageLimits limits;
    limits.max_px = file.options.max_image_px;
    limits.max_bytes = file.budget.remaining();
    model::Image image = decode_image(bytes, size, name_of(view), limits);
    file.budget.charge_image(image.rgba.size(), view.path().c_str());
    // Images may share bytes: those beyond all that was read bring nothing new, and count like geometry.
    if (file.budget.take_encoded(size)) file.budget.add_pixels(image.rgba.size());
    else file.budget.charge(image.rgba.size(), view.path().c_str());
    return image;
}

// Without a folder to look in, it is the host that has to act.
bool may_be_missing(const File &file, const std::string &uri)
{
    return !file.options.strict && !file.options.base_folder.empty() && !is_data_uri(uri);
}

}  // namespace

std::optional<model::Image> read_image(File &file, uint32_t index)
{
    const JsonView view = file.root["images"].at(index);
    if (view["bufferView"].exists()) {
        const uint32_t buffer_view = view["bufferView"].index(file.buffers.view_count(), "buffer view");
        const Bytes bytes = file.buffers.bytes(buffer_view, view.path());
        return decode(file, view, bytes.data, bytes.size);
    }
    const std::string &uri = view["uri"].text();
    std::vector<uint8_t> bytes;
    try {
        bytes = file.buffers.fetch(uri, view.path(), file.budget);
    } catch (const base::Error &error) {
        if (error.status() != CLQ_IO || !may_be_missing(file, uri)) throw;
        file.warn(base::text_of("the picture %s is missing, its materials show their base colour: %s",
                                view.path().c_str(), error.what()));
        return std::nullopt;
    }
    return decode(file, view, bytes.data(), bytes.size());
}

}  // namespace claque::asset
