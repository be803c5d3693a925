#include "samples/cost/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace cost
{
namespace
{

constexpr size_t page_width = 116;

bool is_number(const Cell &cell) { return std::holds_alternative<Figure>(cell); }

std::string text_of(const Cell &cell)
{
    return is_number(cell) ? text_of(std::get<Figure>(cell)) : std::get<std::string>(cell);
}

// Aligns numbers to the right and words to the left, by the column's contents.
bool to_the_right(const Table &table, size_t column)
{
    return std::any_of(table.rows.begin(), table.rows.end(),
                       [&](const std::vector<Cell> &row) { return is_number(row[column]); });
}

std::string padded(const std::string &text, size_t width, bool right)
{
    const std::string room(width - std::min(width, text.size()), ' ');
    return right ? room + text : text + room;
}

// A line does not break within a number.
bool may_break(const std::string &text, size_t at)
{
    const auto digit = [&](size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    return text[at] == ' ' && !(at > 0 && digit(at - 1) && digit(at + 1));
}

// Lines of at most `width` characters, all but the first indented.
std::string broken(const std::string &text, size_t width, const std::string &indent)
{
    std::string lines;
    size_t at = 0;
    while (text.size() - at > width) {
        size_t cut = at + width;
        while (cut > at && !may_break(text, cut)) --cut;
        if (cut == at)  // a word longer than the line
            for (cut = at + width; cut < text.size() && !may_break(text, cut);) ++cut;
        lines += text.substr(at, cut - at) + "\n" + indent;
        at = std::min(cut + 1, text.size());
    }
    return lines + text.substr(at);
}

std::string escaped(std::string text)
{
    for (size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

}  // namespace

std::string text_of(const Figure &figure)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", figure.digits, figure.value);
    std::string grouped = text;
    size_t end = grouped.find('.');
    if (end == std::string::npos) end = grouped.size();
    const size_t first = grouped[0] == '-' ? 1 : 0;
    for (size_t at = end; at > first + 3;) grouped.insert(at -= 3, " ");
    return grouped;
}

Figure figure(double value)
{
    for (int digits = 0; digits < 2; ++digits) {
        const double scaled = value * (digits == 0 ? 1 : 10);
        if (std::abs(scaled - std::round(scaled)) < 1e-9 * std::max(1.0, std::abs(scaled))) return {value, digits};
    }
    return {value, 2};
}

std::string wrapped(const std::string &text, size_t width, const std::string &indent)
{
    return broken(text, width - indent.size(), indent);
}

std::string text_of(const Table &table)
{
    std::vector<size_t> widths;
    for (size_t c = 0; c < table.columns.size(); ++c) {
        size_t width = table.columns[c].size();
        for (const auto &row : table.rows) width = std::max(width, text_of(row[c]).size());
        widths.push_back(width);
    }
    std::string text = table.title + "\n";
    const auto line = [&](const auto &cell_text) {
        std::string one;
        for (size_t c = 0; c < widths.size(); ++c) {
            one += c == 0 ? "  " : "   ";
            const size_t room = std::max<size_t>(page_width, one.size() + 30) - one.size();
            if (c + 1 < widths.size() || widths[c] <= room)
                one += padded(cell_text(c), widths[c], to_the_right(table, c));
            else one += broken(cell_text(c), room, std::string(one.size(), ' '));
        }
        text += one.substr(0, one.find_last_not_of(' ') + 1) + "\n";
    };
    line([&](size_t c) { return table.columns[c]; });
    for (const auto &row : table.rows) line([&](size_t c) { return text_of(row[c]); });
    for (const std::string &note : table.notes) text += "  " + wrapped(note, page_width, "  ") + "\n";
    return text;
}

std::string markdown_of(const Table &table)
{
    std::string text = "**" + table.title + "**\n\n|", rule = "|";
    for (size_t c = 0; c < table.columns.size(); ++c) {
        text += " " + escaped(table.columns[c]) + " |";
        rule += to_the_right(table, c) ? "---:|" : "---|";
    }
    text += "\n" + rule + "\n";
    for (const auto &row : table.rows) {
        text += "|";
        for (const Cell &cell : row) text += " " + escaped(text_of(cell)) + " |";
        text += "\n";
    }
    for (const std::string &note : table.notes) text += "\n" + note + "\n";
    return text;
}

nlohmann::ordered_json json_of(const Table &table)
{
    nlohmann::ordered_json json = {{"title", table.title}, {"columns", table.columns}, {"rows", nullptr}};
    json["rows"] = nlohmann::ordered_json::array();
    for (const auto &row : table.rows) {
        nlohmann::ordered_json cells = nlohmann::ordered_json::array();
        for (const Cell &cell : row)
            if (is_number(cell)) cells.push_back(std::get<Figure>(cell).value);
            else cells.push_back(std::get<std::string>(cell));
        json["rows"].push_back(cells);
    }
    json["notes"] = table.notes;
    return json;
}

}  // namespace cost
