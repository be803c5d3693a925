// Numbers for things that are equal byte for byte, in order of first appearance: what welding is made of.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <unordered_map>

namespace claque::meshsplit
{

class Interner
{
public:
    void begin() { key_.clear(); }
    void add(uint32_t v) { key_.append(reinterpret_cast<const char *>(&v), sizeof v); }
    void add(float v)
    {
        v += 0.0f;  // -0 is 0
        key_.append(reinterpret_cast<const char *>(&v), sizeof v);
    }
    void add(glm::vec3 v) { add(v.x), add(v.y), add(v.z); }
    // The number, and whether it is new.
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
