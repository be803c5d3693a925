// Splits a BVH file into words, names and numbers and knows the line of each, for error messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace claque::asset
{

class BvhText
{
public:
    BvhText(const uint8_t *bytes, size_t size);

    // Throws base::Error (CLQ_FORMAT): "line 12: " followed by `what`.
    [[noreturn]] void refuse(const std::string &what) const;

    bool at_end();
    // The next word, up to a blank or a brace; a brace is a word of its own. Empty at the end of the file.
    std::string_view peek();
    std::string_view word();
    // Consumes the next word if it equals this one, ignoring case.
    bool take(std::string_view wanted);
    void expect(std::string_view wanted);
    // Expects "Frame Time:"; blanks before the colon are allowed.
    void expect_label(std::string_view first, std::string_view second);

    // The rest of the line up to a brace, without the blanks around it. Names may contain blanks.
    std::string name();
    double number(const char *what);  // finite
    uint32_t count(const char *what, uint32_t maximum);

private:
    void skip_blanks();
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

    const char *at_, *end_;
    uint32_t line_ = 1;
};

}  // namespace claque::asset
