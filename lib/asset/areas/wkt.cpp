// Well-known text: POLYGON, MULTIPOLYGON, GEOMETRYCOLLECTION of these, EMPTY. Heights are passed over.
#include <charconv>
#include <cmath>

#include "lib/asset/areas/area_readers.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr uint32_t deepest_collection = 128;

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

class WktReader
{
public:
    WktReader(std::string_view text, AreaBuilder &out) : text_(text), out_(out) {}

    void read()
    {
        geometry(0);
        blanks();
        if (at_ < text_.size()) refuse("nothing");
    }

private:
    void blanks()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || (text_[at_] >= '\t' && text_[at_] <= '\r'))) ++at_;
    }

    [[noreturn]] void refuse(const char *wanted)
    {
        std::string found;
        for (const char c : text_.substr(at_, 20)) found += c >= ' ' && c < 127 ? c : '?';
        fail(CLQ_FORMAT, "byte %zu of the WKT: %s is wanted instead of %s", at_ + 1, wanted,
             found.empty() ? "its end" : ("'" + found + "'").c_str());
    }

    std::string word()
    {
        blanks();
        std::string out;
        while (at_ < text_.size() && out.size() < 40 && upper(text_[at_]) >= 'A' && upper(text_[at_]) <= 'Z')
            out += upper(text_[at_++]);
        return out;
    }

    bool take(char c)
    {
        blanks();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    // EMPTY, or an opening bracket; Z, M and ZM may stand before them.
    bool opens()
    {
        const size_t before = at_;
        std::string next = word();
        if (next == "Z" || next == "M" || next == "ZM") next = word();
        if (next == "EMPTY") return false;
        if (!next.empty()) at_ = before;
        if (!take('(')) refuse("( or EMPTY");
        return true;
    }

    // Items with commas between, up to the closing bracket.
    template <class Item>
    void list(const Item &item)
    {
        do item();
        while (take(','));
        if (!take(')')) refuse(", or )");
    }

    double number()
    {
        blanks();
        double value = 0;
        const char *const begin = text_.data() + at_, *const end = text_.data() + text_.size();
        const auto [rest, error] = std::from_chars(begin, end, value);
        if (error != std::errc() || !(std::fabs(value) <= 1e9)) refuse("a number up to 1e9");
        at_ += static_cast<size_t>(rest - begin);
        return value;
    }

    bool number_follows()
    {
        blanks();
        const char c = at_ < text_.size() ? text_[at_] : '\0';
        return c == '-' || c == '.' || (c >= '0' && c <= '9');
    }

    Point point()
    {
        Point out;
        out.x = number(), out.y = number();
        for (int more = 0; more < 2 && number_follows(); ++more) (void)number();
        return out;
    }

    void polygon()
    {
        if (!opens()) return;
        std::vector<Ring> rings;
        list([&] {
            if (!take('(')) refuse("(");
            rings.emplace_back();
            list([&] { rings.back().push_back(point()); });
        });
        out_.add_polygon(rings);
    }

    void geometry(uint32_t depth)
    {
        if (depth > deepest_collection)
            fail(CLQ_LIMIT, "the WKT has more than %u collections in each other", deepest_collection);
        blanks();
        const size_t before = at_;
        const std::string kind = word();
        if (kind == "POLYGON") return polygon();
        if (kind == "MULTIPOLYGON") {
            if (opens()) list([&] { polygon(); });
            return;
        }
        if (kind == "GEOMETRYCOLLECTION") {
            if (opens()) list([&] { geometry(depth + 1); });
            return;
        }
        for (const char *known : {"POINT", "LINESTRING", "MULTIPOINT", "MULTILINESTRING", "CURVEPOLYGON", "TRIANGLE"})
            if (kind == known)
                fail(CLQ_UNSUPPORTED, "the WKT has a %s: polygons and collections of them are read", known);
        at_ = before;
        refuse("POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION");
    }

    std::string_view text_;
    size_t at_ = 0;
    AreaBuilder &out_;
};

}  // namespace

void read_wkt(std::string_view text, AreaBuilder &out) { WktReader(text, out).read(); }

}  // namespace claque::asset
