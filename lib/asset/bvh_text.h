// Splits a BVH file into words, names and numbers and knows the line of each, for error messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace claque::asset
{

// Whether bytes begin with a byte order mark of UTF-16.
bool is_utf16(const uint8_t *bytes, size_t size);

class BvhText
{
public:
    // The text may be UTF-16 if it begins with a byte order mark.
    BvhText(const uint8_t *bytes, size_t size);
    BvhText(const BvhText &) = delete;
    BvhText &operator=(const BvhText &) = delete;

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
    bool at_comment() const;
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

    std::string decoded_;  // of UTF-16
    const char *begin_, *at_, *end_;
    uint32_t line_ = 1;
};

}  // namespace claque::asset
