// Archives: numbers as little-endian bytes and back, for the files that the library writes itself. Writer and reader
// have the same members, so one function with the archive as template parameter holds the fields of both directions:
// value() for numbers, flag() for booleans, text(), and array() and rows(), which take the smallest size of an element
// in bytes. `Count` is the type in which a file holds lengths.
#pragma once

#include <cstring>
#include <memory_resource>
#include <type_traits>
#include <vector>

#include "lib/base/error.h"
#include "lib/base/hash.h"

namespace claque::base
{

// The unsigned integer type with the size of T, which holds its bits.
template <class T>
using Bits = std::conditional_t<
    sizeof(T) == 1, uint8_t,
    std::conditional_t<sizeof(T) == 2, uint16_t, std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>>>;

class Sink
{
public:
    virtual ~Sink() = default;
    virtual void take(const uint8_t *bytes, size_t count) = 0;  // in order; an exception ends the writing
};

class ArraySink : public Sink
{
public:
    explicit ArraySink(std::pmr::vector<uint8_t> &out) : out_(out) {}
    void take(const uint8_t *bytes, size_t count) override { out_.insert(out_.end(), bytes, bytes + count); }

private:
    std::pmr::vector<uint8_t> &out_;
};

// Computes the size and the hash of its input without storing it.
class HashingSink : public Sink
{
public:
    void take(const uint8_t *bytes, size_t count) override
    {
        hash = fnv(hash, bytes, count);
        size += count;
    }
    uint64_t hash = fnv_start, size = 0;
};

template <class Count = uint32_t>
class ArchiveWriter
{
public:
    explicit ArchiveWriter(Sink &sink) : sink_(sink) {}  // end with flush()
    ArchiveWriter(const ArchiveWriter &) = delete;
    ArchiveWriter &operator=(const ArchiveWriter &) = delete;

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
    void count(size_t n) { value(static_cast<Count>(n)); }
    template <class S>
    void text(const S &s)
    {
        array(s, 1, [&](char c) { value(c); });
    }
    template <class A, class Element>
    void array(const A &values, Count, const Element &element)
    {
        count(values.size());
        for (const auto &v : values) element(v);
    }
    template <class A, class Element>
    void rows(const A &values, Count smallest, const Element &element)
    {
        array(values, smallest, element);
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

// The bytes may have any content. `subject` names them in messages: "a saved track".
template <class Count = uint32_t>
class ArchiveReader
{
public:
    ArchiveReader(const char *subject, const uint8_t *bytes, size_t size) : subject_(subject), at_(bytes), left_(size)
    {
    }

    template <class T>
    void value(T &v)
    {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "numbers go one by one");
        if (left_ < sizeof v) fail(CLQ_FORMAT, "%s ends %zu bytes too early", subject_, sizeof v - left_);
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
        if (byte > 1) fail(CLQ_FORMAT, "%s holds %u where yes or no is due", subject_, byte);
        v = byte == 1;
    }
    // A count of elements; fails if the remaining bytes cannot hold that many.
    Count count(Count smallest)
    {
        Count n = 0;
        value(n);
        if (n > left_ / smallest) fail(CLQ_FORMAT, "%s announces %llu elements in %zu bytes", subject_, big(n), left_);
        return n;
    }
    template <class S>
    void text(S &s)
    {
        const size_t size = count(1);
        s.assign(reinterpret_cast<const char *>(at_), size);
        at_ += size, left_ -= size;
    }
    template <class A, class Element>
    void array(A &values, Count smallest, const Element &element)
    {
        values.resize(count(smallest));
        for (auto &v : values) element(v);
    }
    // For elements that are constructed with the array's memory resource.
    template <class A, class Element>
    void rows(A &values, Count smallest, const Element &element)
    {
        const size_t size = count(smallest);
        values.reserve(size);
        for (size_t i = 0; i < size; ++i) {
            values.emplace_back(values.get_allocator().resource());
            element(values.back());
        }
    }
    size_t left() const { return left_; }
    void end() const  // call it after the last field
    {
        if (left_ != 0) fail(CLQ_FORMAT, "%s has %zu bytes too many", subject_, left_);
    }

private:
    const char *subject_;
    const uint8_t *at_;
    size_t left_;
};

}  // namespace claque::base
