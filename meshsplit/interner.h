// Numbers byte-equal keys in order of first appearance; used for welding.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include <glm/vec3.hpp>

namespace claque::meshsplit
{

inline glm::vec3 without_negative_zero(glm::vec3 v) { return v + glm::vec3(0.0f); }

class Interner
{
public:
    void begin() { key_.clear(); }
    void add(uint32_t v) { key_.append(reinterpret_cast<const char *>(&v), sizeof v); }
    void add(float v)
    {
        v += 0.0f;  // -0 becomes 0
        key_.append(reinterpret_cast<const char *>(&v), sizeof v);
    }
    void add(glm::vec3 v) { add(v.x), add(v.y), add(v.z); }
    // Returns the number, and whether it is new.
    std::pair<uint32_t, bool> number()
    {
        const auto [found, is_new] = numbers_.emplace(key_, static_cast<uint32_t>(numbers_.size()));
        return {found->second, is_new};
    }

private:
    std::string key_;
    std::unordered_map<std::string, uint32_t> numbers_;
};

}  // namespace claque::meshsplit
