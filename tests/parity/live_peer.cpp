#include "tests/parity/live_peer.h"

#include "samples/scenes/check.h"

namespace parity_test
{

LivePeer::LivePeer(const contexts::Offscreen &context, const std::string &folder, const clq_view *view)
    : scene_(read_scene(folder))
{
    peer_.emplace(context, scene_);
    for (size_t row = 0; row < scene_.individuals.size(); ++row) row_[scene_.individuals[row].actor] = row;
    const Json &meshes = scene_.json.at("meshes");
    std::map<const clq_template *, uint32_t> numbers;
    clq_view_stats stats = clq_view_stats_init();
    scenes::check(clq_view_get_stats(view, &stats));
    for (uint32_t i = 0; i < stats.visible; ++i) {
        clq_drawn_actor shown = clq_drawn_actor_init();
        scenes::check(clq_view_get_drawn_actor(view, i, &shown));
        const auto known = row_.find(shown.actor.index1);
        if (known != row_.end())
            numbers[shown.tmpl] = meshes.at(scene_.individuals[known->second].mesh).at("template").get<uint32_t>();
    }
    for (const auto &[tmpl, number] : numbers)
        for (uint32_t i = 0; i < meshes.size(); ++i)
            if (meshes[i].at("template") == number)
                mesh_[{tmpl, meshes[i].at("level").get<uint32_t>(), meshes[i].at("texture_set").get<uint32_t>()}] = i;
}

void LivePeer::begin()
{
    peer_->begin(What::colour);
    peer_->gl().Finish();
}

void LivePeer::draw(const clq_view *view)
{
    clq_view_stats stats = clq_view_stats_init();
    scenes::check(clq_view_get_stats(view, &stats));
    for (uint32_t i = 0; i < stats.visible; ++i) {
        clq_drawn_actor shown = clq_drawn_actor_init();
        scenes::check(clq_view_get_drawn_actor(view, i, &shown));
        if (shown.shadow_only) continue;
        const auto row = row_.find(shown.actor.index1);
        const auto mesh = mesh_.find({shown.tmpl, shown.level, shown.texture_set});
        if (row == row_.end() || mesh == mesh_.end())
            throw Failure("actor " + std::to_string(shown.actor.index1) + " was not exported");
        columns_.resize(12 * static_cast<size_t>(shown.joint_count));
        rows_.resize(columns_.size());
        weights_.resize(shown.morph_weight_count);
        scenes::check(clq_view_get_palette(view, i, columns_.data(), shown.joint_count));
        scenes::check(clq_view_get_morph_weights(view, i, weights_.data(), shown.morph_weight_count));
        for (size_t joint = 0; joint < columns_.size(); joint += 12)
            for (size_t k = 0; k < 12; ++k) rows_[joint + k] = columns_[joint + 3 * (k % 4) + k / 4];
        Individual person;
        person.actor = shown.actor.index1;
        person.mesh = mesh->second;
        person.palette_count = shown.joint_count;
        person.mirrored = shown.mirrored != 0;
        std::copy(std::begin(shown.model_view), std::end(shown.model_view), person.model_view.begin());
        peer_->draw(person, row->second, rows_.data(), weights_.data());
    }
    peer_->gl().Finish();
}

}  // namespace parity_test
