#include "lib/asset/json_view.h"

#include <cfloat>
#include <cmath>

namespace claque::asset
{

using base::fail;

JsonView JsonView::operator[](const char *key) const
{
    std::string path = path_.empty() ? std::string(key) : path_ + "." + key;
    if (!exists()) return JsonView(nullptr, std::move(path));
    const nlohmann::json &members = object();
    const auto found = members.find(key);
    return JsonView(found == members.end() ? nullptr : &*found, std::move(path));
}

size_t JsonView::count() const
{
    if (!exists()) return 0;
    if (!value_->is_array()) refuse("an array");
    return value_->size();
}

JsonView JsonView::at(size_t index) const
{
    if (index >= count()) fail(CLQ_FORMAT, "%s has no element %zu", path_.c_str(), index);
    return JsonView(&(*value_)[index], path_ + "[" + std::to_string(index) + "]");
}

const nlohmann::json &JsonView::value() const
{
    if (!exists()) fail(CLQ_FORMAT, "%s is missing", path_.c_str());
    return *value_;
}

void JsonView::refuse(const char *expected) const
{
    fail(CLQ_FORMAT, "%s is %s instead of %s", path_.empty() ? "the document" : path_.c_str(), value().type_name(),
         expected);
}

const nlohmann::json &JsonView::object() const
{
    if (!value().is_object()) refuse("an object");
    return *value_;
}

const std::string &JsonView::text() const
{
    if (!value().is_string()) refuse("a string");
    return value_->get_ref<const std::string &>();
}

bool JsonView::boolean() const
{
    if (!value().is_boolean()) refuse("true or false");
    return value_->get<bool>();
}

double JsonView::number() const
{
    if (!value().is_number()) refuse("a number");
    return value_->get<double>();
}

float JsonView::real() const
{
    const double x = number();
    if (!(std::fabs(x) <= static_cast<double>(FLT_MAX))) fail(CLQ_FORMAT, "%s is %g: too large", path_.c_str(), x);
    return static_cast<float>(x);
}

uint64_t JsonView::integer(uint64_t first, uint64_t last) const
{
    // Whole numbers below 2^53 are exact in double, and no valid value is larger.
    const double x = number();
    if (x != std::floor(x)) fail(CLQ_FORMAT, "%s is %g instead of a whole number", path_.c_str(), x);
    if (!(x >= static_cast<double>(first) && x <= static_cast<double>(last)))
        fail(CLQ_FORMAT, "%s is %.17g: it must be from %llu to %llu", path_.c_str(), x,
             static_cast<unsigned long long>(first), static_cast<unsigned long long>(last));
    return static_cast<uint64_t>(x);
}

uint32_t JsonView::index(size_t count, const char *what) const
{
    const uint64_t i = integer(0, 0xfffffffeu);
    if (i >= count)
        fail(CLQ_FORMAT, "%s names %s %llu, which does not exist: there are %zu", path_.c_str(), what,
             static_cast<unsigned long long>(i), count);
    return static_cast<uint32_t>(i);
}

void JsonView::numbers(float *out, size_t wanted) const
{
    if (!value().is_array()) refuse("an array");
    if (count() != wanted) fail(CLQ_FORMAT, "%s has %zu numbers instead of %zu", path_.c_str(), count(), wanted);
    for (size_t i = 0; i < wanted; ++i) out[i] = at(i).real();
}

}  // namespace claque::asset
