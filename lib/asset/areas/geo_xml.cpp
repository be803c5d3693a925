// JuPedSim's old geometry, which JPSreport files come with: walls of rooms, and obstacles in them.
#include <cmath>

#include "lib/asset/areas/area_readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/asset/trajectories/xml.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

class GeometryReader : public XmlHandler
{
public:
    explicit GeometryReader(AreaBuilder &out) : out_(out) {}

    void begin(std::string_view name, const char *const *attributes, uint32_t depth, uint32_t line) override
    {
        if (depth == 1 && name != "geometry")
            fail(CLQ_FORMAT, "line %u: the root element is <%.60s>: <geometry> of JuPedSim is wanted", line,
                 std::string(name).c_str());
        if (depth == 1) read_unit(attribute(attributes, "unit"), line);
        if (name == "obstacle") in_obstacle_ = true;
        if (name == "polygon") ring_.clear();
        if (name == "vertex") ring_.push_back({coordinate(attributes, "px", line), coordinate(attributes, "py", line)});
    }

    void end(std::string_view name, uint32_t) override
    {
        if (name == "obstacle") in_obstacle_ = false;
        if (name == "polygon") end_polygon();
        if (name == "subroom") end_room();
    }

private:
    void read_unit(const char *unit, uint32_t line)
    {
        const std::string_view text = unit ? unit : "m";
        if (text == "cm") unit_m_ = 0.01;
        else if (text != "m")
            fail(CLQ_FORMAT, "line %u: the unit is %s: m and cm are known", line, in_quotes(text).c_str());
    }

    double coordinate(const char *const *attributes, const char *name, uint32_t line) const
    {
        const char *text = attribute(attributes, name);
        double value = 0;
        if (!text || !read_number(trimmed(text), value) || !(std::fabs(value) <= 1e9))
            fail(CLQ_FORMAT, "line %u: a vertex has %s instead of a number %s", line,
                 in_quotes(text ? text : "").c_str(), name);
        return value * unit_m_;
    }

    void end_polygon()
    {
        const bool closed = ring_.size() > 3 && ring_.front().x == ring_.back().x && ring_.front().y == ring_.back().y;
        if (in_obstacle_) obstacles_.push_back(ring_);
        else if (closed) rooms_.push_back(ring_);
        else open_.push_back(ring_);
        ring_.clear();
    }

    // Obstacles belong to the first closed wall of their room.
    void end_room()
    {
        for (size_t i = 0; i < rooms_.size(); ++i) {
            std::vector<Ring> rings{rooms_[i]};
            if (i == 0) rings.insert(rings.end(), obstacles_.begin(), obstacles_.end());
            out_.add_polygon(rings);
        }
        if (rooms_.empty()) open_.insert(open_.end(), obstacles_.begin(), obstacles_.end());
        for (const Ring &wall : open_)
            for (size_t i = 1; i < wall.size(); ++i) {
                const uint32_t from = out_.add_point(wall[i - 1]);
                out_.add_wall(from, out_.add_point(wall[i]));
            }
        if (!open_.empty())
            out_.warn(base::text_of("a room has %zu walls that do not close: they enclose no ground", open_.size()));
        rooms_.clear(), obstacles_.clear(), open_.clear();
    }

    AreaBuilder &out_;
    double unit_m_ = 1;
    bool in_obstacle_ = false;
    Ring ring_;
    std::vector<Ring> rooms_, obstacles_, open_;
};

}  // namespace

void read_geo_xml(const uint8_t *bytes, size_t size, AreaBuilder &out)
{
    Budget budget(uint64_t(1) << 30);
    budget.add_input(size);
    GeometryReader reader(out);
    read_xml(bytes, size, budget, reader);
}

}  // namespace claque::asset
