// Which actors entered or left view in the last update, and which were new in it. A host that schedules by visibility
// reads these changes and need not ask about every actor. Nothing that is shown depends on them.
#pragma once

#include "lib/base/bitmap.h"
#include "lib/frame/frame_data.h"

namespace claque::frame
{

class ViewChanges
{
public:
    explicit ViewChanges(std::pmr::memory_resource *memory)
        : now_(memory), before_(memory), fresh_(memory), generations_(memory)
    {
    }

    void reserve(uint32_t rows);  // may throw std::bad_alloc
    // Ends an update. `visible`: of the candidates, those that a view saw.
    void note(const crowd::Crowd &crowd, base::Span<const Candidate> candidates,
              base::Span<const uint32_t> visible) noexcept;
    void forget() noexcept;  // the next update reports every actor

    // Body: f(row, in_view). Of actors that exist now, in the order of their rows.
    template <class Body>
    void for_each(const crowd::Crowd &crowd, const Body &body) const
    {
        for (uint32_t k = 0; k < now_.filled_count(); ++k) {
            uint64_t words = now_.filled(k) | before_.filled(k) | fresh_.filled(k);
            for (; words != 0; words &= words - 1) {
                const uint32_t word = k * base::Bitmap::word_bits + base::lowest_bit(words);
                uint64_t changed = (now_.word(word) ^ before_.word(word)) | fresh_.word(word);
                for (; changed != 0; changed &= changed - 1) {
                    const uint32_t row = word * base::Bitmap::word_bits + base::lowest_bit(changed);
                    if (crowd.alive(row) && crowd.actor(row).generation == generations_[row]) body(row, now_.has(row));
                }
            }
        }
    }

    uint64_t bytes() const { return now_.bytes() + before_.bytes() + fresh_.bytes() + base::held_bytes(generations_); }

private:
    base::Bitmap now_, before_;               // seen in the last update, and in the one before
    base::Bitmap fresh_;                      // the last update was its first
    std::pmr::vector<uint32_t> generations_;  // by row, of the actor that the last update knew; 0: none
    uint64_t structure_ = 0;                  // the crowd's structure version then
};

}  // namespace claque::frame
