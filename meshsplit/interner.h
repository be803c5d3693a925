// Numbers byte-equal keys in order of first appearance; used for welding. Keys lie one after the other in one array:
// models with millions of vertices are welded.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace claque::meshsplit
{

inline glm::vec3 without_negative_zero(glm::vec3 v) { return v + glm::vec3(0.0f); }

class Interner
{
public:
    void begin() { bytes_.resize(ends_.back()); }
    void add(uint32_t v) { append(&v); }
    void add(float v)
    {
        v += 0.0f;  // -0 becomes 0
        append(&v);
    }
    void add(glm::vec3 v) { add(v.x), add(v.y), add(v.z); }
    // Returns the number, and whether it is new.
    std::pair<uint32_t, bool> number()
    {
        if (2 * ends_.size() > places_.size()) grow();
        const std::string_view key(bytes_.data() + ends_.back(), bytes_.size() - ends_.back());
        size_t at = place_of(key);
        for (; places_[at] != empty; at = (at + 1) & (places_.size() - 1))
            if (key_of(places_[at]) == key) return {places_[at], false};
        places_[at] = static_cast<uint32_t>(ends_.size() - 1);
        ends_.push_back(bytes_.size());
        return {places_[at], true};
    }

private:
    static constexpr uint32_t empty = 0xffffffffu;

    template <class T>
    void append(const T *v)
    {
        const size_t end = bytes_.size();
        bytes_.resize(end + sizeof *v);
        std::memcpy(bytes_.data() + end, v, sizeof *v);
    }
    std::string_view key_of(uint32_t number) const
    {
        return {bytes_.data() + ends_[number], ends_[number + 1] - ends_[number]};
    }
    size_t place_of(std::string_view key) const { return std::hash<std::string_view>()(key) & (places_.size() - 1); }

    // At most half of the places are taken.
    void grow()
    {
        places_.assign(places_.empty() ? 64 : 2 * places_.size(), empty);
        for (uint32_t i = 0; i + 1 < ends_.size(); ++i) {
            size_t at = place_of(key_of(i));
            while (places_[at] != empty) at = (at + 1) & (places_.size() - 1);
            places_[at] = i;
        }
    }

    std::vector<char> bytes_;         // all keys, and the one that is being added
    std::vector<size_t> ends_ = {0};  // of the keys; the first begins at 0
    std::vector<uint32_t> places_;    // a hash table of numbers
};

}  // namespace claque::meshsplit
