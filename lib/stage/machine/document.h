// A TOML text and what readers ask of it; every refusal names file, line and column.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/stage/machine/toml.h"

namespace claque::stage
{

constexpr size_t max_text_bytes = size_t(4) << 20;

class Document
{
public:
    // A text of at most max_text_bytes. Throws Error: LIMIT, or FORMAT where it is not TOML.
    Document(std::string_view text, const std::string &name);

    const toml::table &root() const { return parsed_.table(); }

    [[noreturn]] void refuse(const toml::source_region &at, const std::string &sentence) const;
    [[noreturn]] void refuse(const toml::node &at, const std::string &sentence) const { refuse(at.source(), sentence); }
    // At a character of a string.
    [[noreturn]] void refuse(const toml::node &at, size_t offset, const std::string &sentence) const;

    const toml::table &table(const toml::node &node, const std::string &what) const;
    const toml::array &list(const toml::node &node, const std::string &what) const;
    std::string string(const toml::node &node, const std::string &what) const;
    bool truth(const toml::node &node, const std::string &what) const;
    double number(const toml::node &node, const std::string &what) const;  // finite
    double number(const toml::node &node, const std::string &what, double least, double most) const;
    uint32_t whole(const toml::node &node, const std::string &what, uint32_t least, uint32_t most) const;
    void point(const toml::node &node, const std::string &what, double out[3]) const;
    // One string, or a list of them that is not empty.
    std::vector<std::pair<std::string, const toml::node *>> strings(const toml::node &node,
                                                                    const std::string &what) const;
    // Refuses every other key.
    void known(const toml::table &in, std::initializer_list<std::string_view> keys) const;
    // Members in the order of the file, which a parsed table does not keep.
    std::vector<std::pair<const toml::key *, const toml::node *>> in_order(const toml::table &from) const;

private:
    std::string name_;
    toml::parse_result parsed_;
};

}  // namespace claque::stage
