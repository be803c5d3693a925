// What all fuzzers share. A fuzzer is a file with libFuzzer's entry point, LLVMFuzzerTestOneInput, which expects its
// laws by GoogleTest: a broken one ends libFuzzer with the input, and fails the test that replays the corpora.
#pragma once

#include <claque/claque.h>

#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);
extern "C" size_t LLVMFuzzerMutate(uint8_t *bytes, size_t size, size_t max_size);

namespace fuzzing
{

using Bytes = std::vector<uint8_t>;

// Numbers from an input, one after another; zeros behind its end.
class Feed
{
public:
    Feed(const uint8_t *bytes, size_t size) : at_(bytes), left_(size) {}
    size_t left() const { return left_; }
    template <class Number>
    Number take()
    {
        Number out{};
        const size_t size = sizeof out < left_ ? sizeof out : left_;
        if (size > 0) std::memcpy(&out, at_, size);
        at_ += size, left_ -= size;
        return out;
    }
    uint32_t below(uint32_t n) { return n <= 256 ? take<uint8_t>() % n : take<uint32_t>() % n; }
    Bytes bytes(size_t size)
    {
        if (size > left_) size = left_;
        Bytes out(at_, at_ + size);
        at_ += size, left_ -= size;
        return out;
    }

private:
    const uint8_t *at_;
    size_t left_;
};

// A number that follows from an input, to choose what happens to it.
inline uint64_t number_of(const uint8_t *bytes, size_t size)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash ^ hash >> 29;
}

// True for OK; a refusal must be one of these, with a sentence.
inline bool done(clq_status status, std::initializer_list<clq_status> refusals)
{
    if (status == CLQ_OK) return true;
    bool allowed = false;
    for (const clq_status refusal : refusals) allowed = allowed || refusal == status;
    EXPECT_TRUE(allowed) << clq_status_name(status) << ": " << clq_last_error();
    EXPECT_STRNE(clq_last_error(), "");
    return false;
}

inline clq_context *new_context()
{
    clq_context *context = nullptr;
    EXPECT_EQ(clq_context_create(nullptr, &context), CLQ_OK) << clq_last_error();
    return context;
}

// All that is made from the context must have been destroyed.
inline void end(clq_context *context) { EXPECT_EQ(clq_context_destroy(context), CLQ_OK) << clq_last_error(); }

}  // namespace fuzzing
