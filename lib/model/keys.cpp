#include "lib/model/keys.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/math/trig.h"

namespace claque::model
{

namespace
{

// In 1/255. Smaller than the quarter step that the acceptance checks keep free, larger than the error of a float.
constexpr double nudge = 1.0 / 16.0;
constexpr double spare_steps = 0.25;

double halfway(Keys keys, uint32_t index) { return 0.5 * (double(keys[index - 1]) + keys[index]); }

double centre(Keys keys) { return keys[0] - 0.5; }

// A fragment alpha of `value` (in 1/255) as whole steps of the target.
struct Steps {
    double per_255;
    double low(double value) const { return std::floor(value * per_255 - spare_steps + 0.5); }
    double high(double value) const { return std::floor(value * per_255 + spare_steps + 0.5); }
};

Steps steps_of(uint32_t alpha_bits)
{
    return Steps{(std::ldexp(1.0, static_cast<int>(std::min(alpha_bits, 30u))) - 1.0) / 255.0};
}

bool told_apart(const Steps &steps, double lower, double upper, double reference_255)
{
    const double reference = reference_255 * steps.per_255;
    return steps.high(lower) < reference && steps.low(upper) >= reference;
}

template <class Accepts>
uint32_t limit_of(const Accepts &accepts)
{
    uint32_t n = 1;
    while (n < max_zone_keys && accepts(geometric_keys(n + 1))) ++n;
    return n;
}

}  // namespace

std::vector<uint8_t> geometric_keys(uint32_t count)
{
    if (count == 0 || count > max_zone_keys)
        base::fail(CLQ_LIMIT, "a texture with %u zones: zone keys tell 1 to %u apart", count, max_zone_keys);
    if (count == 1) return {255};
    const int n = static_cast<int>(count);
    const int first = std::min<int>(lowest_key, 256 - n);
    std::vector<uint8_t> keys;
    int previous = first - 1;
    for (int i = 0; i < n; ++i) {
        const double wanted = first < 1 ? i : first * math::pow(255.0 / first, double(i) / (n - 1));
        const int key = std::clamp(static_cast<int>(std::floor(wanted + 0.5)), previous + 1, 255 - (n - 1 - i));
        keys.push_back(static_cast<uint8_t>(key));
        previous = key;
    }
    return keys;
}

std::vector<uint8_t> keys_of(const Texture &texture)
{
    std::vector<uint8_t> keys;
    for (const ZoneKey &zone : texture.keys) keys.push_back(zone.key);
    return keys;
}

float pass_reference(Keys keys, uint32_t index)
{
    const double reference = index == 0 ? 0.5 * keys[0] : halfway(keys, index) + nudge;
    return static_cast<float>(reference / 255.0);
}

float fused_reference(Keys keys) { return static_cast<float>(std::max(0.0, centre(keys) + nudge) / 255.0); }

float raised_alpha(Keys keys, uint32_t index)
{
    return static_cast<float>(std::max(0.0, centre(keys)) / halfway(keys, index));
}

uint8_t raised_alpha_8bit(Keys keys, uint32_t index)
{
    return static_cast<uint8_t>(std::floor(255.0 * std::max(0.0, centre(keys)) / halfway(keys, index) + 0.5));
}

FusedTable fused_table(Keys keys)
{
    FusedTable table;
    table.reference = fused_reference(keys);
    for (uint32_t i = 0; i < keys.count; ++i) {
        table.alpha.push_back(i == 0 ? 1.0f : raised_alpha(keys, i));
        table.alpha_8bit.push_back(i == 0 ? uint8_t(255) : raised_alpha_8bit(keys, i));
    }
    return table;
}

bool fused_accepts(Keys keys, uint32_t alpha_bits)
{
    const Steps steps = steps_of(alpha_bits);
    const double reference = double(fused_reference(keys)) * 255.0;
    if (keys.count == 0 || keys[0] == 0 || !told_apart(steps, 0, keys[0], reference)) return false;
    for (uint32_t i = 1; i < keys.count; ++i)
        for (const double alpha : {double(raised_alpha(keys, i)), raised_alpha_8bit(keys, i) / 255.0})
            if (!told_apart(steps, keys[i - 1] * alpha, keys[i] * alpha, reference)) return false;
    return true;
}

bool passes_accept(Keys keys, uint32_t alpha_bits)
{
    const Steps steps = steps_of(alpha_bits);
    for (uint32_t i = 1; i < keys.count; ++i)
        if (!told_apart(steps, keys[i - 1], keys[i], double(pass_reference(keys, i)) * 255.0)) return false;
    return keys.count > 0;
}

uint32_t fused_limit(uint32_t alpha_bits)
{
    return limit_of([&](const std::vector<uint8_t> &keys) { return fused_accepts(Keys(keys), alpha_bits); });
}

uint32_t passes_limit(uint32_t alpha_bits)
{
    return limit_of([&](const std::vector<uint8_t> &keys) { return passes_accept(Keys(keys), alpha_bits); });
}

}  // namespace claque::model
