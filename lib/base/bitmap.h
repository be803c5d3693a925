// A set of small numbers as bits, in ascending order. A second row has a bit for each word that is not empty, so that
// stretches without members cost next to nothing.
//
// Only `reserve` allocates. Members are below its size.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "lib/base/held_bytes.h"

namespace claque::base
{

inline uint32_t lowest_bit(uint64_t bits) { return static_cast<uint32_t>(__builtin_ctzll(bits)); }

class Bitmap
{
public:
    static constexpr uint32_t word_bits = 64;

    explicit Bitmap(std::pmr::memory_resource *memory) : words_(memory), filled_(memory) {}

    // Makes room for numbers below `size`. Throws std::bad_alloc and changes nothing then.
    void reserve(uint32_t size)
    {
        const size_t words = (size_t(size) + word_bits - 1) / word_bits;
        if (words <= words_.size()) return;
        words_.reserve(words);
        filled_.reserve((words + word_bits - 1) / word_bits);
        words_.resize(words);
        filled_.resize((words + word_bits - 1) / word_bits);
    }
    bool has_room_for(uint32_t i) const { return i / word_bits < words_.size(); }

    bool has(uint32_t i) const { return has_room_for(i) && (words_[i / word_bits] >> i % word_bits & 1); }
    void insert(uint32_t i) noexcept
    {
        const uint32_t word = i / word_bits;
        count_ += !has(i);
        words_[word] |= uint64_t(1) << i % word_bits;
        filled_[word / word_bits] |= uint64_t(1) << word % word_bits;
    }
    void erase(uint32_t i) noexcept
    {
        if (!has(i)) return;
        const uint32_t word = i / word_bits;
        --count_;
        words_[word] &= ~(uint64_t(1) << i % word_bits);
        if (words_[word] == 0) filled_[word / word_bits] &= ~(uint64_t(1) << word % word_bits);
    }
    void clear() noexcept
    {
        for_each_word([this](uint32_t word, uint64_t) { words_[word] = 0; });
        for (uint64_t &bits : filled_) bits = 0;
        count_ = 0;
    }

    uint32_t count() const { return count_; }
    uint64_t word(uint32_t i) const { return i < words_.size() ? words_[i] : 0; }
    // Which words of the 64 from 64 * i on have members.
    uint64_t filled(uint32_t i) const { return i < filled_.size() ? filled_[i] : 0; }
    uint32_t filled_count() const { return static_cast<uint32_t>(filled_.size()); }

    template <class Body>
    void for_each_word(const Body &body) const
    {
        for (uint32_t k = 0; k < filled_count(); ++k)
            for (uint64_t left = filled_[k]; left != 0; left &= left - 1) {
                const uint32_t i = k * word_bits + lowest_bit(left);
                body(i, words_[i]);
            }
    }
    template <class Body>
    void for_each(const Body &body) const
    {
        for_each_word([&](uint32_t word, uint64_t bits) {
            for (; bits != 0; bits &= bits - 1) body(word * word_bits + lowest_bit(bits));
        });
    }

    uint64_t bytes() const { return held_bytes(words_, filled_); }

private:
    std::pmr::vector<uint64_t> words_, filled_;
    uint32_t count_ = 0;
};

}  // namespace claque::base
