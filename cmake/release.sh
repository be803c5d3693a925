#!/bin/sh
# release.sh [--check]: makes a release of the commit that is checked out. It refuses a version that the files do not
# agree on, a changelog whose first section is not that version with its date, and a tree that is not exactly a commit.
# Then it runs the tests and leaves in out/release the sources, the wheel, the packages and their SHA-256 sums. With
# --check it stops before the tests.
set -eu
cd "$(dirname "$0")/.."
refuse() {
    echo "release: $1" >&2
    exit 1
}

version=$(sed -n 's/^project(claque VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
[ -n "$version" ] || refuse "CMakeLists.txt has no line 'project(claque VERSION ...'"
part() { sed -n "s/^#define CLQ_VERSION_$1 \\([0-9]*\\)$/\\1/p" include/claque/base.h; }
agrees() { [ "$2" = "$version" ] || refuse "$1 has version '$2', CMakeLists.txt $version: give both the same"; }
agrees include/claque/base.h "$(part MAJOR).$(part MINOR).$(part PATCH)"
agrees lib/python/pyproject.toml "$(sed -n 's/^version = "\(.*\)"$/\1/p' lib/python/pyproject.toml)"

[ -e CHANGELOG.md ] || refuse "CHANGELOG.md is missing"
first=$(sed -n 's/^## //p' CHANGELOG.md | head -n 1)
case "$first" in
"$version - "[0-9][0-9][0-9][0-9]-[0-1][0-9]-[0-3][0-9]) ;;
*) refuse "CHANGELOG.md begins with section '$first': name it '$version - $(date +%F)', or give the files its version" ;;
esac
[ "$(grep -c "^## $version - " CHANGELOG.md)" = 1 ] || refuse "CHANGELOG.md has two sections $version: raise the version \
in CMakeLists.txt, include/claque/base.h and lib/python/pyproject.toml"

[ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ] || refuse "$(pwd -P) is no clone of the repository"
commit=$(git rev-parse --verify --quiet HEAD) || refuse "$(pwd -P) has no commit yet"
changed=$(git status --porcelain)
[ -z "$changed" ] || refuse "$(echo "$changed" | wc -l) files differ from commit $(git rev-parse --short HEAD), the first \
is$(echo "$changed" | head -n 1 | cut -c 3-): commit them or remove them"
tagged=$(git rev-parse --verify --quiet "v$version^{commit}" || true)
[ "${tagged:-$commit}" = "$commit" ] || refuse "tag v$version is commit $(git rev-parse --short "$tagged"), which is not \
checked out: raise the version, or check out the tag"
echo "release: $version is commit $(git rev-parse --short HEAD)"
[ "${1:-}" != --check ] || exit 0

rm -rf out/wheel out/packages
for target in test wheel package; do
    make --no-print-directory $target || refuse "make $target failed"
done

part=out/release.part
rm -rf $part
mkdir -p $part
# The same bytes from the same commit: times are the commit's, and gzip writes none.
git archive --prefix="claque-$version/" "$commit" | gzip -9n >"$part/claque-$version.tar.gz"
take() {
    found=''
    for file; do
        [ ! -e "$file" ] || {
            cp "$file" $part/
            found=$file
        }
    done
    [ -n "$found" ] || refuse "there is no file $file"
}
take out/wheel/claque-"$version"-*.whl
take out/packages/*_"$version"[!0-9.]*.deb
(cd $part && sha256sum -- *.* >SHA256SUMS)
rm -rf out/release
mv $part out/release
cat out/release/SHA256SUMS
