// Answers in a host's array: the first ones in order if there are more than it holds. Nothing is allocated.
#pragma once

#include <algorithm>
#include <cstdint>

namespace claque::scene
{

// `Before` orders answers; no two are equal in it. A full array is a heap with the last answer on top.
template <class Answer, class Before>
class Answers
{
public:
    Answers(Answer *out, uint32_t capacity, const Before &before) : out_(out), capacity_(capacity), before_(before) {}

    void add(const Answer &answer)
    {
        if (count_ < capacity_) {
            out_[count_++] = answer;
            if (count_ == capacity_) std::make_heap(out_, out_ + capacity_, before_);
            return;
        }
        ++count_;
        if (capacity_ == 0 || !before_(answer, out_[0])) return;
        std::pop_heap(out_, out_ + capacity_, before_);
        out_[capacity_ - 1] = answer;
        std::push_heap(out_, out_ + capacity_, before_);
    }
    bool full() const { return count_ >= capacity_; }
    const Answer &last() const { return out_[0]; }  // of a full array that is not empty

    // Sorts what is in the array. Returns the number of all answers, of which there may be more.
    uint32_t finish()
    {
        std::sort(out_, out_ + std::min(count_, capacity_), before_);
        return count_;
    }

private:
    Answer *out_;
    uint32_t capacity_, count_ = 0;
    Before before_;
};

}  // namespace claque::scene
