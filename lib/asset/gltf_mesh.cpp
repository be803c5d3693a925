#include "lib/asset/gltf_mesh.h"

#include "lib/asset/gltf_draco.h"
#include "lib/asset/gltf_influences.h"
#include "lib/asset/srgb.h"

namespace claque::asset
{

using base::fail;
using model::Part;

namespace
{

std::vector<glm::vec3> vec3s(const std::vector<float> &values)
{
    std::vector<glm::vec3> out(values.size() / 3);
    for (size_t i = 0; i < out.size(); ++i) out[i] = glm::vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    return out;
}

class PrimitiveReader
{
public:
    PrimitiveReader(File &file, Materials &materials, const JsonView &view)
        : file_(file), materials_(materials), view_(view), attributes_(view["attributes"])
    {
    }

    // True if all data that the primitive names can be read. References are checked in any case.
    bool has_data() const
    {
        const JsonView indices = view_["indices"];
        const uint32_t index_view =
            indices.exists() ? file_.accessors.at(file_.accessors.reference(indices)).view : none;
        if (index_view != none && file_.buffers.view(index_view).stride)
            fail(CLQ_FORMAT, "%s reads a buffer view with a byteStride", indices.path().c_str());
        const auto there = [&](const JsonView &view) {
            return !view.exists() || file_.accessors.has_data(file_.accessors.reference(view));
        };
        const auto all_there = [&](const JsonView &attributes) {
            for (const auto &member : attributes.object().items())
                if (!there(attributes[member.key().c_str()])) return false;
            return true;
        };
        bool good = all_there(attributes_) && there(indices);
        if (DracoPrimitive::is_packed(file_, view_)) good = good && packed_is_there();
        for (size_t i = 0; i < view_["targets"].count(); ++i) good = all_there(view_["targets"].at(i)) && good;
        return good;
    }

    // False if there is nothing to show: primitives without positions are legal and empty.
    bool read(Primitive &out)
    {
        attributes_.object();
        Part &part = out.part;
        part.topology = static_cast<model::Topology>(view_["mode"].integer_or(4, 0, 6));
        part.material = materials_.reference(view_["material"]);
        if (!attributes_["POSITION"].exists()) {
            file_.warn(base::text_of("%s has no positions: left out", view_.path().c_str()));
            return false;
        }
        const DracoPrimitive unpacked(file_, view_);
        part.positions = vec3s(attribute("POSITION", 3));
        if (attributes_["NORMAL"].exists()) part.normals = vec3s(attribute("NORMAL", 3));
        read_uvs(part);
        read_colours(part);
        read_indices(part);
        read_targets(part);
        out.has_joints = read_influences(file_, attributes_, part);
        return true;
    }

private:
    bool packed_is_there() const
    {
        const JsonView view = view_["extensions"]["KHR_draco_mesh_compression"]["bufferView"];
        return file_.buffers.has_data(view.index(file_.buffers.view_count(), "buffer view"));
    }

    std::vector<float> attribute(const char *name, uint32_t width) const
    {
        const JsonView view = attributes_[name];
        std::vector<float> out = file_.accessors.floats(file_.accessors.reference(view), width, view.path());
        check_count(out.size() / width, view);
        return out;
    }

    void check_count(size_t count, const JsonView &view) const
    {
        const size_t vertices = file_.accessors.at(file_.accessors.reference(attributes_["POSITION"])).count;
        if (count != vertices)
            fail(CLQ_FORMAT, "%s has %zu elements, the primitive has %zu positions", view.path().c_str(), count,
                 vertices);
    }

    void read_uvs(Part &part)
    {
        const UvUse use = materials_.uv_use(part.material);
        if (!use.has_texture) return;
        const std::string name = "TEXCOORD_" + std::to_string(use.set);
        if (!attributes_[name.c_str()].exists()) {
            file_.warn(base::text_of("%s lacks the %s that its texture asks for: shown without the texture",
                                     view_.path().c_str(), name.c_str()));
            part.material = materials_.without_texture(part.material);
            return;
        }
        const std::vector<float> values = attribute(name.c_str(), 2);
        part.uvs.resize(values.size() / 2);
        for (size_t i = 0; i < part.uvs.size(); ++i)
            part.uvs[i] = use.transform.applied(glm::vec2(values[2 * i], values[2 * i + 1]));
    }

    void read_colours(Part &part) const
    {
        const JsonView view = attributes_["COLOR_0"];
        if (!view.exists()) return;
        const bool opaque = file_.accessors.at(file_.accessors.reference(view)).width == 3;
        const uint32_t width = opaque ? 3 : 4;
        const std::vector<float> values = attribute("COLOR_0", width);
        part.colours.resize(values.size() / width);
        for (size_t i = 0; i < part.colours.size(); ++i) {
            const float *c = &values[width * i];
            part.colours[i] = {byte_of(encoded(c[0])), byte_of(encoded(c[1])), byte_of(encoded(c[2])),
                               opaque ? uint8_t(255) : byte_of(c[3])};
        }
    }

