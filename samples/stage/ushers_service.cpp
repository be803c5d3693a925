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
        if (!ushers_) ushers_ = std::make_unique<Ushers>(theatre_, run.seed());
        ushers_->ask(action, guest_of(run, call.person), [&](const Ushers::Answer &answer) {
            const uint32_t person = people_[answer.guest];
            if (run.is_here(person)) run.send(person, answer.event, answer.place.data(), answer.value);
        });
    }

private:
    size_t guest_of(Run &run, uint32_t person)
    {
        const auto found = guests_.find(person);
        if (found != guests_.end()) return found->second;
        Spectator one;
        one.social_class = run.agents_of(person).name;
        one.scale = run.people().all()[person].scale;
        one.entrance = run.place_of(person);
        people_.push_back(person);
        return guests_[person] = ushers_->add(one);
    }

    const Theatre theatre_;
    std::unique_ptr<Ushers> ushers_;
    std::map<uint32_t, size_t> guests_;  // by person
    std::vector<uint32_t> people_;       // by guest
};

}  // namespace

std::unique_ptr<Service> make_ushers(const Scenario &scenario) { return std::make_unique<UshersService>(scenario); }

}  // namespace staged
