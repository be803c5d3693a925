// The ids of people as texts: each is kept once and has a number, in the order of first appearance.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/asset/budget.h"

namespace claque::asset
{

class Ids
{
public:
    static constexpr size_t longest = 256;  // bytes

    explicit Ids(Budget &budget) : budget_(&budget) {}

    // Throws base::Error: CLQ_LIMIT for an id that is too long, or when the budget is spent.
    uint32_t number_of(std::string_view id);
    uint32_t count() const { return static_cast<uint32_t>(known_.size()); }
    const char *text(uint32_t number) const { return known_[number].data(); }
    // Leaves out the first bytes of an id, unless another id is the rest. number_of still takes the whole.
    void shorten(uint32_t number, size_t bytes);

    // Keeps a text that gets no number, ended by 0.
    const char *keep(std::string_view text);
    // The id for a message: short, without control bytes.
    std::string shown(uint32_t number) const;
    // Frees what only number_of needs.
    void close() { numbers_.clear(), after_.clear(); }

private:
    uint32_t add(std::string_view id);

    Budget *budget_;
    std::vector<std::unique_ptr<char[]>> blocks_;
    char *free_ = nullptr;
    size_t left_ = 0;
    std::vector<std::string_view> known_;
    std::map<std::string_view, uint32_t> numbers_;  // ordered: no input makes it slow
    // The number that followed a number when it was last met. Most files repeat an order, or one person.
    std::vector<uint32_t> after_;
    uint32_t last_ = 0;
};

}  // namespace claque::asset
