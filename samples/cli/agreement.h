// Holds pictures of one frame, drawn in different ways, against each other: with one variety they are the same whatever
// is cached, to the bit; between varieties all but depth ties are. (Where surfaces cross, two of them may have the same
// depth in a pixel to the last bit of the depth buffer. The one that is drawn later is seen there, and varieties draw in
// different order.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cli
{

class Agreement
{
public:
    // `what` names the frame in sentences.
    void begin(const std::string &what);
    // Throws scenes::Failure where this picture is not that of the frame. rgb: three bytes a pixel.
    void check(const std::vector<uint8_t> &rgb, const std::string &cache, const std::string &strategy);

    const std::string &hash() const { return first_; }  // of the frame's first picture
    size_t max_ties() const { return max_ties_; }       // of one picture so far, in pixels

private:
    std::string what_, first_;
    std::vector<uint8_t> reference_;
    std::map<std::string, std::string> hashes_;  // by variety
    size_t max_ties_ = 0;
};

}  // namespace cli
