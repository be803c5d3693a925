// Reads accessors: converts bytes to numbers and applies sparse values.
#include <cmath>
#include <cstring>

#include "lib/asset/accessor.h"

namespace claque::asset
{

using base::fail;

namespace
{

template <class T>
T raw(const uint8_t *p)
{
    T value;
    std::memcpy(&value, p, sizeof value);
    return value;
}

uint32_t unsigned_at(Component type, const uint8_t *p)
{
    if (type == Component::u8) return *p;
    if (type == Component::u16) return raw<uint16_t>(p);
    return raw<uint32_t>(p);
}

float float_at(const Accessor &a, const uint8_t *p)
{
    switch (a.component) {
        case Component::i8: {
            const float x = static_cast<float>(raw<int8_t>(p));
            return a.normalized ? std::fmax(x / 127.0f, -1.0f) : x;
        }
        case Component::u8:
            return a.normalized ? static_cast<float>(*p) / 255.0f : static_cast<float>(*p);
        case Component::i16: {
            const float x = static_cast<float>(raw<int16_t>(p));
            return a.normalized ? std::fmax(x / 32767.0f, -1.0f) : x;
        }
        case Component::u16: {
            const float x = static_cast<float>(raw<uint16_t>(p));
            return a.normalized ? x / 65535.0f : x;
        }
        case Component::u32:
            return static_cast<float>(raw<uint32_t>(p));
        default:
            return raw<float>(p);
    }
}

}  // namespace

template <class Out, class Read>
std::vector<Out> Accessors::decode(const Accessor &a, const std::string &needed_by, const Read &read) const
{
    budget_.charge(uint64_t(a.count) * a.width * sizeof(Out), needed_by.c_str());
    std::vector<Out> out(size_t(a.count) * a.width);
    const uint64_t size = bytes_of(a.component);
    const uint64_t element = size * a.width;  // only 4 x 4 matrices are read; their columns have no padding
    const auto copy = [&](const uint8_t *from, size_t to) {
        for (uint32_t k = 0; k < a.width; ++k) out[to * a.width + k] = read(from + k * size);
    };
    const auto supplied = supplied_.find(static_cast<uint32_t>(&a - accessors_.data()));
    if (supplied != supplied_.end()) {
        for (uint32_t i = 0; i < a.count; ++i) copy(supplied->second.data() + i * element, i);
        return out;
    }
    if (a.view != 0xffffffffu) {
        const uint8_t *first = buffers_.bytes(a.view, needed_by).data + a.offset;
        const uint64_t stride = buffers_.view(a.view).stride ? buffers_.view(a.view).stride : element;
        for (uint32_t i = 0; i < a.count; ++i) copy(first + i * stride, i);
    }
    if (a.sparse.count) {
        const uint8_t *indices = buffers_.bytes(a.sparse.index_view, needed_by).data + a.sparse.index_offset;
        const uint8_t *values = buffers_.bytes(a.sparse.value_view, needed_by).data + a.sparse.value_offset;
        uint64_t next = 0;
        for (uint32_t i = 0; i < a.sparse.count; ++i) {
            const uint32_t at = unsigned_at(a.sparse.index_type, indices + i * bytes_of(a.sparse.index_type));
            if (at >= a.count || at < next)
                fail(CLQ_FORMAT, "%s: sparse index %u (number %u) is out of order or beyond %u", a.path.c_str(), at, i,
                     a.count);
            next = uint64_t(at) + 1;
            copy(values + i * element, at);
        }
    }
    return out;
}

std::vector<float> Accessors::any_floats(uint32_t index, uint32_t width, const std::string &needed_by) const
{
    const Accessor &a = wanted(index, width, needed_by);
    return decode<float>(a, needed_by, [&](const uint8_t *p) { return float_at(a, p); });
}

std::vector<float> Accessors::floats(uint32_t index, uint32_t width, const std::string &needed_by) const
{
    std::vector<float> out = any_floats(index, width, needed_by);
    for (size_t i = 0; i < out.size(); ++i)
        if (!std::isfinite(out[i]))
            fail(CLQ_FORMAT, "%s: element %zu of %s is not finite", needed_by.c_str(), i / width,
                 at(index).path.c_str());
    return out;
}

std::vector<uint32_t> Accessors::integers(uint32_t index, uint32_t width, const std::string &needed_by) const
{
    const Accessor &a = wanted(index, width, needed_by);
    if ((a.component != Component::u8 && a.component != Component::u16 && a.component != Component::u32) ||
        a.normalized)
        fail(CLQ_FORMAT, "%s needs unsigned integers: %s has others", needed_by.c_str(), a.path.c_str());
    return decode<uint32_t>(a, needed_by, [&](const uint8_t *p) { return unsigned_at(a.component, p); });
}

}  // namespace claque::asset
