// Where a command line names a file that is read.
#pragma once

namespace cli_test
{

// `words` follow the command: @ is the name that leads elsewhere, with an ending; $ begins a name in the test's folder.
// The option is the word before @, unless `argument` names one without dashes.
struct Named {
    const char *command, *words, *argument;
};

constexpr Named all_named[] = {
    {"render", "@.glb --out $x.png", "FILE"},
    {"render", "@.clq --out $x.png", "FILE"},
    {"render", "--out $x.png --scenario @.toml", ""},
    {"render", "--out $x.png --path @.toml", ""},
    {"render", "--out $x.png --colours @.toml", ""},
    {"render", "citizen --out $x.png --clips @.bvh", ""},
    {"render", "citizen --out $x.png --clips $x.bvh --map @.toml", ""},
    {"render", "--out $x-%d.png --frames 0:1 --manifest @.json", ""},
    {"sheet", "--out $x.png --scenario @.toml", ""},
    {"sheet", "--out $x.png --path @.toml", ""},
    {"sheet", "--out $x.png --colours @.toml", ""},
    {"inspect", "@.glb", "FILE"},
    {"inspect", "@.clq", "FILE"},
    {"inspect", "@.bvh", "FILE"},
    {"inspect", "citizen --clips @.bvh", ""},
    {"inspect", "citizen --clips $x.bvh --map @.toml", ""},
    {"dump", "@.glb --out $x.npy", "FILE"},
    {"dump", "citizen --out $x.npy --clips @.bvh", ""},
    {"dump", "citizen --out $x.npy --clips $x.bvh --map @.toml", ""},
    {"split", "@.glb", "FILE"},
    {"split", "@.clq", "FILE"},
    {"variety", "@.glb --out $x.png", "FILE"},
    {"variety", "citizen --out $x.png --colours @.toml", ""},
    {"colours classes", "--out $x.png --colours @.toml", ""},
    {"colours compare", "--out $x.png --colours @.toml", ""},
    {"colours save", "@.toml --out $x.toml", "FROM"},
    {"colours save", "@.glb --out $x.toml", "FROM"},
    {"colours save", "--out $x.toml --scenario @.toml", ""},
    {"lods", "@.glb", "FILE"},
    {"lods", "citizen --picture $x.png --colours @.toml", ""},
    {"blend", "@.glb --out $x.png", "FILE"},
    {"blend", "citizen --out $x.png --clips @.bvh", ""},
    {"blend", "citizen --out $x.png --clips $x.bvh --map @.toml", ""},
    {"prepare", "@.glb --out $x.clq", "FILE"},
    {"prepare", "citizen --out $x.clq --clips @.bvh", ""},
    {"prepare", "citizen --out $x.clq --clips $x.bvh --map @.toml", ""},
    {"prepare", "citizen --out $x.clq --zones @.png", ""},
    {"convert", "@.obj --out $x.glb", "FILE"},
    {"convert", "$o.obj --out $x.glb --picture @.png", ""},
    {"bench", "@.glb --frames 1 --count 1", "SCENE"},
    {"bench", "@.csv --frames 1", "SCENE"},
    {"bench", "--frames 1 --count 1 --scenario @.toml", ""},
    {"bench", "odeon --frames 1 --path @.toml", ""},
    {"bench", "plaza --frames 1 --count 1 --colours @.toml", ""},
    {"bench", "$few.csv --columns id,frame,x,y --rate 1 --unit m --frames 1 --ground @.wkt", ""},
    {"bench", "$few.csv --columns id,frame,x,y --rate 1 --unit m --frames 1 --characters @.glb", ""},
    {"plot", "@.json --out $x.svg", "FILE"},
    {"cost", "--measured @.json", ""},
    {"parity export", "@.glb --out $x", "SCENE"},
    {"parity export", "--out $x --scenario @.toml", ""},
    {"parity export", "plaza --out $x --path @.toml", ""},
    {"parity export", "plaza --out $x --colours @.toml", ""},
    {"parity export", "citizen --out $x --clips @.bvh", ""},
    {"parity export", "citizen --out $x --clips $x.bvh --map @.toml", ""},
    {"parity capture", "@.glb --out $x", "SCENE"},
    {"parity capture", "--out $x --scenario @.toml", ""},
    {"parity capture", "plaza --out $x --path @.toml", ""},
    {"parity capture", "plaza --out $x --colours @.toml", ""},
    {"parity capture", "citizen --out $x --clips @.bvh", ""},
    {"parity capture", "citizen --out $x --clips $x.bvh --map @.toml", ""},
    {"parity compare", "$folders/@ $folders/@", "REFERENCE"},
    {"parity compare", "$folders/@ $folders/@", "RESULT"},
    {"parity compare", "$x $x --tolerance @.toml", ""},
    {"tracks", "@.csv", "FILE"},
    {"tracks", "@.clt", "FILE"},
    {"tracks", "$few.csv --columns id,frame,x,y --rate 1 --unit m --measure $x.csv --area @.wkt", ""},
    {"tracks", "$few.csv --columns id,frame,x,y --rate 1 --unit m --characters @.glb", ""},
    {"play", "@.csv --out $x.png --time 0", "FILE"},
    {"play", "@.clt --out $x.png --time 0", "FILE"},
    {"play", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x.png --time 0 --characters @.glb", ""},
    {"play", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x.png --time 0 --clips @.bvh", ""},
    {"play", "$few.csv --columns id,frame,x,y --unit m --out $x.png --time 0 --clips $x.bvh --map @.toml", ""},
    {"play", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x.png --time 0 --ground @.wkt", ""},
    {"play", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x.png --time 0 --path @.toml", ""},
    {"play", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x.png --time 0 --colours @.toml", ""},
    {"play", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x-%d.png --frames 0:1 --manifest @.json", ""},
    {"play", "$x.clt --out $x.png --time 0 --scenario @.toml", ""},
    {"frames check", "$folders/@", "DIR"},
    {"labels", "@.toml --out $x", "what"},
    {"labels", "@.csv --out $x", "what"},
    {"labels", "@.clt --out $x", "what"},
    {"labels", "--out $x --scenario @.toml", ""},
    {"labels", "--out $x --path @.toml", ""},
    {"labels", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x --characters @.glb", ""},
    {"labels", "$few.csv --columns id,frame,x,y --rate 1 --unit m --out $x --ground @.wkt", ""},
    {"labels", "--out $x --colours @.toml", ""},
    {"labels", "--out $x --vary @.toml", ""},
    {"labels", "--out $x --keypoints @.toml", ""},
    {"view", "@.glb --script $steps.toml", "FILE"},
    {"view", "@.toml --script $steps.toml", "FILE"},
    {"view", "@.csv --script $steps.toml", "FILE"},
    {"view", "--script $steps.toml --scenario @.toml", ""},
    {"view", "citizen --script $steps.toml --clips @.bvh", ""},
    {"view", "citizen --script $steps.toml --clips $x.bvh --map @.toml", ""},
    {"view", "$few.csv --columns id,frame,x,y --rate 1 --unit m --script $steps.toml --characters @.glb", ""},
    {"view", "$few.csv --columns id,frame,x,y --rate 1 --unit m --script $steps.toml --ground @.wkt", ""},
    {"view", "--scene plaza --script $steps.toml --path @.toml", ""},
    {"view", "--scene plaza --script $steps.toml --colours @.toml", ""},
    {"view", "--script @.toml", ""},
    {"view", "--serve 127.0.0.1:0 --password-file @", ""},
    {"stage", "@.toml", "SCENARIO"},
    {"stage", "$samples/scenarios/evacuation.toml --seconds 1 --size 32x24 --frames 0:1 --out $x-%d.png --path @.toml",
     ""},
    {"stage", "$samples/scenarios/evacuation.toml --seconds 1 --colours @.toml", ""},
    {"stage", "$samples/scenarios/evacuation.toml --seconds 1 --restore @", ""},
    {"stage", "$samples/scenarios/evacuation.toml --seconds 1 --record $x.clt --measure $x.csv --area @.wkt", ""},
};

// Options that name no file, or one that is written. Some name a file in one command, which is above: --vary of labels,
// --tolerance of parity, --picture of convert. --commands is a stream (docs/stage.md).
constexpr const char *name_nothing_read =
    "--help --scene --count --hide --size --camera --hour --context --format --multisample --rigid-mode "
    "--vertex-format --cache-mib --key-poses --key-pose-rate --lod-scale --flush --flat --blob-from --seed --threads "
    "--reload --strategy --cache --filter --close-textures --close-distance --lod --cull --cull-scale --show "
    "--shadows --time --frames --chunk --portable --stride --fps --samples --again --processes --divide --out "
    "--json --unit --from --to --close --rate --root-travel --clock --operations --most-ratio --least-ms --columns "
    "--up --max-speed --vehicles --markdown --save --fade --length --over --layer --additive --node --gaits "
    "--phases --height --memory --seconds --plot --clip --targets --proxy-max-triangles --compare --record "
    "--texture --texture-set --scale --class --image --propose --zone --reduce --zones-out --texture-size --html "
    "--pixels-per-degree --write --serve --rates --shots --at --commands --apart --in-turn --live --draw --stall "
    "--vary --tolerance --picture --allow-mechanisms --origin --quiet --turn --blend --legs --torso --neck --head "
    "--walk --idle --nodes --colours --measure --line --seeds";

}  // namespace cli_test
