// A scene whose people are of social classes (S2 5.3).
#pragma once

#include <cstddef>
#include <string>

namespace scenes
{

class SocialClasses
{
public:
    virtual ~SocialClasses() = default;
    // The class name of number `who` of Scene::actors().
    virtual std::string class_of(size_t who) const = 0;
};

}  // namespace scenes
