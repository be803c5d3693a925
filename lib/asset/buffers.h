// A file's buffers and the views into them: where bytes come from, and which bytes may be read.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "lib/asset/budget.h"
#include "lib/asset/glb.h"
#include "lib/asset/gltf.h"
#include "lib/asset/json_view.h"

namespace claque::asset
{

struct Bytes {
    const uint8_t *data = nullptr;
    uint64_t size = 0;
};

struct BufferView {
    uint32_t buffer = 0;
    uint64_t offset = 0, length = 0;
    uint32_t stride = 0;              // 0: elements are contiguous
    bool meshopt = false;             // its bytes are compressed and its buffer may be a placeholder without bytes
    uint32_t unpacked = 0xffffffffu;  // index of its unpacked bytes, where they were compressed and a decoder is there
};

// The constructor reads all buffers that have data and checks all views against them. Every function throws
// base::Error.
class Buffers
{
public:
    Buffers(const JsonView &document, const Container &container, const LoadOptions &options, Budget &budget);

    size_t view_count() const { return views_.size(); }
    const BufferView &view(uint32_t index) const { return views_[index]; }

    bool has_data(uint32_t view) const
    {
        return views_[view].unpacked != 0xffffffffu || buffers_[views_[view].buffer].bytes.data != nullptr;
    }

    // The bytes of a view. Throws if its buffer has no data. `needed_by` names the reader in messages.
    Bytes bytes(uint32_t view, const std::string &needed_by) const;

    // Reads the bytes of a URI; they are charged to `budget`.
    std::vector<uint8_t> fetch(const std::string &uri, const std::string &needed_by, Budget &budget) const;

private:
    struct Buffer {
        uint64_t length = 0;  // as declared
        Bytes bytes;          // data null: the file has none
    };

    void load(const JsonView &buffer, size_t index, const Container &container, Budget &budget);
    void load_from_uri(const JsonView &buffer, Buffer &out, Budget &budget);
    void check_view(const JsonView &view, Budget &budget);
    void unpack(const JsonView &extension, BufferView &view, Budget &budget);

    const LoadOptions &options_;
    std::vector<Buffer> buffers_;
    std::vector<std::vector<uint8_t>> stored_;       // never moved: buffers refer to the bytes
    std::unordered_map<std::string, size_t> files_;  // by URI, so that each is read once
    std::vector<BufferView> views_;
    std::vector<std::vector<uint8_t>> unpacked_;  // of views that meshopt compressed
    std::vector<std::string> warnings_;

public:
    const std::vector<std::string> &warnings() const { return warnings_; }
};

}  // namespace claque::asset
