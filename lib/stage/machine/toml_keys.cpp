#include "lib/stage/machine/toml_keys.h"

namespace claque::stage
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

}  // namespace

uint32_t line_of_deep_key(std::string_view text)
{
    uint32_t line = 1, parts = 1;
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
        if (c == '.' && ++parts > max_key_parts) return line;
        if (c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}' || c == '\n') parts = 1;
        line += c == '\n';
        ++i;
    }
    return 0;
}

}  // namespace claque::stage
