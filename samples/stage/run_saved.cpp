// The state of a run as bytes.
#include <algorithm>

#include "samples/stage/run.h"

namespace staged
{

using namespace scenes;

namespace
{

constexpr uint64_t run_magic = 0x021a4e5255515143u;  // the version is its first byte

int append_bytes(void *user, const void *bytes, size_t size)
{
    auto &to = *static_cast<std::vector<uint8_t> *>(user);
    const auto *first = static_cast<const uint8_t *>(bytes);
    to.insert(to.end(), first, first + size);
    return 0;
}

}  // namespace

void Run::put_state(BytesOut &out) const
{
    out.put(shown_s_), out.put(ticks_);
    out.put<uint64_t>(next_arrival_);
    out.put<uint64_t>(waiting_.size());
    for (const Arrival &one : waiting_) out.put(one.person), out.put(one.due_s);
    for (const clq_agent &agent : agents_) out.put(agent.index1);
    out.put<uint64_t>(person_of_.size());
    for (const uint32_t person : person_of_) out.put(person);
    for (const uint64_t count : {counts_.came, counts_.left, counts_.commands, counts_.refused, counts_.late})
        out.put(count);
    out.put<uint64_t>(deeds_.size());
    for (const Deed &one : deeds_) {
        out.put(static_cast<uint8_t>(one.kind)), out.put(one.at_s), out.put(one.what);
        for (const double x : one.spot.position) out.put(x);
        out.put(one.spot.heading_rad);
    }
    if (sights_) sights_->put(out);
    for (const auto &service : services_) service->put(out);
}

void Run::take_state(BytesIn &in)
{
    const uint64_t people = people_.all().size();
    const auto known = [](uint32_t number, uint64_t of) {
        if (number >= of) throw Failure("the saved run names a person or a door that the scenario does not have");
        return number;
    };
    shown_s_ = in.take<double>(), ticks_ = in.take<uint64_t>();
    next_arrival_ = in.count(arrivals_.size());
    waiting_.resize(in.count(people));
    for (Arrival &one : waiting_) one.person = known(in.take<uint32_t>(), people), one.due_s = in.take<double>();
    here_.clear();
    for (uint32_t i = 0; i < people; ++i) {
        agents_[i].index1 = in.take<uint32_t>();
        if (is_here(i)) here_.push_back(i);
    }
    person_of_.resize(in.count(people));
    for (uint32_t &person : person_of_) person = known(in.take<uint32_t>(), people);
    for (const clq_agent &agent : agents_) known(agent.index1, person_of_.size() + 1);
    for (uint64_t *count : {&counts_.came, &counts_.left, &counts_.commands, &counts_.refused, &counts_.late})
        *count = in.take<uint64_t>();
    deeds_.resize(in.count(4 * (people + described_.doors.size()) + 1000));
    for (Deed &one : deeds_) {
        one.kind = static_cast<Deed::Kind>(known(in.take<uint8_t>(), 4));
        one.at_s = in.take<double>();
        const bool is_door = one.kind == Deed::Kind::open || one.kind == Deed::Kind::close;
        one.what = known(in.take<uint32_t>(), is_door ? described_.doors.size() : people);
        for (double &x : one.spot.position) x = in.take<double>();
        one.spot.heading_rad = in.take<double>();
    }
    if (sights_) sights_->take(in);
    for (const auto &service : services_) service->take(*this, in);
}

std::vector<uint8_t> Run::save() const
{
    BytesOut out, state;
    out.put(run_magic);
    put_state(state);
    std::vector<uint8_t> stage, crowd;
    check(clq_stage_save(stage_.get(), append_bytes, &stage));
    check(clq_crowd_save(this->crowd(), append_bytes, &crowd));
    for (const std::vector<uint8_t> *block : {&state.bytes, &stage, &crowd}) out.put_block(*block);
    return std::move(out.bytes);
}

void Run::restore(const std::vector<uint8_t> &bytes)
{
    BytesIn in(bytes.data(), bytes.size());
    if (bytes.size() < sizeof run_magic || in.take<uint64_t>() != run_magic)
        throw Failure("this is no saved run, or one of another version of claque");
    const std::vector<uint8_t> state = in.take_block(), stage = in.take_block(), crowd = in.take_block();
    if (!in.is_empty()) throw Failure("there are bytes behind the saved run");
    BytesIn own(state.data(), state.size());
    take_state(own);
    if (!own.is_empty()) throw Failure("the saved run is that of another scenario");
    check(clq_stage_restore(stage_.get(), this->crowd(), stage.data(), stage.size()));
    people_.restore(crowd, templates());
}

}  // namespace staged
