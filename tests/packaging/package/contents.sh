#!/usr/bin/env bash
# contents.sh FOLDER VERSION ID SOURCES: the contents of the package in the folder meet the requirements of
# desktops, shells and Debian.
set -euo pipefail
# shellcheck source=tests/packaging/package/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
folder=$1 version=$2 id=$3 sources=$4
needs dpkg-deb lintian desktop-file-validate appstreamcli xmllint update-mime-database man zsh
package=$(package_in "$folder")
tree=$(mktemp -d)
trap 'rm -rf -- "$tree"' EXIT
dpkg-deb -x "$package" "$tree"
share=$tree/usr/share

# Version, from one place.
[[ $(dpkg-deb -f "$package" Version) == "$version"-* ]] || fail "the package is of another version than $version"
for program in alidade alidade-cli; do
  said=$("$tree/usr/bin/$program" --version)
  [[ $said == "$program $version ("*")" ]] || fail "$program --version says $said, not $version"
done
grep -q "<release version=\"$version\"" "$share/metainfo/$id.metainfo.xml" || fail "the metadata is of another version"
grep -q "^alidade ($version-" < <(gzip -dc "$share/doc/alidade/changelog.Debian.gz") || fail "the changelog is of another version"

# Requirements of Debian.
lintian --allow-root --fail-on error,warning -- "$package"
depends=$(dpkg-deb -f "$package" Depends)
for needed in libqt6svg6 fonts-dejavu-core libqt6charts6 libqpdf29 libc6; do
  [[ ", $depends" == *", $needed"* ]] || fail "the package does not depend on $needed: $depends"
done

# Requirements of desktops.
desktop-file-validate "$share/applications/$id.desktop"
grep -qx 'Exec=alidade %f' "$share/applications/$id.desktop" || fail "the menu entry does not open a file"
grep -qx "Icon=$id" "$share/applications/$id.desktop" || fail "the menu entry has no icon of the package"
appstreamcli validate --no-net --pedantic "$share/metainfo/$id.metainfo.xml"
xmllint --noout --nonet "$share/mime/packages/$id.xml"
update-mime-database "$share/mime" >"$tree/mime" 2>&1 || fail "$(cat "$tree/mime")"
grep -q ':application/x-alidade-session:\*\.alidade$' "$share/mime/globs2" || fail "*.alidade is no kind of file"
grep -aq 'alidade-session' "$share/mime/magic" || fail "a session is not known by its contents"

# Icons have the size of their folder: width and height are in bytes 16 to 23 of a PNG.
icons=0
for icon in "$share"/icons/hicolor/*x*/*/*.png; do
  size=${icon#"$share"/icons/hicolor/} && size=${size%%x*}
  read -r width height < <(od -An -tu4 --endian=big -j16 -N8 "$icon")
  [[ $width == "$size" && $height == "$size" ]] || fail "$icon is $width × $height"
  ((++icons))
done
((icons >= 12)) || fail "only $icons icons of a fixed size"
for icon in "apps/$id" mimetypes/application-x-alidade-session; do
  xmllint --noout --nonet "$share/icons/hicolor/scalable/$icon.svg"
done

# Requirements of shells and man.
for program in alidade alidade-cli; do
  bash -n "$share/bash-completion/completions/$program"
  zsh -n "$share/zsh/vendor-completions/_$program"
  warnings=$(MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$share/man/man1/$program.1.gz" 2>&1 >/dev/null)
  [[ -z $warnings ]] || fail "$program.1: $warnings"
done

# Samples and guide, every file.
diff -r --exclude='*.sh' --exclude=programs "$sources/samples" "$share/alidade/samples" || fail "the samples are not those of the sources"
diff -r "$sources/resources/help" "$share/doc/alidade/help" || fail "the guide is not that of the sources"
