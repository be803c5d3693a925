// TrajNet++: a JSON object a line, scenes and tracks in any order. Scenes are windows on the tracks; only their rate is
// needed.
#include <cmath>

#include "lib/asset/json_view.h"
#include "lib/asset/trajectories/assemble.h"
#include "lib/asset/trajectories/readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr size_t longest_object = 1 << 16;

class TrajnetReader
{
public:
    explicit TrajnetReader(Reading &reading) : reading_(reading) {}

    void read(Lines &lines)
    {
        for (std::string_view line; lines.next(line);) {
            line = trimmed(line);
            if (line.empty()) continue;
            try {
                read_object(line, lines.number());
            } catch (const base::Error &error) {
                if (lines.unfinished() && error.status() == CLQ_FORMAT)
                    ++reading_.rows.read, reading_.rows.missing.add(lines.number());
                else fail(error.status(), "line %u: %s", lines.number(), error.what());
            }
        }
        if (predictions_.count)
            reading_.warnings.push_back("left out " + counted(predictions_.count, "row", "rows") + " of predictions" +
                                        first_of(reading_, predictions_.line));
        reading_.smallest_step_s = fps_ > 0 ? 1 / fps_ : 0;
    }

private:
    void read_object(std::string_view text, uint32_t line)
    {
        if (text.size() > longest_object)
            fail(CLQ_LIMIT, "the object has %zu bytes: %zu are allowed", text.size(), longest_object);
        const JsonDocument document(reinterpret_cast<const uint8_t *>(text.data()), text.size(), 64 * longest_object);
        const JsonView root = document.root();
        if (const JsonView scene = root["scene"]; scene.exists()) return read_scene(scene);
        const JsonView track = root["track"];
        if (!track.exists()) return;  // other kinds of objects may come
        if (track["prediction_number"].exists()) return predictions_.add(line);
        ++reading_.rows.read;
        Row row;
        row.line = line, row.heading_rad = NAN;
        row.time = track["f"].number(), row.x = track["x"].number(), row.y = track["y"].number();
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.15g", track["p"].number());
        row.person = reading_.rows.ids.number_of(digits);
        reading_.rows.add(row);
    }

    void read_scene(const JsonView &scene)
    {
        const JsonView fps = scene["fps"];
        if (!fps.exists()) return;
        const double rate = fps.number();
        if (!(rate > 0 && rate <= 1e6)) fail(CLQ_FORMAT, "fps is %g: more than 0 and at most 1e6 is wanted", rate);
        if (fps_ > 0 && rate != fps_) fail(CLQ_FORMAT, "fps is %g here and %g before", rate, fps_);
        fps_ = rate;
    }

    Reading &reading_;
    double fps_ = 0;
    Tally predictions_;
};

}  // namespace

void read_trajnet(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    Lines lines(input.text());
    reading.frames = true;
    TrajnetReader(reading).read(lines);
}

}  // namespace claque::asset
