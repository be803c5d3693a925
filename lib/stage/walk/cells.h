// Places in square cells, to find those near a place.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace claque::walk
{

class Cells
{
public:
    struct Place {
        uint32_t index;
        float x, z;
    };

    // Cells are as wide as the largest reach of `each`, or wider.
    void fill(const std::vector<Place> &places, float reach_m)
    {
        float max_x = 0, max_z = 0;
        min_x_ = min_z_ = 0;
        if (!places.empty()) min_x_ = max_x = places[0].x, min_z_ = max_z = places[0].z;
        for (const Place &one : places) {
            min_x_ = std::min(min_x_, one.x), max_x = std::max(max_x, one.x);
            min_z_ = std::min(min_z_, one.z), max_z = std::max(max_z, one.z);
        }
        size_m_ = std::max(reach_m, std::max(max_x - min_x_, max_z - min_z_) / (max_row - 1));
        columns_ = static_cast<int>((max_x - min_x_) / size_m_) + 1;
        rows_ = static_cast<int>((max_z - min_z_) / size_m_) + 1;
        // Counts, sums, and places in the order of their cells, which keeps the given order within a cell.
        ends_.assign(static_cast<size_t>(columns_ * rows_), 0);
        for (const Place &one : places) ++ends_[cell(one)];
        uint32_t sum = 0;
        for (uint32_t &end : ends_) end += sum, sum = end;
        sorted_.resize(places.size());
        for (size_t k = places.size(); k-- > 0;) sorted_[--ends_[cell(places[k])]] = places[k];
        ends_.push_back(sum);  // each is now the begin of its cell, and so the end of the one before
    }

    // All places within the reach, and some beyond it.
    template <class Use>
    void each(float x, float z, float reach_m, Use &&use) const
    {
        const int c0 = column(x - reach_m), c1 = column(x + reach_m);
        for (int r = row(z - reach_m); r <= row(z + reach_m); ++r) {
            const auto first = static_cast<size_t>(r * columns_ + c0), last = static_cast<size_t>(r * columns_ + c1);
            for (uint32_t k = ends_[first]; k < ends_[last + 1]; ++k) use(sorted_[k]);
        }
    }

private:
    static constexpr int max_row = 256;

    int column(float x) const { return std::clamp(static_cast<int>((x - min_x_) / size_m_), 0, columns_ - 1); }
    int row(float z) const { return std::clamp(static_cast<int>((z - min_z_) / size_m_), 0, rows_ - 1); }
    size_t cell(const Place &one) const { return static_cast<size_t>(row(one.z) * columns_ + column(one.x)); }

    float min_x_ = 0, min_z_ = 0, size_m_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<uint32_t> ends_;
    std::vector<Place> sorted_;
};

}  // namespace claque::walk
