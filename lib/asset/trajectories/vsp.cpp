// UCY's .vsp: for each person a number of control points in pixels from the middle of the film's picture, x right,
// y up. Between them people walk straight.
#include <cmath>

#include "lib/asset/trajectories/readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/base/error.h"
#include "lib/math/trig.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr double film_rate_hz = 25;
constexpr double middle_row = 288, middle_column = 360;  // of a picture of 720 x 576

// From pixels to metres, by a matrix or by a scale that `convert` applies.
class Film
{
public:
    explicit Film(const std::optional<std::array<double, 9>> &matrix) : matrix_(matrix) {}

    void place(double x, double y, double (&out)[2]) const
    {
        out[0] = x, out[1] = y;
        if (!matrix_) return;
        const std::array<double, 9> &m = *matrix_;
        const double row = middle_row - y, column = middle_column + x;
        const double w = m[6] * row + m[7] * column + m[8];
        out[0] = (m[0] * row + m[1] * column + m[2]) / w;
        out[1] = (m[3] * row + m[4] * column + m[5]) / w;
    }

    // Degrees from up in the picture, counter-clockwise, to a heading: where a step of a pixel leads.
    float heading(double x, double y, double degrees) const
    {
        const double turn = std::fmod(degrees, 360.0) * (math::pi / 180);
        double here[2], there[2];
        place(x, y, here);
        place(x - math::sin(turn), y + math::cos(turn), there);
        return static_cast<float>(math::atan2(there[1] - here[1], there[0] - here[0]));
    }

private:
    const std::optional<std::array<double, 9>> &matrix_;
};

class VspReader
{
public:
    VspReader(Lines &lines, const Film &film, Reading &reading) : lines_(lines), film_(film), reading_(reading) {}

    void read()
    {
        const uint64_t people = count("the number of splines");
        for (uint64_t person = 1; person <= people; ++person) {
            const uint64_t points = count("a number of control points");
            const std::string id = std::to_string(person);
            for (uint64_t i = 0; i < points; ++i) read_point(id);
        }
    }

private:
    void next_row(const char *what)
    {
        for (std::string_view line; lines_.next(line);) {
            line = trimmed(line.substr(0, line.find(" - ")));
            if (line.empty()) continue;
            return fields_.split(line, blanks);
        }
        fail(CLQ_FORMAT, "the file ends after line %u, where %s is wanted", lines_.number(), what);
    }

    uint64_t count(const char *what)
    {
        next_row(what);
        double number = 0;
        if (!read_number(fields_[0], number) || !(number >= 0 && number <= 1e9) || number != std::floor(number))
            fail(CLQ_FORMAT, "line %u: %s instead of %s", lines_.number(), in_quotes(fields_[0]).c_str(), what);
        return static_cast<uint64_t>(number);
    }

    void read_point(const std::string &id)
    {
        next_row("a control point");
        double numbers[4] = {};
        for (int i = 0; i < 4; ++i)
            if (!read_number(fields_[i], numbers[i]))
                fail(CLQ_FORMAT, "line %u, column %d: %s instead of a number of x, y, frame, gaze", lines_.number(),
                     i + 1, in_quotes(fields_[i]).c_str());
        Rows &rows = reading_.rows;
        ++rows.read;
        double place[2];
        film_.place(numbers[0], numbers[1], place);
        Row row;
        row.line = lines_.number();
        row.person = rows.ids.number_of(id);
        row.time = numbers[2], row.x = place[0], row.y = place[1];
        row.heading_rad = film_.heading(numbers[0], numbers[1], numbers[3]);
        rows.add(row);
    }

    Lines &lines_;
    const Film &film_;
    Reading &reading_;
    Fields fields_;
};

std::array<double, 9> matrix_of(const std::string &text)
{
    std::array<double, 9> out{};
    size_t count = 0;
    Lines lines(text);
    Fields fields;
    for (std::string_view line; lines.next(line);) {
        fields.split(line, blanks);
        for (int i = 0; i < static_cast<int>(fields.count()); ++i, ++count) {
            double number = 0;
            if (count >= out.size() || !read_number(fields[i], number) || !std::isfinite(number))
                fail(CLQ_FORMAT, "H.txt, line %u: nine numbers are wanted", lines.number());
            out[count] = number;
        }
    }
    if (count != out.size()) fail(CLQ_FORMAT, "H.txt has %zu numbers: nine are wanted", count);
    return out;
}

}  // namespace

void read_vsp(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading)
{
    std::optional<std::array<double, 9>> matrix = options.picture_to_metres;
    const bool scale = options.metres_per_unit > 0;
    if (!matrix && !scale) {
        const std::optional<std::string> text = input.beside ? input.beside() : std::nullopt;
        if (!text)
            fail(CLQ_ARGUMENT,
                 "the file has pixels: put H.txt beside it, or give --unit (metres_per_unit) or "
                 "picture_to_metres");
        matrix = matrix_of(*text);
    }
    if (matrix && scale)
        fail(CLQ_ARGUMENT, "both --unit (metres_per_unit) and picture_to_metres are given: one is wanted");
    Lines lines(input.text());
    reading.frames = true;
    reading.rate_hz = film_rate_hz;
    reading.joined = true;
    const Film film(matrix);
    VspReader(lines, film, reading).read();
}

}  // namespace claque::asset
