#!/usr/bin/env bash
# Runs every test of povista: units, snapshots, pictures, and the comparison with Debian's povray.
# What is missing of POV-Ray is installed where apt-get can; otherwise this says so and fails.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=(povray povray-includes povray-examples)

missing() {
  command -v povray >/dev/null || echo povray
  [ -f /usr/share/povray-3.7/include/colors.inc ] || echo povray-includes
  [ -n "$(find /usr/share/doc/povray/examples -name '*.pov' -print -quit 2>/dev/null)" ] || echo povray-examples
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi
}

if [ -n "$(missing)" ] && command -v apt-get >/dev/null; then
  echo "installing $(missing | xargs) ..."
  export DEBIAN_FRONTEND=noninteractive
  as_root apt-get update -q || true
  # Slim images leave out /usr/share/doc, where Debian puts the example scenes.
  as_root apt-get install -q -y --no-install-recommends --reinstall \
    -o DPkg::Options::='--path-include=/usr/share/doc/povray*' "${packages[@]}" </dev/null || true
fi
if [ -n "$(missing)" ]; then
  echo "missing: $(missing | xargs)" >&2
  echo "povista is tested beside Debian's POV-Ray: install the packages ${packages[*]}." >&2
  exit 1
fi

cargo fmt --all --check
cargo clippy --workspace --all-targets --profile testing -- -D warnings
RUSTDOCFLAGS='-D warnings' cargo doc --workspace --no-deps --quiet --profile testing
cargo test --workspace --profile testing "$@"
