// For tests that call with each pointer in turn as NULL: a crowd with all that calls need, and a record.
#pragma once

#include <set>
#include <string>
#include <tuple>

#include "tests/api/busy_calls.h"
#include "tests/api/saved_bytes.h"

namespace null_arguments
{

template <class T>
struct AsIs {
    using type = T;
};
template <class T>
using Same = typename AsIs<T>::type;  // that no argument decides

class NullArguments : public busy::Busy
{
protected:
    void SetUp() override
    {
        Busy::SetUp();
        ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &recorded_), CLQ_OK);
        clq_recording_def def = clq_recording_def_init();
        def.user = &bytes_;
        def.write = [](void *user, const void *bytes, size_t size) {
            const auto *first = static_cast<const uint8_t *>(bytes);
            static_cast<saved::Bytes *>(user)->insert(static_cast<saved::Bytes *>(user)->end(), first, first + size);
            return 0;
        };
        ASSERT_EQ(clq_crowd_begin_recording(recorded_, &def), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_end_recording(recorded_, nullptr), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_record_load(world_.context, bytes_.data(), bytes_.size(), &record_), CLQ_OK) << clq_last_error();
        hash_ = clq_crowd_get_hash(crowd());
    }
    void TearDown() override
    {
        EXPECT_EQ(clq_crowd_get_hash(crowd()), hash_);
        clq_record_destroy(record_);
        EXPECT_EQ(clq_crowd_destroy(recorded_), CLQ_OK);
        Busy::TearDown();
    }
    clq_crowd *crowd() const { return objects_.crowd; }

    // Each pointer is needed besides those at the places `may_be_null`.
    template <class... Args>
    void needs(const char *name, clq_status (*call)(Args...), const std::set<size_t> &may_be_null, Same<Args>... args)
    {
        each(name, call, may_be_null, std::tuple<Args...>(args...), std::index_sequence_for<Args...>());
    }
    clq_record *record() const { return record_; }

private:
    template <class Call, class Given, size_t... I>
    void each(const char *name, Call call, const std::set<size_t> &may_be_null, const Given &given,
              std::index_sequence<I...>)
    {
        (one<I>(name, call, may_be_null, given), ...);
    }
    template <size_t I, class Call, class Given>
    void one(const char *name, Call call, const std::set<size_t> &may_be_null, Given given)
    {
        if constexpr (std::is_pointer_v<std::tuple_element_t<I, Given>>) {
            if (may_be_null.count(I)) return;
            std::get<I>(given) = nullptr;
            EXPECT_EQ(std::apply(call, given), CLQ_ARGUMENT) << name << ", argument " << I;
            const std::string said = clq_last_error();
            EXPECT_EQ(said.rfind(std::string(name) + ": ", 0), 0u) << said;
            EXPECT_NE(said.find(" NULL"), std::string::npos) << said;
        }
    }

    saved::Bytes bytes_;
    clq_crowd *recorded_ = nullptr;
    clq_record *record_ = nullptr;
    uint64_t hash_ = 0;
};

const std::set<size_t> none;

}  // namespace null_arguments

// The source files are searched for these calls.
#define NEEDS(call, ...) needs(#call, call, __VA_ARGS__)
