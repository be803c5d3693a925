// Lines, fields and numbers of text files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace claque::asset
{

// Walks over the lines of a text, without line ends (LF or CRLF), after a byte order mark.
class Lines
{
public:
    explicit Lines(std::string_view text);

    bool next(std::string_view &line);
    uint32_t number() const { return number_; }  // of the line that next gave, from 1
    // Whether the line that next gave is the last one and has no line end: a file that was cut off ends like this.
    bool unfinished() const { return unfinished_; }
    // Gives the same line again.
    void back() { at_ = begin_, --number_; }

private:
    std::string_view text_;
    size_t at_ = 0, begin_ = 0;
    uint32_t number_ = 0;
    bool unfinished_ = false;
};

constexpr char blanks = 0;  // a separator: any number of blanks and tabs

// The separator of a row: semicolons before commas before blanks.
char separator_of(std::string_view line);

// The fields of a line, without blanks around them and without the quotes around a whole field. At most 256 are kept.
class Fields
{
public:
    void split(std::string_view line, char separator);
    size_t count() const { return at_.size(); }
    // Empty for a column that the line does not have.
    std::string_view operator[](int column) const
    {
        return column >= 0 && static_cast<size_t>(column) < at_.size() ? at_[static_cast<size_t>(column)]
                                                                       : std::string_view();
    }
    int find(std::string_view name) const;  // -1: there is none

private:
    std::vector<std::string_view> at_;
};

std::string_view trimmed(std::string_view text);
bool starts_with(std::string_view text, std::string_view begin);
bool contains(std::string_view text, std::string_view part);
std::string lower_case(std::string_view text);
// For a message: short, without control bytes.
std::string in_quotes(std::string_view text);

// Reads a number as C writes it, whatever the locale. False: it is none. Too large becomes infinite, too small 0.
bool read_number(std::string_view text, double &out);

// An id as people write it: 1.0000000e+00 is 1, and 00001 stays.
std::string_view plain_id(std::string_view text, char (&buffer)[32]);

}  // namespace claque::asset
