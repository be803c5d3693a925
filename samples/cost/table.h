// Tables of words and numbers, written for a terminal, for a README or as JSON.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace cost
{

// Shown with this many digits after the point, in groups of three before it.
struct Figure {
    double value;
    int digits = 0;
};
using Cell = std::variant<std::string, Figure>;

struct Table {
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
    std::vector<std::string> notes;
};

std::string text_of(const Figure &figure);
// With the digits it needs, at most two.
Figure figure(double value);

std::string text_of(const Table &table);
std::string markdown_of(const Table &table);
nlohmann::ordered_json json_of(const Table &table);

// `text` in lines of at most `width` characters, all but the first indented.
std::string wrapped(const std::string &text, size_t width, const std::string &indent);

}  // namespace cost
