#include "lib/asset/buffers.h"

#include "lib/asset/decoders.h"
#include "lib/asset/file.h"
#include "lib/asset/meshopt.h"
#include "lib/asset/uri.h"

namespace claque::asset
{

using base::big;
using base::fail;

namespace
{

constexpr uint64_t max_buffer_bytes = 1ull << 48;

}  // namespace

Buffers::Buffers(const JsonView &document, const Container &container, const LoadOptions &options, Budget &budget)
    : options_(options)
{
    const JsonView buffers = document["buffers"], views = document["bufferViews"];
    stored_.reserve(buffers.count());
    for (size_t i = 0; i < buffers.count(); ++i) load(buffers.at(i), i, container, budget);
    views_.reserve(views.count());
    for (size_t i = 0; i < views.count(); ++i) check_view(views.at(i), budget);
}

std::vector<uint8_t> Buffers::fetch(const std::string &uri, const std::string &needed_by, Budget &budget) const
{
    if (is_data_uri(uri)) {
        budget.charge(data_uri_bound(uri), needed_by.c_str());
        return decode_data_uri(uri);
    }
    const std::string path = decode_relative_path(uri);
    if (options_.base_folder.empty())
        fail(CLQ_IO, "%s needs the file '%s', and no folder was given to look in", needed_by.c_str(), path.c_str());
    const std::vector<uint8_t> bytes = read_file(options_.base_folder + "/" + path, budget.remaining());
    budget.add_input(bytes.size());
    budget.charge(bytes.size(), needed_by.c_str());
    return bytes;
}

void Buffers::load_from_uri(const JsonView &buffer, Buffer &out, Budget &budget)
{
    const std::string &uri = buffer["uri"].text();
    // The name of a data URI is as long as its data, so it is not kept a second time.
    const auto [place, is_new] =
        is_data_uri(uri) ? std::make_pair(files_.end(), true) : files_.emplace(uri, stored_.size());
    if (is_new) stored_.push_back(fetch(uri, buffer.path(), budget));
    const std::vector<uint8_t> &bytes = is_new ? stored_.back() : stored_[place->second];
    out.bytes = {bytes.data(), bytes.size()};
    if (out.bytes.size < out.length)
        fail(CLQ_FORMAT, "%s says %llu bytes, its data has %llu", buffer.path().c_str(), big(out.length),
             big(out.bytes.size));
}

void Buffers::load(const JsonView &buffer, size_t index, const Container &container, Budget &budget)
{
    buffer.object();
    Buffer out;
    out.length = buffer["byteLength"].integer(1, max_buffer_bytes);
    if (buffer["uri"].exists()) {
        load_from_uri(buffer, out, budget);
    } else if (index == 0 && container.is_glb) {
        if (!container.has_binary)
            fail(CLQ_FORMAT, "%s is the GLB's binary chunk, and there is none", buffer.path().c_str());
        if (container.binary_size < out.length)
            fail(CLQ_FORMAT, "%s says %llu bytes, the GLB's binary chunk has %zu", buffer.path().c_str(),
                 big(out.length), container.binary_size);
        if (container.binary_size - out.length > 3)
            warnings_.push_back(base::text_of("the GLB's binary chunk has %llu bytes that no buffer holds",
                                              big(container.binary_size - out.length)));
        out.bytes = {container.binary, container.binary_size};
    }
    out.bytes.size = out.length;
    buffers_.push_back(out);
}

void Buffers::check_view(const JsonView &view, Budget &budget)
{
    BufferView out;
    out.buffer = view["buffer"].index(buffers_.size(), "buffer");
    out.offset = view["byteOffset"].integer_or(0, 0, max_buffer_bytes);
    out.length = view["byteLength"].integer(1, max_buffer_bytes);
    out.stride = static_cast<uint32_t>(view["byteStride"].integer_or(0, 4, 252));
    if (out.stride % 4 != 0)
        fail(CLQ_FORMAT, "%s.byteStride is %u: not a multiple of 4", view.path().c_str(), out.stride);
    if (out.offset + out.length > buffers_[out.buffer].length)
        fail(CLQ_FORMAT, "%s ends at byte %llu of buffer %u, which has %llu", view.path().c_str(),
             big(out.offset + out.length), out.buffer, big(buffers_[out.buffer].length));
    const JsonView extensions = view["extensions"];
    out.meshopt = extensions["EXT_meshopt_compression"].exists() || extensions["KHR_meshopt_compression"].exists();
    if (has_decoder(Decoder::meshopt) && extensions["EXT_meshopt_compression"].exists())
        unpack(extensions["EXT_meshopt_compression"], out, budget);
    views_.push_back(out);
}

// The bytes count as input once they are unpacked, because what is read from them is measured by the file's size.
void Buffers::unpack(const JsonView &extension, BufferView &view, Budget &budget)
{
    const MeshoptView packed = read_meshopt_view(extension, buffers_.size(), view.length);
    const Buffer &from = buffers_[packed.buffer];
    if (packed.offset + packed.length > from.length)
        fail(CLQ_FORMAT, "%s ends at byte %llu of buffer %u, which has %llu", packed.path.c_str(),
             big(packed.offset + packed.length), packed.buffer, big(from.length));
    if (!from.bytes.data)
        fail(CLQ_UNSUPPORTED, "%s needs buffer %u, whose data the file leaves to the application: not supported",
             packed.path.c_str(), packed.buffer);
    budget.charge(view.length, packed.path.c_str());
    view.offset = 0;
    view.unpacked = static_cast<uint32_t>(unpacked_.size());
    unpacked_.push_back(decode_meshopt(packed, from.bytes.data + packed.offset));
    budget.add_input(view.length);
}

Bytes Buffers::bytes(uint32_t index, const std::string &needed_by) const
{
    const BufferView &view = views_[index];
    if (view.unpacked != 0xffffffffu) return {unpacked_[view.unpacked].data(), view.length};
    const Buffer &buffer = buffers_[view.buffer];
    if (!buffer.bytes.data && view.meshopt) refuse_without(Decoder::meshopt, needed_by);
    if (!buffer.bytes.data)
        fail(CLQ_UNSUPPORTED, "%s needs buffer %u, whose data the file leaves to the application: not supported",
             needed_by.c_str(), view.buffer);
    return {buffer.bytes.data + view.offset, view.length};
}

}  // namespace claque::asset
