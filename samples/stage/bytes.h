// Numbers as bytes, for what a run saves besides the stage and the crowd.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "samples/scenes/check.h"

namespace staged
{

class BytesOut
{
public:
    template <class Number>
    void put(Number number)
    {
        static_assert(std::is_arithmetic_v<Number>);
        const auto *first = reinterpret_cast<const uint8_t *>(&number);
        bytes.insert(bytes.end(), first, first + sizeof number);
    }
    void put_block(const std::vector<uint8_t> &block)
    {
        put(static_cast<uint64_t>(block.size()));
        bytes.insert(bytes.end(), block.begin(), block.end());
    }

    std::vector<uint8_t> bytes;
};

class BytesIn
{
public:
    BytesIn(const uint8_t *first, size_t size) : at_(first), left_(size) {}

    template <class Number>
    Number take()
    {
        static_assert(std::is_arithmetic_v<Number>);
        Number number;
        need(sizeof number);
        std::memcpy(&number, at_, sizeof number);
        at_ += sizeof number, left_ -= sizeof number;
        return number;
    }
    // A number of things that are at most `most`.
    uint32_t count(uint64_t most)
    {
        const auto number = take<uint64_t>();
        if (number > most)
            throw scenes::Failure("the saved run has " + std::to_string(number) +
                                  " of something of which it can have " + std::to_string(most));
        return static_cast<uint32_t>(number);
    }
    std::vector<uint8_t> take_block()
    {
        const auto size = take<uint64_t>();
        need(size);
        std::vector<uint8_t> block(at_, at_ + size);
        at_ += size, left_ -= static_cast<size_t>(size);
        return block;
    }
    bool is_empty() const { return left_ == 0; }

private:
    void need(uint64_t size) const
    {
        if (size > left_) throw scenes::Failure("the saved run is cut off");
    }

    const uint8_t *at_;
    size_t left_;
};

}  // namespace staged
