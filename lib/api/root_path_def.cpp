// Checks and copies the description of a root path.
#include <cmath>

#include "lib/api/behave_def.h"
#include "lib/api/boundary.h"
#include "lib/behave/behave.h"

namespace claque::api
{

using base::fail;

namespace
{

// Keys with rotations, and the first key again at the end of the loop.
void add_table(const clq_root_path_def &def, crowd::RootPath &path)
{
    path.flight = false;
    for (uint32_t i = 0; i < def.count; ++i) {
        const float *q = def.rotations_xyzw + 4 * size_t(i), time = def.times_s[i];
        double square = 0;
        for (int k = 0; k < 4; ++k) square += double(q[k]) * double(q[k]);
        const double length = std::sqrt(square);
        if (!(std::fabs(length - 1) <= 1e-3))
            fail(CLQ_ARGUMENT, "key %u of the path has a rotation of length %g instead of 1", i, length);
        const bool ascends = i == 0 ? time == 0 : time > def.times_s[i - 1];
        if (!ascends || !(time <= def.duration_s))
            fail(CLQ_ARGUMENT, "key %u of the path is at %g s: they ascend from 0 to at most duration_s, %g", i,
                 double(time), double(def.duration_s));
        path.times_s.push_back(time);
        path.rotations.push_back(glm::quat(q[3], q[0], q[1], q[2]));
    }
    if (path.times_s.back() < def.duration_s) {
        path.times_s.push_back(def.duration_s);
        path.rotations.push_back(glm::quat(path.rotations.front()));
        path.positions.push_back(glm::vec3(path.positions.front()));
        return;
    }
    const glm::quat &p = path.rotations.front(), &q = path.rotations.back();
    const double cosine =
        double(p.w) * double(q.w) + double(p.x) * double(q.x) + double(p.y) * double(q.y) + double(p.z) * double(q.z);
    if (path.positions.front() != path.positions.back() || !(std::fabs(cosine) > 0.999))
        fail(CLQ_ARGUMENT, "key %u of the path ends the lap at %g s, and is not where key 0 is", def.count - 1,
             double(def.duration_s));
    path.rotations.back() = path.rotations.front();
}

}  // namespace

crowd::RootPath path_of(const clq_root_path_def &def, std::pmr::memory_resource *memory)
{
    if (def.count < 2) fail(CLQ_ARGUMENT, "the path has %u positions: at least 2 are wanted", def.count);
    require_array(def.positions, def.count, "positions");
    require((def.rotations_xyzw != nullptr) == (def.times_s != nullptr),
            "one of rotations_xyzw and times_s is NULL: a table has both, a flight none");
    if (!(def.duration_s > 0) || !std::isfinite(def.duration_s))
        fail(CLQ_ARGUMENT, "duration_s is %g: a finite number of more than 0 is wanted", double(def.duration_s));
    if (!std::isfinite(def.bank)) fail(CLQ_ARGUMENT, "bank is not finite");
    if (!(def.max_bank_rad >= 0 && def.max_bank_rad <= 3.1415927f))
        fail(CLQ_ARGUMENT, "max_bank_rad is %g: 0 to 3.14159 is wanted", double(def.max_bank_rad));
    crowd::RootPath path(memory);
    path.duration_s = def.duration_s;
    path.bank = def.bank, path.max_bank = def.max_bank_rad;
    for (uint32_t i = 0; i < def.count; ++i) {
        const float *p = def.positions + 3 * size_t(i);
        for (int k = 0; k < 3; ++k)
            if (!(std::fabs(p[k]) <= 1e9f))
                fail(CLQ_ARGUMENT, "coordinate %d of position %u of the path is %g: at most 1e9 is wanted", k, i,
                     double(p[k]));
        path.positions.push_back(glm::vec3(p[0], p[1], p[2]));
    }
    if (def.times_s) add_table(def, path);
    path.reach = behave::reach_of(path);
    return path;
}

}  // namespace claque::api
