// Archives that turn a saved crowd's fields into bytes and back. Both have value() for numbers, flag() for booleans,
// and array(), which takes the smallest size of an element in bytes.
#pragma once

#include <cstring>
#include <type_traits>

#include "lib/base/error.h"
#include "lib/base/hash.h"
#include "lib/crowd/save.h"

namespace claque::crowd
{

// The unsigned integer type with the size of T, which holds its bits.
template <class T>
using Bits = std::conditional_t<
    sizeof(T) == 1, uint8_t,
    std::conditional_t<sizeof(T) == 2, uint16_t, std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>>>;

class Writer
{
public:
    explicit Writer(Sink &sink) : sink_(sink) {}  // end with flush()
    Writer(const Writer &) = delete;
    Writer &operator=(const Writer &) = delete;

    template <class T>
    void value(const T &v)
    {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "numbers go one by one");
        Bits<T> bits;
        std::memcpy(&bits, &v, sizeof bits);
        if (used_ + sizeof bits > sizeof buffer_) flush();
        for (size_t i = 0; i < sizeof bits; ++i) buffer_[used_++] = static_cast<uint8_t>(uint64_t(bits) >> (8 * i));
    }
    void flag(bool v) { value(static_cast<uint8_t>(v)); }
    void count(size_t n) { value(static_cast<uint32_t>(n)); }
    template <class A, class Element>
    void array(const A &values, uint32_t, const Element &element)
    {
        count(values.size());
        for (const auto &v : values) element(v);
    }
    void flush()
    {
        sink_.take(buffer_, used_);
        used_ = 0;
    }

private:
    Sink &sink_;
    size_t used_ = 0;
    uint8_t buffer_[1024] = {};
};

// Computes the size and the hash of its input without storing it.
class HashingSink : public Sink
{
public:
    void take(const uint8_t *bytes, size_t count) override
    {
        hash = base::fnv(hash, bytes, count);
        size += count;
    }
    uint64_t hash = base::fnv_start, size = 0;
};

class Reader
{
public:
    Reader(const uint8_t *bytes, size_t size) : at_(bytes), left_(size) {}

    template <class T>
    void value(T &v)
    {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "numbers go one by one");
        if (left_ < sizeof v) base::fail(CLQ_FORMAT, "a saved crowd ends %zu bytes too early", sizeof v - left_);
        uint64_t bits = 0;
        for (size_t i = 0; i < sizeof v; ++i) bits |= uint64_t(at_[i]) << (8 * i);
        const Bits<T> narrow = static_cast<Bits<T>>(bits);
        std::memcpy(&v, &narrow, sizeof v);
        at_ += sizeof v, left_ -= sizeof v;
    }
    void flag(bool &v)
    {
        uint8_t byte = 0;
        value(byte);
        if (byte > 1) base::fail(CLQ_FORMAT, "a saved crowd holds %u where yes or no is due", byte);
        v = byte == 1;
    }
    // A count of elements; fails if the remaining bytes cannot hold that many.
    uint32_t count(uint32_t smallest)
    {
        uint32_t n = 0;
        value(n);
        if (n > left_ / smallest) base::fail(CLQ_FORMAT, "a saved crowd announces %u elements in %zu bytes", n, left_);
        return n;
    }
    template <class A, class Element>
    void array(A &values, uint32_t smallest, const Element &element)
    {
        values.resize(count(smallest));
        for (auto &v : values) element(v);
    }
    size_t left() const { return left_; }

private:
    const uint8_t *at_;
    size_t left_;
};

}  // namespace claque::crowd