    void read_indices(Part &part) const
    {
        const JsonView view = view_["indices"];
        if (!view.exists()) return;
        part.indices = file_.accessors.integers(file_.accessors.reference(view), 1, view.path());
        for (size_t i = 0; i < part.indices.size(); ++i)
            if (part.indices[i] >= part.positions.size())
                fail(CLQ_FORMAT, "%s: index number %zu is %u, the primitive has %zu vertices", view.path().c_str(), i,
                     part.indices[i], part.positions.size());
    }

    std::vector<glm::vec3> deltas(const JsonView &view) const
    {
        if (!view.exists()) return {};
        const std::vector<float> values = file_.accessors.floats(file_.accessors.reference(view), 3, view.path());
        check_count(values.size() / 3, view);
        return vec3s(values);
    }

    void read_targets(Part &part) const
    {
        const JsonView targets = view_["targets"];
        for (size_t i = 0; i < targets.count(); ++i) {
            const JsonView target = targets.at(i);
            target.object();
            if (target["NORMAL"].exists() && part.normals.empty())
                fail(CLQ_FORMAT, "%s.NORMAL moves normals that the primitive does not have", target.path().c_str());
            part.morphs.push_back({deltas(target["POSITION"]), deltas(target["NORMAL"])});
        }
    }

    File &file_;
    Materials &materials_;
    const JsonView view_, attributes_;
};

// The names of morph targets, where exporters write them. Other members of extras may be anything.
void read_target_names(const JsonView &extras, Part &part)
{
    if (!extras.is_object()) return;
    const auto names = extras.object().find("targetNames");
    if (names == extras.object().end() || !names->is_array()) return;
    for (size_t i = 0; i < std::min(part.morphs.size(), names->size()); ++i)
        if ((*names)[i].is_string()) part.morphs[i].name = (*names)[i].get<std::string>();
}

void read_weights(const JsonView &view, Mesh &mesh)
{
    const JsonView weights = view["weights"];
    mesh.morph_weights.assign(mesh.target_count, 0);
    if (!weights.exists()) return;
    if (weights.count() != mesh.target_count)
        fail(CLQ_FORMAT, "%s has %zu numbers for %u morph targets", weights.path().c_str(), weights.count(),
             mesh.target_count);
    weights.numbers(mesh.morph_weights.data(), mesh.target_count);
}

Mesh read_mesh(const JsonView &view, File &file, Materials &materials, bool shown)
{
    Mesh mesh;
    view.object();
    mesh.name = view["name"].text_or("");
    const JsonView primitives = view["primitives"];
    if (!primitives.exists()) fail(CLQ_FORMAT, "%s is missing", primitives.path().c_str());
    for (size_t i = 0; i < primitives.count(); ++i) {
        const JsonView primitive_view = primitives.at(i);
        const size_t targets = primitive_view["targets"].count();
        if (i > 0 && targets != mesh.target_count)
            fail(CLQ_FORMAT, "%s has %zu morph targets, the primitive before it has %u", primitive_view.path().c_str(),
                 targets, mesh.target_count);
        if (targets > 0xffff)
            fail(CLQ_LIMIT, "%s has %zu morph targets: 65535 are the most", primitive_view.path().c_str(), targets);
        mesh.target_count = static_cast<uint32_t>(targets);
        Primitive primitive;
        PrimitiveReader reader(file, materials, primitive_view);
        if (!reader.has_data() && !shown) continue;
        if (!reader.read(primitive)) continue;
        materials.note_variants(primitive.part.material, primitive_view);
        read_target_names(view["extras"], primitive.part);
        file.budget.charge(bytes_of(primitive.part), primitive_view.path().c_str());
        mesh.primitives.push_back(std::move(primitive));
    }
    read_weights(view, mesh);
    return mesh;
}

}  // namespace

uint64_t bytes_of(const Part &part)
{
    uint64_t names = 0, floats = 3 * (part.positions.size() + part.normals.size()) + 2 * part.uvs.size() +
                                 part.colours.size() + part.indices.size() + part.joints.size() + part.weights.size();
    for (const model::MorphTarget &target : part.morphs)
        floats += 3 * (target.positions.size() + target.normals.size()), names += target.name.size();
    return sizeof(Part) + part.morphs.size() * sizeof(model::MorphTarget) + names + 4 * floats;
}

std::vector<Mesh> read_meshes(File &file, Materials &materials, const std::vector<bool> &shown)
{
    const JsonView list = file.root["meshes"];
    std::vector<Mesh> meshes;
    meshes.reserve(list.count());
    for (size_t i = 0; i < list.count(); ++i) meshes.push_back(read_mesh(list.at(i), file, materials, shown[i]));
    return meshes;
}

}  // namespace claque::asset
