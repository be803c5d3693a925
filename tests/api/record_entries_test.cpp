// Records put together from entries, under right checksums: what has no order, no name or no number of its own is
// refused with a sentence.
#include <functional>

#include "lib/record/format.h"
#include "tests/api/record_fixture.h"

namespace
{

namespace format = claque::record;
using format::Kind;
using records::Bytes;
using records::number_in;

struct Entry {
    Kind kind;
    Bytes fields;
};
using Entries = std::vector<Entry>;

Entries entries_of(const Bytes &bytes)
{
    Entries out;
    for (size_t at = format::file_header_bytes; at < bytes.size();) {
        const size_t end = at + format::block_header_bytes + number_in(bytes, at, 4);
        for (at += format::block_header_bytes; at < end;) {
            const size_t size = number_in(bytes, at, 4);
            const auto first = bytes.begin() + long(at) + format::entry_header_bytes;
            out.push_back({static_cast<Kind>(bytes[at + 4]), {first, first + long(size) - 1}});
            at += 4 + size;
        }
    }
    return out;
}

// All entries in one block.
Bytes record_of(const Entries &entries, uint32_t version = format::first_version)
{
    Bytes out(format::magic, format::magic + 8), contents;
    out.resize(format::file_header_bytes + format::block_header_bytes);
    saved::put(out, 8, version, 4);
    for (const Entry &entry : entries) {
        const size_t at = contents.size();
        contents.resize(at + format::entry_header_bytes);
        saved::put(contents, at, entry.fields.size() + 1, 4);
        contents[at + 4] = static_cast<uint8_t>(entry.kind);
        contents.insert(contents.end(), entry.fields.begin(), entry.fields.end());
    }
    const auto size = static_cast<uint32_t>(contents.size());
    const uint64_t checksum = format::checksum_of(contents.data(), size, 0);
    saved::put(out, format::file_header_bytes, size, 4);
    saved::put(out, format::file_header_bytes + 4, format::check_of_header(size, checksum, 0), 4);
    saved::put(out, format::file_header_bytes + 8, checksum, 8);
    out.insert(out.end(), contents.begin(), contents.end());
    return out;
}

class RecordEntries : public testing::Test
{
protected:
    RecordEntries()
    {
        for (const Entry &entry : entries_of(records::run(world_, 12, 5).bytes))
            if (entry.kind != Kind::index && entry.kind != Kind::end) good_.push_back(entry);
    }
    // The refusal of a record; "" if there is none.
    std::string refusal(const Bytes &bytes)
    {
        clq_record *record = nullptr;
        const clq_status status = clq_record_load(world_.context, bytes.data(), bytes.size(), &record);
        clq_record_destroy(record);
        if (status == CLQ_OK) return "";
        EXPECT_EQ(status, CLQ_FORMAT);
        EXPECT_EQ(record, nullptr);
        return clq_last_error();
    }
    void refused(const Entries &entries, const char *sentence)
    {
        const std::string said = refusal(record_of(entries));
        EXPECT_NE(said.find(sentence), std::string::npos) << "said '" << said << "' and not '" << sentence << "'";
    }
    size_t first(Kind kind) const
    {
        for (size_t i = 0; i < good_.size(); ++i)
            if (good_[i].kind == kind) return i;
        ADD_FAILURE() << "no entry of kind " << unsigned(kind);
        return 0;
    }
    Entries with(const Entry &more) const
    {
        Entries all = good_;
        all.push_back(more);
        return all;
    }

