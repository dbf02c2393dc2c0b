#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Runs the job file jobs.toml on this machine alone, and then as a Slurm array job, and compares every
# image. Prints on which node of the cluster each job ran. `slurm_node.sh 2` sets up a cluster of two
# nodes.
#
#     samples/farm/run_jobs.sh [WORK_FOLDER]
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
root=$here/../..
export FOAMTEX=${FOAMTEX:-$root/build/release/texgen/foamtex}
FOAMTEX=$(realpath -- "$FOAMTEX")
work=${1:-$(mktemp -d)}
mkdir -p -- "$work/local" "$work/slurm"
cd -- "$work"

jobs=$(grep -c '^\[\[bake\]\]' "$here/jobs.toml")
readonly jobs

printf 'on this machine alone: '
(cd local && "$FOAMTEX" run "$here/jobs.toml" 2>/dev/null | tail -n 1)
sbatch --wait -Q --array="1-$jobs" --chdir="$work/slurm" "$here/jobs.slurm" "$here/jobs.toml"
grep -h '^job' slurm/job-*.log
printf 'nodes that ran jobs: %s\n' "$(sed -n 's/^job .* on //p' slurm/job-*.log | sort -u | tr '\n' ' ')"

count=0
for file in local/*/*.{png,exr}; do
    cmp "$file" "slurm/${file#local/}"
    count=$((count + 1))
done
for folder in slurm/*/; do
    "$FOAMTEX" verify "$folder" -q
done
printf '%d images of %d jobs: every one has the same bytes as on this machine alone, and verify holds\n' "$count" "$jobs"
