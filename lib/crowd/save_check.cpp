#include "lib/crowd/save_check.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace claque::crowd
{

using base::fail;
using model::none;

Reader contents_of(const uint8_t *bytes, size_t size)
{
    if (size < header_bytes || std::memcmp(bytes, save_magic, sizeof save_magic) != 0)
        fail(CLQ_FORMAT, "%zu bytes that are not a saved crowd", size);
    Reader header(bytes + sizeof save_magic, header_bytes - sizeof save_magic);
    uint32_t version = 0, zero = 0;
    uint64_t contents = 0, hash = 0;
    header.value(version), header.value(zero), header.value(contents), header.value(hash);
    if (version != save_version)
        fail(CLQ_FORMAT, "a saved crowd of version %u: this library reads version %u", version, save_version);
    if (zero != 0 || contents != size - header_bytes)
        fail(CLQ_FORMAT, "a saved crowd of %llu bytes is %zu bytes long", static_cast<unsigned long long>(contents),
             size - header_bytes);
    if (hash != base::fnv(base::fnv_start, bytes + header_bytes, contents))
        fail(CLQ_FORMAT, "a saved crowd has been changed since it was saved: its hash differs");
    return Reader(bytes + header_bytes, size - header_bytes);
}

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
