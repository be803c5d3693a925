#include "lib/crowd/save_check.h"

#include <cmath>
#include <limits>

namespace claque::crowd
{

using base::fail;
using model::none;

MechanismKind kind_of(uint8_t index, std::pmr::memory_resource *memory)
{
    switch (index) {
        case 0:
            return Gaze();
        case 1:
            return Expression(memory);
        case 2:
            return Blink(memory);
        case 3:
            return Phrase(memory);
        case 4:
            return Idle(memory);
        case 5:
            return HostMechanism();
        default:
            fail(CLQ_FORMAT, "a saved crowd holds a mechanism of kind %u, which is none", index);
    }
}

void check_command(const Mechanism &mechanism, const Command &command, uint32_t number)
{
    uint32_t choices = 1;
    if (const Expression *expression = std::get_if<Expression>(&mechanism.kind))
        choices = static_cast<uint32_t>(expression->poses.size());
    const auto known = [&](uint32_t choice) { return choice == none || choice < choices; };
    bool good = known(command.choice) && known(command.choice_before);
    good = good && (std::isfinite(command.at_s) || command.at_s == -std::numeric_limits<double>::infinity());
    for (int k = 0; k < 3; ++k) good = good && std::fabs(command.point[k]) <= 1e30f;
    good = good && std::isfinite(command.from_yaw) && std::isfinite(command.from_pitch) && std::isfinite(command.side);
    if (!good) fail(CLQ_FORMAT, "a saved crowd holds a command that mechanism %u never gets", number + 1);
}

}  // namespace claque::crowd