    TestWorld world_;
    Entries good_;
};

TEST_F(RecordEntries, OfAGoodRecordArePlayedFromOneBlock)
{
    const records::Recording run = records::run(world_, 12, 5);
    const Bytes bytes = record_of(good_);
    records::Player player(world_, bytes);
    ASSERT_TRUE(player.opened()) << clq_last_error();
    EXPECT_EQ(player.info().step_count, 12u);
    EXPECT_FALSE(player.info().whole);
    records::Shown seen;
    player.show(11, seen);
    EXPECT_EQ(seen.lists[0], run.shown.lists[11]);
}

TEST_F(RecordEntries, BeforeWhatTheyNeedAreRefused)
{
    const Entry def = good_[first(Kind::crowd_def)], state = good_[first(Kind::state)], step = good_[first(Kind::step)];
    const Bytes actor(8, 0);
    refused({}, "ends before its first state");
    refused({state}, "a record has no definition of its crowd, or a second one");
    refused({def, def}, "a record has no definition of its crowd, or a second one");
    refused({def}, "ends before its first state");
    for (const Entry &early : {step, Entry{Kind::key_state, state.fields}, Entry{Kind::actor_destroy, actor}})
        refused({def, early}, "a record has calls before its first state");
    refused({def, state}, "a record names template 0, and has 0 before");
    refused({def, good_[first(Kind::tmpl)], state}, "a record names template 1, and has 1 before");
    refused({def, {Kind::tmpl, {1, 2, 3}}}, "template 0 of a record has no name");
    refused(with({Kind::track, {1, 2, 3}}), "of a record is empty");
    refused(with({static_cast<Kind>(10), {}}), "an entry of kind 10, which this library does not know");
    refused(with({static_cast<Kind>(0), {}}), "an entry of kind 0, which this library does not know");
    Entries ended = with({Kind::end, Bytes(12, 0)});
    EXPECT_EQ(refusal(record_of(ended)), "");
    ended.push_back(step);
    refused(ended, "a record has an entry after its end, at byte ");
}

TEST_F(RecordEntries, OfALocomotionStandOnceAndWithinTheirLimits)
{
    Entry legs = good_[first(Kind::locomotion)];
    refused(with(legs), "a record has a locomotion twice");
    // Every one of its numbers makes another locomotion, but idles beyond their count.
    const size_t count_at = 4 + 4 * 4;
    const size_t idles = number_in(legs.fields, count_at, 4), first_idle = count_at + 4, after_idles = first_idle + 16;
    for (size_t at = 4; at < legs.fields.size(); at += 4) {
        if (at == count_at) continue;
        Entry other = legs;
        other.fields[at] ^= 1;
        if (at >= first_idle + 4 * idles && at < after_idles) refused(with(other), "a record has a locomotion twice");
        else EXPECT_EQ(refusal(record_of(with(other))), "") << "number " << at / 4;
    }
    Entry wrong = legs;
    wrong.fields[0] = 7;
    refused(with(wrong), "a record names template 7, and has 2 before");
    wrong = legs;
    wrong.fields[count_at] = 5;
    refused(with(wrong), "a record has a locomotion with 5 idle clips");
    wrong = legs;
    wrong.fields.push_back(0);
    refused(with(wrong), "a locomotion of a record has 1 bytes too many");
    Entries many = good_;
    for (uint32_t i = 0; many.size() < good_.size() + 256; ++i) {
        saved::put(legs.fields, 4, 1000 + i, 4);
        many.push_back(legs);
    }
    refused(many, "a record has more than 256 locomotions");
    many.resize(many.size() - 2);
    EXPECT_EQ(refusal(record_of(many)), "");
}

TEST_F(RecordEntries, BehindAHeaderOfSomethingElseAreRefused)
{
    const Bytes good = record_of(good_);
    const auto changed = [&](size_t at, uint8_t value) {
        Bytes bytes = good;
        bytes[at] = value;
        return refusal(bytes);
    };
    EXPECT_EQ(changed(8, 1), "");
    EXPECT_NE(changed(0, 'C').find("these bytes are no record"), std::string::npos);
    EXPECT_NE(changed(8, 0).find("a record of version 0; this library reads versions 1 to 2"), std::string::npos);
    EXPECT_NE(changed(8, 3).find("a record of version 3; this library reads versions 1 to 2"), std::string::npos);
    EXPECT_NE(changed(12, 1).find("the header of a record was changed"), std::string::npos);
    const Bytes shorter(good.begin(), good.begin() + format::file_header_bytes - 1);
    EXPECT_NE(refusal(shorter).find("these bytes are no record"), std::string::npos);
    const Bytes only_header(good.begin(), good.begin() + format::file_header_bytes);
    EXPECT_NE(refusal(only_header).find("a record of 16 bytes ends before its first state"), std::string::npos);
}

// Nothing was updated while it was recorded.
TEST_F(RecordEntries, WithoutAStepHaveNoTime)
{
    clq_crowd *crowd = world_.new_crowd();
    Bytes bytes;
    const clq_recording_def def = records::recording_to(bytes);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK);
    for (const auto opening : {clq_record_load, clq_record_open}) {
        clq_record *record = nullptr;
        ASSERT_EQ(opening(world_.context, bytes.data(), bytes.size(), &record), CLQ_OK) << clq_last_error();
        clq_record_info info = clq_record_info_init();
        ASSERT_EQ(clq_record_get_info(record, &info), CLQ_OK);
        EXPECT_EQ(info.step_count, 0u);
        EXPECT_EQ(info.start_s, 0);
        EXPECT_EQ(info.end_s, 0);
        double time_s = 3;
        EXPECT_EQ(clq_record_get_time(record, 0, &time_s), CLQ_ARGUMENT);
        EXPECT_EQ(time_s, 3);
        EXPECT_STREQ(clq_record_get_template_name(record, info.template_count), "");
        EXPECT_STREQ(clq_record_get_template_name(nullptr, 0), "");
        clq_record_destroy(record);
    }
}

}  // namespace
