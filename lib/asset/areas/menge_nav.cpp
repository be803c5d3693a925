// Menge's navigation meshes: vertices, edges, obstacles, then groups of nodes, each a polygon on a plane.
#include <charconv>
#include <cmath>

#include "lib/asset/areas/area_readers.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

struct Obstacle {
    uint32_t from = 0, to = 0, node = 0;
};

class NavReader
{
public:
    NavReader(std::string_view text, AreaBuilder &out) : text_(text), out_(out) {}

    void read()
    {
        const uint32_t vertices = count("vertices");
        for (uint32_t i = 0; i < vertices; ++i) vertices_.push_back(point("a vertex"));
        const uint32_t edges = count("edges");
        for (uint32_t i = 0; i < edges; ++i) {
            (void)vertex(), (void)vertex();
            (void)whole("a node", most), (void)whole("a node", most);
        }
        const uint32_t obstacles = count("obstacles");
        for (uint32_t i = 0; i < obstacles; ++i) {
            Obstacle obstacle;
            obstacle.from = vertex(), obstacle.to = vertex();
            obstacle.node = static_cast<uint32_t>(whole("a node", most));
            (void)number("the next obstacle");
            obstacles_.push_back(obstacle);
        }
        while (!at_end()) {
            (void)word();  // the group's name
            const uint32_t nodes = count("nodes of a group");
            for (uint32_t i = 0; i < nodes; ++i) read_node();
        }
        for (const Obstacle &obstacle : obstacles_) add_obstacle(obstacle);
    }

private:
    static constexpr uint32_t most = 1u << 30;

    struct Node {
        Plane plane;
        std::vector<uint32_t> corners;  // vertices
    };

    bool at_end()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || (text_[at_] >= '\t' && text_[at_] <= '\r')))
            line_ += text_[at_++] == '\n';
        return at_ >= text_.size();
    }

    std::string_view word()
    {
        (void)at_end();
        const size_t end = std::min(text_.find_first_of(" \t\r\n\v\f", at_), text_.size());
        const std::string_view out = text_.substr(at_, end - at_);
        at_ = end;
        return out;
    }

    double number(const char *what)
    {
        const std::string_view text = word();
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !(std::fabs(value) <= 1e9))
            fail(CLQ_FORMAT, "line %u: '%.40s' instead of %s", line_, std::string(text).c_str(), what);
        return value;
    }

    uint64_t whole(const char *what, uint64_t below)
    {
        const double value = number(what);
        if (!(value >= 0 && value < double(below)) || value != std::floor(value))
            fail(CLQ_FORMAT, "line %u: %s is %g: a whole number below %llu is wanted", line_, what, value,
                 base::big(below));
        return static_cast<uint64_t>(value);
    }

    // Each thing takes two bytes at least, a digit and a blank: a count that the file cannot hold is refused.
    uint32_t count(const char *what)
    {
        const uint64_t value = whole(what, most);
        if (value > (text_.size() - at_) / 2)
            fail(CLQ_FORMAT, "line %u: %llu %s are more than the file can hold", line_, base::big(value), what);
        return static_cast<uint32_t>(value);
    }

    uint32_t vertex() { return static_cast<uint32_t>(whole("a vertex", vertices_.size())); }

    Point point(const char *what)
    {
        Point out;
        out.x = number(what), out.y = number(what);
        return out;
    }

    void read_node()
    {
        Node node;
        (void)point("a node's centre");
        const uint32_t corners = count("corners");
        if (corners > 256) fail(CLQ_LIMIT, "line %u: a node of %u corners: 256 are allowed", line_, corners);
        Ring ring;
        for (uint32_t i = 0; i < corners; ++i) {
            node.corners.push_back(vertex());
            ring.push_back(vertices_[node.corners.back()]);
        }
        node.plane.a = number("a plane"), node.plane.b = number("a plane"), node.plane.c = number("a plane");
        for (const char *what : {"edges of a node", "obstacles of a node"}) {
            const uint32_t refs = count(what);
            for (uint32_t i = 0; i < refs; ++i) (void)whole(what, most);
        }
        out_.add_polygon({ring}, node.plane, false);
        nodes_.push_back(std::move(node));
    }

    void add_obstacle(const Obstacle &obstacle)
    {
        if (obstacle.node >= nodes_.size())
            fail(CLQ_FORMAT, "an obstacle belongs to node %u: there are %zu", obstacle.node, nodes_.size());
        const Plane &plane = nodes_[obstacle.node].plane;
        const uint32_t from = out_.add_point(vertices_[obstacle.from], plane);
        out_.add_wall(from, out_.add_point(vertices_[obstacle.to], plane));
    }

    std::string_view text_;
    size_t at_ = 0;
    uint32_t line_ = 1;
    AreaBuilder &out_;
    std::vector<Point> vertices_;
    std::vector<Obstacle> obstacles_;
    std::vector<Node> nodes_;
};

}  // namespace

void read_menge_nav(std::string_view text, AreaBuilder &out) { NavReader(text, out).read(); }

}  // namespace claque::asset
