#include "lib/scene/chosen.h"

#include <algorithm>

namespace claque::scene
{

using model::none;

Chosen::Chosen(const Scene &scene, const crowd::Crowd &crowd, const Filter &filter)
    : scene_(scene), any_of_(filter.any_of), none_of_(filter.none_of), most_(scene.known_.count())
{
    need(scene.known_);
    const auto need_one = [this](const model::Array<base::Bitmap> &all, uint32_t i) {
        if (i < all.size()) need(all[i]);
        else most_ = 0;
    };
    if (filter.tmpl) {
        const base::Span<const model::Template *const> templates = crowd.templates();
        need_one(scene.templates_,
                 static_cast<uint32_t>(std::find(templates.begin(), templates.end(), filter.tmpl) - templates.begin()));
    }
    if (filter.texture_set != none) need_one(scene.texture_sets_, filter.texture_set);
    if (filter.level != none) need_one(scene.levels_, filter.level);
    for (uint64_t left = filter.all_of; left != 0; left &= left - 1)
        need_one(scene.categories_, base::lowest_bit(left));
    if (any_of_ == 0) return;
    uint64_t sum = 0;
    for (uint64_t left = any_of_; left != 0; left &= left - 1)
        if (const base::Bitmap *one = category(base::lowest_bit(left))) sum += one->count();
    most_ = static_cast<uint32_t>(std::min<uint64_t>(most_, sum));
}

void Chosen::need(const base::Bitmap &part)
{
    needed_[needed_count_++] = &part;
    most_ = std::min(most_, part.count());
}

const base::Bitmap *Chosen::category(uint32_t i) const
{
    return i < scene_.categories_.size() ? &scene_.categories_[i] : nullptr;
}

uint64_t Chosen::filled(uint32_t k) const
{
    uint64_t bits = most_ > 0 ? ~uint64_t(0) : 0;
    for (uint32_t i = 0; i < needed_count_; ++i) bits &= needed_[i]->filled(k);
    if (any_of_ == 0 || bits == 0) return bits;
    uint64_t any = 0;
    for (uint64_t left = any_of_; left != 0; left &= left - 1)
        if (const base::Bitmap *one = category(base::lowest_bit(left))) any |= one->filled(k);
    return bits & any;
}

uint64_t Chosen::word(uint32_t at) const
{
    uint64_t bits = most_ > 0 ? ~uint64_t(0) : 0;
    for (uint32_t i = 0; i < needed_count_; ++i) bits &= needed_[i]->word(at);
    if (any_of_ != 0) {
        uint64_t any = 0;
        for (uint64_t left = any_of_; left != 0; left &= left - 1)
            if (const base::Bitmap *one = category(base::lowest_bit(left))) any |= one->word(at);
        bits &= any;
    }
    for (uint64_t left = none_of_; left != 0; left &= left - 1)
        if (const base::Bitmap *one = category(base::lowest_bit(left))) bits &= ~one->word(at);
    return bits;
}

}  // namespace claque::scene
