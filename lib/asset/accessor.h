// Accessors: typed rows of numbers in buffer views. The ranges of all accessors are checked once, in 64 bits, when the
// file is opened. Reading then checks values only.
#pragma once

#include <map>
#include <vector>

#include "lib/asset/buffers.h"

namespace claque::asset
{

enum class Component : uint16_t { unknown = 0, i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

struct Sparse {
    uint32_t count = 0;
    uint32_t index_view = 0, value_view = 0;
    uint64_t index_offset = 0, value_offset = 0;
    Component index_type = Component::u16;
};

struct Accessor {
    std::string path;             // position in the file, for messages
    uint32_t view = 0xffffffffu;  // none: zeros
    uint64_t offset = 0;
    uint32_t count = 0;
    Component component = Component::unknown;
    uint32_t width = 0;    // components per element: 1 to 4, 9 or 16; 0 for an unknown type
    uint32_t columns = 1;  // columns of a matrix; each starts at a multiple of 4 bytes
    bool normalized = false;
    Sparse sparse;
};

class Accessors
{
public:
    Accessors(const JsonView &document, const Buffers &buffers, Budget &budget);

    size_t count() const { return accessors_.size(); }
    const Accessor &at(uint32_t index) const { return accessors_[index]; }

    // True if all bytes that this accessor reads came with the file. A buffer may be a placeholder without bytes.
    bool has_data(uint32_t index) const;

    // Until the next call, accessors are read from these bytes instead of the file: packed elements, by index. Their
    // sizes have been checked.
    using Supplied = std::map<uint32_t, std::vector<uint8_t>>;
    void supply(Supplied bytes) { supplied_ = std::move(bytes); }

    // The index of an accessor in the file. Throws if it is out of range.
    uint32_t reference(const JsonView &view) const { return view.index(accessors_.size(), "accessor"); }

    // All components in a row as finite floats; normalised integers are mapped to [0, 1] or [-1, 1]. Throws unless
    // elements have `width` components. `needed_by` names the reader in messages.
    std::vector<float> floats(uint32_t index, uint32_t width, const std::string &needed_by) const;
    // The same, not all of them finite.
    std::vector<float> any_floats(uint32_t index, uint32_t width, const std::string &needed_by) const;

    // Unsigned integers, not normalised.
    std::vector<uint32_t> integers(uint32_t index, uint32_t width, const std::string &needed_by) const;

private:
    void parse(const JsonView &accessor);
    void parse_sparse(const JsonView &sparse, Accessor &out) const;
    // The layout of elements. The last element ends after `bytes`; earlier matrices may have padded columns.
    struct Row {
        uint64_t count, bytes, stride, unit;
    };
    static Row row_of(const Accessor &accessor, uint64_t count);
    void check_range(const Accessor &accessor, uint32_t view, uint64_t offset, const Row &row, const char *what) const;
    const Accessor &wanted(uint32_t index, uint32_t width, const std::string &needed_by) const;
    template <class Out, class Read>
    std::vector<Out> decode(const Accessor &accessor, const std::string &needed_by, const Read &read) const;

    const Buffers &buffers_;
    Budget &budget_;
    std::vector<Accessor> accessors_;
    Supplied supplied_;
};

uint32_t bytes_of(Component component);  // 0 for unknown

}  // namespace claque::asset
