// The rows of the index that a filter chooses: the common members of several bitmaps, word by word.
#pragma once

#include "lib/scene/scene.h"

namespace claque::scene
{

class Chosen
{
public:
    Chosen(const Scene &scene, const crowd::Crowd &crowd, const Filter &filter);

    uint32_t most() const { return most_; }  // an upper bound of their number

    // As of a base::Bitmap.
    uint32_t filled_count() const { return scene_.known_.filled_count(); }
    uint64_t filled(uint32_t k) const;
    uint64_t word(uint32_t i) const;

    template <class Body>
    void for_each(const Body &body) const
    {
        for (uint32_t k = 0; k < filled_count(); ++k)
            for (uint64_t left = filled(k); left != 0; left &= left - 1) {
                const uint32_t i = k * base::Bitmap::word_bits + base::lowest_bit(left);
                for (uint64_t rows = word(i); rows != 0; rows &= rows - 1)
                    body(i * base::Bitmap::word_bits + base::lowest_bit(rows));
            }
    }

private:
    static constexpr uint32_t most_parts = 4 + category_count;

    void need(const base::Bitmap &part);
    const base::Bitmap *category(uint32_t i) const;

    const Scene &scene_;
    const base::Bitmap *needed_[most_parts];
    uint32_t needed_count_ = 0;
    uint64_t any_of_ = 0, none_of_ = 0;
    uint32_t most_ = 0;
};

}  // namespace claque::scene
