// Bytes of a saved stage: one list of fields, walked in both directions. Numbers are little-endian.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "lib/stage/error.h"

namespace claque::stage
{

[[noreturn]] inline void bad_save(const char *what) { fail(CLQ_FORMAT, "the bytes are no saved stage: %s", what); }

class SaveWriter
{
public:
    static constexpr bool reads = false;
    std::vector<uint8_t> bytes;

    template <class Number>
    void number(const Number &value)
    {
        uint64_t bits = 0;
        if constexpr (std::is_floating_point_v<Number>) {
            const double wide = static_cast<double>(value);
            std::memcpy(&bits, &wide, sizeof bits);
        } else {
            bits = static_cast<uint64_t>(value);
        }
        constexpr unsigned size = std::is_floating_point_v<Number> ? 8 : sizeof(Number);
        for (unsigned i = 0; i < size; ++i) bytes.push_back(static_cast<uint8_t>(bits >> (8 * i)));
    }
    size_t count(size_t now, size_t)
    {
        number(static_cast<uint64_t>(now));
        return now;
    }
    void raw(std::string &text) { bytes.insert(bytes.end(), text.begin(), text.end()); }
    void raw(std::vector<uint8_t> &piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); }
};

class SaveReader
{
public:
    static constexpr bool reads = true;
    SaveReader(const uint8_t *bytes, size_t size) : at_(bytes), left_(size) {}

    template <class Number>
    void number(Number &value)
    {
        constexpr unsigned size = std::is_floating_point_v<Number> ? 8 : sizeof(Number);
        if (left_ < size) bad_save("they end too early");
        uint64_t bits = 0;
        for (unsigned i = 0; i < size; ++i) bits |= uint64_t(at_[i]) << (8 * i);
        at_ += size, left_ -= size;
        if constexpr (std::is_floating_point_v<Number>) {
            double wide;
            std::memcpy(&wide, &bits, sizeof wide);
            value = static_cast<Number>(wide);
        } else if constexpr (std::is_same_v<Number, bool>) {
            if (bits > 1) bad_save("a truth is neither 0 nor 1");
            value = bits != 0;
        } else {
            value = static_cast<Number>(bits);
        }
    }
    // Of things that take least_bytes each.
    size_t count(size_t, size_t least_bytes)
    {
        uint64_t found = 0;
        number(found);
        if (found > left_ / least_bytes) bad_save("a list is longer than they are");
        return static_cast<size_t>(found);
    }
    void raw(std::string &text) { take(text); }
    void raw(std::vector<uint8_t> &piece) { take(piece); }
    size_t left() const { return left_; }

private:
    template <class Container>
    void take(Container &out)
    {
        if (left_ < out.size()) bad_save("they end too early");
        for (size_t i = 0; i < out.size(); ++i) out[i] = static_cast<typename Container::value_type>(at_[i]);
        at_ += out.size(), left_ -= out.size();
    }
    const uint8_t *at_;
    size_t left_;
};

template <class Archive, class... Numbers>
void numbers(Archive &archive, Numbers &...all)
{
    (archive.number(all), ...);
}

template <class Archive, class Enum>
void number_of_enum(Archive &archive, Enum &value, Enum last)
{
    auto number = static_cast<std::underlying_type_t<Enum>>(value);
    archive.number(number);
    if (number > static_cast<std::underlying_type_t<Enum>>(last)) bad_save("a kind is unknown");
    value = static_cast<Enum>(number);
}

template <class Archive, class Element, class Body>
void list(Archive &archive, std::vector<Element> &all, size_t least_bytes, const Body &body)
{
    const size_t count = archive.count(all.size(), least_bytes);
    if constexpr (Archive::reads) all.resize(count);
    for (Element &one : all) body(one);
}

template <class Archive>
void text(Archive &archive, std::string &value)
{
    const size_t size = archive.count(value.size(), 1);
    if constexpr (Archive::reads) value.resize(size);
    archive.raw(value);
}

}  // namespace claque::stage
