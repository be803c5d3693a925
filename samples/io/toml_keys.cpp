#include "samples/io/toml_keys.h"

namespace io
{

namespace
{

// The end of the string that begins at `at`; strings of three quotes may have several lines.
size_t end_of_string(std::string_view text, size_t at)
{
    const char quote = text[at];
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool is_long = text.substr(at, 3) == three;
    for (at += is_long ? 3 : 1; at < text.size(); ++at) {
        if (quote == '"' && text[at] == '\\') ++at;
        else if (is_long ? text.substr(at, 3) == three : text[at] == quote) return at + (is_long ? 3 : 1);
        else if (!is_long && text[at] == '\n') return at;  // wrong syntax
    }
    return text.size();
}

// The number of the line with the first byte outside of strings and comments that `stops(byte)` says; 0: there is none.
template <class Stops>
uint32_t line_of(std::string_view text, Stops stops)
{
    uint32_t line = 1;
    for (size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            const size_t end = end_of_string(text, i);
            for (; i < end; ++i) line += text[i] == '\n';
            continue;
        }
        if (c == '#') {
            while (i < text.size() && text[i] != '\n') ++i;
            continue;
        }
        if (stops(c)) return line;
        line += c == '\n';
        ++i;
    }
    return 0;
}

}  // namespace

uint32_t line_of_deep_key(std::string_view text)
{
    uint32_t parts = 1;
    return line_of(text, [&parts](char c) {
        if (c == '.') return ++parts > max_key_parts;
        if (c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}' || c == '\n') parts = 1;
        return false;
    });
}

uint32_t line_of_stray_letter(std::string_view text)
{
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.substr(0, mark.size()) == mark) text.remove_prefix(mark.size());
    return line_of(text, [](char c) { return (c & 0x80) != 0; });
}

uint32_t line_of_table_too_many(std::string_view text)
{
    uint32_t tables = 0, lists = 0;
    bool begins = true;  // the line
    return line_of(text, [&](char c) {
        if (c == '{' || (c == '[' && begins && lists == 0)) ++tables;
        if (c == '[') ++lists;
        if (c == ']' && lists > 0) --lists;
        begins = c == '\n' || (begins && (c == ' ' || c == '\t' || c == '\r'));
        return tables > max_tables;
    });
}

}  // namespace io
