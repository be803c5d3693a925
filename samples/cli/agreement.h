// Compares pictures of one frame that were drawn in different ways. With one draw strategy all caches give the same
// picture, bit for bit. Between strategies only depth ties may differ: where surfaces intersect, two of them may have
// exactly the same depth in a pixel; the later one is visible, and strategies draw in different orders.
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
    // `what` names the frame in error messages.
    void begin(const std::string &what);
    // Throws scenes::Failure if this picture is not that of the frame. rgb: three bytes a pixel.
    void check(const std::vector<uint8_t> &rgb, const std::string &cache, const std::string &strategy);

    const std::string &hash() const { return first_; }  // of the frame's first picture
    size_t max_ties() const { return max_ties_; }       // maximum of one picture so far, in pixels

private:
    std::string what_, first_;
    std::vector<uint8_t> reference_;
    std::map<std::string, std::string> hashes_;  // by draw strategy
    size_t max_ties_ = 0;
};

}  // namespace cli
