// Levels, prepared templates and clips of other skeletons.
#include <claque/levels.h>

#include "tests/bits/bits.h"

namespace bits
{

namespace
{

// A recording of joints that bend.
const char recording[] =
    "HIERARCHY\nROOT pelvis\n{\nOFFSET 0 95 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "JOINT spine\n{\nOFFSET 0 9 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT chest\n{\nOFFSET 0 22 0\n"
    "CHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 19 0\n}\n}\n}\n"
    "JOINT thigh_l\n{\nOFFSET 9 -2.5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT shin_l\n{\nOFFSET 0 -43 0.4\n"
    "CHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 -40 0\n}\n}\n}\n}\n"
    "MOTION\nFrames: 4\nFrame Time: 0.2\n"
    "0 95 0 1 2 3 4 5 6 7 8 9 10 -31 12 3 45 6\n1 94 3 11 2 33 14 5 -6 27 8 -9 30 -11 2 13 65 6\n"
    "2 93 6 21 12 83 4 25 6 -7 18 19 10 -51 22 -13 25 9\n3 95 9 31 2 103 4 5 36 7 8 29 20 -21 12 3 5 16\n";

void print_saved(const std::string &name, const clq_template *tmpl)
{
    Hash saved;
    check(clq_template_save(tmpl, Hash::write, &saved));
    print(name, saved);
}

void print_with_clips(clq_context *context, const std::string &name, const clq_asset *source, const clq_clips_def &def)
{
    clq_asset *asset;
    clq_template *tmpl;
    check(clq_asset_builtin(context, "plebeian", &asset));
    check(clq_asset_add_clips(context, asset, source, &def, nullptr));
    check(clq_asset_build(context, asset, 0, &tmpl));
    print_saved(name, tmpl);
    clq_template_destroy(tmpl), clq_asset_destroy(asset);
}

}  // namespace

void levels(clq_context *context)
{
    for (const char *name : people) {
        clq_asset *asset;
        clq_template *tmpl;
        check(clq_asset_builtin(context, name, &asset));
        check(clq_asset_make_levels(context, asset, nullptr, nullptr));
        check(clq_asset_build(context, asset, 0, &tmpl));
        print_saved(std::string("levels.") + name, tmpl);
        clq_template_destroy(tmpl), clq_asset_destroy(asset);
    }
}

void templates(clq_context *context)
{
    for (const char *name : {"citizen", "patrician", "decurion", "plebeian", "herald", "owl"}) {
        clq_template *tmpl = built(context, name);
        print_saved(std::string("template.") + name, tmpl);
        clq_template_destroy(tmpl);
    }
    clq_asset *varied;
    clq_template *tmpl;
    check(clq_asset_builtin_varied(context, "decurion", 60, &varied));
    check(clq_asset_build(context, varied, 0, &tmpl));
    print_saved("template.varied", tmpl);
    clq_template_destroy(tmpl), clq_asset_destroy(varied);

    clq_asset *source;
    clq_clips_def def = clq_clips_def_init();
    const char *const names[] = {"jog", "sit_talk", "turn"};
    def.clips = names, def.clip_count = 3, def.prefix = "other_", def.mode = CLQ_RETARGET_MOTION, def.close_s = 0.2f;
    check(clq_asset_builtin(context, "patrician", &source));
    print_with_clips(context, "retargeted.person", source, def);
    clq_asset_destroy(source);

    const clq_joint_pair joints[] = {{"pelvis", "pelvis", CLQ_REST_KEEP},  {"spine", "spine", CLQ_REST_ALIGN},
                                     {"chest", "chest", CLQ_REST_ALIGN},   {"thigh_l", "thigh_l", CLQ_REST_ALIGN},
                                     {"shin_l", "shin_l", CLQ_REST_ALIGN}, {"thigh_l", "thigh_r", CLQ_REST_KEEP},
                                     {"shin_l", "shin_r", CLQ_REST_ALIGN}};
    const clq_follower followers[] = {{"skirt_front_l", "thigh_l", 0.6f}, {"skirt_back_l", "thigh_l", 0.4f}};
    clq_asset_options options = clq_asset_options_init();
    check(clq_asset_load(context, recording, sizeof recording - 1, &options, &source));
    def = clq_clips_def_init();
    def.joints = joints, def.joint_count = 7, def.mode = CLQ_RETARGET_MOTION, def.travel = CLQ_ROOT_TRAVEL_KEEP;
    def.followers = followers, def.follower_count = 2, def.rate_hz = 24;
    print_with_clips(context, "retargeted.recording", source, def);
    clq_asset_destroy(source);
}

}  // namespace bits
