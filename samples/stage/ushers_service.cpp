// In a theatre: the ushers (samples/scenes/odeon/ushers.h) answer what machines call.
#include "samples/scenes/odeon/ushers.h"
#include "samples/stage/run.h"

namespace staged
{

using namespace scenes;

namespace
{

class UshersService final : public Service
{
public:
    explicit UshersService(const Scenario &scenario) : theatre_(*scenario.theatre) {}

    std::vector<std::string> actions() const override { return Ushers::questions(); }

    void serve(Run &run, size_t action, const Call &call) override
    {
        make(run);
        Question one{call.person, static_cast<uint32_t>(action), {}};
        if (guests_.count(call.person) == 0) one.from = run.place_of(call.person);
        asked_.push_back(one);
        ask(run, one, [&](const Ushers::Answer &answer) {
            const uint32_t person = people_[answer.guest];
            if (run.is_here(person)) run.send(person, answer.event, answer.place.data(), answer.value);
        });
    }

    // What the ushers know is what they were asked, in this order.
    void put(BytesOut &out) const override
    {
        out.put<uint64_t>(asked_.size());
        for (const Question &one : asked_) {
            out.put(one.person), out.put(one.action);
            for (const double part : one.from) out.put(part);
        }
    }

    void take(Run &run, BytesIn &in) override
    {
        ushers_.reset(), guests_.clear(), people_.clear(), asked_.clear();
        make(run);
        const uint32_t people = static_cast<uint32_t>(run.people().all().size());
        asked_.resize(in.count(uint64_t(people) * questions_of_a_person));
        for (Question &one : asked_) {
            one.person = in.take<uint32_t>(), one.action = in.take<uint32_t>();
            for (double &part : one.from) part = in.take<double>();
            if (one.person >= people || one.action >= actions().size())
                throw Failure("the saved run has a question to the ushers that no person asks");
            ask(run, one, [](const Ushers::Answer &) {});
        }
    }

private:
    static constexpr uint32_t questions_of_a_person = 1000;

    struct Question {
        uint32_t person, action;
        std::array<double, 3> from;  // of a person's first one
    };

    void make(const Run &run)
    {
        if (!ushers_) ushers_ = std::make_unique<Ushers>(theatre_, run.seed());
    }

    void ask(Run &run, const Question &one, const Ushers::Send &send)
    {
        auto [guest, is_new] = guests_.emplace(one.person, people_.size());
        if (is_new) {
            people_.push_back(one.person);
            (void)ushers_->add({run.agents_of(one.person).name, run.people().all()[one.person].scale, one.from});
        }
        ushers_->ask(one.action, guest->second, send);
    }

    const Theatre theatre_;
    std::unique_ptr<Ushers> ushers_;
    std::map<uint32_t, size_t> guests_;  // by person
    std::vector<uint32_t> people_;       // by guest
    std::vector<Question> asked_;
};

}  // namespace

std::unique_ptr<Service> make_ushers(const Scenario &scenario) { return std::make_unique<UshersService>(scenario); }

}  // namespace staged
